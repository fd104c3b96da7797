// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HERMITE_SURFACE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HERMITE_SURFACE_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <Eigen/Core>
#include <Eigen/LU>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The smooth surface through oriented points: the zero set of
///   f(x) = sum_j (a_j phi(x - x_j) - b_j . grad phi(x - x_j)) + c_0 + c . x,  phi(d) = |d|^3,
/// with f(x_j) = 0, grad f(x_j) = n_j (I. Macedo, J. P. Gois, L. Velho: Hermite radial basis functions implicits.
/// Computer Graphics Forum 30(1), 2011). In space |d|^3 is the triharmonic kernel: of all such fields f has the least
/// third derivatives, so that curvature goes on where points are missing.

class Hermite_surface {
public:
  /// O(n^3): for some hundred points, no two of them equal.
  Hermite_surface(Points points, const Points& normals) : m_centres(std::move(points))
  {
    const auto n = Eigen::Index(m_centres.size());
    for(const Vec3& x : m_centres)
      m_origin += x / double(n);
    for(const Vec3& x : m_centres)
      m_unit = (std::max)(m_unit, (x - m_origin).norm());
    for(Vec3& x : m_centres)
      x = (x - m_origin) / m_unit;
    const Eigen::Index size = 4 * n + 4;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    for(Eigen::Index i = 0; i < n; ++i) {
      const Vec3& x = m_centres[std::size_t(i)];
      for(Eigen::Index j = 0; j < n; ++j) {
        const Vec3 d = x - m_centres[std::size_t(j)];
        const double r = d.norm();
        Mat3 hessian = 3 * r * Mat3::Identity();
        if(r > 0)
          hessian += 3 / r * d * d.transpose();
        A(4 * i, 4 * j) = r * r * r;
        A.block<1, 3>(4 * i, 4 * j + 1) = -3 * r * d.transpose();
        A.block<3, 1>(4 * i + 1, 4 * j) = 3 * r * d;
        A.block<3, 3>(4 * i + 1, 4 * j + 1) = -hessian;
      }
      A(4 * i, 4 * n) = 1;
      A.block<1, 3>(4 * i, 4 * n + 1) = x.transpose();
      A.block<3, 3>(4 * i + 1, 4 * n + 1) = Mat3::Identity();
      A.block<4, 4>(4 * n, 4 * i) = A.block<4, 4>(4 * i, 4 * n).transpose();
      b.segment<3>(4 * i + 1) = normals[std::size_t(i)];
    }
    m_factors.compute(A);
    m_coefficients = m_factors.solve(b);
    m_variance = std::abs(b.dot(m_coefficients)) / double(4 * n);
  }

  std::size_t number_of_centres() const { return m_centres.size(); }

  /// Moves `x` to the surface along gradients. False, and nothing is changed, if it does not come to the surface.
  bool project(Vec3& x, Vec3& normal) const
  {
    constexpr int most_steps = 20;
    constexpr double converged = 1e-6;  // of the extent of the points
    Vec3 y = local(x);
    for(int step = 0; step < most_steps; ++step) {
      const auto [value, gradient] = field(y);
      const double squared = gradient.squaredNorm();
      if(!(squared > 0) || !std::isfinite(value))
        return false;
      y -= value / squared * gradient;
      if(std::abs(value) > converged * std::sqrt(squared))
        continue;
      x = m_origin + m_unit * y;
      normal = gradient / std::sqrt(squared);
      return true;
    }
    return false;
  }

  /// Projects all, or none if one does not come to the surface.
  bool project(Points& points, Points& normals) const
  {
    Points projected = points, projected_normals = normals;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(!project(projected[i], projected_normals[i]))
        return false;
    points.swap(projected);
    normals.swap(projected_normals);
    return true;
  }

  /// How far the surface at `x` is likely to be from the true one: the standard deviation of f, as a Gaussian process
  /// with this kernel that the points are a sample of, by the length of its gradient. O(n^2).
  double deviation(const Vec3& x) const
  {
    const auto n = Eigen::Index(m_centres.size());
    const Vec3 y = local(x);
    Eigen::VectorXd row(4 * n + 4);
    for(Eigen::Index j = 0; j < n; ++j) {
      const Vec3 d = y - m_centres[std::size_t(j)];
      const double r = d.norm();
      row[4 * j] = r * r * r;
      row.segment<3>(4 * j + 1) = -3 * r * d;
    }
    row[4 * n] = 1;
    row.segment<3>(4 * n + 1) = y;
    const double variance = -row.dot(m_factors.solve(row)) * m_variance;
    return m_unit * std::sqrt((std::max)(0., variance)) / field(y).second.norm();
  }

private:
  Vec3 local(const Vec3& x) const { return (x - m_origin) / m_unit; }

  /// Value and gradient at `y`, in local coordinates.
  std::pair<double, Vec3> field(const Vec3& y) const
  {
    const auto n = Eigen::Index(m_centres.size());
    Vec3 gradient = m_coefficients.segment<3>(4 * n + 1);
    double value = m_coefficients[4 * n] + gradient.dot(y);
    for(Eigen::Index j = 0; j < n; ++j) {
      const Vec3 d = y - m_centres[std::size_t(j)], b = m_coefficients.segment<3>(4 * j + 1);
      const double a = m_coefficients[4 * j], r = d.norm(), along = d.dot(b);
      value += r * (a * r * r - 3 * along);
      gradient += 3 * r * (a * d - b);
      if(r > 0)
        gradient -= 3 * along / r * d;
    }
    return {value, gradient};
  }

  Points m_centres;
  Vec3 m_origin = Vec3::Zero();
  double m_unit = 0;
  Eigen::PartialPivLU<Eigen::MatrixXd> m_factors;
  Eigen::VectorXd m_coefficients;  ///< a_j, b_j of all points, c_0, c
  double m_variance = 0;           ///< of the process, for the kernel of unit size
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HERMITE_SURFACE_H
