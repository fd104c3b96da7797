// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_UNION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_UNION_H

#include <CGAL/Point_set_consolidation_3/internal/ball_clip.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/scalar_grid.h>

#include <array>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The solid that the balls make, on a grid, and which of it is seen from
/// outside. Lengths in units of the spacing r of S.
class Ball_union {
public:
  /// A node is inside if so many balls hold it: neighbouring balls overlap, so that one alone is too large.
  static constexpr std::size_t agreeing_balls = 3;

  /// Distances are clamped to this.
  static constexpr double band = 2.5;

  /// max(|x - b_i| - l_i of the third nearest ball, Phi(x)), clamped, not yet smoothed. `phi` is
  /// a grid of the same nodes, or empty.
  static Scalar_grid make(const Execution& execution, const Bounding_box& box, double step,
                          const Balls& balls, const Scalar_grid* phi)
  {
    Solids solids;
    solids.fill(Scalar_grid(box, step, float(band)));
    Scalar_grid& solid = solids.back();
    parallel_for(execution, std::size_t(solid.size(2)), [&](std::size_t plane) {
      const int z = int(plane);
      for(std::size_t i = 0; i < balls.centres.size(); ++i)
        add_ball(solids, z, (balls.centres[i] - solid.origin()) / step, balls.radius[i]);
      if(phi != nullptr)
        for(int y = 0; y < solid.size(1); ++y) {
          Eigen::Map<Eigen::ArrayXf> row(solid.row(y, z), solid.size(0));
          row = row.max(Eigen::Map<const Eigen::ArrayXf>(phi->row(y, z), solid.size(0)));
        }
    }, long_bodies);
    return std::move(solid);
  }

  /// Nodes outside of the solid that a corner of the grid can reach: inner voids are no surface.
  static std::vector<char> outside(const Scalar_grid& solid)
  {
    std::vector<char> is_outside(solid.number_of_nodes(), 0);
    std::vector<std::size_t> front(1, 0);
    is_outside[0] = 1;
    while(!front.empty()) {
      const std::size_t i = front.back();
      front.pop_back();
      for(int axis = 0; axis < 3; ++axis) {
        const std::size_t stride = solid.stride(axis);
        const std::size_t coordinate = i / stride % std::size_t(solid.size(axis));
        const auto visit = [&](std::size_t j) {
          if(!is_outside[j] && solid[j] > 0) {
            is_outside[j] = 1;
            front.push_back(j);
          }
        };
        if(coordinate > 0)
          visit(i - stride);
        if(coordinate + 1 < std::size_t(solid.size(axis)))
          visit(i + stride);
      }
    }
    return is_outside;
  }

private:
  /// Distances to the nearest, second nearest, ... ball.
  typedef std::array<Scalar_grid, agreeing_balls> Solids;

  /// One plane of a ball; `centre` in grid units.
  static void add_ball(Solids& solids, int z, const Vec3& centre, double radius)
  {
    const Scalar_grid& grid = solids.front();
    const double step = grid.step();
    const double reach = (radius + band) / step;
    const double dz = z - centre.z();
    const double left = reach * reach - dz * dz;
    if(left <= 0)
      return;
    const double half_y = std::sqrt(left);
    const int y0 = (std::max)(0, int(std::ceil(centre.y() - half_y)));
    const int y1 = (std::min)(grid.size(1) - 1, int(std::floor(centre.y() + half_y)));
    Eigen::ArrayXf distance, displaced;
    for(int y = y0; y <= y1; ++y) {
      const double dy = y - centre.y();
      const double half_x = std::sqrt((std::max)(0., left - dy * dy));
      const int x0 = (std::max)(0, int(std::ceil(centre.x() - half_x)));
      const int x1 = (std::min)(grid.size(0) - 1, int(std::floor(centre.x() + half_x)));
      if(x1 < x0)
        continue;
      distance.setLinSpaced(x1 - x0 + 1, float(x0 - centre.x()), float(x1 - centre.x()));
      distance = ((distance.square() + float(dy * dy + dz * dz)).sqrt() * float(step) -
                  float(radius)).max(-float(band));
      for(Scalar_grid& solid : solids) {
        Eigen::Map<Eigen::ArrayXf> row(solid.row(y, z) + x0, x1 - x0 + 1);
        displaced = row.max(distance);
        row = row.min(distance);
        distance.swap(displaced);
      }
    }
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_UNION_H
