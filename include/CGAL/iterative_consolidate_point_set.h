// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ITERATIVE_CONSOLIDATE_POINT_SET_H
#define CGAL_ITERATIVE_CONSOLIDATE_POINT_SET_H

#include <CGAL/Algebraic_point_set_surface_3.h>
#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/scan_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>
#include <CGAL/bilateral_project_point_set.h>
#include <CGAL/interpolatory_upsample_point_set.h>
#include <CGAL/mean_shift_remove_outliers.h>
#include <CGAL/repulse_along_apss.h>
#include <CGAL/wlop_project_point_set.h>

#include <functional>
#include <utility>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Completion

  completes large smooth holes of a point set and removes its outliers by the iterative consolidation of
  \cgalCite{cgal:lcw-icupc-12}: particles sampled from the points are evened out (WLOP, `wlop_project_point_set()`)
  and rid of outliers (`mean_shift_remove_outliers()`); they extend their surface over its borders
  (`repulse_along_apss()`) and are up-sampled (`interpolatory_upsample_point_set()`); what falls into regions
  without points is added, and the step is repeated for what was added last, algorithm 1, until little is added.

  The points themselves are not moved: detail is preserved. The input is neither changed nor reordered. The result is
  the same, bit for bit, for any `ConcurrencyTag` and number of threads, and does not depend on the
  unit and origin of the coordinates.

  It pays for large smooth holes. At thin and occluded parts an extended surface is a wrong guess; therefore
  added points must pass guards that are not in the paper: no ray of the scanner has passed there (if
  directions are known), no sheet of data that faces the other way is near, they rise from the data by
  less than 49 degrees, the regions that they form continue the data's normals at their rim and have data all around
  (no angle of 92 degrees without, seen from their middle), they reach farther than holes that Poisson reconstruction
  closes by itself, and no border is left open. If less than half of what was added passes, all is taken back: then
  the gaps are occlusions rather than holes. What fills a hole is moved at the end onto the smooth surface that
  interpolates the data around it by radial basis functions (`hole_fairing`; not in the paper either): as grown, it has
  the curvature of the rim only. There, points are inserted until they are as dense as the data.

  Outliers are points farther than 0.35 \f$h\f$ from the up-sampled surface, but for patches of at least 30 points
  that are as dense and as smooth as the others (parts seen apart, not in the paper), and nearer ones that lie off the
  quadric that the points around follow, by more than 2.25 times their median residual, and are sparser than these:
  off by 0.073 \f$h\f$ if the distances of their neighbours are 1.35 times those around, by 0.13 \f$h\f$ if 1.2 times,
  by 0.17 \f$h\f$ if not denser. If few near ones are found, less than 1 % of the points or a quarter of the far ones,
  they are no layer of noise but single points out of the space around: those off by 0.1 \f$h\f$ and twice as sparse.
  Nearer ones than \f$h\f$ are kept if all outliers are less than 0.5 % of the points: so many lie on tips and creases
  of clean scans.

  Defaults that differ from the print were chosen by tests; `printed_values(true)` sets the printed ones:
  one repulsion step per iteration with the printed angle, minimum spacing \f$h/3\f$, data are outliers beyond
  \f$h\f$ only, selection at half of the points' spacing, no guards. With them hardly any hole is
  completed: particles advance by 0.01 \f$h\f$ per iteration, and points \f$h/3\f$ apart do not fit between
  evenly spread particles.

  Complexity: linear in the number of points for a given number of particles per point, some
  50 microseconds each on one core; about 300 bytes of memory per point.

  The body scan of the paper is processed in two phases: `two_phases(true)`.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`.

  \param points at least one point, with finite coordinates.
  \param output receives the input points that are no outliers, in their order and place, then the new
  points, with unit normals; nothing if the callback cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals; they are what is written, unless they are only hints}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: normals of quadrics fitted to 18 neighbours, oriented as in Section \ref
        PSC3Orientation and a vote of neighbours}
      \cgalParamExtra{Points with a zero normal get an estimated one.}
    \cgalParamNEnd
    \cgalParamNBegin{orientation_is_hint}
      \cgalParamDescription{whether `normal_map` only tells which side is outside}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{view_direction_map}
      \cgalParamDescription{directions from the points towards the scanner; they orient estimated normals and keep new
        points out of space that rays have passed}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{view_index_map}
      \cgalParamDescription{number of the scanner position that saw a point}
      \cgalParamType{a model of `ReadablePropertyMap` with an integer value type, values from 0}
      \cgalParamDefault{views are found as groups of parallel rays}
    \cgalParamNEnd
    \cgalParamNBegin{scanner_positions}
      \cgalParamDescription{positions of the scanner in the order of the view indices; instead of
        `view_direction_map`}
      \cgalParamType{a range of `geom_traits::Point_3`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{particle_fraction}
      \cgalParamDescription{\f$m/|P^0|\f$: particles per point, in (0, 1]; 1/20 to 1/5 in the paper}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1, but at least 500 particles}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{\f$h\f$: support of all operators, in the unit of the points}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{\f$2 L_{avg}\f$, with the median over the particles instead of the mean, which far outliers
        spoil; kept for all iterations}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{largest number of outer iterations, at most 1000; with 0 only outliers are removed}
      \cgalParamType{unsigned int}
      \cgalParamDefault{10, as in the paper}
      \cgalParamExtra{It stops before if nothing is added, or less than 20 points or a tenth of the largest addition.}
    \cgalParamNEnd
    \cgalParamNBegin{adaptive}
      \cgalParamDescription{whether only particles of the points added last move; else all are sampled anew in each
        iteration, several times slower}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{two_phases}
      \cgalParamDescription{whether all is done without repulsion and with 0.6 \f$h\f$ first, then as usual}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{repulsion_weight}
      \cgalParamDescription{\f$\mu\f$ of WLOP and of the repulsion, in [0, 0.5)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.45, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_repulsion_steps}
      \cgalParamDescription{steps of repulsion per outer iteration, at most 1000; 0: none}
      \cgalParamType{unsigned int}
      \cgalParamDefault{10; with 1, as printed, large holes stay open}
    \cgalParamNEnd
    \cgalParamNBegin{minimum_spacing}
      \cgalParamDescription{\f$d_{min}\f$ of the up-sampling in units of \f$h\f$, at least 0.01}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1: the spacing of the points}
    \cgalParamNEnd
    \cgalParamNBegin{far_outlier_distance}
      \cgalParamDescription{points farther than this from the up-sampled surface are outliers, in units of
        \f$h\f$, but for patches as dense and as smooth as the others}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.35; with 1, as printed, clusters stay}
    \cgalParamNEnd
    \cgalParamNBegin{completion_guard}
      \cgalParamDescription{whether new points must pass the guards}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{hole_fairing}
      \cgalParamDescription{whether the points that fill a hole are moved onto the smooth surface through the data
        around it, and filled up to the density of the data there; not without `completion_guard`}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{printed_values}
      \cgalParamDescription{whether the defaults are the printed values}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{the static region: its points are no outliers, and particles there do not move}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{of the particles}
      \cgalParamType{unsigned int}
      \cgalParamDefault{0}
    \cgalParamNEnd
    \cgalParamNBegin{outlier_output_iterator}
      \cgalParamDescription{receives the indices of the outliers in the range, in increasing order}
      \cgalParamType{a model of `OutputIterator` for `std::size_t`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{completed_output_iterator}
      \cgalParamDescription{receives a flag per element of `output`: whether it is new}
      \cgalParamType{a model of `OutputIterator` for `bool`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{confidence_output_iterator}
      \cgalParamDescription{receives a confidence per element of `output`: 1 for input points, falling with the
        distance from them for new ones}
      \cgalParamType{a model of `OutputIterator` for `double`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{denoised_normal_map}
      \cgalParamDescription{receives the oriented unit normals of all input points; outliers get that of the nearest
        other point}
      \cgalParamType{a model of `WritablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{inconsistent_neighbors}
      \cgalParamDescription{receives the number of pairs of near points on one sheet whose normals point to different
        sides}
      \cgalParamType{`std::reference_wrapper` of a `std::size_t`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{stage_times}
      \cgalParamDescription{receives name, seconds and iterations of each stage}
      \cgalParamType{`std::reference_wrapper` of a `std::vector<Point_set_consolidation_3::Stage_time>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call, which then writes nothing}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{the kernel of the points}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `output` past the last point.
  \throws std::invalid_argument if there is no point, a coordinate is not finite, or a parameter is out of its
  range; the message names it. Points that are too few or too degenerate to work with (at most 20, most of them
  equal) are written as they are.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
iterative_consolidate_point_set(const PointRange& points, OutputIterator output,
                                const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  typedef Point_set_consolidation_3::internal::Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  const char* const function = "iterative_consolidate_point_set";
  const auto& pack = cgal_np(np);

  Iterative_input input;
  input.points = copy_points(function, points, pack, 1);
  input.normals = copy_normals(function, points, pack);
  input.normals_are_hints = parameter_or(pack, names::orientation_is_hint, false);
  input.directions = copy_scan_directions(function, points, input.points, pack);
  input.is_constrained = copy_constrained(points, pack);

  Iterative_parameters parameters = parameter_or(pack, names::printed_values, false)
                                      ? Iterative_parameters::printed()
                                      : Iterative_parameters();
  parameters.particle_fraction = positive(function, pack, names::particle_fraction,
                                          "particle_fraction", parameters.particle_fraction);
  require(parameters.particle_fraction <= 1, function, "particle_fraction must be at most 1");
  parameters.support_radius =
    not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);
  parameters.iterations = parameter_or(pack, CGAL::internal_np::number_of_iterations,
                                       (unsigned int)(parameters.iterations));
  require(parameters.iterations <= 1000, function, "number_of_iterations must be at most 1000");
  parameters.adaptive = parameter_or(pack, names::adaptive, true);
  parameters.two_phases = parameter_or(pack, names::two_phases, false);
  const double mu = not_negative(function, pack, names::repulsion_weight, "repulsion_weight",
                                 parameters.repulsion.repulsion);
  require(mu < 0.5, function, "repulsion_weight must be less than 0.5");
  parameters.wlop.repulsion = parameters.repulsion.repulsion = mu;
  parameters.repulsion.steps = parameter_or(pack, names::number_of_repulsion_steps,
                                            (unsigned int)(parameters.repulsion.steps));
  require(parameters.repulsion.steps <= 1000, function,
          "number_of_repulsion_steps must be at most 1000");
  parameters.upsampling.least_distance = positive(function, pack, names::minimum_spacing,
                                                  "minimum_spacing",
                                                  parameters.upsampling.least_distance);
  require(parameters.upsampling.least_distance >= 0.01, function,
          "minimum_spacing must be at least 0.01");
  parameters.outliers.far_distance = positive(function, pack, names::far_outlier_distance,
                                              "far_outlier_distance",
                                              parameters.outliers.far_distance);
  parameters.guard.enabled =
    parameter_or(pack, names::completion_guard, parameters.guard.enabled);
  parameters.fairs_holes = parameter_or(pack, names::hole_fairing, parameters.fairs_holes);
  parameters.seed = parameter_or(pack, CGAL::internal_np::random_seed, 0u);

  Iterative_result result;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    result = consolidate_iteratively(execution, input, parameters);
  });
  if(!is_complete)
    return output;

  auto point_map = Np_helper<PointRange, NP>::get_const_point_map(points, pack);
  std::vector<std::size_t> outliers;
  for_each_indexed(points, [&](auto&& key, std::size_t i) {
    if(result.is_outlier[i])
      outliers.push_back(i);
    else
      *output++ = std::make_pair(typename Traits::Point_3(get(point_map, key)),
                                 to_vector<Traits>(result.normals[i]));
  });
  output = write_oriented<Traits>(result.new_points, result.new_normals, output);

  const std::size_t kept = input.points.size() - outliers.size();
  std::vector<char> is_new(kept, 0);
  is_new.resize(kept + result.new_points.size(), 1);
  std::vector<double> confidences(kept, 1.);
  confidences.insert(confidences.end(), result.new_confidence.begin(),
                     result.new_confidence.end());
  write_to(pack, names::outlier_output_iterator, outliers);
  write_to(pack, names::completed_output_iterator, is_new);
  write_to(pack, names::confidence_output_iterator, confidences);
  if constexpr(has_parameter<NP, names::denoised_normal_map_t>) {
    auto normal_map = CGAL::parameters::get_parameter(pack, names::denoised_normal_map);
    for_each_indexed(points, [&](auto&& key, std::size_t i) {
      put(normal_map, key, to_vector<Traits>(result.normals[i]));
    });
  }
  if constexpr(has_parameter<NP, names::inconsistent_neighbors_t>)
    CGAL::parameters::get_parameter(pack, names::inconsistent_neighbors).get() =
      result.inconsistent_neighbors;
  return output;
}

}  // namespace CGAL

#endif  // CGAL_ITERATIVE_CONSOLIDATE_POINT_SET_H
