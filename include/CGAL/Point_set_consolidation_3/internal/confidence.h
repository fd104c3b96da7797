// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONFIDENCE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONFIDENCE_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Confidence of a point by its distance to the nearest datum, the one predictor of its true error
/// that is monotone over all scans: 1 up to one spacing, then decaying.
inline double confidence(double distance_in_spacings)
{
  constexpr double measured = 1;     // spacings of the particles
  constexpr double decay = 6;        // spacings until confidence has fallen to 1/e
  return std::exp(-(std::max)(0., distance_in_spacings - measured) / decay);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONFIDENCE_H
