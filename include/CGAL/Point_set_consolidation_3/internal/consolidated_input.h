// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONSOLIDATED_INPUT_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONSOLIDATED_INPUT_H

#include <CGAL/Point_set_consolidation_3/internal/gaps.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>
#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/internal/views.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What a method starts from. All lengths are in units of `frame.unit`.
struct Consolidated_input {
  Frame frame;
  Points data;                 ///< C, in the caller's order, without outliers
  Gap_parameters gaps;         ///< for these
  std::vector<std::size_t> outliers;  ///< of the caller's points, in increasing order
  /// Of the caller's points in `data`; outliers have the nearest one's. Empty: no outliers.
  std::vector<Index> place;
  bool is_denoised = false;    ///< along the rays
  Seen_part seen;              ///< C with outward normals; empty if the scanner's directions tell
  Scan_directions directions;  ///< empty: none
  Points points;               ///< S
  Points normals;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONSOLIDATED_INPUT_H
