// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DEEP_POINTS_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DEEP_POINTS_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/options.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

constexpr std::size_t number_of_priors = std::size_t(Prior::FLAT) + 1;

/// Deep points paper: the parameters of its sections, with defaults. Lengths in units of r.

struct Input_parameters {
  std::size_t particles = 0;          ///< |S|; 0: by `default_particles`
  double neighbor_radius = 0;         ///< of WLOP, in the caller's unit; 0: twice the output's spacing
  unsigned int iterations = 35;       ///< of WLOP
  bool require_uniform_sampling = true;   ///< the paper's WLOP weighs by density
  unsigned int normal_neighbors = 18;
  bool denoise_along_rays = true;
  bool detect_outliers = true;
};

struct Sinking_parameters {
  double smoothing_radius = 5;                    ///< sigma_p: static neighbourhoods on the surface
  double collision_radius = 2;                    ///< sigma_q: dynamic neighbourhoods of inner points
  double collision_angle = CGAL_PI / 4;           ///< omega, radians
  bool closing_step = true;                       ///< go on to where colliding fronts would touch
  std::size_t max_iterations = 200;
};

struct Meso_skeleton_parameters {
  double collision_radius = 2;   ///< sigma_q: neighbourhood of the principal component analysis
  double repulsion = 0.4;        ///< mu
  double epsilon = 0.1;          ///< bounds semi-axes by 1 / epsilon
  std::size_t iterations = 10;   ///< movement never vanishes on an over-dense curve: a fixed count
};

struct Surface_parameters {
  double smoothing_radius = 5;   ///< sigma_p
  double repulsion = 0.4;        ///< mu hat
  Data_term data_term = Data_term::FULL;
  Prior prior = Prior::VOLUME_PRESERVING;
  double shrinkage = 0.1;        ///< of the minimal volume prior, per iteration
  std::size_t iterations = 90;   ///< until the fronts of half a tube of 60 r around have met
  double completed_spacing = 1;  ///< to which completed regions are filled; 0: not at all
};

struct Meso_graph_parameters {
  double sampling_radius = 0.02;            ///< distance of the nodes, in diagonals of the box of S
  std::size_t largest_merged_cycle = 6;     ///< nodes
  bool curves_only = false;                 ///< sheets are contracted to curves
  bool extend_tips = false;                 ///< of curves, to the end of S
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DEEP_POINTS_PARAMETERS_H
