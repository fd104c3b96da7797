// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_kernel.h"

#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/bilateral_project_point_set.h>
#include <CGAL/complete_point_set.h>
#include <CGAL/deep_points_consolidate_point_set.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/mean_shift_remove_outliers.h>
#include <CGAL/wlop_project_point_set.h>

#include <functional>
#include <limits>
#include <numeric>

namespace benchmark {

namespace {

namespace parameters = CGAL::Point_set_consolidation_3::parameters;

constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

/// As `query_kd_tree()`.
void query_sorted_grid(const Speed_input& input, Stopwatch& watch, bool times_building)
{
  using namespace CGAL::Point_set_consolidation_3::internal;
  const double radius = query_radius * input.spacing;
  double sum = 0.0;
  watch.start();
  const Sorted_grid grid(input.points, radius);
  if(!times_building)
    watch.start();
  Block_weights weights;
  for(std::size_t i = 0; i < input.points.size(); i += 20) {
    grid.for_each_neighbor_block(input.points[i], radius, [&](const Neighbor_block& block) {
      sum += weights.set_gaussian(16.0 / (radius * radius), block).sum();
    });
  }
  watch.stop();
  if(!(sum > 0.0))
    throw support::Method_error("no neighbours");
}

/// A scan as indices with maps, with everything a depth camera knows.
struct Scan_maps {
  std::vector<Point_3> points;
  std::vector<Vector_3> directions;
  std::vector<int> views;
  std::vector<std::size_t> indices;

  explicit Scan_maps(const Speed_input& input)
    : points(points_of(input)), views(input.views), indices(input.points.size())
  {
    for(const Vec3& d : input.directions)
      directions.emplace_back(d.x(), d.y(), d.z());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
  }

  auto named() const
  {
    return parameters::point_map(CGAL::make_property_map(points))
        .geom_traits(Kernel())
        .view_direction_map(CGAL::make_property_map(directions))
        .view_index_map(CGAL::make_property_map(views));
  }
};

using Stage_times = std::vector<CGAL::Point_set_consolidation_3::Stage_time>;

auto oriented()
{
  return parameters::point_map(Point_map()).normal_map(Normal_map());
}

std::size_t particles(const Speed_input& input)
{
  return static_cast<std::size_t>(particle_share * static_cast<double>(input.points.size()));
}

/// Times `work(times)`, a function of the package that reports its stages.
template <typename Work>
void measure_stages(Stopwatch& watch, const Work& work)
{
  Stage_times times;
  watch.start();
  work(times);
  watch.stop();
  watch.record_stages(times);
}

}  // namespace

/// Add an operator by one entry: name, operator of CGAL to compare with, largest number of points, call.
std::vector<Speed_operator> package_operators()
{
  std::vector<Speed_operator> list;
  add_sequential(list, "sorted grid", "CGAL Kd_tree + Fuzzy_sphere", any_size,
                 [](const Speed_input& input, Stopwatch& watch) { query_sorted_grid(input, watch, true); });
  add_sequential(list, "sorted grid queries", "CGAL Kd_tree queries", any_size,
                 [](const Speed_input& input, Stopwatch& watch) { query_sorted_grid(input, watch, false); });
  add_operator(list, "wlop_project", "CGAL WLOP", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_3> points = points_of(input);
                 std::vector<Point_3> result;
                 watch.start();
                 CGAL::wlop_project_point_set<decltype(tag)>(
                     points, std::back_inserter(result),
                     parameters::number_of_output_points(particles(input))
                         .neighbor_radius(particle_radius(input)));
                 watch.stop();
               });
  add_operator(list, "anisotropic WLOP", "CGAL WLOP", 300000,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_with_normal> points = pairs_of(input);
                 std::vector<Point_with_normal> result;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::anisotropic_wlop_simplify_and_regularize_point_set<decltype(tag)>(
                       points, std::back_inserter(result),
                       oriented()
                           .number_of_output_points(particles(input))
                           .neighbor_radius(particle_radius(input))
                           .stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "deep points", "CGAL WLOP", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const Scan_maps scan(input);
                 std::vector<CGAL::Deep_point_3<Kernel>> result;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::deep_points_consolidate_point_set<decltype(tag)>(
                       scan.indices, std::back_inserter(result),
                       scan.named().number_of_output_points(particles(input)).stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "completion", "CGAL WLOP", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const Scan_maps scan(input);
                 std::vector<CGAL::Deep_point_3<Kernel>> result;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::complete_point_set<decltype(tag)>(scan.indices, std::back_inserter(result),
                                                           scan.named().stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "iterative consolidation", "CGAL WLOP", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const Scan_maps scan(input);
                 std::vector<Point_with_normal> result;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::iterative_consolidate_point_set<decltype(tag)>(
                       scan.indices, std::back_inserter(result), scan.named().stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "mean shift outliers", "CGAL remove outliers", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_3> points = points_of(input);
                 std::vector<Point_3> result;
                 watch.start();
                 CGAL::mean_shift_remove_outliers<decltype(tag)>(points,
                                                                 std::back_inserter(result));
                 watch.stop();
               });
  add_operator(list, "bilateral projection", "CGAL bilateral smoothing", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 std::vector<Point_with_normal> points = pairs_of(input);
                 watch.start();
                 CGAL::bilateral_project_point_set<decltype(tag)>(
                     points, oriented().number_of_iterations(1));
                 watch.stop();
               });
  add_operator(list, "anisotropic up-sampling", "CGAL EAR", any_size,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_with_normal> points = pairs_of(input);
                 std::vector<Point_with_normal> result;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::anisotropic_edge_aware_upsample_point_set<decltype(tag)>(
                       points, std::back_inserter(result),
                       oriented().number_of_output_points(points.size() * 6 / 5)
                           .stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "Laplacian skeleton", "CGAL WLOP", 100000,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_3> points = points_of(input);
                 CGAL::Curve_skeleton_3<Kernel> skeleton;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::extract_laplacian_contraction_skeleton<decltype(tag)>(
                       points, skeleton, parameters::stage_times(std::ref(times)));
                 });
               });
  add_operator(list, "L1-medial skeleton", "CGAL WLOP", 100000,
               [](auto tag, const Speed_input& input, Stopwatch& watch) {
                 const std::vector<Point_3> points = points_of(input);
                 CGAL::Curve_skeleton_3<Kernel> skeleton;
                 measure_stages(watch, [&](Stage_times& times) {
                   CGAL::extract_l1_medial_skeleton<decltype(tag)>(
                       points, skeleton, parameters::stage_times(std::ref(times)));
                 });
               });
  return list;
}

namespace {

template <typename Tag>
void run_class_as(Class_method method, const Paper_class& row, const Speed_input& input, Stopwatch& watch)
{
  const Scan_maps scan(input);
  Stage_times times;
  if(method == Class_method::deep_points) {
    std::vector<CGAL::Deep_point_3<Kernel>> result;
    watch.start();
    CGAL::deep_points_consolidate_point_set<Tag>(
        scan.indices, std::back_inserter(result),
        scan.named()
            .number_of_output_points((std::min)(row.particles, scan.indices.size()))
            .stage_times(std::ref(times)));
    watch.stop();
  } else {
    std::vector<Point_with_normal> result;
    watch.start();
    CGAL::iterative_consolidate_point_set<Tag>(
        scan.indices, std::back_inserter(result),
        scan.named()
            .particle_fraction(static_cast<double>(row.particles) / static_cast<double>(row.points))
            .number_of_iterations(row.steps)
            .two_phases(row.two_phases)
            .stage_times(std::ref(times)));
    watch.stop();
  }
  watch.record_stages(times);
}

}  // namespace

void run_class(Class_method method, const Paper_class& row, bool parallel, const Speed_input& input, Stopwatch& watch)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(parallel) {
    run_class_as<CGAL::Parallel_tag>(method, row, input, watch);
    return;
  }
#else
  (void)parallel;
#endif
  run_class_as<CGAL::Sequential_tag>(method, row, input, watch);
}

}  // namespace benchmark
