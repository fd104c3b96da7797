// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEGMENTATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEGMENTATION_H

#include <CGAL/Point_set_consolidation_3/internal/density_peaks.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/laplacian_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/numbered_segments.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_segmentation.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section IV.A: a label for every point, by one of three methods.

inline Segmentation segment_points(Execution& execution, double share, const Points& world,
                                   const Points& normals, const Segmentation_settings& settings)
{
  constexpr double default_radius = 0.15;  // of the diagonal: a body's width
  Stage stage(execution, "segmentation", share);
  if(settings.method != Segmentation_method::SKELETON) {
    const double h =
      settings.radius > 0 ? settings.radius : default_radius * bounding_box(world).diagonal();
    if(!(h > 0))
      return numbered_by_size(std::vector<std::size_t>(world.size(), 0));
    return settings.method == Segmentation_method::PERSISTENCE
             ? persistence_segments(execution, world, h, settings.prominence, settings.skeleton.count)
             : density_peak_segments(execution, world, h, settings.skeleton.count);
  }
  const Skeleton_graph skeleton = skeleton_of_parts(execution, stage, world, normals, false);
  return Skeleton_segmentation(skeleton, world.size(), settings.skeleton).run(world);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEGMENTATION_H
