// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "iterative_runs.h"

#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <chrono>
#include <ctime>
#include <functional>
#include <iterator>

namespace benchmark {

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Tag = CGAL::Parallel_if_available_tag;
using Stage_times = std::vector<CGAL::Point_set_consolidation_3::internal::Stage_time>;

Vec3 vec3(const Point& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vec3(const Vector& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

Iterative_run consolidate_iteratively(const Point_cloud& cloud, const Iterative_options& options)
{
  std::vector<Point> points;
  std::vector<Vector> normals, directions;
  std::vector<std::size_t> indices;
  std::vector<char> is_static = options.is_static;
  is_static.resize(cloud.size(), 0);
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    points.emplace_back(cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z());
    indices.push_back(i);
  }
  for(const Vec3& n : cloud.normals)
    normals.emplace_back(n.x(), n.y(), n.z());
  for(const Vec3& d : cloud.directions)
    directions.emplace_back(d.x(), d.y(), d.z());
  Iterative_run run;
  std::vector<Oriented_point> output;
  std::vector<bool> is_new;
  Stage_times times;
  const auto np = params::point_map(CGAL::make_property_map(points))
                    .geom_traits(Kernel())
                    .particle_fraction(options.particle_fraction)
                    .number_of_iterations(options.iterations)
                    .adaptive(options.adaptive)
                    .two_phases(options.two_phases)
                    .point_is_constrained_map(CGAL::make_property_map(is_static))
                    .outlier_output_iterator(std::back_inserter(run.outliers))
                    .completed_output_iterator(std::back_inserter(is_new))
                    .inconsistent_neighbors(std::ref(run.inconsistent))
                    .stage_times(std::ref(times));
  const auto call = [&](const auto& parameters) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu_begin = std::clock();
    CGAL::iterative_consolidate_point_set<Tag>(indices, std::back_inserter(output), parameters);
    run.cpu_seconds = double(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto call_oriented = [&](const auto& parameters) {
    if(!normals.empty())
      call(parameters.normal_map(CGAL::make_property_map(normals)));
    else if(!directions.empty() && !cloud.views.empty())
      call(parameters.view_direction_map(CGAL::make_property_map(directions))
             .view_index_map(CGAL::make_property_map(cloud.views)));
    else
      call(parameters);
  };
  if(options.printed_values)
    call_oriented(np.printed_values(true));
  else
    call_oriented(np.number_of_repulsion_steps(options.repulsion_steps).completion_guard(options.guard));
  for(std::size_t i = 0; i < output.size(); ++i) {
    for(Point_cloud* target : {&run.cloud, &run.added}) {
      if(target == &run.added && !is_new[i])
        continue;
      target->points.push_back(vec3(output[i].first));
      target->normals.push_back(vec3(output[i].second));
    }
    run.cloud.confidence.push_back(is_new[i] ? 0.0 : 1.0);
  }
  for(const auto& time : times)
    if(time.name == "iteration")
      run.iterations += (std::max)(std::size_t(1), time.iterations);
  return run;
}

Point_cloud oriented_by_spanning_tree(const std::vector<Vec3>& points)
{
  constexpr unsigned int neighbors = 18;
  std::vector<Oriented_point> pairs;
  for(const Vec3& p : points)
    pairs.emplace_back(Point(p.x(), p.y(), p.z()), Vector(0, 0, 0));
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  CGAL::pca_estimate_normals<Tag>(pairs, neighbors, maps);
  CGAL::mst_orient_normals(pairs, neighbors, maps);
  Point_cloud cloud;
  for(const Oriented_point& p : pairs) {
    cloud.points.push_back(vec3(p.first));
    cloud.normals.push_back(vec3(p.second));
  }
  return cloud;
}

std::vector<Vec3> projected_onto_apss(const Point_cloud& cloud, double support)
{
  namespace core = CGAL::Point_set_consolidation_3::internal;
  constexpr std::size_t projections = 3;
  const core::Execution execution;
  const double spacing = core::data_frame(execution, cloud.points, cloud.size()).unit;
  const core::Algebraic_surface surface(cloud.points, cloud.normals, support * spacing);
  std::vector<Vec3> projected = cloud.points;
  for(std::size_t i = 0; i < projected.size(); ++i) {
    Vec3 normal = cloud.normals[i];
    surface.project(projected[i], normal, projections);
  }
  return projected;
}

}  // namespace benchmark
