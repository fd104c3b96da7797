// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_DENSER_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_DENSER_H

#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <limits>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// For equation (7) of the feature-enhanced surfaces paper: the nearest point of smaller rank, by a tree of boxes whose
/// nodes know their smallest rank.
class Nearest_denser {
  static constexpr std::size_t leaf_size = 16;

public:
  /// `points` in the order of their ranks.
  explicit Nearest_denser(const Points& points) : m_points(points), m_order(all_indices(points.size()))
  {
    if(!points.empty())
      build(0, points.size());
  }

  /// The nearest point of a rank below `rank`; rank must not be 0.
  Neighbor find(std::size_t rank) const
  {
    Neighbor best = {0, std::numeric_limits<double>::max()};
    search(0, rank, best);
    return best;
  }

private:
  struct Node {
    Bounding_box box;
    std::size_t begin, end;
    Index least_rank;
    std::size_t right = 0;  ///< the left child follows its parent; 0: a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end)
  {
    const std::size_t place = m_nodes.size();
    Node node{{}, begin, end, m_order[begin], 0};
    node.box.lower = node.box.upper = m_points[m_order[begin]];
    for(std::size_t k = begin; k < end; ++k) {
      node.box.lower = node.box.lower.cwiseMin(m_points[m_order[k]]);
      node.box.upper = node.box.upper.cwiseMax(m_points[m_order[k]]);
      node.least_rank = (std::min)(node.least_rank, m_order[k]);
    }
    m_nodes.push_back(node);
    if(end - begin > leaf_size) {
      Eigen::Index axis = 0;
      node.box.sides().maxCoeff(&axis);
      const std::size_t middle = begin + (end - begin) / 2;
      std::nth_element(m_order.begin() + std::ptrdiff_t(begin), m_order.begin() + std::ptrdiff_t(middle),
                       m_order.begin() + std::ptrdiff_t(end), [&](Index a, Index b) {
                         const double x = m_points[a][axis], y = m_points[b][axis];
                         return x != y ? x < y : a < b;
                       });
      build(begin, middle);
      m_nodes[place].right = build(middle, end);
    }
    return place;
  }

  static double distance_to_box(const Bounding_box& box, const Vec3& p)
  {
    return (p - p.cwiseMax(box.lower).cwiseMin(box.upper)).squaredNorm();
  }

  void search(std::size_t place, std::size_t rank, Neighbor& best) const
  {
    const Node& node = m_nodes[place];
    const Vec3& query = m_points[rank];
    if(node.least_rank >= rank || distance_to_box(node.box, query) > best.squared_distance)
      return;
    if(node.right == 0) {
      for(std::size_t k = node.begin; k < node.end; ++k) {
        const Index other = m_order[k];
        if(other >= rank)
          continue;
        const double d2 = (m_points[other] - query).squaredNorm();
        if(d2 < best.squared_distance || (d2 == best.squared_distance && other < best.index))
          best = {other, d2};
      }
      return;
    }
    const std::size_t left = place + 1;
    const bool left_first = distance_to_box(m_nodes[left].box, query) <=
                            distance_to_box(m_nodes[node.right].box, query);
    search(left_first ? left : node.right, rank, best);
    search(left_first ? node.right : left, rank, best);
  }

  const Points& m_points;
  std::vector<Index> m_order;
  std::vector<Node> m_nodes;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_DENSER_H
