// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEEP_POINTS_CONSOLIDATE_POINT_SET_H
#define CGAL_DEEP_POINTS_CONSOLIDATE_POINT_SET_H

#include <CGAL/Deep_points_consolidation_3.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Completion

  consolidates and completes a point set by deep points \cgalCite{cgal:wshcl-dpc-15}: each point of the
  denoised set gets an inner point on the meso-skeleton, a mixture of curves and sheets; joint optimisation of
  both ends spreads the outer points over the surface, missing regions included.

  The input may be unoriented, noisy, unevenly spread and incomplete. It is neither changed nor
  reordered. The result is the same, bit for bit, for any `ConcurrencyTag` and number of threads, and does
  not depend on the unit and origin of the coordinates.

  Complexity: linear in the number of input points and of deep points for given densities; about 100
  microseconds for each of them.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `Deep_point_3<Geom_traits>`.

  \param points at least 10 points with finite coordinates.
  \param output receives the deep points; nothing is written if the callback cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{rough normals; they only tell which side is outside}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: sides are found from the points, see Section \ref PSC3Orientation}
    \cgalParamNEnd
    \cgalParamNBegin{view_direction_map}
      \cgalParamDescription{directions from the points towards the scanner; they orient the normals and keep
        completed points out of space that rays have passed}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none; a scan that can have been taken from one side is taken for one}
      \cgalParamExtra{Precedence over `normal_map`. Not zero.}
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
    \cgalParamNBegin{missed_rays}
      \cgalParamDescription{rays that met nothing: a point on each, and the index of its view. Without them all of a
        view's image that has no data, but for gaps of the sampling, is taken for seen through; with them only
        where they passed, so that dropouts of the scanner are completed}
      \cgalParamType{a range of `std::pair<geom_traits::Point_3, std::size_t>`}
      \cgalParamDefault{not known}
      \cgalParamExtra{Needs `view_direction_map` or `scanner_positions`.}
    \cgalParamNEnd
    \cgalParamNBegin{denoise_along_rays}
      \cgalParamDescription{whether noisy views are denoised along their rays before all else, see Section \ref
        PSC3Denoising; the paper consolidates the points as they are}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`; without effect if the direction of the scanner is neither given nor found}
    \cgalParamNEnd
    \cgalParamNBegin{detect_outliers}
      \cgalParamDescription{whether points that belong to no surface are left out before all else: those at least 3.5
        times as far from their neighbours as usual, or 2.5 times as far as the points around them are from theirs,
        that do not lie on the plane of these. If they are less than 0.5 % of all, only those twelve times as far; if
        they are more than 25 %, none. Noisy views are searched once more when they are denoised}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
      \cgalParamExtra{Constrained points are no outliers, and sets of less than 100 points have none.}
    \cgalParamNEnd
    \cgalParamNBegin{outlier_output_iterator}
      \cgalParamDescription{receives the indices of the outliers in the range, in increasing order}
      \cgalParamType{a model of `OutputIterator` that accepts `std::size_t`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_output_points}
      \cgalParamDescription{number of consolidated points, each of which becomes a deep point}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{5 % of the input, at least 4000}
      \cgalParamExtra{At most the number of input points.}
    \cgalParamNEnd
    \cgalParamNBegin{select_percentage}
      \cgalParamDescription{the same as a percentage of the input, in (0, 100]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{none; `number_of_output_points` goes first}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{support radius of WLOP, in the unit of the input}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{twice the spacing to be expected of the consolidated points: larger radii draw
        opposite sheets together}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{iterations of WLOP}
      \cgalParamType{unsigned int}
      \cgalParamDefault{35}
    \cgalParamNEnd
    \cgalParamNBegin{require_uniform_sampling}
      \cgalParamDescription{whether WLOP weighs the input by its density; scans are thin where the surface
        turns away from the scanner, and uneven particles sink to a biased skeleton}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`; about half of WLOP's time}
    \cgalParamNEnd
    \cgalParamNBegin{collision_angle}
      \cgalParamDescription{\f$\omega\f$: fronts whose normals differ by more meet and settle, degrees, (0, 170]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{45}
    \cgalParamNEnd
    \cgalParamNBegin{smoothing_radius}
      \cgalParamDescription{\f$\sigma_p\f$: radius of neighbourhoods on the surface, in units of r, (0, 50]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{5}
    \cgalParamNEnd
    \cgalParamNBegin{collision_radius}
      \cgalParamDescription{\f$\sigma_q\f$: radius of neighbourhoods of inner points, in units of r, (0, 50]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{2}
    \cgalParamNEnd
    \cgalParamNBegin{closing_step}
      \cgalParamDescription{whether settled points go on to where the colliding fronts touch; makes the
        meso-skeleton two to five times more accurate (not in the paper)}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{skeleton_repulsion}
      \cgalParamDescription{\f$\mu\f$: repulsion of inner points along the skeleton, equation (5), not negative}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.4}
    \cgalParamNEnd
    \cgalParamNBegin{axis_epsilon}
      \cgalParamDescription{\f$\epsilon\f$: bounds the semi-axes of neighbourhoods by \f$r/\epsilon\f$, at least 0.01}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_skeleton_iterations}
      \cgalParamDescription{iterations that form the meso-skeleton}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{10}
    \cgalParamNEnd
    \cgalParamNBegin{surface_repulsion}
      \cgalParamDescription{\f$\hat\mu\f$: repulsion of outer points in the tangent plane, equation (7), not negative;
        cooled down over the last third of the iterations}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.4}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_surface_iterations}
      \cgalParamDescription{iterations that spread the outer points, at most: they end when the fronts
        stand still. Points amid the data move in every third iteration}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{90: the fronts of half a tube of 60 r around have met}
    \cgalParamNEnd
    \cgalParamNBegin{completed_spacing}
      \cgalParamDescription{spacing to which completed regions are filled, in units of r, 0 or at least 0.2.
        Spreading leaves them 2 to 6 r sparse; inserted points take their distance from the meso-skeleton
        from their neighbours, as in equation (8), and follow the consolidated ones in the output. 0: no
        insertion, as many deep points as consolidated points, as in the paper}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{1}
    \cgalParamNEnd
    \cgalParamNBegin{data_term}
      \cgalParamDescription{how outer points are drawn to the data, equation (6)}
      \cgalParamType{`Point_set_consolidation_3::Data_term`}
      \cgalParamDefault{`Data_term::FULL`}
    \cgalParamNEnd
    \cgalParamNBegin{prior}
      \cgalParamDescription{what is assumed where data are missing, equations (8) and (9), or a plane through
        the border}
      \cgalParamType{`Point_set_consolidation_3::Prior`}
      \cgalParamDefault{`Prior::VOLUME_PRESERVING`}
    \cgalParamNEnd
    \cgalParamNBegin{prior_map}
      \cgalParamDescription{a prior per input point, for the region around it}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Point_set_consolidation_3::Prior`}
      \cgalParamDefault{`prior` everywhere}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{regions that stay as WLOP leaves them}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
      \cgalParamDefault{nothing is constrained}
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

  \return `output` past the last deep point.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, most points
  coincide, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
deep_points_consolidate_point_set(const PointRange& points, OutputIterator output,
                                  const NamedParameters& np = parameters::default_values())
{
  typedef Point_set_consolidation_3::internal::Cgal_np<NamedParameters> NP;
  typedef typename Point_set_consolidation_3::internal::Np_helper<PointRange, NP>::Geom_traits Traits;
  Deep_points_consolidation_3<Traits, ConcurrencyTag> consolidation(points, np, "deep_points_consolidate_point_set");
  const bool is_complete = consolidation.consolidate_outer_points();
  Point_set_consolidation_3::internal::report_stage_times(
    Point_set_consolidation_3::internal::cgal_np(np), consolidation.stage_times());
  if(!is_complete)
    return output;
  Point_set_consolidation_3::internal::write_to(
    Point_set_consolidation_3::internal::cgal_np(np),
    Point_set_consolidation_3::internal_np::outlier_output_iterator, consolidation.outliers());
  return consolidation.deep_points(output);
}

}  // namespace CGAL

#endif  // CGAL_DEEP_POINTS_CONSOLIDATE_POINT_SET_H
