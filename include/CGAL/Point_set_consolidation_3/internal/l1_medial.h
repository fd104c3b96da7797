// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_H

#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/recentring.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_thinning.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_rings.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section V.A: the L1-medial skeleton, equation (8). In: points Z. Out: a
/// curve skeleton in the points' coordinates. Samples M of the points move to the L1 medians of balls that
/// grow, repelled along the curves that form; a sample whose surroundings are a curve stays.
///
/// Huang et al. trace branches and bridge them by rules; here the rings of the samples on the surface are
/// kept while they move, and thinned to a graph, which has the right topology. Lengths in units of the
/// diagonal of the points' box.

class L1_medial_skeletonization {
  static constexpr double cutoff = 0.6;            ///< of h: theta is 3e-3 there
  static constexpr double least_distance = 1e-3;   ///< of h
  static constexpr double least_move = 5e-4;       ///< mean move that ends the iterations at one h
  static constexpr std::size_t linearity_neighbors = 6;
  static constexpr std::size_t density_neighbors = 8;

public:
  L1_medial_skeletonization(Execution& execution, const Points& world,
                            const L1_medial_parameters& parameters)
    : m_execution(execution), m_parameters(parameters)
  {
    const Bounding_box box = bounding_box(world);
    m_frame.origin = box.centre();
    if(box.diagonal() > 0)
      m_frame.unit = box.diagonal();
    m_all = m_frame.to_local(world);
    m_points = selected(m_all, random_subset(m_all.size(), m_parameters.most_points, m_parameters.seed));
  }

  Skeleton_graph run(Stage& stage)
  {
    choose_samples();
    const Tangent_rings rings = find_tangent_rings(
      m_execution, m_start, (std::min)(m_start.size(), default_ring_neighbors(m_start.size())));
    weigh_points();
    contract(stage);
    return graph(rings);
  }

private:
  /// Evenly spread samples, each the farthest from those before: the rings need an even set.
  void choose_samples()
  {
    const std::size_t wanted = (std::min)(m_parameters.samples, m_points.size());
    std::vector<double> distance(m_points.size(), std::numeric_limits<double>::max());
    std::size_t farthest = 0;
    while(m_start.size() < wanted) {
      const Vec3 p = m_points[farthest];
      m_start.push_back(p);
      for(std::size_t i = 0; i < m_points.size(); ++i)
        distance[i] = (std::min)(distance[i], (m_points[i] - p).squaredNorm());
      farthest = std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
      if(!(distance[farthest] > 0))
        break;  // the rest are copies
    }
    m_samples = m_start;
    m_is_frozen.assign(m_samples.size(), 0);
    m_linearity.assign(m_samples.size(), 0.);
  }

  /// Area that a point stands for: alpha is divided by the density of the input.
  void weigh_points()
  {
    const Nearest_neighbors tree(m_points);
    m_area.assign(m_points.size(), 1.);
    parallel_for_places(m_execution, m_points, [&](std::size_t i) {
      std::vector<Neighbor> near;
      tree.find(m_points[i], density_neighbors + 1, near);
      m_area[i] = (std::max)(near.back().squared_distance, tiny_length);
    });
  }

  void contract(Stage& stage)
  {
    const double h0 = m_parameters.initial_radius > 0 ? m_parameters.initial_radius
                                                      : 2 / std::cbrt(double(m_points.size()));
    double h = h0;
    while(h <= (std::max)(h0, m_parameters.largest_radius)) {
      const Sorted_grid data(m_points, 0.5 * cutoff * h);
      for(std::size_t t = 0; t < m_parameters.inner_iterations; ++t) {
        const double move = iterate(data, h);
        stage.count_iteration();
        stage.update((h - h0 + 0.5 * h0 * double(t) / double(m_parameters.inner_iterations)) /
                     (std::max)(h0, m_parameters.largest_radius));
        if(move < least_move)
          break;
      }
      freeze();
      if(std::find(m_is_frozen.begin(), m_is_frozen.end(), char(0)) == m_is_frozen.end())
        break;
      h += 0.5 * h0;
    }
  }

  /// One step of equation (8) for all samples that are free; returns their mean move.
  double iterate(const Sorted_grid& data, double h)
  {
    const Sorted_grid grid(m_samples, cutoff * h);
    Points next = m_samples;
    std::vector<double> moves(m_samples.size(), 0.);
    parallel_for_places(m_execution, grid, [&](std::size_t l) {
      if(m_is_frozen[l])
        return;
      const Vec3& m = m_samples[l];
      const double factor = 16 / (h * h), least = least_distance * h;
      Vec3 median = Vec3::Zero();
      double weight = 0;
      data.for_each_neighbor_block(m, cutoff * h, [&](const Neighbor_block& block) {
        Block_weights weights;
        auto w = weights.set_gaussian(factor, block);
        w /= block.squared_distance().max(least * least).sqrt();
        for(int k = 0; k < block.size; ++k)
          w[k] *= m_area[block.index[k]];
        weight += w.sum();
        median += block.weighted_offset(w);
      });
      if(weight > 0)
        next[l] += median / weight;

      // sigma and the repulsion of the other samples
      Vec3 push = Vec3::Zero();
      Mat3 scatter = Mat3::Zero();
      double push_weight = 0;
      grid.for_each_neighbor_block(m, cutoff * h, [&](const Neighbor_block& block) {
        Block_weights theta;
        theta.set_gaussian(factor, block);
        for(int k = 0; k < block.size; ++k) {
          if(block.index[k] == l)
            continue;
          const Vec3 offset = block.offset(k);
          scatter += theta[k] * offset * offset.transpose();
          const double beta = theta[k] / (std::max)(block.d2[k], least * least);
          push -= beta * offset;
          push_weight += beta;
        }
      });
      m_linearity[l] = linearity(scatter);
      if(push_weight > 0)
        next[l] += m_parameters.repulsion * m_linearity[l] * push / push_weight;
      moves[l] = (next[l] - m).norm();
    });
    m_samples.swap(next);
    double sum = 0;
    std::size_t count = 0;
    for(std::size_t l = 0; l < moves.size(); ++l)
      if(!m_is_frozen[l]) {
        sum += moves[l];
        ++count;
      }
    return count > 0 ? sum / double(count) : 0;
  }

  /// sigma of equation (8): share of the largest eigenvalue.
  static double linearity(const Mat3& scatter)
  {
    const double trace = scatter.trace();
    if(!(trace > 0))
      return 0;
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.compute(scatter / trace, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[2];
  }

  /// Samples whose surroundings are a curve stay: without it everything collapses.
  void freeze()
  {
    const Nearest_neighbors tree(m_samples);
    std::vector<char> next = m_is_frozen;
    parallel_for(m_execution, m_samples.size(), [&](std::size_t l) {
      std::vector<Neighbor> near;
      tree.find(m_samples[l], linearity_neighbors + 1, near);
      double sum = 0;
      for(const Neighbor& neighbor : near)
        sum += m_linearity[neighbor.index];
      if(sum >= m_parameters.freezing_linearity * double(near.size()))
        next[l] = 1;
    });
    m_is_frozen.swap(next);
  }

  /// Thins the samples along the rings they had on the surface.
  Skeleton_graph graph(const Tangent_rings& rings) const
  {
    Skeleton_thinning thinning(
      m_samples, rings.edges,
      Thinning_parameters{m_parameters.sampling_radius, m_parameters.largest_merged_cycle});
    thinning.thin();
    std::vector<std::size_t> node_of;
    Skeleton_graph result = thinning.graph(&node_of);
    for(Skeleton_node& node : result.nodes)
      node.points.clear();
    const Nearest_neighbors tree(m_start);
    for(std::size_t i = 0; i < m_all.size(); ++i)
      result.nodes[node_of[tree.nearest(m_all[i]).index]].points.push_back(i);
    measure_radii(result);
    while(remove_spur(result))
      measure_radii(result);
    if(m_parameters.extend_tips)
      internal::extend_tips(result, m_all);
    return to_world(result, m_frame);
  }

  void measure_radii(Skeleton_graph& graph) const
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
    for(std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const Vec3 axis = axis_at(graph, neighbors, i);
      std::vector<double> distances;
      for(const std::size_t p : graph.nodes[i].points)
        distances.push_back(across(m_all[p] - graph.nodes[i].position, axis).norm());
      graph.nodes[i].radius = median(std::move(distances));
    }
  }

  /// Removes the shortest branch that ends inside of the ball of its joint: samples at the end of a tube that
  /// came late to the curve. Its points go to the joint.
  static bool remove_spur(Skeleton_graph& graph)
  {
    const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
    std::vector<std::size_t> spur;  // from the joint on
    double shortest = std::numeric_limits<double>::max();
    for(std::vector<std::size_t> chain : polylines_of(graph)) {
      if(neighbors[chain.front()].size() == 1)
        std::reverse(chain.begin(), chain.end());
      if(neighbors[chain.front()].size() < 3 || neighbors[chain.back()].size() != 1)
        continue;
      double length = 0;
      for(std::size_t k = 1; k < chain.size(); ++k)
        length += (graph.nodes[chain[k]].position - graph.nodes[chain[k - 1]].position).norm();
      if(length < (std::min)(shortest, graph.nodes[chain.front()].radius)) {
        shortest = length;
        spur = std::move(chain);
      }
    }
    if(spur.empty())
      return false;
    std::vector<char> keep(graph.nodes.size(), 1);
    std::vector<std::size_t>& points = graph.nodes[spur.front()].points;
    for(std::size_t k = 1; k < spur.size(); ++k) {
      const std::vector<std::size_t>& lost = graph.nodes[spur[k]].points;
      points.insert(points.end(), lost.begin(), lost.end());
      keep[spur[k]] = 0;
    }
    std::sort(points.begin(), points.end());
    graph = subgraph(graph, keep);
    return true;
  }

  Execution& m_execution;
  L1_medial_parameters m_parameters;
  Frame m_frame;
  Points m_all, m_points, m_start, m_samples;
  std::vector<double> m_area, m_linearity;
  std::vector<char> m_is_frozen;
};

inline Skeleton_graph l1_medial_skeleton(Execution& execution, double share, const Points& world,
                                         const L1_medial_parameters& parameters)
{
  Stage stage(execution, "l1-medial", share);
  return L1_medial_skeletonization(execution, world, parameters).run(stage);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_L1_MEDIAL_H
