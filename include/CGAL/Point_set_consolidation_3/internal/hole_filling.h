// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FILLING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FILLING_H

#include <CGAL/Point_set_consolidation_3/internal/placement_guard.h>
#include <CGAL/Point_set_consolidation_3/internal/rim_surfaces.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What fills a hole.
struct Hole {
  Points points, normals;
};

/// Fairs what iterative consolidation has grown over holes, and makes it as dense as the data; not in the paper.
class Hole_filling {
  static constexpr std::size_t spacing_neighbors = 6;
  static constexpr int most_passes = 8;         ///< each about halves the widest gaps

public:
  /// All must outlive this object. `longest_gap` between neighbouring points of a hole.
  Hole_filling(const Execution& execution, const Points& data, const Points& normals, const Nearest_neighbors& tree,
               double h, double longest_gap, const Placement_guard& guard)
    : m_tree(tree), m_surfaces(data, normals, tree, h), m_guard(guard), m_longest_gap(longest_gap)
    , m_clearance(scan_clearance * median(neighbor_distances(execution, tree, data, spacing_neighbors)))
  {}

  /// Moves it onto the smooth surface through the data around, and fills it up there; not where a ray has passed.
  void run(Hole& hole) const
  {
    const Hermite_surface surface = m_surfaces.around(hole.points);
    Hole moved = hole;
    if(!surface.project(moved.points, moved.normals) ||
       std::any_of(moved.points.begin(), moved.points.end(),
                   [&](const Vec3& x) { return m_guard.is_seen_through(x); }))
      return;
    hole = std::move(moved);
    for(int pass = 0; pass < most_passes && fill_up(surface, hole); ++pass) {}
  }

private:
  /// Inserts points between those of a hole that are wide apart. Selected points are several times sparser than the
  /// data; Poisson reconstruction weighs points alike, and its surface over them would be uneven.
  bool fill_up(const Hermite_surface& surface, Hole& hole) const
  {
    const Sorted_grid grid(hole.points, m_longest_gap);
    const auto is_free = [&](const Vec3& x) {
      bool is_near = m_tree.nearest(x).squared_distance < m_clearance * m_clearance;
      grid.for_each_neighbor(x, m_clearance, [&](Index, double) { return !(is_near = true); });
      return !is_near;
    };
    Hole inserted;
    for(std::size_t i = 0; i < hole.points.size(); ++i)
      grid.for_each_neighbor(hole.points[i], m_longest_gap, [&](Index j, double squared_distance) {
        if(j <= i || squared_distance < 4 * m_clearance * m_clearance || hole.normals[i].dot(hole.normals[j]) < 0)
          return true;
        Vec3 x = (hole.points[i] + hole.points[j]) / 2, normal = hole.normals[i];
        if(is_free(x) && surface.project(x, normal) && is_free(x) && !m_guard.is_seen_through(x)) {
          inserted.points.push_back(x);
          inserted.normals.push_back(normal);
        }
        return true;
      });
    for(const Index k : thinned(inserted.points, m_clearance)) {
      hole.points.push_back(inserted.points[k]);
      hole.normals.push_back(inserted.normals[k]);
    }
    return !inserted.points.empty();
  }

  const Nearest_neighbors& m_tree;
  Rim_surfaces m_surfaces;
  const Placement_guard& m_guard;
  double m_longest_gap, m_clearance;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FILLING_H
