// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SEGMENTATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SEGMENTATION_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/numbered_segments.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Segments by the curve skeleton, which the density of a surface does not know of (2018 paper, section IV:
/// "topological information by segmenting the geometry and constructing curve skeletons"). In: a skeleton with
/// radii whose nodes know their points. Out: a label for every point.
///
/// Chains between joints are cut where the radius changes. A piece goes on beyond a joint if only thinner ones branch
/// off there. Joints go to the incident piece of largest radius, with the nodes of thinner ones inside the
/// joint's ball.

class Skeleton_segmentation {
  /// Ratio of radii from which on two pieces are equally thick, and up to which one branches off the other.
  static constexpr double equally_thick = 0.75, branches_off = 0.6;
  static constexpr double least_radius = 1e-9;      ///< whose logarithm counts
  static constexpr double pointless_weight = 1e-3;  ///< of a node without points, in points
  /// Added to differences of log radii, so that of similar pieces the smaller goes first.
  static constexpr double least_price = 0.1;

public:
  Skeleton_segmentation(const Skeleton_graph& graph, std::size_t number_of_points,
                        const Skeleton_segmentation_parameters& parameters)
    : m_graph(graph), m_parameters(parameters), m_number_of_points(number_of_points)
    , m_neighbors(adjacency(graph)), m_piece(graph.nodes.size(), none)
  {}

  Segmentation run(const Points& points)
  {
    for(const std::vector<std::size_t>& chain : polylines_of(m_graph))
      cut_chain(chain);
    for(std::size_t i = 0; i < m_graph.nodes.size(); ++i)
      if(m_neighbors[i].empty())
        m_piece[i] = m_count++;
    assign_joints();
    merge_small();
    if(m_parameters.count > 0)
      merge_similar();

    std::vector<std::size_t> raw(m_number_of_points, none);
    for(std::size_t i = 0; i < m_graph.nodes.size(); ++i)
      for(const std::size_t p : m_graph.nodes[i].points)
        raw[p] = m_piece[i];
    label_the_rest(points, raw);
    return numbered_by_size(raw);
  }

  /// Piece of every node after `run()`.
  const std::vector<std::size_t>& pieces() const { return m_piece; }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  double radius(std::size_t i) const { return (std::max)(m_graph.nodes[i].radius, least_radius); }
  bool is_joint(std::size_t i) const { return m_neighbors[i].size() > 2; }

  /// Pieces of constant log radius, by dynamic programming over the positions of cuts. Nodes without
  /// points (extended tips) have no radius of their own and follow their neighbour.
  void cut_chain(const std::vector<std::size_t>& chain)
  {
    std::vector<std::size_t> nodes;
    for(const std::size_t i : chain)
      if(!is_joint(i) && m_piece[i] == none && !m_graph.nodes[i].points.empty() &&
         std::find(nodes.begin(), nodes.end(), i) == nodes.end())
        nodes.push_back(i);
    const std::size_t n = nodes.size();
    std::vector<double> sum(n + 1, 0), squares(n + 1, 0);
    for(std::size_t k = 0; k < n; ++k) {
      const double x = std::log(radius(nodes[k]));
      sum[k + 1] = sum[k] + x;
      squares[k + 1] = squares[k] + x * x;
    }
    const auto deviation = [&](std::size_t a, std::size_t b) {  // of nodes [a, b)
      const double s = sum[b] - sum[a];
      return squares[b] - squares[a] - s * s / double(b - a);
    };
    std::vector<double> cost(n + 1, 0);
    std::vector<std::size_t> start(n + 1, 0);
    for(std::size_t b = 1; b <= n; ++b) {
      cost[b] = std::numeric_limits<double>::max();
      for(std::size_t a = 0; a < b; ++a) {
        const double c = cost[a] + deviation(a, b) + m_parameters.penalty;
        if(c < cost[b]) {
          cost[b] = c;
          start[b] = a;
        }
      }
    }
    for(std::size_t b = n; b > 0; b = start[b]) {
      for(std::size_t k = start[b]; k < b; ++k)
        m_piece[nodes[k]] = m_count;
      ++m_count;
    }
    for(const std::size_t i : chain)
      if(m_graph.nodes[i].points.empty() && !is_joint(i) && m_piece[i] == none)
        m_piece[i] = n > 0 ? m_piece[i == chain.front() ? nodes.front() : nodes.back()] : m_count++;
  }

  double mean_radius(std::size_t piece) const
  {
    double total = 0, weight = 0;
    for(std::size_t i = 0; i < m_piece.size(); ++i)
      if(m_piece[i] == piece) {
        const double w = double(m_graph.nodes[i].points.size()) + pointless_weight;
        total += w * radius(i);
        weight += w;
      }
    return weight > 0 ? total / weight : 0;
  }

  /// A joint, largest first, goes to the incident piece of largest radius and takes along the nodes of thinner
  /// pieces inside its ball, which stand for points of the thick part.
  void assign_joints()
  {
    std::vector<std::size_t> joints;
    for(std::size_t i = 0; i < m_piece.size(); ++i)
      if(is_joint(i))
        joints.push_back(i);
    std::sort(joints.begin(), joints.end(), [&](std::size_t a, std::size_t b) {
      return radius(a) != radius(b) ? radius(a) > radius(b) : a < b;
    });
    for(const std::size_t joint : joints) {
      const std::vector<std::size_t> pieces = pieces_at(joint);
      m_piece[joint] = pieces.empty() ? m_count++ : pieces[0];
      if(goes_on(pieces))
        rename(pieces[1], pieces[0]);
      for(const std::size_t j : m_neighbors[joint])
        take_along(joint, joint, j);
    }
  }

  /// Pieces that meet at a joint, the thickest first.
  std::vector<std::size_t> pieces_at(std::size_t joint) const
  {
    std::vector<std::pair<double, std::size_t> > pieces;  // those of equal radius in the order of their numbers
    for(const std::size_t j : m_neighbors[joint])
      if(m_piece[j] != none)
        pieces.emplace_back(-mean_radius(m_piece[j]), m_piece[j]);
    std::sort(pieces.begin(), pieces.end());
    std::vector<std::size_t> result;
    for(const auto& piece : pieces)
      if(result.empty() || result.back() != piece.second)
        result.push_back(piece.second);
    return result;
  }

  /// Whether the two thickest of at least three pieces are one part that the others branch off.
  bool goes_on(const std::vector<std::size_t>& pieces) const
  {
    return pieces.size() > 2 &&
           mean_radius(pieces[1]) > equally_thick * mean_radius(pieces[0]) &&
           mean_radius(pieces[2]) < branches_off * mean_radius(pieces[0]);
  }

  void take_along(std::size_t joint, std::size_t from, std::size_t at)
  {
    std::vector<std::size_t> path;
    const double thinner = equally_thick * mean_radius(m_piece[joint]);
    while(!is_joint(at) && at != joint && mean_radius(m_piece[at]) < thinner &&
          (m_graph.nodes[at].position - m_graph.nodes[joint].position).norm() < radius(joint)) {
      path.push_back(at);
      if(m_neighbors[at].size() < 2)
        return;  // the chain ends in the ball: a limb too short to tell, or a part of its own
      const std::size_t next = m_neighbors[at][0] == from ? m_neighbors[at][1] : m_neighbors[at][0];
      from = at;
      at = next;
    }
    for(const std::size_t i : path)
      m_piece[i] = m_piece[joint];
  }

  std::vector<std::size_t> sizes() const
  {
    std::vector<std::size_t> size(m_count, 0);
    for(std::size_t i = 0; i < m_piece.size(); ++i)
      size[m_piece[i]] += m_graph.nodes[i].points.size();
    return size;
  }

  /// The adjacent piece whose radius is the most similar; `none` if there is none.
  std::size_t most_similar(std::size_t piece, double* difference = nullptr) const
  {
    std::size_t best = none;
    double least = std::numeric_limits<double>::max();
    const double own = mean_radius(piece);
    for(const Skeleton_edge& e : m_graph.edges) {
      const std::size_t a = m_piece[e[0]], b = m_piece[e[1]];
      if(a == b || (a != piece && b != piece))
        continue;
      const std::size_t other = a == piece ? b : a;
      const double d = std::abs(std::log(own / mean_radius(other)));
      if(d < least || (d == least && other < best)) {
        least = d;
        best = other;
      }
    }
    if(difference != nullptr)
      *difference = least;
    return best;
  }
  void rename(std::size_t from, std::size_t into)
  {
    for(std::size_t& piece : m_piece)
      if(piece == from)
        piece = into;
  }

  void merge_small()
  {
    const double least = m_parameters.least_share * double(m_number_of_points);
    std::vector<char> is_alone(m_count, 0);
    while(true) {
      const std::vector<std::size_t> size = sizes();
      std::size_t smallest = none;
      for(std::size_t k = 0; k < size.size(); ++k)
        if(!is_alone[k] && double(size[k]) < least && exists(k) &&
           (smallest == none || size[k] < size[smallest]))
          smallest = k;
      if(smallest == none)
        return;
      const std::size_t into = most_similar(smallest);
      if(into == none)
        is_alone[smallest] = 1;
      else
        rename(smallest, into);
    }
  }
  bool exists(std::size_t piece) const
  {
    return std::find(m_piece.begin(), m_piece.end(), piece) != m_piece.end();
  }

  void merge_similar()
  {
    while(true) {
      std::size_t pieces = 0, from = none, into = none;
      double least = std::numeric_limits<double>::max();
      const std::vector<std::size_t> size = sizes();
      for(std::size_t k = 0; k < m_count; ++k) {
        if(!exists(k))
          continue;
        ++pieces;
        double difference = 0;
        const std::size_t other = most_similar(k, &difference);
        // small ones first: a limb of many points is worth more than a bulge of the same contrast
        const double price = (difference + least_price) * double(size[k] + 1);
        if(other != none && price < least) {
          least = price;
          from = k;
          into = other;
        }
      }
      if(pieces <= m_parameters.count || from == none)
        return;
      rename(from, into);
    }
  }

  /// Points that no node stands for follow their nearest labelled point.
  void label_the_rest(const Points& points, std::vector<std::size_t>& raw) const
  {
    Points labelled;
    std::vector<std::size_t> labels;
    for(std::size_t i = 0; i < raw.size(); ++i)
      if(raw[i] != none) {
        labelled.push_back(points[i]);
        labels.push_back(raw[i]);
      }
    if(labelled.size() == raw.size())
      return;
    const Nearest_neighbors tree(labelled);
    for(std::size_t i = 0; i < raw.size(); ++i)
      if(raw[i] == none)
        raw[i] = labels.empty() ? 0 : labels[tree.nearest(points[i]).index];
  }

  const Skeleton_graph& m_graph;
  Skeleton_segmentation_parameters m_parameters;
  std::size_t m_number_of_points;
  std::vector<std::vector<std::size_t> > m_neighbors;
  std::vector<std::size_t> m_piece;
  std::size_t m_count = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SEGMENTATION_H
