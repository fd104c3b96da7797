// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The feature-enhanced surfaces paper, on points in the caller's coordinates. Normals are unit vectors; none: they are
/// estimated. Throws `Unusable_input` if most points coincide.

/// Normals that belong to one side of an edge, and points that are denoised accordingly. Section III.B and VI.
Oriented_points separate_at_edges(Execution& execution, const Points& points, const Points& normals,
                                  const Feature_parameters& parameters);

Oriented_points simplify_anisotropically(Execution& execution, const Points& points, const Points& normals,
                                         const Projection_settings& settings);

/// The result begins with the given points.
Oriented_points upsample_at_edges(Execution& execution, const Points& points, const Points& normals,
                                  const Edge_aware_parameters& parameters);

Segmentation segment_points(Execution& execution, const Points& points, const Points& normals,
                            const Segmentation_settings& settings);

/// `skeleton` may be empty.
Feature_enhanced_result reconstruct_feature_enhanced(Execution& execution, const Points& points, const Points& normals,
                                                     const Skeleton_graph& skeleton,
                                                     const Feature_enhanced_settings& settings);

/// What is added along the skeleton.
Oriented_points complete_along(Execution& execution, const Points& points, const Points& normals,
                               const Skeleton_graph& skeleton, bool trusts_all);

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/feature_enhanced_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_FEATURE_ENHANCED_H
