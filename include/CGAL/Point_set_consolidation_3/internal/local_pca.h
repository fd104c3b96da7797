// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LOCAL_PCA_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LOCAL_PCA_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Sums for a principal component analysis of a neighbourhood, relative to a point near it.
class Covariance_sum {
public:
  void add(const Vec3& offset)
  {
    m_sum += offset;
    m_squares += offset * offset.transpose();
    ++m_count;
  }
  std::size_t count() const { return m_count; }
  Vec3 mean() const { return m_count == 0 ? Vec3(Vec3::Zero()) : Vec3(m_sum / double(m_count)); }

  /// Principal axes as columns, eigenvalues in increasing order.
  Eigen::SelfAdjointEigenSolver<Mat3> axes() const
  {
    Mat3 covariance = Mat3::Zero();
    if(m_count > 0) {
      const Vec3 m = mean();
      covariance = m_squares / double(m_count) - m * m.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.compute(covariance);  // iterative: exact also for nearly equal eigenvalues
    return solver;
  }
  Vec3 normal() const { return axes().eigenvectors().col(0); }

private:
  Vec3 m_sum = Vec3::Zero();
  Mat3 m_squares = Mat3::Zero();
  std::size_t m_count = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LOCAL_PCA_H
