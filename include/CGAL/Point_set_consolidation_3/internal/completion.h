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
#include <CGAL/Point_set_consolidation_3/internal/consolidated_input.h>
#include <CGAL/Point_set_consolidation_3/internal/gap_selection.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/scalar_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/internal/sinking.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>
#include <CGAL/Point_set_consolidation_3/internal/working_boxes.h>
#include <CGAL/Point_set_consolidation_3/internal/zero_set_samples.h>

#include <memory>

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
  Gap_parameters gaps;
};

class Completion {
  static constexpr double largest_ball = 0.3;     ///< of the diagonal
  static constexpr double obstacle_distance = 2.5;  ///< in sp: nearer free space is the data's own
  static constexpr double image_uncertainty = 2;  ///< like completed points at this distance from data
  static constexpr double below_data = 0.5;       ///< there the solid must be
  static constexpr double thin_part = 3;          ///< radius of balls beyond which the solid is sampled anyway
  static constexpr double thickest_back = 6;
  static constexpr double most_nodes = 3e7;       ///< coarser grids beyond: 16 bytes a node

public:
  Completion(Execution& execution, const Consolidated_input& input, const Seen_part& seen,
             const Sunk_points& sunk, const Free_space& free_space,
             const Completion_parameters& parameters)
    : Completion(execution, input, seen, sunk, free_space, parameters, seen.points.size())
  {}

  /// Only the first `measured` points of the seen part are data; the others, images by symmetry, are
  /// completed points that are known before.
  Completion(Execution& execution, const Consolidated_input& input, const Seen_part& seen,
             const Sunk_points& sunk, const Free_space& free_space,
             const Completion_parameters& parameters, std::size_t measured)
    : m_execution(execution), m_parameters(parameters), m_input(input), m_seen(seen), m_sunk(sunk)
    , m_free_space(free_space), m_measured(measured), m_data_tree(execution, seen.points)
  {}

  Completed_points run(Stage& stage)
  {
    std::vector<Bounding_box> boxes =
      working_boxes(m_input.points, m_free_space, m_parameters.box_margin,
                    m_parameters.one_view_depth);
    const bool is_one_view = m_free_space.number_of_views() == 1;
    m_balls = Ball_clip(m_execution, m_input.points, m_sunk.normals, obstacles(boxes))
                .clip(m_sunk.anchors, largest_ball * longest_diagonal(boxes), is_one_view);
    m_centre_tree = std::make_unique<Nearest_neighbors>(m_balls.centres);
    stage.update(0.4);
    if(!is_one_view)  // else the box is as deep as completion may go
      boxes = holding_balls(std::move(boxes), m_input.points, m_balls.centres, m_balls.radius,
                            m_parameters.box_margin);
    const double step = grid_step(boxes);
    Completed_points completed;
    for(std::size_t b = 0; b < boxes.size(); ++b) {
      Scalar_grid solid = union_of_balls(boxes[b], step);
      solid.smooth(m_execution, m_parameters.smoothing);
      Completed_points part = sample(solid);
      correct_border(solid, part);
      part.keep_if([&](const Vec3& x) { return !is_seen_through(x) && !is_mere_guess(x); });
      completed.append(part);
      note_missed(boxes[b], solid);
      stage.update(0.4 + 0.6 * double(b + 1) / double(boxes.size()));
    }
    completed = Gap_selection(m_execution, m_input.points, m_seen, m_data_tree, m_balls, m_free_space,
                              m_parameters.gaps)
                  .run(completed, is_one_view, m_free_space.empty());
    if(is_one_view)
      completed.append(thin_backs(completed));
    for(std::size_t j = m_measured; j < m_seen.points.size(); ++j) {
      completed.points.push_back(m_seen.points[j]);
      completed.normals.push_back(m_seen.normals[j]);
      completed.distance.push_back(0);
    }
    describe(completed);
    return completed;
  }

private:
  double data_distance(const Vec3& x) const
  {
    return std::sqrt(m_data_tree.nearest(x).squared_distance);
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

  Scalar_grid union_of_balls(const Bounding_box& box, double step) const
  {
    if(m_free_space.empty())
      return Ball_union::make(m_execution, box, step, m_balls, nullptr);
    const Scalar_grid phi = free_space_grid(box, step);
    return Ball_union::make(m_execution, box, step, m_balls, &phi);
  }

  Scalar_grid free_space_grid(const Bounding_box& box, double step) const
  {
    Scalar_grid phi(box, step, 0.f);
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
  Points obstacles(const std::vector<Bounding_box>& boxes) const
  {
    Points result;
    if(!m_free_space.empty())
      for(const Bounding_box& box : boxes) {
        const Points border = free_space_border(free_space_grid(box, grid_step(boxes)));
        result.insert(result.end(), border.begin(), border.end());
      }
    return result;
  }

  Points free_space_border(const Scalar_grid& phi) const
  {
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
    return selected(far, thinned(far, 1.));
  }

  /// From the data to the first completed point; less on parts that are thinner than that.
  double least_distance(double ball_radius) const
  {
    constexpr double thin = 3;  // in sp: nearer points would disturb the data
    return m_seen.spacing *
           (std::max)(thin, (std::min)(m_parameters.least_gap, ball_radius / m_seen.spacing));
  }

  /// The surface of the solid where no data are near, as dense as the data: Poisson reconstruction weighs points alike,
  /// and the level that it extracts moves off the data if there are fewer elsewhere.
  Completed_points sample(const Scalar_grid& solid) const
  {
    Points samples = Zero_set_samples::find(m_execution, solid, Ball_union::outside(solid));
    samples = selected(samples, thinned(samples, scan_clearance * m_seen.spacing));
    std::vector<double> distance(samples.size()), least(samples.size());
    parallel_for(m_execution, samples.size(), [&](std::size_t i) {
      distance[i] = data_distance(samples[i]);
      least[i] = least_distance(m_balls.radius[m_centre_tree->nearest(samples[i]).index]);
    });
    Completed_points completed;
    for(std::size_t i = 0; i < samples.size(); ++i) {
      if(distance[i] < least[i])
        continue;
      const Vec3 normal = normalized_or(solid.gradient(samples[i]), Vec3::Zero());
      if(normal.isZero())
        continue;
      completed.points.push_back(samples[i]);
      completed.normals.push_back(normal);
      completed.distance.push_back(distance[i]);
    }
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
      const double ball = (std::max)(2., m_balls.radius[m_centre_tree->nearest(x).index]);
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

  /// Data that the solid does not reach: parts that are too thin for it.
  void note_missed(const Bounding_box& box, const Scalar_grid& solid)
  {
    m_is_missed.resize(m_seen.points.size(), 0);
    parallel_for_places(m_execution, m_seen.points, [&](std::size_t j) {
      const Vec3 x = m_seen.points[j] - below_data * m_seen.normals[j];
      if(box.contains(x) && solid(x) > 0)
        m_is_missed[j] = 1;
    });
  }

  /// A sheet of data that nothing closes would be lost beside closed ones, because the level that Poisson
  /// reconstruction extracts belongs to all points. It gets a back as far behind as its balls are thick.
  Completed_points thin_backs(const Completed_points& completed) const
  {
    const double sp = m_seen.spacing;
    const Sorted_grid data(m_seen.points, 4 * sp), others(completed.points, 4 * sp);
    const Nearest_neighbors particles(m_input.points);
    std::vector<Vec3> back(m_seen.points.size());
    std::vector<char> is_open(m_seen.points.size(), 0);
    parallel_for_places(m_execution, m_seen.points, [&](std::size_t j) {
      const Vec3 &x = m_seen.points[j], &n = m_seen.normals[j];
      const double radius = m_balls.radius[particles.nearest(x).index];
      if(!m_is_missed[j] && radius > thin_part)
        return;
      const double thickness = (std::max)(3 * sp, (std::min)(2 * radius, thickest_back));
      const Gap_parameters& gaps = m_parameters.gaps;
      if(thickness > gaps.largest || (!gaps.is_frozen.empty() && gaps.is_frozen[j]))
        return;
      back[j] = x - thickness * n;
      bool is_closed = is_seen_through(back[j]);
      const auto closes = [&](const Vec3& p, const Vec3& normal) {
        is_closed = is_closed || ((x - p).dot(n) > 0.3 * (x - p).norm() && normal.dot(n) < -0.2);
        return !is_closed;
      };
      data.for_each_neighbor(x, 1.5 * thickness + 2 * sp, [&](Index k, double) {
        return closes(m_seen.points[k], m_seen.normals[k]);
      });
      others.for_each_neighbor(x, 1.5 * thickness + 2 * sp, [&](Index k, double) {
        return closes(completed.points[k], completed.normals[k]);
      });
      data.for_each_neighbor(back[j], 1.5 * sp, [&](Index, double) { return !(is_closed = true); });
      others.for_each_neighbor(back[j], sp, [&](Index, double) { return !(is_closed = true); });
      is_open[j] = char(!is_closed);
    });
    Completed_points backs;
    for(std::size_t j = 0; j < back.size(); ++j)
      if(is_open[j]) {
        backs.points.push_back(back[j]);
        backs.normals.push_back(-m_seen.normals[j]);
        backs.distance.push_back(data_distance(back[j]));
      }
    return backs.part(thinned(backs.points, scan_clearance * sp));
  }

  /// The correction may have moved points to where a ray has passed.
  bool is_seen_through(const Vec3& x) const
  {
    constexpr double tolerance = 0.5;
    return !m_free_space.empty() && m_free_space(x) > tolerance;
  }

  /// Nothing bounds the depth of a sheet that nothing opposes if the caller knows no rays either.
  bool is_mere_guess(const Vec3& x) const
  {
    return (m_free_space.empty() || m_input.directions.is_estimated) &&
           m_sunk.anchoring[m_centre_tree->nearest(x).index] == Anchoring::unanchored;
  }

  void describe(Completed_points& completed) const
  {
    const std::size_t n = completed.points.size();
    completed.inner.resize(n);
    completed.is_clipped.resize(n);
    completed.is_unanchored.resize(n);
    completed.uncertainty.resize(n);
    std::unique_ptr<Nearest_neighbors> measured;
    if(m_measured < m_seen.points.size())
      measured = std::make_unique<Nearest_neighbors>(
        Points(m_seen.points.begin(), m_seen.points.begin() + std::ptrdiff_t(m_measured)));
    parallel_for(m_execution, n, [&](std::size_t i) {
      const std::size_t ball = m_centre_tree->nearest(completed.points[i]).index;
      completed.inner[i] = m_balls.centres[ball];
      completed.is_clipped[i] = m_balls.is_clipped[ball];
      completed.is_unanchored[i] = char(m_sunk.anchoring[ball] == Anchoring::unanchored);
      const Neighbor known = m_data_tree.nearest(completed.points[i]);
      completed.distance[i] = completed.uncertainty[i] = std::sqrt(known.squared_distance);
      if(known.index >= m_measured)
        completed.uncertainty[i] += image_uncertainty;
      if(measured)
        completed.distance[i] = std::sqrt(measured->nearest(completed.points[i]).squared_distance);
    });
  }

  Execution& m_execution;
  Completion_parameters m_parameters;
  const Consolidated_input& m_input;
  const Seen_part& m_seen;
  const Sunk_points& m_sunk;
  const Free_space& m_free_space;
  std::size_t m_measured;
  Nearest_neighbors m_data_tree;
  Balls m_balls;
  std::vector<char> m_is_missed;   ///< of the data
  std::unique_ptr<Nearest_neighbors> m_centre_tree;   ///< of the balls
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETION_H
