// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
#define CGAL_EXTRACT_L1_MEDIAL_SKELETON_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  extracts the L1-medial curve skeleton of a point set, equation (8) of the feature-enhanced surfaces paper
  \cgalCite{cgal:wfglchc-fes-18}: as a whole, or of each segment.

  Samples move to the L1 medians of growing balls, repelled along the curves that form, until their
  surroundings are curves; the graph comes from the neighbourhoods that the samples had on the surface.
  It suits thin, tubular and incomplete point sets. For others `extract_laplacian_contraction_skeleton()` is
  faster and better centred: samples in a fat body are not drawn to a curve by any ball smaller than it.

  The result is the same, bit for bit, for any `ConcurrencyTag` and number of threads. Complexity:
  \f$O(m\, n)\f$ for each of about a hundred iterations, with m samples and n points, at most 2500.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam Kernel a model of `Kernel`, floating point coordinates.

  \param points at least 10 points with finite coordinates.
  \param skeleton receives the skeleton; unchanged if the callback cancels.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{segment_map}
      \cgalParamDescription{number of each point's segment: the skeleton of each segment is extracted by itself;
        those of segments that touch are joined by an edge between their nearest vertices, without cycles}
      \cgalParamType{a model of `ReadablePropertyMap` with an integer value type, values from 0}
      \cgalParamDefault{none: one skeleton}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_samples}
      \cgalParamDescription{number of samples, at least 10}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{700}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{\f$h_0\f$, support radius of \f$\theta(r) = e^{-16 r^2/h^2}\f$ at the start, in the unit
        of the input; it grows by half of it until half the diagonal}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{\f$2\, d_{bb}/\sqrt[3]{n}\f$}
    \cgalParamNEnd
    \cgalParamNBegin{repulsion_weight}
      \cgalParamDescription{\f$\mu\f$ of equation (8), in [0, 0.5)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.35}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{largest number of iterations at one radius}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{10}
    \cgalParamNEnd
    \cgalParamNBegin{sampling_radius}
      \cgalParamDescription{distance of the vertices before thinning, as a share of the diagonal, in [0.001, 1]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.02}
    \cgalParamNEnd
    \cgalParamNBegin{largest_merged_cycle}
      \cgalParamDescription{cycles of at most so many vertices are merged to one; 0 keeps all}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{6}
    \cgalParamNEnd
    \cgalParamNBegin{extend_tips}
      \cgalParamDescription{whether tips are extended to the end of the shape, by a vertex of radius 0}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{seed of the choice of points from larger sets}
      \cgalParamType{`std::uint64_t`}
      \cgalParamDefault{0}
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
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, all points are
  equal, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename Kernel,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(const PointRange& points, Curve_skeleton_3<Kernel>& skeleton,
                                const NamedParameters& named_parameters
                                  = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  typedef Cgal_np<NamedParameters> NP;
  const char* function = "extract_l1_medial_skeleton";
  const NP& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;

  const Points world = copy_points(function, points, np, least_points);
  const double diagonal = bounding_box(world).diagonal();
  require(diagonal > 0, function, "all points are equal");
  L1_medial_parameters parameters;
  parameters.samples = parameter_or(np, tags::number_of_samples, parameters.samples);
  const double radius = parameter_or(np, tags::neighbor_radius, 0.);
  parameters.initial_radius = radius / diagonal;
  parameters.repulsion = parameter_or(np, tags::repulsion_weight, parameters.repulsion);
  parameters.inner_iterations =
    parameter_or(np, tags::number_of_iterations, parameters.inner_iterations);
  parameters.sampling_radius = parameter_or(np, tags::sampling_radius, parameters.sampling_radius);
  parameters.largest_merged_cycle =
    parameter_or(np, tags::largest_merged_cycle, parameters.largest_merged_cycle);
  parameters.extend_tips = parameter_or(np, tags::extend_tips, parameters.extend_tips);
  parameters.seed = parameter_or(np, tags::random_seed, parameters.seed);
  require(parameters.samples >= least_points, function, "number_of_samples must be at least 10");
  require(radius >= 0 && std::isfinite(radius), function, "neighbor_radius must not be negative");
  require(radius == 0 || parameters.initial_radius >= 1e-3, function,
          "neighbor_radius must be at least a thousandth of the diagonal");
  require(parameters.repulsion >= 0 && parameters.repulsion < 0.5, function,
          "repulsion_weight must be in [0, 0.5)");
  require(parameters.sampling_radius >= 0.001 && parameters.sampling_radius <= 1, function,
          "sampling_radius must be in [0.001, 1]");

  std::vector<std::size_t> labels;
  std::size_t segments = 0;
  if constexpr(has_parameter<NP, tags::segment_t>) {
    const auto map = CGAL::parameters::get_parameter(np, tags::segment_map);
    for_each_indexed(points, [&](const auto& key, std::size_t) {
      const long long label = (long long)(get(map, key));
      require(label >= 0 && std::size_t(label) < world.size(), function,
              "segment_map has a value that is negative or not below the number of points");
      labels.push_back(std::size_t(label));
      segments = (std::max)(segments, labels.back() + 1);
    });
  }

  Skeleton_graph graph;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    graph = extract_l1_skeleton(execution, world, labels, segments, parameters);
  });
  if(!is_complete)
    return false;
  assign<Kernel>(skeleton, graph);
  return true;
}

}  // namespace CGAL

#endif  // CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
