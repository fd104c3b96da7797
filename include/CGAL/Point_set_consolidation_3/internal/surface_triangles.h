// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_TRIANGLES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_TRIANGLES_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

struct Surface_triangles {
  Points vertices;
  std::vector<std::array<std::size_t, 3> > triangles;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_TRIANGLES_H
