// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_CURVES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_CURVES_H

#include <CGAL/Point_set_consolidation_3/internal/laplacian_contraction.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_labels.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points as the start of a Laplacian contraction: the anchors are near the skeleton already, also where
/// the surface has no back, and the contraction draws sheets together to curves. In: deep points, in units of their
/// spacing. Out: the contracted anchors in the same units.
///
/// The surface itself as the start leaves the open rims of a scan where they are, with cycles around its gaps.
inline Points contracted_anchors(const Execution& execution, const Meso_shape& shape)
{
  Tangent_rings rings = find_tangent_rings(execution, shape.outer, link_neighbors(shape));
  std::size_t kept = 0;
  for(std::size_t k = 0; k < rings.triangles.size(); ++k) {
    const Ring_triangle& t = rings.triangles[k];
    if(are_opposed(shape, t[0], t[1]) || are_opposed(shape, t[0], t[2]) || are_opposed(shape, t[1], t[2]))
      continue;
    rings.triangles[kept] = t;
    rings.agreement[kept++] = rings.agreement[k];
  }
  rings.triangles.resize(kept);
  rings.agreement.resize(kept);
  connect_triangles(shape.outer.size(), rings);

  const Frame frame = contraction_frame(bounding_box(shape.outer));
  Points start;
  for(const Vec3& anchor : shape.anchors)
    start.push_back(frame.to_local(anchor));
  Laplacian_contraction contraction(execution, start, rings, Contraction_parameters());
  while(contraction.contract_geometry()) {
  }
  Points result;
  for(const Vec3& p : contraction.points())
    result.push_back(frame.to_world(p));
  return result;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_CURVES_H
