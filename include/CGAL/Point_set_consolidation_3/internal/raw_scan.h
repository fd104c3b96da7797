// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RAW_SCAN_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RAW_SCAN_H

#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Of values that may be missing altogether.
template <typename T>
std::vector<T> selected_if_any(const std::vector<T>& values, const std::vector<Index>& indices)
{
  return values.empty() ? values : selected(values, indices);
}

/// The rays of a scan: a unit direction towards the scanner per point and the view it belongs to.
/// Empty when the caller does not know them.
struct Scan_directions {
  Points towards_scanner;
  std::vector<std::size_t> view;   ///< in [0, number of views)
  Points missed;                   ///< a point on each ray that met nothing; empty: not known
  std::vector<std::size_t> missed_view;
  bool is_estimated = false;       ///< from the points; the caller knows none

  bool empty() const { return towards_scanner.empty(); }
  std::size_t number_of_views() const
  {
    return view.empty() ? 0 : *std::max_element(view.begin(), view.end()) + 1;
  }
  /// Of the points with these indices; rays that met nothing stay.
  Scan_directions part(const std::vector<Index>& indices) const
  {
    Scan_directions result;
    result.towards_scanner = selected_if_any(towards_scanner, indices);
    result.view = selected_if_any(view, indices);
    result.missed = missed;
    result.missed_view = missed_view;
    result.is_estimated = is_estimated;
    return result;
  }
  /// Indices of the points of each view.
  std::vector<std::vector<std::size_t> > by_view() const
  {
    std::vector<std::vector<std::size_t> > points(number_of_views());
    for(std::size_t i = 0; i < view.size(); ++i)
      points[view[i]].push_back(i);
    return points;
  }
};

/// What the caller wants of the gaps. Lengths in r.
struct Gap_parameters {
  double largest = (std::numeric_limits<double>::max)();  ///< wider gaps stay open
  Prior prior = Prior::VOLUME_PRESERVING;
  double shrinkage = 0.1;             ///< of the minimal volume prior, per r of distance from the data
  std::vector<Prior> priors;          ///< one per datum; empty: `prior` everywhere
  std::vector<char> is_frozen;        ///< one per datum: nothing is completed next to it; empty: none

  /// Of the data with these indices.
  Gap_parameters part(const std::vector<Index>& indices) const
  {
    return {largest, prior, shrinkage, selected_if_any(priors, indices), selected_if_any(is_frozen, indices)};
  }

  /// The prior of most of the data at the border of a gap.
  Prior prior_of(const std::vector<Index>& border) const
  {
    if(priors.empty())
      return prior;
    std::array<std::size_t, number_of_priors> votes = {};
    for(const Index i : border)
      ++votes[std::size_t(priors[i])];
    return Prior(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }
};

/// What the caller knows, in his coordinates.
struct Raw_scan {
  Points points;
  Points hints;                ///< rough normals; empty: none
  Scan_directions directions;  ///< empty: none
  Gap_parameters gaps;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RAW_SCAN_H
