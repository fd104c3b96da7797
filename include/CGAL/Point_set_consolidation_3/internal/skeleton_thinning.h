// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_THINNING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_THINNING_H

#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

#include <functional>
#include <limits>
#include <set>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section III.B: from a thin point set with local connectivity to a curve
/// skeleton. In: contracted points, and the pairs that are neighbours on the input surface. Out: a graph
/// without triangles whose nodes share the points among them.

struct Thinning_parameters {
  double sampling_radius = 0;             ///< r: distance of the graph's nodes
  std::size_t largest_merged_cycle = 6;   ///< nodes; 0: no cycle is merged
  /// Whether a cycle goes around a hole of the shape, by the mean of each of its nodes' points before they became thin;
  /// empty: estimated from its width.
  std::function<bool(const Points&)> is_handle = {};
};

class Skeleton_thinning {
public:
  /// `connections`: range of pairs of indices into `points`. `surface`: where the points were before they became
  /// thin, or empty; it tells true handles of few nodes.
  template <typename Connections>
  Skeleton_thinning(const Points& points, const Connections& connections,
                    const Thinning_parameters& parameters, Points surface = Points())
    : m_parameters(parameters), m_surface(std::move(surface))
  {
    sample(points);
    m_neighbors.resize(m_positions.size());
    for(const auto& c : connections)
      connect(m_node_of[std::size_t(c[0])], m_node_of[std::size_t(c[1])]);
    m_alive.assign(m_positions.size(), 1);
  }

  /// Collapses edges of triangles, the shortest first, to their midpoints, until no triangle is left. Then
  /// merges short cycles, which come from places where the local triangulations disagree, except around a hole.
  void thin()
  {
    collapse_triangles();
    for(std::vector<std::size_t> cycle = shortest_cycle(); !cycle.empty(); cycle = shortest_cycle()) {
      if(is_handle(cycle)) {
        std::sort(cycle.begin(), cycle.end());
        m_handles.insert(cycle);
        continue;
      }
      Vec3 centroid = Vec3::Zero();
      for(const std::size_t i : cycle)
        centroid += m_positions[i];
      centroid /= double(cycle.size());
      for(std::size_t k = 1; k < cycle.size(); ++k)
        merge(cycle[k], cycle[0]);
      m_positions[cycle[0]] = centroid;
      collapse_triangles();
    }
  }

  /// The graph in its present state. `node_of[i]`: the node of point i.
  Skeleton_graph graph(std::vector<std::size_t>* node_of = nullptr) const
  {
    Skeleton_graph result;
    std::vector<std::size_t> index(m_positions.size(), 0);
    for(std::size_t i = 0; i < m_positions.size(); ++i)
      if(m_alive[i]) {
        index[i] = result.nodes.size();
        result.nodes.emplace_back();
        result.nodes.back().position = m_positions[i];
      }
    for(std::size_t i = 0; i < m_positions.size(); ++i)
      for(const std::size_t j : m_neighbors[i])
        if(i < j)
          result.edges.push_back({index[i], index[j]});
    for(std::size_t p = 0; p < m_node_of.size(); ++p)
      result.nodes[index[m_node_of[p]]].points.push_back(p);
    if(node_of != nullptr) {
      node_of->resize(m_node_of.size());
      for(std::size_t p = 0; p < m_node_of.size(); ++p)
        (*node_of)[p] = index[m_node_of[p]];
    }
    return result;
  }

private:
  /// Farthest point sampling from the first point on; every point belongs to its nearest sample.
  void sample(const Points& points)
  {
    m_node_of.assign(points.size(), 0);
    if(points.empty())
      return;
    std::vector<double> distance(points.size(), std::numeric_limits<double>::max());
    const double limit = m_parameters.sampling_radius * m_parameters.sampling_radius;
    std::size_t farthest = 0;
    do {
      const std::size_t node = m_positions.size();
      const Vec3& position = points[farthest];
      m_positions.push_back(position);
      double largest = -1;
      for(std::size_t i = 0; i < points.size(); ++i) {
        const double d2 = (points[i] - position).squaredNorm();
        if(d2 < distance[i]) {
          distance[i] = d2;
          m_node_of[i] = node;
        }
        if(distance[i] > largest) {
          largest = distance[i];
          farthest = i;
        }
      }
    } while(distance[farthest] > limit);
  }

  void connect(std::size_t a, std::size_t b)
  {
    if(a == b)
      return;
    m_neighbors[a].insert(b);
    m_neighbors[b].insert(a);
  }

  bool is_in_triangle(std::size_t a, std::size_t b) const
  {
    const std::set<std::size_t>& smaller =
      m_neighbors[a].size() < m_neighbors[b].size() ? m_neighbors[a] : m_neighbors[b];
    const std::set<std::size_t>& larger = &smaller == &m_neighbors[a] ? m_neighbors[b] : m_neighbors[a];
    for(const std::size_t c : smaller)
      if(larger.count(c))
        return true;
    return false;
  }

  void collapse_triangles()
  {
    // Edges by length, ties by index. Entries of edges that are gone or longer or shorter by now are passed over.
    struct Entry {
      double length;
      std::size_t a, b;
      bool operator<(const Entry& other) const
      {
        return length != other.length ? length < other.length
                                      : a != other.a ? a < other.a : b < other.b;
      }
    };
    std::set<Entry> queue;
    const auto entry = [&](std::size_t a, std::size_t b) {
      return Entry{(m_positions[a] - m_positions[b]).norm(), (std::min)(a, b), (std::max)(a, b)};
    };
    for(std::size_t i = 0; i < m_neighbors.size(); ++i)
      for(const std::size_t j : m_neighbors[i])
        if(i < j)
          queue.insert(entry(i, j));
    while(!queue.empty()) {
      const Entry shortest = *queue.begin();
      queue.erase(queue.begin());
      // no collapse makes triangles out of edges that were in none, except at the merged node,
      // whose edges enter the queue again
      if(!is_in_triangle(shortest.a, shortest.b))
        continue;
      for(const std::size_t end : {shortest.a, shortest.b})
        for(const std::size_t j : m_neighbors[end])
          queue.erase(entry(end, j));
      m_positions[shortest.a] = 0.5 * (m_positions[shortest.a] + m_positions[shortest.b]);
      merge(shortest.b, shortest.a);
      for(const std::size_t j : m_neighbors[shortest.a]) {
        queue.insert(entry(shortest.a, j));
        // two neighbours of the merged node may be neighbours of each other
        for(const std::size_t k : m_neighbors[j])
          if(m_neighbors[shortest.a].count(k))
            queue.insert(entry(j, k));
      }
    }
  }

  /// Node `from` becomes part of node `into`.
  void merge(std::size_t from, std::size_t into)
  {
    for(const std::size_t j : m_neighbors[from]) {
      m_neighbors[j].erase(from);
      connect(into, j);
    }
    m_neighbors[from].clear();
    m_alive[from] = 0;
    for(std::size_t& node : m_node_of)
      if(node == from)
        node = into;
  }

  /// The cycle of fewest nodes, of those the shortest; empty if it has too many nodes.
  std::vector<std::size_t> shortest_cycle() const
  {
    std::vector<std::size_t> best;
    double best_length = std::numeric_limits<double>::max();
    for(std::size_t a = 0; a < m_neighbors.size(); ++a)
      for(const std::size_t b : m_neighbors[a]) {
        if(b < a)
          continue;
        const std::size_t limit =
          best.empty() ? m_parameters.largest_merged_cycle : best.size();
        std::vector<std::size_t> path = path_without_edge(a, b, limit);
        if(path.empty() || is_known_handle(path))
          continue;
        const double length = closed_length(path);
        if(best.empty() || path.size() < best.size() || length < best_length) {
          best.swap(path);
          best_length = length;
        }
      }
    return best;
  }
  bool is_known_handle(std::vector<std::size_t> cycle) const
  {
    if(m_handles.empty())
      return false;
    std::sort(cycle.begin(), cycle.end());
    return m_handles.count(cycle) > 0;
  }

  /// Whether a cycle goes around a hole of the shape. It is then wider than the tubes that it is made of, and these
  /// have a side towards the hole. A cycle that comes from disagreeing triangulations lies in one tube, of which each
  /// of its strands has the outer side. Over fifteen models the width was 1.2 to 2.4 of the tube for handles and 0.4
  /// to 0.6 for others; but 1.2 to 1.5 for those of views that are misaligned, whose surfaces are double, and with less
  /// than 0.3 of a strand's points on the side of the hole.
  bool is_handle(const std::vector<std::size_t>& cycle) const
  {
    constexpr double surely_wide = 1.6;  // whether or not the side towards the hole was seen
    constexpr double least_inner_share = 0.3;
    constexpr std::size_t telling = 30;      // points that tell sides apart
    if(m_surface.empty())
      return false;
    const std::size_t n = cycle.size();
    std::vector<Points> tubes(n);  // the surface of each node
    std::vector<std::size_t> place(m_positions.size(), n);
    for(std::size_t k = 0; k < n; ++k)
      place[cycle[k]] = k;
    for(std::size_t p = 0; p < m_node_of.size(); ++p)
      if(place[m_node_of[p]] < n)
        tubes[place[m_node_of[p]]].push_back(m_surface[p]);
    Points centres;
    for(const Points& tube : tubes)
      centres.push_back(mean_of(tube));
    if(m_parameters.is_handle)
      return m_parameters.is_handle(centres);

    const Vec3 middle = mean_of(centres);
    Covariance_sum loop;
    double radius = 0, inner_share = 1;
    for(std::size_t k = 0; k < n; ++k) {
      loop.add(centres[k] - centres[0]);
      const Tube_section section(tubes[k], centres[k], centres[(k + 1) % n] - centres[(k + n - 1) % n], middle);
      radius += section.radius / double(n);
      if(tubes[k].size() >= telling)
        inner_share = (std::min)(inner_share, section.inner_share);
    }
    // of a circle, or the smaller half axis of an ellipse
    const double half_width = std::sqrt(2 * (std::max)(0., loop.axes().eigenvalues()[1]));
    return half_width > radius && (half_width > surely_wide * radius || inner_share >= least_inner_share);
  }

  static Vec3 mean_of(const Points& points)
  {
    Vec3 sum = Vec3::Zero();
    for(const Vec3& p : points)
      sum += p;
    return sum / double(points.size());
  }

  /// The surface around a node of a cycle, seen along the cycle.
  struct Tube_section {
    double radius = 0;       ///< mean distance from the axis
    double inner_share = 0;  ///< of the points amid the tube, on the side of the cycle's middle

    Tube_section(const Points& tube, const Vec3& centre, const Vec3& along, const Vec3& middle)
    {
      const Vec3 axis = normalized_or(along, Vec3::Zero());
      const auto across = [&](const Vec3& d) { return Vec3(d - d.dot(axis) * axis); };
      const Vec3 inwards = normalized_or(across(middle - centre), Vec3::Zero()), sideways = axis.cross(inwards);
      double squares = 0;
      for(const Vec3& p : tube) {
        radius += across(p - centre).norm() / double(tube.size());
        squares += std::pow(sideways.dot(p - centre), 2) / double(tube.size());
      }
      std::size_t amid = 0, inner = 0;
      for(const Vec3& p : tube)
        if(std::pow(sideways.dot(p - centre), 2) <= 0.5 * squares) {
          ++amid;
          inner += inwards.dot(p - centre) > 0;
        }
      inner_share = amid > 0 ? double(inner) / double(amid) : 0;
    }
  };

  double closed_length(const std::vector<std::size_t>& cycle) const
  {
    double length = 0;
    for(std::size_t k = 0; k < cycle.size(); ++k)
      length += (m_positions[cycle[k]] - m_positions[cycle[(k + 1) % cycle.size()]]).norm();
    return length;
  }
  /// A shortest path from a to b other than their edge, with at most `limit` nodes; breadth first.
  std::vector<std::size_t> path_without_edge(std::size_t a, std::size_t b, std::size_t limit) const
  {
    std::vector<std::pair<std::size_t, std::size_t> > visited = {{a, 0}};  // node, place of its predecessor
    std::set<std::size_t> seen = {a};
    std::size_t begin = 0;
    for(std::size_t nodes = 2; nodes <= limit; ++nodes) {
      const std::size_t end = visited.size();
      for(; begin < end; ++begin)
        for(const std::size_t j : m_neighbors[visited[begin].first]) {
          if((visited[begin].first == a && j == b) || !seen.insert(j).second)
            continue;
          visited.emplace_back(j, begin);
          if(j == b) {
            std::vector<std::size_t> path = {b};
            for(std::size_t at = begin; at != 0; at = visited[at].second)
              path.push_back(visited[at].first);
            path.push_back(a);
            return path;
          }
        }
    }
    return {};
  }

  Thinning_parameters m_parameters;
  Points m_positions;
  std::vector<std::set<std::size_t> > m_neighbors;
  std::vector<char> m_alive;
  std::vector<std::size_t> m_node_of;
  Points m_surface;
  std::set<std::vector<std::size_t> > m_handles;  ///< cycles that stay, sorted
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_THINNING_H
