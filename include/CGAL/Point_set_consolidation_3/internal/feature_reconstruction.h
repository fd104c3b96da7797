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
  constexpr double field_noise = 0.12;
  return 1 / (1 + noise * noise / (field_noise * field_noise));
}

/// The whole 2018 pipeline on the caller's points; `given` may be empty (then the skeleton is extracted).
inline Feature_enhanced_result
reconstruct_feature_enhanced(Execution& execution, const Points& world, Points normals,
                             const Skeleton_graph& given, const Feature_enhanced_settings& settings)
{
  constexpr double confirmed_enough = 0.6;  // of a segment's length, to complete it automatically
  Feature_enhanced_result result;
  Frame frame;
  Points points;
  {
    Stage stage(execution, "features", 0.2);
    frame = data_frame(execution, world, world.size());
    require_spacing(frame);
    points = frame.to_local(world);
    if(normals.empty())
      normals = estimated_normals(execution, points);
    stage.update(0.3);
    if(settings.enhances) {
      Feature_parameters features;
      features.oriented = true;
      features.sharpness_angle = settings.sharpness_angle;
      enhance_features(execution, points, normals, features);
    }
  }
  {
    Stage stage(execution, "skeleton", 0.15);
    if(!given.nodes.empty()) {
      result.skeleton = to_local(given, frame);
      Points nodes;
      for(Skeleton_node& node : result.skeleton.nodes) {
        nodes.push_back(node.position);
        node.points.clear();
      }
      const Nearest_neighbors tree(nodes);
      for(std::size_t i = 0; i < points.size(); ++i)
        result.skeleton.nodes[tree.nearest(points[i]).index].points.push_back(i);
      complete_radii(result.skeleton, points);
    }
    else {
      Laplacian_skeleton_parameters parameters;
      parameters.most_samples = 5000;
      Execution silent = {execution.parallel, Progress(), {}};
      Laplacian_skeletonization skeletonization(silent, points, normals, Points(), parameters);
      skeletonization.contract_until_convergence();
      stage.update(0.8);
      skeletonization.thin();
      skeletonization.recentre();
      skeletonization.extend_tips();
      result.skeleton = skeletonization.skeleton();
    }
  }
  if(settings.segmentation.method == Segmentation_method::SKELETON)
    result.segmentation =
      Skeleton_segmentation(result.skeleton, points.size(), settings.segmentation.skeleton)
        .run(points);
  else {
    Segmentation_settings local = settings.segmentation;
    local.radius /= frame.unit;
    result.segmentation = segment_points(execution, 0.05, points, normals, local);
  }

  Oriented_points& fused = result.fused;
  fused.points = points;
  fused.normals = normals;
  if(settings.upsampling_factor > 1) {
    Edge_aware_parameters upsampling;
    upsampling.oriented = true;
    upsampling.sharpness_angle = settings.sharpness_angle;
    upsampling.number_of_points = std::size_t(settings.upsampling_factor * double(points.size()));
    upsampling.neighbor_radius = 0;
    upsampling.plane_width = 0;
    fused = upsample_at_edges(execution, 0.1, points, normals, upsampling);
  }

  // parts: which are completed along the skeleton
  const std::vector<std::size_t> segment = segments_of_edges(result.skeleton, result.segmentation);
  const std::vector<double> confirmed =
    confirmed_shares(result.skeleton, points, segment, result.segmentation.count);
  const std::vector<char> is_gap = gap_edges(result.skeleton, points, normals);
  std::vector<char> is_wanted, is_constraint;
  for(std::size_t e = 0; e < segment.size(); ++e) {
    const std::size_t s = segment[e];
    const Part_method method =
      s < settings.methods.size() ? settings.methods[s] : Part_method::AUTOMATIC;
    is_wanted.push_back(method == Part_method::SKELETON ||
                        (method == Part_method::AUTOMATIC && !given.nodes.empty() &&
                         (is_gap[e] || confirmed[s] >= confirmed_enough)));
    // an extracted skeleton has wrong centres and radii beside missing data, where normals know better
    is_constraint.push_back(method == Part_method::SKELETON ||
                            (method == Part_method::AUTOMATIC && !given.nodes.empty()));
  }
  const Skeleton_completion completion(points, normals, 1, result.skeleton);
  const Skeleton_completed_points completed = completion.run(is_wanted, !given.nodes.empty());
  fused.points.insert(fused.points.end(), completed.points.begin(), completed.points.end());
  fused.normals.insert(fused.normals.end(), completed.normals.begin(), completed.normals.end());

  // parts are fused in one field: fields of parts close themselves at the cuts
  const Bounding_box box = bounding_box(fused.points);
  Frame field_frame;
  field_frame.origin = box.centre();
  field_frame.unit = box.sides().maxCoeff();
  // A skeleton that is given has the right handles; where an extracted one has too few, those that are far from
  // being closed stay.
  constexpr double doubtful_depth = 1;  // cells
  Field_parameters field = settings.field;
  field.removed_handles =
    given.nodes.empty() ? doubtful_depth : std::numeric_limits<double>::max();
  const double cell = field_frame.unit / double(field.resolution);
  field.surface_weight *= share_of_weight(measured_noise(execution, points) / cell);
  result.surface =
    reconstruct_from_skeleton(execution, field_frame.to_local(fused.points), fused.normals,
                              to_local(result.skeleton, field_frame), is_constraint,
                              field);
  for(Vec3& v : result.surface.vertices)
    v = frame.to_world(field_frame.to_world(v));
  fused.points = frame.to_world(std::move(fused.points));
  result.skeleton = to_world(std::move(result.skeleton), frame);
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_RECONSTRUCTION_H
