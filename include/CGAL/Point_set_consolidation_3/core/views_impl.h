// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/views.h>
#include <CGAL/Point_set_consolidation_3/internal/views.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::vector<std::size_t> group_views(const Points& points, const Points& towards_scanner)
{
  if(Projection::fit(points, towards_scanner).has_rays(points, towards_scanner))
    return std::vector<std::size_t>(points.size(), 0);
  constexpr std::size_t most_views = 64;
  constexpr double least_cosine = 0.99985;  // one degree
  std::vector<Vec3> views;
  std::vector<std::size_t> view(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    std::size_t v = 0;
    while(v < views.size() && views[v].dot(towards_scanner[i]) < least_cosine)
      ++v;
    if(v == views.size()) {
      if(views.size() == most_views)
        return std::vector<std::size_t>();
      views.push_back(towards_scanner[i]);
    }
    view[i] = v;
  }
  return view;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_IMPL_H
