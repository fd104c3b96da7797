// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_GRAPH_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_GRAPH_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// A curve skeleton as the core passes it around; its public face is `Curve_skeleton_3`.

struct Skeleton_node {
  Vec3 position = Vec3::Zero();
  double radius = 0;
  std::vector<std::size_t> points;  ///< indices of the input points that the node stands for
};

using Skeleton_edge = std::array<std::size_t, 2>;

/// Edges are simple: no loops, none twice. `add_edge()` keeps it so.
struct Skeleton_graph {
  std::vector<Skeleton_node> nodes;
  std::vector<Skeleton_edge> edges;

  bool has_edge(std::size_t a, std::size_t b) const
  {
    for(const Skeleton_edge& e : edges)
      if((e[0] == a && e[1] == b) || (e[0] == b && e[1] == a))
        return true;
    return false;
  }
  bool add_edge(std::size_t a, std::size_t b)
  {
    if(a == b || has_edge(a, b))
      return false;
    edges.push_back({(std::min)(a, b), (std::max)(a, b)});
    return true;
  }
  double edge_length(const Skeleton_edge& e) const
  {
    return (nodes[e[0]].position - nodes[e[1]].position).norm();
  }
};

/// Neighbours of every node, in increasing order.
inline std::vector<std::vector<std::size_t> > adjacency(const Skeleton_graph& graph)
{
  std::vector<std::vector<std::size_t> > neighbors(graph.nodes.size());
  for(const Skeleton_edge& e : graph.edges) {
    neighbors[e[0]].push_back(e[1]);
    neighbors[e[1]].push_back(e[0]);
  }
  for(std::vector<std::size_t>& list : neighbors)
    std::sort(list.begin(), list.end());
  return neighbors;
}

/// Component of every node, numbered in the order of their first nodes.
inline std::vector<std::size_t> component_labels(const Skeleton_graph& graph,
                                                 std::size_t* count = nullptr)
{
  Disjoint_sets sets(graph.nodes.size());
  for(const Skeleton_edge& e : graph.edges)
    sets.join(e[0], e[1]);
  std::vector<std::size_t> labels(graph.nodes.size());
  std::size_t next = 0;
  for(std::size_t i = 0; i < labels.size(); ++i) {
    const std::size_t representative = sets.find(i);
    labels[i] = representative == i ? next++ : labels[representative];
  }
  if(count != nullptr)
    *count = next;
  return labels;
}

inline std::size_t number_of_components(const Skeleton_graph& graph)
{
  std::size_t count = 0;
  component_labels(graph, &count);
  return count;
}

/// First Betti number: independent cycles, the genus of a surface that the skeleton describes.
inline std::size_t number_of_cycles(const Skeleton_graph& graph)
{
  return graph.edges.size() + number_of_components(graph) - graph.nodes.size();
}

/// The graph of the nodes with `keep[i]`, in their order, with the edges among them.
/// `new_index[i]`: place of node i in the result, `nodes.size()` of the given graph if it is gone.
inline Skeleton_graph subgraph(const Skeleton_graph& graph, const std::vector<char>& keep,
                               std::vector<std::size_t>* new_index = nullptr)
{
  const std::size_t gone = graph.nodes.size();
  std::vector<std::size_t> index(graph.nodes.size(), gone);
  Skeleton_graph result;
  for(std::size_t i = 0; i < graph.nodes.size(); ++i)
    if(keep[i]) {
      index[i] = result.nodes.size();
      result.nodes.push_back(graph.nodes[i]);
    }
  for(const Skeleton_edge& e : graph.edges)
    if(index[e[0]] != gone && index[e[1]] != gone)
      result.edges.push_back({index[e[0]], index[e[1]]});
  if(new_index != nullptr)
    new_index->swap(index);
  return result;
}

/// The same graph in the frame's world coordinates.
inline Skeleton_graph to_world(Skeleton_graph graph, const Frame& frame)
{
  for(Skeleton_node& node : graph.nodes) {
    node.position = frame.to_world(node.position);
    node.radius *= frame.unit;
  }
  return graph;
}

/// The same graph in the frame's local coordinates.
inline Skeleton_graph to_local(Skeleton_graph graph, const Frame& frame)
{
  for(Skeleton_node& node : graph.nodes) {
    node.position = frame.to_local(node.position);
    node.radius /= frame.unit;
  }
  return graph;
}

/// The chains between branch nodes, tips and isolated nodes, and the closed chains (first node repeated).
/// Every edge is in exactly one chain.
inline std::vector<std::vector<std::size_t> > polylines_of(const Skeleton_graph& graph)
{
  const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
  std::vector<std::vector<char> > used(neighbors.size());
  for(std::size_t i = 0; i < neighbors.size(); ++i)
    used[i].assign(neighbors[i].size(), 0);
  const auto use = [&](std::size_t a, std::size_t b) {
    used[a][std::size_t(std::lower_bound(neighbors[a].begin(), neighbors[a].end(), b) -
                        neighbors[a].begin())] = 1;
  };

  std::vector<std::vector<std::size_t> > chains;
  const auto follow = [&](std::size_t start, std::size_t slot) {
    std::vector<std::size_t> chain(1, start);
    std::size_t from = start, to = neighbors[start][slot];
    while(true) {
      use(from, to);
      use(to, from);
      chain.push_back(to);
      if(to == start || neighbors[to].size() != 2)
        break;
      const std::size_t next = neighbors[to][0] == from ? neighbors[to][1] : neighbors[to][0];
      from = to;
      to = next;
    }
    chains.push_back(std::move(chain));
  };
  for(int pass = 0; pass < 2; ++pass)  // first from the ends of chains, then what is left: closed chains
    for(std::size_t i = 0; i < neighbors.size(); ++i)
      if(pass == 1 || neighbors[i].size() != 2)
        for(std::size_t slot = 0; slot < neighbors[i].size(); ++slot)
          if(!used[i][slot])
            follow(i, slot);
  return chains;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_GRAPH_H
