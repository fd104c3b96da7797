// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_CONTRACTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_CONTRACTION_H

#include <CGAL/Point_set_consolidation_3/internal/laplacian_weights.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section III.A: points are contracted to a thin set around the curve
/// skeleton by solving equation (1) with growing weights. In: distinct points whose longest box side is
/// `contraction_side` (the initial weight has the unit 1 / length, so that the method is not invariant to
/// scale by itself), and their rings. Out: the contracted points, one for each point.

constexpr double contraction_side = 1.6;

/// The coordinates in which points of that box are contracted.
inline Frame contraction_frame(const Bounding_box& box)
{
  const double side = box.sides().maxCoeff();
  return {box.centre(), side > 0 ? side / contraction_side : 1};
}

class Laplacian_contraction {
  static constexpr double default_weight = 0.2;  ///< W_L^0 times the mean extent
  static constexpr double largest_contraction = 2048, largest_attraction = 1e4;
  static constexpr double least_extent = 1e-6 * contraction_side;
  static constexpr double largest_growth = 1.2;  ///< of a side of the box; more is an unstable system
  static constexpr std::size_t least_iterations = 2;

  using Sparse = Eigen::SparseMatrix<double>;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

public:
  Laplacian_contraction(const Execution& execution, const Points& points, const Tangent_rings& rings,
                        const Contraction_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_rings(rings)
    , m_laplacian(rings, parameters.weights), m_points(points), m_box(bounding_box(points).sides())
  {
    m_initial_extents = extents(points, Extent::least);
    double sum = 0;
    for(const double s : m_initial_extents)
      sum += s;
    m_initial_sum = (std::max)(sum, tiny_length);
    m_attraction.assign(points.size(), parameters.attraction_weight);
    const std::vector<double> ring_means = extents(points, Extent::mean);
    double mean_extent = 0;
    for(const double s : ring_means)
      mean_extent += s;
    mean_extent /= double((std::max)(std::size_t(1), points.size()));
    m_contraction = parameters.contraction_weight * default_weight / (std::max)(mean_extent, least_extent);
    m_initial_contraction = m_contraction;
  }

  const Points& points() const { return m_points; }
  std::size_t number_of_iterations() const { return m_iterations; }
  /// W_L^0
  double initial_contraction_weight() const { return m_initial_contraction; }

  /// One iteration. Returns whether another one makes sense; if not, the points may be those of
  /// the previous iteration.
  bool contract_geometry()
  {
    if(m_converged || m_rings.triangles.empty() || m_iterations >= m_parameters.max_iterations)
      return !(m_converged = true);
    Points next = solve();
    if(next.empty() || has_grown(next))
      return !(m_converged = true);
    const std::vector<double> s = extents(next, Extent::least);
    double sum = 0;
    for(const double value : s)
      sum += value;
    const double ratio = sum / m_initial_sum;
    if(m_iterations >= least_iterations && m_ratio - ratio < m_parameters.threshold)
      return !(m_converged = true);
    ++m_iterations;
    m_ratio = ratio;
    m_points.swap(next);
    m_contraction = (std::min)(largest_contraction, m_parameters.contraction_factor * m_contraction);
    for(std::size_t i = 0; i < s.size(); ++i)
      m_attraction[i] =
        (std::min)(largest_attraction, m_parameters.attraction_weight * m_initial_extents[i] / s[i]);
    return m_iterations < m_parameters.max_iterations;
  }

private:
  enum class Extent { least, mean };

  /// Extent S_i of a ring: the distance to its nearest neighbour (attraction weights, convergence) or the mean
  /// distance (initial contraction weight).
  std::vector<double> extents(const Points& points, Extent kind) const
  {
    std::vector<double> result(points.size(), least_extent);
    parallel_for(m_execution, points.size(), [&](std::size_t i) {
      const std::size_t begin = m_rings.first[i], end = m_rings.first[i + 1];
      if(begin == end)
        return;
      double least = std::numeric_limits<double>::max(), sum = 0;
      for(std::size_t slot = begin; slot < end; ++slot) {
        const double d = (points[m_rings.neighbors[slot]] - points[i]).norm();
        least = (std::min)(least, d);
        sum += d;
      }
      const double extent = kind == Extent::least ? least : sum / double(end - begin);
      result[i] = (std::max)(least_extent, extent);
    });
    return result;
  }

  bool has_grown(const Points& points) const
  {
    // a side of a flat sheet is nearly 0 and may vary
    constexpr double flat = 1e-3 * contraction_side;
    const Vec3 sides = bounding_box(points).sides();
    for(int axis = 0; axis < 3; ++axis)
      if(sides[axis] > largest_growth * (std::max)(m_box[axis], flat))
        return true;
    return false;
  }

  /// Equation (1) in the least squares sense: (W_L^2 L^T L + W_H^2) P' = W_H^2 P.
  /// A direct solver: the squared condition number makes iterative ones a hundred times slower. The result
  /// is empty if the system cannot be solved.
  Points solve()
  {
    m_laplacian.update(m_execution, m_points);
    const std::size_t n = m_points.size();
    Sparse L;  // transposed: its columns are the rows of the Laplacian
    L.resize(Eigen::Index(n), Eigen::Index(n));
    L.reserve(Eigen::Index(m_rings.neighbors.size() + n));
    for(std::size_t i = 0; i < n; ++i) {
      L.startVec(Eigen::Index(i));
      bool diagonal_is_set = false;
      const auto set_diagonal = [&] {
        L.insertBack(Eigen::Index(i), Eigen::Index(i)) = m_contraction * m_laplacian.diagonal(i);
        diagonal_is_set = true;
      };
      for(std::size_t slot = m_rings.first[i]; slot < m_rings.first[i + 1]; ++slot) {
        const Index j = m_rings.neighbors[slot];
        if(!diagonal_is_set && j > i)
          set_diagonal();
        L.insertBack(Eigen::Index(j), Eigen::Index(i)) = m_contraction * m_laplacian.weight(slot);
      }
      if(!diagonal_is_set)
        set_diagonal();
    }
    L.finalize();
    Sparse A = L * Sparse(L.transpose());
    Columns b(Eigen::Index(n), 3);
    for(std::size_t i = 0; i < n; ++i) {
      const double h2 = m_attraction[i] * m_attraction[i];
      A.coeffRef(Eigen::Index(i), Eigen::Index(i)) += h2;
      b.row(Eigen::Index(i)) = h2 * m_points[i].transpose();
    }
    if(m_iterations == 0)
      m_solver.analyzePattern(A);
    m_solver.factorize(A);
    if(m_solver.info() != Eigen::Success)
      return Points();
    const Columns x = m_solver.solve(b);
    if(!x.allFinite())
      return Points();
    Points result(n);
    for(std::size_t i = 0; i < n; ++i)
      result[i] = x.row(Eigen::Index(i)).transpose();
    return result;
  }

  const Execution& m_execution;
  Contraction_parameters m_parameters;
  const Tangent_rings& m_rings;
  Ring_laplacian m_laplacian;
  Eigen::SimplicialLDLT<Sparse> m_solver;
  Points m_points;
  Vec3 m_box;
  std::vector<double> m_initial_extents, m_attraction;
  double m_initial_sum = 1;
  double m_ratio = 1;  ///< sum S^t / sum S^0
  double m_contraction = 1, m_initial_contraction = 1;
  std::size_t m_iterations = 0;
  bool m_converged = false;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_CONTRACTION_H
