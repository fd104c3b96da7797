// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_ANISOTROPIC_EDGE_AWARE_UPSAMPLE_POINT_SET_H
#define CGAL_ANISOTROPIC_EDGE_AWARE_UPSAMPLE_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

#include <utility>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  optimises the normals of a point set such that near a sharp edge they belong to one of the surfaces that meet
  there instead of to their mean (sections III.B and VI of the feature-enhanced surfaces paper
  \cgalCite{cgal:wfglchc-fes-18}).

  A point takes the plane of the neighbourhood around it that does not straddle an edge; then normals are
  averaged within clusters. With `enhance_features(true)` positions are denoised in the same way.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `Range` whose iterator is a `ForwardIterator`.

  \param points at least 10 points with finite coordinates. Their normals are replaced.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{normals; the given ones tell the sides if none of them is zero, otherwise sides are found
        as in Section \ref PSC3Orientation}
      \cgalParamType{a model of `ReadWritePropertyMap` with value type `geom_traits::Vector_3`}
    \cgalParamNEnd
    \cgalParamNBegin{sharpness_angle}
      \cgalParamDescription{\f$\alpha\f$ of equation (5): normals that differ by more are not averaged, degrees, (0,
        90)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{20}
    \cgalParamNEnd
    \cgalParamNBegin{enhance_features}
      \cgalParamDescription{whether points move to the surface of their cluster as well; needs a writable `point_map`}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
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

  \return `false` if the callback cancelled; then nothing has changed.
  \throws std::invalid_argument if there are too few points, no normal map, a value is not finite, most
  points coincide, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
bool optimize_normals_across_edges(PointRange& points, const NamedParameters& named_parameters
                                                         = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  const char* function = "optimize_normals_across_edges";
  const auto& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;

  const Points world = copy_points(function, points, np, least_points);
  const Points normals = copy_normals(function, points, np);
  require(!normals.empty(), function, "needs a normal_map");
  Feature_parameters parameters;
  parameters.oriented = true;
  parameters.sharpness_angle = parameter_or(np, tags::sharpness_angle, 20.);
  require(parameters.sharpness_angle > 0 && parameters.sharpness_angle < 90, function,
          "sharpness_angle must be in (0, 90)");
  const bool moves = parameter_or(np, tags::enhance_features, false);

  Oriented_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    result = separate_at_edges(execution, world, normals, parameters);
  });
  if(!is_complete)
    return false;
  put_points(points, np, moves ? result.points : world, result.normals);
  return true;
}

/*!
  \ingroup PkgPointSetConsolidation3Operators

  adds points in the sparsest places and at sharp edges: the anisotropic edge-aware up-sampling of section III.B
  of the feature-enhanced surfaces paper \cgalCite{cgal:wfglchc-fes-18}.

  Insertion bases lie between neighbouring points, rated by equation (5): the distance to the normal lines
  around, raised between points whose normals differ. A base is projected with the weights of equation (6), with
  the normal of the two that fits better; a point that would go beyond an edge returns to it. Bases
  are inserted in rounds, rated together, so that the result is the same, bit for bit, for any
  `ConcurrencyTag` and number of threads.

  Complexity: \f$O(N \log N)\f$ per round for N output points; the number of rounds is logarithmic in the
  factor of growth.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for
  `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`.

  \param points at least 10 points with finite coordinates and normals, best those of
  `anisotropic_wlop_simplify_and_regularize_point_set()`: normals that are smooth across edges have no edges.
  \param output receives the given points, then the new ones; nothing is written if the callback cancels.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals, not zero; required}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_output_points}
      \cgalParamDescription{number of points wanted; fewer if there is no place between points closer than
        `neighbor_radius`}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{four times the number of points}
    \cgalParamNEnd
    \cgalParamNBegin{upsampling_formula}
      \cgalParamDescription{how new points are projected}
      \cgalParamType{`Point_set_consolidation_3::Upsampling_formula`}
      \cgalParamDefault{`Upsampling_formula::WEIGHTED`; equation (6) has no decay with the distance and is better with
        exact normals only}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{new points lie between points at most so far apart, in the unit of the input}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{3 spacings of the input}
    \cgalParamNEnd
    \cgalParamNBegin{sharpness_angle}
      \cgalParamDescription{\f$\alpha\f$ of equation (5), degrees, (0, 90)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{20}
    \cgalParamNEnd
    \cgalParamNBegin{edge_sensitivity}
      \cgalParamDescription{bases are rated \f$(2 - n^T n')^s\f$ times higher; 0 samples evenly, 1 strongly at edges;
        not negative}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.5}
    \cgalParamNEnd
    \cgalParamNBegin{plane_width}
      \cgalParamDescription{\f$\sigma_p\f$ of equation (4), in the unit of the input}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{the spacing of the input}
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

  \return `output` past the last point.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, a normal is
  zero, most points coincide, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator anisotropic_edge_aware_upsample_point_set(
  const PointRange& points, OutputIterator output,
  const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  typedef Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  const char* function = "anisotropic_edge_aware_upsample_point_set";
  const NP& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;

  const Points world = copy_points(function, points, np, least_points);
  const Points normals = copy_unit_normals(function, points, np);
  Edge_aware_parameters parameters;
  parameters.oriented = true;
  parameters.formula = enumerator(function, np, tags::upsampling_formula, "upsampling_formula",
                                  parameters.formula, Point_set_consolidation_3::Upsampling_formula::EDGES);
  parameters.number_of_points =
    parameter_or(np, tags::number_of_output_points, 4 * world.size());
  parameters.neighbor_radius = parameter_or(np, tags::neighbor_radius, 0.);
  parameters.sharpness_angle = parameter_or(np, tags::sharpness_angle, 20.);
  parameters.edge_sensitivity = parameter_or(np, tags::edge_sensitivity, parameters.edge_sensitivity);
  parameters.plane_width = parameter_or(np, tags::plane_width, 0.);
  require(parameters.number_of_points >= world.size(), function,
          "number_of_output_points must be at least the number of points");
  require(parameters.neighbor_radius >= 0 && std::isfinite(parameters.neighbor_radius), function,
          "neighbor_radius must not be negative");
  require(parameters.sharpness_angle > 0 && parameters.sharpness_angle < 90, function,
          "sharpness_angle must be in (0, 90)");
  require(parameters.edge_sensitivity >= 0 && std::isfinite(parameters.edge_sensitivity), function,
          "edge_sensitivity must not be negative");
  require(parameters.plane_width >= 0 && std::isfinite(parameters.plane_width), function,
          "plane_width must not be negative");

  Oriented_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    result = upsample_at_edges(execution, world, normals, parameters);
  });
  if(!is_complete)
    return output;
  return write_oriented<Traits>(result.points, result.normals, output);
}

}  // namespace CGAL

#endif  // CGAL_ANISOTROPIC_EDGE_AWARE_UPSAMPLE_POINT_SET_H
