// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_VERSION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_H

/// \file
/// The version of the package. This is the one place where it is written: the build system reads
/// the three numbers from here.

/// First number of the version.
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MAJOR 0
/// Second number of the version.
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MINOR 1
/// Third number of the version.
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_PATCH 0

/// A number to compare with: `major * 1000000 + minor * 1000 + patch`.
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_NUMBER(major, minor, patch) \
  ((major)*1000000 + (minor)*1000 + (patch))

/// The version of these headers as such a number.
#define CGAL_POINT_SET_CONSOLIDATION_3_VERSION_NR                                             \
  CGAL_POINT_SET_CONSOLIDATION_3_VERSION_NUMBER(CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MAJOR, \
                                                CGAL_POINT_SET_CONSOLIDATION_3_VERSION_MINOR, \
                                                CGAL_POINT_SET_CONSOLIDATION_3_VERSION_PATCH)

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_VERSION_H
