// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCAN_DIRECTIONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCAN_DIRECTIONS_H

#include <CGAL/Point_set_consolidation_3/core/views.h>
#include <CGAL/Point_set_consolidation_3/internal/range_access.h>
#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>

#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What the caller knows of the scanner, from the named parameters `view_direction_map`, `view_index_map`
/// and `scanner_positions`.

template <typename PointRange, typename NP>
std::vector<std::size_t> copy_view_indices(const char* function, const PointRange& range,
                                           const NP& np)
{
  std::vector<std::size_t> view;
  if constexpr(has_parameter<NP, internal_np::view_index_map_t>) {
    const auto map = CGAL::parameters::get_parameter(np, internal_np::view_index_map);
    for(typename PointRange::const_iterator it = range.begin(); it != range.end(); ++it) {
      const auto v = get(map, *it);
      constexpr unsigned long most_views = 100000;
      if(v < 0 || static_cast<unsigned long>(v) > most_views)  // std::size_t(-1) too
        throw_invalid(function, "view_index_map is " + std::to_string(v) + " for the point at index " +
                                  std::to_string(view.size()) + ", not in [0, 100000]");
      view.push_back(std::size_t(v));
    }
  }
  else {
    (void)function; (void)range; (void)np;
  }
  return view;
}

/// The caller's rays that met nothing, for views that have data.
template <typename NP>
void copy_missed_rays(const char* function, const NP& np, Scan_directions& directions)
{
  if constexpr(has_parameter<NP, internal_np::missed_rays_t>) {
    const std::size_t views = directions.number_of_views();
    for(const auto& ray : CGAL::parameters::get_parameter(np, internal_np::missed_rays)) {
      const Vec3 p = to_vec3(ray.first);
      require(p.allFinite(), function, "missed_rays has a point that is not finite");
      require(std::size_t(ray.second) < views, function,
              "missed_rays has a view that none of the points belongs to");
      directions.missed.push_back(p);
      directions.missed_view.push_back(std::size_t(ray.second));
    }
  }
  else {
    (void)function; (void)np; (void)directions;
  }
}

template <typename PointRange, typename NP>
Scan_directions copy_scan_directions(const char* function, const PointRange& range,
                                     const Points& points, const NP& np)
{
  Scan_directions directions;
  directions.view = copy_view_indices(function, range, np);
  if constexpr(has_parameter<NP, internal_np::scanner_positions_t>) {
    Points scanners;
    for(const auto& p : CGAL::parameters::get_parameter(np, internal_np::scanner_positions))
      scanners.push_back(to_vec3(p));
    require(!scanners.empty(), function, "scanner_positions is empty");
    if(directions.view.empty()) {
      require(scanners.size() == 1, function, "several scanner_positions need a view_index_map");
      directions.view.assign(points.size(), 0);
    }
    for(std::size_t i = 0; i < points.size(); ++i) {
      require(directions.view[i] < scanners.size(), function,
              "view_index_map has an index beyond scanner_positions");
      directions.towards_scanner.push_back(scanners[directions.view[i]] - points[i]);
    }
  }
  else if constexpr(has_parameter<NP, internal_np::view_direction_map_t>) {
    directions.towards_scanner =
      copy_vectors(function, "view_direction_map", range,
                   CGAL::parameters::get_parameter(np, internal_np::view_direction_map));
  }
  else {
    require(directions.view.empty(), function,
            "view_index_map needs view_direction_map or scanner_positions");
    if constexpr(has_parameter<NP, internal_np::missed_rays_t>)
      throw_invalid(function, "missed_rays needs view_direction_map or scanner_positions");
    return directions;
  }
  directions.towards_scanner = with_usable_lengths(std::move(directions.towards_scanner));
  for(std::size_t i = 0; i < points.size(); ++i) {
    Vec3& d = directions.towards_scanner[i];
    const double length = d.norm();
    if(!(length > 0 && std::isfinite(length)))
      throw_invalid(function, "the direction towards the scanner is zero for the point at index " +
                                std::to_string(i));
    d /= length;
  }
  if(directions.view.empty())
    directions.view = group_views(points, directions.towards_scanner);
  copy_missed_rays(function, np, directions);
  return directions;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCAN_DIRECTIONS_H
