// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PREPROCESSING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PREPROCESSING_H

#include <CGAL/Point_set_consolidation_3/internal/edge_aware_upsampling.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section III: from the caller's points to those that the steps work on, and
/// up-sampled ones in the caller's coordinates.

inline void require_spacing(const Frame& frame)
{
  if(!(frame.unit > 0))
    throw Unusable_input("more than half of the points coincide: no spacing to work with");
}

/// Points in units of their spacing, with normals: those given, or estimated ones if there are none.
struct Feature_input {
  Frame frame;
  Points points, normals;

  Feature_input(const Execution& execution, const Points& world, Points given)
    : frame(data_frame(execution, world, world.size())), normals(std::move(given))
  {
    require_spacing(frame);
    points = frame.to_local(world);
    if(normals.empty())
      normals = estimated_normals(execution, points);
  }
};

/// The same after section III.B, if wanted: normals separated at edges, and points that are denoised accordingly.
inline Feature_input enhanced_input(Execution& execution, double share, const Points& world, const Points& normals,
                                    bool enhances, double sharpness_angle)
{
  Stage stage(execution, "features", share);
  Feature_input input(execution, world, normals);
  stage.update(0.3);
  if(enhances) {
    Feature_parameters features;
    features.oriented = true;
    features.sharpness_angle = sharpness_angle;
    enhance_features(execution, input.points, input.normals, features);
  }
  return input;
}

/// Section III.B. The result begins with the given points, their positions unchanged.
inline Oriented_points upsample_at_edges(Execution& execution, double share, const Points& world,
                                         const Points& normals, Edge_aware_parameters parameters)
{
  Stage stage(execution, "upsampling", share);
  const Frame frame = data_frame(execution, world, world.size());
  require_spacing(frame);
  constexpr double default_radius = 3;  // spacings: bases across the usual gaps of irregular sets
  parameters.neighbor_radius =
    parameters.neighbor_radius > 0 ? parameters.neighbor_radius / frame.unit : default_radius;
  parameters.plane_width = parameters.plane_width > 0 ? parameters.plane_width / frame.unit : 1;
  Edge_aware_upsampling upsampling(execution, frame.to_local(world), normals, parameters);
  upsampling.run(stage);
  Oriented_points result;
  result.points = world;
  for(std::size_t i = world.size(); i < upsampling.points().size(); ++i)
    result.points.push_back(frame.to_world(upsampling.points()[i]));
  result.normals = upsampling.normals();
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PREPROCESSING_H
