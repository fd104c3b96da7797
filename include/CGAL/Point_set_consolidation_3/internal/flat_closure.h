// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FLAT_CLOSURE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FLAT_CLOSURE_H

#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The plane that closes an open base: through the data at the border of a gap, normal outwards.
struct Closing_plane {
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();

  bool is_valid() const { return !normal.isZero(); }
  Vec3 projected(const Vec3& x) const { return x - normal.dot(x - point) * normal; }
};

/// `border`: data at the border of the gap; `outwards`: the mean normal of what would close it otherwise. Not
/// valid if the border is far from flat, or a line.
inline Closing_plane closing_plane(const Points& data, const std::vector<Index>& border,
                                   const Vec3& outwards)
{
  constexpr double flatness = 0.3;   // height of the border over its width, at most
  constexpr double least_width = 0.1;  // of the border over its length
  Closing_plane plane;
  if(border.size() < 3)
    return plane;
  const Vec3& origin = data[border.front()];
  Covariance_sum sum;
  for(const Index i : border)
    sum.add(data[i] - origin);
  const auto axes = sum.axes();
  const Vec3 extent = axes.eigenvalues().cwiseMax(0.).cwiseSqrt();
  if(extent[0] > flatness * extent[1] || extent[1] < least_width * extent[2])
    return plane;
  plane.point = origin + sum.mean();
  plane.normal = axes.eigenvectors().col(0);
  if(plane.normal.dot(outwards) < 0)
    plane.normal = -plane.normal;
  return plane;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FLAT_CLOSURE_H
