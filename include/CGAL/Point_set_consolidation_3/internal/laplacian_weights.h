// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_WEIGHTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_WEIGHTS_H

#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_rings.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {

namespace internal {

/// Laplacian contraction paper, section III.A: weights of the Laplacian on fixed rings, for moving points.
/// Rows: (L p)_i = sum_j w_ij (p_j - p_i). The triangles of the rings are kept; only lengths and
/// angles change while the points contract.
class Ring_laplacian {
  /// Rows are scaled down to this sum of weights, so that the weights of collapsed triangles do not
  /// spoil the system. Single weights stay as they are, negative ones too: clamping them makes loops collapse.
  static constexpr double largest_row = 1e4;

public:
  Ring_laplacian(const Tangent_rings& rings, Laplacian_weights scheme)
    : m_rings(rings), m_scheme(scheme), m_weights(rings.neighbors.size(), 0.)
    , m_diagonal(rings.number_of_points(), 0.)
  {
    list_corners();
  }

  const Tangent_rings& rings() const { return m_rings; }
  /// w_ij, parallel to `rings().neighbors`
  double weight(std::size_t slot) const { return m_weights[slot]; }
  /// minus the sum of the weights of row i
  double diagonal(std::size_t i) const { return m_diagonal[i]; }

  void update(const Execution& execution, const Points& points)
  {
    parallel_for(execution, m_diagonal.size(), [&](std::size_t i) {
      const std::size_t begin = m_rings.first[i], end = m_rings.first[i + 1];
      std::fill(m_weights.begin() + std::ptrdiff_t(begin), m_weights.begin() + std::ptrdiff_t(end), 0.);
      for(std::size_t c = m_first_corner[i]; c < m_first_corner[i + 1]; ++c)
        add_corner(points, i, m_corners[c]);
      double sum = 0;
      for(std::size_t slot = begin; slot < end; ++slot)
        sum += m_weights[slot];
      // mean value weights have the unit 1 / length: made comparable to the others
      if(m_scheme == Laplacian_weights::MEAN_VALUE && sum > 0) {
        scale_row(i, double(end - begin) / sum);
        sum = double(end - begin);
      }
      if(std::abs(sum) > largest_row) {
        scale_row(i, largest_row / std::abs(sum));
        sum = sum > 0 ? largest_row : -largest_row;
      }
      m_diagonal[i] = -sum;
    });
  }

private:
  struct Corner {  ///< a triangle seen from one of its corners
    std::size_t slots[2];  ///< places of the two others in the corner's row
  };

  void list_corners()
  {
    m_first_corner.assign(m_rings.number_of_points() + 1, 0);
    for(const Ring_triangle& t : m_rings.triangles)
      for(const Index i : t)
        ++m_first_corner[i + 1];
    for(std::size_t i = 0; i + 1 < m_first_corner.size(); ++i)
      m_first_corner[i + 1] += m_first_corner[i];
    m_corners.resize(m_first_corner.back());
    std::vector<std::size_t> next(m_first_corner.begin(), m_first_corner.end() - 1);
    for(const Ring_triangle& t : m_rings.triangles)
      for(std::size_t c = 0; c < 3; ++c)
        m_corners[next[t[c]]++] = {{slot_of(t[c], t[(c + 1) % 3]), slot_of(t[c], t[(c + 2) % 3])}};
  }
  std::size_t slot_of(Index i, Index j) const
  {
    const auto begin = m_rings.neighbors.begin();
    return std::size_t(std::lower_bound(begin + std::ptrdiff_t(m_rings.first[i]),
                                        begin + std::ptrdiff_t(m_rings.first[i + 1]), j) - begin);
  }

  void scale_row(std::size_t i, double factor)
  {
    for(std::size_t slot = m_rings.first[i]; slot < m_rings.first[i + 1]; ++slot)
      m_weights[slot] *= factor;
  }

  static double finite_ratio(double numerator, double denominator)
  {
    const double ratio = numerator / denominator;
    return std::isfinite(ratio) ? ratio : 0;
  }

  void add_corner(const Points& points, std::size_t i, const Corner& corner)
  {
    const Vec3& p = points[i];
    const Vec3& a = points[m_rings.neighbors[corner.slots[0]]];
    const Vec3& b = points[m_rings.neighbors[corner.slots[1]]];
    switch(m_scheme) {
      case Laplacian_weights::COTANGENT: {
        const double twice_area = (a - p).cross(b - p).norm();
        m_weights[corner.slots[0]] += finite_ratio((p - b).dot(a - b), twice_area);
        m_weights[corner.slots[1]] += finite_ratio((p - a).dot(b - a), twice_area);
        break;
      }
      case Laplacian_weights::MEAN_VALUE: {
        // tan(angle / 2) = sin / (1 + cos)
        const double la = (a - p).norm(), lb = (b - p).norm();
        const double half_tangent =
          finite_ratio((a - p).cross(b - p).norm(), la * lb + (a - p).dot(b - p));
        m_weights[corner.slots[0]] += finite_ratio(half_tangent, la);
        m_weights[corner.slots[1]] += finite_ratio(half_tangent, lb);
        break;
      }
      case Laplacian_weights::COMBINATORIAL:
        m_weights[corner.slots[0]] = m_weights[corner.slots[1]] = 1;
        break;
    }
  }

  const Tangent_rings& m_rings;
  Laplacian_weights m_scheme;
  std::vector<double> m_weights, m_diagonal;
  std::vector<std::size_t> m_first_corner;
  std::vector<Corner> m_corners;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_WEIGHTS_H
