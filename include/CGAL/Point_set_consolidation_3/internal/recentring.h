// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RECENTRING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RECENTRING_H

#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section III, last step: nodes move to the centre of the points they stand for,
/// and get a radius; and tips that are extended to the end of the shape.

/// Direction of the skeleton at a node; zero at branches and isolated nodes.
inline Vec3 axis_at(const Skeleton_graph& graph, const std::vector<std::vector<std::size_t> >& neighbors,
                    std::size_t i)
{
  const std::vector<std::size_t>& list = neighbors[i];
  Vec3 axis = Vec3::Zero();
  if(list.size() == 1)
    axis = graph.nodes[list[0]].position - graph.nodes[i].position;
  if(list.size() == 2)
    axis = graph.nodes[list[0]].position - graph.nodes[list[1]].position;
  return normalized_or(axis, Vec3::Zero());
}

inline Vec3 across(const Vec3& v, const Vec3& axis) { return v - v.dot(axis) * axis; }

class Recentring {
  /// Mean squared deviation of the normals below which they are those of a plane: no centre.
  static constexpr double least_variation = 0.1;

public:
  /// `normals` may be empty; otherwise outward normals of the points.
  Recentring(const Points& points, const Points& normals) : m_points(points), m_normals(normals) {}

  void apply(Skeleton_graph& graph) const
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
    Skeleton_graph moved = graph;
    for(std::size_t i = 0; i < graph.nodes.size(); ++i)
      if(!graph.nodes[i].points.empty())
        moved.nodes[i].position = mean(graph.nodes[i].points);
    for(std::size_t i = 0; i < graph.nodes.size(); ++i)
      moved.nodes[i].radius =
        median_distance(moved.nodes[i], axis_at(moved, neighbors, i));
    if(!m_normals.empty()) {
      const Skeleton_graph start = moved;
      for(std::size_t i = 0; i < graph.nodes.size(); ++i)
        fit_with_normals(start, neighbors, i, moved.nodes[i]);
    }
    graph = std::move(moved);
  }

private:
  Vec3 mean(const std::vector<std::size_t>& indices) const
  {
    Vec3 sum = Vec3::Zero();
    for(const std::size_t p : indices)
      sum += m_points[p];
    return sum / double(indices.size());
  }

  double median_distance(const Skeleton_node& node, const Vec3& axis) const
  {
    std::vector<double> distances;
    for(const std::size_t p : node.points)
      distances.push_back(across(m_points[p] - node.position, axis).norm());
    return median(std::move(distances));
  }

  /// Centre x and radius r that minimise sum |p_i - r n_i - x|^2 across the axis. It holds on
  /// one-sided data as well, where the mean of the points lies near the visible side.
  void fit_with_normals(const Skeleton_graph& graph,
                        const std::vector<std::vector<std::size_t> >& neighbors, std::size_t i,
                        Skeleton_node& node) const
  {
    std::vector<std::size_t> indices = graph.nodes[i].points;
    for(const std::size_t j : neighbors[i])
      indices.insert(indices.end(), graph.nodes[j].points.begin(), graph.nodes[j].points.end());
    if(indices.empty())
      return;
    const Vec3 axis = axis_at(graph, neighbors, i);
    const Vec3 centre = mean(indices);
    Vec3 mean_normal = Vec3::Zero();
    for(const std::size_t p : indices)
      mean_normal += across(m_normals[p], axis);
    mean_normal /= double(indices.size());
    double product = 0, variation = 0;
    for(const std::size_t p : indices) {
      const Vec3 n = across(m_normals[p], axis) - mean_normal;
      product += n.dot(m_points[p] - centre);
      variation += n.squaredNorm();
    }
    if(variation < least_variation * double(indices.size()) || product <= 0)
      return;
    const double radius = product / variation;
    const Vec3 x = across(centre - radius * mean_normal, axis) + node.position.dot(axis) * axis;
    if(!x.allFinite())
      return;
    node.position = x;
    node.radius = radius;
  }

  const Points& m_points;
  const Points& m_normals;
};

/// Adds a node of radius 0 where the skeleton, continued beyond a tip, meets the end of the points the tip
/// stands for. Radii that decrease linearly towards it are those of a rounded end.
inline void extend_tips(Skeleton_graph& graph, const Points& points)
{
  constexpr double least_length = 0.1;   // of the last edge: shorter is at the end already
  constexpr int direction_edges = 3;     // edges that give the direction: single ones are noisy
  const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
  const std::size_t count = graph.nodes.size();
  for(std::size_t i = 0; i < count; ++i) {
    if(neighbors[i].size() != 1 || graph.nodes[i].points.empty())
      continue;
    std::size_t from = i, back = neighbors[i][0];
    for(int k = 1; k < direction_edges && neighbors[back].size() == 2; ++k) {
      const std::size_t next = neighbors[back][0] == from ? neighbors[back][1] : neighbors[back][0];
      from = back;
      back = next;
    }
    const Vec3 x = graph.nodes[i].position;
    const Vec3 direction = normalized_or(x - graph.nodes[back].position, Vec3::Zero());
    double reach = 0;
    for(const std::size_t p : graph.nodes[i].points)
      reach = (std::max)(reach, (points[p] - x).dot(direction));
    if(reach <= least_length * (graph.nodes[neighbors[i][0]].position - x).norm())
      continue;
    Skeleton_node tip;
    tip.position = x + reach * direction;
    graph.nodes.push_back(tip);
    graph.add_edge(i, graph.nodes.size() - 1);
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RECENTRING_H
