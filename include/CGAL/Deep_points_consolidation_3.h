// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEEP_POINTS_CONSOLIDATION_3_H
#define CGAL_DEEP_POINTS_CONSOLIDATION_3_H

#include <CGAL/Deep_point_3.h>
#include <CGAL/Point_set_consolidation_3/internal/completed_filling.h>
#include <CGAL/Point_set_consolidation_3/internal/confidence.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/input_stage.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/mirrored_scan.h>
#include <CGAL/Point_set_consolidation_3/internal/scan_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/sinking.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_consolidation.h>
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
  typedef Point_set_consolidation_3::internal::Points Points;
  typedef Point_set_consolidation_3::internal::Stage Stage;
  typedef Point_set_consolidation_3::internal::Cancelled Cancelled;
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
    : m_execution(Point_set_consolidation_3::internal::make_execution<ConcurrencyTag>())
  {
    read(points, Point_set_consolidation_3::internal::cgal_np(np));
  }

  /// \name Stages
  /// Each returns `false` if the callback stopped it; the object is then as before the call.
  /// @{

  /// Section 3 of the paper: WLOP consolidation and oriented normals.
  bool consolidate_input()
  {
    if(m_stage >= CONSOLIDATED)
      return true;
    return run(CONSOLIDATED, [&] {
      m_input = Point_set_consolidation_3::internal::consolidate_input<ConcurrencyTag>(
        m_execution, 0.35, m_scan, m_input_parameters);
      m_scan.hints = Point_set_consolidation_3::internal::Points();  // m_input has what is needed of these
      m_scan.directions = Point_set_consolidation_3::internal::Scan_directions();
    });
  }

  /// Section 4.1: inner points sink until opposing fronts meet.
  bool sink_inner_points()
  {
    if(m_stage >= SUNK)
      return true;
    return consolidate_input() && run(SUNK, [&] {
      Stage stage(m_execution, "sinking", 0.1);
      m_sunk = Point_set_consolidation_3::internal::sink(
        m_execution, stage, m_input.points, m_input.normals, m_sinking_parameters);
    });
  }

  /// Section 4.2: the inner points form the meso-skeleton, curves and sheets.
  bool form_meso_skeleton()
  {
    if(m_stage >= SKELETON_FORMED)
      return true;
    return sink_inner_points() && run(SKELETON_FORMED, [&] {
      Stage stage(m_execution, "meso-skeleton", 0.15);
      m_skeleton = Point_set_consolidation_3::internal::form_meso_skeleton(
        m_execution, stage, m_sunk.anchors, m_sunk.normals, m_skeleton_parameters);
    });
  }

  /// Section 4.3: the outer points spread over the surface, missing parts included.
  bool consolidate_outer_points()
  {
    if(m_stage >= SURFACE_CONSOLIDATED)
      return true;
    return form_meso_skeleton() && run(SURFACE_CONSOLIDATED, [&] {
      using namespace Point_set_consolidation_3::internal;
      Stage stage(m_execution, "surface", 0.4);
      Free_space free_space;
      if(!m_input.directions.empty())
        free_space = Free_space(m_execution, m_input.data, m_input.directions, region(), 1.);
      const Nearest_neighbors data(m_input.data);
      std::vector<char> frozen;
      std::vector<Point_set_consolidation_3::Prior> priors;
      for(const Vec3& p : m_input.points) {
        const std::size_t c = data.nearest(p).index;
        if(!m_input.gaps.is_frozen.empty())
          frozen.push_back(m_input.gaps.is_frozen[c]);
        if(!m_input.gaps.priors.empty())
          priors.push_back(m_input.gaps.priors[c]);
      }
      m_surface = Surface_consolidation(m_execution, m_input.data, m_input.points, m_sunk.normals,
                                        m_skeleton.points, m_surface_parameters, free_space,
                                        frozen, priors)
                    .run(stage);
      Completed_filling filling(m_execution, m_skeleton.points, frozen, m_surface);
      filling.run(m_surface_parameters.completed_spacing);
      filling.close_flat(m_input.data, data, m_input.gaps);
      m_confidence.resize(m_surface.points.size());
      parallel_for(m_execution, m_confidence.size(), [&](std::size_t i) {
        m_confidence[i] =
          confidence(std::sqrt(data.nearest(m_surface.points[i]).squared_distance));
      });
    });
  }

  /// Beside the paper's stages, after `sink_inner_points()`: the missing parts by clipped balls, and the seen
  /// part denoised and oriented, see `complete_point_set()`.
  bool complete_missing_parts()
  {
    if(m_has_completion)
      return true;
    if(!sink_inner_points())
      return false;
    return run(m_stage, [&] {
      using namespace Point_set_consolidation_3::internal;
      {
        Stage stage(m_execution, "seen part", 0.1);
        if(m_seen.points.empty())  // it is kept when a call is cancelled
          m_seen = m_input.seen.points.empty() ? Seen_part_estimation::estimate(m_execution, m_input.data)
                                               : std::move(m_input.seen);
        m_seen.is_noisy = m_seen.is_noisy || m_input.is_denoised;
        if(!m_input.directions.empty())
          orient_to_scanner(m_execution, m_input.data, m_seen.normals, m_input.directions.towards_scanner);
      }
      const double margin = m_seen.spacing + (m_seen.is_noisy ? 3 * m_seen.noise : 0);
      Free_space free_space;
      if(!m_input.directions.empty())
        free_space = Free_space(m_execution, m_input.data, m_input.directions, region(), margin);
      Completion_parameters parameters;
      parameters.gaps = m_input.gaps;
      parameters.gaps.largest = m_largest_gap / m_input.frame.unit;
      if(!complete_by_symmetry(free_space, margin, parameters)) {
        Stage stage(m_execution, "completion", 0.4);
        m_completed = Completion(m_execution, m_input, m_seen, m_sunk, free_space, parameters)
                        .run(stage);
      }
      m_has_completion = true;
      m_execution.progress.finish();
    });
  }

  /// @}
  /// \name Results
  /// Empty before their stage has run.
  /// @{

  /// writes the deep points as `Deep_point_3<Traits>`: one for each consolidated point, then those inserted
  /// where completed regions were sparse.
  template <typename OutputIterator>
  OutputIterator deep_points(OutputIterator output) const
  {
    for(std::size_t i = 0; i < m_surface.points.size(); ++i)
      *output++ = Deep_point(world(m_surface.points[i]),
                             world(m_skeleton.points[m_surface.inner[i]]),
                             vector(m_surface.normals[i]), FT(m_confidence[i]));
    return output;
  }

  /// writes the missing points, as `Completed_point_3<Traits>`; empty if nothing is missing.
  template <typename OutputIterator>
  OutputIterator completed_points(OutputIterator output) const
  {
    using Point_set_consolidation_3::internal::confidence;
    for(std::size_t i = 0; i < m_completed.points.size(); ++i) {
      const double distance = m_completed.distance[i];
      *output++ = Completed_point_3<Traits>(
        Deep_point(world(m_completed.points[i]), world(m_completed.inner[i]),
                   vector(m_completed.normals[i]), FT(confidence(m_completed.uncertainty[i]))),
        FT(m_input.frame.unit * distance), m_completed.is_clipped[i] != 0,
        m_completed.is_unanchored[i] != 0);
    }
    return output;
  }
  /// indices of the input points that are outliers, in increasing order; known once the input is consolidated
  const std::vector<std::size_t>& outliers() const { return m_input.outliers; }
  /// whether input point i is one
  bool is_outlier(std::size_t i) const
  {
    return std::binary_search(m_input.outliers.begin(), m_input.outliers.end(), i);
  }
  /// position of input point i as it should be meshed: the input point itself unless the data are noisy and the
  /// point is neither constrained nor an outlier
  Point_3 denoised_point(std::size_t i) const
  {
    const Vec3& p = m_scan.points[i];
    const bool is_frozen = !m_scan.gaps.is_frozen.empty() && m_scan.gaps.is_frozen[i];
    return m_seen.is_noisy && !is_frozen && !is_outlier(i) ? world(m_seen.points[place(i)])
                                                           : Point_3(FT(p.x()), FT(p.y()), FT(p.z()));
  }
  /// its unit normal, outwards; of an outlier, that of the nearest other point
  Vector_3 denoised_normal(std::size_t i) const { return vector(m_seen.normals[place(i)]); }

  /// number of consolidated points
  std::size_t size() const { return m_input.points.size(); }
  /// spacing r of the consolidated points, equation (1), in the input's unit
  double spacing() const { return m_input.frame.unit; }

  /// consolidated point i of S
  Point_3 consolidated_point(std::size_t i) const { return world(m_input.points[i]); }
  /// its oriented normal; bilaterally smoothed once the inner points have sunk
  Vector_3 consolidated_normal(std::size_t i) const
  {
    return vector(m_stage >= SUNK ? m_sunk.normals[i] : m_input.normals[i]);
  }
  /// anchor point i of H
  Point_3 anchor_point(std::size_t i) const { return world(m_sunk.anchors[i]); }
  /// how it came to rest
  Anchoring anchoring(std::size_t i) const { return m_sunk.anchoring[i]; }
  /// skeletal point i of Q
  Point_3 skeletal_point(std::size_t i) const { return world(m_skeleton.points[i]); }
  /// axis m (0, 1, 2) of its anisotropic neighbourhood, as long as the semi-axis, in the input's unit
  Vector_3 ellipsoid_axis(std::size_t i, int m) const
  {
    const auto& e = m_skeleton.ellipsoids[i];
    return vector(m_input.frame.unit * e.semi_axes[m] * e.axes.col(m));
  }
  /// index of the skeletal point that is the partner of outer point i
  std::size_t partner(std::size_t i) const { return m_surface.inner[i]; }
  /// density eta of the data at outer point i, equation (6); below 1.5: completed
  double data_density(std::size_t i) const { return m_surface.data_density[i]; }
  /// iterations that sinking took
  std::size_t number_of_sinking_iterations() const { return m_sunk.iterations; }
  /// seconds and iterations of the stages so far
  const std::vector<Stage_time>& stage_times() const { return m_execution.times; }

  /// @}

private:
  /// \cond SKIP_IN_MANUAL
  enum State { EMPTY, CONSOLIDATED, SUNK, SKELETON_FORMED, SURFACE_CONSOLIDATED };

  template <typename Work>
  bool run(State state, const Work& work)
  {
    try {
      work();
      if(state == SURFACE_CONSOLIDATED)
        m_execution.progress.finish();
    }
    catch(const Cancelled&) {
      return false;
    }
    m_stage = state;
    return true;
  }

  template <typename PointRange, typename NP>
  void read(const PointRange& points, const NP& np)
  {
    using namespace Point_set_consolidation_3;
    using namespace Point_set_consolidation_3::internal;
    const char* const function = "deep_points_consolidate_point_set";
    m_execution.progress = Progress(callback_of(np));

    constexpr std::size_t least_points = 10;
    m_scan.points = copy_points(function, points, np, least_points);
    m_scan.hints = copy_normals(function, points, np);
    m_scan.directions = copy_scan_directions(function, points, m_scan.points, np);
    Gap_parameters& gaps = m_scan.gaps;
    gaps.is_frozen = copy_constrained(points, np);
    if constexpr(has_parameter<NP, Point_set_consolidation_3::internal_np::prior_map_t>) {
      const auto map =
        CGAL::parameters::get_parameter(np, Point_set_consolidation_3::internal_np::prior_map);
      for(auto it = points.begin(); it != points.end(); ++it)
        gaps.priors.push_back(get(map, *it));
    }
    m_input_parameters = read_input_parameters(function, np, m_scan.points.size());

    m_sinking_parameters = read_sinking_parameters(function, np);
    m_skeleton_parameters = read_skeleton_parameters(function, np);
    m_surface_parameters = read_surface_parameters(function, np);
    gaps.prior = m_surface_parameters.prior;
    gaps.shrinkage = m_surface_parameters.shrinkage;
    m_largest_gap = positive(function, np, Point_set_consolidation_3::internal_np::maximum_hole_size,
                             "maximum_hole_size", (std::numeric_limits<double>::max)());
    const bool is_usual = gaps.priors.empty() && gaps.prior == Prior::VOLUME_PRESERVING &&
                          !(m_largest_gap < (std::numeric_limits<double>::max)());
    m_use_symmetry = parameter_or(np, Point_set_consolidation_3::internal_np::use_symmetry, is_usual);
  }

  /// Where data count; outliers lie beyond.
  Point_set_consolidation_3::internal::Bounding_box region() const
  {
    constexpr double margin = 5;
    return Point_set_consolidation_3::internal::bounding_box(m_input.points).grown(margin);
  }

  /// Completes the scan and its image by the shape's mirror plane; false if no plane is certain.
  bool complete_by_symmetry(const Point_set_consolidation_3::internal::Free_space& free_space,
                            double margin,
                            Point_set_consolidation_3::internal::Completion_parameters parameters)
  {
    using namespace Point_set_consolidation_3::internal;
    if(!m_use_symmetry || free_space.empty())
      return false;
    const Mirror_symmetry symmetry(m_execution, m_input.points, m_input.normals, free_space);
    Mirror_plane plane;
    if(!symmetry.find(plane, m_input.directions.is_estimated))
      return false;
    const Mirrored_scan scan(m_execution, m_input, m_seen, m_input.gaps, free_space, symmetry, plane);
    if(!scan.is_larger_than(m_seen))
      return false;
    Sunk_points sunk;
    {
      Stage stage(m_execution, "sinking of images", 0.1);
      sunk = sink(m_execution, stage, scan.input().points, scan.input().normals,
                  m_sinking_parameters);
    }
    Stage stage(m_execution, "completion", 0.3);
    parameters.gaps = scan.gaps();
    m_completed = Completion(m_execution, scan.input(), scan.seen(), sunk, scan.free_space(margin),
                             parameters, m_seen.points.size())
                    .run(stage);
    return true;
  }

  Point_3 world(const Vec3& local) const
  {
    const Vec3 w = m_input.frame.to_world(local);
    return Point_3(FT(w.x()), FT(w.y()), FT(w.z()));
  }
  /// Of an input point among the data.
  std::size_t place(std::size_t i) const { return m_input.place.empty() ? i : m_input.place[i]; }
  static Vector_3 vector(const Vec3& v) { return Vector_3(FT(v.x()), FT(v.y()), FT(v.z())); }

  Point_set_consolidation_3::internal::Execution m_execution;
  State m_stage = EMPTY;
  Point_set_consolidation_3::internal::Raw_scan m_scan;
  double m_largest_gap = 0;   ///< in the input's unit
  Point_set_consolidation_3::internal::Input_parameters m_input_parameters;
  Point_set_consolidation_3::internal::Sinking_parameters m_sinking_parameters;
  Point_set_consolidation_3::internal::Meso_skeleton_parameters m_skeleton_parameters;
  Point_set_consolidation_3::internal::Surface_parameters m_surface_parameters;
  Point_set_consolidation_3::internal::Consolidated_input m_input;
  Point_set_consolidation_3::internal::Sunk_points m_sunk;
  Point_set_consolidation_3::internal::Meso_skeleton m_skeleton;
  Point_set_consolidation_3::internal::Consolidated_surface m_surface;
  Point_set_consolidation_3::internal::Seen_part m_seen;
  Point_set_consolidation_3::internal::Completed_points m_completed;
  bool m_has_completion = false;
  bool m_use_symmetry = true;
  std::vector<double> m_confidence;
  /// \endcond
};

}  // namespace CGAL

#endif  // CGAL_DEEP_POINTS_CONSOLIDATION_3_H
