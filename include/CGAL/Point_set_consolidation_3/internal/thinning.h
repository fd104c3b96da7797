// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_THINNING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_THINNING_H

#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Sets thinned to this share of a scan's spacing, the mean distance to six neighbours, which is 1.2 times the pitch,
/// are as dense as the scan.
constexpr double scan_clearance = 0.7;

/// Indices of a subset with no two points closer than `distance`: greedy in the given order.
inline std::vector<Index> thinned(const Points& points, double distance)
{
  const Sorted_grid grid(points, distance);
  std::vector<char> is_covered(points.size(), 0);
  std::vector<Index> kept;
  for(std::size_t i = 0; i < points.size(); ++i) {
    if(is_covered[i])
      continue;
    kept.push_back(Index(i));
    grid.for_each_neighbor(points[i], distance, [&](Index j, double) {
      is_covered[j] = 1;
      return true;
    });
  }
  return kept;
}

/// Indices of at most `count` evenly spread points, and nearly as many.
inline std::vector<Index> spread_points(const Points& points, std::size_t count)
{
  constexpr int most_steps = 12;
  constexpr double enough = 0.95;
  std::vector<Index> best;
  // a surface as large as the box's largest side, covered by discs
  const double side = bounding_box(points).sides().maxCoeff();
  double distance = side / std::sqrt(double(count));
  double too_small = 0, too_large = side;
  for(int step = 0; step < most_steps; ++step) {
    std::vector<Index> chosen = thinned(points, distance);
    const double ratio = std::sqrt(double(chosen.size()) / double(count));
    (chosen.size() > count ? too_small : too_large) = distance;
    if(chosen.size() <= count && chosen.size() > best.size())
      best.swap(chosen);
    if(double(best.size()) >= enough * double(count))
      break;
    // the number of points goes with 1 / distance^2; slightly more, to end up below `count`
    distance *= 1.01 * ratio;
    if(!(distance > too_small && distance < too_large))
      distance = 0.5 * (too_small + too_large);
  }
  return best;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_THINNING_H
