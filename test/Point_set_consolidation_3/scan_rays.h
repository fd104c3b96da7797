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

/// The same with maps by index, which results can be written to as well.
struct Indexed_rays {
  std::vector<std::size_t> indices;  ///< 0, 1, 2, ...: the range
  std::vector<Point> points;
  std::vector<Vector> directions;
  std::vector<int> views;

  void add(const Vec3& p, const Vec3& towards_scanner, int view = 0)
  {
    indices.push_back(points.size());
    points.emplace_back(p.x(), p.y(), p.z());
    directions.emplace_back(towards_scanner.x(), towards_scanner.y(), towards_scanner.z());
    views.push_back(view);
  }
  auto point_map() const { return CGAL::make_property_map(points); }
  auto view_direction_map() const { return CGAL::make_property_map(directions); }
  auto view_index_map() const { return CGAL::make_property_map(views); }
};

inline Indexed_rays indexed_rays(const synthetic::Scan& scan)
{
  Indexed_rays result;
  for(std::size_t i = 0; i < scan.points.size(); ++i)
    result.add(scan.points[i], scan.directions[i]);
  return result;
}

inline Vec3 vec3(const Point& p) { return Vec3(p.x(), p.y(), p.z()); }
inline Vec3 vec3(const Vector& v) { return Vec3(v.x(), v.y(), v.z()); }

#endif  // POINT_SET_CONSOLIDATION_3_TEST_SCAN_RAYS_H
