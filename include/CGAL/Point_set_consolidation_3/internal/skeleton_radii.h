// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_RADII_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_RADII_H

#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/recentring.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

#include <Eigen/SparseCholesky>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section V: the distance from skeleton nodes to the surface. In gaps of the
/// data the nearest point says nothing; there radii are interpolated along the skeleton.

/// Fills in the radii with `is_unknown`: the function on the graph that is linear along edges, balanced at every
/// unknown node, and has the known values. Components without a known radius stay as they are.
inline void interpolate_radii(Skeleton_graph& graph, std::vector<char> is_unknown)
{
  const std::vector<std::size_t> component = component_labels(graph);
  std::vector<char> has_known(graph.nodes.size(), 0);
  for(std::size_t i = 0; i < graph.nodes.size(); ++i)
    if(!is_unknown[i])
      has_known[component[i]] = 1;
  std::vector<Eigen::Index> row(graph.nodes.size(), -1);
  Eigen::Index n = 0;
  for(std::size_t i = 0; i < graph.nodes.size(); ++i) {
    is_unknown[i] = is_unknown[i] && has_known[component[i]];
    if(is_unknown[i])
      row[i] = n++;
  }
  if(n == 0)
    return;
  double longest = tiny_length;
  for(const Skeleton_edge& e : graph.edges)
    longest = (std::max)(longest, graph.edge_length(e));
  constexpr double shortest = 1e-6;  // of the longest edge: nodes at the same place
  std::vector<Eigen::Triplet<double> > entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for(const Skeleton_edge& e : graph.edges) {
    const double w = longest / (std::max)(shortest * longest, graph.edge_length(e));
    for(int side = 0; side < 2; ++side) {
      const std::size_t i = e[std::size_t(side)], j = e[std::size_t(1 - side)];
      if(!is_unknown[i])
        continue;
      entries.emplace_back(row[i], row[i], w);
      if(is_unknown[j])
        entries.emplace_back(row[i], row[j], -w);
      else
        right[row[i]] += w * graph.nodes[j].radius;
    }
  }
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> > solver(A);
  const Eigen::VectorXd radii = solver.solve(right);
  if(solver.info() != Eigen::Success || !radii.allFinite())
    return;
  for(std::size_t i = 0; i < graph.nodes.size(); ++i)
    if(is_unknown[i])
      graph.nodes[i].radius = (std::max)(0., radii[row[i]]);
}

/// Whether data surround a node at the distance of the nearest of them: enough points, on all sides, and beside the
/// node rather than before or behind it.
class Trusted_nodes {
  static constexpr double shell = 1.3;             ///< points that count, in distances of the nearest one
  static constexpr std::size_t least_points = 6;
  static constexpr double largest_offset = 0.5;    ///< length of the mean direction; 0: on all sides
  static constexpr double largest_slope = 0.75;    ///< mean absolute cosine to the axis; 0: beside

public:
  explicit Trusted_nodes(const Points& points) : m_points(points), m_tree(points)
  {
  }

  double distance(const Vec3& x) const { return std::sqrt(m_tree.nearest(x).squared_distance); }

  bool operator()(const Vec3& x, const Vec3& axis) const
  {
    const double limit = shell * distance(x);
    Vec3 sum = Vec3::Zero();
    double slope = 0;
    std::size_t count = 0;
    std::vector<Neighbor> found;
    for(std::size_t k = 64;; k *= 2) {
      m_tree.find(x, k, found);
      if(found.size() < k || found.back().squared_distance > limit * limit)
        break;
    }
    for(const Neighbor& neighbor : found) {
      if(neighbor.squared_distance > limit * limit)
        break;
      const Vec3 direction = normalized_or(m_points[neighbor.index] - x, Vec3::Zero());
      sum += direction;
      slope += std::abs(direction.dot(axis));
      ++count;
    }
    return count >= least_points && sum.norm() < largest_offset * double(count) &&
           slope < largest_slope * double(count);
  }

private:
  const Points& m_points;
  Nearest_neighbors m_tree;
};

/// Estimates the radii that are not given (not positive). A tip of radius 0 is one, at the surface, if there are given
/// radii at all.
inline void complete_radii(Skeleton_graph& graph, const Points& points)
{
  const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
  bool has_given = false;
  for(const Skeleton_node& node : graph.nodes)
    has_given = has_given || node.radius > 0;
  std::vector<char> is_unknown(graph.nodes.size(), 0);
  const Trusted_nodes trusted(points);
  for(std::size_t i = 0; i < graph.nodes.size(); ++i) {
    Skeleton_node& node = graph.nodes[i];
    if(node.radius > 0 || (has_given && neighbors[i].size() == 1))
      continue;
    node.radius = trusted.distance(node.position);
    is_unknown[i] = !trusted(node.position, axis_at(graph, neighbors, i));
  }
  interpolate_radii(graph, is_unknown);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_RADII_H
