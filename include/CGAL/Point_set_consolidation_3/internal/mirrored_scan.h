// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRRORED_SCAN_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRRORED_SCAN_H

#include <CGAL/Point_set_consolidation_3/internal/consolidated_input.h>
#include <CGAL/Point_set_consolidation_3/internal/mirror_symmetry.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// A scan of a symmetric shape is a scan from twice as many views: the images of the data are data where
/// none are near, and the images of the rays have passed through free space.
/// Lengths in units of the spacing r of S.
class Mirrored_scan {
  static constexpr double particle_clearance = 0.7;
  static constexpr double data_clearance = 2;       ///< of data with about the same normal
  static constexpr double other_clearance = 1;      ///< in sp, of other data
  static constexpr double same_side = 0.3;          ///< cosine of normals
  static constexpr double asymmetric_radius = 5;   ///< around points whose images are in free space
  static constexpr double asymmetric_share = 0.1;

public:
  Mirrored_scan(const Execution& execution, const Consolidated_input& input, const Seen_part& seen,
                const Free_space& free_space, const Mirror_symmetry& symmetry, const Mirror_plane& plane)
    : m_execution(execution), m_symmetry(symmetry), m_free_space(free_space), m_plane(plane)
    , m_input(input), m_seen(seen)
  {
    find_asymmetric();
    add_rays();
    add_particles();
    add_data();
  }

  /// Measured particles, then their images; `gaps` is for `seen()`.
  const Consolidated_input& input() const { return m_input; }
  /// Measured points, then the images of some of them.
  const Seen_part& seen() const { return m_seen; }
  /// Whether the symmetry tells anything new.
  bool is_larger_than(const Seen_part& measured) const
  {
    constexpr double least_share = 0.02;
    return double(m_seen.points.size()) > (1 + least_share) * double(measured.points.size());
  }
  Free_space free_space(double margin) const
  {
    constexpr double reach = 5;
    Bounding_box region = bounding_box(m_input.points).grown(reach);
    return Free_space(m_execution, m_ray_points, m_rays, region, margin);
  }

private:
  /// Around points whose images lie in free space the shape is not symmetric.
  void find_asymmetric()
  {
    const Points& points = m_input.points;
    std::vector<char> is_free(points.size());
    m_is_asymmetric.resize(points.size());
    parallel_for(m_execution, points.size(), [&](std::size_t i) {
      is_free[i] = char(m_symmetry.is_free(m_plane, i));
    });
    const Sorted_grid grid(points, asymmetric_radius);
    parallel_for(m_execution, points.size(), [&](std::size_t i) {
      double free = 0, all = 0;
      grid.for_each_neighbor(points[i], asymmetric_radius, [&](Index j, double) {
        free += is_free[j];
        ++all;
        return true;
      });
      m_is_asymmetric[i] = char(free > asymmetric_share * all);
    });
  }

  void add_rays()
  {
    const Bounding_box region = bounding_box(m_input.points).grown(asymmetric_radius);
    const Scan_directions& directions = m_input.directions;
    const std::size_t views = directions.number_of_views();
    m_ray_points = m_input.data;
    m_rays = directions;
    for(std::size_t i = 0; i < m_input.data.size(); ++i)
      if(region.contains(m_input.data[i])) {
        m_ray_points.push_back(m_plane.reflected(m_input.data[i]));
        m_rays.towards_scanner.push_back(m_plane.reflected_vector(directions.towards_scanner[i]));
        m_rays.view.push_back(directions.view[i] + views);
      }
    for(std::size_t i = 0; i < directions.missed.size(); ++i) {
      m_rays.missed.push_back(m_plane.reflected(directions.missed[i]));
      m_rays.missed_view.push_back(directions.missed_view[i] + views);
    }
  }

  void add_particles()
  {
    const std::size_t n = m_input.points.size();
    const Nearest_neighbors tree(m_input.points);
    std::vector<char> is_kept(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const Vec3 y = m_plane.reflected(m_input.points[i]);
      const Vec3 normal = m_plane.reflected_vector(m_input.normals[i]);
      const Neighbor nearest = tree.nearest(y);
      const bool is_same = m_input.normals[nearest.index].dot(normal) > same_side;
      const double clearance = is_same ? data_clearance : particle_clearance;
      is_kept[i] = char(!m_is_asymmetric[i] && !(m_free_space(y) > 0) &&
                        nearest.squared_distance > clearance * clearance);
    });
    for(std::size_t i = 0; i < n; ++i)
      if(is_kept[i]) {
        m_input.points.push_back(m_plane.reflected(m_input.points[i]));
        m_input.normals.push_back(m_plane.reflected_vector(m_input.normals[i]));
      }
  }

  void add_data()
  {
    const std::size_t n = m_seen.points.size();
    const Nearest_neighbors particles(m_input.points);
    const Sorted_grid data(m_seen.points, data_clearance);
    const Nearest_neighbors tree(m_execution, m_seen.points);
    const double other = other_clearance * m_seen.spacing;
    std::vector<char> is_kept(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const Vec3 y = m_plane.reflected(m_seen.points[i]);
      const Vec3 normal = m_plane.reflected_vector(m_seen.normals[i]);
      const Index particle = particles.nearest(m_seen.points[i]).index;
      if((particle < m_is_asymmetric.size() && m_is_asymmetric[particle]) || m_free_space(y) > 0)
        return;
      if(!m_input.gaps.is_frozen.empty() && m_input.gaps.is_frozen[tree.nearest(y).index])
        return;
      bool is_clear = true;
      data.for_each_neighbor(y, data_clearance, [&](Index j, double d2) {
        is_clear = m_seen.normals[j].dot(normal) < same_side && d2 > other * other;
        return is_clear;
      });
      is_kept[i] = char(is_clear);
    });
    for(std::size_t i = 0; i < n; ++i)
      if(is_kept[i]) {
        m_seen.points.push_back(m_plane.reflected(m_seen.points[i]));
        m_seen.normals.push_back(m_plane.reflected_vector(m_seen.normals[i]));
        if(!m_input.gaps.priors.empty())
          m_input.gaps.priors.push_back(m_input.gaps.priors[i]);
        if(!m_input.gaps.is_frozen.empty())
          m_input.gaps.is_frozen.push_back(m_input.gaps.is_frozen[i]);
      }
  }

  const Execution& m_execution;
  const Mirror_symmetry& m_symmetry;
  const Free_space& m_free_space;
  Mirror_plane m_plane;
  Consolidated_input m_input;
  Seen_part m_seen;
  Points m_ray_points;
  Scan_directions m_rays;
  std::vector<char> m_is_asymmetric;   ///< of the measured particles
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRRORED_SCAN_H
