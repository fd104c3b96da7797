// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/anisotropic_wlop.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_preprocessing.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_reconstruction.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Point_set_consolidation_3/internal/segmentation.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_completion.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points separate_at_edges(Execution& execution, const Points& points, const Points& normals,
                                  const Feature_parameters& parameters)
{
  Stage stage(execution, "normals", 1);
  const bool have_sides =
    std::all_of(normals.begin(), normals.end(), [](const Vec3& n) { return n.squaredNorm() > 0; });
  Feature_input input(execution, points, have_sides ? normals : Points());
  stage.update(0.3);
  enhance_features(execution, input.points, input.normals, parameters);
  return {input.frame.to_world(std::move(input.points)), std::move(input.normals)};
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points simplify_anisotropically(Execution& execution, const Points& world, const Points& normals,
                                         const Projection_settings& settings)
{
  constexpr double separated_radius = 4;       // of the spacing of the result: three rings of neighbours
  constexpr double separated_repulsion = 0.15; // more drives points to the edges
  constexpr double edge_attraction = 0.3;      // of the spacing of the result
  Anisotropic_wlop_parameters parameters = settings.wlop;
  const bool separated = parameters.formula == Anisotropic_formula::SEPARATED;

  const Feature_input input = enhanced_input(execution, 0.4, world, normals, settings.enhances_features,
                                             parameters.sharpness_angle);
  const Frame& frame = input.frame;
  const Points& data = input.points;

  Stage stage(execution, "projection", 0.6);
  const double thinning = std::sqrt(double(data.size()) / double(settings.count));
  // d_bb / sqrt|J|; the printed 4 sqrt(d_bb / |J|) is no length and agrees for d_bb = 1
  const double printed_spacing = bounding_box(data).diagonal() / std::sqrt(double(data.size()));
  const double printed_multiple =
    parameters.formula == Anisotropic_formula::PRINTED ? 4 : 12;
  parameters.oriented = true;
  parameters.support_radius =
    parameters.support_radius > 0 ? parameters.support_radius / frame.unit
    : separated ? separated_radius * thinning : printed_multiple * printed_spacing;
  parameters.plane_width = parameters.plane_width > 0 ? parameters.plane_width / frame.unit
                           : separated ? 1 : printed_spacing;
  if(separated && !settings.repulsion_is_given)
    parameters.repulsion = separated_repulsion;
  parameters.edge_attraction = edge_attraction * thinning;

  Oriented_points result;
  const std::vector<std::size_t> chosen = random_subset(data.size(), settings.count, settings.seed);
  result.points = selected(data, chosen);
  result.normals = selected(input.normals, chosen);
  Anisotropic_wlop(execution, data, input.normals, parameters).run(stage, result.points, result.normals);
  result.points = frame.to_world(std::move(result.points));
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points upsample_at_edges(Execution& execution, const Points& points, const Points& normals,
                                  const Edge_aware_parameters& parameters)
{
  return upsample_at_edges(execution, 1, points, normals, parameters);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Segmentation segment_points(Execution& execution, const Points& points, const Points& normals,
                            const Segmentation_settings& settings)
{
  return segment_points(execution, 1, points, normals, settings);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Feature_enhanced_result reconstruct_feature_enhanced(Execution& execution, const Points& points, const Points& normals,
                                                     const Skeleton_graph& skeleton,
                                                     const Feature_enhanced_settings& settings)
{
  return Feature_enhanced_reconstruction(execution, points, normals, skeleton, settings).run();
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points complete_along(Execution& execution, const Points& points, const Points& normals,
                               const Skeleton_graph& skeleton, bool trusts_all)
{
  Stage stage(execution, "completion", 1);
  const Feature_input input(execution, points, normals);
  stage.update(0.3);
  Skeleton_completed_points completed = Skeleton_completion(points, input.normals, input.frame.unit, skeleton)
                                          .run(std::vector<char>(skeleton.edges.size(), 1), trusts_all);
  return {std::move(completed.points), std::move(completed.normals)};
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H
