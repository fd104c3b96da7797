// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_FRAME_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_FRAME_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Unit vectors u and v across a unit normal n, v = n x u; u is perpendicular to the axis that n is the farthest from.
struct Tangent_frame {
  explicit Tangent_frame(const Vec3& n)
  {
    Vec3::Index smallest;
    n.cwiseAbs().minCoeff(&smallest);
    u = normalized_or(n.cross(Vec3(Vec3::Unit(smallest))), Vec3::UnitX());
    v = n.cross(u);
  }

  Vec3 u, v;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_FRAME_H
