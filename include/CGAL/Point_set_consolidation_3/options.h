// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H

namespace CGAL {
namespace Point_set_consolidation_3 {

/// \ingroup PkgPointSetConsolidation3Ref
/// How outer points are drawn to the data, equation (6) of the deep points paper.
enum class Data_term : unsigned char {
  /// To the L1 median of the data, as printed: stays on the data and completes slowly.
  FULL,
  /// Only along the normal: really closes the surface; three to four times more accurate on tubes.
  NORMAL
};

/// \ingroup PkgPointSetConsolidation3Ref
/// What is assumed of the shape where data are missing.
enum class Prior : unsigned char {
  /// Thickness as in the neighbourhood, equation (8) of the deep points paper.
  VOLUME_PRESERVING,
  /// Thickness decays away from the data, equation (9).
  MINIMAL_VOLUME
};

}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_OPTIONS_H
