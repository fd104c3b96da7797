// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MEAN_SHIFT_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MEAN_SHIFT_H

#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-B, algorithm 2: a particle is an outlier if the mean shift
/// carries it farther than a few spacings of the place where it ends.

/// One flag per point. Sets of at most k points have no outliers: every shift ends at their mean.
inline std::vector<char> mean_shift_outliers(const Execution& execution, const Points& points,
                                             const Mean_shift_parameters& parameters)
{
  std::vector<char> is_outlier(points.size(), 0);
  if(points.size() <= parameters.neighbors)
    return is_outlier;
  const Nearest_neighbors tree(execution, points);
  parallel_for_places(execution, points, [&](std::size_t i) {
    std::vector<Neighbor> K;
    Vec3 shifted = points[i];
    for(std::size_t step = 0; step < parameters.iterations; ++step) {
      tree.find(shifted, parameters.neighbors, K);
      Vec3 sum = Vec3::Zero();
      for(const Neighbor& k : K)
        sum += points[k.index];
      shifted = sum / double(K.size());
    }
    tree.find(shifted, parameters.neighbors, K);
    double mean_distance = 0;
    for(const Neighbor& k : K)
      mean_distance += std::sqrt(k.squared_distance) / double(K.size());
    is_outlier[i] = (shifted - points[i]).norm() > parameters.threshold * mean_distance;
  });
  return is_outlier;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MEAN_SHIFT_H
