// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/deep_points.h>
#include <CGAL/Point_set_consolidation_3/internal/completed_filling.h>
#include <CGAL/Point_set_consolidation_3/internal/completion.h>
#include <CGAL/Point_set_consolidation_3/internal/confidence.h>
#include <CGAL/Point_set_consolidation_3/internal/input_stage.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/mirrored_scan.h>
#include <CGAL/Point_set_consolidation_3/internal/sinking.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_consolidation.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What the stages leave for each other.
struct Deep_points::State {
  enum Progress_of_stages { EMPTY, CONSOLIDATED, SUNK, SKELETON_FORMED, SURFACE_CONSOLIDATED };

  Execution execution;
  Deep_points_settings settings;
  Raw_scan scan;
  Progress_of_stages stage = EMPTY;
  Consolidated_input input;
  Sunk_points sunk;
  Meso_skeleton skeleton;
  Consolidated_surface surface;
  std::vector<double> confidences;  ///< of the points of `surface`
  Seen_part seen;
  Completed_points completed;
  bool has_completion = false;

  /// `work` assigns its results last, so that what stops it leaves the object as it was.
  template <typename Work>
  bool run(Progress_of_stages next, const Work& work)
  {
    const Progress::Fractions fractions = execution.progress.fractions();
    const std::size_t timed = execution.times.size();
    const auto take_back = [&] {
      execution.progress.set_fractions(fractions);
      execution.times.resize(timed);
    };
    try {
      work();
    }
    catch(const Cancelled&) {
      take_back();
      return false;
    }
    catch(const Unusable_input& error) {
      take_back();
      throw std::invalid_argument(std::string(settings.function) + "(): " + error.what());
    }
    catch(...) {
      take_back();
      throw;
    }
    stage = next;
    return true;
  }

  Vec3 world(const Vec3& local) const { return input.frame.to_world(local); }
  /// Of an input point among the data.
  std::size_t place(std::size_t i) const { return input.place.empty() ? i : input.place[i]; }

  /// Where data count; outliers lie beyond.
  Bounding_box region() const
  {
    constexpr double margin = 5;
    return bounding_box(input.points).grown(margin);
  }
  Free_space free_space(double margin) const
  {
    return input.directions.empty() ? Free_space()
                                    : Free_space(execution, input.data, input.directions, region(), margin);
  }

  void consolidate_outer_points()
  {
    Stage stage(execution, "surface", 0.4);
    const Nearest_neighbors data(input.data);
    std::vector<char> frozen;
    std::vector<Prior> priors;
    for(const Vec3& p : input.points) {
      const std::size_t c = data.nearest(p).index;
      if(!input.gaps.is_frozen.empty())
        frozen.push_back(input.gaps.is_frozen[c]);
      if(!input.gaps.priors.empty())
        priors.push_back(input.gaps.priors[c]);
    }
    Consolidated_surface outer = Surface_consolidation(execution, input.data, input.points, sunk.normals,
                                                       skeleton.points, settings.surface, free_space(1), frozen,
                                                       priors)
                                   .run(stage);
    Completed_filling filling(execution, skeleton.points, frozen, outer);
    filling.run(settings.surface.completed_spacing);
    filling.close_flat(input.data, data, input.gaps);
    std::vector<double> outer_confidences(outer.points.size());
    parallel_for(execution, outer_confidences.size(), [&](std::size_t i) {
      outer_confidences[i] = confidence(std::sqrt(data.nearest(outer.points[i]).squared_distance));
    });
    execution.progress.finish();
    surface = std::move(outer);
    confidences = std::move(outer_confidences);
  }

  void estimate_seen_part()
  {
    Stage stage(execution, "seen part", 0.1);
    if(seen.points.empty())  // it is kept when a call is cancelled
      seen = input.seen.points.empty() ? Seen_part_estimation::estimate(execution, input.data)
                                       : std::move(input.seen);
    seen.is_noisy = seen.is_noisy || input.is_denoised;
    if(!input.directions.empty())
      orient_to_scanner(execution, input.data, seen.normals, input.directions.towards_scanner);
  }

  void complete_missing_parts()
  {
    Completed_points missing = missing_parts();
    execution.progress.finish();
    completed = std::move(missing);
    has_completion = true;
  }

  Completed_points missing_parts()
  {
    estimate_seen_part();
    const double margin = seen.spacing + (seen.is_noisy ? 3 * seen.noise : 0);
    const Free_space space = free_space(margin);
    Completion_parameters parameters;
    parameters.gaps = input.gaps;
    parameters.gaps.largest = settings.largest_gap / input.frame.unit;
    Completed_points missing;
    if(complete_by_symmetry(space, margin, parameters, missing))
      return missing;
    Stage stage(execution, "completion", 0.4);
    return Completion(execution, input, seen, sunk, space, parameters).run(stage);
  }

  /// Completes the scan and its image by the shape's mirror plane; false if no plane is certain.
  bool complete_by_symmetry(const Free_space& space, double margin, Completion_parameters parameters,
                            Completed_points& missing)
  {
    if(!settings.use_symmetry || space.empty())
      return false;
    const Mirror_symmetry symmetry(execution, input.points, input.normals, space);
    const std::optional<Mirror_plane> plane = symmetry.find(input.directions.is_estimated);
    if(!plane)
      return false;
    const Mirrored_scan mirrored(execution, input, seen, space, symmetry, *plane);
    if(!mirrored.is_larger_than(seen))
      return false;
    Sunk_points all_sunk;
    {
      Stage stage(execution, "sinking of images", 0.1);
      all_sunk = sink(execution, stage, mirrored.input().points, mirrored.input().normals, settings.sinking);
    }
    Stage stage(execution, "completion", 0.3);
    parameters.gaps = mirrored.input().gaps;
    missing = Completion(execution, mirrored.input(), mirrored.seen(), all_sunk, mirrored.free_space(margin),
                         parameters, seen.points.size())
                .run(stage);
    return true;
  }
};

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Deep_points::Deep_points(Execution execution, Raw_scan scan, const Deep_points_settings& settings)
  : m(new State)
{
  m->execution = std::move(execution);
  m->scan = std::move(scan);
  m->settings = settings;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Deep_points::~Deep_points() = default;

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Deep_points::Deep_points(const Deep_points& other) : m(new State(*other.m)) {}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Deep_points::Deep_points(Deep_points&& other) noexcept = default;

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Deep_points& Deep_points::operator=(Deep_points other) noexcept
{
  m.swap(other.m);
  return *this;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::consolidate_input()
{
  return m->stage >= State::CONSOLIDATED || m->run(State::CONSOLIDATED, [&] {
    m->input = internal::consolidate_input(m->execution, 0.35, m->scan, m->settings.input);
    m->scan.hints = Points();  // the input has what is needed of these
    m->scan.directions = Scan_directions();
  });
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::sink_inner_points()
{
  return m->stage >= State::SUNK || (consolidate_input() && m->run(State::SUNK, [&] {
    Stage stage(m->execution, "sinking", 0.1);
    m->sunk = sink(m->execution, stage, m->input.points, m->input.normals, m->settings.sinking);
  }));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::form_meso_skeleton()
{
  return m->stage >= State::SKELETON_FORMED || (sink_inner_points() && m->run(State::SKELETON_FORMED, [&] {
    Stage stage(m->execution, "meso-skeleton", 0.15);
    m->skeleton = internal::form_meso_skeleton(m->execution, stage, m->sunk.anchors, m->sunk.normals,
                                               m->settings.skeleton);
  }));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::consolidate_outer_points()
{
  return m->stage >= State::SURFACE_CONSOLIDATED ||
         (form_meso_skeleton() &&
          m->run(State::SURFACE_CONSOLIDATED, [&] { m->consolidate_outer_points(); }));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::complete_missing_parts()
{
  return m->has_completion ||
         (sink_inner_points() && m->run(m->stage, [&] { m->complete_missing_parts(); }));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
const Execution& Deep_points::execution() const { return m->execution; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
double Deep_points::spacing() const { return m->input.frame.unit; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Deep_points::size() const { return m->input.points.size(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::consolidated_point(std::size_t i) const { return m->world(m->input.points[i]); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::consolidated_normal(std::size_t i) const
{
  return m->stage >= State::SUNK ? m->sunk.normals[i] : m->input.normals[i];
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::anchor_point(std::size_t i) const { return m->world(m->sunk.anchors[i]); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Anchoring Deep_points::anchoring(std::size_t i) const { return m->sunk.anchoring[i]; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Deep_points::number_of_sinking_iterations() const { return m->sunk.iterations; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::skeletal_point(std::size_t i) const { return m->world(m->skeleton.points[i]); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::ellipsoid_axis(std::size_t i, int axis) const
{
  const Ellipsoid& e = m->skeleton.ellipsoids[i];
  return m->input.frame.unit * e.semi_axes[axis] * e.axes.col(axis);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Deep_points::number_of_outer_points() const { return m->surface.points.size(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::outer_point(std::size_t i) const { return m->world(m->surface.points[i]); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::outer_normal(std::size_t i) const { return m->surface.normals[i]; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Deep_points::partner(std::size_t i) const { return m->surface.inner[i]; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
double Deep_points::data_density(std::size_t i) const { return m->surface.data_density[i]; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
double Deep_points::outer_confidence(std::size_t i) const { return m->confidences[i]; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Deep_points::number_of_completed_points() const { return m->completed.points.size(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Completed_place Deep_points::completed_point(std::size_t i) const
{
  const Completed_points& all = m->completed;
  Completed_place place;
  place.point = m->world(all.points[i]);
  place.inner = m->world(all.inner[i]);
  place.normal = all.normals[i];
  place.confidence = confidence(all.uncertainty[i]);
  place.distance = m->input.frame.unit * all.distance[i];
  place.is_clipped = all.is_clipped[i] != 0;
  place.is_unanchored = all.is_unanchored[i] != 0;
  return place;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
const std::vector<std::size_t>& Deep_points::outliers() const { return m->input.outliers; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Deep_points::is_outlier(std::size_t i) const
{
  return std::binary_search(m->input.outliers.begin(), m->input.outliers.end(), i);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::denoised_point(std::size_t i) const
{
  const std::vector<char>& is_frozen = m->scan.gaps.is_frozen;
  const bool stays = !m->seen.is_noisy || (!is_frozen.empty() && is_frozen[i]) || is_outlier(i);
  return stays ? m->scan.points[i] : m->world(m->seen.points[m->place(i)]);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Vec3 Deep_points::denoised_normal(std::size_t i) const { return m->seen.normals[m->place(i)]; }

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_IMPL_H
