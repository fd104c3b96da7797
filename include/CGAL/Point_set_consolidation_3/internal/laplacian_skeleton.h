// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_SKELETON_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_SKELETON_H

#include <CGAL/Point_set_consolidation_3/internal/contraction_samples.h>
#include <CGAL/Point_set_consolidation_3/internal/laplacian_contraction.h>
#include <CGAL/Point_set_consolidation_3/internal/recentring.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_thinning.h>

#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section III: the steps in their order, from the caller's points to the
/// skeleton in the caller's coordinates.

class Laplacian_skeletonization {
public:
  /// `normals`: outward normals of the points, or empty. `references` are the points that the nodes' lists
  /// mean; empty: the points themselves.
  Laplacian_skeletonization(Execution execution, const Points& points, const Points& normals,
                            const Points& references,
                            const Laplacian_skeleton_parameters& parameters)
    : m_execution(std::move(execution)), m_parameters(parameters), m_normals(normals)
  {
    const Bounding_box box = bounding_box(points);
    m_frame = contraction_frame(box);
    m_points = m_frame.to_local(points);
    m_references = m_frame.to_local(references);
    m_node_distance = m_parameters.sampling_radius * box.diagonal() / m_frame.unit;
    m_samples = contraction_samples(m_execution, m_points, m_parameters.most_samples);
  }
  Laplacian_skeletonization(const Laplacian_skeletonization&) = delete;  // parts refer to each other
  Laplacian_skeletonization& operator=(const Laplacian_skeletonization&) = delete;

  Execution& execution() { return m_execution; }
  const Execution& execution() const { return m_execution; }

  void find_rings()
  {
    if(m_contraction)
      return;
    Stage stage(m_execution, "rings", 0.2);
    const std::size_t n = m_samples.points.size();
    m_rings = m_parameters.neighbors > 0
                ? find_tangent_rings(m_execution, m_samples.points, (std::min)(m_parameters.neighbors, n))
                : find_joined_rings(m_execution, m_samples.points);
    m_contraction = std::make_unique<Laplacian_contraction>(m_execution, m_samples.points, m_rings,
                                                            m_parameters.contraction);
  }

  /// One iteration; returns whether another one makes sense.
  bool contract_geometry()
  {
    find_rings();
    return m_contraction->contract_geometry();
  }

  void contract_until_convergence()
  {
    find_rings();
    Stage stage(m_execution, "contraction", 0.7);
    constexpr double usual_iterations = 5;
    while(m_contraction->contract_geometry()) {
      stage.count_iteration();
      stage.update(double(m_contraction->number_of_iterations()) / usual_iterations);
    }
  }

  void build_graph()
  {
    find_rings();
    const Thinning_parameters parameters = {m_node_distance, m_parameters.largest_merged_cycle};
    const Points& points = m_contraction->points();
    if(m_rings.triangles.empty())
      m_thinning = std::make_unique<Skeleton_thinning>(points, chain(), parameters);
    else
      m_thinning = std::make_unique<Skeleton_thinning>(points, m_rings.edges, parameters,
                                                       m_samples.points);
    take_graph();
  }

  void thin()
  {
    if(!m_thinning)
      build_graph();
    Stage stage(m_execution, "thinning", 0.1);
    m_thinning->thin();
    take_graph();
  }

  void recentre() { Recentring(m_points, m_normals).apply(m_graph); }

  void extend_tips()
  {
    if(m_parameters.extend_tips)
      internal::extend_tips(m_graph, m_points);
  }

  /// The skeleton in its present state, in the caller's coordinates.
  Skeleton_graph skeleton() const
  {
    Skeleton_graph result = to_world(m_graph, m_frame);
    if(!m_references.empty()) {
      for(Skeleton_node& node : result.nodes)
        node.points.clear();
      const Nearest_neighbors tree(m_samples.points);
      for(std::size_t i = 0; i < m_references.size(); ++i)
        result.nodes[m_node_of_sample[tree.nearest(m_references[i]).index]].points.push_back(i);
    }
    return result;
  }

  /// The contracted place of every point, in the caller's coordinates.
  Points contracted_points() const
  {
    const Points& samples = m_contraction ? m_contraction->points() : m_samples.points;
    Points result;
    for(const std::size_t s : m_samples.sample_of)
      result.push_back(m_frame.to_world(samples[s]));
    return result;
  }

  std::size_t number_of_iterations() const
  {
    return m_contraction ? m_contraction->number_of_iterations() : 0;
  }
  double initial_contraction_weight() const
  {
    return m_contraction ? m_contraction->initial_contraction_weight() : 0;
  }

private:
  /// Neighbours along a line, for points that have no ring at all because they lie on one.
  std::vector<Ring_edge> chain() const
  {
    const Points& points = m_samples.points;
    Covariance_sum sum;
    for(const Vec3& p : points)
      sum.add(p - points.front());
    const Vec3 axis = sum.axes().eigenvectors().col(2);
    std::vector<Index> order = all_indices(points.size());
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return points[a].dot(axis) < points[b].dot(axis); });
    std::vector<Ring_edge> edges;
    for(std::size_t k = 1; k < order.size(); ++k)
      edges.push_back({order[k - 1], order[k]});
    return edges;
  }

  /// The nodes' points are samples in the thinning; here they become the caller's.
  void take_graph()
  {
    m_graph = m_thinning->graph(&m_node_of_sample);
    for(Skeleton_node& node : m_graph.nodes)
      node.points.clear();
    for(std::size_t i = 0; i < m_points.size(); ++i)
      m_graph.nodes[m_node_of_sample[m_samples.sample_of[i]]].points.push_back(i);
  }

  Execution m_execution;
  Laplacian_skeleton_parameters m_parameters;
  Frame m_frame;
  Points m_points, m_normals, m_references;
  double m_node_distance = 0;
  Contraction_samples m_samples;
  Tangent_rings m_rings;
  std::unique_ptr<Laplacian_contraction> m_contraction;
  std::unique_ptr<Skeleton_thinning> m_thinning;
  std::vector<std::size_t> m_node_of_sample;
  Skeleton_graph m_graph;
};

/// The skeleton by which a shape falls into parts, within a stage of another method.
inline Skeleton_graph skeleton_of_parts(const Execution& execution, Stage& stage, const Points& points,
                                        const Points& normals, bool extends_tips)
{
  Laplacian_skeleton_parameters parameters;
  parameters.most_samples = 5000;  // seconds on large sets; parts do not depend on it
  parameters.extend_tips = extends_tips;
  Execution silent = {execution.parallel, Progress(), {}};
  Laplacian_skeletonization skeletonization(std::move(silent), points, normals, Points(), parameters);
  skeletonization.find_rings();
  stage.update(0.2);
  skeletonization.contract_until_convergence();
  stage.update(0.9);
  skeletonization.thin();
  skeletonization.recentre();
  skeletonization.extend_tips();
  return skeletonization.skeleton();
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_LAPLACIAN_SKELETON_H
