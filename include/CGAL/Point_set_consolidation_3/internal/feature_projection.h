// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H

#include <CGAL/Point_set_consolidation_3/internal/normal_optimization.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Beyond the 2018 paper, which has no projection that keeps edges: points move to the surface of their own
/// cluster; where two clusters meet, points that went beyond the other's plane return to the edge.
/// In: points and normals that separate clusters. Out: the same, denoised. Signs of normals do not matter.

/// Surface seen from a point, as the mean over neighbours of the same cluster.
struct Local_surface {
  Vec3 step = Vec3::Zero();   ///< from the point to the surface
  Vec3 normal = Vec3::Zero(); ///< mean, not normalised
  double weight = 0;
};

/// Adds the neighbour at `offset` with normal `other` to the surface of a point with normal `n`.
/// The offset is measured along the mean of the two normals: along n alone convex surfaces shrink, along
/// the neighbour's alone they swell; along the mean a sphere stays where it is.
inline void add_to_surface(Local_surface& surface, const Vec3& n, const Vec3& offset,
                           const Vec3& other, double weight)
{
  const Vec3 same_side = n.dot(other) < 0 ? Vec3(-other) : other;
  const Vec3 mean = normalized_or(n + same_side, n);
  surface.step += weight * mean.dot(offset) * mean;
  surface.normal += weight * same_side;
  surface.weight += weight;
}

struct Projection_parameters {
  double sharpness_angle = 25;      ///< degrees
  std::size_t iterations = 10;
  std::size_t neighbors = 30;
};

/// Moves every point to the surface of its cluster; normals stay.
inline void project_on_clusters(const Execution& execution, Points& points, const Points& normals,
                                const Nearest_table& table, const Projection_parameters& parameters)
{
  const Normal_similarity phi(parameters.sharpness_angle);
  const std::size_t width = (std::min)(parameters.neighbors, table.width);
  Points next(points.size());
  for(std::size_t t = 0; t < parameters.iterations && width > 0; ++t) {
    parallel_for(execution, points.size(), [&](std::size_t i) {
      const Index* row = table.row(i);
      const double reach = (points[row[width - 1]] - points[i]).squaredNorm();
      Local_surface surface;
      surface.weight = 1;  // the point itself
      for(std::size_t k = 0; k < width; ++k) {
        const Vec3 offset = points[row[k]] - points[i];
        const double theta = reach > 0 ? std::exp(-2 * offset.squaredNorm() / reach) : 1;
        const double w = theta * phi(std::abs(normals[i].dot(normals[row[k]])));
        add_to_surface(surface, normals[i], offset, normals[row[k]], w);
      }
      next[i] = points[i] + surface.step / surface.weight;
    });
    points.swap(next);
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H
