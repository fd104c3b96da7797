// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_SELECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_SELECTION_H

#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, sections IV-B and IV-D: which data points are outliers, which up-sampled
/// points are new, and which of them are taken back at the end.

struct Outlier_parameters {
  double support_radius = 1;        ///< h
  /// Data farther from the up-sampled surface are outliers, in units of h. Printed: 1, which keeps clusters.
  double far_distance = 0.35;
  /// Data off the tangent planes of the nearest up-sampled points by more than `near_distance` h and by
  /// more than `near_factor` times the median of their neighbours. h is larger than usual noise, so the
  /// printed rule alone finds none of it; the local median keeps detail that the particles do not resolve.
  bool removes_near = true;
  double near_distance = 0.05;
  double near_factor = 3;
  /// Flagged points closer than h are kept if they are a smaller share of the data: a clean scan has about
  /// 0.2 % of points in crevices and on tips that the particles do not resolve.
  double least_share = 0.005;
};

/// One flag per data point. `surface`: the up-sampled points.
inline std::vector<char> outlier_points(const Execution& execution, const Points& data,
                                        const Nearest_table& nearest, const Points& surface,
                                        const Points& surface_normals,
                                        const Outlier_parameters& parameters)
{
  std::vector<char> is_outlier(data.size(), 0), is_beyond(data.size(), 0);
  if(surface.empty())
    return is_outlier;
  constexpr std::size_t planes = 6;
  const double h = parameters.support_radius;
  const Nearest_neighbors tree(surface);
  std::vector<double> distance(data.size());  // from the tangent planes
  parallel_for(execution, data.size(), [&](std::size_t i) {
    std::vector<Neighbor> found;
    tree.find(data[i], planes, found);
    for(const Neighbor& u : found)
      distance[i] += std::abs(surface_normals[u.index].dot(data[i] - surface[u.index]));
    distance[i] /= double(found.size());
    const double far = parameters.far_distance * h;
    is_outlier[i] = found.front().squared_distance > far * far;
    is_beyond[i] = found.front().squared_distance > (std::max)(far, h) * (std::max)(far, h);
  });
  parallel_for(execution, data.size(), [&](std::size_t i) {
    if(!parameters.removes_near || distance[i] <= parameters.near_distance * h)
      return;
    std::vector<double> around;
    for(std::size_t k = 0; k < nearest.k; ++k)
      around.push_back(distance[nearest.row(i)[k]]);
    if(distance[i] > parameters.near_factor * median(std::move(around)))
      is_outlier[i] = 1;
  });
  const std::size_t flagged =
    std::size_t(std::count(is_outlier.begin(), is_outlier.end(), char(1)));
  return double(flagged) < parameters.least_share * double(data.size()) ? is_beyond : is_outlier;
}

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

struct Peel_parameters {
  double radius = 0.5;          ///< of the neighbourhood that must surround a point
  double largest_gap = 150;     ///< degrees
};

/// Added points at an open border are taken back, one layer after the other: a sheet that closed no hole
/// disappears, one that did has no border. Points before `first_added` stay. Returns a flag per point.
inline std::vector<char> peel_open_borders(const Execution& execution, const Points& points,
                                           const Points& normals, std::size_t first_added,
                                           const Peel_parameters& parameters)
{
  const std::size_t n = points.size();
  std::vector<char> removed(n, 0);
  const Sorted_grid grid(points, parameters.radius);
  constexpr double degree = 3.14159265358979324 / 180;
  const auto is_open = [&](std::size_t i) {
    const Vec3& normal = normals[i];
    Vec3::Index smallest;
    normal.cwiseAbs().minCoeff(&smallest);
    const Vec3 e1 = normalized_or(normal.cross(Vec3(Vec3::Unit(smallest))), Vec3::UnitX());
    const Vec3 e2 = normal.cross(e1);
    std::vector<double> angles;
    grid.for_each_neighbor(points[i], parameters.radius, [&](Index j, double d2) {
      if(j != i && d2 > 0 && !removed[j] && normals[j].dot(normal) > 0) {
        const Vec3 d = points[j] - points[i];
        angles.push_back(std::atan2(d.dot(e2), d.dot(e1)));
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
