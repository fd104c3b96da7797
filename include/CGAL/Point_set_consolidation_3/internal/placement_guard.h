// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PLACEMENT_GUARD_H

#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
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
  /// A region of completed points is taken back as a whole if it rises higher than this anywhere, ...
  double largest_region_elevation = 0.7;
  /// ... or if its normals differ more from the data's along its rim (mean cosine): it bends off instead of
  /// going on.
  double least_rim_cosine = 0.95;
  /// Regions that reach no farther from the data are bounded all around by near data: their normals may differ by
  /// this mean cosine.
  double small_reach = 1;
  double least_small_rim_cosine = 0.7;
  /// Where the mean normal of a region's rim is shorter than this, the hole is a crease between parts that
  /// occluded each other and not a patch of one sheet, unless it is wide (in units of h).
  double least_rim_flatness = 0.6;
  double wide_reach = 1.5;
  /// A region is also taken back if it reaches no farther from the data: Poisson reconstruction closes such holes as well.
  double least_reach = 0.45;
  /// Share of all added points that must pass, else all are taken back: where most extensions fail, gaps are
  /// occlusions rather than holes, and the regions that pass are not better founded.
  double least_accepted_share = 0.5;
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

  /// Flags the regions, neighbours within `radius`, that are no plausible continuation of the data as a
  /// whole. `number_added`: how many points there were before some were taken back.
  std::vector<char> doubtful_regions(const Execution& execution, const Points& points,
                                     const Points& normals, double radius,
                                     std::size_t number_added) const
  {
    constexpr double rim = 0.35;  // of h: nearer to the data than this is a region's rim
    std::vector<char> is_doubtful(points.size(), 0);
    if(!m_parameters.enabled || m_data == nullptr || points.empty())
      return is_doubtful;
    std::vector<Neighbor> nearest(points.size());
    parallel_for(execution, points.size(),
                 [&](std::size_t i) { nearest[i] = m_tree->nearest(points[i]); });
    for(std::vector<Index>& members : connected_components(points, radius)) {
      std::sort(members.begin(), members.end());  // sums in the points' order
      Region region;
      for(const Index i : members) {
        const Vec3& n = (*m_normals)[nearest[i].index];
        const double distance = std::sqrt(nearest[i].squared_distance);
        if(distance > beside * m_h)
          region.elevation =
            (std::max)(region.elevation,
                       std::abs(n.dot(points[i] - (*m_data)[nearest[i].index])) / distance);
        region.reach = (std::max)(region.reach, distance);
        if(distance < rim * m_h) {
          region.cosine += n.dot(normals[i]);
          region.rim_normals += n;
          ++region.rim_points;
        }
      }
      const char is_bad = is_doubtful_region(region);
      for(const Index i : members)
        is_doubtful[i] = is_bad;
    }
    const std::size_t accepted =
      std::size_t(std::count(is_doubtful.begin(), is_doubtful.end(), char(0)));
    if(double(accepted) < m_parameters.least_accepted_share * double(number_added))
      std::fill(is_doubtful.begin(), is_doubtful.end(), char(1));
    return is_doubtful;
  }

private:
  static constexpr double beside = 0.2;  ///< of h: on the data, where the elevation is noise

  /// Added points that hang together, and the data beside them.
  struct Region {
    double elevation = 0, reach = 0, cosine = 0;
    Vec3 rim_normals = Vec3::Zero();
    std::size_t rim_points = 0;
  };

  bool is_doubtful_region(const Region& region) const
  {
    const bool is_small = region.reach <= m_parameters.small_reach * m_h;
    const double least_cosine =
      is_small ? m_parameters.least_small_rim_cosine : m_parameters.least_rim_cosine;
    const bool is_wide = region.reach > m_parameters.wide_reach * m_h;
    return region.elevation > m_parameters.largest_region_elevation ||
           region.reach < m_parameters.least_reach * m_h ||
           region.cosine < least_cosine * double(region.rim_points) ||
           (!is_wide && region.rim_normals.norm() < m_parameters.least_rim_flatness * double(region.rim_points));
  }

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
