// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "skeleton_runs.h"

#include "scan_ranges.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace benchmark {

namespace {

namespace core = CGAL::Point_set_consolidation_3::internal;
namespace params = CGAL::Point_set_consolidation_3::parameters;

using Consolidation = CGAL::Deep_points_consolidation_3<support::Kernel, support::Concurrency_tag>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Skeleton_run run_of(Consolidation& consolidation, bool curves_only)
{
  const Clock::time_point begin = Clock::now();
  CGAL::Meso_skeleton_3<support::Kernel> skeleton;
  CGAL::meso_skeleton_to_graph(consolidation, skeleton, params::curves_only(curves_only));
  Skeleton_run run;
  run.seconds = seconds_since(begin);
  run.cycles = number_of_cycles(skeleton);
  run.components = number_of_components(skeleton);

  const core::Meso_graph meso = core::to_meso_graph(skeleton);
  for(const core::Skeleton_node& node : meso.graph.nodes) {
    run.graph.vertices.push_back(node.position);
    run.graph.radius.push_back(node.radius);
  }
  run.graph.edges = core::all_edges(meso.graph.edges, meso.triangles);
  run.triangles = meso.triangles;
  std::vector<std::size_t> degree(run.graph.vertices.size(), 0);
  for(const auto& edge : run.graph.edges)
    for(const std::size_t v : edge)
      ++degree[v];
  run.tips = std::size_t(std::count(degree.begin(), degree.end(), std::size_t(1)));
  return run;
}

}  // namespace

Meso_runs meso_skeletons(const support::Point_cloud& scan)
{
  if(scan.directions.empty() || scan.views.empty())
    throw std::invalid_argument("meso_skeletons: the scan needs directions and views");
  const support::Scan_ranges ranges(scan, {});
  const Clock::time_point begin = Clock::now();
  Consolidation consolidation(ranges.indices,
                              params::point_map(CGAL::make_property_map(ranges.points))
                                .view_direction_map(CGAL::make_property_map(ranges.directions))
                                .view_index_map(CGAL::make_property_map(ranges.views)));
  consolidation.form_meso_skeleton();
  const double seconds = seconds_since(begin);
  Meso_runs runs = {run_of(consolidation, false), run_of(consolidation, true)};
  runs.sheets.seconds += seconds;
  runs.curves.seconds += seconds;
  return runs;
}

}  // namespace benchmark
