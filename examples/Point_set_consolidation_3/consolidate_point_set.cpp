// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program: consolidates and completes a scan, and meshes it. See --help.

#include "command_line.h"
#include "consolidation.h"
#include "file_bytes.h"
#include "json.h"
#include "picture.h"
#include "ply_file.h"
#include "point_file.h"
#include "poisson_mesh.h"
#include "small_handles.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace {

using support::Json;
using support::Point_cloud;

struct Options : support::Consolidation_options {
  std::string input, output, mesh, mesh_from = "completed", inner, deep_points, completed, json,
    picture;
  std::size_t threads = 0, upsample = 0;
  double mesh_distance = 0.1;  // the mesher's usual 0.375 facets tubes visibly
  bool keep_handles = false, quiet = false;
};

typedef support::Consolidation_result Result;

bool parse(Options& o, int argc, char** argv)
{
  support::Command_line line("consolidate_point_set",
                             "Consolidates and completes a scan: INPUT is a point file (.xyz .pwn .off .ply "
                             ".las). Its normals only tell the outer side; PLY properties vx vy vz "
                             "(direction towards the scanner) and view are used if present.");
  line.positional("INPUT", o.input, "the scan");
  line.option("-o,--output", "FILE", o.output, "consolidated points: x y z nx ny nz confidence");
  line.option("--method", "NAME", o.method, "how to consolidate")
    .one_of({"deep-points", "iterative", "anisotropic-wlop", "wlop"});
  line.option("--mesh", "FILE", o.mesh, "Poisson mesh (.off .ply .obj .stl)");
  line.option("--mesh-from", "WHAT", o.mesh_from,
              "mesh the completed input (your points, denoised if noisy, and the new ones) or the "
              "method's result alone")
    .one_of({"completed", "result"});
  line.option("--mesh-distance", "X", o.mesh_distance,
              "largest distance of the mesh's facets from the surface, in spacings of the meshed points")
    .between(0.01, 1);
  line.flag("--keep-handles", o.keep_handles,
            "mesh of the completed input: keep handles no wider than three times the noise of the scan");
  line.option("--completed", "FILE", o.completed,
              "the completed input, your points (without outliers) first and in order");
  line.option("--inner", "FILE", o.inner, "inner points (meso-skeleton), .ply with radius and label: "
              "0 curve, 1 sheet, 2 end, 3 unanchored");
  line.option("--deep-points", "FILE", o.deep_points, "outer and inner points joined by edges (.ply)");
  line.option("--picture", "FILE", o.picture, "before and after, side by side (.png)");
  line.option("--json", "FILE", o.json, "counts, spacing, seconds and iterations of the stages");
  line.heading("Scanner");
  line.option("--scanner", "X Y Z", o.scanner,
              "position of the scanner; repeated in the order of the property view");
  line.heading("Consolidation");
  line.option("--particles", "N", o.particles, "number of consolidated points")
    .at_least(1).default_is("5 % of the input, at least 4000");
  line.option("--select-percentage", "P", o.percentage, "the same in percent of the input")
    .above(0).between(0, 100).default_is("none");
  line.option("--radius", "LENGTH", o.radius, "support radius of WLOP, unit of the input")
    .above(0).default_is("2 spacings of the output");
  line.option("--wlop-iterations", "N", o.wlop_iterations, "iterations of WLOP").between(1, 10000);
  line.flag("--keep-density", o.keep_density, "do not weigh the input by its density: faster");
  line.flag("--no-denoising", o.no_denoising, "do not denoise views along their rays first");
  line.flag("--keep-outliers", o.keep_outliers, "deep points: do not leave points out that belong to no surface");
  line.heading("Deep points (lengths in spacings r of the consolidated points)");
  line.option("--prior", "NAME", o.prior, "what is assumed where data are missing")
    .one_of({"volume-preserving", "minimal-volume", "flat"});
  line.option("--max-hole", "LENGTH", o.maximum_hole, "wider gaps stay open in the completed input, unit of "
                                                      "the input").above(0).default_is("no bound");
  line.flag("--no-symmetry", o.no_symmetry, "do not complete by a mirror plane of the shape (nor with another prior, "
                                            "nor with --max-hole)");
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
  line.option("--surface-iterations", "N", o.surface_iterations, "iterations of the surface, at most");
  line.option("--completed-spacing", "R", o.completed_spacing,
              "completed regions are filled to this spacing; 0: not at all").at_least(0);
  line.heading("Iterative consolidation");
  line.flag("--no-hole-fairing", o.no_hole_fairing, "leave the points that fill a hole where they have grown");
  line.heading("Post-processing");
  line.option("--upsample", "N", o.upsample, "edge-aware up-sampling of the result to N points")
    .default_is("none");
  line.heading("Running");
  line.option("--threads", "N", o.threads, "number of threads").default_is("all");
  line.flag("-q,--quiet", o.quiet, "no progress bar, no report");
  return line.parse(argc, argv);
}

void check_outputs(Options& o)
{
  for(const std::string& file : {o.output, o.completed})
    support::check_point_output(file);
  support::check_mesh_output(o.mesh);
  for(const std::string& file : {o.inner, o.deep_points})
    support::check_output(file, {".ply"});
  support::check_output(o.picture, {".png"});
  support::check_output(o.json);
  support::check_distinct({o.output, o.completed, o.mesh, o.inner, o.deep_points, o.picture, o.json});
  const bool is_deep = o.method == "deep-points";
  if(!is_deep && !(o.inner.empty() && o.deep_points.empty()))
    throw support::Usage_error("--inner and --deep-points need --method deep-points");
  if(o.output.empty() && o.mesh.empty() && o.completed.empty() && o.inner.empty() &&
     o.deep_points.empty() && o.json.empty() && o.picture.empty())
    throw support::Usage_error("nothing to write: give -o, --mesh or another output");
  const bool completes = is_deep || o.method == "iterative";
  if(!completes && !o.completed.empty())
    throw support::Usage_error("--completed needs --method deep-points or iterative");
  const bool shows = !o.picture.empty() || !o.json.empty();
  o.wants_points = !(o.output.empty() && o.deep_points.empty()) || o.mesh_from == "result" || shows;
  o.wants_inner = !o.inner.empty();
  o.wants_completed =
    !o.completed.empty() || (o.mesh_from == "completed" && (!o.mesh.empty() || shows));
}

support::Consolidation_result consolidate(const Options& o, const Point_cloud& cloud)
{
  support::Progress_bar bar(o.method, o.quiet);
  return support::with_points_of(o.input, [&] {
    return support::consolidate(cloud, o, [&](double fraction) { bar(fraction); });
  });
}

void write_inner(const std::string& file, const Result& result)
{
  using support::Ply_type;
  support::Ply_element vertex{"vertex", result.inner.vertices.size(), {}};
  support::append_vectors(vertex, support::position_names, Ply_type::float64, result.inner.vertices);
  vertex.properties.push_back({"radius", Ply_type::float64, result.inner.radius});
  vertex.properties.push_back(
    {"label", Ply_type::uint8, {result.inner_labels.begin(), result.inner_labels.end()}});
  support::write_ply(file, {{std::move(vertex)}});
}

void write_picture(const Options& o, const Point_cloud& scan, const Result& result,
                   const support::Triangle_mesh& mesh)
{
  std::vector<support::Panel> panels(1);
  panels[0].title = "input";
  panels[0].cloud = scan;
  const bool keeps_all = !result.completed.points.empty() && result.outliers == 0;
  if(panels[0].cloud.normals.empty() && keeps_all)
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

  const Clock::time_point start = Clock::now();
  Result result = consolidate(o, cloud);
  if(o.upsample > 0)
    support::upsample(result.consolidated, o.upsample);
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
  std::size_t removed_handles = 0;
  if(!o.mesh.empty()) {
    const Clock::time_point mesh_start = Clock::now();
    const Point_cloud& source = result.completed.points.empty() || o.mesh_from == "result"
                                  ? result.consolidated : result.completed;
    support::Poisson_options mesh_options;
    mesh_options.distance = o.mesh_distance;
    mesh = support::poisson_mesh(source.points, source.normals, mesh_options);
    if(!o.keep_handles && &source == &result.completed)
      removed_handles = support::remove_handles_of_noise(mesh, result.noise);
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
    json["outliers"] = result.outliers;
    json["spacing"] = result.spacing;
    json["seconds"] = seconds;
    json["mesh_seconds"] = mesh_seconds;
    json["mesh_faces"] = mesh.faces.size();
    json["removed_handles"] = removed_handles;
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
    std::fprintf(stderr, "%zu points, %zu of them outliers -> %zu consolidated, %zu completed, %.1f s%s\n",
                 cloud.size(), result.outliers, result.consolidated.size(), result.completed_points, seconds,
                 mesh.empty() ? "" : "; meshed");
  if(!o.quiet && removed_handles > 0)
    std::fprintf(stderr, "handles no wider than three times the noise (%g) removed from the mesh: %zu, "
                 "see --keep-handles\n",
                 3 * result.noise, removed_handles);
  support::report_files(o.quiet, {o.output, o.completed, o.inner, o.deep_points, o.mesh, o.picture,
                                  o.json});
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("consolidate_point_set", [&] { run(argc, argv); });
}
