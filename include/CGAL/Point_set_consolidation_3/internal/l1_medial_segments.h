// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_SEGMENTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_SEGMENTS_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/l1_medial.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

#include <limits>
#include <set>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section V.A: the L1-medial skeletons of all segments of a point set, in one graph.

/// Pairs of segments that touch: neighbours with different labels.
inline std::set<std::pair<std::size_t, std::size_t> > touching_segments(const Points& world,
                                                                        const std::vector<std::size_t>& labels)
{
  constexpr std::size_t contact_neighbors = 6;
  std::set<std::pair<std::size_t, std::size_t> > contacts;
  const Nearest_neighbors tree(world);
  std::vector<Neighbor> near;
  for(std::size_t i = 0; i < world.size(); ++i) {
    tree.find(world[i], contact_neighbors + 1, near);
    for(const Neighbor& neighbor : near)
      if(labels[neighbor.index] != labels[i])
        contacts.insert({(std::min)(labels[i], labels[neighbor.index]),
                         (std::max)(labels[i], labels[neighbor.index])});
  }
  return contacts;
}

/// Joins segments that touch between their nearest nodes, the pair of segments with the nearest nodes first, without
/// cycles of segments.
inline void join_segments(const std::set<std::pair<std::size_t, std::size_t> >& contacts,
                          const std::vector<std::size_t>& segment_of_node, std::size_t count, Skeleton_graph& graph)
{
  struct Bridge {
    double squared_length;
    std::size_t a, b;
  };
  std::vector<Bridge> bridges;
  for(const auto& contact : contacts) {
    Bridge best = {std::numeric_limits<double>::max(), 0, 0};
    for(std::size_t a = 0; a < graph.nodes.size(); ++a)
      if(segment_of_node[a] == contact.first)
        for(std::size_t b = 0; b < graph.nodes.size(); ++b)
          if(segment_of_node[b] == contact.second) {
            const double d2 = (graph.nodes[a].position - graph.nodes[b].position).squaredNorm();
            if(d2 < best.squared_length)
              best = {d2, a, b};
          }
    if(best.a != best.b)
      bridges.push_back(best);
  }
  std::stable_sort(bridges.begin(), bridges.end(), [](const Bridge& x, const Bridge& y) {
    return x.squared_length < y.squared_length;
  });
  Disjoint_sets sets(count);
  for(const Bridge& bridge : bridges)
    if(sets.join(segment_of_node[bridge.a], segment_of_node[bridge.b]))
      graph.add_edge(bridge.a, bridge.b);
}

/// Each segment's skeleton; those of segments that touch are joined.
inline Skeleton_graph l1_medial_skeleton_of_segments(Execution& execution, const Points& world,
                                                     const std::vector<std::size_t>& labels, std::size_t count,
                                                     const L1_medial_parameters& parameters)
{
  constexpr std::size_t least_points = 10;  // a smaller segment is one node
  Skeleton_graph result;
  std::vector<std::size_t> segment_of_node;
  for(std::size_t s = 0; s < count; ++s) {
    std::vector<std::size_t> indices;
    for(std::size_t i = 0; i < world.size(); ++i)
      if(labels[i] == s)
        indices.push_back(i);
    if(indices.empty())
      continue;
    const Points points = selected(world, indices);
    Skeleton_graph part;
    const double share = double(indices.size()) / double(world.size());
    if(indices.size() >= least_points)
      part = l1_medial_skeleton(execution, share, points, parameters);
    else {
      part.nodes.emplace_back();
      for(std::size_t k = 0; k < indices.size(); ++k) {
        part.nodes[0].position += points[k] / double(indices.size());
        part.nodes[0].points.push_back(k);
      }
    }
    const std::size_t offset = result.nodes.size();
    for(Skeleton_node& node : part.nodes) {
      for(std::size_t& p : node.points)
        p = indices[p];
      result.nodes.push_back(std::move(node));
      segment_of_node.push_back(s);
    }
    for(const Skeleton_edge& e : part.edges)
      result.edges.push_back({e[0] + offset, e[1] + offset});
  }
  join_segments(touching_segments(world, labels), segment_of_node, count, result);
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_SEGMENTS_H
