// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program: consolidates and completes a scan, and meshes it. See --help.

#include "command_line.h"
#include "json.h"
#include "picture.h"
#include "point_file.h"
#include "poisson_mesh.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace {

using support::Json;
using support::Point_cloud;
using support::Vec3;
namespace psc = CGAL::Point_set_consolidation_3;
namespace params = CGAL::Point_set_consolidation_3::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;
typedef CGAL::Deep_points_consolidation_3<Kernel, Concurrency_tag> Consolidation;

struct Options {
  std::string input, output, method = "deep-points";
  std::string mesh, mesh_from = "completed", inner, deep_points, completed, json, picture;
  std::size_t particles = 0, threads = 0, upsample = 0;
  double percentage = 0;
  std::string prior = "volume-preserving", data_term = "full";
  double omega = 45, sigma_p = 5, sigma_q = 2, mu = 0.4, mu_hat = 0.4, epsilon = 0.1, radius = 0;
  unsigned int wlop_iterations = 35;
  std::size_t skeleton_iterations = 10, surface_iterations = 60;
  bool no_closing = false, keep_density = false, quiet = false;
  std::vector<Vec3> scanner;
};

/// What a method returns.
struct Result {
  Point_cloud consolidated;             ///< the method's own points
  Point_cloud completed;                ///< the caller's points, then the missing ones; may be empty
  std::size_t completed_points = 0;     ///< how many of them are new
  support::Segment_graph deep_points;   ///< outer and inner vertices
  std::vector<psc::internal::Anchoring> anchoring;
  std::vector<psc::internal::Stage_time> times;
  double spacing = 0;
};

bool parse(Options& o, int argc, char** argv)
{
  support::Command_line line("consolidate_point_set",
                             "Consolidates and completes a scan: INPUT is a point file (.xyz .pwn .off .ply "
                             ".las). Its normals only tell the outer side; PLY properties vx vy vz "
                             "(direction towards the scanner) and view are used if present.");
  line.positional("INPUT", o.input, "the scan");
  line.option("-o,--output", "FILE", o.output, "consolidated points: x y z nx ny nz confidence");
  line.option("--method", "NAME", o.method, "how to consolidate")
    .one_of({"deep-points", "wlop"});
  line.option("--mesh", "FILE", o.mesh, "Poisson mesh (.off .ply .obj .stl)");
  line.option("--mesh-from", "WHAT", o.mesh_from,
              "mesh the completed input (your points, denoised if noisy, and the new ones) or the "
              "method's result alone")
    .one_of({"completed", "result"});
  line.option("--completed", "FILE", o.completed, "the completed input, your points first and in order");
  line.option("--inner", "FILE", o.inner, "inner points (meso-skeleton): .ply with radius and label");
  line.option("--deep-points", "FILE", o.deep_points, "outer and inner points joined by edges (.ply)");
  line.option("--picture", "FILE", o.picture, "before and after, side by side (.png)");
  line.option("--json", "FILE", o.json, "counts, spacing, seconds and iterations of the stages");
  line.heading("Scanner");
  line.option("--scanner", "X Y Z", o.scanner,
              "position of the scanner; repeated in the order of the property view");
  line.heading("Consolidation");
  line.option("--particles", "N", o.particles, "number of consolidated points")
    .default_is("5 % of the input, at least 4000");
  line.option("--select-percentage", "P", o.percentage, "the same in percent of the input")
    .above(0).between(0, 100).default_is("none");
  line.option("--radius", "LENGTH", o.radius, "support radius of WLOP, unit of the input")
    .default_is("2 spacings of the output");
  line.option("--wlop-iterations", "N", o.wlop_iterations, "iterations of WLOP").between(1, 10000);
  line.flag("--keep-density", o.keep_density, "do not weigh the input by its density: faster");
  line.heading("Deep points (lengths in spacings r of the consolidated points)");
  line.option("--prior", "NAME", o.prior, "what is assumed where data are missing")
    .one_of({"volume-preserving", "minimal-volume", "flat"});
  line.option("--data-term", "NAME", o.data_term, "attraction to the data, or its part along the normal "
                                                  "(better for tubes)")
    .one_of({"full", "normal"});
  line.option("--omega", "DEG", o.omega, "collision angle of sinking fronts").between(1, 170);
  line.option("--sigma-p", "R", o.sigma_p, "radius of neighbourhoods on the surface").between(0.5, 50);
  line.option("--sigma-q", "R", o.sigma_q, "radius of neighbourhoods of inner points").between(0.5, 50);
  line.option("--mu", "X", o.mu, "repulsion along the meso-skeleton").at_least(0);
  line.option("--mu-hat", "X", o.mu_hat, "repulsion on the surface").at_least(0);
  line.option("--epsilon", "X", o.epsilon, "bounds the skeleton's neighbourhoods by r / epsilon")
    .between(0.01, 10);
  line.flag("--no-closing", o.no_closing, "settle where fronts are found to meet, as published");
  line.option("--skeleton-iterations", "N", o.skeleton_iterations, "iterations of the meso-skeleton");
  line.option("--surface-iterations", "N", o.surface_iterations, "iterations of the surface");
  line.heading("Post-processing");
  line.option("--upsample", "N", o.upsample, "edge-aware up-sampling of the result to N points")
    .default_is("none");
  line.heading("Running");
  line.option("--threads", "N", o.threads, "number of threads").default_is("all");
  line.flag("--quiet", o.quiet, "no progress bar, no report");
  return line.parse(argc, argv);
}

void check_outputs(const Options& o)
{
  for(const std::string& file : {o.output, o.completed})
    if(!file.empty())
      support::check_point_output(file);
  if(!o.mesh.empty())
    support::check_mesh_output(o.mesh);
  const bool is_deep = o.method == "deep-points";
  if(!is_deep && !(o.inner.empty() && o.deep_points.empty()))
    throw support::Usage_error("--inner and --deep-points need --method deep-points");
  if(o.output.empty() && o.mesh.empty() && o.completed.empty() && o.inner.empty() &&
     o.deep_points.empty() && o.json.empty() && o.picture.empty())
    throw support::Usage_error("nothing to write: give -o, --mesh or another output");
}

Vec3 vec3(const Kernel::Point_3& p) { return Vec3(p.x(), p.y(), p.z()); }
Vec3 vec3(const Kernel::Vector_3& v) { return Vec3(v.x(), v.y(), v.z()); }

/// The scan as CGAL's functions see it: indices and maps.
struct Scan {
  std::vector<std::size_t> indices;
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals, directions;
  std::vector<int> views;
  std::vector<Kernel::Point_3> scanners;

  explicit Scan(const Point_cloud& cloud, const std::vector<Vec3>& scanner)
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
void with_scanner(const Scan& scan, const NP& np, const Run& run)
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

std::size_t particles(const Options& o, std::size_t n)
{
  if(o.particles > 0)
    return o.particles;
  if(o.percentage > 0)
    return (std::max)(std::size_t(1), std::size_t(o.percentage / 100 * double(n)));
  return psc::internal::default_particles(n);
}

psc::Prior prior(const std::string& name)
{
  return name == "minimal-volume" ? psc::Prior::MINIMAL_VOLUME
         : name == "flat"         ? psc::Prior::FLAT
                                  : psc::Prior::VOLUME_PRESERVING;
}

void collect_deep_points(const Consolidation& consolidation, Result& result)
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
    result.anchoring.push_back(consolidation.anchoring(consolidation.partner(i)));
  }
}

void collect_completed(const Consolidation& consolidation, std::size_t n, Result& result)
{
  std::vector<CGAL::Completed_point_3<Kernel> > points;
  consolidation.completed_points(std::back_inserter(points));
  Point_cloud& completed = result.completed;
  for(std::size_t i = 0; i < n; ++i) {
    completed.points.push_back(vec3(consolidation.denoised_point(i)));
    completed.normals.push_back(vec3(consolidation.denoised_normal(i)));
    completed.confidence.push_back(1);
  }
  for(const CGAL::Completed_point_3<Kernel>& p : points) {
    completed.points.push_back(vec3(p.outer()));
    completed.normals.push_back(vec3(p.normal()));
    completed.confidence.push_back(p.confidence());
  }
  result.completed_points = points.size();
}

Result consolidate(const Options& o, const Scan& scan)
{
  Result result;
  support::Progress_bar bar(o.method, o.quiet);
  const bool wants_points = !(o.output.empty() && o.inner.empty() && o.deep_points.empty()) ||
                            o.mesh_from == "result" || !o.picture.empty() || !o.json.empty();
  const bool wants_completed =
    o.mesh_from == "completed" && (!o.mesh.empty() || !o.picture.empty() || !o.json.empty());
  const auto np = params::point_map(CGAL::make_property_map(scan.points))
                    .number_of_output_points(particles(o, scan.points.size()))
                    .number_of_iterations(o.wlop_iterations)
                    .require_uniform_sampling(!o.keep_density)
                    .collision_angle(o.omega)
                    .smoothing_radius(o.sigma_p)
                    .collision_radius(o.sigma_q)
                    .closing_step(!o.no_closing)
                    .skeleton_repulsion(o.mu)
                    .surface_repulsion(o.mu_hat)
                    .axis_epsilon(o.epsilon)
                    .number_of_skeleton_iterations(o.skeleton_iterations)
                    .number_of_surface_iterations(o.surface_iterations)
                    .data_term(o.data_term == "normal" ? psc::Data_term::NORMAL
                                                       : psc::Data_term::FULL)
                    .prior(prior(o.prior))
                    .callback([&](double fraction) { return bar(fraction); });
  const auto run = [&](const auto& parameters) {
    Consolidation consolidation(scan.indices, parameters);
    if(o.method == "wlop") {
      consolidation.consolidate_input();
      for(std::size_t i = 0; i < consolidation.size(); ++i) {
        result.consolidated.points.push_back(vec3(consolidation.consolidated_point(i)));
        result.consolidated.normals.push_back(vec3(consolidation.consolidated_normal(i)));
        result.consolidated.confidence.push_back(1);
      }
    }
    else {
      if(wants_points) {
        consolidation.consolidate_outer_points();
        collect_deep_points(consolidation, result);
      }
      if(wants_completed || !o.completed.empty()) {
        consolidation.complete_missing_parts();
        collect_completed(consolidation, scan.points.size(), result);
      }
    }
    result.times = consolidation.stage_times();
    result.spacing = consolidation.spacing();
  };
  with_scanner(scan, np, [&](const auto& parameters) {
    if(o.radius > 0)
      run(parameters.neighbor_radius(o.radius));
    else
      run(parameters);
  });
  return result;
}

/// Figure 15 of the deep points paper: normals are made piecewise smooth, then points are inserted.
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

void write_inner(const std::string& file, const Result& result)
{
  support::Segment_graph inner;
  for(std::size_t i = 1; i < result.deep_points.vertices.size(); i += 2) {
    inner.vertices.push_back(result.deep_points.vertices[i]);
    inner.radius.push_back(result.deep_points.radius[i]);
  }
  support::write_segment_graph(file, inner);
}

void write_picture(const Options& o, const Point_cloud& scan, const Result& result,
                   const support::Triangle_mesh& mesh)
{
  std::vector<support::Panel> panels(1);
  panels[0].title = "input";
  panels[0].cloud = scan;
  if(panels[0].cloud.normals.empty() && !result.completed.points.empty())
    panels[0].cloud.normals.assign(result.completed.normals.begin(),
                                   result.completed.normals.begin() + std::ptrdiff_t(scan.size()));
  panels[0].cloud.confidence.clear();
  support::Panel points;
  points.title = "consolidated";
  points.cloud = result.consolidated;
  panels.push_back(points);
  if(!result.completed.points.empty()) {
    support::Panel completed;
    completed.title = "completed";
    completed.cloud = result.completed;
    panels.push_back(completed);
  }
  if(!mesh.empty()) {
    support::Panel meshed;
    meshed.title = "mesh";
    meshed.mesh = mesh;
    panels.push_back(meshed);
  }
  support::write_panels(o.picture, panels);
}

void run(int argc, char** argv)
{
  typedef std::chrono::steady_clock Clock;
  Options o;
  if(!parse(o, argc, argv))
    return;
  check_outputs(o);
  const support::Thread_limit limit(o.threads);
  const Point_cloud cloud = support::read_point_cloud(o.input);
  const Scan scan(cloud, o.scanner);

  const Clock::time_point start = Clock::now();
  Result result;
  try {
    result = consolidate(o, scan);
  }
  catch(const std::invalid_argument& error) {  // the data do not allow it
    throw support::File_error(o.input + ": " + error.what());
  }
  if(o.upsample > 0)
    upsample(result.consolidated, o.upsample);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();

  if(!o.output.empty())
    support::write_point_cloud(o.output, result.consolidated);
  if(!o.completed.empty())
    support::write_point_cloud(o.completed, result.completed);
  if(!o.inner.empty())
    write_inner(o.inner, result);
  if(!o.deep_points.empty())
    support::write_segment_graph(o.deep_points, result.deep_points);

  support::Triangle_mesh mesh;
  double mesh_seconds = 0;
  if(!o.mesh.empty()) {
    const Clock::time_point mesh_start = Clock::now();
    const Point_cloud& source = result.completed.points.empty() || o.mesh_from == "result"
                                  ? result.consolidated : result.completed;
    mesh = support::poisson_mesh(source.points, source.normals);
    mesh_seconds = std::chrono::duration<double>(Clock::now() - mesh_start).count();
    support::write_mesh(o.mesh, mesh);
  }
  if(!o.picture.empty())
    write_picture(o, cloud, result, mesh);
  if(!o.json.empty()) {
    Json json = Json::object();
    json["method"] = o.method;
    json["points"] = cloud.size();
    json["consolidated_points"] = result.consolidated.size();
    json["completed_points"] = result.completed_points;
    json["spacing"] = result.spacing;
    json["seconds"] = seconds;
    json["mesh_seconds"] = mesh_seconds;
    json["mesh_faces"] = mesh.faces.size();
    Json stages = Json::array();
    for(const auto& time : result.times) {
      Json stage = Json::object();
      stage["name"] = time.name;
      stage["seconds"] = time.seconds;
      stage["iterations"] = time.iterations;
      stages.append(stage);
    }
    json["stages"] = stages;
    support::write_json(o.json, json);
  }
  if(!o.quiet)
    std::fprintf(stderr, "%zu points -> %zu consolidated, %zu completed, %.1f s%s\n", cloud.size(),
                 result.consolidated.size(), result.completed_points, seconds,
                 mesh.empty() ? "" : "; meshed");
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("consolidate_point_set", [&] { run(argc, argv); });
}
