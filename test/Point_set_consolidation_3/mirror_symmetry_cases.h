// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_CONSOLIDATION_3_TEST_MIRROR_SYMMETRY_CASES_H
#define POINT_SET_CONSOLIDATION_3_TEST_MIRROR_SYMMETRY_CASES_H

// Part of deep_points_test: the mirror plane of a shape is found in a scan from one side, and none where
// there is none.

#include "scan_rays.h"

#include <CGAL/Point_set_consolidation_3/internal/input_stage.h>
#include <CGAL/Point_set_consolidation_3/internal/mirror_symmetry.h>
#include <CGAL/complete_point_set.h>

#include <cassert>
#include <iostream>
#include <optional>

namespace mirror_symmetry_cases {

namespace params = CGAL::Point_set_consolidation_3::parameters;
namespace psc = CGAL::Point_set_consolidation_3::internal;
using synthetic::Scan;
using synthetic::Shape;

const double offset = 0.3;   // the mirror plane is x = offset

/// A body with head, two ears and four legs; `bend` displaces the legs and the ear of one side.
inline Shape animal(const Vec3& bend)
{
  const auto at = [](double x, double y, double z) { return Vec3(offset + x, y, z); };
  const auto limbs = [&](double side, const Vec3& d) {
    return std::vector<Shape>{
      synthetic::capsule(at(0.25 * side, 0, 0.8), at(0.45 * side, 0.2, -0.9) + d, 0.16),
      synthetic::capsule(at(0.25 * side, 0, -0.8), at(0.45 * side, -0.1, -0.9) - d, 0.16),
      synthetic::capsule(at(0.1 * side, 0, 1.5), at(0.45 * side, 0.1, 1.9) + d, 0.12)};
  };
  std::vector<Shape> parts = {synthetic::capsule(at(0, 0.3, -1), at(0, 0.3, 0.9), 0.45),
                              synthetic::capsule(at(0, 0.4, 0.9), at(0, 0.8, 1.6), 0.3)};
  for(const Shape& s : limbs(1, Vec3::Zero()))
    parts.push_back(s);
  for(const Shape& s : limbs(-1, bend))
    parts.push_back(s);
  return synthetic::united(parts);
}

struct Completion_quality {
  std::vector<Vec3> points;
  double error = 0;      ///< percent of the diagonal, from the hidden surface to the data or a completed point
  double coverage = 0;   ///< share of the hidden surface within 1.5 percent of the data or a completed point
};

template <typename NP>
Completion_quality complete(const Shape& shape, const Scan& scan, const NP& np)
{
  const Rays data = rays(scan);
  std::vector<CGAL::Completed_point_3<Kernel> > completed;
  CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
    data, std::back_inserter(completed),
    np.point_map(First()).view_direction_map(Second()).number_of_output_points(3000));
  Completion_quality result;
  const double percent = 100 / shape.diagonal();
  for(const auto& p : completed) {
    result.points.push_back(vec3(p.outer()));
    assert(p.distance() > 0 && p.confidence() > 0 && p.confidence() < 1);
  }
  for(const Vec3& h : scan.hidden) {
    double nearest = 1e300;
    for(const Vec3& p : result.points)
      nearest = (std::min)(nearest, (p - h).norm());
    for(const Vec3& p : scan.points)
      nearest = (std::min)(nearest, (p - h).norm());
    result.error += percent * nearest / double(scan.hidden.size());
    result.coverage += (percent * nearest < 1.5) / double(scan.hidden.size());
  }
  std::cout << "  " << completed.size() << " points, error " << result.error << " %, coverage "
            << result.coverage << std::endl;
  return result;
}

/// In the scan's coordinates; `unit` becomes the spacing of the particles.
inline std::optional<psc::Mirror_plane> mirror_plane(const Scan& scan, double& unit)
{
  psc::Execution execution = psc::make_execution<CGAL::Parallel_if_available_tag>();
  psc::Raw_scan raw;
  raw.points = scan.points;
  raw.directions.towards_scanner = scan.directions;
  raw.directions.view.assign(scan.points.size(), 0);
  psc::Input_parameters parameters;
  parameters.particles = 3000;
  const psc::Consolidated_input input = psc::consolidate_input(execution, 1, raw, parameters);
  const psc::Free_space free_space(execution, input.data, input.directions, 0.5);
  const psc::Mirror_symmetry symmetry(execution, input.points, input.normals, free_space);
  std::optional<psc::Mirror_plane> plane = symmetry.find(false);
  unit = input.frame.unit;
  if(plane)
    plane->offset = plane->normal.dot(input.frame.to_world(plane->offset * plane->normal));
  return plane;
}

inline void symmetric()
{
  std::cout << "symmetric animal" << std::endl;
  const Shape shape = animal(Vec3::Zero());
  const Scan scan = synthetic::scan(shape, {Vec3(1, 0.7, 0.5)}, 12000, 3);
  double unit = 0;
  const std::optional<psc::Mirror_plane> plane = mirror_plane(scan, unit);
  assert(plane);
  std::cout << "  plane " << plane->normal.transpose() << ", " << plane->offset << std::endl;
  assert(std::abs(plane->normal.x()) > std::cos(0.01));
  assert(std::abs(plane->reflected(Vec3(offset, 0.3, 0)).x() - offset) < 0.5 * unit);
  const Completion_quality with = complete(shape, scan, params::use_symmetry(true));
  const Completion_quality without = complete(shape, scan, params::use_symmetry(false));
  assert(with.error < 0.75 * without.error);
  assert(with.coverage > without.coverage && with.coverage > 0.86);
  assert(complete(shape, scan, params::use_symmetry(true)).points == with.points);
  // a caller's own prior or bound comes first
  assert(complete(shape, scan, params::maximum_hole_size(100.)).points == without.points);
}

inline void asymmetric()
{
  std::cout << "asymmetric animal" << std::endl;
  const Shape shape = animal(Vec3(-0.5, 0.6, 0.3));
  for(const Vec3& view : {Vec3(1, 0.7, 0.5), Vec3(-1, 0.7, 0.5)}) {
    const Scan scan = synthetic::scan(shape, {view}, 12000, 3);
    double unit = 0;
    assert(!mirror_plane(scan, unit));
  }
}

}  // namespace mirror_symmetry_cases

#endif  // POINT_SET_CONSOLIDATION_3_TEST_MIRROR_SYMMETRY_CASES_H
