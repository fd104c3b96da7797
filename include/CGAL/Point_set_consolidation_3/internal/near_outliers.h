// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAR_OUTLIERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAR_OUTLIERS_H

#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/quadric_fit.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-B, end: data closer than h to the up-sampled surface, which is coarser
/// than they are, are outliers if they are off the surface that the data themselves make.

/// Heights over a tangent plane as a quadric of the plane's coordinates, fitted to neighbours of which many may
/// be outliers: iteratively reweighted least squares with Cauchy weights. The particles' surface, which is coarser
/// than the data, gives plane and first weights only.
class Robust_height {
  static constexpr std::size_t iterations = 6;
  typedef Height_frame::Vector Vector;
  typedef Height_frame::Matrix Matrix;

public:
  /// Offsets are relative to the origin of the plane.
  Robust_height(const Vec3& normal, std::size_t capacity)
  {
    Vec3::Index smallest;
    normal.cwiseAbs().minCoeff(&smallest);
    m_frame.normal = normal;
    m_frame.u = normalized_or(normal.cross(Vec3(Vec3::Unit(smallest))), Vec3::UnitX());
    m_frame.v = normal.cross(m_frame.u);
    m_offsets.reserve(capacity);
    m_first_distances.reserve(capacity);
  }

  /// `distance`: of the neighbour from the particles' surface.
  void add(const Vec3& offset, double distance)
  {
    m_offsets.push_back(offset);
    m_first_distances.push_back(distance);
  }

  /// False if there are too few neighbours. `least_scale` bounds the residuals' scale from below.
  bool fit(double least_scale)
  {
    const std::size_t n = m_offsets.size();
    if(n < 2 * Height_frame::coefficients)
      return false;
    m_frame.unit = 0;
    for(const Vec3& d : m_offsets)
      m_frame.unit = (std::max)(m_frame.unit, std::hypot(m_frame.u.dot(d), m_frame.v.dot(d)));
    if(!(m_frame.unit > 0))
      return false;
    std::vector<Vector> rows(n);
    std::vector<double> heights(n);
    for(std::size_t k = 0; k < n; ++k) {
      rows[k] = m_frame.monomials(m_offsets[k]);
      heights[k] = m_frame.height(m_offsets[k]);
    }
    m_residuals = m_first_distances;
    for(std::size_t t = 0; t < iterations; ++t) {
      const double scale = (std::max)(least_scale, 1.5 * median(m_residuals));
      Matrix A = Matrix::Zero();
      Vector b = Vector::Zero();
      for(std::size_t k = 0; k < n; ++k) {
        const double r = m_residuals[k] / scale, weight = 1 / ((1 + r * r) * (1 + r * r));
        A += weight * rows[k] * rows[k].transpose();
        b += weight * heights[k] * rows[k];
      }
      A.diagonal().array() += 1e-6 * A(0, 0);
      m_c = solve_normal_equations(A, b);
      if(!m_c.allFinite())
        return false;
      for(std::size_t k = 0; k < n; ++k)
        m_residuals[k] = std::abs(heights[k] - rows[k].dot(m_c));
    }
    return true;
  }

  double median_residual() const { return median(m_residuals); }

  /// Distance from the quadric, to first order.
  double distance(const Vec3& offset) const
  {
    const double slope = std::hypot(m_c[1], m_c[2]) / m_frame.unit;
    return std::abs(m_frame.height(offset) - m_frame.monomials(offset).dot(m_c)) /
           std::sqrt(1 + slope * slope);
  }

private:
  Height_frame m_frame;
  std::vector<Vec3> m_offsets;
  std::vector<double> m_first_distances, m_residuals;
  Vector m_c = Vector::Zero();
};

/// The data beside the particles' surface.
struct Data_on_surface {
  Points feet, normals;          ///< on that surface
  std::vector<double> distance;  ///< from it
};

/// Finds the data off the surface of the data themselves.
class Near_outliers {
  static constexpr std::size_t fitted_neighbors = 24, sparsity_neighbors = 6;
  static constexpr double least_scale = 0.25;  ///< of the limit: smaller residuals all have full weight

  /// The data that count, and how sparse all are among them.
  struct Base {
    std::vector<Index> kept;
    Points points;
    Nearest_neighbors tree;
    std::vector<double> sparsity;

    Base(const Execution& execution, const Points& data, const std::vector<Index>& order, std::vector<Index> indices)
      : kept(std::move(indices)), points(selected(data, kept)), tree(execution, points), sparsity(data.size(), 0.)
    {
      parallel_for_places(execution, order, [&](std::size_t i) {
        for(const Neighbor& neighbor : neighbors_of(i, data[i], sparsity_neighbors))
          sparsity[i] += std::sqrt(neighbor.squared_distance);
      });
    }

    /// Without datum i.
    std::vector<Neighbor> neighbors_of(std::size_t i, const Vec3& place, std::size_t k) const
    {
      std::vector<Neighbor> found;
      tree.find(place, k + 1, found);
      const auto self =
        std::find_if(found.begin(), found.end(), [&](const Neighbor& n) { return kept[n.index] == i; });
      found.erase(self == found.end() ? found.end() - 1 : self);
      return found;
    }
  };

public:
  /// `order` is that of places.
  Near_outliers(const Execution& execution, const Points& data, const std::vector<Index>& order,
                const Data_on_surface& foot, const Outlier_parameters& parameters)
    : m_execution(execution), m_data(data), m_order(order), m_foot(foot), m_parameters(parameters)
  {
  }

  /// Of `is_candidate`, those that one of the evidences tells from the surface of the data that `is_left_out` does not
  /// flag.
  std::vector<char> find(const std::vector<char>& is_candidate, const std::vector<char>& is_left_out,
                         const std::vector<Outlier_evidence>& evidences) const
  {
    std::vector<Index> kept;
    for(std::size_t i = 0; i < m_data.size(); ++i)
      if(!is_left_out[i])
        kept.push_back(Index(i));
    std::vector<char> is_outlier(m_data.size(), 0);
    if(kept.size() <= fitted_neighbors)
      return is_outlier;
    const Base base(m_execution, m_data, m_order, std::move(kept));
    parallel_for_places(m_execution, m_order, [&](std::size_t i) {
      is_outlier[i] = is_candidate[i] && is_off(base, evidences, i, m_foot.feet[i], true) &&
                      is_off(base, evidences, i, m_data[i], false);
    });
    return is_outlier;
  }

private:
  /// How dense the data is, the neighbours of the foot tell: those of the point may be outliers themselves.
  bool is_off(const Base& base, const std::vector<Outlier_evidence>& evidences, std::size_t i, const Vec3& place,
              bool tests_sparsity) const
  {
    const double h = m_parameters.support_radius, limit = evidences.front().distance * h;
    const std::vector<Neighbor> found = base.neighbors_of(i, place, fitted_neighbors);
    std::vector<double> sparsities;
    sparsities.reserve(found.size());
    for(const Neighbor& neighbor : found)
      sparsities.push_back(base.sparsity[base.kept[neighbor.index]]);
    const double relative_sparsity = base.sparsity[i] / median(std::move(sparsities));
    const auto is_sparse = [&](const Outlier_evidence& e) { return relative_sparsity > e.sparsity; };
    if(tests_sparsity && std::none_of(evidences.begin(), evidences.end(), is_sparse))
      return false;
    const Vec3& foot = m_foot.feet[i];
    Robust_height quadric(m_foot.normals[i], found.size());
    for(const Neighbor& neighbor : found)
      quadric.add(base.points[neighbor.index] - foot, m_foot.distance[base.kept[neighbor.index]]);
    if(!quadric.fit(least_scale * limit))
      return false;
    const double off = quadric.distance(m_data[i] - foot);
    return off > limit && off > m_parameters.near_factor * quadric.median_residual() &&
           (!tests_sparsity || std::any_of(evidences.begin(), evidences.end(), [&](const Outlier_evidence& e) {
              return off > e.distance * h && is_sparse(e);
            }));
  }

  const Execution& m_execution;
  const Points& m_data;
  const std::vector<Index>& m_order;
  const Data_on_surface& m_foot;
  const Outlier_parameters& m_parameters;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAR_OUTLIERS_H
