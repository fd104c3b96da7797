// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_LISTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_LISTS_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Neighbourhoods that stay the same over many iterations, stored once. Row i holds the points within
/// a radius of point i, itself included, in the grid's order.
struct Neighbor_lists {
  std::vector<std::size_t> first;
  std::vector<Index> neighbors;

  std::size_t begin(std::size_t i) const { return first[i]; }
  std::size_t end(std::size_t i) const { return first[i + 1]; }
  std::size_t count(std::size_t i) const { return first[i + 1] - first[i]; }
};

/// `grid`: of the points.
inline Neighbor_lists make_neighbor_lists(const Execution& execution, const Sorted_grid& grid,
                                          const Points& points, double radius)
{
  const std::size_t n = points.size();
  Neighbor_lists lists;
  lists.first.assign(n + 1, 0);
  parallel_for_places(execution, grid, [&](std::size_t i) {
    std::size_t count = 0;
    grid.for_each_neighbor(points[i], radius, [&](Index, double) { return ++count != 0; });
    lists.first[i + 1] = count;
  });
  for(std::size_t i = 0; i < n; ++i)
    lists.first[i + 1] += lists.first[i];
  lists.neighbors.resize(lists.first[n]);
  parallel_for_places(execution, grid, [&](std::size_t i) {
    std::size_t slot = lists.first[i];
    grid.for_each_neighbor(points[i], radius, [&](Index j, double) {
      lists.neighbors[slot++] = j;
      return true;
    });
  });
  return lists;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_LISTS_H
