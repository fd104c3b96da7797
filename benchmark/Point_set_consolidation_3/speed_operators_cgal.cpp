// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_kernel.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/remove_outliers.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <limits>

namespace benchmark {

namespace {

constexpr unsigned int normal_neighbours = 18;
constexpr unsigned int smoothing_neighbours = 24;
constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

auto oriented()
{
  return CGAL::parameters::point_map(Point_map()).normal_map(Normal_map());
}

/// Sums the weights of all points around each of every twentieth point, as a projection does; the time may be
/// that of the queries alone.
void query_kd_tree(const Speed_input& input, Stopwatch& watch, bool times_building)
{
  using Traits = CGAL::Search_traits_3<Kernel>;
  const std::vector<Point_3> points = points_of(input);
  const double radius = query_radius * input.spacing;
  double sum = 0.0;
  watch.start();
  CGAL::Kd_tree<Traits> tree(points.begin(), points.end());
  tree.build();
  if(!times_building)
    watch.start();
  std::vector<Point_3> found;
  for(std::size_t i = 0; i < points.size(); i += 20) {
    found.clear();
    tree.search(std::back_inserter(found), CGAL::Fuzzy_sphere<Traits>(points[i], radius));
    for(const Point_3& p : found)
      sum += std::exp(-16.0 * CGAL::squared_distance(p, points[i]) / (radius * radius));
  }
  watch.stop();
  if(!(sum > 0.0))
    throw support::Method_error("no neighbours");
}

}  // namespace

std::vector<Speed_operator> cgal_operators()
{
  std::vector<Speed_operator> list;
  add_sequential(list, "CGAL Kd_tree + Fuzzy_sphere", "", any_size,
                 [](const Speed_input& input, Stopwatch& watch) { query_kd_tree(input, watch, true); });
  add_sequential(list, "CGAL Kd_tree queries", "", any_size,
                 [](const Speed_input& input, Stopwatch& watch) { query_kd_tree(input, watch, false); });
  add_operator(list, "CGAL average spacing", "", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_3> points = points_of(input);
                 watch.start();
                 CGAL::compute_average_spacing<decltype(tag)>(points, 6);
                 watch.stop();
               });
  add_operator(list, "CGAL PCA normals", "", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_with_normal> points = pairs_of(input);
                 watch.start();
                 CGAL::pca_estimate_normals<decltype(tag)>(points, normal_neighbours, oriented());
                 watch.stop();
               });
  add_operator(list, "CGAL jet normals", "", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_with_normal> points = pairs_of(input);
                 watch.start();
                 CGAL::jet_estimate_normals<decltype(tag)>(points, normal_neighbours, oriented());
                 watch.stop();
               });
  add_sequential(list, "CGAL MST orientation", "", any_size,
                 [](const Speed_input& input, Stopwatch& watch) {
                   std::vector<Point_with_normal> points = pairs_of(input);
                   watch.start();
                   CGAL::mst_orient_normals(points, normal_neighbours, oriented());
                   watch.stop();
                 });
  add_operator(list, "CGAL remove outliers", "", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_3> points = points_of(input);
                 watch.start();
                 CGAL::remove_outliers<decltype(tag)>(points, smoothing_neighbours,
                                                      CGAL::parameters::threshold_percent(5.0));
                 watch.stop();
               });
  add_operator(list, "CGAL jet smoothing", "", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_3> points = points_of(input);
                 watch.start();
                 CGAL::jet_smooth_point_set<decltype(tag)>(points, smoothing_neighbours);
                 watch.stop();
               });
  add_operator(list, "CGAL bilateral smoothing", "", 300000,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_with_normal> points = pairs_of(input);
                 watch.start();
                 CGAL::bilateral_smooth_point_set<decltype(tag)>(points, smoothing_neighbours,
                                                                 oriented());
                 watch.stop();
               });
  for(const bool uniform : {false, true}) {
    add_operator(list, uniform ? "CGAL WLOP, uniform" : "CGAL WLOP", "", any_size,
                 [uniform](auto tag, const Speed_input& input, Stopwatch& watch) {
                   std::vector<Point_3> points = points_of(input);
                   std::vector<Point_3> result;
                   watch.start();
                   CGAL::wlop_simplify_and_regularize_point_set<decltype(tag)>(
                       points, std::back_inserter(result),
                       CGAL::parameters::select_percentage(100.0 * particle_share)
                           .neighbor_radius(particle_radius(input))
                           .require_uniform_sampling(uniform));
                   watch.stop();
                 });
  }
  add_operator(list, "CGAL EAR", "", 100000,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_with_normal> points = pairs_of(input);
                 std::vector<Point_with_normal> result;
                 watch.start();
                 CGAL::edge_aware_upsample_point_set<decltype(tag)>(
                     points, std::back_inserter(result),
                     oriented().number_of_output_points(points.size() * 6 / 5));
                 watch.stop();
               });
  add_sequential(list, "CGAL Poisson", "", 300000, [](const Speed_input& input, Stopwatch& watch) {
    const std::vector<Point_with_normal> points = pairs_of(input);
    CGAL::Surface_mesh<Point_3> mesh;
    watch.start();
    CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), Point_map(),
                                                  Normal_map(), mesh, input.spacing);
    watch.stop();
  });
  return list;
}

}  // namespace benchmark
