// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_WEIGHTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_WEIGHTS_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Weights of equation (3) of the deep points paper; lengths in units of the spacing r.
struct Bilateral_weights {
  double cosine;  ///< cos(omega), omega the collision angle

  /// Proximity of points at squared distance `d2`.
  static double theta(double d2) { return std::exp(-d2); }
  /// Similarity of unit normals.
  double phi(const Vec3& n1, const Vec3& n2) const
  {
    const double t = (1 - n1.dot(n2)) / (1 - cosine);
    return std::exp(-t * t);
  }
};

/// theta(3 r) = 1e-4: sums over theta need no points beyond.
constexpr double theta_support = 3;

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_WEIGHTS_H
