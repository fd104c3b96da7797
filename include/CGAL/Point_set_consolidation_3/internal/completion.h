// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETION_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/ball_clip.h>
#include <CGAL/Point_set_consolidation_3/internal/ball_union.h>
#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/consolidated_input.h>
#include <CGAL/Point_set_consolidation_3/internal/scalar_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/internal/sinking.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>
#include <CGAL/Point_set_consolidation_3/internal/working_boxes.h>

#include <array>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Completion of a scan by balls at the sunk deep points: each ball is tangent to the surface at a
/// consolidated point and no larger than the data and the known free space allow; the union of
/// the balls, smoothed, is sampled where data are missing.
/// Lengths in units of the spacing r of S; sp is the spacing of the data.

struct Completion_parameters {
  double grid_step = 0.7;
  double smoothing = 0.75;            ///< of the union; 2 collapses tubes, 0.5 leaves scallops
  double least_gap = 6;               ///< in sp: Poisson bridges smaller gaps better
  double box_margin = 4;
  double one_view_depth = 0.6;        ///< of the longest side: how far behind the data there may be more
};

struct Completed_points {
  Points points, normals, inner;
  std::vector<double> distance;       ///< to the nearest datum, in r
  std::vector<char> is_clipped;       ///< the ball's radius is bounded by data or free space
  std::vector<char> is_unanchored;    ///< nothing opposes: the depth is a guess
};

class Completion {
  static constexpr double largest_ball = 0.3;     ///< of the diagonal
  static constexpr double obstacle_distance = 2.5;  ///< in sp: nearer free space is the data's own
  static constexpr double most_nodes = 3e7;       ///< coarser grids beyond: 16 bytes a node
  static constexpr double wide_gap = 10;          ///< in r: half its width; never bridged well
  static constexpr double predictable = 0.12;     ///< of the balls' radius: between scans that gained and lost
  static constexpr double largest_miss = 6;       ///< in r: farther is equally wrong

public:
  Completion(Execution& execution, const Consolidated_input& input, const Seen_part& seen,
             const Sunk_points& sunk, const Free_space& free_space,
             const Completion_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_input(input), m_seen(seen), m_sunk(sunk)
    , m_free_space(free_space), m_data_tree(seen.points)
  {}

  Completed_points run(Stage& stage)
  {
    const std::vector<Bounding_box> boxes =
      working_boxes(m_input.points, m_free_space, m_parameters.box_margin,
                    m_parameters.one_view_depth);
    const double step = grid_step(boxes);
    std::vector<Scalar_grid> free_space(boxes.size());
    Points obstacles;
    for(std::size_t b = 0; b < boxes.size(); ++b) {
      free_space[b] = free_space_grid(boxes[b], step);
      add_free_space_border(free_space[b], obstacles);
      stage.update(0.3 * double(b + 1) / double(boxes.size()));
    }
    m_balls = Ball_clip(m_execution, m_input.points, m_sunk.normals, obstacles)
                .clip(m_sunk.anchors, largest_ball * longest_diagonal(boxes),
                      m_free_space.number_of_views() == 1);
    stage.update(0.5);
    Completed_points completed;
    for(std::size_t b = 0; b < boxes.size(); ++b) {
      Scalar_grid solid = Ball_union::make(m_execution, boxes[b], step, m_balls,
                                           m_free_space.empty() ? nullptr : &free_space[b]);
      free_space[b] = Scalar_grid();
      solid.smooth(m_execution, m_parameters.smoothing);
      Completed_points part = sample(solid);
      correct_border(solid, part);
      remove_seen_through(part);
      append(completed.points, part.points);
      append(completed.normals, part.normals);
      append(completed.distance, part.distance);
      stage.update(0.5 + 0.5 * double(b + 1) / double(boxes.size()));
    }
    leave_out_bridgeable_gaps(completed);
    describe(completed);
    return completed;
  }

private:
  double data_distance(const Vec3& x) const
  {
    return std::sqrt(m_data_tree.nearest(x).squared_distance);
  }

  template <typename T>
  static void append(std::vector<T>& to, const std::vector<T>& from)
  {
    to.insert(to.end(), from.begin(), from.end());
  }

  double grid_step(const std::vector<Bounding_box>& boxes) const
  {
    double nodes = 0;
    for(const Bounding_box& box : boxes)
      nodes += Scalar_grid::nodes_of(box, m_parameters.grid_step);
    return m_parameters.grid_step * (std::max)(1., std::cbrt(nodes / most_nodes));
  }

  static double longest_diagonal(const std::vector<Bounding_box>& boxes)
  {
    double longest = 0;
    for(const Bounding_box& box : boxes)
      longest = (std::max)(longest, box.diagonal());
    return longest;
  }

  template <typename Value>
  void fill(Scalar_grid& grid, const Value& value) const
  {
    const std::size_t rows = std::size_t(grid.size(1)) * std::size_t(grid.size(2));
    parallel_for(m_execution, rows, [&](std::size_t r) {
      const int y = int(r % std::size_t(grid.size(1))), z = int(r / std::size_t(grid.size(1)));
      float* const row = grid.row(y, z);
      for(int x = 0; x < grid.size(0); ++x)
        row[x] = float(value(grid.node(x, y, z)));
    });
  }

  Scalar_grid free_space_grid(const Bounding_box& box, double step) const
  {
    Scalar_grid phi;
    if(m_free_space.empty())
      return phi;
    phi = Scalar_grid(box, step, 0.f);
    fill(phi, [&](const Vec3& x) {
      return (std::min)(Ball_union::band, (std::max)(-Ball_union::band, m_free_space(x)));
    });
    return phi;
  }

  static Vec3 crossing(const Scalar_grid& grid, std::size_t i, std::size_t j)
  {
    const double a = grid[i], b = grid[j];
    return grid.node(i) + a / (a - b) * (grid.node(j) - grid.node(i));
  }

  /// Where known free space begins, away from the data.
  void add_free_space_border(const Scalar_grid& phi, Points& obstacles) const
  {
    if(m_free_space.empty())
      return;
    Points border;
    phi.for_each_edge([&](std::size_t i, std::size_t j, int) {
      if((phi[i] > 0) != (phi[j] > 0))
        border.push_back(crossing(phi, i, j));
    });
    std::vector<char> is_far(border.size());
    const double near = obstacle_distance * m_seen.spacing;
    parallel_for(m_execution, border.size(),
                 [&](std::size_t i) { is_far[i] = char(data_distance(border[i]) > near); });
    Points far;
    for(std::size_t i = 0; i < border.size(); ++i)
      if(is_far[i])
        far.push_back(border[i]);
    append(obstacles, selected(far, thinned(far, 1.)));
  }

  /// From the data to the first completed point; less on parts that are thinner than that.
  double least_distance(double ball_radius) const
  {
    constexpr double thin = 3;  // in sp: nearer points would disturb the data
    return m_seen.spacing *
           (std::max)(thin, (std::min)(m_parameters.least_gap, ball_radius / m_seen.spacing));
  }

  /// The surface of the solid where no data are near.
  Completed_points sample(const Scalar_grid& solid) const
  {
    const std::vector<char> is_outside = Ball_union::outside(solid);
    Points crossings;
    solid.for_each_edge([&](std::size_t i, std::size_t j, int) {
      const bool enters = (is_outside[i] && solid[j] <= 0) || (is_outside[j] && solid[i] <= 0);
      if(enters)
        crossings.push_back(crossing(solid, i, j));
    });
    std::vector<double> distance(crossings.size()), least(crossings.size());
    const Nearest_neighbors centres(m_balls.centres);
    parallel_for(m_execution, crossings.size(), [&](std::size_t i) {
      distance[i] = data_distance(crossings[i]);
      least[i] = least_distance(m_balls.radius[centres.nearest(crossings[i]).index]);
    });
    Completed_points completed;
    Points far, normals;
    for(std::size_t i = 0; i < crossings.size(); ++i) {
      if(distance[i] < least[i])
        continue;
      const Vec3 normal = normalized_or(solid.gradient(crossings[i]), Vec3::Zero());
      if(normal.isZero())
        continue;
      far.push_back(crossings[i]);
      normals.push_back(normal);
      completed.distance.push_back(distance[i]);
    }
    const std::vector<Index> kept = thinned(far, m_seen.spacing);
    completed.points = selected(far, kept);
    completed.normals = selected(normals, kept);
    completed.distance = selected(completed.distance, kept);
    return completed;
  }

  /// The solid passes the data at G(c_j) != 0; completed points near the border follow it, so
  /// that there is no step.
  void correct_border(const Scalar_grid& solid, Completed_points& completed) const
  {
    const double sp = m_seen.spacing;
    std::vector<double> offset(m_seen.points.size());
    parallel_for(m_execution, offset.size(), [&](std::size_t j) {
      offset[j] = (std::min)(2., (std::max)(-2., solid(m_seen.points[j])));
    });
    const Sorted_grid data(m_seen.points, 4 * sp);
    const Nearest_neighbors centres(m_balls.centres);
    const std::size_t n = completed.points.size();
    std::vector<double> delta(n), smoothed(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const Vec3 &x = completed.points[i], &normal = completed.normals[i];
      const double radius = (std::max)(2 * completed.distance[i], 4 * sp);
      double sum = 0, weight = 0;
      data.for_each_neighbor(x, radius, [&](Index j, double d2) {
        const double cosine = m_seen.normals[j].dot(normal);
        if(cosine > 0.2) {
          const double k = cosine * std::exp(-4 * d2 / (radius * radius));
          sum += k * offset[j];
          weight += k;
        }
        return true;
      });
      const double ball = (std::max)(2., m_balls.radius[centres.nearest(x).index]);
      const double far = completed.distance[i] / (1.5 * ball);
      delta[i] = weight > 0 ? sum / weight / (1 + far * far) : 0;
    });
    const Sorted_grid around(completed.points, 4 * sp);
    parallel_for(m_execution, n, [&](std::size_t i) {
      double sum = 0, weight = 0;
      around.for_each_neighbor(completed.points[i], 4 * sp, [&](Index j, double d2) {
        if(completed.normals[j].dot(completed.normals[i]) > 0.3) {
          const double k = std::exp(-4 * d2 / (16 * sp * sp));
          sum += k * delta[j];
          weight += k;
        }
        return true;
      });
      smoothed[i] = sum / weight;
    });
    for(std::size_t i = 0; i < n; ++i)
      completed.points[i] += smoothed[i] * completed.normals[i];
  }

  /// The correction may have moved points to where a ray has passed.
  void remove_seen_through(Completed_points& completed) const
  {
    constexpr double tolerance = 0.5;
    std::vector<Index> kept;
    for(std::size_t i = 0; i < completed.points.size(); ++i)
      if(m_free_space.empty() || m_free_space(completed.points[i]) <= tolerance)
        kept.push_back(Index(i));
    completed.points = selected(completed.points, kept);
    completed.normals = selected(completed.normals, kept);
    completed.distance = selected(completed.distance, kept);
  }

  /// The mesher bridges narrow gaps better than balls that are only roughly right. Wide gaps are always
  /// completed; the narrow ones if the balls from beyond them predict the data at their borders well. They are
  /// completed together or not at all: the level that Poisson reconstruction extracts belongs to all
  /// points, and thin parts left open beside closed ones would be lost. After one view, where
  /// everything is open, all are completed.
  void leave_out_bridgeable_gaps(Completed_points& completed) const
  {
    if(m_free_space.number_of_views() == 1)
      return;
    const std::size_t n = completed.points.size();
    const Nearest_neighbors centres(m_balls.centres);
    std::vector<Index> nearest_datum(n);
    std::vector<double> radius(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      nearest_datum[i] = m_data_tree.nearest(completed.points[i]).index;
      radius[i] = m_balls.radius[centres.nearest(completed.points[i]).index];
    });
    std::vector<Index> wide, narrow;
    double error = 0;
    const double link = 3 * m_seen.spacing;  // completed points are one spacing apart
    for(const std::vector<Index>& gap : connected_components(completed.points, link)) {
      double width = 0;
      for(const Index i : gap)
        width = (std::max)(width, completed.distance[i]);
      if(width > wide_gap) {
        append(wide, gap);
        continue;
      }
      append(narrow, gap);
      error += double(gap.size()) * prediction_error(selected(nearest_datum, gap), width) /
               median(selected(radius, gap));
    }
    if(error < predictable * double(narrow.size()))
      append(wide, narrow);
    std::sort(wide.begin(), wide.end());
    completed.points = selected(completed.points, wide);
    completed.normals = selected(completed.normals, wide);
    completed.distance = selected(completed.distance, wide);
  }

  /// How far the balls that touch the surface beyond `distance` miss the data at the border of a gap.
  double prediction_error(std::vector<Index> border, double distance) const
  {
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    std::vector<double> error(border.size());
    parallel_for(m_execution, border.size(), [&](std::size_t b) {
      const Vec3& x = m_seen.points[border[b]];
      std::array<double, Ball_union::agreeing_balls> nearest;
      nearest.fill(largest_miss);
      for(std::size_t i = 0; i < m_balls.centres.size(); ++i)
        if((m_input.points[i] - x).norm() > distance) {
          double d = (x - m_balls.centres[i]).norm() - m_balls.radius[i];
          for(double& slot : nearest)
            if(d < slot)
              std::swap(d, slot);
        }
      error[b] = (std::min)(largest_miss, std::abs(nearest.back()));
    });
    return mean(error);
  }

  void describe(Completed_points& completed) const
  {
    const Nearest_neighbors centres(m_balls.centres);
    const std::size_t n = completed.points.size();
    completed.inner.resize(n);
    completed.is_clipped.resize(n);
    completed.is_unanchored.resize(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const std::size_t ball = centres.nearest(completed.points[i]).index;
      completed.inner[i] = m_balls.centres[ball];
      completed.is_clipped[i] = m_balls.is_clipped[ball];
      completed.is_unanchored[i] = char(m_sunk.anchoring[ball] == Anchoring::unanchored);
      completed.distance[i] = data_distance(completed.points[i]);
    });
  }

  Execution& m_execution;
  Completion_parameters m_parameters;
  const Consolidated_input& m_input;
  const Seen_part& m_seen;
  const Sunk_points& m_sunk;
  const Free_space& m_free_space;
  Nearest_neighbors m_data_tree;
  Balls m_balls;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETION_H
