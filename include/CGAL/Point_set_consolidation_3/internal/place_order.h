// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACE_ORDER_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACE_ORDER_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The points' indices, close points close to each other. Neighbourhoods queried in this order are found in
/// the cache: from some 100000 points in arbitrary order on, that halves a query's time. Costs as much as
/// building a `Sorted_grid`, one hundredth of a query for each point.
inline std::vector<Index> place_order(const Points& points)
{
  constexpr double points_per_cell = 50;  // of a surface
  const double cells = (std::max)(1., std::sqrt(double(points.size()) / points_per_cell));
  return Sorted_grid(points, bounding_box(points).diagonal() / cells).order();
}

/// `parallel_for()` over all indices, in a given order.
template <typename Body>
void parallel_for_places(const Execution& execution, const std::vector<Index>& order, const Body& body)
{
  parallel_for(execution, order.size(), [&](std::size_t k) { body(std::size_t(order[k])); });
}

/// Over all points of a grid, cell by cell.
template <typename Body>
void parallel_for_places(const Execution& execution, const Sorted_grid& grid, const Body& body)
{
  parallel_for_places(execution, grid.order(), body);
}

/// Over all points, in the order of their places. Where they are the points of a grid at hand, that grid does better.
template <typename Body>
void parallel_for_places(const Execution& execution, const Points& points, const Body& body)
{
  parallel_for_places(execution, place_order(points), body);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACE_ORDER_H
