// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MULTIGRID_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MULTIGRID_H

#include <Eigen/Sparse>

#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// A symmetric V-cycle over ever finer systems of equations with positive definite matrices: Gauss-Seidel forwards on
/// the way down, backwards on the way up, the coarsest system directly. A preconditioner of conjugate gradients.
class Multigrid {
  static constexpr int sweeps = 2;
  /// Second differences of values that are interpolated linearly vanish but at the coarse nodes, where they are twice
  /// as large: in three dimensions the fine energy of a smooth field is overestimated by two. The matrices of the
  /// levels are not, hence corrections are scaled by the root on their way down and up.
  static constexpr double scale = 1.4142135623730951;

public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Vector = Eigen::VectorXd;

  /// Adds the next finer system; `interpolation` maps values of the one before to it, and is empty for the first.
  void add_level(Matrix matrix, Matrix interpolation)
  {
    if(m_levels.empty())
      m_coarsest.compute(Eigen::SparseMatrix<double>(matrix));
    m_levels.push_back({std::move(matrix), scale * interpolation});
  }

  bool is_solvable() const { return m_coarsest.info() == Eigen::Success; }
  const Matrix& finest() const { return m_levels.back().matrix; }
  Vector cycle(const Vector& right) const { return cycle(m_levels.size() - 1, right); }

private:
  struct Level {
    Matrix matrix, interpolation;
  };

  Vector cycle(std::size_t level, const Vector& right) const
  {
    if(level == 0)
      return m_coarsest.solve(right);
    const Matrix &matrix = m_levels[level].matrix, &interpolation = m_levels[level].interpolation;
    Vector u = Vector::Zero(right.size());
    for(int sweep = 0; sweep < sweeps; ++sweep)
      for(Eigen::Index row = 0; row < matrix.rows(); ++row)
        relax(matrix, right, row, u);
    u += interpolation * cycle(level - 1, interpolation.transpose() * (right - matrix * u));
    for(int sweep = 0; sweep < sweeps; ++sweep)
      for(Eigen::Index row = matrix.rows(); row-- > 0;)
        relax(matrix, right, row, u);
    return u;
  }

  static void relax(const Matrix& matrix, const Vector& right, Eigen::Index row, Vector& u)
  {
    double sum = right[row], diagonal = 0;
    for(Matrix::InnerIterator it(matrix, row); it; ++it)
      if(it.col() == row)
        diagonal = it.value();
      else
        sum -= it.value() * u[it.col()];
    u[row] = sum / diagonal;
  }

  std::vector<Level> m_levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> > m_coarsest;
};

/// As Eigen's solvers want it.
class Multigrid_preconditioner {
public:
  void set(const Multigrid& multigrid) { m_multigrid = &multigrid; }

  template <typename Matrix> Multigrid_preconditioner& compute(const Matrix&) { return *this; }
  template <typename Right> Eigen::VectorXd solve(const Right& right) const { return m_multigrid->cycle(right); }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

private:
  const Multigrid* m_multigrid = nullptr;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MULTIGRID_H
