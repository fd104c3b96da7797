// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_ITERATIVE_RUNS_H
#define CONSOLIDATION_BENCHMARK_ITERATIVE_RUNS_H

#include "types.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace benchmark {

using support::Point_cloud;
using support::Vec3;

struct Iterative_options {
  double particle_fraction = 0.1;
  unsigned int iterations = 10, repulsion_steps = 10;
  bool adaptive = true, two_phases = false, guard = true;
  bool printed_values = false;  ///< then of the above only the particles, iterations and loops count
  std::vector<char> is_static;  ///< empty: none
};

struct Iterative_run {
  Point_cloud cloud;  ///< kept points with confidence 1, then new ones with confidence 0
  Point_cloud added;
  std::vector<std::size_t> outliers;
  std::size_t inconsistent = 0, iterations = 0;
  double seconds = 0, cpu_seconds = 0;
};

/// `iterative_consolidate_point_set()` on all cores. Normals of the cloud are taken as they are; directions orient
/// estimated ones.
Iterative_run consolidate_iteratively(const Point_cloud& cloud, const Iterative_options& options = {});

/// Points with normals by PCA and a minimum spanning tree, both CGAL's.
Point_cloud oriented_by_spanning_tree(const std::vector<Vec3>& points);

/// Projected onto the algebraic surface of all of them, with a support radius in spacings.
std::vector<Vec3> projected_onto_apss(const Point_cloud& cloud, double support);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_ITERATIVE_RUNS_H
