// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_LAPLACIAN_CONTRACTION_SKELETON_H
#define CGAL_EXTRACT_LAPLACIAN_CONTRACTION_SKELETON_H

#include <CGAL/Laplacian_contraction_skeletonization_3.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  extracts the curve skeleton of a point set by Laplacian contraction \cgalCite{cgal:ctowz-pcsvl-10}.

  The points, which need neither normals nor connectivity, are contracted to a thin set by solving equation (1)
  of the paper with growing weights on one-rings in their tangent planes; this set is sampled and thinned
  to a graph without triangles, whose nodes are moved to the centre of the points they stand for. Cycles of
  the skeleton are handles of the shape, components are those of the shape. Nodes keep the radius of the
  shape and the points they stand for.

  Topology is right for complete point sets whose parts do not touch: parts closer to each other than a few
  spacings are joined. On scans from few views, expect the right branches, not the right cycles;
  `bridge_components()` joins components that missing data have separated.

  Special inputs: of equal points one is contracted; points that are all equal have a skeleton of one vertex; collinear
  points have one that follows the line.

  Complexity: \f$O(n^{1.5})\f$ in the number of contracted points, see `number_of_samples`.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam Kernel a model of `Kernel`, floating point coordinates.

  \param points at least 4 points with finite coordinates.
  \param skeleton receives the skeleton; unchanged if the callback cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{outward normals; nodes are then centred by circles fitted to points and normals, which
        halves the error on one-sided scans and yields better radii}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
      \cgalParamDefault{none: nodes are the means of their points}
    \cgalParamNEnd
    \cgalParamNBegin{k_neighbors}
      \cgalParamDescription{number of nearest points, itself included, among which the ring of a point is found;
        at least 4}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{0.012 times the number of points, within [8, 12]; the upper bound of the paper, 30, joins
        parts that are close to each other. Where the points are so uneven that the rings fall into more components than
        with 30, as many more as join them}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_samples}
      \cgalParamDescription{largest number of points that are contracted; larger sets are represented by evenly spread
        ones of their points}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{20000; 10000 for polygon soups}
    \cgalParamNEnd
    \cgalParamNBegin{laplacian_weights}
      \cgalParamDescription{weights of the Laplacian (figure 3 of the paper)}
      \cgalParamType{`Point_set_consolidation_3::Laplacian_weights`}
      \cgalParamDefault{`Laplacian_weights::COTANGENT`: the others need more iterations and lose handles}
    \cgalParamNEnd
    \cgalParamNBegin{contraction_weight}
      \cgalParamDescription{\f$W_L^0\f$, initial weight of the contraction, as a multiple of the paper's
        \f$1/(5 \bar S^0)\f$}
      \cgalParamType{floating scalar value, positive}
      \cgalParamDefault{1}
    \cgalParamNEnd
    \cgalParamNBegin{attraction_weight}
      \cgalParamDescription{\f$W_H^0\f$, initial weight of the attraction of points to their places}
      \cgalParamType{floating scalar value, positive}
      \cgalParamDefault{1}
    \cgalParamNEnd
    \cgalParamNBegin{contraction_factor}
      \cgalParamDescription{\f$s_L\f$, by which the weight of the contraction grows in an iteration; 2 is gentler to
        shapes with thin limbs between thick parts}
      \cgalParamType{floating scalar value, at least 1}
      \cgalParamDefault{3}
    \cgalParamNEnd
    \cgalParamNBegin{convergence_threshold}
      \cgalParamDescription{\f$t\f$, least decrease of the mean extent of rings, relative to the initial one, in an
        iteration}
      \cgalParamType{floating scalar value, positive}
      \cgalParamDefault{0.01}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{largest number of contractions}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{20; usually 4 to 6 are needed}
    \cgalParamNEnd
    \cgalParamNBegin{sampling_radius}
      \cgalParamDescription{\f$r\f$, distance of the nodes before thinning, as a share of the diagonal of the points'
        bounding box, in [0.001, 1]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.02}
    \cgalParamNEnd
    \cgalParamNBegin{largest_merged_cycle}
      \cgalParamDescription{cycles of at most so many nodes are merged to a node, as they come from places where
        local triangulations disagree, unless they are wider than the parts of the shape around their nodes, and
        these parts have a side towards the middle of the cycle: these are handles. 0 keeps all}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{6}
    \cgalParamNEnd
    \cgalParamNBegin{extend_tips}
      \cgalParamDescription{whether tips are extended to the end of the shape, by a vertex of radius 0}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{seed of the samples of polygon soups}
      \cgalParamType{`std::uint64_t`}
      \cgalParamDefault{0}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call}
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

  \return `false` if the callback cancelled, `true` otherwise.
  \throws std::invalid_argument if there are too few points, a coordinate is not finite or a parameter is out
  of its range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename Kernel,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_laplacian_contraction_skeleton(
  const PointRange& points, Curve_skeleton_3<Kernel>& skeleton,
  const NamedParameters& np = parameters::default_values())
{
  Laplacian_contraction_skeletonization_3<Kernel, ConcurrencyTag> skeletonization(points, np);
  const bool is_complete = skeletonization.extract();
  Point_set_consolidation_3::internal::report_stage_times(
    Point_set_consolidation_3::internal::cgal_np(np), skeletonization.stage_times());
  if(is_complete)
    skeletonization.skeleton(skeleton);
  return is_complete;
}

/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  extracts the curve skeleton of a soup of polygons, by sampling it: surfaces with or without boundary, in any
  orientation. The vertices of the skeleton stand for vertices of the soup. Named parameters and errors are those
  of the function for point sets; `normal_map` is not used.

  \tparam PolygonRange a model of `ConstRange` whose value type is a range of indices; polygons with more than three
  vertices should be convex.
*/
template <typename ConcurrencyTag, typename PointRange, typename PolygonRange, typename Kernel,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_laplacian_contraction_skeleton(
  const PointRange& points, const PolygonRange& polygons, Curve_skeleton_3<Kernel>& skeleton,
  const NamedParameters& np = parameters::default_values())
{
  Laplacian_contraction_skeletonization_3<Kernel, ConcurrencyTag> skeletonization(points, polygons,
                                                                                  np);
  const bool is_complete = skeletonization.extract();
  Point_set_consolidation_3::internal::report_stage_times(
    Point_set_consolidation_3::internal::cgal_np(np), skeletonization.stage_times());
  if(is_complete)
    skeletonization.skeleton(skeleton);
  return is_complete;
}

}  // namespace CGAL

#endif  // CGAL_EXTRACT_LAPLACIAN_CONTRACTION_SKELETON_H
