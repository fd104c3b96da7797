// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H

#include <cstddef>
#include <string>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Ref
  Options and named parameters of the package.
*/
namespace Point_set_consolidation_3 {

/*!
  \addtogroup PkgPointSetConsolidation3Options
  @{
*/

/// How outer points are drawn to the data, equation (6) of \cgalCite{cgal:wshcl-dpc-15}.
enum class Data_term : unsigned char {
  /// To the L1 median of the data, as printed: stays on the data and completes slowly.
  FULL,
  /// Only along the normal: really closes the surface; three to four times more accurate on tubes.
  NORMAL
};

/// What is assumed of the shape where data are missing.
enum class Prior : unsigned char {
  /// Thickness as in the neighbourhood, equation (8) of \cgalCite{cgal:wshcl-dpc-15}.
  VOLUME_PRESERVING,
  /// Thickness decays away from the data, equation (9).
  MINIMAL_VOLUME,
  /// Closed by a plane through the border: for open bases, where an object stood on the ground. Where
  /// the border is far from flat, as `VOLUME_PRESERVING`.
  FLAT
};

/// How an inner point of `Deep_points_consolidation_3` came to rest.
enum class Anchoring : unsigned char {
  sinking,     ///< still on its way
  collided,    ///< met an opposing front, equation (2)
  slowed,      ///< stopped because its neighbours had settled
  inherited,   ///< never settled; length taken from settled neighbours
  unanchored   ///< nothing opposes its whole component: the depth is a guess
};

/// Weights of the point cloud Laplacian in the contraction of a shape to its curve skeleton.
enum class Laplacian_weights {
  COTANGENT,     ///< cotangents of the opposite angles: contracts along the mean curvature normal
  MEAN_VALUE,    ///< tangents of the half angles at the point by the edge's length
  COMBINATORIAL  ///< one for every neighbour
};

/// How `anisotropic_wlop_simplify_and_regularize_point_set()` reads equations (1) to (4) of
/// \cgalCite{cgal:wfglchc-fes-18}.
enum class Anisotropic_formula : unsigned char {
  /// as printed, sums over all points: quadratic time, and faces shrink towards their middle
  PRINTED,
  /// distance weights beside the tangent plane weights in (1) and (2), and a support radius three times as large
  LOCAL,
  /// points are attracted to the surface of their own cluster only, and repelled along it, up to its edges
  SEPARATED
};

/// How `anisotropic_edge_aware_upsample_point_set()` projects a new point.
enum class Upsampling_formula : unsigned char {
  /// equation (6), with \f$n^T(s_i - b)\f$: with the sign as printed points move away from the surface
  PRINTED,
  /// distance weights beside those of (6), offsets along the mean of the two normals
  WEIGHTED,
  /// as `WEIGHTED`, and a base between two clusters goes onto the edge between their planes
  EDGES
};

/// How `density_peak_segment_point_set()` finds segments.
enum class Segmentation_method : unsigned char {
  /// equation (7) of \cgalCite{cgal:wfglchc-fes-18}: centres stand out by density and by distance to denser
  /// points; every point follows its nearest denser point
  DENSITY_PEAKS,
  /// the same along a neighbour graph: peaks of little prominence are merged, no point leaps across a gap
  PERSISTENCE,
  /// chains of the curve skeleton, cut where the radius changes
  SKELETON
};

/// What the surface of a segment is made from, in `feature_enhanced_surface_reconstruction()`.
enum class Part_method : unsigned char {
  /// as `SKELETON` if the skeleton is given, with cylinders where it crosses a gap of the data and all along if data
  /// confirm most of the segment's part of it; as `DATA` otherwise: centres and radii of an extracted skeleton do
  /// more harm than good where data are missing
  AUTOMATIC,
  /// from the points and their normals alone
  DATA,
  /// from the data, and where they are missing from generalised cylinders around the skeleton
  SKELETON
};

/// Seconds and iterations of a stage of a call; the named parameter `stage_times` receives one for each stage,
/// in order.
struct Stage_time {
  std::string name;            ///< of the stage
  double seconds = 0;          ///< wall time
  std::size_t iterations = 0;  ///< 0 if the stage does not count them
};

/// What a part of the meso-skeleton is.
enum class Meso_label : unsigned char {
  CURVE,      ///< the shape is tubular here
  SHEET,      ///< it is flat: two sides face each other
  END,        ///< the end of a curve, or a blob
  UNANCHORED  ///< nothing opposes the surface: the depth is a guess
};

/// @}

}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H
