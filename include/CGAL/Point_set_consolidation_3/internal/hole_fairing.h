// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FAIRING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FAIRING_H

#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/hermite_surface.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/placement_guard.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Moves the points that fill a hole onto the smooth surface through the data around it; not in the paper. The points
/// have grown over the hole from all sides along spheres with the curvature of the rim: they flatten tips that are more
/// curved, and did not know of each other before they met.

class Hole_fairing {
public:
  /// All must outlive the fairing.
  Hole_fairing(const Points& data, const Points& normals, const Nearest_neighbors& tree, double h,
               const Placement_guard& guard)
    : m_data(data), m_normals(normals), m_tree(tree), m_grid(data, h), m_guard(guard), m_h(h) {}

  /// Moves the points `members`, which fill one hole; not into space that is seen through.
  void operator()(Points& points, Points& normals, const std::vector<Index>& members) const
  {
    Points region = selected(points, members), region_normals = selected(normals, members);
    const Hermite_surface surface = surface_around(region);
    for(std::size_t k = 0; k < region.size(); ++k)
      if(!surface.project(region[k], region_normals[k]) || m_guard.is_seen_through(region[k]))
        return;
    for(std::size_t k = 0; k < members.size(); ++k) {
      points[members[k]] = region[k];
      normals[members[k]] = region_normals[k];
    }
  }

private:
  /// Through the data that are no farther from the region than its middle is from the data.
  Hermite_surface surface_around(const Points& region) const
  {
    constexpr std::size_t most_centres = 120;
    double reach = 0;
    for(const Vec3& x : region)
      reach = (std::max)(reach, std::sqrt(m_tree.nearest(x).squared_distance));
    const std::vector<Index> rim = data_within(region, reach);
    Points centres = selected(m_data, rim), normals = selected(m_normals, rim);
    double distance = 0.05 * m_h;
    for(std::vector<Index> kept = thinned(centres, distance);; kept = thinned(centres, distance)) {
      centres = selected(centres, kept);
      normals = selected(normals, kept);
      if(centres.size() <= most_centres)
        break;
      distance *= 1.1;
    }
    smooth(data_within(region, reach + m_h), centres, normals);
    return Hermite_surface(std::move(centres), normals);
  }

  /// In their order.
  std::vector<Index> data_within(const Points& region, double distance) const
  {
    Vec3 middle = Vec3::Zero();
    for(const Vec3& x : region)
      middle += x / double(region.size());
    double radius = 0;
    for(const Vec3& x : region)
      radius = (std::max)(radius, (x - middle).norm());
    const Nearest_neighbors tree(region);
    std::vector<Index> found;
    m_grid.for_each_neighbor(middle, radius + distance, [&](Index j, double) {
      if(tree.nearest(m_data[j]).squared_distance <= distance * distance)
        found.push_back(j);
      return true;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Projects the centres onto the algebraic surface of the data `around`. Its support grows with the noise: the
  /// interpolation carries errors of single normals far into the hole.
  void smooth(const std::vector<Index>& around, Points& centres, Points& normals) const
  {
    constexpr double least_support = 0.3, largest_support = 1, support_by_noise = 15;
    constexpr std::size_t steps = 3;
    constexpr double normal_deviation = 1.48;  // standard deviation by median of the absolute values
    const Points data = selected(m_data, around), data_normals = selected(m_normals, around);
    const Algebraic_surface detail(data, data_normals, least_support * m_h);
    std::vector<double> heights;
    for(std::size_t k = 0; k < centres.size(); ++k)
      heights.push_back(std::abs(detail.fit(centres[k], normals[k]).sphere.signed_distance(centres[k])));
    const double noise = normal_deviation * median(std::move(heights));
    const double support = (std::min)(least_support * m_h + support_by_noise * noise, largest_support * m_h);
    const Algebraic_surface surface(data, data_normals, support);
    for(std::size_t k = 0; k < centres.size(); ++k)
      surface.project(centres[k], normals[k], steps);
  }

  const Points& m_data;
  const Points& m_normals;
  const Nearest_neighbors& m_tree;
  Sorted_grid m_grid;
  const Placement_guard& m_guard;
  double m_h;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_HOLE_FAIRING_H
