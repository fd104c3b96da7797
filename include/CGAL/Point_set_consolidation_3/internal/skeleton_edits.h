// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_EDITS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_EDITS_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_radii.h>

#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section V and figure 14: a user repairs the topology, the places and the radii of a
/// skeleton. Nodes keep their numbers while they are edited, new ones get the next; `result()` closes the gaps.
class Skeleton_editor {
public:
  explicit Skeleton_editor(Skeleton_graph graph)
    : m_graph(std::move(graph)), m_is_alive(m_graph.nodes.size(), 1)
  {
  }

  Skeleton_graph result() const { return subgraph(m_graph, m_is_alive); }

  std::size_t add(const Vec3& position, double radius)
  {
    check(position.allFinite() && std::isfinite(radius) && radius >= 0, "bad position or radius");
    Skeleton_node node;
    node.position = position;
    node.radius = radius;
    m_graph.nodes.push_back(std::move(node));
    m_is_alive.push_back(1);
    return m_graph.nodes.size() - 1;
  }
  void move(std::size_t i, const Vec3& position)
  {
    check(position.allFinite(), "bad position");
    node(i).position = position;
  }
  void set_radius(std::size_t i, double radius)
  {
    check(std::isfinite(radius) && radius >= 0, "bad radius");
    node(i).radius = radius;
  }
  void scale_radii(double factor)
  {
    check(std::isfinite(factor) && factor >= 0, "bad factor");
    for(Skeleton_node& n : m_graph.nodes)
      n.radius *= factor;
  }
  void connect(std::size_t a, std::size_t b)
  {
    check(&node(a) != &node(b), "a vertex cannot be connected to itself");
    m_graph.add_edge(a, b);
  }
  void disconnect(std::size_t a, std::size_t b)
  {
    check(m_graph.has_edge(a, b), "there is no such edge");
    m_graph.edges.erase(std::find(m_graph.edges.begin(), m_graph.edges.end(),
                                  Skeleton_edge{(std::min)(a, b), (std::max)(a, b)}));
  }
  void remove(std::size_t i)
  {
    node(i);
    m_is_alive[i] = 0;
    const auto touches = [&](const Skeleton_edge& e) { return e[0] == i || e[1] == i; };
    m_graph.edges.erase(std::remove_if(m_graph.edges.begin(), m_graph.edges.end(), touches),
                        m_graph.edges.end());
  }

  /// Removes the chain that node i is on, up to the branch nodes at its ends.
  void delete_branch(std::size_t i)
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    node(i);
    check(neighbors[i].size() <= 2, "the vertex is a branch vertex: name one on the branch");
    std::vector<std::size_t> chain(1, i);
    for(std::size_t first : neighbors[i])
      for(std::size_t from = i, at = first; neighbors[at].size() <= 2 && at != i;) {
        if(std::find(chain.begin(), chain.end(), at) != chain.end())
          break;  // a closed chain, met from its other end
        chain.push_back(at);
        if(neighbors[at].size() == 1)
          break;
        const std::size_t next = neighbors[at][0] == from ? neighbors[at][1] : neighbors[at][0];
        from = at;
        at = next;
      }
    for(const std::size_t j : chain)
      remove(j);
  }

  /// Opens the shortest cycle through node i: removes the chain that the node is on or, if it is a branch node,
  /// the longest edge of the cycle.
  void delete_cycle(std::size_t i)
  {
    const std::vector<std::size_t> cycle = shortest_cycle(i);
    if(adjacency(m_graph)[i].size() == 2) {
      delete_branch(i);
      return;
    }
    std::size_t longest = 0;
    double length = -1;
    for(std::size_t k = 0; k < cycle.size(); ++k) {
      const double l = (node(cycle[k]).position - node(cycle[(k + 1) % cycle.size()]).position).norm();
      if(l > length) {
        length = l;
        longest = k;
      }
    }
    disconnect(cycle[longest], cycle[(longest + 1) % cycle.size()]);
  }

  /// Merges the shortest cycle through node i into that node, at the middle of the cycle.
  void collapse_cycle(std::size_t i)
  {
    const std::vector<std::size_t> cycle = shortest_cycle(i);
    Vec3 centre = Vec3::Zero();
    double radius = 0;
    for(const std::size_t j : cycle) {
      centre += node(j).position;
      radius = (std::max)(radius, node(j).radius);
    }
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    for(const std::size_t j : cycle) {
      if(j == i)
        continue;
      node(i).points.insert(node(i).points.end(), node(j).points.begin(), node(j).points.end());
      remove(j);
      for(const std::size_t k : neighbors[j])
        if(m_is_alive[k] && k != i)
          m_graph.add_edge(i, k);
    }
    std::sort(node(i).points.begin(), node(i).points.end());
    node(i).position = centre / double(cycle.size());
    node(i).radius = radius;
  }

  /// Removes branches that end in a tip and are shorter than `length`, the shortest first.
  void prune_spurs(double length)
  {
    check(length >= 0, "bad length");
    while(true) {
      const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
      double shortest = length;
      std::size_t tip = m_graph.nodes.size();
      for(const std::vector<std::size_t>& chain : polylines_of(m_graph)) {
        const std::size_t a = neighbors[chain.front()].size(), b = neighbors[chain.back()].size();
        if(!((a == 1 && b > 2) || (b == 1 && a > 2)))
          continue;
        double sum = 0;
        for(std::size_t k = 1; k < chain.size(); ++k)
          sum += (m_graph.nodes[chain[k]].position - m_graph.nodes[chain[k - 1]].position).norm();
        if(sum < shortest) {
          shortest = sum;
          tip = a == 1 ? chain.front() : chain.back();
        }
      }
      if(tip == m_graph.nodes.size())
        return;
      delete_branch(tip);
    }
  }

  /// Continues tips with a radius by that length, to a new node of radius 0.
  void extend_tips()
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    for(std::size_t i = 0; i < neighbors.size(); ++i)
      if(m_is_alive[i] && neighbors[i].size() == 1 && m_graph.nodes[i].radius > 0) {
        const Vec3 direction = -axis_at(m_graph, neighbors, i);
        const std::size_t tip = add(node(i).position + node(i).radius * direction, 0);
        m_graph.add_edge(i, tip);
      }
  }

  /// Radii between a and b, along the shortest path, from those of a and b.
  void interpolate(std::size_t a, std::size_t b)
  {
    const std::vector<std::size_t> path = shortest_path(a, b);
    check(!path.empty(), "the vertices are not connected");
    double length = 0;
    for(std::size_t k = 1; k < path.size(); ++k)
      length += (node(path[k]).position - node(path[k - 1]).position).norm();
    double at = 0;
    for(std::size_t k = 1; k + 1 < path.size(); ++k) {
      at += (node(path[k]).position - node(path[k - 1]).position).norm();
      const double t = length > 0 ? at / length : 0.5;
      node(path[k]).radius = (1 - t) * node(a).radius + t * node(b).radius;
    }
  }
  /// Radii of all nodes without one, other than tips, from those around them.
  void interpolate_unknown()
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    std::vector<char> is_unknown(m_graph.nodes.size(), 0);
    for(std::size_t i = 0; i < neighbors.size(); ++i)
      is_unknown[i] = m_is_alive[i] && !(m_graph.nodes[i].radius > 0) && neighbors[i].size() != 1;
    interpolate_radii(m_graph, is_unknown);
  }

  /// Joins components by edges between their closest nodes, the shortest first, as long as they are not longer
  /// than `longest`. Returns the number of edges.
  std::size_t bridge(double longest)
  {
    check(longest > 0, "bad length");
    std::vector<std::tuple<double, std::size_t, std::size_t> > pairs;
    const std::vector<std::size_t> label = component_labels(m_graph);
    for(std::size_t a = 0; a < label.size(); ++a)
      for(std::size_t b = a + 1; b < label.size(); ++b) {
        const double d = (m_graph.nodes[a].position - m_graph.nodes[b].position).norm();
        if(label[a] != label[b] && m_is_alive[a] && m_is_alive[b] && d <= longest)
          pairs.emplace_back(d, a, b);
      }
    std::sort(pairs.begin(), pairs.end());
    Disjoint_sets sets(label.size());
    std::size_t count = 0;
    for(const auto& pair : pairs)
      if(sets.join(label[std::get<1>(pair)], label[std::get<2>(pair)])) {
        m_graph.add_edge(std::get<1>(pair), std::get<2>(pair));
        ++count;
      }
    return count;
  }

private:
  static void check(bool condition, const char* what)
  {
    if(!condition)
      throw std::invalid_argument(what);
  }

  Skeleton_node& node(std::size_t i)
  {
    check(i < m_graph.nodes.size() && m_is_alive[i], "there is no such vertex");
    return m_graph.nodes[i];
  }

  /// Nodes from a to b with the fewest edges; empty if there is no path. Without the edge a b on demand.
  std::vector<std::size_t> shortest_path(std::size_t a, std::size_t b, bool without_edge = false)
  {
    node(a);
    node(b);
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    const std::size_t none = m_graph.nodes.size();
    std::vector<std::size_t> before(none, none), queue(1, b);
    before[b] = b;
    for(std::size_t k = 0; k < queue.size() && before[a] == none; ++k)
      for(const std::size_t j : neighbors[queue[k]])
        if(before[j] == none && !(without_edge && queue[k] == b && j == a)) {
          before[j] = queue[k];
          queue.push_back(j);
        }
    std::vector<std::size_t> path;
    if(before[a] == none)
      return path;
    for(std::size_t at = a; at != b; at = before[at])
      path.push_back(at);
    path.push_back(b);
    return path;
  }

  std::vector<std::size_t> shortest_cycle(std::size_t i)
  {
    node(i);
    std::vector<std::size_t> best;
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(m_graph);
    for(const std::size_t j : neighbors[i]) {
      std::vector<std::size_t> path = shortest_path(i, j, true);
      if(!path.empty() && (best.empty() || path.size() < best.size()))
        best.swap(path);
    }
    check(!best.empty(), "the vertex is on no cycle");
    return best;
  }

  Skeleton_graph m_graph;
  std::vector<char> m_is_alive;
};

/// Applies the edits of a text, a line each; `#` begins a comment. Vertices are named by their numbers in the file
/// that is edited. Errors are `std::invalid_argument`, the message names the line.
inline void apply_edits(std::istream& in, Skeleton_editor& editor)
{
  std::string line;
  for(std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command;
    if(!(words >> command))
      continue;
    const auto fail = [&](const std::string& what) {
      std::string message = "line " + std::to_string(number);
      message.append(", ").append(command).append(": ").append(what);
      throw std::invalid_argument(message);
    };
    const auto real = [&] {
      double value = 0;
      if(!(words >> value))
        fail("a number is missing");
      return value;
    };
    const auto vertex = [&] {
      long long value = -1;
      if(!(words >> value) || value < 0)
        fail("the number of a vertex is missing");
      return std::size_t(value);
    };
    const auto has_more = [&] { return !(words >> std::ws).eof(); };
    try {
      if(command == "move") {
        const std::size_t i = vertex();
        const double x = real(), y = real(), z = real();
        editor.move(i, Vec3(x, y, z));
      }
      else if(command == "add") {
        const double x = real(), y = real(), z = real();
        editor.add(Vec3(x, y, z), has_more() ? real() : 0);
      }
      else if(command == "connect") {
        const std::size_t a = vertex(), b = vertex();
        editor.connect(a, b);
      }
      else if(command == "disconnect") {
        const std::size_t a = vertex(), b = vertex();
        editor.disconnect(a, b);
      }
      else if(command == "remove") editor.remove(vertex());
      else if(command == "delete_branch") editor.delete_branch(vertex());
      else if(command == "delete_cycle") editor.delete_cycle(vertex());
      else if(command == "collapse_cycle") editor.collapse_cycle(vertex());
      else if(command == "prune") editor.prune_spurs(real());
      else if(command == "extend_tips") editor.extend_tips();
      else if(command == "radius") {
        const std::size_t i = vertex();
        editor.set_radius(i, real());
      }
      else if(command == "scale_radii") editor.scale_radii(real());
      else if(command == "interpolate") {
        if(has_more()) {
          const std::size_t a = vertex(), b = vertex();
          editor.interpolate(a, b);
        }
        else
          editor.interpolate_unknown();
      }
      else if(command == "bridge") editor.bridge(real());
      else
        fail("there is no such edit");
    }
    catch(const std::invalid_argument& error) {
      if(std::string(error.what()).compare(0, 5, "line ") == 0)
        throw;
      fail(error.what());
    }
    if(has_more())
      fail("there is more on the line than expected");
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_EDITS_H
