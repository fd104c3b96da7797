// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "methods.h"

#include "arguments.h"
#include "consolidation.h"
#include "point_tree.h"
#include "poisson_mesh.h"
#include "small_handles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/property_map.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <cmath>
#include <iterator>
#include <utility>

namespace benchmark {

const char* const baseline_settings = "k18-wlop4000-poisson0.4-0.2";

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Point_with_normal = std::pair<Point_3, Vector_3>;

/// Neighbours for normals, as CGAL's examples use.
constexpr unsigned int normal_neighbours = 18;

/// Neighbours for CGAL's jet smoothing, as its example uses.
constexpr unsigned int smoothing_neighbours = 24;

/// Particles of WLOP.
constexpr double wlop_points = 4000.0;

/// Support radius of WLOP in expected spacings of the particles: larger ones pull thin parts together.
constexpr double wlop_radius = 2.0;

/// Unit of length of the mesher as a share of the diagonal, about half the spacing of 4000 particles ...
constexpr double poisson_spacing = 0.004;
/// ... and distance of facets from the iso-surface in this unit: 0.1 of the spacing of 4000 particles.
constexpr double poisson_distance = 0.2;

/// Raw points whose mean direction orients the normal of a new point.
constexpr std::size_t orienting_neighbours = 6;

Point_3 to_cgal(const Vec3& p)
{
  return {p.x(), p.y(), p.z()};
}
Vec3 to_eigen(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
Vec3 to_eigen(const Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

/// Jet normals, turned towards the scanner.
Method_result with_normals(const std::vector<Vec3>& points, const std::vector<Vec3>& directions)
{
  std::vector<Point_with_normal> pairs;
  for(const Vec3& p : points)
    pairs.emplace_back(to_cgal(p), CGAL::NULL_VECTOR);
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(
      pairs, normal_neighbours,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  Method_result result;
  result.points = points;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 normal = to_eigen(pairs[i].second);
    result.normals.push_back(normal.dot(directions[i]) < 0.0 ? Vec3(-normal) : normal);
  }
  return result;
}

Method_result direct(const Point_cloud& scan)
{
  return with_normals(scan.points, scan.directions);
}

Method_result smoothed(const Point_cloud& scan)
{
  std::vector<Point_3> points;
  for(const Vec3& p : scan.points)
    points.push_back(to_cgal(p));
  CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(points, smoothing_neighbours);
  std::vector<Vec3> smooth;
  for(const Point_3& p : points)
    smooth.push_back(to_eigen(p));
  return with_normals(smooth, scan.directions);
}

Method_result wlop(const Point_cloud& scan)
{
  std::vector<Point_3> points;
  for(const Vec3& p : scan.points)
    points.push_back(to_cgal(p));
  const double share = std::min(1.0, wlop_points / static_cast<double>(points.size()));
  const double radius = wlop_radius * average_spacing(scan.points) / std::sqrt(share);
  CGAL::get_default_random() = CGAL::Random(0);  // the particles are picked by it
  std::vector<Point_3> particles;
  CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
      points, std::back_inserter(particles),
      CGAL::parameters::select_percentage(100.0 * share).neighbor_radius(radius));

  const Point_tree tree(scan.points);
  std::vector<Vec3> positions, directions;
  for(const Point_3& particle : particles) {
    positions.push_back(to_eigen(particle));
    Vec3 direction = Vec3::Zero();
    for(const Neighbour& raw : tree.nearest(positions.back(), orienting_neighbours)) {
      direction += scan.directions[raw.index];
    }
    directions.push_back(direction);
  }
  return with_normals(positions, directions);
}

/// The scan's points without outliers, and new ones in large smooth holes.
Method_result iterative(const Point_cloud& scan)
{
  std::vector<Point_3> points;
  std::vector<Vector_3> directions;
  std::vector<std::size_t> indices;
  for(std::size_t i = 0; i < scan.size(); ++i) {
    const Vec3& d = scan.directions[i];
    points.push_back(to_cgal(scan.points[i]));
    directions.emplace_back(d.x(), d.y(), d.z());
    indices.push_back(i);
  }
  std::vector<Point_with_normal> result;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
      indices, std::back_inserter(result),
      CGAL::Point_set_consolidation_3::parameters::point_map(CGAL::make_property_map(points))
          .geom_traits(Kernel())
          .view_direction_map(CGAL::make_property_map(directions))
          .view_index_map(CGAL::make_property_map(scan.views)));
  Method_result oriented;
  for(const Point_with_normal& p : result) {
    oriented.points.push_back(to_eigen(p.first));
    oriented.normals.push_back(to_eigen(p.second));
  }
  return oriented;
}

/// The paper's consolidation, its points alone.
Method_result deep_points(const Point_cloud& scan)
{
  support::Consolidation_options options;
  options.wants_completed = false;
  const Point_cloud result = support::consolidate(scan, options, {}).consolidated;
  return {result.points, result.normals, {}};
}

Method_result completed_input(const Point_cloud& scan, support::Consolidation_options options)
{
  options.wants_points = false;
  const support::Consolidation_result result = support::consolidate(scan, options, {});
  return {result.completed.points, result.completed.normals, {}, result.noise};
}

/// Completion: the scan's points and the missing ones, all options at their defaults.
Method_result completion(const Point_cloud& scan)
{
  return completed_input(scan, {});
}

/// The same without denoising along the rays.
Method_result raw_completion(const Point_cloud& scan)
{
  support::Consolidation_options options;
  options.no_denoising = true;
  return completed_input(scan, options);
}

/// Completion without directions towards the scanner.
Method_result blind_completion(const Point_cloud& scan)
{
  Point_cloud points;
  points.points = scan.points;
  return completion(points);
}

}  // namespace

const std::vector<Method>& methods()
{
  static const std::vector<Method> list = {
      {"direct", "the scan's points, CGAL's jet normals turned towards the scanner", direct, true},
      {"smoothed", "CGAL's jet smoothing of the scan's points, then as direct", smoothed, true},
      {"wlop", "CGAL's WLOP to 4000 points, then as direct", wlop, true},
      {"deep-points", "deep points consolidation, the consolidated points alone", deep_points, false},
      {"completion", "completed input of the deep points, with directions and views", completion, false},
      {"raw-completion", "the same without denoising along the rays", raw_completion, false},
      {"blind-completion", "completion without directions", blind_completion, false},
      {"iterative", "iterative consolidation, with directions and views", iterative, false},
  };
  return list;
}

const Method& method_called(const std::string& name)
{
  for(const Method& method : methods()) {
    if(method.name == name)
      return method;
  }
  throw Usage_error("unknown method '" + name + "'");
}

Triangle_mesh reconstruct(const Method_result& result)
{
  if(result.mesh)
    return *result.mesh;
  support::Poisson_options options;
  options.spacing = poisson_spacing;
  options.distance = poisson_distance;
  Triangle_mesh mesh = support::poisson_mesh(result.points, result.normals, options);
  support::remove_handles_of_noise(mesh, result.noise);
  return mesh;
}

}  // namespace benchmark
