// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_POINTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_POINTS_H

#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Points where data are missing. `inner` and the flags are known at the end only.
struct Completed_points {
  Points points, normals, inner;
  std::vector<double> distance;       ///< to the nearest datum, in r
  std::vector<double> uncertainty;    ///< to the nearest datum or image of one by symmetry, in r
  std::vector<char> is_clipped;       ///< the ball's radius is bounded by data or free space
  std::vector<char> is_unanchored;    ///< nothing opposes: the depth is a guess

  void append(const Completed_points& other)
  {
    points.insert(points.end(), other.points.begin(), other.points.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    distance.insert(distance.end(), other.distance.begin(), other.distance.end());
  }

  Completed_points part(const std::vector<Index>& indices) const
  {
    Completed_points result;
    result.points = selected(points, indices);
    result.normals = selected(normals, indices);
    result.distance = selected(distance, indices);
    return result;
  }

  /// Without the points for which `is_kept` is false.
  template <typename Predicate>
  void keep_if(const Predicate& is_kept)
  {
    std::vector<Index> kept;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_kept(points[i]))
        kept.push_back(Index(i));
    if(kept.size() < points.size())
      *this = part(kept);
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_POINTS_H
