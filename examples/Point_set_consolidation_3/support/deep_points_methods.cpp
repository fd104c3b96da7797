// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "consolidation.h"
#include "consolidation_methods.h"
#include "scan_ranges.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace support {

namespace psc = CGAL::Point_set_consolidation_3;
namespace params = CGAL::Point_set_consolidation_3::parameters;

namespace {

typedef CGAL::Deep_points_consolidation_3<Kernel, Concurrency_tag> Consolidation;

psc::Prior prior(const std::string& name)
{
  return name == "minimal-volume" ? psc::Prior::MINIMAL_VOLUME
         : name == "flat"         ? psc::Prior::FLAT
                                  : psc::Prior::VOLUME_PRESERVING;
}

void collect_deep_points(const Consolidation& consolidation, Consolidation_result& result)
{
  std::vector<CGAL::Deep_point_3<Kernel> > points;
  consolidation.deep_points(std::back_inserter(points));
  for(std::size_t i = 0; i < points.size(); ++i) {
    const CGAL::Deep_point_3<Kernel>& p = points[i];
    result.consolidated.points.push_back(vec3(p.outer()));
    result.consolidated.normals.push_back(vec3(p.normal()));
    result.consolidated.confidence.push_back(p.confidence());
    result.deep_points.vertices.push_back(vec3(p.outer()));
    result.deep_points.vertices.push_back(vec3(p.inner()));
    const double length = (vec3(p.outer()) - vec3(p.inner())).norm();
    result.deep_points.radius.insert(result.deep_points.radius.end(), {0., length});
    result.deep_points.edges.push_back({2 * i, 2 * i + 1});
  }
}

void collect_inner(Consolidation& consolidation, Consolidation_result& result)
{
  CGAL::Meso_skeleton_3<Kernel> skeleton;
  CGAL::meso_skeleton_to_graph(consolidation, skeleton);
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    result.inner.vertices.push_back(vec3(consolidation.skeletal_point(i)));
    result.inner.radius.push_back(skeleton.radii[i]);
    result.inner_labels.push_back(int(skeleton.labels[i]));
  }
}

void collect_completed(const Consolidation& consolidation, const Scan_ranges& scan, Consolidation_result& result)
{
  const std::size_t n = scan.points.size();
  std::vector<CGAL::Completed_point_3<Kernel> > points;
  consolidation.completed_points(std::back_inserter(points));
  Point_cloud& completed = result.completed;
  double moved = 0;
  for(std::size_t i = 0; i < n; ++i) {
    if(consolidation.is_outlier(i))
      continue;
    completed.points.push_back(vec3(consolidation.denoised_point(i)));
    moved += (completed.points.back() - vec3(scan.points[i])).squaredNorm();
    completed.normals.push_back(vec3(consolidation.denoised_normal(i)));
    completed.confidence.push_back(1);
  }
  result.noise = std::sqrt(moved / double((std::max)(completed.size(), std::size_t(1))));
  for(const CGAL::Completed_point_3<Kernel>& p : points) {
    completed.points.push_back(vec3(p.outer()));
    completed.normals.push_back(vec3(p.normal()));
    completed.confidence.push_back(p.confidence());
  }
  result.completed_points = points.size();
}

void collect_particles(const Consolidation& consolidation, Consolidation_result& result)
{
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    result.consolidated.points.push_back(vec3(consolidation.consolidated_point(i)));
    result.consolidated.normals.push_back(vec3(consolidation.consolidated_normal(i)));
    result.consolidated.confidence.push_back(1);
  }
}

}  // namespace

Consolidation_result consolidate_by_deep_points(const Scan_ranges& scan,
                                                const Consolidation_options& o,
                                                const std::function<void(double)>& progress)
{
  Consolidation_result result;
  const std::size_t n = scan.points.size();
  const auto np = params::point_map(CGAL::make_property_map(scan.points))
                    .number_of_output_points(number_of_particles(o, n))
                    .number_of_iterations(o.wlop_iterations)
                    .require_uniform_sampling(!o.keep_density)
                    .collision_angle(o.omega)
                    .smoothing_radius(o.sigma_p)
                    .collision_radius(o.sigma_q)
                    .closing_step(!o.no_closing)
                    .denoise_along_rays(!o.no_denoising && o.method != "wlop")
                    .detect_outliers(!o.keep_outliers && o.method != "wlop")
                    .skeleton_repulsion(o.mu)
                    .surface_repulsion(o.mu_hat)
                    .axis_epsilon(o.epsilon)
                    .number_of_skeleton_iterations(o.skeleton_iterations)
                    .number_of_surface_iterations(o.surface_iterations)
                    .completed_spacing(o.completed_spacing)
                    .maximum_hole_size(o.maximum_hole > 0 ? o.maximum_hole
                                                          : (std::numeric_limits<double>::max)())
                    .use_symmetry(!o.no_symmetry && o.prior == "volume-preserving" && !(o.maximum_hole > 0))
                    .data_term(o.data_term == "normal" ? psc::Data_term::NORMAL
                                                       : psc::Data_term::FULL)
                    .prior(prior(o.prior))
                    .callback(reporting(progress));
  const auto run = [&](const auto& parameters) {
    Consolidation consolidation(scan.indices, parameters);
    if(o.method == "wlop") {
      consolidation.consolidate_input();
      collect_particles(consolidation, result);
    }
    else {
      if(o.wants_points) {
        consolidation.consolidate_outer_points();
        collect_deep_points(consolidation, result);
      }
      if(o.wants_inner)
        collect_inner(consolidation, result);
      if(o.wants_completed) {
        consolidation.complete_missing_parts();
        collect_completed(consolidation, scan, result);
      }
    }
    result.times = consolidation.stage_times();
    result.spacing = consolidation.spacing();
    result.outliers = consolidation.outliers().size();
  };
  with_scanner(scan, np, [&](const auto& parameters) {
    if(o.radius > 0)
      run(parameters.neighbor_radius(o.radius));
    else
      run(parameters);
  });
  return result;
}

void upsample(Point_cloud& cloud, std::size_t count)
{
  if(count <= cloud.size())
    return;
  typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Pair;
  std::vector<Pair> points;
  for(std::size_t i = 0; i < cloud.size(); ++i)
    points.emplace_back(
      Kernel::Point_3(cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z()),
      Kernel::Vector_3(cloud.normals[i].x(), cloud.normals[i].y(), cloud.normals[i].z()));
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                      .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  constexpr unsigned int smoothing_neighbors = 24;
  CGAL::bilateral_smooth_point_set<Concurrency_tag>(points, smoothing_neighbors, maps);
  const std::vector<Pair> base = points;
  CGAL::edge_aware_upsample_point_set<Concurrency_tag>(
    base, std::back_inserter(points),
    maps.sharpness_angle(25).edge_sensitivity(0).number_of_output_points((unsigned int)count));
  cloud = Point_cloud();
  for(const Pair& p : points) {
    cloud.points.push_back(vec3(p.first));
    cloud.normals.push_back(vec3(p.second));
    cloud.confidence.push_back(1);
  }
}

}  // namespace support
