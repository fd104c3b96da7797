// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ALGEBRAIC_SPHERE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ALGEBRAIC_SPHERE_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, appendix II: algebraic spheres fitted to oriented points, after
/// Guennebaud and Gross, Algebraic Point Set Surfaces.

/// The field s(x) = u0 + u . y + u4 y . y with y = (x - origin) / unit; its zero set is a sphere, or a
/// plane if u4 = 0. The centre is never formed: it lies at infinity for planes.
struct Algebraic_sphere {
  Vec3 origin = Vec3::Zero();
  double unit = 1;
  double u0 = 0;
  Vec3 u = Vec3::Zero();
  double u4 = 0;

  Vec3 local(const Vec3& x) const { return (x - origin) / unit; }
  /// Length times the gradient's length; a distance where the gradient has length one.
  double value(const Vec3& x) const
  {
    const Vec3 y = local(x);
    return unit * (u0 + u.dot(y) + u4 * y.squaredNorm());
  }
  Vec3 gradient(const Vec3& x) const { return u + 2 * u4 * local(x); }
  Vec3 normal(const Vec3& x, const Vec3& fallback) const
  {
    return normalized_or(gradient(x), fallback);
  }

  /// One over the radius, signed: positive if normals point away from the centre.
  double curvature() const
  {
    // |u|^2 - 4 u0 u4 is the squared gradient on the surface
    const double squared = u.squaredNorm() - 4 * u0 * u4;
    return squared > 0 ? 2 * u4 / (unit * std::sqrt(squared)) : 0;
  }

  /// Signed Euclidean distance to the zero set, along the ray through x and the centre.
  double signed_distance(const Vec3& x) const
  {
    const double g = gradient(x).norm();
    return g > tiny_length ? -step_to_zero(x) * g * unit : 0;
  }

  /// Equation (6): the nearest point of the zero set; `x` itself if the field has none.
  Vec3 project(const Vec3& x) const { return x + step_to_zero(x) * unit * gradient(x); }

  /// Equation (4): moves `x` by the arc length |arc| along the level set through `x`, in direction of
  /// the tangential vector `arc`.
  Vec3 slide(const Vec3& x, const Vec3& arc) const
  {
    const Vec3 g = gradient(x);
    const double length = g.norm(), a = arc.norm();
    if(!(length > tiny_length) || !(a > tiny_length))
      return x;
    const double kappa = 2 * u4 / (length * unit), angle = kappa * a;
    constexpr double small_angle = 1e-4;  // below, the series are exact to rounding
    const double sinc =
      std::abs(angle) < small_angle ? 1 - angle * angle / 6 : std::sin(angle) / angle;
    const double versine_by_angle =
      std::abs(angle) < small_angle ? angle / 2 : (1 - std::cos(angle)) / angle;
    return x + sinc * arc - versine_by_angle * a / length * g;
  }

private:
  /// t with s(x + unit t grad s(x)) = 0, the root nearest to zero.
  double step_to_zero(const Vec3& x) const
  {
    const Vec3 y = local(x);
    const double s = u0 + u.dot(y) + u4 * y.squaredNorm();
    const double g2 = (u + 2 * u4 * y).squaredNorm();
    const double root = std::sqrt((std::max)(0., g2 * g2 - 4 * u4 * g2 * s));
    const double denominator = g2 + root;
    return denominator > tiny_length * tiny_length ? -2 * s / denominator : 0;
  }
};

/// Weighted sums of oriented points relative to an origin, and the sphere that fits them best: the closed
/// form of equation (9) for beta -> infinity, from which the printed beta = 10^6 h^2 differs by less than
/// the rounding of coordinates.
class Algebraic_sphere_fit {
public:
  Algebraic_sphere_fit(const Vec3& origin, double unit) : m_origin(origin), m_unit(unit) {}

  /// `offset`: from the origin to the point.
  void add(double weight, const Vec3& offset, const Vec3& normal)
  {
    const Vec3 y = offset / m_unit;
    m_w += weight;
    m_y += weight * y;
    m_n += weight * normal;
    m_yy += weight * y.squaredNorm();
    m_yn += weight * y.dot(normal);
    m_nn += weight * normal.squaredNorm();
    ++m_count;
  }

  std::size_t count() const { return m_count; }

  Algebraic_sphere sphere() const
  {
    Algebraic_sphere sphere;
    sphere.origin = m_origin;
    sphere.unit = m_unit;
    if(!(m_w > 0))
      return sphere;
    constexpr double coincident = 1e-9;  // spread of the points, in units squared: no curvature to see
    const double spread = m_yy - m_y.squaredNorm() / m_w;
    if(m_count > 1 && spread > coincident * m_w)
      sphere.u4 = 0.5 * (m_yn - m_y.dot(m_n) / m_w) / spread;
    sphere.u = (m_n - 2 * sphere.u4 * m_y) / m_w;
    sphere.u0 = -(sphere.u.dot(m_y) + sphere.u4 * m_yy) / m_w;
    return sphere;
  }

  /// Root mean square difference between the points' normals and the fitted gradient: 0 on spheres and
  /// planes, large at folds, ridges and where sheets meet.
  double normal_residual(const Algebraic_sphere& sphere) const
  {
    if(!(m_w > 0))
      return 0;
    // sum w |n - u - 2 u4 y|^2, expanded
    const double sum = m_nn + m_w * sphere.u.squaredNorm() + 4 * sphere.u4 * sphere.u4 * m_yy -
                       2 * sphere.u.dot(m_n) - 4 * sphere.u4 * m_yn +
                       4 * sphere.u4 * sphere.u.dot(m_y);
    return std::sqrt((std::max)(0., sum / m_w));
  }

private:
  Vec3 m_origin;
  double m_unit;
  double m_w = 0, m_yy = 0, m_yn = 0, m_nn = 0;
  Vec3 m_y = Vec3::Zero(), m_n = Vec3::Zero();
  std::size_t m_count = 0;
};

/// Oriented points that define an algebraic point set surface of support `h`.
class Algebraic_surface {
public:
  struct Fit {
    Algebraic_sphere sphere;
    std::size_t count = 0;         ///< points in the support
    double normal_residual = 0;
  };

  Algebraic_surface() = default;
  Algebraic_surface(Points points, Points normals, double h)
    : m_points(std::move(points)), m_normals(std::move(normals)), m_grid(m_points, h), m_h(h) {}

  double support() const { return m_h; }
  const Points& points() const { return m_points; }
  const Points& normals() const { return m_normals; }

  /// The sphere at `x`. Points whose normals oppose `side` lie on another sheet and are left out (zero
  /// vector: none is).
  Fit fit(const Vec3& x, const Vec3& side) const
  {
    Algebraic_sphere_fit sums(x, m_h);
    const double inverse_h2 = 1 / (m_h * m_h);
    m_grid.for_each_neighbor_block(x, m_h, [&](const Neighbor_block& block) {
      for(int k = 0; k < block.size; ++k) {
        const Vec3& n = m_normals[block.index[k]];
        if(n.dot(side) < 0)
          continue;
        const double t = 1 - block.d2[k] * inverse_h2;  // phi(r) = (1 - r^2)^4
        const double weight = (t * t) * (t * t);
        if(weight > 0)
          sums.add(weight, block.offset(k), n);
      }
    });
    Fit fit;
    fit.count = sums.count();
    fit.sphere = sums.sphere();
    fit.normal_residual = sums.normal_residual(fit.sphere);
    return fit;
  }

  /// Projects `x` onto the surface by `steps` fits. False, and nothing is changed, where the surface is not
  /// defined: fewer than three points in the support, or a projection that leaves it.
  bool project(Vec3& x, Vec3& normal, std::size_t steps) const
  {
    Vec3 y = x, n = normal;
    for(std::size_t step = 0; step < steps; ++step) {
      const Fit f = fit(y, n);
      if(f.count < least_points)
        return false;
      const Vec3 projected = f.sphere.project(y);
      if(!projected.allFinite() || (projected - x).squaredNorm() > m_h * m_h)
        return false;
      y = projected;
      n = f.sphere.normal(y, n);
      constexpr double converged = 1e-9;  // in units of h
      if((f.sphere.origin - y).squaredNorm() < converged * converged * m_h * m_h)
        break;
    }
    x = y;
    normal = n;
    return true;
  }

  static constexpr std::size_t least_points = 3;

private:
  Points m_points, m_normals;
  Sorted_grid m_grid;
  double m_h = 1;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ALGEBRAIC_SPHERE_H
