// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERPOLATORY_UPSAMPLE_POINT_SET_H
#define CGAL_INTERPOLATORY_UPSAMPLE_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

#include <utility>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  inserts points into oriented points by interpolatory refinement, section IV-D of
  \cgalCite{cgal:lcw-icupc-12} after \cgalCite{cgal:gbp-irrtpg-05}: a \f$\sqrt{3}\f$-like subdivision without
  connectivity. The points stay where they are; a triangle of a point and two successive points of its ring gets a
  new point at its centroid, bulged by the normals, unless another point is closer than the minimum
  spacing. On spheres the new points are exact to second order.

  Gaps of more than 135 degrees stay open, so that borders stay; holes of a radius up to 0.7 times
  `neighbor_radius` are closed. The input is neither changed nor reordered; the result does not depend on unit
  and origin of the coordinates. Complexity: linear in the number of points, input and new, for evenly
  spread points.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`.

  \param points points with finite coordinates and oriented normals.
  \param output receives the new points with their unit normals; nothing if the callback cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals of any length except zero}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamExtra{Required, unless the range carries normals itself as `Point_set_3` does.}
    \cgalParamNEnd
    \cgalParamNBegin{minimum_spacing}
      \cgalParamDescription{\f$d_{min}\f$: no point is inserted closer to another, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1 times `neighbor_radius`: about four times the number of points}
      \cgalParamExtra{With the printed 1/3 nothing is inserted between evenly spread points.}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{\f$h\f$: largest radius of a ring, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{twice the median over the points of the mean distance to 20 others}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_output_points}
      \cgalParamDescription{largest number of points to insert}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{no limit but 1000 per point}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{points that are no centres of refinement; they may be in rings}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
      \cgalParamDefault{none}
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

  \return `output` past the last new point.
  \throws std::invalid_argument if there is no normal map, a coordinate is not finite, a normal is zero or a
  parameter is out of its range.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
interpolatory_upsample_point_set(const PointRange& points, OutputIterator output,
                                 const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  typedef Point_set_consolidation_3::internal::Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  const char* const function = "interpolatory_upsample_point_set";
  const auto& pack = cgal_np(np);

  const Points positions = copy_points(function, points, pack, 0);
  const Points normals = copy_unit_normals(function, points, pack);
  const std::vector<char> is_constrained = copy_constrained(points, pack);
  Upsampling_parameters parameters;
  parameters.support_radius =
    not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);
  parameters.least_distance = not_negative(function, pack, names::minimum_spacing, "minimum_spacing", 0);
  parameters.most_points =
    parameter_or(pack, CGAL::internal_np::number_of_output_points, parameters.most_points);
  if(positions.size() < 3)
    return output;

  Moved_points inserted;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    inserted = upsample_by_interpolation(execution, positions, normals, is_constrained, parameters);
  });
  if(!is_complete)
    return output;
  return write_oriented<Traits>(inserted.points, inserted.normals, output);
}

}  // namespace CGAL

#endif  // CGAL_INTERPOLATORY_UPSAMPLE_POINT_SET_H
