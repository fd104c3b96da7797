// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAP_SELECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAP_SELECTION_H

#include <CGAL/Point_set_consolidation_3/internal/ball_clip.h>
#include <CGAL/Point_set_consolidation_3/internal/ball_union.h>
#include <CGAL/Point_set_consolidation_3/internal/completed_points.h>
#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/data_hull.h>
#include <CGAL/Point_set_consolidation_3/internal/flat_closure.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/gaps.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/rim_surfaces.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>

#include <array>
#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Gaps are the connected components of completed points. Each is closed by the prior of its border, or left
/// open: if the caller wants it so, or if the mesher bridges it better.
class Gap_selection {
  static constexpr double link = 3;               ///< in sp: several times the distance of completed points
  static constexpr double least_distance = 3;     ///< in sp, of flat and smooth closures from the data
  static constexpr double wide_gap = 10;          ///< in r: half its width; never bridged well
  static constexpr double predictable = 0.12;     ///< of the balls' radius: between scans that gained and lost
  static constexpr double largest_miss = 6;       ///< in r: farther is equally wrong
  static constexpr double least_share = 0.06;     ///< of the data: gaps with fewer points in all are bridged well
  /// Smooth closures predict their error: they are trusted up to these shares of half the gap's width, by which they
  /// deviate, and by which they move the hull of the balls. Where the hull is trusted, they must be better: the
  /// mesher misses by 0.12, the hull by 0.07.
  static constexpr double largest_deviation = 0.1, largest_move = 0.3, better_than_balls = 0.07;
  /// Share of the narrow gaps that must have a smooth closure: to take the place of trusted balls, and to be closed
  /// beside others that stay open. Between scans that gained and lost.
  static constexpr double replacing_share = 0.9, closing_share = 0.75;
  static constexpr double most_seen_through = 0.2;  ///< share of a smooth closure
  static constexpr double free_space_tolerance = 0.5;  ///< in r, as of all completed points
  static constexpr double smoothing_reach = 10;   ///< in sp
  static constexpr std::size_t least_points = 100;  ///< the mesher bridges smaller gaps
  static constexpr std::size_t least_centres = 20, tested_points = 100;
  /// A gap whose closure leaves the data's hull farther than both is a balloon: share of the data's
  /// diagonal, and of the closure's largest distance from the data (0.7 at the round end of a tube).
  static constexpr double least_swelling = 0.05, swelling_share = 0.8;
  /// The same for smooth closures: 0.39 where they gained, 0.49 and 0.8 where they lost.
  static constexpr double smooth_swelling_share = 0.45;

public:
  Gap_selection(Execution& execution, const Points& particles, const Seen_part& seen,
                const Nearest_neighbors& data_tree, const Balls& balls, const Free_space& free_space,
                const Gap_parameters& parameters)
    : m_execution(execution), m_particles(particles), m_seen(seen), m_data_tree(data_tree)
    , m_balls(balls), m_free_space(free_space), m_centre_tree(balls.centres)
    , m_surfaces(seen.points, seen.normals, data_tree, smoothing_reach * seen.spacing), m_parameters(parameters)
  {}

  /// `is_all_open`: after one view everything is open, and all gaps are completed. `is_blind`: no rays are
  /// known, so that nothing else bounds how far a gap's closure swells.
  Completed_points run(const Completed_points& completed, bool is_all_open, bool is_blind)
  {
    if(is_blind) {
      m_hull = std::make_unique<Data_hull>(m_particles);
      m_diagonal = bounding_box(m_particles).diagonal();
    }
    m_closed = Completed_points();
    m_narrow.clear();
    Completed_points allowed = completed;
    if(!m_parameters.is_frozen.empty())
      allowed.keep_if([&](const Vec3& x) {
        return !m_parameters.is_frozen[m_data_tree.nearest(x).index];
      });
    for(const std::vector<Index>& gap : connected_components(allowed.points, link * m_seen.spacing))
      sort_in(allowed, gap, is_all_open);
    close_narrow();
    return std::move(m_closed);
  }

private:
  /// A gap that the mesher might bridge better.
  struct Narrow_gap {
    Completed_points by_balls;  ///< the hull of the balls
    Completed_points smooth;    ///< none if no smooth surface is trusted
    double half_width = 0;
    double error = 0;           ///< predicted of the hull, by the balls' radius
    double deviation = 0;       ///< of the smooth surface, by half the gap's width

    bool is_smooth() const { return !smooth.points.empty(); }
  };

  void sort_in(const Completed_points& completed, std::vector<Index> indices, bool is_all_open)
  {
    std::sort(indices.begin(), indices.end());
    Completed_points gap = completed.part(indices);
    const double half_width = *std::max_element(gap.distance.begin(), gap.distance.end());
    if(2 * half_width > m_parameters.largest || is_balloon(gap, half_width))
      return;
    const std::vector<Index> border = border_of(m_execution, m_data_tree, gap.points);
    const Prior prior = m_parameters.prior_of(border);
    if(prior == Prior::FLAT)
      close_flat(gap, border);
    else if(prior == Prior::MINIMAL_VOLUME)
      shrink(gap);
    const bool is_wide = half_width > wide_gap && !m_hull;  // where no rays are known the mesher swells less
    if(is_all_open || prior != Prior::VOLUME_PRESERVING || is_wide) {
      m_closed.append(gap);
      return;
    }
    Narrow_gap narrow;
    narrow.half_width = half_width;
    narrow.error = prediction_error(border, half_width) / typical_radius(gap);
    narrow.by_balls = std::move(gap);
    m_narrow.push_back(std::move(narrow));
  }

  /// The narrow ones are completed together or not at all: the level that Poisson reconstruction extracts belongs to
  /// all points, and thin parts left open beside closed ones would be lost, or tied to others by webs.
  void close_narrow()
  {
    parallel_for(m_execution, m_narrow.size(), [&](std::size_t k) { close_smoothly(m_narrow[k]); }, long_bodies);
    double points = 0, error = 0, smooth_points = 0, deviation = 0;
    for(const Narrow_gap& gap : m_narrow) {
      const double number = double(gap.by_balls.points.size());
      points += number;
      error += number * gap.error;
      if(gap.is_smooth()) {
        smooth_points += number;
        deviation += number * gap.deviation;
      }
    }
    const double smooth_share = smooth_points / (std::max)(1., points);
    const bool are_balls_right =
      error < predictable * points && points > least_share * double(m_seen.points.size());
    const bool is_smooth_right = are_balls_right ? smooth_share >= replacing_share &&
                                                     deviation <= better_than_balls * smooth_points
                                                 : smooth_share > closing_share;
    if(is_smooth_right)
      for(const Narrow_gap& gap : m_narrow)
        m_closed.append(gap.smooth);
    if(are_balls_right)
      for(const Narrow_gap& gap : m_narrow)
        if(!is_smooth_right || !gap.is_smooth())
          m_closed.append(gap.by_balls);
  }

  bool is_balloon(const Completed_points& gap, double half_width) const
  {
    return swells_beyond((std::max)(least_swelling * m_diagonal, swelling_share * half_width), gap);
  }

  bool swells_beyond(double most, const Completed_points& gap) const
  {
    return m_hull && std::any_of(gap.points.begin(), gap.points.end(),
                                 [&](const Vec3& x) { return m_hull->distance(x) > most; });
  }

  /// Onto the smooth surface that goes on from the data around, if that predicts itself well.
  void close_smoothly(Narrow_gap& gap) const
  {
    const Points& points = gap.by_balls.points;
    if(points.size() < least_points || m_seen.is_noisy)  // the deviation knows nothing of errors of the normals
      return;
    const Hermite_surface surface = m_surfaces.around(points);
    Completed_points closed = gap.by_balls;
    if(surface.number_of_centres() < least_centres || !surface.project(closed.points, closed.normals))
      return;
    const std::size_t stride = 1 + points.size() / tested_points;
    std::vector<double> deviations, moves;
    for(std::size_t i = 0; i < closed.points.size(); i += stride) {
      deviations.push_back(surface.deviation(closed.points[i]));
      moves.push_back((closed.points[i] - points[i]).norm());
    }
    gap.deviation = mean(deviations) / gap.half_width;
    if(!(gap.deviation < largest_deviation) || mean(moves) > largest_move * gap.half_width)
      return;
    std::vector<Index> kept;
    std::size_t seen_through = 0;
    for(std::size_t i = 0; i < closed.points.size(); ++i) {
      const Vec3& x = closed.points[i];
      closed.distance[i] = std::sqrt(m_data_tree.nearest(x).squared_distance);
      if(m_free_space(x) > free_space_tolerance)
        ++seen_through;
      else if(closed.distance[i] >= least_distance * m_seen.spacing)
        kept.push_back(Index(i));
    }
    if(kept.empty() || double(seen_through) > most_seen_through * double(closed.points.size()))
      return;
    closed = closed.part(kept);
    if(!swells_beyond(smooth_swelling_share * gap.half_width, closed))
      gap.smooth = std::move(closed);
  }

  /// A plane through the border, or the gap as it is if the border is far from flat.
  void close_flat(Completed_points& gap, const std::vector<Index>& border) const
  {
    Vec3 outwards = Vec3::Zero();
    for(const Vec3& n : gap.normals)
      outwards += n;
    const Closing_plane plane = closing_plane(m_seen.points, border, outwards);
    if(!plane.is_valid())
      return;
    Points points;
    std::vector<double> distance;
    for(const Vec3& x : gap.points) {
      const Vec3 y = plane.projected(x);
      const double d = std::sqrt(m_data_tree.nearest(y).squared_distance);
      if(d >= least_distance * m_seen.spacing) {
        points.push_back(y);
        distance.push_back(d);
      }
    }
    const std::vector<Index> kept = thinned(points, scan_clearance * m_seen.spacing);
    gap.points = selected(points, kept);
    gap.distance = selected(distance, kept);
    gap.normals.assign(kept.size(), plane.normal);
  }

  /// Equation (9): lengths decay with the distance from the data.
  void shrink(Completed_points& gap) const
  {
    parallel_for(m_execution, gap.points.size(), [&](std::size_t i) {
      const Vec3& centre = m_balls.centres[m_centre_tree.nearest(gap.points[i]).index];
      const double share = std::pow(1 - m_parameters.shrinkage, gap.distance[i]);
      gap.points[i] = centre + share * (gap.points[i] - centre);
    });
  }

  double typical_radius(const Completed_points& gap) const
  {
    std::vector<double> radius(gap.points.size());
    parallel_for(m_execution, radius.size(), [&](std::size_t i) {
      radius[i] = m_balls.radius[m_centre_tree.nearest(gap.points[i]).index];
    });
    return median(radius);
  }

  /// How far the balls that touch the surface beyond `distance` miss the data at the border of a gap: the
  /// mesher bridges narrow gaps better than balls that are only roughly right.
  double prediction_error(const std::vector<Index>& border, double distance) const
  {
    std::vector<double> error(border.size());
    parallel_for(m_execution, border.size(), [&](std::size_t b) {
      const Vec3& x = m_seen.points[border[b]];
      std::array<double, Ball_union::agreeing_balls> nearest;
      nearest.fill(largest_miss);
      for(std::size_t i = 0; i < m_balls.centres.size(); ++i)
        if((m_particles[i] - x).norm() > distance) {
          double d = (x - m_balls.centres[i]).norm() - m_balls.radius[i];
          for(double& slot : nearest)
            if(d < slot)
              std::swap(d, slot);
        }
      error[b] = (std::min)(largest_miss, std::abs(nearest.back()));
    });
    return mean(error);
  }

  Execution& m_execution;
  const Points& m_particles;
  const Seen_part& m_seen;
  const Nearest_neighbors& m_data_tree;
  const Balls& m_balls;
  const Free_space& m_free_space;
  Nearest_neighbors m_centre_tree;
  Rim_surfaces m_surfaces;
  const Gap_parameters& m_parameters;
  std::unique_ptr<Data_hull> m_hull;   ///< of the data, if that bounds completion
  double m_diagonal = 0;               ///< of the data then
  Completed_points m_closed;
  std::vector<Narrow_gap> m_narrow;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_GAP_SELECTION_H
