// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPHERE_DIRECTIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPHERE_DIRECTIONS_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Unit vector number k at height z of a golden spiral: equal steps of z spread them evenly.
inline Vec3 spiral_direction(std::size_t k, double z)
{
  constexpr double golden_angle = 2.399963229728653;
  const double radius = std::sqrt(1 - z * z), angle = golden_angle * double(k);
  return Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
}

/// Number k of n evenly spread directions.
inline Vec3 sphere_direction(std::size_t k, std::size_t n)
{
  return spiral_direction(k, 1 - (2 * double(k) + 1) / double(n));
}

/// Number k of n evenly spread axes, whose sign means nothing.
inline Vec3 half_sphere_direction(std::size_t k, std::size_t n)
{
  return spiral_direction(k, (double(k) + 0.5) / double(n));
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPHERE_DIRECTIONS_H
