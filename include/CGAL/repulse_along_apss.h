// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REPULSE_ALONG_APSS_H
#define CGAL_REPULSE_ALONG_APSS_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  spreads oriented particles along the algebraic point set surface that they define, section IV-C of
  \cgalCite{cgal:lcw-icupc-12}: particles repel each other, equations (1) and (2), slide along fitted spheres, (3) to
  (5), and are projected back, (6). Inside a region they become even; at its border they move out and extend
  the surface into the missing part, by up to 0.5 \f$h\f$ for the default 10 steps. The surface is that of the
  particles before the call.

  Differences from the print, by tests: the arc length is \f$|l'|\f$, an angle of \f$|l'|/R\f$ instead of
  \f$|l'|/(2 \pi R)\f$; the last term of (1) is left out, it would subtract the position twice; 10 steps per call
  instead of one, which advances by 0.06 \f$h\f$ only; particles on folds and thin parts, whose normals differ from the
  fitted sphere's by more than 0.4 in the mean, stay. `printed_values(true)` restores the first, the
  third and the fourth.

  Complexity: for each step, the number of particles times that of those within \f$h\f$ of one, twice for each
  projection and once for the repulsion.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `Range` whose iterator is a `ForwardIterator`.

  \param points particles, evenly spread, with oriented normals; positions and normals are replaced.
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
      \cgalParamDescription{\f$h\f$: support of the surface and of the repulsion, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{twice the median over the particles of the mean distance to 20 others}
    \cgalParamNEnd
    \cgalParamNBegin{repulsion_weight}
      \cgalParamDescription{\f$\mu\f$, in [0, 0.5)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.45, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_repulsion_steps}
      \cgalParamDescription{steps, at most 1000}
      \cgalParamType{unsigned int}
      \cgalParamDefault{10; 20 advance by 0.7 \f$h\f$ with larger errors}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_projections}
      \cgalParamDescription{projections per step}
      \cgalParamType{unsigned int}
      \cgalParamDefault{1; 3 in the paper, with equal results}
    \cgalParamNEnd
    \cgalParamNBegin{printed_values}
      \cgalParamDescription{whether the defaults are the printed values}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{particles that stay; they act on the others}
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

  \return the mean distance that the moving particles were displaced; 0, and nothing is changed, if the callback
  cancels or there are fewer than two distinct particles.
  \throws std::invalid_argument if there is no normal map, a coordinate is not finite, a normal is zero or a
  parameter is out of its range.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
double repulse_along_apss(PointRange& points,
                          const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  const char* const function = "repulse_along_apss";
  const auto& pack = cgal_np(np);

  const Points particles = copy_points(function, points, pack, 0);
  const Points normals = copy_unit_normals(function, points, pack);
  const std::vector<char> is_constrained = copy_constrained(points, pack);
  const bool printed = parameter_or(pack, names::printed_values, false);
  Repulsion_parameters parameters =
    printed ? Repulsion_parameters::printed() : Repulsion_parameters();
  parameters.repulsion =
    not_negative(function, pack, names::repulsion_weight, "repulsion_weight", parameters.repulsion);
  require(parameters.repulsion < 0.5, function, "repulsion_weight must be less than 0.5");
  parameters.steps =
    parameter_or(pack, names::number_of_repulsion_steps, (unsigned int)(parameters.steps));
  require(parameters.steps <= 1000, function, "number_of_repulsion_steps must be at most 1000");
  parameters.projections =
    parameter_or(pack, names::number_of_projections, (unsigned int)(parameters.projections));
  require(parameters.projections <= 100, function, "number_of_projections must be at most 100");
  parameters.support_radius =
    not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);
  if(particles.size() < 2)
    return 0;

  Moved_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    result = repulse_along_algebraic_surface(execution, particles, normals, is_constrained, parameters);
  });
  if(!is_complete)
    return 0;
  if(!result.points.empty())
    put_points(points, pack, result.points, result.normals);
  return result.distance;
}

}  // namespace CGAL

#endif  // CGAL_REPULSE_ALONG_APSS_H
