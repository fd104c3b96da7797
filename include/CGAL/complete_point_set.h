// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLETE_POINT_SET_H
#define CGAL_COMPLETE_POINT_SET_H

#include <CGAL/Deep_point_3.h>
#include <CGAL/Point_set_consolidation_3/internal/completion.h>
#include <CGAL/Point_set_consolidation_3/internal/confidence.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/input_stage.h>
#include <CGAL/Point_set_consolidation_3/internal/scan_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/parameters.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Ref

  A point that `complete_point_set()` adds: a deep point, and what is known of it. It may be assigned to a
  `Deep_point_3`.
*/
template <typename Kernel>
class Completed_point_3 : public Deep_point_3<Kernel> {
public:
  typedef Deep_point_3<Kernel> Base;
  typedef typename Kernel::FT FT;

  Completed_point_3() = default;
  Completed_point_3(const Base& base, const FT& distance, bool is_clipped, bool is_unanchored)
    : Base(base), m_distance(distance), m_is_clipped(is_clipped), m_is_unanchored(is_unanchored)
  {}

  /// distance to the nearest input point, in the input's unit
  const FT& distance() const { return m_distance; }
  /// whether the data or known free space bound the shape here
  bool is_clipped() const { return m_is_clipped; }
  /// whether nothing opposes the surface from which this was completed: its depth is a guess
  bool is_unanchored() const { return m_is_unanchored; }

private:
  FT m_distance = FT(0);
  bool m_is_clipped = false, m_is_unanchored = false;
};

/// \cond SKIP_IN_MANUAL
namespace Point_set_consolidation_3 {
namespace internal {

/// All stages on plain arrays. `hints` may be empty.
struct Completion_result {
  Consolidated_input input;
  Seen_part seen;
  Completed_points completed;
};

template <typename ConcurrencyTag>
Completion_result complete(Execution& execution, const Points& world, const Points& hints,
                           const Scan_directions& directions,
                           const Input_parameters& input_parameters,
                           const Sinking_parameters& sinking_parameters,
                           const Completion_parameters& completion_parameters)
{
  Completion_result result;
  result.input = consolidate_input<ConcurrencyTag>(execution, 0.5, world, hints, directions,
                                                   input_parameters);
  const Consolidated_input& input = result.input;
  Sunk_points sunk;
  {
    Stage stage(execution, "sinking", 0.15);
    sunk = sink(execution, stage, input.points, input.normals, sinking_parameters);
  }
  {
    Stage stage(execution, "seen part", 0.1);
    Points sides = directions.towards_scanner;
    if(directions.empty()) {
      const Nearest_neighbors tree(input.points);
      sides.resize(input.data.size());
      parallel_for(execution, sides.size(), [&](std::size_t i) {
        sides[i] = input.normals[tree.nearest(input.data[i]).index];
      });
    }
    result.seen = Seen_part_estimation::estimate(execution, input.data, sides);
  }
  Stage stage(execution, "completion", 0.25);
  Free_space free_space;
  if(!directions.empty())
    free_space = Free_space(execution, input.data, directions,
                            result.seen.spacing + (result.seen.is_noisy ? 3 * result.seen.noise : 0));
  stage.update(0.1);
  result.completed = Completion(execution, input, result.seen, sunk, free_space,
                                completion_parameters).run(stage);
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
/// \endcond

/*!
  \ingroup PkgPointSetConsolidation3Ref

  completes a point set for meshing: writes points where data are missing, and optionally the denoised,
  oriented positions of the caller's points. Both together go into Poisson reconstruction.

  The deep points of \cgalCite{cgal:wshcl-dpc-15}, section 4.1, give each point of the consolidated
  set a ball inside of the shape. Balls are clipped by the data and by the space that rays have passed; their
  union is smoothed and sampled farther than six spacings from the data: smaller gaps are bridged better by the
  mesher. This is not the paper's own completion, which `deep_points_consolidate_point_set()` offers; it
  is more accurate on shapes that are no tubes.

  The input is neither changed nor reordered; the result does not depend on `ConcurrencyTag`, bit for bit.

  Complexity: about 100 microseconds for each input point; memory about 200 bytes for each input point, and a
  grid of at most 6 10^7 nodes.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `Completed_point_3<Geom_traits>` (or
  `Deep_point_3<Geom_traits>`, to which it converts).

  \param points at least 10 points with finite coordinates.
  \param output receives the missing points: `outer()` on the surface, `inner()` the centre of the ball,
  `normal()` outwards, `confidence()`. Nothing is written if the callback cancels, or if nothing is missing.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`, `normal_map`,
  `view_direction_map`, `view_index_map`, `scanner_positions`, `number_of_output_points` (of the consolidated
  set), `select_percentage`, `neighbor_radius`, `number_of_iterations`, `require_uniform_sampling`,
  `collision_angle`, `smoothing_radius`, `collision_radius`, `closing_step`, `callback`, `stage_times` and
  `geom_traits` as in `deep_points_consolidate_point_set()`, and those listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{denoised_point_map}
      \cgalParamDescription{receives the positions of the caller's points as they should be meshed: unchanged
        for clean data, projected to a local quadric fit for noisy data}
      \cgalParamType{a model of `WritablePropertyMap` with the range's value type as key and
        `geom_traits::Point_3` as value type}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{denoised_normal_map}
      \cgalParamDescription{receives their unit normals, pointing outwards}
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
  const char* const function = "complete_point_set";
  const auto& np = cgal_np(named_parameters);
  typedef Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::Vector_3 Vector_3;

  constexpr std::size_t least_points = 10;
  const Points world = copy_points(function, points, np, least_points);
  const Points hints = copy_normals(function, points, np);
  const Scan_directions directions = copy_scan_directions(function, points, world, np);
  const Input_parameters input_parameters = read_input_parameters(function, np, world.size());
  const Sinking_parameters sinking_parameters = read_sinking_parameters(function, np);

  Execution execution = make_execution<ConcurrencyTag>(callback_of(np));
  Completion_result result;
  try {
    result = complete<ConcurrencyTag>(execution, world, hints, directions, input_parameters,
                                      sinking_parameters, Completion_parameters());
    execution.progress.finish();
  }
  catch(const Cancelled&) {
    return output;
  }
  report_stage_times(np, execution.times);

  const Frame& frame = result.input.frame;
  const auto point = [&](const Vec3& local) {
    const Vec3 w = frame.to_world(local);
    return Point_3(FT(w.x()), FT(w.y()), FT(w.z()));
  };
  const auto vector = [](const Vec3& v) { return Vector_3(FT(v.x()), FT(v.y()), FT(v.z())); };
  std::size_t i = 0;
  for(auto it = points.begin(); it != points.end(); ++it, ++i) {
    if constexpr(has_parameter<NP, names::denoised_point_map_t>) {
      const Vec3& w = world[i];
      put(CGAL::parameters::get_parameter(np, names::denoised_point_map), *it,
          result.seen.is_noisy ? point(result.seen.points[i])
                               : Point_3(FT(w.x()), FT(w.y()), FT(w.z())));
    }
    if constexpr(has_parameter<NP, names::denoised_normal_map_t>)
      put(CGAL::parameters::get_parameter(np, names::denoised_normal_map), *it,
          vector(result.seen.normals[i]));
  }
  const Completed_points& completed = result.completed;
  for(i = 0; i < completed.points.size(); ++i)
    *output++ = Completed_point_3<Traits>(
      Deep_point_3<Traits>(point(completed.points[i]), point(completed.inner[i]),
                           vector(completed.normals[i]), FT(confidence(completed.distance[i]))),
      FT(frame.unit * completed.distance[i]), completed.is_clipped[i] != 0,
      completed.is_unanchored[i] != 0);
  return output;
}

}  // namespace CGAL

#endif  // CGAL_COMPLETE_POINT_SET_H
