// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_DENSITY_PEAK_SEGMENT_POINT_SET_H
#define CGAL_DENSITY_PEAK_SEGMENT_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  segments a point set into parts (section IV.A of the feature-enhanced surfaces paper
  \cgalCite{cgal:wfglchc-fes-18}).

  The paper's density peaks, equation (7), find parts that differ in density or thickness; on evenly sampled
  surfaces the density is constant up to noise, and a segmentation by the curve skeleton is far
  better: it is the default. Segments are numbered from 0 by falling size. The result is the same, bit for
  bit, for any `ConcurrencyTag` and number of threads.

  Complexity: density peaks and persistence \f$O(n\, m + n \log n)\f$ with m points in a ball of 0.6 h;
  skeleton: see `extract_laplacian_contraction_skeleton()`, at most 5000 points are contracted.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `Range` whose iterator is a `ForwardIterator`; it may be constant if the label
  map does not write into its elements.
  \tparam LabelMap a model of `WritablePropertyMap` with the value type of the range as key and an integer as value
  type.

  \param points at least 4 points with finite coordinates.
  \param label_map receives the number of each point's segment.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{outward normals; they make the radii of skeletons of one-sided scans better}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_segments}
      \cgalParamDescription{number of segments; 0: found automatically. `DENSITY_PEAKS`: the centres of highest
        \f$\log\nu+\log\delta\f$; the others merge segments, so that there may be fewer}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{0: `DENSITY_PEAKS` up to the largest drop of \f$\log\nu+\log\delta\f$}
    \cgalParamNEnd
    \cgalParamNBegin{segmentation_method}
      \cgalParamDescription{how segments are found}
      \cgalParamType{`Point_set_consolidation_3::Segmentation_method`}
      \cgalParamDefault{`Segmentation_method::SKELETON`}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{h of the density's \f$\theta(r) = e^{-16 r^2/h^2}\f$, in the unit of the input}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{0.15 diagonals of the bounding box}
    \cgalParamNEnd
    \cgalParamNBegin{prominence}
      \cgalParamDescription{`PERSISTENCE`: a peak counts if its logarithm of density is so much above the point where
        its segment meets a higher one; not negative}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1}
    \cgalParamNEnd
    \cgalParamNBegin{variation_penalty}
      \cgalParamDescription{`SKELETON`: \f$\lambda\f$, the price of a cut, against the sum of squared deviations of the
        logarithm of the radius; positive}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.4; results are stable for 0.1 to 0.8}
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

  \return the number of segments; 0 if the callback cancelled.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, or a parameter is
  out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename LabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t density_peak_segment_point_set(
  PointRange& points, LabelMap label_map,
  const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  typedef typename boost::property_traits<LabelMap>::value_type Label;
  const char* function = "density_peak_segment_point_set";
  const auto& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 4;

  const Points world = copy_points(function, points, np, least_points);
  const Points normals = copy_normals(function, points, np);
  Segmentation_settings settings;
  settings.method = enumerator(function, np, tags::segmentation_method, "segmentation_method", settings.method,
                               Point_set_consolidation_3::Segmentation_method::SKELETON);
  settings.radius = parameter_or(np, tags::neighbor_radius, 0.);
  settings.prominence = parameter_or(np, tags::prominence, settings.prominence);
  settings.skeleton.penalty = parameter_or(np, tags::variation_penalty, settings.skeleton.penalty);
  settings.skeleton.count = parameter_or(np, tags::number_of_segments, std::size_t(0));
  require(settings.radius >= 0 && std::isfinite(settings.radius), function,
          "neighbor_radius must not be negative");
  require(settings.prominence >= 0, function, "prominence must not be negative");
  require(settings.skeleton.penalty > 0, function, "variation_penalty must be positive");
  require(settings.skeleton.count <= world.size(), function,
          "number_of_segments must be at most the number of points");

  Segmentation segmentation;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    segmentation = segment_points(execution, world, normals, settings);
  });
  if(!is_complete)
    return 0;
  for_each_indexed(points, [&](auto&& key, std::size_t i) {
    put(label_map, key, Label(segmentation.labels[i]));
  });
  return segmentation.count;
}

}  // namespace CGAL

#endif  // CGAL_DENSITY_PEAK_SEGMENT_POINT_SET_H
