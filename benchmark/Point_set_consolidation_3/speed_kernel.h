// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_SPEED_KERNEL_H
#define CONSOLIDATION_BENCHMARK_SPEED_KERNEL_H

#include "speed_operators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cmath>
#include <string>
#include <utility>

namespace benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Point_with_normal = std::pair<Point_3, Vector_3>;
using Point_map = CGAL::First_of_pair_property_map<Point_with_normal>;
using Normal_map = CGAL::Second_of_pair_property_map<Point_with_normal>;

inline std::vector<Point_3> points_of(const Speed_input& input)
{
  std::vector<Point_3> points;
  points.reserve(input.points.size());
  for(const Vec3& p : input.points)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

inline std::vector<Point_with_normal> pairs_of(const Speed_input& input)
{
  std::vector<Point_with_normal> pairs;
  pairs.reserve(input.points.size());
  for(std::size_t i = 0; i < input.points.size(); ++i) {
    const Vec3& p = input.points[i];
    const Vec3& n = input.normals[i];
    pairs.emplace_back(Point_3(p.x(), p.y(), p.z()), Vector_3(n.x(), n.y(), n.z()));
  }
  return pairs;
}

inline double particle_radius(const Speed_input& input)
{
  return radius_in_spacings * input.spacing / std::sqrt(particle_share);
}

/// Adds the operator `run(concurrency_tag, input, stopwatch)` twice: sequential and parallel.
template <typename Run>
void add_operator(std::vector<Speed_operator>& list, const std::string& name,
                  const std::string& counterpart, std::size_t largest, Run run)
{
  list.push_back(
      {name, counterpart, false, largest, [run](const Speed_input& input, Stopwatch& watch) {
         run(CGAL::Sequential_tag(), input, watch);
       }});
#ifdef CGAL_LINKED_WITH_TBB
  list.push_back(
      {name, counterpart, true, largest, [run](const Speed_input& input, Stopwatch& watch) {
         run(CGAL::Parallel_tag(), input, watch);
       }});
#endif
}

/// An operator that has no parallel version.
inline void add_sequential(std::vector<Speed_operator>& list, const std::string& name,
                           const std::string& counterpart, std::size_t largest,
                           std::function<void(const Speed_input&, Stopwatch&)> run)
{
  list.push_back({name, counterpart, false, largest, std::move(run)});
}

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_SPEED_KERNEL_H
