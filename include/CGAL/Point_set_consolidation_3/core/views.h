// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Groups parallel rays into views. Empty if they are not a few orthographic views.
std::vector<std::size_t> group_views(const Points& points, const Points& towards_scanner);

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/views_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_VIEWS_H
