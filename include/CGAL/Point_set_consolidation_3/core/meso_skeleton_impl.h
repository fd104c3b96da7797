// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/meso_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_io.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Meso_graph build_meso_graph(const Execution& execution, const Meso_shape& shape,
                            const Meso_graph_parameters& parameters)
{
  return Meso_graph_builder(execution, shape, parameters).run();
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Meso_topology topology_of(const Skeleton_graph& graph, const std::vector<Sheet_triangle>& triangles)
{
  Meso_topology topology;
  Skeleton_graph all = graph;
  all.edges = all_edges(graph.edges, triangles);
  topology.components = number_of_components(all);
  topology.cycles = Skeleton_homology(all, triangles).number_of_cycles();
  Skeleton_graph sheets = graph;
  sheets.edges = all_edges({}, triangles);
  std::vector<char> is_corner(graph.nodes.size(), 0);
  for(const Sheet_triangle& t : triangles)
    for(const std::size_t v : t)
      is_corner[v] = 1;
  topology.sheets = number_of_components(subgraph(sheets, is_corner));
  return topology;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void write(std::ostream& out, const Meso_graph& meso, Meso_format format)
{
  switch(format) {
    case Meso_format::PLY: write_meso_ply(out, meso); break;
    case Meso_format::OBJ: write_meso_obj(out, meso); break;
    case Meso_format::MA: write_meso_ma(out, meso); break;
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_IMPL_H
