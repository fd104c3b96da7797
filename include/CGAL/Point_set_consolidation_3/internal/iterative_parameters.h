// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/internal/mean_shift.h>
#include <CGAL/Point_set_consolidation_3/internal/interpolatory_upsampling.h>
#include <CGAL/Point_set_consolidation_3/internal/outlier_selection.h>
#include <CGAL/Point_set_consolidation_3/internal/particle_selection.h>
#include <CGAL/Point_set_consolidation_3/internal/placement_guard.h>
#include <CGAL/Point_set_consolidation_3/internal/repulsion.h>
#include <CGAL/Point_set_consolidation_3/internal/scan_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/wlop_projection.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, algorithm 1: parameters, input and result. Deviations from the printed values are
/// defaults of the parameters; `Iterative_parameters::printed()` has the paper's.

struct Iterative_parameters {
  double particle_fraction = 0.1;      ///< m / |P^0|, 1/20 to 1/5 in the paper
  std::size_t neighbors = 20;          ///< k of L_avg
  double support_radius = 0;           ///< h, in the frame's unit; 0: 2 L_avg
  std::size_t iterations = 10;
  bool adaptive = true;                ///< false: all particles anew in each iteration
  bool two_phases = false;             ///< first without repulsion at a smaller h, then as usual
  std::uint64_t seed = 0;

  Wlop_parameters wlop;
  Mean_shift_parameters mean_shift;
  Repulsion_parameters repulsion;
  Upsampling_parameters upsampling;    ///< its lengths in units of h
  Outlier_parameters outliers;
  Guard_parameters guard;
  /// Up-sampled points nearer to the data than this are no new points, in units of h; at least L_pnt / 2. L_pnt / 2
  /// alone, as printed, fills the gaps of any random sample.
  double selection_distance = 0.2;
  double particles_per_new_point = 2;  ///< m^i = 2 m |P^i| / |P^0|
  bool takes_back_open_borders = true;
  Peel_parameters peel;                ///< its radius in units of h
  double least_new_share = 0.1;        ///< of the largest |P^j|; the printed stop test cannot be met

  static Iterative_parameters printed()
  {
    Iterative_parameters p;
    p.repulsion = Repulsion_parameters::printed();
    p.upsampling.least_distance = 1. / 3;
    p.outliers.far_distance = 1;
    p.outliers.removes_near = false;
    p.outliers.least_share = 0;
    p.guard.enabled = false;
    p.selection_distance = 0;
    p.takes_back_open_borders = false;
    p.least_new_share = 0;
    return p;
  }
};

/// What the method starts from; lengths in the frame's unit.
struct Iterative_input {
  Points points;
  Points normals;                      ///< empty: none
  bool normals_are_hints = false;      ///< they only tell the side
  Scan_directions directions;          ///< empty: none
  std::vector<char> is_constrained;    ///< the static region; empty: none
};

struct Iterative_result {
  Points normals;                      ///< of all input points
  std::vector<char> is_outlier;        ///< of all input points
  Points new_points, new_normals;
  std::vector<double> new_confidence;  ///< in (0, 1]
  std::vector<std::size_t> new_counts; ///< |P^i|, i = 1, 2, ...
  std::size_t inconsistent_neighbors = 0;
  double support_radius = 0;           ///< h
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H
