// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLETE_POINT_SET_H
#define CGAL_COMPLETE_POINT_SET_H

#include <CGAL/Deep_points_consolidation_3.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Completion

  completes a point set for meshing: writes points where data are missing, and optionally the denoised,
  oriented positions of the caller's points. Both together go into Poisson reconstruction.

  The deep points of \cgalCite{cgal:wshcl-dpc-15}, section 4.1, give each point of the consolidated set a ball inside
  of the shape. Balls are clipped by the data and by the space that rays have passed; their union is smoothed and
  sampled as densely as the data, farther than six spacings from them: smaller gaps are bridged better by the mesher.
  Narrow gaps between views without noise are closed by Hermite radial basis function surfaces through the data around
  \cgalCite{cgal:mgv-hrbfi-11} where these predict that they are good. If the scan shows that the shape has a mirror
  plane, the measured side completes the other one. This is not the paper's own completion, which
  `deep_points_consolidate_point_set()` offers; it is more accurate on shapes that are no tubes.

  The input is neither changed nor reordered; the result does not depend on `ConcurrencyTag`, bit for bit.

  Complexity: linear in the number of points for a given density; 20000 points took 2.5 seconds on one core, WLOP
  included, and 15 MB above the input (`speed_study`). Grids have at most 3 10^7 nodes of 16 bytes, whatever the
  size of the bounding box.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `Completed_point_3<Geom_traits>` (or
  `Deep_point_3<Geom_traits>`, to which it converts).

  \param points at least 10 points with finite coordinates.
  \param output receives the missing points: `outer()` on the surface, `inner()` the centre of the ball,
  `normal()` outwards, `confidence()`. Nothing is written if the callback cancels, or if nothing is missing.
  \param named_parameters an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`,
  `normal_map`, `view_direction_map`, `view_index_map`, `scanner_positions`, `number_of_output_points` (of the
  consolidated set), `select_percentage`, `neighbor_radius`, `number_of_iterations`, `require_uniform_sampling`,
  `collision_angle`, `smoothing_radius`, `collision_radius`, `closing_step`, `denoise_along_rays`, `detect_outliers`,
  `outlier_output_iterator`, `missed_rays`, `callback`, `stage_times` and `geom_traits` as in
  `deep_points_consolidate_point_set()`, and those listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{prior}
      \cgalParamDescription{what is assumed of the shape in a gap}
      \cgalParamType{`Point_set_consolidation_3::Prior`}
      \cgalParamDefault{`Prior::VOLUME_PRESERVING`}
      \cgalParamExtra{With `MINIMAL_VOLUME` completed points keep 0.9 of their distance from the centre of the ball
        for each spacing between them and the data.}
    \cgalParamNEnd
    \cgalParamNBegin{prior_map}
      \cgalParamDescription{a prior per input point; a gap is closed by the prior of most points at its border}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Point_set_consolidation_3::Prior`}
      \cgalParamDefault{`prior` everywhere}
    \cgalParamNEnd
    \cgalParamNBegin{maximum_hole_size}
      \cgalParamDescription{wider gaps stay open: twice the largest distance of a gap's points from the data, in
        the unit of the input, positive}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{no bound}
    \cgalParamNEnd
    \cgalParamNBegin{point_is_constrained_map}
      \cgalParamDescription{points that are not denoised, and next to which nothing is completed}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
      \cgalParamDefault{nothing is constrained}
    \cgalParamNEnd
    \cgalParamNBegin{use_symmetry}
      \cgalParamDescription{whether a mirror plane of the shape, if the scan shows one, completes the other side:
        the data are reflected to where no data are near and no ray has passed, and so are the rays}
      \cgalParamType{Boolean}
      \cgalParamDefault{symmetry is used, unless `prior` or `prior_map` ask for something else than
        `VOLUME_PRESERVING`, or `maximum_hole_size` is given}
      \cgalParamExtra{Directions or positions of the scanner must be known, or found because the scan is from one
        side. A plane is accepted if at least 80 percent of the reflected points that face the scanner lie on the
        data, and those that lie in free space are less than 5 percent of them (2 percent if the direction was
        found). Where they do, the shape is taken for asymmetric.}
    \cgalParamNEnd
    \cgalParamNBegin{denoised_point_map}
      \cgalParamDescription{receives the positions of the caller's points as they should be meshed: unchanged
        for clean data and outliers; for noisy data moved along the rays where these are known, then projected to a
        local quadric fit}
      \cgalParamType{a model of `WritablePropertyMap` with the range's value type as key and
        `geom_traits::Point_3` as value type}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{denoised_normal_map}
      \cgalParamDescription{receives their unit normals, pointing outwards; outliers get that of the nearest other
        point}
      \cgalParamType{a model of `WritablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `output` past the last completed point.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite, most points
  coincide, or a parameter is out of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
complete_point_set(const PointRange& points, OutputIterator output,
                   const NamedParameters& named_parameters = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  const auto& np = cgal_np(named_parameters);
  typedef Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  Deep_points_consolidation_3<Traits, ConcurrencyTag> consolidation(points, named_parameters,
                                                                  "complete_point_set");
  const bool is_complete = consolidation.complete_missing_parts();
  report_stage_times(np, consolidation.stage_times());
  if(!is_complete)
    return output;
  std::size_t i = 0;
  for(auto it = points.begin(); it != points.end(); ++it, ++i) {
    if constexpr(has_parameter<NP, names::denoised_point_map_t>)
      put(CGAL::parameters::get_parameter(np, names::denoised_point_map), *it,
          consolidation.denoised_point(i));
    if constexpr(has_parameter<NP, names::denoised_normal_map_t>)
      put(CGAL::parameters::get_parameter(np, names::denoised_normal_map), *it,
          consolidation.denoised_normal(i));
  }
  write_to(np, names::outlier_output_iterator, consolidation.outliers());
  return consolidation.completed_points(output);
}

}  // namespace CGAL

#endif  // CGAL_COMPLETE_POINT_SET_H
