// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The only place that tells versions of CGAL apart: what has another name in CGAL 6 than in CGAL 5. The library itself
// needs nothing of the kind.

#ifndef CONSOLIDATION_SUPPORT_CGAL_COMPATIBILITY_H
#define CONSOLIDATION_SUPPORT_CGAL_COMPATIBILITY_H

#include <CGAL/config.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace support {

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
template <typename Kernel, typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
template <typename Kernel, typename Primitive>
using Box_tree_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
template <typename Kernel, typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
template <typename Kernel, typename Primitive>
using Box_tree_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_CGAL_COMPATIBILITY_H
