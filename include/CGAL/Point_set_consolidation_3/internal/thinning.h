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

template <typename T>
std::vector<T> selected(const std::vector<T>& values, const std::vector<Index>& indices)
{
  std::vector<T> result;
  result.reserve(indices.size());
  for(const Index i : indices)
    result.push_back(values[i]);
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_THINNING_H
