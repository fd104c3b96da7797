// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H

#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Where a completed point may lie; not in the paper. The extension of a surface over its border is a guess
/// that holds for smooth holes; at thin and occluded parts it grows sheets that the shape does not have.
/// Lengths in units of h.

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

  /// Whether a ray of the scanner passed there.
  bool is_seen_through(const Vec3& x) const
  {
    return !m_free_space->empty() && (*m_free_space)(x) > m_parameters.free_space_tolerance * m_h;
  }

  /// Flags the regions, indices of added points that hang together, that are no plausible continuation of the data as a
  /// whole. `number_added`: how many points there were before some were taken back.
  std::vector<char> doubtful_regions(const Execution& execution, const Points& points, const Points& normals,
                                     const std::vector<std::vector<Index> >& regions, std::size_t number_added) const
  {
    std::vector<char> is_doubtful(regions.size(), 0);
    if(!m_parameters.enabled || m_data == nullptr || points.empty())
      return is_doubtful;
    std::vector<Neighbor> nearest(points.size());
    parallel_for(execution, points.size(),
                 [&](std::size_t i) { nearest[i] = m_tree->nearest(points[i]); });
    std::size_t accepted = 0;
    for(std::size_t k = 0; k < regions.size(); ++k) {
      is_doubtful[k] = is_doubtful_region(points, normals, nearest, regions[k]);
      if(!is_doubtful[k])
        accepted += regions[k].size();
    }
    if(double(accepted) < m_parameters.least_accepted_share * double(number_added))
      std::fill(is_doubtful.begin(), is_doubtful.end(), char(1));
    return is_doubtful;
  }

private:
  static constexpr double beside = 0.2;  ///< of h: on the data, where the elevation is noise

  /// Of added points that hang together. `nearest`: data of each point.
  bool is_doubtful_region(const Points& points, const Points& normals, const std::vector<Neighbor>& nearest,
                          const std::vector<Index>& members) const
  {
    constexpr double beside_rim = 0.35;  // of h: nearer to the data than this is a region's rim
    double reach = 0, cosine = 0;
    Vec3 middle = Vec3::Zero(), rim_normal = Vec3::Zero();
    std::size_t rim_points = 0;
    for(const Index i : members) {
      const double distance = std::sqrt(nearest[i].squared_distance);
      reach = (std::max)(reach, distance);
      middle += points[i] / double(members.size());
      if(distance < beside_rim * m_h) {
        const Vec3& n = (*m_normals)[nearest[i].index];
        cosine += n.dot(normals[i]);
        rim_normal += n;
        ++rim_points;
      }
    }
    return rim_points == 0 || reach < m_parameters.least_reach * m_h ||
           cosine < m_parameters.least_rim_cosine * double(rim_points) ||
           rim_normal.norm() < m_parameters.least_rim_flatness * double(rim_points) ||
           opening(middle, normalized_or(rim_normal, Vec3::UnitZ())) > m_parameters.largest_opening;
  }

  /// The widest angle around a place, in the plane of a normal, without data near the nearest's distance.
  double opening(const Vec3& place, const Vec3& normal) const
  {
    const double nearest = std::sqrt(m_tree->nearest(place).squared_distance);
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<double> angles;
    m_grid.for_each_neighbor(place, m_parameters.opening_reach * nearest, [&](Index j, double) {
      const Vec3 d = (*m_data)[j] - place;
      angles.push_back(std::atan2(d.dot(v), d.dot(u)));
      return true;
    });
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2 * CGAL_PI - angles.back();
    for(std::size_t k = 1; k < angles.size(); ++k)
      widest = (std::max)(widest, angles[k] - angles[k - 1]);
    return widest;
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
