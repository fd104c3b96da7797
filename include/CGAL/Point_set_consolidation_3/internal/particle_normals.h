// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_NORMALS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_NORMALS_H

#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/quadric_fit.h>
#include <CGAL/Point_set_consolidation_3/internal/wlop_projection.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, line 9 of algorithm 1: normals of points and of particles.

/// Unoriented normals of quadrics fitted to the nearest neighbours.
inline Points table_normals(const Execution& execution, const Points& points,
                            const Nearest_table& nearest)
{
  constexpr std::size_t fitted_neighbors = 18;
  Points normals(points.size(), Vec3::UnitZ());
  parallel_for_places(execution, points, [&](std::size_t i) {
    std::vector<Neighbor> neighbors(1, Neighbor{Index(i), 0.});
    for(std::size_t k = 0; k < (std::min)(nearest.k, fitted_neighbors); ++k) {
      const Index j = nearest.row(i)[k];
      neighbors.push_back({j, (points[j] - points[i]).squaredNorm()});
    }
    const Vec3 normal = fit_quadric(points, points[i], neighbors).normal;
    if(normal.allFinite())
      normals[i] = normal;
  });
  return normals;
}

/// Orients each normal by its own hint, or, where that is nearly tangential, by those of its neighbours.
inline void orient_by_sides(const Execution& execution, Points& normals, const Points& sides,
                            const Nearest_table& nearest)
{
  constexpr double decisive = 0.2;  // cosine from which a point's own hint is trusted
  parallel_for(execution, normals.size(), [&](std::size_t i) {
    double vote = normals[i].dot(sides[i]);
    if(std::abs(vote) < decisive)
      for(std::size_t k = 0; k < nearest.k; ++k)
        vote += normals[i].dot(sides[nearest.row(i)[k]]);
    if(vote < 0)
      normals[i] = -normals[i];
  });
}

/// Normals of the particles from `first` on: those of the points around, on the side of the nearest of them, as a
/// linear function of the place. At borders, where all points lie on one side, their mean would be that of a place
/// within, and sheets would leave the border at that angle.
inline void update_particle_normals(const Execution& execution, const Points& points,
                                    const Points& normals, double h, const Points& particles,
                                    std::size_t first, Points& particle_normals)
{
  const Wlop_kernel kernel(h);
  const Sorted_grid grid(points, kernel.reach);
  const Nearest_neighbors tree(execution, points);
  particle_normals.resize(particles.size(), Vec3::UnitZ());
  parallel_for(execution, particles.size() - first, [&](std::size_t k) {
    const std::size_t i = first + k;
    const Vec3 side = normals[tree.nearest(particles[i]).index];
    // rows: the constant, then the offset's coordinates in units of the reach
    Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> sums = Eigen::Matrix<double, 4, 3>::Zero();
    grid.for_each_neighbor_block(particles[i], kernel.reach, [&](const Neighbor_block& block) {
      Block_weights theta;
      kernel.theta(block, theta);
      for(int j = 0; j < block.size; ++j) {
        const Vec3& n = normals[block.index[j]];
        if(!(n.dot(side) > 0))
          continue;
        Eigen::Vector4d row;
        row << 1, (points[block.index[j]] - particles[i]) / kernel.reach;
        moments += theta[j] * row * row.transpose();
        sums += theta[j] * row * n.transpose();
      }
    });
    // points near a plane leave the slope across it open; along it their mean square offset is an order above this
    constexpr double ridge = 1e-2;
    moments.diagonal().tail<3>().array() += ridge * moments(0, 0);
    const Vec3 mean = normalized_or(Vec3(sums.row(0)), side);
    const Eigen::Matrix<double, 4, 3> linear = solve_normal_equations(moments, sums);
    const Vec3 normal = normalized_or(Vec3(linear.row(0)), mean);
    constexpr double least_cosine = 0.9;  // farther from the mean it is noise
    particle_normals[i] = normal.allFinite() && normal.dot(mean) > least_cosine ? normal : mean;
  });
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARTICLE_NORMALS_H
