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
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>
#include <CGAL/Point_set_consolidation_3/options.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

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
