// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONNECTED_COMPONENTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONNECTED_COMPONENTS_H

#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Components of the graph that joins points no farther apart than `link`, by their first point; the
/// points of a component come in the order in which they are reached.
inline std::vector<std::vector<Index> > connected_components(const Points& points, double link)
{
  const Sorted_grid grid(points, link);
  std::vector<char> is_visited(points.size(), 0);
  std::vector<std::vector<Index> > components;
  for(std::size_t seed = 0; seed < points.size(); ++seed) {
    if(is_visited[seed])
      continue;
    std::vector<Index> component(1, Index(seed));
    is_visited[seed] = 1;
    for(std::size_t k = 0; k < component.size(); ++k)
      grid.for_each_neighbor(points[component[k]], link, [&](Index j, double) {
        if(!is_visited[j]) {
          is_visited[j] = 1;
          component.push_back(j);
        }
        return true;
      });
    components.push_back(std::move(component));
  }
  return components;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONNECTED_COMPONENTS_H
