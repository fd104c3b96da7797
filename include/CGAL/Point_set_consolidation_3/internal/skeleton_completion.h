// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_COMPLETION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_COMPLETION_H

#include <CGAL/Point_set_consolidation_3/internal/skeleton_radii.h>

#include <CGAL/number_type_config.h>

#include <array>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section V.A, "an ensemble of general cylinders around the curve
/// skeleton": rings of points around the skeleton where the data have none, with profiles from the data. In: data and a
/// skeleton with radii, in any unit. Out: the missing points with normals.
///
/// Only between nodes whose radius the data around them confirm: elsewhere centre and radius of
/// an automatic skeleton are guesses, and rings around them do harm.

/// Mean cosine between the normals of the data around a place and the directions from them to it: -1 on the axis of a
/// tube or inside of a part, which face away, 0 in a gap, which they face by their sides.
inline double facing(const Nearest_neighbors& tree, const Points& data, const Points& normals, const Vec3& x)
{
  constexpr std::size_t voters = 6;
  std::vector<Neighbor> near;
  tree.find(x, voters, near);
  double sum = 0;
  for(const Neighbor& neighbor : near)
    sum += normals[neighbor.index].dot(normalized_or(x - data[neighbor.index], Vec3::Zero()));
  return sum / double(near.size());
}

struct Skeleton_completed_points {
  Points points, normals;
  std::vector<std::size_t> edges;  ///< the skeleton edge of each point
};

class Skeleton_completion {
  static constexpr std::size_t profile_bins = 16;
  static constexpr double least_gap = 3;           ///< spacings: a ring point nearer to data is not missing
  static constexpr double least_relative_gap = 0.35;  ///< of the radius, the same
  /// A ring point is inside of the shape, and not missing, if the data around see it so far below their tangent
  /// planes (cosine): beside a gap of the surface the data see it in their planes.
  static constexpr double most_inside = -0.35;
  /// Some minutes of work; outliers far away make skeletons that want more.
  static constexpr double most_points = 1e7;

public:
  /// `normals`: outward ones of the data.
  Skeleton_completion(const Points& data, const Points& normals, double spacing,
                      const Skeleton_graph& graph)
    : m_data(data), m_normals(normals), m_spacing(spacing), m_graph(graph), m_trusted(data)
    , m_tree(data)
  {}

  /// `is_wanted`: edges along which points are wanted; `trusts_all`: for skeletons edited by hand.
  Skeleton_completed_points run(const std::vector<char>& is_wanted, bool trusts_all) const
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    std::vector<char> is_trusted(m_graph.nodes.size(), 1);
    if(!trusts_all)
      for(std::size_t i = 0; i < is_trusted.size(); ++i)
        is_trusted[i] = m_graph.nodes[i].radius > 0 &&
                        m_trusted(m_graph.nodes[i].position, axis_at(m_graph, neighbors, i));
    spread_trust(neighbors, is_trusted);
    std::vector<std::size_t> wanted;
    double number = 0;
    for(std::size_t e = 0; e < m_graph.edges.size(); ++e)
      if(is_wanted[e] && is_trusted[m_graph.edges[e][0]] && is_trusted[m_graph.edges[e][1]]) {
        wanted.push_back(e);
        number += ring_points(e);
      }
    if(!(number <= most_points))
      throw Unusable_input("the skeleton is too large for the spacing of the points: more than "
                                  "ten million points would be tried around it");
    Skeleton_completed_points result;
    for(const std::size_t e : wanted)
      add_rings(e, result);
    return result;
  }

private:
  /// Nodes of a chain between two trusted ones are trusted: their radii are interpolated.
  void spread_trust(const std::vector<std::vector<std::size_t> >& neighbors,
                    std::vector<char>& is_trusted) const
  {
    for(const std::vector<std::size_t>& chain : polylines_of(m_graph)) {
      std::size_t last = chain.size();
      for(std::size_t k = 0; k < chain.size(); ++k) {
        if(!is_trusted[chain[k]])
          continue;
        for(std::size_t j = last + 1; last < chain.size() && j < k; ++j)
          if(neighbors[chain[j]].size() == 2)
            is_trusted[chain[j]] = 1;
        last = k;
      }
    }
  }

  /// Distance of the surface from a node in directions around an axis; directions without data have the
  /// node's radius.
  std::array<double, profile_bins> profile(std::size_t node, const Vec3& u, const Vec3& v) const
  {
    std::array<double, profile_bins> sum{}, weight{};
    const Skeleton_node& n = m_graph.nodes[node];
    for(const std::size_t p : n.points) {
      const Vec3 offset = m_data[p] - n.position;
      const double x = offset.dot(u), y = offset.dot(v);
      const double turn = std::atan2(y, x) / (2 * CGAL_PI) + 1;
      const std::size_t bin = std::size_t(turn * profile_bins) % profile_bins;
      sum[bin] += std::sqrt(x * x + y * y);
      weight[bin] += 1;
    }
    std::array<double, profile_bins> result;
    for(std::size_t k = 0; k < profile_bins; ++k)
      result[k] = weight[k] >= 3 ? sum[k] / weight[k] : n.radius;
    return result;
  }

  bool is_inside(const Vec3& x) const { return facing(m_tree, m_data, m_normals, x) < most_inside; }

  /// The number of points that are tried around an edge.
  double ring_points(std::size_t edge) const
  {
    const Skeleton_node& a = m_graph.nodes[m_graph.edges[edge][0]];
    const Skeleton_node& b = m_graph.nodes[m_graph.edges[edge][1]];
    const double rings = std::ceil((b.position - a.position).norm() / m_spacing);
    return rings * (6 + CGAL_PI * (a.radius + b.radius) / m_spacing);
  }

  void add_rings(std::size_t edge, Skeleton_completed_points& result) const
  {
    const Skeleton_node& a = m_graph.nodes[m_graph.edges[edge][0]];
    const Skeleton_node& b = m_graph.nodes[m_graph.edges[edge][1]];
    const Vec3 along = b.position - a.position;
    const double length = along.norm();
    if(!(length > tiny_length * m_spacing))
      return;
    const Vec3 axis = along / length, u = axis.unitOrthogonal(), v = axis.cross(u);
    const std::array<double, profile_bins> start = profile(m_graph.edges[edge][0], u, v);
    const std::array<double, profile_bins> end = profile(m_graph.edges[edge][1], u, v);
    const std::size_t rings = std::size_t(std::ceil(length / m_spacing));
    for(std::size_t ring = 0; ring < rings; ++ring) {
      const double t = (double(ring) + 0.5) / double(rings);
      const double radius = a.radius + t * (b.radius - a.radius);
      const std::size_t count =
        (std::max)(std::size_t(6), std::size_t(std::ceil(2 * CGAL_PI * radius / m_spacing)));
      const double gap = (std::max)(least_gap * m_spacing, least_relative_gap * radius);
      for(std::size_t k = 0; k < count; ++k) {
        // every second ring is turned by half a step
        const double turn = (double(k) + 0.5 * double(ring % 2)) / double(count);
        const double place = turn * profile_bins + profile_bins - 0.5;
        const std::size_t bin = std::size_t(place) % profile_bins;
        const std::size_t next = (bin + 1) % profile_bins;
        const double f = place - std::floor(place);
        const double r = (1 - t) * ((1 - f) * start[bin] + f * start[next]) +
                         t * ((1 - f) * end[bin] + f * end[next]);
        const Vec3 n = std::cos(2 * CGAL_PI * turn) * u + std::sin(2 * CGAL_PI * turn) * v;
        const Vec3 x = a.position + t * along + r * n;
        if(m_trusted.distance(x) < gap || is_inside(x))
          continue;
        result.points.push_back(x);
        result.normals.push_back(normalized_or(n, n));  // lengths near the least number are rough
        result.edges.push_back(edge);
      }
    }
  }

  const Points& m_data;
  const Points& m_normals;
  double m_spacing;
  const Skeleton_graph& m_graph;
  Trusted_nodes m_trusted;
  Nearest_neighbors m_tree;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_COMPLETION_H
