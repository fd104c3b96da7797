// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_CLIP_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_CLIP_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {
/// Balls inside of the shape for completion, each tangent to the surface at a consolidated point.
/// Lengths in units of the spacing r of S.
struct Balls {
  Points centres;
  std::vector<double> radius;
  std::vector<char> is_clipped;
};

/// The radius of a ball is the deep point's length, bounded by the largest ball tangent at s_i that
/// holds at most two obstacles: data of another part of the surface, or known free space.
class Ball_clip {
  static constexpr std::size_t tolerated = 2;     ///< obstacles: the third smallest tangent ball counts
  static constexpr double own_sheet = 3;          ///< data closer than this belong to the ball's own sheet
  static constexpr double grazing = 0.2;          ///< cosine: obstacles beside the point say nothing
  static constexpr double first_radius = 2;
  static constexpr double thickness = 0.95;       ///< balls of a union reach farther than each of them should
  static constexpr double flattest = 0.75;        ///< least share of the length that a flat face keeps
  static constexpr double curvature_gain = 1.5;   ///< noise lowers the measured curvature of round parts
  static constexpr double curvature_radius = 0.8; ///< of the ball's radius
  static constexpr double median_radius = 2;
  static constexpr double median_cosine = 0.7;

public:
  Ball_clip(const Execution& execution, const Points& points, const Points& normals,
            const Points& obstacles)
    : m_execution(execution), m_points(points), m_normals(normals)
    , m_point_grid(points, own_sheet), m_obstacle_grid(obstacles, own_sheet), m_obstacles(obstacles)
  {}

  /// `is_one_sided`: all data were seen from one side, so that nothing but the visible face tells the depth.
  Balls clip(const Points& anchors, double largest, bool is_one_sided) const
  {
    const std::size_t n = m_points.size();
    std::vector<double> length(n), smoothed(n);
    Balls balls;
    balls.centres.resize(n);
    balls.is_clipped.resize(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const double sunk = (std::min)((anchors[i] - m_points[i]).norm(), largest);
      length[i] = clipped(i, sunk);
      balls.is_clipped[i] = char(length[i] < sunk);
      if(is_one_sided)
        length[i] = thickness * flattened(i, length[i]);
    });
    parallel_for(m_execution, n, [&](std::size_t i) {
      std::vector<double> around;
      m_point_grid.for_each_neighbor(m_points[i], median_radius, [&](Index j, double) {
        if(m_normals[j].dot(m_normals[i]) > median_cosine)
          around.push_back(length[j]);
        return true;
      });
      smoothed[i] = median(std::move(around));
      balls.centres[i] = m_points[i] - smoothed[i] * m_normals[i];
    });
    balls.radius = std::move(smoothed);
    return balls;
  }

private:
  /// A section whose visible face is flatter than its ball is an ellipse rather than a circle: with half
  /// its width a and the curvature k = b / a^2 of the face, it is b = k a^2 thick instead of a.
  double flattened(std::size_t i, double length) const
  {
    const double radius = (std::max)(own_sheet, curvature_radius * length);
    const double roundness = curvature_gain * largest_curvature(i, radius) * length;
    return length * (std::min)(1., (std::max)(flattest, roundness));
  }

  /// Larger principal curvature, from the change of the normals over the neighbourhood.
  double largest_curvature(std::size_t i, double radius) const
  {
    const Vec3 &s = m_points[i], &n = m_normals[i];
    const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
    Mat3 normal_matrix = 1e-9 * Mat3::Identity();
    Vec3 right_side = Vec3::Zero();
    m_point_grid.for_each_neighbor(s, radius, [&](Index j, double) {
      constexpr double same_sheet = 0.3;
      if(m_normals[j].dot(n) < same_sheet)
        return true;
      const Vec3 d = m_points[j] - s, change = m_normals[j] - n;
      const double x = d.dot(u), y = d.dot(v);
      const Vec3 along_u(x, y, 0), along_v(0, x, y);
      normal_matrix += along_u * along_u.transpose() + along_v * along_v.transpose();
      right_side += change.dot(u) * along_u + change.dot(v) * along_v;
      return true;
    });
    const Vec3 form = solve_normal_equations(normal_matrix, right_side);  // second fundamental form
    return 0.5 * (form[0] + form[2]) + std::hypot(0.5 * (form[0] - form[2]), form[1]);
  }

  /// Tangent balls at one point are nested, so the balls are searched from small to large.
  double clipped(std::size_t i, double length) const
  {
    const Vec3 &s = m_points[i], &n = m_normals[i];
    std::vector<double> tangent;
    for(double radius = first_radius;; radius *= 2) {
      radius = (std::min)(radius, length);
      tangent.clear();
      const Vec3 centre = s - radius * n;
      m_point_grid.for_each_neighbor(centre, radius, [&](Index j, double) {
        const Vec3 d = s - m_points[j];
        if(d.squaredNorm() >= own_sheet * own_sheet)
          add_tangent(d, n, radius, tangent);
        return true;
      });
      m_obstacle_grid.for_each_neighbor(centre, radius, [&](Index j, double) {
        add_tangent(s - m_obstacles[j], n, radius, tangent);
        return true;
      });
      if(tangent.size() > tolerated) {
        std::nth_element(tangent.begin(), tangent.begin() + tolerated, tangent.end());
        return tangent[tolerated];
      }
      if(radius >= length)
        return length;
    }
  }

  static void add_tangent(const Vec3& d, const Vec3& n, double largest,
                          std::vector<double>& tangent)
  {
    const double squared = d.squaredNorm(), height = n.dot(d);
    if(height > grazing * std::sqrt(squared))
      tangent.push_back((std::min)(largest, squared / (2 * height)));
  }

  const Execution& m_execution;
  const Points& m_points;
  const Points& m_normals;
  Sorted_grid m_point_grid, m_obstacle_grid;
  const Points& m_obstacles;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_BALL_CLIP_H
