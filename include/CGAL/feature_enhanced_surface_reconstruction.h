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

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>

#include <utility>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Surfaces

  reconstructs a closed surface from a noisy, incomplete point set with the help of segments and curve
  skeletons: the whole of the feature-enhanced surfaces paper \cgalCite{cgal:wfglchc-fes-18}.

  If wanted, normals are optimised across edges and points denoised (section III); the curve skeleton is extracted
  and the points are segmented along it (section IV; the other order than the paper's, whose segments by density do
  not find parts of evenly sampled surfaces); each segment gets its surface from the data, or, where these are
  missing, from generalised cylinders around the skeleton with profiles of the data (section V); all are fused in
  one signed distance field, see `skeleton_driven_surface_reconstruction()`. Separate surfaces of the
  parts would close themselves at the cuts. Beyond that field, the gradient at the points is their normal, and
  the skeleton constrains the field only in segments that are made from it: an extracted skeleton has wrong
  centres and radii beside missing data, which would bend the unseen surface.

  A skeleton can be given, for instance an edited one; its vertices are then trusted wherever they are, and so is
  its topology: handles of the surface that it does not have are removed, the weakest first. Of those that an extracted
  skeleton does not have, only the ones are removed whose bridge or tunnel is thinner than two cells.

  Complexity: that of `extract_laplacian_contraction_skeleton()` of at most 5000 samples, \f$O(n \log n)\f$ for
  normals and segments, and \f$O(a R^2)\f$ for the field, as for `skeleton_driven_surface_reconstruction()`.

  The result is the same, bit for bit, for any `ConcurrencyTag` and number of threads.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam Kernel a model of `Kernel`, floating point coordinates.
  \tparam TriangleMesh a model of `MutableFaceGraph`.

  \param points at least 10 points with finite coordinates.
  \param skeleton the skeleton to use; if it is empty it is extracted, and receives the skeleton that was used.
  \param mesh receives the surface; unchanged if the callback cancels.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: planes fitted to 18 neighbours, oriented as in Section \ref PSC3Orientation}
    \cgalParamNEnd
    \cgalParamNBegin{enhance_features}
      \cgalParamDescription{whether normals are optimised and points denoised: for noisy points of shapes with flat
        faces and sharp edges. Curved parts become flatter than by the field alone, which takes the noise into
        account}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
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
      \cgalParamDefault{`Part_method::AUTOMATIC` for all: from the data if the skeleton is extracted; from both if it
        is given, with cylinders if data confirm at least 60 % of it and, in any case, where it crosses a gap}
    \cgalParamNEnd
    \cgalParamNBegin{grid_resolution}
      \cgalParamDescription{cells along the longest side of the bounding box, in [8, 1024]}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{64}
    \cgalParamNEnd
    \cgalParamNBegin{surface_weight}
      \cgalParamDescription{\f$\omega_2\f$, weight of points without noise in the field, positive. It is divided by
        \f$1 + (\sigma / 0.05)^2\f$ with the typical distance \f$\sigma\f$ of the points from the planes of
        their neighbours, measured in cells}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{500}
    \cgalParamNEnd
    \cgalParamNBegin{normal_weight}
      \cgalParamDescription{weight of the normals as gradients of the field at the points; 0: the skeleton alone tells
        inside from outside. Not negative}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{10; with 5 unseen parts are less exact, with 20 near parts join more often}
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
  settings.sharpness_angle = parameter_or(np, tags::sharpness_angle, settings.sharpness_angle);
  settings.upsampling_factor = parameter_or(np, tags::upsampling_factor, settings.upsampling_factor);
  settings.segmentation.method =
    enumerator(function, np, tags::segmentation_method, "segmentation_method", settings.segmentation.method,
               Point_set_consolidation_3::Segmentation_method::SKELETON);
  settings.segmentation.skeleton.count =
    parameter_or(np, tags::number_of_segments, std::size_t(0));
  settings.field.resolution = parameter_or(np, tags::grid_resolution, settings.field.resolution);
  settings.field.surface_weight = parameter_or(np, tags::surface_weight, settings.field.surface_weight);
  settings.field.normal_weight = parameter_or(np, tags::normal_weight, settings.field.normal_weight);
  if constexpr(has_parameter<NP, tags::segment_methods_t>) {
    const auto methods = CGAL::parameters::get_parameter(np, tags::segment_methods);
    for(const auto& method : dereferenced(methods)) {
      require(is_enumerator(method, Point_set_consolidation_3::Part_method::SKELETON), function,
              "segment_methods has a value that is none of the methods");
      settings.methods.push_back(method);
    }
  }
  require(settings.sharpness_angle > 0 && settings.sharpness_angle < 90, function,
          "sharpness_angle must be in (0, 90)");
  require(settings.upsampling_factor >= 1 && settings.upsampling_factor <= 100, function,
          "upsampling_factor must be in [1, 100]");
  require(settings.field.resolution >= 8 && settings.field.resolution <= 1024, function,
          "grid_resolution must be in [8, 1024]");
  require(settings.field.surface_weight > 0 && std::isfinite(settings.field.surface_weight), function,
          "surface_weight must be positive");
  require(settings.field.normal_weight >= 0 && std::isfinite(settings.field.normal_weight), function,
          "normal_weight must not be negative");
  const Skeleton_graph given = to_skeleton_graph<Kernel>(skeleton);
  for(const Skeleton_node& node : given.nodes)
    require(node.position.allFinite() && std::isfinite(node.radius) && node.radius >= 0, function,
            "a vertex of the skeleton is not finite or has a negative radius");

  Feature_enhanced_result result;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    result = reconstruct_feature_enhanced(execution, world, normals, given, settings);
  });
  if(!is_complete)
    return false;
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
  \param named_parameters an optional sequence of named parameters: `point_map`, `normal_map` (outward; without it
  normals are estimated), `callback` and `stage_times` as in `feature_enhanced_surface_reconstruction()`, `geom_traits`.

  \return `output` past the last point; nothing is written if the callback stops the call.
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
  Points normals = copy_normals(function, points, np);
  if(!normals.empty())
    normals = copy_unit_normals(function, points, np);
  Oriented_points completed;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    completed = complete_along(execution, world, normals, graph, trusts_all);
  });
  if(!is_complete)
    return output;
  return write_oriented<Kernel>(completed.points, completed.normals, output);
}

}  // namespace CGAL

#endif  // CGAL_FEATURE_ENHANCED_SURFACE_RECONSTRUCTION_H
