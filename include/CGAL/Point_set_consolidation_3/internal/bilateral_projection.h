// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_PROJECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_PROJECTION_H

#include <CGAL/Point_set_consolidation_3/internal/bilateral_weights.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Bilateral projection of oriented points: along its normal, a point moves to the weighted mean of the heights
/// of its neighbours over the tangent plane, weighted by distance and by similarity of the normals, so that
/// points beyond a sharp edge do not pull. After Fleishman, Drori and Cohen-Or, and the projection of
/// Huang et al., Edge-Aware Point Set Resampling.

/// theta is exp(-(2 d / radius)^2): 2 % at the border of the neighbourhood.
constexpr double bilateral_theta_factor = 4;

inline void project_bilaterally(Execution& execution, Stage& stage, Points& points,
                                Points& normals, const std::vector<char>& is_constrained,
                                const Bilateral_parameters& parameters)
{
  constexpr double degree = CGAL_PI / 180;
  const Bilateral_weights weights{std::cos(parameters.sharpness_angle * degree)};
  const double factor = bilateral_theta_factor / (parameters.radius * parameters.radius);
  const auto for_each_weight = [&](const Sorted_grid& grid, std::size_t i, const auto& body) {
    grid.for_each_neighbor_block(points[i], parameters.radius, [&](const Neighbor_block& block) {
      for(int k = 0; k < block.size; ++k) {
        const Vec3& n = normals[block.index[k]];
        body(Bilateral_weights::theta(factor * block.d2[k]) * weights.phi(normals[i], n),
             block.offset(k), n);
      }
    });
  };
  const auto stays = [&](std::size_t i) { return !is_constrained.empty() && is_constrained[i]; };

  for(std::size_t t = 0; t < parameters.iterations; ++t) {
    const Sorted_grid grid(points, parameters.radius);
    if(parameters.updates_normals) {
      Points next = normals;
      parallel_for_places(execution, grid, [&](std::size_t i) {
        if(stays(i))
          return;
        Vec3 sum = Vec3::Zero();
        for_each_weight(grid, i, [&](double w, const Vec3&, const Vec3& n) { sum += w * n; });
        next[i] = normalized_or(sum, normals[i]);
      });
      normals.swap(next);
    }
    Points next = points;
    parallel_for_places(execution, grid, [&](std::size_t i) {
      if(stays(i))
        return;
      double height = 0, total = 0;
      // heights over the point's own tangent plane; a neighbour at the same place counts as well
      for_each_weight(grid, i, [&](double w, const Vec3& offset, const Vec3&) {
        height += w * offset.dot(normals[i]);
        total += w;
      });
      if(total > 0)
        next[i] = points[i] + height / total * normals[i];
    });
    points.swap(next);
    stage.count_iteration();
    stage.update(double(t + 1) / double(parameters.iterations));
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BILATERAL_PROJECTION_H
