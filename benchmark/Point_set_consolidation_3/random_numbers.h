// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_RANDOM_NUMBERS_H
#define CONSOLIDATION_BENCHMARK_RANDOM_NUMBERS_H

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <random>

namespace benchmark {

/// Random numbers that do not depend on the standard library at hand: the engine is specified by the
/// standard, its distributions are not, so the transforms are spelled out.
class Random_numbers {
public:
  explicit Random_numbers(std::uint64_t seed) : m_engine(seed) {}

  /// uniform in [0, 1)
  double uniform() { return static_cast<double>(m_engine() >> 11) * 0x1.0p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// standard normal (Box and Muller; one of the pair is thrown away, so that the number of draws is fixed)
  double normal()
  {
    const double u = 1.0 - uniform();
    const double v = uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
  }

  /// uniform on the unit sphere
  Eigen::Vector3d direction()
  {
    const double z = uniform(-1.0, 1.0);
    const double angle = uniform(0.0, 2.0 * EIGEN_PI);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

private:
  std::mt19937_64 m_engine;
};

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_RANDOM_NUMBERS_H
