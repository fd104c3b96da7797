// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_FEATURE_ENHANCED_SURFACE_RECONSTRUCTION_H
#define CGAL_FEATURE_ENHANCED_SURFACE_RECONSTRUCTION_H

#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <CGAL/Point_set_consolidation_3/internal/feature_preprocessing.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_completion.h>
#include <CGAL/Point_set_consolidation_3/options.h>

#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {

/// \cond SKIP_IN_MANUAL
namespace internal {

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

/// Whether denoising gains more than it flattens curved parts. Points in units of their spacing.
inline bool is_noisy(const Execution& execution, const Points& points)
{
  constexpr double least_noise = 0.15;  // a tube of radius 9 without noise has 0.06
  Normal_parameters parameters;
  parameters.plane_neighbors = parameters.neighbors = 12;
  return Normal_optimization(execution, points, parameters).noise() > least_noise;
}

struct Feature_enhanced_settings {
  Segmentation_settings segmentation;
  std::vector<Part_method> methods;   ///< of the segments; missing ones are automatic
  bool enhances = true;
  bool is_enhancement_automatic = true;  ///< only if there is noise
  double sharpness_angle = 20;
  double upsampling_factor = 1;
  Field_parameters field;
};

struct Feature_enhanced_result {
  Segmentation segmentation;
  Skeleton_graph skeleton;
  Oriented_points fused;              ///< enhanced, up-sampled and completed points
  Surface_triangles surface;
};

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
    points = local_points(frame, world);
    if(normals.empty())
      normals = estimated_normals(execution, points);
    stage.update(0.3);
    if(settings.is_enhancement_automatic ? is_noisy(execution, points) : settings.enhances) {
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
  std::vector<char> is_wanted;
  for(const std::size_t s : segment) {
    const Part_method method =
      s < settings.methods.size() ? settings.methods[s] : Part_method::AUTOMATIC;
    is_wanted.push_back(method == Part_method::SKELETON ||
                        (method == Part_method::AUTOMATIC && !given.nodes.empty() &&
                         confirmed[s] >= confirmed_enough));
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
  result.surface =
    reconstruct_from_skeleton(execution, local_points(field_frame, fused.points),
                              to_local(result.skeleton, field_frame), settings.field);
  for(Vec3& v : result.surface.vertices)
    v = frame.to_world(field_frame.to_world(v));
  make_world(frame, fused.points);
  result.skeleton = to_world(std::move(result.skeleton), frame);
  return result;
}

}  // namespace internal
/// \endcond
}  // namespace Point_set_consolidation_3

/*!
  \ingroup PkgPointSetConsolidation3Surfaces

  reconstructs a closed surface from a noisy, incomplete point set with the help of segments and curve
  skeletons: the whole of the feature-enhanced surfaces paper \cgalCite{cgal:wfglchc-fes-18}.

  Normals are optimised across edges and points denoised (section III); the curve skeleton is extracted and the
  points are segmented along it (section IV; the other order than the paper's, whose segments by density do
  not find parts of evenly sampled surfaces); each segment gets its surface from the data, or, where these are
  missing, from generalised cylinders around the skeleton with profiles of the data (section V); all are fused in
  one signed distance field, see `skeleton_driven_surface_reconstruction()`. Separate surfaces of the
  parts would close themselves at the cuts.

  A skeleton can be given, for instance an edited one; its vertices are then trusted wherever they are.

  The result is the same, bit for bit, for any `ConcurrencyTag` and number of threads.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam Kernel a model of `Kernel`, floating point coordinates.
  \tparam TriangleMesh a model of `MutableFaceGraph`.

  \param points at least 10 points with finite coordinates.
  \param skeleton the skeleton to use; if it is empty it is extracted, and receives the skeleton that was used.
  \param mesh receives the surface; unchanged if the callback cancels.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: planes fitted to 18 neighbours, oriented by propagation}
    \cgalParamNEnd
    \cgalParamNBegin{enhance_features}
      \cgalParamDescription{whether normals are optimised and points denoised}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true` if points lie more than 0.15 spacings off the planes of their neighbours, so that thin
        parts of clean data are not flattened}
    \cgalParamNEnd
    \cgalParamNBegin{sharpness_angle}
      \cgalParamDescription{\f$\alpha\f$ of equation (5), degrees, (0, 90)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{20}
    \cgalParamNEnd
    \cgalParamNBegin{upsampling_factor}
      \cgalParamDescription{number of points after up-sampling, in numbers of points; at least 1}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{1: no up-sampling}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_segments}
      \cgalParamDescription{number of segments; 0: found automatically}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{0}
    \cgalParamNEnd
    \cgalParamNBegin{segmentation_method}
      \cgalParamDescription{how segments are found}
      \cgalParamType{`Point_set_consolidation_3::Segmentation_method`}
      \cgalParamDefault{`Segmentation_method::SKELETON`}
    \cgalParamNEnd
    \cgalParamNBegin{segment_methods}
      \cgalParamDescription{what the surface of each segment is made from, in the order of the segments' numbers}
      \cgalParamType{a range of `Point_set_consolidation_3::Part_method`, by value or by `std::ref`}
      \cgalParamDefault{`Part_method::AUTOMATIC` for all: completed if the skeleton is given and data confirm at least 60 % of
        it}
    \cgalParamNEnd
    \cgalParamNBegin{grid_resolution}
      \cgalParamDescription{cells along the longest side of the bounding box, in [8, 1024]}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{64}
    \cgalParamNEnd
    \cgalParamNBegin{surface_weight}
      \cgalParamDescription{weight of the points in the field, positive}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{50}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call, which then leaves its output untouched}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{stage_times}
      \cgalParamDescription{receives name, seconds and iterations of each stage}
      \cgalParamType{`std::reference_wrapper` of a `std::vector<Point_set_consolidation_3::Stage_time>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{the kernel of the points}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `false` if the callback cancelled, `true` otherwise.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, most points
  coincide, or a parameter is out of its range; the message names it.
  \throws std::runtime_error if there is no surface at this resolution.
*/
template <typename ConcurrencyTag, typename PointRange, typename Kernel, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
bool feature_enhanced_surface_reconstruction(
  const PointRange& points, Curve_skeleton_3<Kernel>& skeleton, TriangleMesh& mesh,
  const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  typedef Cgal_np<NamedParameters> NP;
  const char* function = "feature_enhanced_surface_reconstruction";
  const NP& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;

  const Points world = copy_points(function, points, np, least_points);
  Points normals = copy_normals(function, points, np);
  if(!normals.empty())
    normals = copy_unit_normals(function, points, np);
  Feature_enhanced_settings settings;
  settings.enhances = parameter_or(np, tags::enhance_features, settings.enhances);
  settings.is_enhancement_automatic = !has_parameter<NP, tags::enhance_features_t>;
  settings.sharpness_angle = parameter_or(np, tags::sharpness_angle, settings.sharpness_angle);
  settings.upsampling_factor = parameter_or(np, tags::upsampling_factor, settings.upsampling_factor);
  settings.segmentation.method =
    parameter_or(np, tags::segmentation_method, settings.segmentation.method);
  settings.segmentation.skeleton.count =
    parameter_or(np, tags::number_of_segments, std::size_t(0));
  settings.field.resolution = parameter_or(np, tags::grid_resolution, settings.field.resolution);
  settings.field.surface_weight = parameter_or(np, tags::surface_weight, settings.field.surface_weight);
  if constexpr(has_parameter<NP, tags::segment_methods_t>) {
    const auto methods = CGAL::parameters::get_parameter(np, tags::segment_methods);
    for(const auto& method : dereferenced(methods))
      settings.methods.push_back(method);
  }
  require(settings.sharpness_angle > 0 && settings.sharpness_angle < 90, function,
          "sharpness_angle must be in (0, 90)");
  require(settings.upsampling_factor >= 1 && settings.upsampling_factor <= 100, function,
          "upsampling_factor must be in [1, 100]");
  require(settings.field.resolution >= 8 && settings.field.resolution <= 1024, function,
          "grid_resolution must be in [8, 1024]");
  require(settings.field.surface_weight > 0, function, "surface_weight must be positive");
  const Skeleton_graph given = to_skeleton_graph<Kernel>(skeleton);
  for(const Skeleton_node& node : given.nodes)
    require(node.position.allFinite() && std::isfinite(node.radius) && node.radius >= 0, function,
            "a vertex of the skeleton is not finite or has a negative radius");

  Execution execution = make_execution<ConcurrencyTag>(callback_of(np));
  Feature_enhanced_result result;
  try {
    result = reconstruct_feature_enhanced(execution, world, std::move(normals), given, settings);
    execution.progress.finish();
  }
  catch(const Cancelled&) {
    return false;
  }
  catch(const std::invalid_argument& error) {
    throw_invalid(function, error.what());
  }
  report_stage_times(np, execution.times);
  if(result.surface.triangles.empty())
    throw std::runtime_error(std::string(function) + "(): no surface at this resolution");

  std::vector<typename Kernel::Point_3> vertices;
  for(const Vec3& v : result.surface.vertices)
    vertices.push_back(to_point<Kernel>(v));
  CGAL::clear(mesh);
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(vertices, result.surface.triangles, mesh);
  if(given.nodes.empty())
    assign<Kernel>(skeleton, result.skeleton);
  return true;
}

/*!
  \ingroup PkgPointSetConsolidation3Surfaces

  completes a point set along a curve skeleton: writes points with normals on generalised cylinders around the
  skeleton where the point set has none. Profiles are those of the points around the vertices.

  With the right skeleton and radii the result is very good, with wrong ones it does harm: by default only
  vertices that the points confirm, and those between two of them, count. A point is missing where the next
  one is farther than 3 spacings and 0.35 radii.

  \tparam OutputIterator a model of `OutputIterator` for
  `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`.
  \param points at least 10 points with finite coordinates.
  \param skeleton a skeleton with radii whose vertices know their points.
  \param output receives the missing points.
  \param trusts_all whether all vertices count, for skeletons edited by hand.
  \param named_parameters an optional sequence of named parameters: `point_map`, `normal_map` (outward; without it normals are
  estimated), `geom_traits`.

  \return `output` past the last point.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, most points
  coincide, a vertex of the skeleton has an index that is not one of the points, or the skeleton is so long and
  thick that it would take more than ten million points.
*/
template <typename ConcurrencyTag, typename PointRange, typename Kernel, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator complete_point_set_along_skeleton(
  const PointRange& points, const Curve_skeleton_3<Kernel>& skeleton, OutputIterator output,
  bool trusts_all = false, const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  const char* function = "complete_point_set_along_skeleton";
  const auto& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;
  const Points world = copy_points(function, points, np, least_points);
  const Skeleton_graph graph = to_skeleton_graph<Kernel>(skeleton);
  for(const Skeleton_node& node : graph.nodes) {
    require(node.position.allFinite() && std::isfinite(node.radius) && node.radius >= 0, function,
            "a vertex of the skeleton is not finite or has a negative radius");
    for(const std::size_t p : node.points)
      require(p < world.size(), function, "a vertex of the skeleton stands for a point that is not there");
  }
  const Execution execution = make_execution<ConcurrencyTag>();
  const Frame frame = data_frame(execution, world, world.size());
  require(frame.unit > 0, function, "more than half of the points coincide");
  Points normals = copy_normals(function, points, np);
  if(normals.empty())
    normals = estimated_normals(execution, local_points(frame, world));
  else
    normals = copy_unit_normals(function, points, np);
  const Skeleton_completion completion(world, normals, frame.unit, graph);
  Skeleton_completed_points completed;
  try {
    completed = completion.run(std::vector<char>(graph.edges.size(), 1), trusts_all);
  }
  catch(const std::invalid_argument& error) {
    throw_invalid(function, error.what());
  }
  for(std::size_t i = 0; i < completed.points.size(); ++i)
    *output++ = std::make_pair(to_point<Kernel>(completed.points[i]),
                               to_vector<Kernel>(completed.normals[i]));
  return output;
}

}  // namespace CGAL

#endif  // CGAL_FEATURE_ENHANCED_SURFACE_RECONSTRUCTION_H
