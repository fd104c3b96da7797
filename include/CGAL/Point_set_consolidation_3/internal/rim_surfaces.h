// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RIM_SURFACES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RIM_SURFACES_H

#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/hermite_surface.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The smooth surfaces that go on from the data around holes and gaps; not in the papers. What fills a hole otherwise,
/// grown along spheres or the hull of balls, has the curvature of its rim on one side only, or none of it.

class Rim_surfaces {
public:
  /// `h`: ten spacings of the data. All must outlive the surfaces.
  Rim_surfaces(const Points& data, const Points& normals, const Nearest_neighbors& tree, double h)
    : m_data(data), m_normals(normals), m_tree(tree), m_grid(data, h), m_h(h) {}

  /// Through the data that are no farther from the region than its middle is from the data.
  Hermite_surface around(const Points& region) const
  {
    // error in gaps between clean views by that of the mesher: 0.79 with 120, 0.76 with 200, 0.74 with 320 (4 x slower)
    constexpr std::size_t most_centres = 200;
    constexpr double first_distance = 0.05, growth = 1.1;  // of h: half a spacing keeps nearly all
    double reach = 0;
    for(const Vec3& x : region)
      reach = (std::max)(reach, std::sqrt(m_tree.nearest(x).squared_distance));
    const std::vector<Index> rim = data_within(region, reach);
    Points centres = selected(m_data, rim), normals = selected(m_normals, rim);
    double distance = first_distance * m_h;
    for(std::vector<Index> kept = thinned(centres, distance);; kept = thinned(centres, distance)) {
      centres = selected(centres, kept);
      normals = selected(normals, kept);
      if(centres.size() <= most_centres)
        break;
      distance *= growth;
    }
    smooth(data_within(region, reach + m_h), centres, normals);
    return Hermite_surface(std::move(centres), normals);
  }

private:
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

  /// If the data are noisy, projects the centres onto their algebraic surface, whose support grows with the noise: the
  /// interpolation carries errors of single normals far into the hole.
  void smooth(const std::vector<Index>& around, Points& centres, Points& normals) const
  {
    // of h, and per noise: less leaves the noise of normals, more smooths the rims of clean holes away
    constexpr double least_support = 0.3, support_by_noise = 15;
    constexpr double normal_deviation = 1.48;  // standard deviation by median of the absolute values
    constexpr std::size_t steps = 3;
    const Points data = selected(m_data, around), data_normals = selected(m_normals, around);
    const Algebraic_surface detail(data, data_normals, least_support * m_h);
    std::vector<double> heights;
    for(std::size_t k = 0; k < centres.size(); ++k)
      heights.push_back(std::abs(detail.fit(centres[k], normals[k]).sphere.signed_distance(centres[k])));
    const double support = support_by_noise * normal_deviation * median(std::move(heights));
    if(support < least_support * m_h)
      return;
    const Algebraic_surface surface(data, data_normals, (std::min)(support, m_h));
    for(std::size_t k = 0; k < centres.size(); ++k)
      surface.project(centres[k], normals[k], steps);
  }

  const Points& m_data;
  const Points& m_normals;
  const Nearest_neighbors& m_tree;
  Sorted_grid m_grid;
  double m_h;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RIM_SURFACES_H
