// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BILATERAL_PROJECT_POINT_SET_H
#define CGAL_BILATERAL_PROJECT_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  smooths oriented points by bilateral projection \cgalCite{cgal:hwgca-eapsr-13}: each point moves along its
  normal to the weighted mean height of its neighbours, with weights that fall with distance,
  \f$\theta = e^{-4 d^2 / h^2}\f$, and with the difference of the normals,
  \f$\phi = e^{-((1 - n \cdot n') / (1 - \cos \sigma))^2}\f$. Sharp edges stay sharp: points beyond one do
  not pull. Points do not slide along the surface. Normals are averaged with the same weights before each
  step.

  The result does not depend on unit and origin of the coordinates. Complexity: the number of points times that of
  the neighbours within \f$h\f$, for each iteration.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `Range` whose iterator is a `ForwardIterator`.

  \param points points with finite coordinates and oriented normals.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points, read and written}
      \cgalParamType{a model of `ReadWritePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals of any length except zero, read and written}
      \cgalParamType{a model of `ReadWritePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamExtra{Required, unless the range carries normals itself as `Point_set_3` does.}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{\f$h\f$, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{3 times the spacing, the median over the points of the mean distance to six others}
    \cgalParamNEnd
    \cgalParamNBegin{sharpness_angle}
      \cgalParamDescription{\f$\sigma\f$: normals that differ by more count little, in degrees, (0, 90]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{25, as in `CGAL::bilateral_smooth_point_set()`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{number of projections}
      \cgalParamType{unsigned int}
      \cgalParamDefault{3}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{points that stay; they act on the others}
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

  \return the mean distance that points were displaced; 0, and nothing is changed, if the callback cancels.
  \throws std::invalid_argument if there is no normal map, a coordinate is not finite, a normal is zero or a
  parameter is out of its range.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
double bilateral_project_point_set(PointRange& points,
                                   const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  const char* const function = "bilateral_project_point_set";
  const auto& pack = cgal_np(np);

  const Points input = copy_points(function, points, pack, 0);
  const Points normals = copy_unit_normals(function, points, pack);
  const std::vector<char> is_constrained = copy_constrained(points, pack);
  Bilateral_parameters parameters;
  parameters.sharpness_angle =
    positive(function, pack, CGAL::internal_np::sharpness_angle, "sharpness_angle", 25);
  require(parameters.sharpness_angle <= 90, function, "sharpness_angle must be at most 90");
  parameters.iterations = parameter_or(pack, CGAL::internal_np::number_of_iterations, 3u);
  require(parameters.iterations <= 100000, function, "number_of_iterations is too large");
  parameters.radius = not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);
  if(input.size() < 2)
    return 0;

  Moved_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    result = project_bilaterally_in_place(execution, input, normals, is_constrained, parameters);
  });
  if(!is_complete)
    return 0;
  if(!result.points.empty())
    put_points(points, pack, result.points, result.normals);
  return result.distance;
}

}  // namespace CGAL

#endif  // CGAL_BILATERAL_PROJECT_POINT_SET_H
