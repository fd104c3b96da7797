// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONTRACTION_SAMPLES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONTRACTION_SAMPLES_H

#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The points that are contracted: distinct, evenly spread, not too many. Every input point knows the sample
/// it goes with.
struct Contraction_samples {
  Points points;
  std::vector<std::size_t> sample_of;  ///< parallel to the input
};

/// Index of the first of all points that are equal to point i, for every i.
inline std::vector<std::size_t> first_of_equals(const Points& points)
{
  std::vector<std::size_t> order = all_indices<std::size_t>(points.size()), first(points.size());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    for(int axis = 0; axis < 3; ++axis)
      if(points[a][axis] != points[b][axis])
        return points[a][axis] < points[b][axis];
    return a < b;
  });
  for(std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? first[order[k - 1]] : order[k];
  return first;
}

/// Distinct points of the input; if there are more than `most`, evenly spread ones.
inline Contraction_samples contraction_samples(const Execution& execution, const Points& points,
                                               std::size_t most)
{
  Contraction_samples samples;
  samples.sample_of = first_of_equals(points);
  std::vector<std::size_t> place(points.size(), 0);
  for(std::size_t i = 0; i < points.size(); ++i)
    if(samples.sample_of[i] == i) {
      place[i] = samples.points.size();
      samples.points.push_back(points[i]);
    }
  for(std::size_t& s : samples.sample_of)
    s = place[s];
  if(samples.points.size() <= most)
    return samples;
  samples.points = selected(samples.points, spread_points(samples.points, most));
  const Nearest_neighbors tree(samples.points);
  parallel_for(execution, points.size(),
               [&](std::size_t i) { samples.sample_of[i] = tree.nearest(points[i]).index; });
  return samples;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_CONTRACTION_SAMPLES_H
