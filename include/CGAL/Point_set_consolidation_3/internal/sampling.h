// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SAMPLING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SAMPLING_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>

#include <random>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Pseudo-random indices without repetition, in the order drawn; the same for the same arguments.
inline std::vector<std::size_t> random_subset(std::size_t n, std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  std::vector<std::size_t> order = all_indices<std::size_t>(n);
  count = (std::min)(count, n);
  for(std::size_t i = 0, left = n; i < count && left > 0; ++i, --left)
    std::swap(order[i], order[i + std::size_t(generator() % left)]);
  order.resize(count);
  return order;
}

/// Spacing to be expected of `count` points spread over the data: that of a random subset, as the median of
/// the mean distances to six neighbours, so that outliers do not matter.
inline double expected_spacing(const Execution& execution, const Points& data, std::size_t count)
{
  const Points subset = selected(data, random_subset(data.size(), count, 0));
  return median(neighbor_distances(execution, Nearest_neighbors(subset), subset, 6));
}

/// Puts the caller's points into a frame of their own: origin in their middle (the median, so that
/// outliers do not move it), unit the spacing of `count` of them.
inline Frame data_frame(const Execution& execution, const Points& world, std::size_t count)
{
  Frame frame;
  for(int axis = 0; axis < 3; ++axis) {
    std::vector<double> values(world.size());
    for(std::size_t i = 0; i < world.size(); ++i)
      values[i] = world[i][axis];
    frame.origin[axis] = median(std::move(values));
  }
  Points centred(world.size());
  for(std::size_t i = 0; i < world.size(); ++i)
    centred[i] = world[i] - frame.origin;
  frame.unit = expected_spacing(execution, centred, count);
  return frame;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SAMPLING_H
