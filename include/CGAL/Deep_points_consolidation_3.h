// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEEP_POINTS_CONSOLIDATION_3_H
#define CGAL_DEEP_POINTS_CONSOLIDATION_3_H

#include <CGAL/Deep_point_3.h>
#include <CGAL/Point_set_consolidation_3/core/deep_points.h>
#include <CGAL/Point_set_consolidation_3/internal/read_deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/scan_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>
#include <CGAL/Point_set_consolidation_3/options.h>
#include <CGAL/Point_set_consolidation_3/parameters.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Completion

  Deep points consolidation \cgalCite{cgal:wshcl-dpc-15} with the paper's stages as members, for
  users who want to look at, or change, what happens in between. The function
  `deep_points_consolidate_point_set()` runs all of them.

  Points may be unoriented, noisy, unevenly spread and have large missing parts. The object copies what it
  needs at construction; the input is neither changed nor reordered. A stage runs the stages before it
  if that has not happened yet. Results do not depend on `ConcurrencyTag`, bit for bit.

  Lengths are in units of the spacing r of the consolidated points (equation (1)) unless said otherwise, so
  that results do not depend on the unit or the place of the input.

  Complexity of each stage: linear in the number of input points and of deep points for given densities; see
  `deep_points_consolidate_point_set()` for times.

  \tparam Traits a model of `Kernel`, floating point coordinates.
  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
*/
template <typename Traits, typename ConcurrencyTag = Sequential_tag>
class Deep_points_consolidation_3 {
  /// \cond SKIP_IN_MANUAL
  typedef Point_set_consolidation_3::internal::Vec3 Vec3;
  typedef Point_set_consolidation_3::internal::Deep_points Core;
  /// \endcond

public:
  /// number type of the coordinates
  typedef typename Traits::FT FT;
  /// type of points
  typedef typename Traits::Point_3 Point_3;
  /// type of vectors
  typedef typename Traits::Vector_3 Vector_3;
  /// what `deep_points()` writes
  typedef Deep_point_3<Traits> Deep_point;

  /// How an inner point came to rest.
  typedef Point_set_consolidation_3::Anchoring Anchoring;
  /// Name, seconds and iterations of a stage.
  typedef Point_set_consolidation_3::Stage_time Stage_time;

  /*!
    copies the points and reads the parameters.

    \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
    \param points at least 10 points, all coordinates finite.
    \param np the named parameters of `deep_points_consolidate_point_set()`.
    \throws std::invalid_argument if a parameter or a coordinate is out of its range.
  */
  template <typename PointRange,
            typename NamedParameters = parameters::Default_named_parameters>
  explicit Deep_points_consolidation_3(const PointRange& points,
                                       const NamedParameters& np = parameters::default_values())
    : Deep_points_consolidation_3(points, np, "Deep_points_consolidation_3")
  {}

  /// \cond SKIP_IN_MANUAL
  /// `function` is named in error messages.
  template <typename PointRange, typename NamedParameters>
  Deep_points_consolidation_3(const PointRange& points, const NamedParameters& np, const char* function)
    : m_core(read(function, points, Point_set_consolidation_3::internal::cgal_np(np)))
  {}
  /// \endcond

  /// \name Stages
  /// Each returns `false` if the callback stopped it; the object is then as before the call.
  /// @{

  /// Section 3 of the paper: WLOP consolidation and oriented normals.
  bool consolidate_input() { return m_core.consolidate_input(); }
  /// Section 4.1: inner points sink until opposing fronts meet.
  bool sink_inner_points() { return m_core.sink_inner_points(); }
  /// Section 4.2: the inner points form the meso-skeleton, curves and sheets.
  bool form_meso_skeleton() { return m_core.form_meso_skeleton(); }
  /// Section 4.3: the outer points spread over the surface, missing parts included.
  bool consolidate_outer_points() { return m_core.consolidate_outer_points(); }
  /// Beside the paper's stages, after `sink_inner_points()`: the missing parts by clipped balls, and the seen
  /// part denoised and oriented, see `complete_point_set()`.
  bool complete_missing_parts() { return m_core.complete_missing_parts(); }

  /// @}
  /// \name Results
  /// Empty before their stage has run.
  /// @{

  /// writes the deep points as `Deep_point_3<Traits>`: one for each consolidated point, then those inserted
  /// where completed regions were sparse.
  template <typename OutputIterator>
  OutputIterator deep_points(OutputIterator output) const
  {
    for(std::size_t i = 0; i < m_core.number_of_outer_points(); ++i)
      *output++ = Deep_point(point(m_core.outer_point(i)), skeletal_point(partner(i)),
                             vector(m_core.outer_normal(i)), FT(m_core.outer_confidence(i)));
    return output;
  }

  /// writes the missing points, as `Completed_point_3<Traits>`; empty if nothing is missing.
  template <typename OutputIterator>
  OutputIterator completed_points(OutputIterator output) const
  {
    for(std::size_t i = 0; i < m_core.number_of_completed_points(); ++i) {
      const Point_set_consolidation_3::internal::Completed_place p = m_core.completed_point(i);
      *output++ = Completed_point_3<Traits>(
        Deep_point(point(p.point), point(p.inner), vector(p.normal), FT(p.confidence)), FT(p.distance),
        p.is_clipped, p.is_unanchored);
    }
    return output;
  }
  /// indices of the input points that are outliers, in increasing order; known once the input is consolidated
  const std::vector<std::size_t>& outliers() const { return m_core.outliers(); }
  /// whether input point i is one
  bool is_outlier(std::size_t i) const { return m_core.is_outlier(i); }
  /// position of input point i as it should be meshed: the input point itself unless the data are noisy and the
  /// point is neither constrained nor an outlier
  Point_3 denoised_point(std::size_t i) const { return point(m_core.denoised_point(i)); }
  /// its unit normal, outwards; of an outlier, that of the nearest other point
  Vector_3 denoised_normal(std::size_t i) const { return vector(m_core.denoised_normal(i)); }

  /// number of consolidated points
  std::size_t size() const { return m_core.size(); }
  /// spacing r of the consolidated points, equation (1), in the input's unit
  double spacing() const { return m_core.spacing(); }

  /// consolidated point i of S
  Point_3 consolidated_point(std::size_t i) const { return point(m_core.consolidated_point(i)); }
  /// its oriented normal; bilaterally smoothed once the inner points have sunk
  Vector_3 consolidated_normal(std::size_t i) const { return vector(m_core.consolidated_normal(i)); }
  /// anchor point i of H
  Point_3 anchor_point(std::size_t i) const { return point(m_core.anchor_point(i)); }
  /// how it came to rest
  Anchoring anchoring(std::size_t i) const { return m_core.anchoring(i); }
  /// skeletal point i of Q
  Point_3 skeletal_point(std::size_t i) const { return point(m_core.skeletal_point(i)); }
  /// axis m (0, 1, 2) of its anisotropic neighbourhood, as long as the semi-axis, in the input's unit
  Vector_3 ellipsoid_axis(std::size_t i, int m) const { return vector(m_core.ellipsoid_axis(i, m)); }
  /// index of the skeletal point that is the partner of outer point i
  std::size_t partner(std::size_t i) const { return m_core.partner(i); }
  /// density eta of the data at outer point i, equation (6); below 1.5: completed
  double data_density(std::size_t i) const { return m_core.data_density(i); }
  /// iterations that sinking took
  std::size_t number_of_sinking_iterations() const { return m_core.number_of_sinking_iterations(); }
  /// seconds and iterations of the stages so far
  const std::vector<Stage_time>& stage_times() const { return m_core.execution().times; }

  /// @}

private:
  /// \cond SKIP_IN_MANUAL
  template <typename PointRange, typename NP>
  static Core read(const char* function, const PointRange& points, const NP& np)
  {
    using namespace Point_set_consolidation_3;
    using namespace Point_set_consolidation_3::internal;
    namespace names = Point_set_consolidation_3::internal_np;
    constexpr std::size_t least_points = 10;
    Raw_scan scan;
    scan.points = copy_points(function, points, np, least_points);
    scan.hints = copy_normals(function, points, np);
    scan.directions = copy_scan_directions(function, points, scan.points, np);
    Gap_parameters& gaps = scan.gaps;
    gaps.is_frozen = copy_constrained(points, np);
    if constexpr(has_parameter<NP, names::prior_map_t>) {
      const auto map = CGAL::parameters::get_parameter(np, names::prior_map);
      for(auto it = points.begin(); it != points.end(); ++it) {
        gaps.priors.push_back(get(map, *it));
        if(!is_enumerator(gaps.priors.back(), Point_set_consolidation_3::Prior::FLAT))
          throw_invalid(function, "prior_map: point " + std::to_string(gaps.priors.size() - 1) + " has none of the priors");
      }
    }
    Deep_points_settings settings;
    settings.function = function;
    settings.input = read_input_parameters(function, np, scan.points.size());
    settings.sinking = read_sinking_parameters(function, np);
    settings.skeleton = read_skeleton_parameters(function, np, settings.sinking.collision_radius);
    settings.surface = read_surface_parameters(function, np, settings.sinking.smoothing_radius);
    gaps.prior = settings.surface.prior;
    gaps.shrinkage = settings.surface.shrinkage;
    constexpr double no_bound = (std::numeric_limits<double>::max)();
    settings.largest_gap = positive(function, np, names::maximum_hole_size, "maximum_hole_size", no_bound);
    const bool is_usual =
      gaps.priors.empty() && gaps.prior == Prior::VOLUME_PRESERVING && !(settings.largest_gap < no_bound);
    settings.use_symmetry = parameter_or(np, names::use_symmetry, is_usual);
    return Core(make_execution<ConcurrencyTag>(callback_of(np)), std::move(scan), settings);
  }

  static Point_3 point(const Vec3& p) { return Point_set_consolidation_3::internal::to_point<Traits>(p); }
  static Vector_3 vector(const Vec3& v) { return Point_set_consolidation_3::internal::to_vector<Traits>(v); }

  Core m_core;
  /// \endcond
};

}  // namespace CGAL

#endif  // CGAL_DEEP_POINTS_CONSOLIDATION_3_H
