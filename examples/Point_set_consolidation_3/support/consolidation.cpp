// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "consolidation.h"

#include "consolidation_methods.h"
#include "scan_ranges.h"

#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/iterative_consolidate_point_set.h>

#include <iterator>
#include <utility>

namespace support {

namespace params = CGAL::Point_set_consolidation_3::parameters;

namespace {

typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Oriented_point;

void append(Point_cloud& cloud, const std::vector<Oriented_point>& points)
{
  for(const Oriented_point& p : points) {
    cloud.points.push_back(vec3(p.first));
    cloud.normals.push_back(vec3(p.second));
  }
}

}  // namespace

Consolidation_result consolidate_iteratively(const Scan_ranges& scan,
                                             const Consolidation_options& o,
                                             const std::function<void(double)>& progress)
{
  Consolidation_result result;
  std::vector<Oriented_point> points;
  std::vector<bool> is_new;
  std::vector<double> confidence;
  const auto np = params::point_map(CGAL::make_property_map(scan.points))
                    .geom_traits(Kernel())
                    .completed_output_iterator(std::back_inserter(is_new))
                    .confidence_output_iterator(std::back_inserter(confidence))
                    .hole_fairing(!o.no_hole_fairing)
                    .stage_times(std::ref(result.times))
                    .callback(reporting(progress));
  const auto run = [&](const auto& parameters) {
    CGAL::iterative_consolidate_point_set<Concurrency_tag>(scan.indices,
                                                           std::back_inserter(points), parameters);
  };
  with_scanner(scan, np.orientation_is_hint(true), [&](const auto& parameters) {
    if(o.particles > 0 || o.percentage > 0)
      run(parameters.particle_fraction(double(number_of_particles(o, scan.points.size())) /
                                       double(scan.points.size())));
    else
      run(parameters);
  });
  append(result.consolidated, points);
  result.consolidated.confidence = confidence;
  result.completed = result.consolidated;
  for(const bool b : is_new)
    result.completed_points += b;
  result.outliers = scan.points.size() + result.completed_points - points.size();
  return result;
}

Consolidation_result consolidate_anisotropically(const Scan_ranges& scan,
                                                 const Consolidation_options& o,
                                                 const std::function<void(double)>& progress)
{
  Consolidation_result result;
  std::vector<Oriented_point> points;
  const auto np = params::point_map(CGAL::make_property_map(scan.points))
                    .geom_traits(Kernel())
                    .number_of_output_points(number_of_particles(o, scan.points.size()))
                    .stage_times(std::ref(result.times))
                    .callback(reporting(progress));
  const auto run = [&](const auto& parameters) {
    CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Concurrency_tag>(
      scan.indices, std::back_inserter(points), parameters);
  };
  // directions towards the scanner are normals as rough as this method needs
  if(!scan.directions.empty())
    run(np.normal_map(CGAL::make_property_map(scan.directions)));
  else if(!scan.normals.empty())
    run(np.normal_map(CGAL::make_property_map(scan.normals)));
  else
    run(np);
  append(result.consolidated, points);
  result.consolidated.confidence.assign(points.size(), 1.);
  return result;
}

Consolidation_result consolidate(const Point_cloud& cloud, const Consolidation_options& options,
                                 const std::function<void(double)>& progress)
{
  const Scan_ranges scan(cloud, options.scanner);
  if(options.method == "iterative")
    return consolidate_iteratively(scan, options, progress);
  if(options.method == "anisotropic-wlop")
    return consolidate_anisotropically(scan, options, progress);
  return consolidate_by_deep_points(scan, options, progress);
}

}  // namespace support
