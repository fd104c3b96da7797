// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_ANISOTROPIC_WLOP_SIMPLIFY_AND_REGULARIZE_POINT_SET_H
#define CGAL_ANISOTROPIC_WLOP_SIMPLIFY_AND_REGULARIZE_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

#include <utility>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  simplifies, regularises and denoises a point set without rounding its sharp edges: the anisotropic locally
  optimal projection of section III.A of the feature-enhanced surfaces paper \cgalCite{cgal:wfglchc-fes-18}.

  By default it goes beyond the paper. First the normals are optimised so that they belong to one of the
  clusters at an edge, and every input point is moved to the surface of its cluster; then a random subset is
  projected by equation (3) within clusters: attraction across the surface only, repulsion along it up to the
  edges, where points are held. The printed equations are available by `anisotropic_formula()`.

  The input is neither changed nor reordered. The result is the same, bit for bit, for any `ConcurrencyTag`
  and number of threads. Complexity: \f$O(n \log n)\f$ for the normals, linear in the number of output points
  for each iteration; `PRINTED` is quadratic.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for
  `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`: points with unit normals.

  \param points at least 10 points with finite coordinates.
  \param output receives points and normals; nothing is written if the callback cancels.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
    below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{oriented normals; with `enhance_features(true)` only their sides are used}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: planes fitted to 18 neighbours, oriented as in Section \ref PSC3Orientation}
    \cgalParamNEnd
    \cgalParamNBegin{select_percentage}
      \cgalParamDescription{percentage of points to keep, in (0, 100]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{5, as `CGAL::wlop_simplify_and_regularize_point_set()`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_output_points}
      \cgalParamDescription{the same as a number; precedence over `select_percentage`}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{anisotropic_formula}
      \cgalParamDescription{reading of the paper's equations}
      \cgalParamType{`Point_set_consolidation_3::Anisotropic_formula`}
      \cgalParamDefault{`Anisotropic_formula::SEPARATED`; on CAD models with noise the others have more than twice
        its error}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{support radius \f$h\f$ of \f$\theta(r) = e^{-16 r^2/h^2}\f$, in the unit of the input}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{`SEPARATED`: 4 spacings of the result. `PRINTED`: \f$4\, d_{bb}/\sqrt{|J|}\f$ (the
        printed \f$4\sqrt{d_{bb}/|J|}\f$ is no length). `LOCAL`: three times that}
      \cgalParamExtra{CGAL's WLOP uses \f$e^{-4 r^2/h^2}\f$: its radius h is 2 h here.}
    \cgalParamNEnd
    \cgalParamNBegin{plane_width}
      \cgalParamDescription{\f$\sigma_p\f$ of the tangent plane weight, equation (4), in the unit of the input}
      \cgalParamType{floating scalar value, not negative; 0 for the default}
      \cgalParamDefault{\f$d_{bb}/\sqrt{|J|}\f$; `SEPARATED`: the spacing of the input}
    \cgalParamNEnd
    \cgalParamNBegin{repulsion_weight}
      \cgalParamDescription{\f$\mu\f$ of equation (3), in [0, 0.5)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.4 as in the paper; `SEPARATED`: 0.15, more drives points onto the edges}
    \cgalParamNEnd
    \cgalParamNBegin{sharpness_angle}
      \cgalParamDescription{\f$\alpha\f$: normals that differ by more belong to different clusters, degrees, (0, 90)}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{20}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{iterations of equation (3)}
      \cgalParamType{unsigned int}
      \cgalParamDefault{20, as in figure 2 of the paper}
    \cgalParamNEnd
    \cgalParamNBegin{enhance_features}
      \cgalParamDescription{whether normals are optimised and points denoised first}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true` for `SEPARATED`, `false` otherwise}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{seed of the subset to start from}
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

  \return `output` past the last point.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, most points
  coincide, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator anisotropic_wlop_simplify_and_regularize_point_set(
  const PointRange& points, OutputIterator output,
  const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace tags = Point_set_consolidation_3::internal_np;
  typedef Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  const char* function = "anisotropic_wlop_simplify_and_regularize_point_set";
  const NP& np = cgal_np(named_parameters);
  constexpr std::size_t least_points = 10;

  const Points world = copy_points(function, points, np, least_points);
  Points normals = copy_normals(function, points, np);
  if(!normals.empty())
    normals = copy_unit_normals(function, points, np);

  Projection_settings settings;
  Anisotropic_wlop_parameters& wlop = settings.wlop;
  wlop.formula = enumerator(function, np, tags::anisotropic_formula, "anisotropic_formula", wlop.formula,
                            Point_set_consolidation_3::Anisotropic_formula::SEPARATED);
  wlop.support_radius = parameter_or(np, tags::neighbor_radius, 0.);
  wlop.plane_width = parameter_or(np, tags::plane_width, 0.);
  wlop.repulsion = parameter_or(np, tags::repulsion_weight, wlop.repulsion);
  wlop.sharpness_angle = parameter_or(np, tags::sharpness_angle, 20.);
  wlop.iterations = parameter_or(np, tags::number_of_iterations, wlop.iterations);
  settings.repulsion_is_given = has_parameter<NP, tags::repulsion_weight_t>;
  settings.enhances_features =
    parameter_or(np, tags::enhance_features,
                 wlop.formula == Point_set_consolidation_3::Anisotropic_formula::SEPARATED);
  settings.seed = parameter_or(np, tags::random_seed, std::uint64_t(0));
  const double percentage = parameter_or(np, tags::select_percentage, 5.);
  require(percentage > 0 && percentage <= 100, function, "select_percentage must be in (0, 100]");
  settings.count = parameter_or(
    np, tags::number_of_output_points,
    (std::max)(std::size_t(1), std::size_t(std::round(percentage / 100 * double(world.size())))));
  require(settings.count > 0 && settings.count <= world.size(), function,
          "number_of_output_points must be at least 1 and at most the number of points");
  require(wlop.support_radius >= 0 && std::isfinite(wlop.support_radius), function,
          "neighbor_radius must not be negative");
  require(wlop.plane_width >= 0 && std::isfinite(wlop.plane_width), function,
          "plane_width must not be negative");
  require(wlop.repulsion >= 0 && wlop.repulsion < 0.5, function,
          "repulsion_weight must be in [0, 0.5)");
  require(wlop.sharpness_angle > 0 && wlop.sharpness_angle < 90, function,
          "sharpness_angle must be in (0, 90)");

  Oriented_points result;
  const bool is_complete = run_core<ConcurrencyTag>(function, np, [&](Execution& execution) {
    result = simplify_anisotropically(execution, world, normals, settings);
  });
  if(!is_complete)
    return output;
  return write_oriented<Traits>(result.points, result.normals, output);
}

}  // namespace CGAL

#endif  // CGAL_ANISOTROPIC_WLOP_SIMPLIFY_AND_REGULARIZE_POINT_SET_H
