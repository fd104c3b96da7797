// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_SELECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_SELECTION_H

#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_frame.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-D: which up-sampled points are new, and which of them are
/// taken back at the end.

/// L_pnt: the mean distance of points to the nearest other one.
inline double nearest_distance(const Execution& execution, const Points& points,
                               const Nearest_table& nearest)
{
  std::vector<double> distances(points.size(), 0.);
  parallel_for(execution, points.size(), [&](std::size_t i) {
    if(nearest.k > 0)
      distances[i] = (points[nearest.row(i)[0]] - points[i]).norm();
  });
  return mean(distances);
}

/// Indices of the candidates that keep `least_distance` from all points.
inline std::vector<std::size_t> select_new_points(const Execution& execution,
                                                  const Sorted_grid& points,
                                                  const Points& candidates, std::size_t first,
                                                  double least_distance)
{
  std::vector<char> is_new(candidates.size(), 0);
  parallel_for(execution, candidates.size() - first, [&](std::size_t k) {
    bool free = true;
    points.for_each_neighbor(candidates[first + k], least_distance,
                             [&](Index, double) { return free = false; });
    is_new[first + k] = free;
  });
  std::vector<std::size_t> selected;
  for(std::size_t i = first; i < candidates.size(); ++i)
    if(is_new[i])
      selected.push_back(i);
  return selected;
}

/// Added points at an open border are taken back, one layer after the other: a sheet that closed no hole
/// disappears, one that did has no border. Points before `first_added` stay. Returns a flag per point.
inline std::vector<char> peel_open_borders(const Execution& execution, const Points& points,
                                           const Points& normals, std::size_t first_added,
                                           const Peel_parameters& parameters)
{
  const std::size_t n = points.size();
  std::vector<char> removed(n, 0);
  const Sorted_grid grid(points, parameters.radius);
  constexpr double degree = CGAL_PI / 180;
  const auto is_open = [&](std::size_t i) {
    const Vec3& normal = normals[i];
    const Tangent_frame tangent(normal);
    std::vector<double> angles;
    grid.for_each_neighbor(points[i], parameters.radius, [&](Index j, double d2) {
      if(j != i && d2 > 0 && !removed[j] && normals[j].dot(normal) > 0) {
        const Vec3 d = points[j] - points[i];
        angles.push_back(std::atan2(d.dot(tangent.v), d.dot(tangent.u)));
      }
      return true;
    });
    if(angles.size() < 3)
      return true;
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 360 * degree - angles.back();
    for(std::size_t k = 1; k < angles.size(); ++k)
      gap = (std::max)(gap, angles[k] - angles[k - 1]);
    return gap > parameters.largest_gap * degree;
  };

  std::vector<std::size_t> front;
  for(std::size_t i = first_added; i < n; ++i)
    front.push_back(i);
  while(!front.empty()) {
    std::vector<char> open(front.size(), 0);
    parallel_for(execution, front.size(), [&](std::size_t k) { open[k] = is_open(front[k]); });
    std::vector<std::size_t> next;
    std::vector<char> is_queued(n, 0);
    for(std::size_t k = 0; k < front.size(); ++k)
      if(open[k])
        removed[front[k]] = 1;
    for(std::size_t k = 0; k < front.size(); ++k)
      if(open[k])
        grid.for_each_neighbor(points[front[k]], parameters.radius, [&](Index j, double) {
          if(j >= first_added && !removed[j] && !is_queued[j]) {
            is_queued[j] = 1;
            next.push_back(j);
          }
          return true;
        });
    front.swap(next);
  }
  return removed;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_SELECTION_H
