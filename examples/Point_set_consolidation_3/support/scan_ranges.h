// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_SCAN_RANGES_H
#define CONSOLIDATION_SUPPORT_SCAN_RANGES_H

#include "types.h"

#include <CGAL/Point_set_consolidation_3/parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

namespace support {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

inline Vec3 vec3(const Kernel::Point_3& p)
{
  return Vec3(p.x(), p.y(), p.z());
}
inline Vec3 vec3(const Kernel::Vector_3& v)
{
  return Vec3(v.x(), v.y(), v.z());
}

/// The scan as CGAL's functions see it: indices and maps.
struct Scan_ranges {
  std::vector<std::size_t> indices;
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals, directions;
  std::vector<int> views;
  std::vector<Kernel::Point_3> scanners;

  explicit Scan_ranges(const Point_cloud& cloud, const std::vector<Vec3>& scanner)
  {
    for(std::size_t i = 0; i < cloud.size(); ++i) {
      indices.push_back(i);
      points.emplace_back(cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z());
    }
    for(const Vec3& n : cloud.normals)
      normals.emplace_back(n.x(), n.y(), n.z());
    for(const Vec3& d : cloud.directions)
      directions.emplace_back(d.x(), d.y(), d.z());
    views = cloud.views;
    for(const Vec3& s : scanner)
      scanners.emplace_back(s.x(), s.y(), s.z());
  }
};

/// Calls `run` with the named parameters that tell what is known of the scanner.
template <typename NP, typename Run>
void with_scanner(const Scan_ranges& scan, const NP& np, const Run& run)
{
  if(!scan.scanners.empty()) {
    if(scan.views.empty())
      run(np.scanner_positions(scan.scanners));
    else
      run(np.scanner_positions(scan.scanners).view_index_map(CGAL::make_property_map(scan.views)));
  }
  else if(!scan.directions.empty()) {
    const auto with_directions = np.view_direction_map(CGAL::make_property_map(scan.directions));
    if(scan.views.empty())
      run(with_directions);
    else
      run(with_directions.view_index_map(CGAL::make_property_map(scan.views)));
  }
  else if(!scan.normals.empty())
    run(np.normal_map(CGAL::make_property_map(scan.normals)));
  else
    run(np);
}

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_SCAN_RANGES_H
