// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_EQUATIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_EQUATIONS_H

#include <CGAL/Point_set_consolidation_3/internal/multigrid.h>
#include <CGAL/Point_set_consolidation_3/internal/sparse_lattice.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section V, equations (3) to (5): the quadratic energy of a field on the nodes of a
/// lattice, and its minimum. All lengths are in units of the lattice's spacing, the field's values too.
///
/// The smoothness has the mixed second derivatives: without them, or as the square of the Laplacian, the
/// system is nearly singular and the field worse.
class Field_equations {
  /// Offsets of nodes that a node shares a term with: second derivatives along an axis reach two nodes
  /// far, the other terms stay in a cell. In the order of the nodes, so that rows come out sorted.
  static constexpr int reach = 2, width = 2 * reach + 1;
  static constexpr double tolerance = 1e-4;  // a tenth of what is visible of a cell
  static constexpr int max_iterations = 2000;

  template <typename Preconditioner>
  using Conjugate_gradient =
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper, Preconditioner>;

public:
  using Matrix = Multigrid::Matrix;

  /// `values`: of all nodes; those with `is_fixed` are boundary conditions, the others the initial guess.
  Field_equations(const Sparse_lattice& lattice, const std::vector<char>& is_fixed,
                  const std::vector<double>& values)
    : m_lattice(lattice), m_values(values), m_unknown(lattice.size(), Sparse_lattice::none)
  {
    for(std::size_t i = 0; i < lattice.size(); ++i)
      if(!is_fixed[i]) {
        m_unknown[i] = m_nodes.size();
        m_nodes.push_back(i);
      }
    make_pattern();
  }

  std::size_t number_of_iterations() const { return m_iterations; }

  /// w |sum_a c_a u_a - k|^2 over `count` nodes
  void add(double w, const std::size_t* nodes, const double* coefficients, std::size_t count, double k)
  {
    for(std::size_t a = 0; a < count; ++a) {
      const std::size_t row = m_unknown[nodes[a]];
      if(row == Sparse_lattice::none)
        continue;
      const double wa = w * coefficients[a];
      m_right[Eigen::Index(row)] += wa * k;
      for(std::size_t b = 0; b < count; ++b) {
        if(m_unknown[nodes[b]] == Sparse_lattice::none)
          m_right[Eigen::Index(row)] -= wa * coefficients[b] * m_values[nodes[b]];
        else
          entry(row, nodes[a], nodes[b]) += wa * coefficients[b];
      }
    }
  }

  /// Equation (4) with mixed terms, wherever all nodes of a difference exist.
  void add_smoothness(double w)
  {
    static const double second[3] = {1, -2, 1};
    static const double mixed[4] = {1, -1, -1, 1};
    for(std::size_t i = 0; i < m_lattice.size(); ++i) {
      const Lattice_point p = m_lattice.point(i);
      std::size_t forward[3];
      for(std::size_t axis = 0; axis < 3; ++axis) {
        Lattice_point q = p;
        ++q[axis];
        forward[axis] = m_lattice.find(q);
        q[axis] -= 2;
        const std::size_t backward = m_lattice.find(q);
        if(forward[axis] != Sparse_lattice::none && backward != Sparse_lattice::none) {
          const std::size_t nodes[3] = {backward, i, forward[axis]};
          add(w, nodes, second, 3, 0);
        }
      }
      for(std::size_t a = 0; a < 3; ++a)
        for(std::size_t b = a + 1; b < 3; ++b) {
          if(forward[a] == Sparse_lattice::none || forward[b] == Sparse_lattice::none)
            continue;
          Lattice_point q = p;
          ++q[a];
          ++q[b];
          const std::size_t nodes[4] = {i, forward[a], forward[b], m_lattice.find(q)};
          if(nodes[3] != Sparse_lattice::none)
            add(2 * w, nodes, mixed, 4, 0);
        }
    }
  }

  /// w |u(p) - k|^2 with u(p) interpolated in the cell of p; nothing if the cell is not in the domain.
  void add_point(double w, const Vec3& p, double k)
  {
    std::array<std::size_t, 8> nodes;
    double t[3];
    if(!find_cell(p, nodes, t))
      return;
    double coefficients[8];
    for(std::size_t c = 0; c < 8; ++c)
      coefficients[c] = (c & 1 ? t[0] : 1 - t[0]) * (c & 2 ? t[1] : 1 - t[1]) *
                        (c & 4 ? t[2] : 1 - t[2]);
    add(w, nodes.data(), coefficients, 8, k);
  }

  /// w |grad u(p) - g|^2 with u interpolated in the cell of p; nothing if the cell is not in the domain.
  void add_gradient(double w, const Vec3& p, const Vec3& g)
  {
    std::array<std::size_t, 8> nodes;
    double t[3];
    if(!find_cell(p, nodes, t))
      return;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      double coefficients[8];
      for(std::size_t c = 0; c < 8; ++c) {
        coefficients[c] = c >> axis & 1 ? 1 : -1;
        for(std::size_t other = 0; other < 3; ++other)
          if(other != axis)
            coefficients[c] *= c >> other & 1 ? t[other] : 1 - t[other];
      }
      add(w, nodes.data(), coefficients, 8, g[Eigen::Index(axis)]);
    }
  }

  void add_node(double w, std::size_t node, double k)
  {
    const double one = 1;
    add(w, &node, &one, 1, k);
  }

  /// The values of all nodes that minimise the energy; empty if the solver fails. For a good guess.
  std::vector<double> solve()
  {
    Conjugate_gradient<Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int> > > solver;
    return solve(solver, m_matrix);
  }

  /// The same as the next level of `multigrid`, to which the matrix moves: for large systems. `interpolation`: from the
  /// unknowns of the level before.
  std::vector<double> solve(Multigrid& multigrid, Matrix interpolation)
  {
    multigrid.add_level(std::move(m_matrix), std::move(interpolation));
    if(!multigrid.is_solvable())
      return {};
    Conjugate_gradient<Multigrid_preconditioner> solver;
    solver.preconditioner().set(multigrid);
    return solve(solver, multigrid.finest());
  }

private:
  template <typename Solver>
  std::vector<double> solve(Solver& solver, const Matrix& matrix)
  {
    if(m_nodes.empty())
      return m_values;
    Eigen::VectorXd guess(Eigen::Index(m_nodes.size()));
    for(std::size_t row = 0; row < m_nodes.size(); ++row)
      guess[Eigen::Index(row)] = m_values[m_nodes[row]];
    solver.setTolerance(tolerance);
    solver.setMaxIterations(max_iterations);
    solver.compute(matrix);
    if(solver.info() != Eigen::Success)
      return {};
    const Eigen::VectorXd u = solver.solveWithGuess(m_right, guess);
    m_iterations = std::size_t(solver.iterations());
    if(!u.allFinite())
      return {};
    std::vector<double> values = m_values;
    for(std::size_t row = 0; row < m_nodes.size(); ++row)
      values[m_nodes[row]] = u[Eigen::Index(row)];
    return values;
  }

  /// The corners of the cell of p and its place in there.
  bool find_cell(const Vec3& p, std::array<std::size_t, 8>& nodes, double* t) const
  {
    Lattice_point cell;
    for(int axis = 0; axis < 3; ++axis) {
      const double floor = std::floor(p[axis]);
      cell[std::size_t(axis)] = std::int64_t(floor);
      t[axis] = p[axis] - floor;
    }
    return m_lattice.corners(cell, nodes);
  }

  struct Offset {
    int x, y, z;
  };

  static std::vector<Offset> offsets()
  {
    std::vector<Offset> result;
    for(int z = -reach; z <= reach; ++z)
      for(int y = -reach; y <= reach; ++y)
        for(int x = -reach; x <= reach; ++x) {
          const bool in_cell = std::abs(x) < 2 && std::abs(y) < 2 && std::abs(z) < 2;
          const bool on_axis = (x == 0) + (y == 0) + (z == 0) == 2;
          if(in_cell || on_axis)
            result.push_back({x, y, z});
        }
    return result;
  }
  static std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return std::size_t(((z + reach) * width + y + reach) * width + x + reach);
  }

  void make_pattern()
  {
    const std::vector<Offset> all = offsets();
    m_bit_of_slot.fill(0);
    for(std::size_t bit = 0; bit < all.size(); ++bit)
      m_bit_of_slot[slot(all[bit].x, all[bit].y, all[bit].z)] = bit;

    const std::size_t n = m_nodes.size();
    m_right = Eigen::VectorXd::Zero(Eigen::Index(n));
    m_present.assign(n, 0);
    m_matrix.resize(Eigen::Index(n), Eigen::Index(n));
    std::vector<int> columns;
    columns.reserve(n * all.size());
    std::vector<int> first(1, 0);
    for(std::size_t row = 0; row < n; ++row) {
      const Lattice_point p = m_lattice.point(m_nodes[row]);
      for(std::size_t bit = 0; bit < all.size(); ++bit) {
        const std::size_t j = m_lattice.find(p[0] + all[bit].x, p[1] + all[bit].y, p[2] + all[bit].z);
        if(j == Sparse_lattice::none || m_unknown[j] == Sparse_lattice::none)
          continue;
        m_present[row] |= std::uint64_t(1) << bit;
        columns.push_back(int(m_unknown[j]));
      }
      first.push_back(int(columns.size()));
    }
    m_matrix.resizeNonZeros(Eigen::Index(columns.size()));
    std::copy(first.begin(), first.end(), m_matrix.outerIndexPtr());
    std::copy(columns.begin(), columns.end(), m_matrix.innerIndexPtr());
    std::fill(m_matrix.valuePtr(), m_matrix.valuePtr() + columns.size(), 0.);
  }

  double& entry(std::size_t row, std::size_t from, std::size_t to)
  {
    const Lattice_point p = m_lattice.point(from), q = m_lattice.point(to);
    const std::size_t bit = m_bit_of_slot[slot(q[0] - p[0], q[1] - p[1], q[2] - p[2])];
    const std::uint64_t before = m_present[row] & ((std::uint64_t(1) << bit) - 1);
    return m_matrix.valuePtr()[m_matrix.outerIndexPtr()[row] + number_of_bits(before)];
  }
  static int number_of_bits(std::uint64_t bits)
  {
    bits -= bits >> 1 & 0x5555555555555555u;
    bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return int(bits * 0x0101010101010101u >> 56);
  }

  const Sparse_lattice& m_lattice;
  const std::vector<double>& m_values;
  std::vector<std::size_t> m_unknown;  ///< row of a node
  std::vector<std::size_t> m_nodes;    ///< node of a row
  std::vector<std::uint64_t> m_present;
  std::array<std::size_t, std::size_t(width * width * width)> m_bit_of_slot;
  Matrix m_matrix;
  Eigen::VectorXd m_right;
  std::size_t m_iterations = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_EQUATIONS_H
