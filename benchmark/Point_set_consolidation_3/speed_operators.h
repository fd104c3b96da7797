// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H
#define CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H

#include "types.h"

#include <chrono>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace benchmark {

using support::Vec3;

/// What all operators get. The model has unit diagonal.
struct Speed_input {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;     ///< true ones
  std::vector<Vec3> directions;  ///< towards the scanner
  std::vector<int> views;
  double spacing = 0.0;  ///< mean distance to the 6 nearest neighbours
};

/// Started when the operator's own input is ready, stopped before its result is looked at.
class Stopwatch {
public:
  void start()
  {
    m_wall_begin = std::chrono::steady_clock::now();
    m_cpu_begin = std::clock();
  }
  void stop()
  {
    cpu_seconds = static_cast<double>(std::clock() - m_cpu_begin) / CLOCKS_PER_SEC;
    wall_seconds
        = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_wall_begin).count();
  }
  double cpu_seconds = 0.0;  ///< of all threads
  double wall_seconds = 0.0;

private:
  std::chrono::steady_clock::time_point m_wall_begin;
  std::clock_t m_cpu_begin = 0;
};

struct Speed_operator {
  std::string name;
  std::string counterpart;  ///< operator of CGAL that it is compared with; itself for CGAL's own
  bool parallel;
  std::size_t largest;  ///< not run on more points
  std::function<void(const Speed_input&, Stopwatch&)> run;
};

/// Particles of all projections, as a share of the points (CGAL's default).
constexpr double particle_share = 0.05;

/// Support radius of all projections, in spacings of the particles.
constexpr double radius_in_spacings = 2.0;

/// Radius of the neighbour queries, in spacings of the points: about 125 neighbours on a surface.
constexpr double query_radius = 5.0;

std::vector<Speed_operator> cgal_operators();
std::vector<Speed_operator> package_operators();

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H
