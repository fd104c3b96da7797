// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PREPROCESSING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PREPROCESSING_H

#include <CGAL/Point_set_consolidation_3/internal/anisotropic_wlop.h>
#include <CGAL/Point_set_consolidation_3/internal/edge_aware_upsampling.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section III: from the caller's points to projected and up-sampled ones,
/// in the caller's coordinates.

inline void require_spacing(const Frame& frame)
{
  if(!(frame.unit > 0))
    throw Unusable_input("more than half of the points coincide: no spacing to work with");
}

/// Section III.A. `normals` may be empty.
inline Oriented_points project_anisotropically(Execution& execution, double share,
                                               const Points& world, Points normals,
                                               const Projection_settings& settings)
{
  constexpr double separated_radius = 4;       // of the spacing of the result: three rings of neighbours
  constexpr double separated_repulsion = 0.15; // more drives points to the edges
  constexpr double edge_attraction = 0.3;      // of the spacing of the result
  Anisotropic_wlop_parameters parameters = settings.wlop;
  const bool separated = parameters.formula == Anisotropic_formula::SEPARATED;

  Frame frame;
  Points data;
  {
    Stage stage(execution, "features", 0.4 * share);
    frame = data_frame(execution, world, world.size());
    require_spacing(frame);
    data = frame.to_local(world);
    if(normals.empty())
      normals = estimated_normals(execution, data);
    stage.update(0.3);
    if(settings.enhances_features) {
      Feature_parameters features;
      features.oriented = true;
      features.sharpness_angle = parameters.sharpness_angle;
      enhance_features(execution, data, normals, features);
    }
  }

  Stage stage(execution, "projection", 0.6 * share);
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
  for(const std::size_t i : random_subset(data.size(), settings.count, settings.seed)) {
    result.points.push_back(data[i]);
    result.normals.push_back(normals[i]);
  }
  Anisotropic_wlop(execution, data, normals, parameters).run(stage, result.points, result.normals);
  result.points = frame.to_world(std::move(result.points));
  return result;
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
