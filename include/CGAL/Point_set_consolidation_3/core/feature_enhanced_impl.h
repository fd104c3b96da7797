// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_preprocessing.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_reconstruction.h>
#include <CGAL/Point_set_consolidation_3/internal/segmentation.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_completion.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points separate_at_edges(Execution& execution, const Points& points, const Points& normals,
                                  const Feature_parameters& parameters)
{
  const Frame frame = data_frame(execution, points, points.size());
  require_spacing(frame);
  Oriented_points result = {frame.to_local(points), normals};
  Stage stage(execution, "normals", 1);
  bool have_sides = true;
  for(const Vec3& n : normals)
    have_sides = have_sides && n.squaredNorm() > 0;
  if(!have_sides)
    result.normals = estimated_normals(execution, result.points);
  stage.update(0.3);
  enhance_features(execution, result.points, result.normals, parameters);
  result.points = frame.to_world(std::move(result.points));
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points simplify_anisotropically(Execution& execution, const Points& points, const Points& normals,
                                         const Projection_settings& settings)
{
  return project_anisotropically(execution, 1, points, normals, settings);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points upsample_edge_aware(Execution& execution, const Points& points, const Points& normals,
                                    const Edge_aware_parameters& parameters)
{
  return upsample_at_edges(execution, 1, points, normals, parameters);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Segmentation segment(Execution& execution, const Points& points, const Points& normals,
                     const Segmentation_settings& settings)
{
  return segment_points(execution, 1, points, normals, settings);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Feature_enhanced_result reconstruct_with_features(Execution& execution, const Points& points, const Points& normals,
                                                  const Skeleton_graph& skeleton,
                                                  const Feature_enhanced_settings& settings)
{
  return reconstruct_feature_enhanced(execution, points, normals, skeleton, settings);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_points complete_along(const Execution& execution, const Points& points, const Points& normals,
                               const Skeleton_graph& skeleton, bool trusts_all)
{
  const Frame frame = data_frame(execution, points, points.size());
  require_spacing(frame);
  const Points usable = normals.empty() ? estimated_normals(execution, frame.to_local(points)) : normals;
  Skeleton_completed_points completed = Skeleton_completion(points, usable, frame.unit, skeleton)
                                          .run(std::vector<char>(skeleton.edges.size(), 1), trusts_all);
  return {std::move(completed.points), std::move(completed.normals)};
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_IMPL_H
