// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAPS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAPS_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/options.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What the caller wants of the gaps. Lengths in r.
struct Gap_parameters {
  double largest = (std::numeric_limits<double>::max)();  ///< wider gaps stay open
  Prior prior = Prior::VOLUME_PRESERVING;
  double shrinkage = 0.1;             ///< of the minimal volume prior, per r of distance from the data
  std::vector<Prior> priors;          ///< one per datum; empty: `prior` everywhere
  std::vector<char> is_frozen;        ///< one per datum: nothing is completed next to it; empty: none

  /// The prior of most of the data at the border of a gap.
  Prior prior_of(const std::vector<Index>& border) const
  {
    if(priors.empty())
      return prior;
    std::array<std::size_t, 3> votes = {};
    for(const Index i : border)
      ++votes[std::size_t(priors[i])];
    return Prior(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }
};

/// Data nearest to the points of a gap, each once.
inline std::vector<Index> border_of(const Execution& execution, const Nearest_neighbors& data_tree,
                                    const Points& gap)
{
  std::vector<Index> border(gap.size());
  parallel_for(execution, border.size(),
               [&](std::size_t i) { border[i] = data_tree.nearest(gap[i]).index; });
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAPS_H
