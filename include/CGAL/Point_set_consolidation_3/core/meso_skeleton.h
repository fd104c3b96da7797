// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph_types.h>

#include <iosfwd>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The meso-skeleton as an object: curves, sheets, and where they meet, in the coordinates of `shape`, whose unit is
/// the spacing r of S.

Meso_graph build_meso_graph(const Execution& execution, const Meso_shape& shape,
                            const Meso_graph_parameters& parameters);

/// Betti numbers of curves and sheets together.
struct Meso_topology {
  std::size_t components = 0, cycles = 0, sheets = 0;
};
Meso_topology topology_of(const Skeleton_graph& graph, const std::vector<Sheet_triangle>& triangles);

enum class Meso_format { PLY, OBJ, MA };
void write(std::ostream& out, const Meso_graph& meso, Meso_format format);

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/meso_skeleton_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_MESO_SKELETON_H
