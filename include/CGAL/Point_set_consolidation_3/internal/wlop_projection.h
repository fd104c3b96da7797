// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WLOP_PROJECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WLOP_PROJECTION_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, appendix I, equation (7): weighted locally optimal projection (WLOP)
/// with its true L1 data term. Particles are drawn to the L1 median of the data around them and
/// spread by a repulsion among themselves; some may be static: they act, but do not move.
/// Every step reads the previous positions and writes new ones.

/// theta(r) = exp(-16 r^2 / h^2), taken as zero beyond h / 2, where it is e^-4: beyond, four times the
/// neighbours change nothing on even data and worsen uneven data.
struct Wlop_kernel {
  explicit Wlop_kernel(double h)
    : reach(h / 2), factor(16 / (h * h)), least_squared_distance(0.05 * h * 0.05 * h) {}

  double reach;
  double factor;
  /// 1/r is taken at no less than 0.05 h: a particle starts on a data point, where 1/r has a pole.
  double least_squared_distance;

  void theta(const Neighbor_block& block, Block_weights& weights) const
  {
    weights.set_gaussian(factor, block);
  }
  void theta_by_distance(const Neighbor_block& block, Block_weights& weights) const
  {
    weights.set_gaussian(factor, block) /=
      block.squared_distance().max(least_squared_distance).sqrt();
  }
};

/// Weights by position alone. A policy for other weights multiplies into the columns: `data()` for the
/// attraction of particle i by data points, `particles()` for its repulsion.
struct Isotropic_weights {
  void data(std::size_t, const Neighbor_block&, Block_weights&) const {}
  void particles(std::size_t, const Neighbor_block&, Block_weights&) const {}
};

/// 1 + sum of theta over all others: the densities v_j of the data and w_q of the particles.
inline double wlop_density(const Sorted_grid& grid, const Vec3& point, const Wlop_kernel& kernel)
{
  double sum = 0;  // the point itself is found with theta = 1
  grid.for_each_neighbor_block(point, kernel.reach, [&](const Neighbor_block& block) {
    Block_weights theta;
    kernel.theta(block, theta);
    sum += theta.column(block.size).sum();
  });
  return (std::max)(1., sum);
}

inline std::vector<double> wlop_densities(const Execution& execution, const Sorted_grid& grid,
                                          const Points& points, const Wlop_kernel& kernel)
{
  std::vector<double> densities(points.size());
  parallel_for_places(execution, grid, [&](std::size_t i) {
    densities[i] = wlop_density(grid, points[i], kernel);
  });
  return densities;
}

/// The same for points within `reach` of `places`; others get 1 and must not be used.
inline std::vector<double> wlop_densities_near(const Execution& execution, const Sorted_grid& grid,
                                               const Points& points, const Wlop_kernel& kernel,
                                               const Points& places, double reach)
{
  const Sorted_grid place_grid(places, reach);
  std::vector<double> densities(points.size(), 1.);
  parallel_for_places(execution, grid, [&](std::size_t i) {
    bool is_used = false;
    place_grid.for_each_neighbor(points[i], reach, [&](Index, double) {
      is_used = true;
      return false;
    });
    if(is_used)
      densities[i] = wlop_density(grid, points[i], kernel);
  });
  return densities;
}

/// Second term of equation (7) without mu, and equation (1): the weighted mean of x_i - x_q over the other
/// particles. Zero for a particle without neighbours.
template <typename Weights>
Vec3 wlop_repulsion(const Sorted_grid& grid, const std::vector<double>& densities, const Vec3& x,
                    std::size_t i, const Wlop_kernel& kernel, const Weights& weights)
{
  Vec3 sum = Vec3::Zero();
  double total = 0;
  grid.for_each_neighbor_block(x, kernel.reach, [&](const Neighbor_block& block) {
    Block_weights b;
    kernel.theta_by_distance(block, b);
    for(int k = 0; k < block.size; ++k)
      b[k] *= block.index[k] == i ? 0. : densities[block.index[k]];
    weights.particles(i, block, b);
    const auto w = b.column(block.size);
    total += w.sum();
    sum -= block.weighted_offset(w);
  });
  return total > 0 ? Vec3(sum / total) : Vec3(Vec3::Zero());
}

/// Of all particles that the moving ones see.
inline std::vector<double> particle_densities(const Execution& execution, const Sorted_grid& grid,
                                              const Points& particles,
                                              const std::vector<std::size_t>& moving,
                                              const Wlop_kernel& kernel)
{
  if(moving.size() > particles.size() / 2)
    return wlop_densities(execution, grid, particles, kernel);
  return wlop_densities_near(execution, grid, particles, kernel, selected(particles, moving), kernel.reach);
}

/// The data as the projection sees them: positions, their grid and their densities v_j.
struct Wlop_data {
  const Sorted_grid* grid = nullptr;
  const std::vector<double>* densities = nullptr;
};

template <typename Weights = Isotropic_weights>
class Wlop_projection {
public:
  Wlop_projection(Execution& execution, const Wlop_data& data, const Wlop_parameters& parameters,
                  const Weights& weights = Weights())
    : m_execution(execution), m_data(data), m_parameters(parameters)
    , m_kernel(parameters.support_radius), m_weights(weights) {}

  /// Moves the particles that are not static. Returns the mean move of the last iteration.
  double run(Stage& stage, Points& particles, const std::vector<char>& is_static) const
  {
    std::vector<std::size_t> moving;
    for(const Index i : place_order(particles))
      if(is_static.empty() || !is_static[i])
        moving.push_back(i);
    double mean_move = 0;
    for(std::size_t t = 0; t < m_parameters.iterations && !moving.empty(); ++t) {
      mean_move = step(particles, moving);
      stage.count_iteration();
      stage.update(double(t + 1) / double(m_parameters.iterations));
      if(mean_move < m_parameters.least_move * m_parameters.support_radius)
        break;
    }
    return mean_move;
  }

private:
  double step(Points& particles, const std::vector<std::size_t>& moving) const
  {
    const Sorted_grid grid(particles, m_kernel.reach);
    const std::vector<double> densities =
      particle_densities(m_execution, grid, particles, moving, m_kernel);
    Points next(moving.size());
    parallel_for(m_execution, moving.size(), [&](std::size_t k) {
      const std::size_t i = moving[k];
      next[k] = attracted(particles[i], i) +
                m_parameters.repulsion *
                  wlop_repulsion(grid, densities, particles[i], i, m_kernel, m_weights);
    });
    double move = 0;
    for(std::size_t k = 0; k < moving.size(); ++k) {
      move += (next[k] - particles[moving[k]]).norm();
      particles[moving[k]] = next[k];
    }
    return move / double(moving.size());
  }

  /// First term of equation (7); the particle itself where it sees no data.
  Vec3 attracted(const Vec3& x, std::size_t i) const
  {
    Vec3 sum = Vec3::Zero();
    double total = 0;
    m_data.grid->for_each_neighbor_block(x, m_kernel.reach, [&](const Neighbor_block& block) {
      Block_weights a;
      m_kernel.theta_by_distance(block, a);
      for(int k = 0; k < block.size; ++k)
        a[k] /= (*m_data.densities)[block.index[k]];
      m_weights.data(i, block, a);
      const auto w = a.column(block.size);
      total += w.sum();
      sum += block.weighted_offset(w);
    });
    return total > 0 ? Vec3(x + sum / total) : x;
  }

  Execution& m_execution;
  Wlop_data m_data;
  Wlop_parameters m_parameters;
  Wlop_kernel m_kernel;
  Weights m_weights;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WLOP_PROJECTION_H
