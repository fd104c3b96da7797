// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_IO_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_IO_H

#include <CGAL/Point_set_consolidation_3/internal/meso_graph.h>

#include <limits>
#include <ostream>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Files of meso-skeletons. What they hold of a `Meso_graph`: nodes with radius and label, edges of curves,
/// triangles of sheets.

/// `x y z radius label`, `element edge` (curves only) and `element face`; ASCII.
inline void write_meso_ply(std::ostream& out, const Meso_graph& meso)
{
  const Skeleton_graph& graph = meso.graph;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\nelement vertex " << graph.nodes.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty double radius\n"
      << "property uchar label\nelement edge " << graph.edges.size()
      << "\nproperty int vertex1\nproperty int vertex2\nelement face " << meso.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < graph.nodes.size(); ++v)
    out << graph.nodes[v].position.x() << ' ' << graph.nodes[v].position.y() << ' '
        << graph.nodes[v].position.z() << ' ' << graph.nodes[v].radius << ' '
        << int(meso.node_labels[v]) << '\n';
  for(const Skeleton_edge& e : graph.edges)
    out << e[0] << ' ' << e[1] << '\n';
  for(const Sheet_triangle& t : meso.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

/// Lines and faces, indices from 1.
inline void write_meso_obj(std::ostream& out, const Meso_graph& meso)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  for(const Skeleton_node& node : meso.graph.nodes)
    out << "v " << node.position.x() << ' ' << node.position.y() << ' ' << node.position.z() << '\n';
  for(const Skeleton_edge& e : meso.graph.edges)
    out << "l " << e[0] + 1 << ' ' << e[1] + 1 << '\n';
  for(const Sheet_triangle& t : meso.triangles)
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

/// Medial axis format: the three counts, then `v x y z r`, `e` (sides of triangles too) and `f`, indices from 0.
inline void write_meso_ma(std::ostream& out, const Meso_graph& meso)
{
  const std::vector<Skeleton_edge> edges = all_edges(meso.graph.edges, meso.triangles);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << meso.graph.nodes.size() << ' ' << edges.size() << ' ' << meso.triangles.size() << '\n';
  for(const Skeleton_node& node : meso.graph.nodes)
    out << "v " << node.position.x() << ' ' << node.position.y() << ' ' << node.position.z() << ' '
        << node.radius << '\n';
  for(const Skeleton_edge& e : edges)
    out << "e " << e[0] << ' ' << e[1] << '\n';
  for(const Sheet_triangle& t : meso.triangles)
    out << "f " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_IO_H
