// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_OPTIMIZATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_OPTIMIZATION_H

#include <CGAL/Point_set_consolidation_3/internal/dipole_orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, sections III.B and VI: normals that belong to one of the point clusters
/// at a sharp edge instead of their mean. In: points and, if known, their normals. Out: unit normals.
/// Signs of given normals are kept. If normals are not oriented, neighbours are compared without regard to
/// their signs; if they are, the two sides of a thin plate are told apart.
///
/// The paper says only that clusters are distinguished. Done in two steps: a point takes the plane of that
/// neighbourhood around it that does not straddle an edge, then normals are averaged over neighbours
/// of the same cluster, weight phi of equation (5).

struct Normal_parameters {
  bool oriented = false;            ///< the signs of given normals mean something
  double sharpness_angle = 25;      ///< alpha of equation (5), degrees: normals this far apart are not averaged
  std::size_t iterations = 8;       ///< of the averaging within clusters
  std::size_t plane_neighbors = 30; ///< points of a candidate plane: 3 spacings, averages noise of half a spacing
  std::size_t neighbors = 24;       ///< of the averaging within clusters
};

/// phi of equation (5) with 1 - n n_i in the place of the misprint n_i n_i.
class Normal_similarity {
public:
  Normal_similarity(double angle_in_degrees, bool oriented)
    : m_inverse_width(1 / (1 - std::cos(angle_in_degrees * CGAL_PI / 180))), m_oriented(oriented)
  {}
  /// Cosine of the angle between two normals, or between their lines.
  double cosine(const Vec3& a, const Vec3& b) const
  {
    const double c = a.dot(b);
    return m_oriented ? c : std::abs(c);
  }
  double operator()(const Vec3& a, const Vec3& b) const
  {
    const double t = (1 - cosine(a, b)) * m_inverse_width;
    return std::exp(-t * t);  // squared as in CGAL: falls off steeply between clusters
  }

private:
  double m_inverse_width;
  bool m_oriented;
};

class Normal_optimization {
  /// A neighbourhood's plane replaces a point's own only if it fits this much better: on smooth surfaces
  /// all planes fit alike, and the own one is the best centred.
  static constexpr double significant_gain = 0.7;

public:
  Normal_optimization(const Execution& execution, const Points& points,
                      const Normal_parameters& parameters)
    : m_execution(execution), m_points(points), m_parameters(parameters)
    , m_table(nearest_table(execution, points,
                            (std::max)(parameters.plane_neighbors, parameters.neighbors)))
  {}

  const Nearest_table& table() const { return m_table; }

  /// Normals of the planes through the neighbours; across an edge they turn gradually.
  Points plane_normals() const
  {
    Points normals(m_points.size());
    parallel_for(m_execution, normals.size(),
                 [&](std::size_t i) { normals[i] = fitted_plane(i).normal; });
    return normals;
  }

  /// Typical distance of points from the planes through their neighbours: noise, and little curvature.
  double noise() const
  {
    std::vector<double> variances(m_points.size());
    parallel_for(m_execution, variances.size(),
                 [&](std::size_t i) { variances[i] = fitted_plane(i).variance; });
    return std::sqrt(median(std::move(variances)));
  }

  /// Normals of planes that stay on one side of an edge. Signs as in `hints`, if there are any.
  Points separated_normals(const Points& hints) const
  {
    const std::size_t n = m_points.size();
    std::vector<Plane> planes(n);
    parallel_for(m_execution, n, [&](std::size_t i) { planes[i] = fitted_plane(i); });

    std::vector<double> best(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      best[i] = planes[i].variance;
      for(std::size_t k = 0; k < (std::min)(m_parameters.plane_neighbors, m_table.k); ++k)
        best[i] = (std::min)(best[i], planes[m_table.row(i)[k]].variance);
    });
    const double noise = (std::max)(median(best), tiny_length);

    Points normals(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const std::size_t j = plane_of(planes, noise, i);
      normals[i] = planes[j].normal;
      if(!hints.empty() && normals[i].dot(hints[i]) < 0)
        normals[i] = -normals[i];
    });
    return normals;
  }

  /// Averages normals over neighbours of the same cluster.
  void smooth(Points& normals) const
  {
    const Normal_similarity phi(m_parameters.sharpness_angle, m_parameters.oriented);
    Points next(normals.size());
    for(std::size_t t = 0; t < m_parameters.iterations; ++t) {
      parallel_for(m_execution, normals.size(), [&](std::size_t i) {
        const std::size_t width = (std::min)(m_parameters.neighbors, m_table.k);
        Vec3 sum = normals[i];
        if(width > 0) {
          const Index* row = m_table.row(i);
          const double reach = (m_points[row[width - 1]] - m_points[i]).squaredNorm();
          for(std::size_t k = 0; k < width; ++k) {
            const Vec3& other = normals[row[k]];
            const double d2 = (m_points[row[k]] - m_points[i]).squaredNorm();
            // a Gauss function that has fallen to e^-2 at the last neighbour
            const double theta = reach > 0 ? std::exp(-2 * d2 / reach) : 1;
            const double sign = normals[i].dot(other) < 0 ? -1 : 1;  // phi is 0 if signs count
            sum += sign * theta * phi(normals[i], other) * other;
          }
        }
        next[i] = normalized_or(sum, normals[i]);
      });
      normals.swap(next);
    }
  }

private:
  struct Plane {
    Vec3 centre, normal;
    double variance;  ///< of the points' distances from the plane
  };

  Plane fitted_plane(std::size_t i) const
  {
    Covariance_sum sum;
    sum.add(Vec3::Zero());
    for(std::size_t k = 0; k < (std::min)(m_parameters.plane_neighbors, m_table.k); ++k)
      sum.add(m_points[m_table.row(i)[k]] - m_points[i]);
    const auto axes = sum.axes();
    return {m_points[i] + sum.mean(), axes.eigenvectors().col(0),
            (std::max)(0., axes.eigenvalues()[0])};
  }

  /// The candidate plane that fits its own points and point i best.
  std::size_t plane_of(const std::vector<Plane>& planes, double noise, std::size_t i) const
  {
    const auto cost = [&](std::size_t j) {
      const double d = planes[j].normal.dot(m_points[i] - planes[j].centre);
      // the distance of one point weighs less than the variance of a neighbourhood
      return planes[j].variance + 0.25 * (std::max)(0., d * d - noise);
    };
    const double own = cost(i);
    std::size_t best = i;
    double best_cost = significant_gain * own;
    for(std::size_t k = 0; k < (std::min)(m_parameters.plane_neighbors, m_table.k); ++k) {
      const std::size_t j = m_table.row(i)[k];
      const double c = cost(j);
      if(c < best_cost) {
        best_cost = c;
        best = j;
      }
    }
    return best;
  }

  const Execution& m_execution;
  const Points& m_points;
  Normal_parameters m_parameters;
  Nearest_table m_table;
};

/// Oriented normals of points without any.
inline Points estimated_normals(const Execution& execution, const Points& points)
{
  Normal_parameters parameters;
  parameters.plane_neighbors = 18;  // thin parts keep their two sides, signs need no more precision
  const Normal_optimization optimization(execution, points, parameters);
  Points normals = optimization.plane_normals();
  orient_by_dipoles(execution, points, normals);
  return normals;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_OPTIMIZATION_H
