// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_TYPES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_TYPES_H

#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/options.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The deep points after section 4.2, parallel arrays.
struct Meso_shape {
  Points outer;              ///< S
  Points normals;            ///< of S, smoothed
  Points anchors;            ///< H
  Points skeletal;           ///< Q
  std::vector<char> is_unanchored;
};

using Sheet_triangle = std::array<std::size_t, 3>;  ///< corners in increasing order

struct Meso_graph {
  Skeleton_graph graph;                     ///< all nodes, and the edges of curves
  std::vector<Sheet_triangle> triangles;    ///< of sheets, indices of nodes
  std::vector<Meso_label> node_labels;
  std::vector<std::size_t> node_of;         ///< per deep point
  std::vector<Meso_label> labels;           ///< per deep point
  std::vector<double> radii;                ///< per deep point: distance of its inner point to S
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_TYPES_H
