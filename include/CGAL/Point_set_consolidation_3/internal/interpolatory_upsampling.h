// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INTERPOLATORY_UPSAMPLING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INTERPOLATORY_UPSAMPLING_H

#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/repulsion.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_frame.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-D: interpolatory refinement of oriented points, a sqrt(3)-like
/// scheme without connectivity after Guennebaud, Barthe and Paulin. Triangles of a centre and two
/// successive points of its ring get a point at their centroid, bulged by the normals.
///
/// Centres are refined in rounds instead of one queue: a round sees all points of the rounds before, its
/// candidates are found independently and accepted in the order of their centres.

class Interpolatory_upsampling {
  static constexpr double least_tangential_share = 0.3;  ///< of a neighbour's distance
  static constexpr double least_normal_cosine = 0.3;     ///< neighbours on the same sheet
  static constexpr double ring_separation = 0.86602540378443865;  ///< cos 30 degrees
  static constexpr double first_radius = 3;              ///< of the ring, in d_min
  static constexpr double two_pi = 2 * CGAL_PI;
  /// Termination is by distance: points are d_min apart in a bounded region. The bounds only guard
  /// against degenerate normals.
  static constexpr std::size_t most_rounds = 64;
  static constexpr std::size_t most_points_per_centre = 1000;

public:
  Interpolatory_upsampling(Execution& execution, const Upsampling_parameters& parameters,
                           Placement_test may_insert = {})
    : m_execution(execution), m_parameters(parameters), m_may_insert(std::move(may_insert)) {}

  /// Appends the inserted points to `points` and `normals`. Only `centres` are refined, and what is
  /// inserted around them.
  void run(Stage& stage, Points& points, Points& normals, std::vector<std::size_t> centres) const
  {
    const std::size_t first = points.size();
    const std::size_t limit =
      first + (std::min)(m_parameters.most_points,
                         most_points_per_centre * (std::max)(std::size_t(1), centres.size()));
    for(std::size_t round = 0; round < most_rounds && !centres.empty(); ++round) {
      const Candidates candidates = find_candidates(points, normals, centres);
      const std::vector<char> accepted = accept(candidates);
      std::vector<std::size_t> next;
      for(std::size_t c = 0, k = 0; c < centres.size(); ++c) {
        bool has_inserted = false;
        for(; k < candidates.first[c + 1]; ++k) {
          if(!accepted[k] || points.size() >= limit)
            continue;
          next.push_back(points.size());
          points.push_back(candidates.points[k]);
          normals.push_back(candidates.normals[k]);
          has_inserted = true;
        }
        if(has_inserted)
          next.push_back(centres[c]);
      }
      centres.swap(next);
      stage.count_iteration();
      stage.update(double(round + 1) / double(round + 3));
    }
  }

private:
  struct Candidates {
    Points points, normals;
    std::vector<std::size_t> first;  ///< of each centre
  };

  struct Ring_point {
    double angle;
    Index index;
  };

  Candidates find_candidates(const Points& points, const Points& normals,
                             const std::vector<std::size_t>& centres) const
  {
    const Sorted_grid grid(points, first_radius * m_parameters.least_distance);
    std::vector<Points> found(centres.size()), found_normals(centres.size());
    parallel_for_places(m_execution, selected(points, centres), [&](std::size_t c) {
      refine(grid, points, normals, centres[c], found[c], found_normals[c]);
    });
    Candidates candidates;
    candidates.first.assign(1, 0);
    for(std::size_t c = 0; c < centres.size(); ++c) {
      candidates.points.insert(candidates.points.end(), found[c].begin(), found[c].end());
      candidates.normals.insert(candidates.normals.end(), found_normals[c].begin(),
                                found_normals[c].end());
      candidates.first.push_back(candidates.points.size());
    }
    return candidates;
  }

  void refine(const Sorted_grid& grid, const Points& points, const Points& normals,
              std::size_t c, Points& found, Points& found_normals) const
  {
    const std::vector<Ring_point> ring = ring_of(grid, points, normals, c);
    const double widest = m_parameters.largest_gap / 360 * two_pi;
    for(std::size_t k = 0; k < ring.size() && ring.size() >= 2; ++k) {
      const Ring_point& a = ring[k];
      const Ring_point& b = ring[(k + 1) % ring.size()];
      const double gap = b.angle - a.angle + (k + 1 == ring.size() ? two_pi : 0);
      if(gap > widest)
        continue;
      const std::size_t triangle[3] = {c, a.index, b.index};
      Vec3 y = Vec3::Zero(), n = Vec3::Zero(), bulge = Vec3::Zero();
      for(const std::size_t v : triangle) {
        y += points[v] / 3;
        n += normals[v];
      }
      for(const std::size_t v : triangle)
        bulge += (points[v] - y).dot(normals[v]) * normals[v] / 3;
      y += m_parameters.bulge * bulge;
      n = normalized_or(n, normals[c]);
      if(is_free(grid, y) && (!m_may_insert || m_may_insert(y, n))) {
        found.push_back(y);
        found_normals.push_back(n);
      }
    }
  }

  /// Neighbours around the centre, one per direction, nearest first; sorted by angle. The radius grows
  /// until no gap is left open.
  std::vector<Ring_point> ring_of(const Sorted_grid& grid, const Points& points,
                                  const Points& normals, std::size_t c) const
  {
    const Vec3 &x = points[c], &n = normals[c];
    const Tangent_frame tangent(n);
    const double widest = m_parameters.largest_gap / 360 * two_pi;
    std::vector<Ring_point> ring;
    double radius = (std::min)(first_radius * m_parameters.least_distance,
                               m_parameters.support_radius);
    for(;;) {
      std::vector<std::pair<double, Index> > near;
      grid.for_each_neighbor(x, radius, [&](Index j, double d2) {
        if(j != c && d2 > 0 && normals[j].dot(n) > least_normal_cosine)
          near.emplace_back(d2, j);
        return true;
      });
      std::sort(near.begin(), near.end());
      ring.clear();
      std::vector<Vec3> directions;
      for(const auto& candidate : near) {
        const Vec3 d = points[candidate.second] - x;
        const Vec3 tangential(d.dot(tangent.u), d.dot(tangent.v), 0);
        const double length = tangential.norm();
        if(length <= least_tangential_share * std::sqrt(candidate.first))
          continue;
        const Vec3 direction = tangential / length;
        bool is_new = true;
        for(const Vec3& other : directions)
          is_new = is_new && direction.dot(other) <= ring_separation;
        if(!is_new)
          continue;
        directions.push_back(direction);
        ring.push_back({std::atan2(direction.y(), direction.x()), candidate.second});
      }
      std::sort(ring.begin(), ring.end(), [](const Ring_point& a, const Ring_point& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.index < b.index;
      });
      if(radius >= m_parameters.support_radius || largest_gap(ring) <= widest)
        return ring;
      radius = (std::min)(2 * radius, m_parameters.support_radius);
    }
  }

  static double largest_gap(const std::vector<Ring_point>& ring)
  {
    double gap = ring.empty() ? two_pi : ring.front().angle + two_pi - ring.back().angle;
    for(std::size_t k = 1; k < ring.size(); ++k)
      gap = (std::max)(gap, ring[k].angle - ring[k - 1].angle);
    return gap;
  }

  bool is_free(const Sorted_grid& grid, const Vec3& y) const
  {
    bool free = true;
    grid.for_each_neighbor(y, m_parameters.least_distance,
                           [&](Index, double) { return free = false; });
    return free;
  }

  /// Candidates that keep their distance from all accepted before them.
  std::vector<char> accept(const Candidates& candidates) const
  {
    const std::size_t n = candidates.points.size();
    const Sorted_grid grid(candidates.points, m_parameters.least_distance);
    std::vector<std::vector<Index> > rivals(n);  // those before it
    parallel_for_places(m_execution, grid, [&](std::size_t k) {
      grid.for_each_neighbor(candidates.points[k], m_parameters.least_distance, [&](Index j, double) {
        if(j < k)
          rivals[k].push_back(j);
        return true;
      });
    });
    std::vector<char> accepted(n, 0);
    for(std::size_t k = 0; k < n; ++k)
      accepted[k] = std::none_of(rivals[k].begin(), rivals[k].end(), [&](Index j) { return accepted[j]; });
    return accepted;
  }

  Execution& m_execution;
  Upsampling_parameters m_parameters;
  Placement_test m_may_insert;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INTERPOLATORY_UPSAMPLING_H
