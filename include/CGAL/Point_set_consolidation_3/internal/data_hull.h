// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DATA_HULL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DATA_HULL_H

#include <CGAL/Point_set_consolidation_3/internal/sphere_directions.h>

#include <array>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The convex hull of points as the meeting of half spaces in evenly spread directions: it is too large
/// by up to a hundredth of its diameter.
class Data_hull {
  static constexpr std::size_t number_of_directions = 200;

public:
  explicit Data_hull(const Points& points)
  {
    for(std::size_t k = 0; k < number_of_directions; ++k) {
      m_direction[k] = sphere_direction(k, number_of_directions);
      m_extent[k] = points.empty() ? 0 : points.front().dot(m_direction[k]);
      for(const Vec3& p : points)
        m_extent[k] = (std::max)(m_extent[k], p.dot(m_direction[k]));
    }
  }

  /// How far x is outside; negative inside.
  double distance(const Vec3& x) const
  {
    double d = x.dot(m_direction[0]) - m_extent[0];
    for(std::size_t k = 1; k < number_of_directions; ++k)
      d = (std::max)(d, x.dot(m_direction[k]) - m_extent[k]);
    return d;
  }

private:
  std::array<Vec3, number_of_directions> m_direction;
  std::array<double, number_of_directions> m_extent;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DATA_HULL_H
