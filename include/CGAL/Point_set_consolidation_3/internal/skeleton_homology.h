// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_HOMOLOGY_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_HOMOLOGY_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Cycles of a complex of curves and triangles, as classes modulo 2: two cycles are the same if triangles lie
/// between them. In: a graph with all edges, those of the triangles too. Out: how many classes are independent, and
/// the shortest cycles that represent them (the greedy basis of Erickson and Whittlesey, 2005).
class Skeleton_homology {
  using Class = std::vector<std::uint64_t>;  ///< a bit for each independent class

public:
  Skeleton_homology(const Skeleton_graph& graph,
                    const std::vector<std::array<std::size_t, 3> >& triangles)
    : m_graph(graph), m_neighbors(graph.nodes.size())
  {
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
      for(int end = 0; end < 2; ++end)
        m_neighbors[graph.edges[e][end]].push_back({graph.edges[e][1 - end], e});
    classify_edges(triangles);
  }

  std::size_t number_of_cycles() const { return m_count; }

  /// Nodes of one cycle for each independent class, the shortest cycle first.
  std::vector<std::vector<std::size_t> > shortest_basis() const
  {
    struct Candidate {
      double length;
      std::size_t root, edge;
      bool operator<(const Candidate& other) const
      {
        return length != other.length ? length < other.length
               : root != other.root   ? root < other.root
                                      : edge < other.edge;
      }
    };
    std::vector<std::vector<std::size_t> > basis;
    if(m_count == 0)
      return basis;
    // every cycle that no triangles fill has an edge of a class other than zero
    std::vector<char> may_be_root(m_graph.nodes.size(), 0);
    for(std::size_t e = 0; e < m_graph.edges.size(); ++e)
      if(!is_zero(m_classes[e]))
        may_be_root[m_graph.edges[e][0]] = 1;
    std::map<Class, Candidate> shortest;  // of each class
    for(std::size_t root = 0; root < m_graph.nodes.size(); ++root) {
      if(!may_be_root[root])
        continue;
      const Paths paths = shortest_paths(root);
      for(std::size_t e = 0; e < m_graph.edges.size(); ++e) {
        const std::size_t a = m_graph.edges[e][0], b = m_graph.edges[e][1];
        if(!(paths.length[a] < infinity))
          continue;
        Class sum = m_classes[e];
        add(sum, paths.classes[a]);
        add(sum, paths.classes[b]);
        if(is_zero(sum))
          continue;
        const Candidate candidate = {paths.length[a] + paths.length[b] + m_graph.edge_length(m_graph.edges[e]),
                                     root, e};
        const auto entry = shortest.emplace(sum, candidate).first;
        entry->second = (std::min)(entry->second, candidate);
      }
    }
    std::vector<std::pair<Candidate, Class> > sorted;
    for(const auto& entry : shortest)
      sorted.emplace_back(entry.second, entry.first);
    std::sort(sorted.begin(), sorted.end());
    std::map<std::size_t, Class> reduced;  // by their lowest bits
    for(auto& entry : sorted) {
      Class& rest = entry.second;
      while(!is_zero(rest) && reduced.count(lowest_bit(rest)))
        add(rest, reduced.at(lowest_bit(rest)));
      if(is_zero(rest))
        continue;
      reduced.emplace(lowest_bit(rest), rest);
      basis.push_back(closed_path(entry.first.root, entry.first.edge));
    }
    return basis;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::max();

  struct Step {
    std::size_t node, edge;
  };
  struct Paths {
    std::vector<double> length;
    std::vector<Class> classes;         ///< sums over the path
    std::vector<std::size_t> previous;  ///< node
  };

  static void add(Class& a, const Class& b)
  {
    for(std::size_t k = 0; k < a.size(); ++k)
      a[k] ^= b[k];
  }
  static bool is_zero(const Class& c)
  {
    return std::all_of(c.begin(), c.end(), [](std::uint64_t word) { return word == 0; });
  }
  static std::size_t lowest_bit(const Class& c)
  {
    std::size_t bit = 0;
    while(!(c[bit / 64] >> (bit % 64) & 1))
      ++bit;
    return bit;
  }

  /// A class for each edge, such that those of a triangle's sides add up to zero, and those of a tree are zero.
  void classify_edges(const std::vector<std::array<std::size_t, 3> >& triangles)
  {
    Disjoint_sets sets(m_graph.nodes.size());
    std::vector<char> is_in_tree(m_graph.edges.size(), 0);
    std::map<Skeleton_edge, std::size_t> place;
    for(std::size_t e = 0; e < m_graph.edges.size(); ++e) {
      const Skeleton_edge& edge = m_graph.edges[e];
      place[{(std::min)(edge[0], edge[1]), (std::max)(edge[0], edge[1])}] = e;
      is_in_tree[e] = sets.join(edge[0], edge[1]);
    }
    // columns of sides, reduced until their largest edges differ
    std::map<std::size_t, std::vector<std::size_t> > columns;
    for(const std::array<std::size_t, 3>& t : triangles) {
      std::vector<std::size_t> column;
      for(int k = 0; k < 3; ++k) {
        const std::size_t a = t[k], b = t[(k + 1) % 3];
        const std::size_t e = place.at({(std::min)(a, b), (std::max)(a, b)});
        if(!is_in_tree[e])
          column.push_back(e);
      }
      std::sort(column.begin(), column.end());
      for(auto found = columns.end();
          !column.empty() && (found = columns.find(column.back())) != columns.end();) {
        std::vector<std::size_t> sum;
        std::set_symmetric_difference(column.begin(), column.end(), found->second.begin(),
                                      found->second.end(), std::back_inserter(sum));
        column.swap(sum);
      }
      if(!column.empty())
        columns.emplace(column.back(), std::move(column));
    }
    for(std::size_t e = 0; e < is_in_tree.size(); ++e)
      m_count += !is_in_tree[e] && columns.count(e) == 0;
    const Class zero((m_count + 63) / 64, 0);
    m_classes.assign(m_graph.edges.size(), zero);
    std::size_t next = 0;
    for(std::size_t e = 0; e < is_in_tree.size(); ++e) {
      if(is_in_tree[e])
        continue;
      const auto column = columns.find(e);
      if(column == columns.end()) {
        m_classes[e][next / 64] |= std::uint64_t(1) << (next % 64);
        ++next;
      }
      else
        for(const std::size_t other : column->second)  // smaller ones, which have their classes
          if(other != e)
            add(m_classes[e], m_classes[other]);
    }
  }

  Paths shortest_paths(std::size_t root) const
  {
    const std::size_t n = m_graph.nodes.size();
    Paths paths = {std::vector<double>(n, infinity), std::vector<Class>(n, Class((m_count + 63) / 64, 0)),
                   std::vector<std::size_t>(n, root)};
    paths.length[root] = 0;
    std::set<std::pair<double, std::size_t> > front = {{0., root}};
    while(!front.empty()) {
      const std::size_t node = front.begin()->second;
      front.erase(front.begin());
      for(const Step& step : m_neighbors[node]) {
        const double length = paths.length[node] + m_graph.edge_length(m_graph.edges[step.edge]);
        if(!(length < paths.length[step.node]))
          continue;
        front.erase({paths.length[step.node], step.node});
        paths.length[step.node] = length;
        paths.previous[step.node] = node;
        paths.classes[step.node] = paths.classes[node];
        add(paths.classes[step.node], m_classes[step.edge]);
        front.insert({length, step.node});
      }
    }
    return paths;
  }

  /// The edge and the paths from its ends to where they meet.
  std::vector<std::size_t> closed_path(std::size_t root, std::size_t edge) const
  {
    const Paths paths = shortest_paths(root);
    std::vector<std::size_t> ways[2];
    for(int end = 0; end < 2; ++end) {
      std::size_t node = m_graph.edges[edge][end];
      for(; node != root; node = paths.previous[node])
        ways[end].push_back(node);
      ways[end].push_back(root);
    }
    while(ways[0].size() > 1 && ways[1].size() > 1 &&
          ways[0][ways[0].size() - 2] == ways[1][ways[1].size() - 2]) {
      ways[0].pop_back();
      ways[1].pop_back();
    }
    ways[0].insert(ways[0].end(), ways[1].rbegin() + 1, ways[1].rend());
    return ways[0];
  }

  const Skeleton_graph& m_graph;
  std::vector<std::vector<Step> > m_neighbors;
  std::vector<Class> m_classes;  ///< of edges
  std::size_t m_count = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_HOMOLOGY_H
