// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/options.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Parameters of curve skeletons and of the surfaces that they drive.

struct Contraction_parameters {
  Laplacian_weights weights = Laplacian_weights::COTANGENT;
  double contraction_weight = 1;  ///< W_L^0 in units of its default 1 / (5 S^0)
  double attraction_weight = 1;   ///< W_H^0
  double contraction_factor = 3;  ///< s_L
  double threshold = 0.01;        ///< t: least decrease of the mean extent in an iteration
  std::size_t max_iterations = 20;
};

struct Laplacian_skeleton_parameters {
  std::size_t neighbors = 0;        ///< of a ring; 0: by `default_ring_neighbors()`
  std::size_t most_samples = 20000; ///< points to contract
  Contraction_parameters contraction;
  double sampling_radius = 0.02;    ///< distance of the graph's nodes, in diagonals of the input's box
  std::size_t largest_merged_cycle = 6;
  bool extend_tips = true;
};

struct L1_medial_parameters {
  std::size_t most_points = 2500;    ///< of Z: the ball sums at large h are what costs
  std::size_t samples = 700;         ///< of M
  double repulsion = 0.35;           ///< mu
  double largest_radius = 0.5;       ///< of h: a tube of radius rho contracts at h = 4 to 5 rho only
  double initial_radius = 0;         ///< h_0; 0: 2 / cbrt(n)
  double freezing_linearity = 0.9;   ///< of sigma
  std::size_t inner_iterations = 10; ///< at one h
  double sampling_radius = 0.02;     ///< of the graph's nodes
  std::size_t largest_merged_cycle = 6;
  bool extend_tips = true;
  std::uint64_t seed = 0;
};

struct Field_parameters {
  double smoothness_weight = 1;   ///< omega_1
  double surface_weight = 50;     ///< omega_2; the paper's 5 is too smooth for data of usual density
  double normal_weight = 0;       ///< of the points' normals, if there are any; not in the paper
  double skeleton_weight = 0.5;   ///< omega_3
  double outside_weight = 0.005;  ///< omega_4
  double outside_factor = 4;      ///< K: outside is farther from the skeleton than K radii
  std::size_t resolution = 64;    ///< cells along the longest side of the data's box
  bool adaptive = true;
  double removed_handles = 0;     ///< depth in cells up to which handles that the skeleton does not have are removed
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_PARAMETERS_H
