// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H

#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Where a completed point may lie; not in the paper. The extension of a surface over its border is a guess
/// that holds for smooth holes; at thin and occluded parts it grows sheets that the shape does not have.
/// Lengths in units of h.

struct Guard_parameters {
  bool enabled = true;
  /// A ray of the scanner passed there. The tolerance covers the silhouettes' sampling.
  double free_space_tolerance = 0.25;
  /// Points nearer than this to a sheet that faces the other way lie in a thin part or in a gap.
  double opposite_distance = 0.5;
  /// Sine of the largest elevation over the tangent plane of the nearest data: more than 45 degrees, what
  /// the pole of a missing hemisphere has, is no continuation of its rim.
  double largest_elevation = 0.75;
};

class Placement_guard {
public:
  Placement_guard() = default;
  /// `data` and `normals` must outlive the guard.
  Placement_guard(const Points& data, const Points& normals, const Free_space& free_space,
                  double h, const Guard_parameters& parameters)
    : m_data(&data), m_normals(&normals), m_free_space(&free_space), m_h(h)
    , m_parameters(parameters), m_tree(std::make_unique<Nearest_neighbors>(data))
    , m_grid(data, parameters.opposite_distance * h) {}

  bool operator()(const Vec3& x, const Vec3& normal) const
  {
    return !m_parameters.enabled || m_data == nullptr ||
           (!is_seen_through(x) && !opposes_data(x, normal) && continues_data(x));
  }

private:
  bool is_seen_through(const Vec3& x) const
  {
    return !m_free_space->empty() && (*m_free_space)(x) > m_parameters.free_space_tolerance * m_h;
  }

  bool opposes_data(const Vec3& x, const Vec3& normal) const
  {
    constexpr double opposite_cosine = -0.3;
    bool opposes = false;
    m_grid.for_each_neighbor(x, m_parameters.opposite_distance * m_h, [&](Index j, double) {
      return !(opposes = (*m_normals)[j].dot(normal) < opposite_cosine);
    });
    return opposes;
  }

  bool continues_data(const Vec3& x) const
  {
    const Neighbor p = m_tree->nearest(x);
    const double distance = std::sqrt(p.squared_distance);
    constexpr double beside = 0.2;  // of h: on the data, where the ratio is noise
    return distance < beside * m_h ||
           std::abs((*m_normals)[p.index].dot(x - (*m_data)[p.index])) <=
             m_parameters.largest_elevation * distance;
  }

  const Points* m_data = nullptr;
  const Points* m_normals = nullptr;
  const Free_space* m_free_space = nullptr;
  double m_h = 1;
  Guard_parameters m_parameters;
  std::unique_ptr<Nearest_neighbors> m_tree;
  Sorted_grid m_grid;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H
