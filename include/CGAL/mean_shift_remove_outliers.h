// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEAN_SHIFT_REMOVE_OUTLIERS_H
#define CGAL_MEAN_SHIFT_REMOVE_OUTLIERS_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  removes outliers by the mean shift, section IV-B and algorithm 2 of \cgalCite{cgal:lcw-icupc-12}: each point is
  moved \f$b\f$ times to the mean of its \f$k\f$ nearest points; it is an outlier if it ends farther than
  \f$s\f$ times the mean distance of the \f$k\f$ points around the place where it ends. The threshold is local,
  so that the points may be unevenly spread.

  It finds isolated points and small clusters far from the surface; it is blind to noise that is
  closer than the extent of \f$k\f$ points. Sets of at most \f$k\f$ points have no outliers. The input is neither
  changed nor reordered. Complexity: \f$O(b\,n \log n)\f$ for evenly spread points.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for the value type of the range.

  \param points points with finite coordinates.
  \param output receives copies of the elements that are no outliers, in their order.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{k_neighbors}
      \cgalParamDescription{\f$k\f$, at least 2}
      \cgalParamType{unsigned int}
      \cgalParamDefault{20, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{\f$b\f$; the shift converges quickly}
      \cgalParamType{unsigned int}
      \cgalParamDefault{3, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{shift_threshold}
      \cgalParamDescription{\f$s\f$, positive; 2 finds more outliers and a few good points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{3, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{outlier_output_iterator}
      \cgalParamDescription{receives the indices of the outliers in the range, in increasing order}
      \cgalParamType{a model of `OutputIterator` for `std::size_t`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call, which then writes nothing}
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

  \return `output` past the last element.
  \throws std::invalid_argument if a coordinate is not finite or a parameter is out of its range.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
mean_shift_remove_outliers(const PointRange& points, OutputIterator output,
                           const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  const char* const function = "mean_shift_remove_outliers";
  const auto& pack = cgal_np(np);

  const Points input = copy_points(function, points, pack, 0);
  Mean_shift_parameters parameters;
  parameters.neighbors = parameter_or(pack, names::k_neighbors, 20u);
  require(parameters.neighbors >= 2, function, "k_neighbors must be at least 2");
  parameters.iterations = parameter_or(pack, CGAL::internal_np::number_of_iterations, 3u);
  require(parameters.iterations >= 1, function, "number_of_iterations must be positive");
  parameters.threshold = positive(function, pack, names::shift_threshold, "shift_threshold", 3);

  std::vector<char> is_outlier;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    is_outlier = find_mean_shift_outliers(execution, input, parameters);
  });
  if(!is_complete)
    return output;
  std::vector<std::size_t> outliers;
  for_each_indexed(points, [&](auto&& element, std::size_t i) {
    if(is_outlier[i])
      outliers.push_back(i);
    else
      *output++ = element;
  });
  write_to(pack, names::outlier_output_iterator, outliers);
  return output;
}

}  // namespace CGAL

#endif  // CGAL_MEAN_SHIFT_REMOVE_OUTLIERS_H
