// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_QUADRIC_FIT_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_QUADRIC_FIT_H

#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Coordinates of offsets over a plane, for heights as a quadric of the plane's coordinates (a jet of degree 2).
struct Height_frame {
  static constexpr std::size_t coefficients = 6;
  typedef Eigen::Matrix<double, coefficients, 1> Vector;
  typedef Eigen::Matrix<double, coefficients, coefficients> Matrix;

  Vec3 normal = Vec3::UnitZ(), u = Vec3::UnitX(), v = Vec3::UnitY();
  double unit = 1;                ///< of the plane's coordinates

  double height(const Vec3& offset) const { return normal.dot(offset); }
  Vector monomials(const Vec3& offset) const
  {
    const double x = u.dot(offset) / unit, y = v.dot(offset) / unit;
    Vector row;
    row << 1, x, y, x * x, x * y, y * y;
    return row;
  }
};

/// A quadratic height field over the plane of a neighbourhood (a jet of degree 2).
struct Quadric_fit {
  Vec3 normal = Vec3::UnitZ();    ///< at the projection
  Vec3 projection = Vec3::Zero(); ///< of the query, along the plane's normal
  double residual = 0;            ///< root mean square of the heights left over
};

/// Fits to `neighbors` of `query`; to a plane where they do not determine a quadric.
inline Quadric_fit fit_quadric(const Points& points, const Vec3& query,
                               const std::vector<Neighbor>& neighbors)
{
  Quadric_fit fit;
  fit.projection = query;
  if(neighbors.size() < 3)
    return fit;
  Covariance_sum sum;
  for(const Neighbor& neighbor : neighbors)
    sum.add(points[neighbor.index] - query);
  const auto axes = sum.axes();
  const double scale = std::sqrt(neighbors.back().squared_distance);
  const Height_frame frame = {axes.eigenvectors().col(0), axes.eigenvectors().col(1),
                              axes.eigenvectors().col(2), scale};
  fit.normal = frame.normal;
  if(!(scale > tiny_length))
    return fit;

  typedef Height_frame::Vector Coefficients;
  Height_frame::Matrix normal_matrix = Height_frame::Matrix::Zero();
  Coefficients right_side = Coefficients::Zero();
  for(const Neighbor& neighbor : neighbors) {
    const Vec3 d = points[neighbor.index] - query;
    const Coefficients row = frame.monomials(d);
    normal_matrix += row * row.transpose();
    right_side += frame.height(d) / scale * row;
  }
  constexpr std::size_t determined = 8;  // two more than coefficients
  Coefficients c = Coefficients::Zero();
  // a ridge far below the data's weight keeps degenerate neighbourhoods (lines) solvable
  if(neighbors.size() >= determined) {
    normal_matrix.diagonal().array() += 1e-9 * double(neighbors.size());
    c = solve_normal_equations(normal_matrix, right_side);
  }
  if(neighbors.size() < determined || !c.allFinite()) {
    c.setZero();
    c[0] = frame.height(sum.mean()) / scale;
  }
  double squares = 0;
  for(const Neighbor& neighbor : neighbors) {
    const Vec3 d = points[neighbor.index] - query;
    const double left = frame.height(d) / scale - frame.monomials(d).dot(c);
    squares += left * left;
  }
  fit.residual = scale * std::sqrt(squares / double(neighbors.size()));
  fit.projection = query + scale * c[0] * frame.normal;
  fit.normal = (frame.normal - c[1] * frame.u - c[2] * frame.v).normalized();
  return fit;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_QUADRIC_FIT_H
