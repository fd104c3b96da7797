// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APSS_PROJECT_POINT_SET_H
#define CGAL_APSS_PROJECT_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  projects points onto the algebraic point set surface that they define themselves
  \cgalCite{cgal:gg-apss-07}: the moving least squares surface whose primitives are spheres fitted to positions
  and normals. Noise of positions is smoothed with little shrinkage, because spheres follow curvature. Positions and
  normals are replaced.

  The fit is the closed form of appendix II of \cgalCite{cgal:lcw-icupc-12} for \f$\beta \to \infty\f$, from which
  the printed \f$\beta = 10^6 h^2\f$ does not differ measurably. Neighbours whose normals oppose that of the
  point are left out, so that thin parts do not collapse. A point stays where the surface is not
  defined: fewer than three neighbours in the support, or a projection that leaves it.

  The result does not depend on unit and origin of the coordinates. Complexity: the number of points times that
  of the neighbours in the support, for each iteration.

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
      \cgalParamDescription{\f$h\f$: support of the fits, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{4 times the spacing, the median over the points of the mean distance to six others}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{fits per point; it stops before where the point does not move}
      \cgalParamType{unsigned int}
      \cgalParamDefault{3}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{points that stay; they define the surface like the others}
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

  \return the number of points that were projected; 0, and nothing is changed, if the callback cancels.
  \throws std::invalid_argument if there is no normal map, a coordinate is not finite, a normal is zero or a
  parameter is out of its range.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t apss_project_point_set(PointRange& points,
                                   const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  const char* const function = "apss_project_point_set";
  const auto& pack = cgal_np(np);

  const Points input = copy_points(function, points, pack, 0);
  const Points normals = copy_unit_normals(function, points, pack);
  const std::vector<char> is_constrained = copy_constrained(points, pack);
  const unsigned int iterations =
    parameter_or(pack, CGAL::internal_np::number_of_iterations, 3u);
  require(iterations <= 1000, function, "number_of_iterations is too large");

  const double radius =
    not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);

  Moved_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    result = project_to_algebraic_surface(execution, input, normals, is_constrained, radius, iterations);
  });
  if(!is_complete)
    return 0;
  put_points(points, pack, result.points, result.normals);
  return result.number;
}

}  // namespace CGAL

#endif  // CGAL_APSS_PROJECT_POINT_SET_H
