// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_CONSOLIDATION_3_TEST_SCAN_RAYS_H
#define POINT_SET_CONSOLIDATION_3_TEST_SCAN_RAYS_H

#include "synthetic_scans.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

/// Synthetic scans as ranges of CGAL's types: points with directions towards the scanner.

using Vec3 = Eigen::Vector3d;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Point_and_direction;
typedef CGAL::First_of_pair_property_map<Point_and_direction> First;
typedef CGAL::Second_of_pair_property_map<Point_and_direction> Second;
typedef std::vector<Point_and_direction> Rays;

inline Rays rays(const synthetic::Scan& scan)
{
  Rays result;
  for(std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vec3 &p = scan.points[i], &d = scan.directions[i];
    result.emplace_back(Point(p.x(), p.y(), p.z()), Vector(d.x(), d.y(), d.z()));
  }
  return result;
}

inline Vec3 vec3(const Point& p) { return Vec3(p.x(), p.y(), p.z()); }
inline Vec3 vec3(const Vector& v) { return Vec3(v.x(), v.y(), v.z()); }

#endif  // POINT_SET_CONSOLIDATION_3_TEST_SCAN_RAYS_H
