// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_RECONSTRUCTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_RECONSTRUCTION_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_preprocessing.h>
#include <CGAL/Point_set_consolidation_3/internal/segmentation.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_completion.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_surface.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section V: features, skeleton, segments, completion and one field for all.

/// Segment of every skeleton edge: that of most of its ends' points, ties to the smaller number.
inline std::vector<std::size_t> segments_of_edges(const Skeleton_graph& graph,
                                                  const Segmentation& segmentation)
{
  std::vector<std::size_t> result;
  for(const Skeleton_edge& e : graph.edges) {
    std::vector<std::size_t> votes(segmentation.count, 0);
    for(const std::size_t end : e)
      for(const std::size_t p : graph.nodes[end].points)
        ++votes[segmentation.labels[p]];
    result.push_back(
      std::size_t(std::max_element(votes.begin(), votes.end()) - votes.begin()));
  }
  return result;
}

/// Share of each segment's skeleton length that the data confirm.
inline std::vector<double> confirmed_shares(const Skeleton_graph& graph, const Points& points,
                                            const std::vector<std::size_t>& segment, std::size_t count)
{
  const Trusted_nodes trusted(points);
  const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
  std::vector<char> is_trusted;
  for(std::size_t i = 0; i < graph.nodes.size(); ++i)
    is_trusted.push_back(trusted(graph.nodes[i].position, axis_at(graph, neighbors, i)));
  std::vector<double> confirmed(count, 0.), length(count, 0.);
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double l = graph.edge_length(graph.edges[e]);
    length[segment[e]] += l;
    confirmed[segment[e]] +=
      0.5 * l * (is_trusted[graph.edges[e][0]] + is_trusted[graph.edges[e][1]]);
  }
  for(std::size_t s = 0; s < count; ++s)
    confirmed[s] = length[s] > 0 ? confirmed[s] / length[s] : 0;
  return confirmed;
}

/// Edges of which an end or the middle lies in a gap of the data: the nearest points are farther than those of a tube
/// would be, and do not face away from there as a thicker part around it would, but to the side.
inline std::vector<char> gap_edges(const Skeleton_graph& graph, const Points& points, const Points& normals)
{
  constexpr double farther = 1.5;  // radii
  const Nearest_neighbors tree(points);
  const auto is_in_gap = [&](const Vec3& x, double radius) {
    return tree.nearest(x).squared_distance > farther * farther * radius * radius &&
           facing(tree, points, normals, x) > -1 / farther;  // the rim of a tube, from so many radii along its axis
  };
  std::vector<char> is_gap;
  for(const Skeleton_edge& e : graph.edges) {
    const Skeleton_node& a = graph.nodes[e[0]];
    const Skeleton_node& b = graph.nodes[e[1]];
    is_gap.push_back(is_in_gap(a.position, a.radius) || is_in_gap(b.position, b.radius) ||
                     is_in_gap((a.position + b.position) / 2, (a.radius + b.radius) / 2));
  }
  return is_gap;
}

/// Typical distance of the points from the planes of their neighbours. Points in units of their spacing.
inline double measured_noise(const Execution& execution, const Points& points)
{
  constexpr std::size_t few = 12, many = 48;
  constexpr double narrow = 0.3;  // noise for which the few neighbours' plane is not much wider than thick
  Normal_parameters parameters;
  parameters.plane_neighbors = parameters.neighbors = few;
  const double noise = Normal_optimization(execution, points, parameters).noise();
  if(noise < narrow)
    return noise;  // few neighbours: curvature counts less, a tube of radius 9 without noise has 0.06
  parameters.plane_neighbors = parameters.neighbors = many;
  return Normal_optimization(execution, points, parameters).noise();
}

/// What remains of the points' weight if they have noise, which is given in cells of the field. The cell's smoothness
/// and its data balance as the variances of the field and of the noise do.
inline double share_of_weight(double noise)
{
  constexpr double field_noise = 0.05;  // with 0.12, surfaces follow noise of 1 % of the diagonal
  return 1 / (1 + noise * noise / (field_noise * field_noise));
}

/// The whole pipeline. `given` may be empty (then the skeleton is extracted).
class Feature_enhanced_reconstruction {
  static constexpr double confirmed_enough = 0.6;  ///< of a segment's length, to complete it automatically
  static constexpr double doubtful_depth = 1;      ///< cells, of handles that an extracted skeleton does not have

public:
  Feature_enhanced_reconstruction(Execution& execution, const Points& world, const Points& normals,
                                  const Skeleton_graph& given, const Feature_enhanced_settings& settings)
    : m_execution(execution), m_settings(settings), m_has_skeleton(!given.nodes.empty())
    , m_input(enhanced_input(execution, 0.2, world, normals, settings.enhances, settings.sharpness_angle))
  {
    Stage stage(execution, "skeleton", 0.15);
    if(m_has_skeleton)
      use_skeleton(to_local(given, m_input.frame));
    else
      m_result.skeleton = skeleton_of_parts(execution, stage, m_input.points, m_input.normals, true);
  }

  Feature_enhanced_result run()
  {
    segment();
    upsample();
    choose_parts();
    complete();
    fuse();
    m_result.fused.points = m_input.frame.to_world(std::move(m_result.fused.points));
    m_result.skeleton = to_world(std::move(m_result.skeleton), m_input.frame);
    return std::move(m_result);
  }

private:
  void use_skeleton(Skeleton_graph graph)
  {
    Points nodes;
    for(Skeleton_node& node : graph.nodes) {
      nodes.push_back(node.position);
      node.points.clear();
    }
    const Nearest_neighbors tree(nodes);
    for(std::size_t i = 0; i < m_input.points.size(); ++i)
      graph.nodes[tree.nearest(m_input.points[i]).index].points.push_back(i);
    complete_radii(graph, m_input.points);
    m_result.skeleton = std::move(graph);
  }

  void segment()
  {
    Segmentation_settings settings = m_settings.segmentation;
    if(settings.method == Segmentation_method::SKELETON) {
      m_result.segmentation =
        Skeleton_segmentation(m_result.skeleton, m_input.points.size(), settings.skeleton).run(m_input.points);
      return;
    }
    settings.radius /= m_input.frame.unit;
    m_result.segmentation = segment_points(m_execution, 0.05, m_input.points, m_input.normals, settings);
  }

  void upsample()
  {
    m_result.fused = {m_input.points, m_input.normals};
    if(!(m_settings.upsampling_factor > 1))
      return;
    Edge_aware_parameters upsampling;
    upsampling.oriented = true;
    upsampling.sharpness_angle = m_settings.sharpness_angle;
    upsampling.number_of_points = std::size_t(m_settings.upsampling_factor * double(m_input.points.size()));
    upsampling.neighbor_radius = 0;
    upsampling.plane_width = 0;
    m_result.fused = upsample_at_edges(m_execution, 0.1, m_input.points, m_input.normals, upsampling);
  }

  /// Edges along which the surface is completed, and those that constrain it.
  void choose_parts()
  {
    const Skeleton_graph& graph = m_result.skeleton;
    const std::vector<std::size_t> segment = segments_of_edges(graph, m_result.segmentation);
    const std::vector<double> confirmed =
      confirmed_shares(graph, m_input.points, segment, m_result.segmentation.count);
    const std::vector<char> is_gap = gap_edges(graph, m_input.points, m_input.normals);
    for(std::size_t e = 0; e < segment.size(); ++e) {
      const std::size_t s = segment[e];
      const Part_method method = s < m_settings.methods.size() ? m_settings.methods[s] : Part_method::AUTOMATIC;
      // an extracted skeleton has wrong centres and radii beside missing data, where normals know better
      const bool is_trusted =
        method == Part_method::SKELETON || (method == Part_method::AUTOMATIC && m_has_skeleton);
      m_is_constraint.push_back(is_trusted);
      m_is_wanted.push_back(method == Part_method::SKELETON ||
                            (is_trusted && (is_gap[e] || confirmed[s] >= confirmed_enough)));
    }
  }

  void complete()
  {
    const Skeleton_completed_points completed =
      Skeleton_completion(m_input.points, m_input.normals, 1, m_result.skeleton).run(m_is_wanted, m_has_skeleton);
    Oriented_points& fused = m_result.fused;
    fused.points.insert(fused.points.end(), completed.points.begin(), completed.points.end());
    fused.normals.insert(fused.normals.end(), completed.normals.begin(), completed.normals.end());
  }

  /// One field for all parts: fields of parts close themselves at the cuts.
  void fuse()
  {
    const Bounding_box box = bounding_box(m_result.fused.points);
    Frame frame;
    frame.origin = box.centre();
    frame.unit = box.sides().maxCoeff();
    Field_parameters field = m_settings.field;
    // A skeleton that is given has the right handles; where an extracted one has too few, those that are far from
    // being closed stay.
    field.removed_handles = m_has_skeleton ? std::numeric_limits<double>::max() : doubtful_depth;
    const double cell = frame.unit / double(field.resolution);
    field.surface_weight *= share_of_weight(measured_noise(m_execution, m_input.points) / cell);
    m_result.surface =
      reconstruct_from_skeleton(m_execution, frame.to_local(m_result.fused.points), m_result.fused.normals,
                                to_local(m_result.skeleton, frame), m_is_constraint, field);
    for(Vec3& v : m_result.surface.vertices)
      v = m_input.frame.to_world(frame.to_world(v));
  }

  Execution& m_execution;
  const Feature_enhanced_settings& m_settings;
  bool m_has_skeleton;
  Feature_input m_input;
  Feature_enhanced_result m_result;   ///< in the frame of the input until the end
  std::vector<char> m_is_wanted, m_is_constraint;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_RECONSTRUCTION_H
