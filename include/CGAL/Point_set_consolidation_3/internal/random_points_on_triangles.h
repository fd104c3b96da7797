// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANDOM_POINTS_ON_TRIANGLES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANDOM_POINTS_ON_TRIANGLES_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <array>
#include <random>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Independent points, uniformly distributed over the area of a soup of triangles; the same for the same arguments.
/// None if the triangles have no area.
inline Points random_points_on_triangles(const Points& vertices,
                                         const std::vector<std::array<std::size_t, 3> >& triangles,
                                         std::size_t count, std::uint64_t seed)
{
  std::vector<double> area_up_to;
  double area = 0;
  for(const std::array<std::size_t, 3>& t : triangles) {
    area += (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]).norm();
    area_up_to.push_back(area);
  }
  Points points;
  if(!(area > 0))
    return points;
  // the standard fixes the engine, not its distributions: 53 bits of it are a number in [0, 1) on any platform
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return double(generator() >> 11) * 0x1.0p-53; };
  for(std::size_t i = 0; i < count; ++i) {
    const double where = uniform() * area;
    const std::size_t k = std::size_t(
      std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, where) - area_up_to.begin());
    double u = uniform(), v = uniform();
    if(u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const std::array<std::size_t, 3>& t = triangles[k];
    points.push_back(vertices[t[0]] + u * (vertices[t[1]] - vertices[t[0]]) + v * (vertices[t[2]] - vertices[t[0]]));
  }
  return points;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANDOM_POINTS_ON_TRIANGLES_H
