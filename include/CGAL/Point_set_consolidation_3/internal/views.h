// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEWS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEWS_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>
#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_frame.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Maps space onto the image of one scanner position. Lengths in the image are those at the object.
class Projection {
public:
  /// Orthographic, seen from the direction `towards_scanner`.
  static Projection orthographic(const Vec3& towards_scanner)
  {
    Projection projection;
    projection.set_axis(towards_scanner);
    return projection;
  }

  /// Perspective from `scanner`; `towards_scanner` is the direction from the object's middle, at
  /// `distance`. Azimuthal equidistant, so that wide fields of view do not stretch.
  static Projection perspective(const Vec3& scanner, const Vec3& towards_scanner, double distance)
  {
    Projection projection;
    projection.set_axis(towards_scanner);
    projection.m_is_perspective = true;
    projection.m_scanner = scanner;
    projection.m_distance = distance;
    return projection;
  }

  /// Finds the projection from the rays of one view: their common point if they have one.
  static Projection fit(const Points& points, const std::vector<Vec3>& towards_scanner)
  {
    Vec3 mean_direction = Vec3::Zero(), centre = Vec3::Zero();
    Mat3 normal_matrix = Mat3::Zero();
    Vec3 right_side = Vec3::Zero();
    const double n = double(points.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      mean_direction += towards_scanner[i];
      centre += points[i] / n;
    }
    const Vec3 axis = normalized_or(mean_direction, Vec3::UnitZ());
    double spread = 0, radius = 0;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Mat3 across = Mat3::Identity() - towards_scanner[i] * towards_scanner[i].transpose();
      normal_matrix += across;
      right_side += across * (points[i] - centre);
      spread += (towards_scanner[i] - axis).squaredNorm() / n;
      radius += (points[i] - centre).squaredNorm() / n;
    }
    constexpr double parallel_spread = 1e-6;  // mean squared angle: 0.06 degrees
    if(spread < parallel_spread)
      return orthographic(axis);
    const Vec3 scanner = centre + solve_normal_equations(normal_matrix, right_side);
    const double distance = (scanner - centre).norm();
    if(!(distance > std::sqrt(radius)) || (scanner - centre).dot(axis) <= 0)
      return orthographic(axis);  // the rays do not meet in front of the object
    return perspective(scanner, (scanner - centre) / distance, distance);
  }

  const Vec3& axis() const { return m_axis; }

  /// Position in the image, and height towards the scanner as third coordinate.
  Vec3 operator()(const Vec3& x) const
  {
    if(!m_is_perspective)
      return Vec3(x.dot(m_right), x.dot(m_up), x.dot(m_axis));
    const Vec3 ray = x - m_scanner;
    const double depth = ray.norm();
    const double right = ray.dot(m_right), up = ray.dot(m_up);
    const double across = std::sqrt(right * right + up * up);
    const double angle = std::atan2(across, -ray.dot(m_axis));
    const double scale = across > tiny_length ? m_distance * angle / across : 0;
    return Vec3(scale * right, scale * up, -depth);
  }

  /// Direction towards the scanner at x.
  Vec3 towards_scanner(const Vec3& x) const
  {
    return m_is_perspective ? normalized_or(m_scanner - x, m_axis) : m_axis;
  }
  /// Whether these are its rays; those of a fitted projection are if they come from one scanner position.
  bool has_rays(const Points& points, const Points& towards) const
  {
    double error = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      error += (towards_scanner(points[i]) - towards[i]).norm();
    constexpr double angle = 0.01;  // radians
    return error < angle * double(points.size());
  }
  const Vec3& right() const { return m_right; }
  const Vec3& up() const { return m_up; }

private:
  void set_axis(const Vec3& axis)
  {
    m_axis = normalized_or(axis, Vec3::UnitZ());
    const Tangent_frame image(m_axis);
    m_right = image.u;
    m_up = image.v;
  }

  bool m_is_perspective = false;
  Vec3 m_axis = Vec3::UnitZ(), m_right = Vec3::UnitX(), m_up = Vec3::UnitY();
  Vec3 m_scanner = Vec3::Zero();
  double m_distance = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEWS_H
