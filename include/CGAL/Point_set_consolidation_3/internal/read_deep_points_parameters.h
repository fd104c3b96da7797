// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_READ_DEEP_POINTS_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_READ_DEEP_POINTS_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/range_access.h>

#include <CGAL/number_type_config.h>

#include <string>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The methods' own parameters from the caller's named parameters, with their defaults and ranges.

template <typename NP>
Input_parameters read_input_parameters(const char* function, const NP& np, std::size_t n)
{
  Input_parameters input;
  if constexpr(has_parameter<NP, CGAL::internal_np::number_of_output_points_t>) {
    input.particles =
      parameter_or(np, CGAL::internal_np::number_of_output_points, std::size_t(0));
    require(input.particles > 0, function, "number_of_output_points must be positive");
  }
  else if constexpr(has_parameter<NP, CGAL::internal_np::select_percentage_t>) {
    const double percentage =
      positive(function, np, CGAL::internal_np::select_percentage, "select_percentage", 5);
    require(percentage <= 100, function, "select_percentage must be at most 100");
    input.particles = (std::max)(std::size_t(1), std::size_t(percentage / 100 * double(n)));
  }
  if constexpr(has_parameter<NP, CGAL::internal_np::neighbor_radius_t>)
    input.neighbor_radius =
      positive(function, np, CGAL::internal_np::neighbor_radius, "neighbor_radius", 1);
  input.iterations = parameter_or(np, CGAL::internal_np::number_of_iterations, 35u);
  require(input.iterations > 0 && input.iterations <= 100000, function,
          "number_of_iterations must be in [1, 100000]");
  input.require_uniform_sampling =
    parameter_or(np, CGAL::internal_np::require_uniform_sampling, true);
  input.denoise_along_rays =
    parameter_or(np, internal_np::denoise_along_rays, true);
  input.detect_outliers = parameter_or(np, internal_np::detect_outliers, true);
  return input;
}

/// A radius of neighbourhoods, in r.
template <typename NP, typename Tag>
double read_radius(const char* function, const NP& np, Tag tag, const char* name, double fallback)
{
  const double radius = positive(function, np, tag, name, fallback);
  if(radius > 50)
    throw_invalid(function, std::string(name) + " must be at most 50");
  return radius;
}

template <typename NP>
Sinking_parameters read_sinking_parameters(const char* function, const NP& np)
{
  Sinking_parameters sinking;
  sinking.smoothing_radius = read_radius(function, np, internal_np::smoothing_radius, "smoothing_radius", 5);
  sinking.collision_radius = read_radius(function, np, internal_np::collision_radius, "collision_radius", 2);
  const double omega = positive(function, np, internal_np::collision_angle, "collision_angle", 45);
  require(omega <= 170, function, "collision_angle must be at most 170 degrees");
  sinking.collision_angle = omega * CGAL_PI / 180;
  sinking.closing_step = parameter_or(np, internal_np::closing_step, true);
  return sinking;
}

/// `collision_radius`: sigma_q, as sinking has it.
template <typename NP>
Meso_skeleton_parameters read_skeleton_parameters(const char* function, const NP& np, double collision_radius)
{
  Meso_skeleton_parameters skeleton;
  skeleton.collision_radius = collision_radius;
  skeleton.repulsion =
    not_negative(function, np, internal_np::skeleton_repulsion, "skeleton_repulsion", 0.4);
  skeleton.epsilon = positive(function, np, internal_np::axis_epsilon, "axis_epsilon", 0.1);
  require(skeleton.epsilon >= 0.01, function, "axis_epsilon must be at least 0.01");
  skeleton.iterations =
    parameter_or(np, internal_np::number_of_skeleton_iterations, std::size_t(10));
  return skeleton;
}

/// `smoothing_radius`: sigma_p, as sinking has it.
template <typename NP>
Surface_parameters read_surface_parameters(const char* function, const NP& np, double smoothing_radius)
{
  Surface_parameters surface;
  surface.smoothing_radius = smoothing_radius;
  surface.repulsion =
    not_negative(function, np, internal_np::surface_repulsion, "surface_repulsion", 0.4);
  surface.data_term =
    enumerator(function, np, internal_np::data_term, "data_term", Data_term::FULL, Data_term::NORMAL);
  surface.prior =
    enumerator(function, np, internal_np::prior, "prior", Prior::VOLUME_PRESERVING, Prior::FLAT);
  surface.iterations =
    parameter_or(np, internal_np::number_of_surface_iterations, std::size_t(90));
  surface.completed_spacing =
    not_negative(function, np, internal_np::completed_spacing, "completed_spacing", 1);
  require(surface.completed_spacing == 0 || surface.completed_spacing >= 0.2, function,
          "completed_spacing must be 0 or at least 0.2");
  return surface;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_READ_DEEP_POINTS_PARAMETERS_H
