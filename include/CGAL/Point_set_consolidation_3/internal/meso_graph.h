// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_H

#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_curves.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph_types.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_labels.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/recentring.h>
#include <CGAL/Point_set_consolidation_3/internal/sheet_triangles.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_homology.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_thinning.h>
#include <CGAL/Point_set_consolidation_3/internal/spanning_disc.h>

#include <map>
#include <set>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The meso-skeleton as an object: curves, sheets, and where they meet. Lengths in units of the spacing r of S.

/// Distinct sides of triangles and edges, sorted.
inline std::vector<Skeleton_edge> all_edges(const std::vector<Skeleton_edge>& edges,
                                            const std::vector<Sheet_triangle>& triangles)
{
  std::set<Skeleton_edge> all(edges.begin(), edges.end());
  for(const Sheet_triangle& t : triangles) {
    all.insert({t[0], t[1]});
    all.insert({t[0], t[2]});
    all.insert({t[1], t[2]});
  }
  return std::vector<Skeleton_edge>(all.begin(), all.end());
}

class Meso_graph_builder {
  /// Nodes stand for some deep points each, so that their means are smooth.
  static constexpr double least_node_distance = 2;

public:
  Meso_graph_builder(const Execution& execution, const Meso_shape& shape,
                     const Meso_graph_parameters& parameters)
    : m_execution(execution), m_shape(shape), m_disc(shape.outer, shape.normals)
    , m_parameters(parameters)
    , m_node_distance((std::max)(least_node_distance,
                                 parameters.sampling_radius * bounding_box(shape.outer).diagonal()))
  {
  }

  Meso_graph run()
  {
    const std::vector<Ring_edge> links = surface_links(m_execution, m_shape);
    std::vector<char> is_sheet(m_shape.outer.size(), 0);
    m_result.node_of.resize(is_sheet.size());
    if(m_parameters.curves_only)
      add_contracted_curves(links);
    else {
      is_sheet = Sheet_finder(m_execution, m_shape, links).find();
      add_curves(links, is_sheet);
      add_sheets(links, is_sheet);
      join_parts(links);
      if(m_parameters.largest_merged_cycle > 0)
        fill_false_cycles();
    }
    set_radii();
    set_labels(is_sheet);
    if(m_parameters.extend_tips)
      add_tips();
    return std::move(m_result);
  }

private:
  /// Indices of the deep points with the given flag, and their places among them.
  static std::vector<std::size_t> members(const std::vector<char>& flags, char value,
                                          std::vector<std::size_t>& place)
  {
    std::vector<std::size_t> indices;
    place.assign(flags.size(), 0);
    for(std::size_t i = 0; i < flags.size(); ++i)
      if(flags[i] == value) {
        place[i] = indices.size();
        indices.push_back(i);
      }
    return indices;
  }
  static std::vector<Ring_edge> links_among(const std::vector<Ring_edge>& links,
                                            const std::vector<char>& flags, char value,
                                            const std::vector<std::size_t>& place)
  {
    std::vector<Ring_edge> result;
    for(const Ring_edge& e : links)
      if(flags[e[0]] == value && flags[e[1]] == value)
        result.push_back({Index(place[e[0]]), Index(place[e[1]])});
    return result;
  }

  /// Nodes, each with the mean of its deep points' inner points as position.
  void append(const Skeleton_graph& part, const std::vector<std::size_t>& indices, const Points& inner,
              bool is_sheet)
  {
    const std::size_t first = m_result.graph.nodes.size();
    for(const Skeleton_node& node : part.nodes) {
      Skeleton_node world;
      for(const std::size_t p : node.points) {
        world.points.push_back(indices[p]);
        world.position += inner[indices[p]];
        m_result.node_of[indices[p]] = m_result.graph.nodes.size();
      }
      world.position /= double(node.points.size());
      m_result.graph.nodes.push_back(std::move(world));
      m_result.node_labels.push_back(is_sheet ? Meso_label::SHEET : Meso_label::CURVE);
    }
    for(const Skeleton_edge& e : part.edges)
      m_result.graph.edges.push_back({first + e[0], first + e[1]});
  }

  void add_curves(const std::vector<Ring_edge>& links, const std::vector<char>& is_sheet)
  {
    std::vector<std::size_t> place;
    const std::vector<std::size_t> curve = members(is_sheet, 0, place);
    if(curve.empty())
      return;
    Skeleton_thinning thinning(selected(m_shape.skeletal, curve), links_among(links, is_sheet, 0, place),
                               {m_node_distance, m_parameters.largest_merged_cycle,
                                [&](const Points& cycle) { return m_disc.leaves_the_shape(cycle); }},
                               selected(m_shape.skeletal, curve));
    thinning.thin();
    append(thinning.graph(), curve, m_shape.skeletal, false);
  }

  /// One graph of all deep points. The contraction is coarser than the skeletal points: longer cycles are merged.
  void add_contracted_curves(const std::vector<Ring_edge>& links)
  {
    Skeleton_thinning thinning(contracted_anchors(m_execution, m_shape), links,
                               {m_node_distance, 2 * m_parameters.largest_merged_cycle,
                                [&](const Points& cycle) { return m_disc.leaves_the_shape(cycle); }},
                               m_shape.skeletal);
    thinning.thin();
    append(thinning.graph(), all_indices<std::size_t>(m_shape.outer.size()), m_shape.skeletal, false);
  }

  void add_tips()
  {
    Skeleton_graph& graph = m_result.graph;
    std::vector<char> is_corner(graph.nodes.size(), 0);
    for(const Sheet_triangle& t : m_result.triangles)
      for(const std::size_t v : t)
        is_corner[v] = 1;
    // sheets end at their rims
    std::vector<std::vector<std::size_t> > hidden(graph.nodes.size());
    for(std::size_t v = 0; v < is_corner.size(); ++v)
      if(is_corner[v])
        hidden[v].swap(graph.nodes[v].points);
    extend_tips(graph, m_shape.outer);
    for(std::size_t v = 0; v < is_corner.size(); ++v)
      if(is_corner[v])
        hidden[v].swap(graph.nodes[v].points);
    m_result.node_labels.resize(graph.nodes.size(), Meso_label::END);
  }

  /// The skeletal points of a sheet draw together in it; the anchors cover it up to its rim.
  void add_sheets(const std::vector<Ring_edge>& links, const std::vector<char>& is_sheet)
  {
    std::vector<std::size_t> place;
    const std::vector<std::size_t> sheet = members(is_sheet, 1, place);
    if(sheet.empty())
      return;
    const std::vector<Ring_edge> inner_links = links_among(links, is_sheet, 1, place);
    const Skeleton_thinning sampling(selected(m_shape.anchors, sheet), inner_links,
                                     {m_node_distance, 0});
    Skeleton_graph nodes = sampling.graph();
    const std::set<Ring_edge> pairs = near_pairs(nodes);
    nodes.edges.clear();
    const std::size_t first = m_result.graph.nodes.size();
    append(nodes, sheet, m_shape.anchors, true);
    Points positions;
    for(std::size_t v = first; v < m_result.graph.nodes.size(); ++v)
      positions.push_back(m_result.graph.nodes[v].position);
    for(const Sheet_triangle& t : Sheet_triangulation::triangulate(m_execution, positions, pairs,
                                                                   m_parameters.largest_merged_cycle))
      m_result.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  /// Pairs of nodes that are one or two edges apart: the four corners of a quadrangle of links need a diagonal.
  static std::set<Ring_edge> near_pairs(const Skeleton_graph& graph)
  {
    std::set<Ring_edge> pairs;
    for(const std::vector<std::size_t>& around : adjacency(graph))
      for(const std::size_t a : around)
        for(const std::size_t b : around)
          if(a < b)
            pairs.insert({Index(a), Index(b)});
    for(const Skeleton_edge& e : graph.edges)
      pairs.insert({Index(e[0]), Index(e[1])});
    return pairs;
  }

  /// Curves and sheets that touch on the surface: an edge for each contact.
  void join_parts(const std::vector<Ring_edge>& links)
  {
    Skeleton_graph& graph = m_result.graph;
    Skeleton_graph all = graph;
    all.edges = all_edges(graph.edges, m_result.triangles);
    const std::vector<std::size_t> part = component_labels(all);
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(all);

    // contacts: pairs of nodes of two parts, by parts
    std::map<std::array<std::size_t, 2>, std::set<Skeleton_edge> > contacts;
    for(const Ring_edge& e : links) {
      std::size_t a = m_result.node_of[e[0]], b = m_result.node_of[e[1]];
      if(part[a] > part[b])
        std::swap(a, b);
      if(part[a] != part[b])
        contacts[{part[a], part[b]}].insert({a, b});
    }
    for(const auto& between : contacts)
      for(const Skeleton_edge& e : shortest_contacts(between.second, neighbors))
        graph.edges.push_back({(std::min)(e[0], e[1]), (std::max)(e[0], e[1])});
    std::sort(graph.edges.begin(), graph.edges.end());
  }

  /// Contacts whose ends are near each other in both parts, or the same in one of them, are one contact.
  std::vector<Skeleton_edge>
  shortest_contacts(const std::set<Skeleton_edge>& contacts,
                    const std::vector<std::vector<std::size_t> >& neighbors) const
  {
    const std::vector<Skeleton_edge> list(contacts.begin(), contacts.end());
    Disjoint_sets sets(list.size());
    for(std::size_t k = 0; k < list.size(); ++k)
      for(std::size_t l = 0; l < k; ++l)
        if(list[k][0] == list[l][0] || list[k][1] == list[l][1] ||
           (is_near(list[k][0], list[l][0], neighbors) && is_near(list[k][1], list[l][1], neighbors)))
          sets.join(k, l);
    std::map<std::size_t, std::size_t> shortest;
    for(std::size_t k = 0; k < list.size(); ++k) {
      const auto entry = shortest.emplace(sets.find(k), k).first;
      if(m_result.graph.edge_length(list[k]) < m_result.graph.edge_length(list[entry->second]))
        entry->second = k;
    }
    std::vector<Skeleton_edge> result;
    result.reserve(shortest.size());
    for(const auto& entry : shortest)
      result.push_back(list[entry.second]);
    return result;
  }
  /// At most two edges apart.
  static bool is_near(std::size_t a, std::size_t b,
                      const std::vector<std::vector<std::size_t> >& neighbors)
  {
    if(std::binary_search(neighbors[a].begin(), neighbors[a].end(), b))
      return true;
    for(const std::size_t c : neighbors[a])
      if(std::binary_search(neighbors[b].begin(), neighbors[b].end(), c))
        return true;
    return false;
  }

  /// A cycle that goes around a hole of the shape cannot be spanned inside of it. Others come from gaps of sheets
  /// and from sheets and curves that touch several times: triangles span them.
  void fill_false_cycles()
  {
    Skeleton_graph all = m_result.graph;
    all.edges = all_edges(all.edges, m_result.triangles);
    for(const std::vector<std::size_t>& cycle : Skeleton_homology(all, m_result.triangles).shortest_basis()) {
      Points corners;
      for(const std::size_t v : cycle)
        corners.push_back(all.nodes[v].position);
      if(m_disc.leaves_the_shape(corners))
        continue;
      const std::vector<Sheet_triangle> disc = triangles_of_polygon(
        cycle, [&](std::size_t v) -> const Vec3& { return all.nodes[v].position; });
      m_result.triangles.insert(m_result.triangles.end(), disc.begin(), disc.end());
    }
    std::sort(m_result.triangles.begin(), m_result.triangles.end());
    m_result.triangles.erase(std::unique(m_result.triangles.begin(), m_result.triangles.end()),
                             m_result.triangles.end());
  }

  void set_radii()
  {
    const Nearest_neighbors tree(m_shape.outer);
    for(Skeleton_node& node : m_result.graph.nodes)
      node.radius = std::sqrt(tree.nearest(node.position).squared_distance);
    m_result.radii.resize(m_shape.skeletal.size());
    parallel_for(m_execution, m_result.radii.size(), [&](std::size_t i) {
      m_result.radii[i] = std::sqrt(tree.nearest(m_shape.skeletal[i]).squared_distance);
    });
  }

  /// Nodes of curves with at most one neighbour are ends; where most deep points are not anchored, that goes first.
  void set_labels(const std::vector<char>& is_sheet)
  {
    std::vector<std::size_t> degree(m_result.graph.nodes.size(), 0);
    for(const Skeleton_edge& e : m_result.graph.edges) {
      ++degree[e[0]];
      ++degree[e[1]];
    }
    std::vector<std::size_t> unanchored(degree.size(), 0);
    for(std::size_t i = 0; i < is_sheet.size(); ++i)
      unanchored[m_result.node_of[i]] += m_shape.is_unanchored[i];
    for(std::size_t v = 0; v < degree.size(); ++v) {
      Meso_label& label = m_result.node_labels[v];
      if(2 * unanchored[v] > m_result.graph.nodes[v].points.size())
        label = Meso_label::UNANCHORED;
      else if(label == Meso_label::CURVE && degree[v] < 2)
        label = Meso_label::END;
    }
    for(std::size_t i = 0; i < is_sheet.size(); ++i) {
      const Meso_label label = m_result.node_labels[m_result.node_of[i]];
      m_result.labels.push_back(m_shape.is_unanchored[i]         ? Meso_label::UNANCHORED
                                : label != Meso_label::UNANCHORED ? label
                                : is_sheet[i]                     ? Meso_label::SHEET
                                                                  : Meso_label::CURVE);
    }
  }

  const Execution& m_execution;
  const Meso_shape& m_shape;
  Spanning_disc m_disc;
  Meso_graph_parameters m_parameters;
  double m_node_distance;
  Meso_graph m_result;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_GRAPH_H
