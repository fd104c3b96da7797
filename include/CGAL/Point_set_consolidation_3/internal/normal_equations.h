// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_EQUATIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_EQUATIONS_H


#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The solution x of the normal equations `A x = b` of a least-squares fit with up to six unknowns; not finite or
/// arbitrary where A is singular. One factorisation for all sizes: each size of its own costs every user of
/// the package seconds of compilation.
template <int Unknowns, int Columns>
Eigen::Matrix<double, Unknowns, Columns> solve_normal_equations(const Eigen::Matrix<double, Unknowns, Unknowns>& A,
                                                                const Eigen::Matrix<double, Unknowns, Columns>& b)
{
  static_assert(Unknowns <= 6 && Columns <= 6, "fits have at most six unknowns");
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;  // not on the heap
  const Eigen::LDLT<Matrix> factors{Matrix(A)};
  const Matrix x = factors.solve(Matrix(b));
  return x;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NORMAL_EQUATIONS_H
