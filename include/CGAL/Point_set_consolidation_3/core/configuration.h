// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_CONFIGURATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_CONFIGURATION_H

#include <Eigen/Core>

// The core of the methods works on plain arrays and has no template parameters. The headers of this folder declare what
// the public templates call; each `*_impl.h` beside them defines it. The definitions are compiled
//
// - once, in a library, if the package is used through its CMake target, which defines
//   CGAL_POINT_SET_CONSOLIDATION_3_COMPILED_CORE as the alignment in bytes that Eigen has in the library, and
//   CGAL_POINT_SET_CONSOLIDATION_3_CORE_HAS_TBB if the library can run in parallel;
// - with every file that includes a public header, if only the folder of the headers is in the include path.
//
// Files whose options do not fit the library are compiled the second way: another instruction set (the
// allocations of Eigen differ), checked containers, or TBB where the library has none.

#if !defined(CGAL_POINT_SET_CONSOLIDATION_3_COMPILED_CORE)
#  define CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY 1
#elif CGAL_POINT_SET_CONSOLIDATION_3_COMPILED_CORE != EIGEN_MAX_ALIGN_BYTES || defined(_GLIBCXX_DEBUG)
#  define CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY 1
#elif defined(CGAL_LINKED_WITH_TBB) && !defined(CGAL_POINT_SET_CONSOLIDATION_3_CORE_HAS_TBB)
#  define CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY 1
#endif

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#  define CGAL_POINT_SET_CONSOLIDATION_3_INLINE inline
#else
#  define CGAL_POINT_SET_CONSOLIDATION_3_INLINE
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_CONFIGURATION_H
