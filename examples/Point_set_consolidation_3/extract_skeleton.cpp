// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cgal_conversion.h"
#include "command_line.h"
#include "file_bytes.h"
#include "json.h"
#include "picture.h"
#include "point_file.h"
#include "scan_ranges.h"

#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;

using support::Concurrency_tag;
using support::Kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Meso_skeleton = CGAL::Meso_skeleton_3<Kernel>;
using Oriented_point = std::pair<Point, Vector>;
using Stage_times = std::vector<CGAL::Point_set_consolidation_3::Stage_time>;

struct Options {
  std::string input, output, method = "laplacian", edits, json, picture;
  bool quiet = false;
  std::size_t threads = 0;
  // laplacian
  std::string weights = "cotangent";
  std::optional<std::size_t> neighbors, samples;
  std::size_t iterations = 20, largest_merged_cycle = 6;
  double contraction_weight = 1, attraction_weight = 1, contraction_factor = 3, threshold = 0.01;
  double sampling_radius = 0.02;
  bool is_surface = false, ignores_normals = false, keeps_tips = false;
  // l1-medial
  double initial_radius = 0, repulsion = 0.35;
  // meso
  std::size_t particles = 0;
  bool curves_only = false;
  std::vector<support::Vec3> scanner;
};

struct Run {
  const Options& options;
  support::Progress_bar& progress;
  Stage_times times = {};
  support::Point_cloud cloud = {};   // what was read: points,
  support::Triangle_mesh mesh = {};  // or a soup of polygons
  std::size_t number_of_points() const { return cloud.size() + mesh.vertices.size(); }
  Meso_skeleton meso = {};  // curves and sheets, of the method meso
  bool has_sheets() const { return options.method == "meso" && !options.curves_only; }
};

Point to_point(const support::Vec3& p) { return Point(p.x(), p.y(), p.z()); }

Skeleton laplacian(Run& run)
{
  using CGAL::Point_set_consolidation_3::Laplacian_weights;
  static const std::map<std::string, Laplacian_weights> weights = {
    {"cotangent", Laplacian_weights::COTANGENT},
    {"mean-value", Laplacian_weights::MEAN_VALUE},
    {"combinatorial", Laplacian_weights::COMBINATORIAL}};
  const Options& options = run.options;
  const auto extract = [&](const auto& np, const auto&... input) {
    Skeleton skeleton;
    const auto parameters =
      np.laplacian_weights(weights.at(options.weights))
        .contraction_weight(options.contraction_weight)
        .attraction_weight(options.attraction_weight)
        .contraction_factor(options.contraction_factor)
        .convergence_threshold(options.threshold)
        .number_of_iterations(options.iterations)
        .sampling_radius(options.sampling_radius)
        .largest_merged_cycle(options.largest_merged_cycle)
        .extend_tips(!options.keeps_tips)
        .stage_times(std::ref(run.times))
        .callback([&](double fraction) { return run.progress(fraction); });
    const std::size_t samples = options.samples.value_or(options.is_surface ? 10000 : 20000);
    if(options.neighbors)
      CGAL::extract_laplacian_contraction_skeleton<Concurrency_tag>(
        input..., skeleton, parameters.number_of_samples(samples).k_neighbors(*options.neighbors));
    else
      CGAL::extract_laplacian_contraction_skeleton<Concurrency_tag>(
        input..., skeleton, parameters.number_of_samples(samples));
    return skeleton;
  };

  if(options.is_surface) {
    run.mesh = support::read_mesh(options.input);
    std::vector<Point> points;
    for(const support::Vec3& p : run.mesh.vertices)
      points.push_back(to_point(p));
    return extract(params::random_seed(std::uint64_t(0)), points, run.mesh.faces);
  }
  run.cloud = support::read_point_cloud(options.input);
  const support::Point_cloud& cloud = run.cloud;
  std::vector<Oriented_point> points;
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    const bool has_normal = !cloud.normals.empty();
    const support::Vec3 n = has_normal ? cloud.normals[i].normalized() : support::Vec3(0, 0, 0);
    points.emplace_back(to_point(cloud.points[i]), Vector(n.x(), n.y(), n.z()));
  }
  const auto positions = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>());
  if(cloud.normals.empty() || options.ignores_normals)
    return extract(positions, points);
  return extract(positions.normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()), points);
}

Skeleton l1_medial(Run& run)
{
  const Options& options = run.options;
  run.cloud = support::read_point_cloud(options.input);
  std::vector<Point> points;
  for(const support::Vec3& p : run.cloud.points)
    points.push_back(to_point(p));
  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton<Concurrency_tag>(
    points, skeleton,
    params::number_of_samples(options.samples.value_or(700))
      .neighbor_radius(options.initial_radius)
      .repulsion_weight(options.repulsion)
      .sampling_radius(options.sampling_radius)
      .largest_merged_cycle(options.largest_merged_cycle)
      .extend_tips(!options.keeps_tips)
      .stage_times(std::ref(run.times))
      .callback([&](double fraction) { return run.progress(fraction); }));
  return skeleton;
}

Skeleton meso(Run& run)
{
  const Options& options = run.options;
  run.cloud = support::read_point_cloud(options.input);
  const support::Scan_ranges scan(run.cloud, options.scanner);
  const auto np = params::point_map(CGAL::make_property_map(scan.points))
                    .callback([&](double fraction) { return run.progress(fraction); });
  const auto extract = [&](const auto& parameters) {
    CGAL::Deep_points_consolidation_3<Kernel, Concurrency_tag> consolidation(scan.indices, parameters);
    CGAL::meso_skeleton_to_graph(consolidation, run.meso,
                                 params::sampling_radius(options.sampling_radius)
                                   .largest_merged_cycle(options.largest_merged_cycle)
                                   .curves_only(options.curves_only)
                                   .extend_tips(options.curves_only && !options.keeps_tips));
    run.times = consolidation.stage_times();
  };
  support::with_scanner(scan, np, [&](const auto& parameters) {
    if(options.particles > 0)
      extract(parameters.number_of_output_points(options.particles));
    else
      extract(parameters);
  });
  return run.meso.graph;
}

using Method = Skeleton (*)(Run&);
const std::map<std::string, Method> methods = {
  {"laplacian", laplacian},
  {"l1-medial", l1_medial},
  {"meso", meso},
};

bool parse(Options& options, int argc, char** argv)
{
  support::Command_line line("extract_skeleton", "Extracts the curve skeleton of a point set.");
  line.positional("INPUT", options.input, "point file: .ply .off .noff .xyz .pwn .las");
  line.option("-o,--output", "FILE", options.output,
              "skeleton: .ply with edges and radii, or .polylines.txt; method meso with sheets also .obj and .ma");
  std::vector<std::string> names;
  for(const auto& method : methods)
    names.push_back(method.first);
  line.option("--method", "NAME", options.method, "how the skeleton is found").one_of(names);
  line.option("--edits", "FILE", options.edits,
              "edits of the skeleton, a line each: move V X Y Z, add X Y Z [R], connect V W, "
              "disconnect V W, remove V, delete_branch V, delete_cycle V, collapse_cycle V, prune LENGTH, "
              "extend_tips, radius V R, scale_radii F, interpolate [V W], bridge LENGTH");
  line.option("--picture", "FILE", options.picture, "input and skeleton, side by side (.png)");
  line.option("--json", "FILE", options.json, "report: counts, seconds and iterations of each stage");
  line.option("--threads", "N", options.threads, "number of threads").default_is("all");
  line.flag("-q,--quiet", options.quiet, "no progress bar");

  line.heading("Method laplacian");
  line.flag("--surface", options.is_surface,
            "the input is a soup of polygons (.off .ply .obj .stl), which is sampled");
  line.flag("--ignore-normals", options.ignores_normals,
            "centre by means, also if the input has (outward) normals");
  line.option("--samples", "N", options.samples, "largest number of points to contract").at_least(4)
    .default_is("20000; surfaces: 10000");
  line.option("--neighbors", "K", options.neighbors, "nearest points among which rings are found")
    .at_least(4).default_is("0.012 N within 8 and 12");
  line.option("--weights", "NAME", options.weights, "of the Laplacian")
    .one_of({"cotangent", "mean-value", "combinatorial"});
  line.option("--contraction-weight", "X", options.contraction_weight,
              "W_L^0, as a multiple of 1 / (5 S^0)").above(0);
  line.option("--attraction-weight", "X", options.attraction_weight, "W_H^0").above(0);
  line.option("--contraction-factor", "X", options.contraction_factor,
              "s_L, growth of the contraction weight").at_least(1);
  line.option("--threshold", "X", options.threshold,
              "t, least decrease of the mean extent in an iteration").above(0);
  line.option("--iterations", "N", options.iterations, "largest number of contractions").between(1, 1000);
  line.option("--sampling-radius", "X", options.sampling_radius,
              "r, distance of nodes, in bounding box diagonals").between(0.001, 1);
  line.option("--merge-cycles", "N", options.largest_merged_cycle,
              "merge cycles of at most N nodes that are no handles; 0: none");
  line.flag("--keep-tips", options.keeps_tips, "do not extend tips to the end of the shape");

  line.heading("Method l1-medial (and --samples, --sampling-radius, --merge-cycles, --keep-tips)");
  line.option("--initial-radius", "H", options.initial_radius,
              "h_0, support radius at the start, in the unit of the input")
    .at_least(0).default_is("2 diagonals over the cube root of the number of points");
  line.option("--repulsion", "X", options.repulsion, "mu, of samples along the skeleton")
    .between(0, 0.49);

  line.heading("Method meso: curves and sheets (and --sampling-radius, --merge-cycles)");
  line.option("--particles", "N", options.particles, "number of deep points")
    .default_is("5 % of the points, at least 4000");
  line.flag("--curves-only", options.curves_only,
            "contract sheets to curves: a curve skeleton, of scans from few sides the best (and --edits, --keep-tips)");
  line.option("--scanner", "X Y Z", options.scanner,
              "position of the scanner; repeated in the order of the property view");
  if(!line.parse(argc, argv))
    return false;
  if(options.method == "meso" && !options.curves_only && !options.edits.empty())
    throw support::Usage_error("--edits is for curve skeletons, not for --method meso without --curves-only");
  if(options.method == "l1-medial" && options.samples && *options.samples < 10)
    throw support::Usage_error("--samples must be at least 10 for --method l1-medial");
  if(options.output.empty())
    throw support::Usage_error("--output is missing");
  return true;
}

bool ends_with(const std::string& name, const std::string& end)
{
  return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

bool is_meso_output(const std::string& name)
{
  return ends_with(name, ".ply") || ends_with(name, ".obj") || ends_with(name, ".ma");
}

void write(const Run& run, const Skeleton& skeleton)
{
  const std::string& name = run.options.output;
  if(!run.has_sheets() && ends_with(name, ".ply"))
    support::write_segment_graph(name, support::to_segment_graph(skeleton));
  else
    support::replace_file(name, [&](const std::string& file) {
      return run.has_sheets() && is_meso_output(name)
               ? CGAL::IO::write_meso_skeleton(file, run.meso)
               : CGAL::IO::write_curve_skeleton(file, skeleton);
    });
}

void report(const Run& run, const Skeleton& skeleton)
{
  std::size_t tips = 0, branches = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    tips += degree(v, skeleton) == 1;
    branches += degree(v, skeleton) > 2;
  }
  support::Json json;
  json["method"] = run.options.method;
  json["points"] = run.number_of_points();
  json["vertices"] = num_vertices(skeleton);
  json["edges"] = num_edges(skeleton);
  if(run.has_sheets()) {
    json["components"] = CGAL::number_of_components(run.meso);
    json["cycles"] = CGAL::number_of_cycles(run.meso);
    json["sheets"] = CGAL::number_of_sheets(run.meso);
    json["triangles"] = run.meso.triangles.size();
  }
  else {
    json["components"] = CGAL::number_of_skeleton_components(skeleton);
    json["cycles"] = CGAL::number_of_skeleton_cycles(skeleton);
  }
  json["tips"] = tips;
  json["branch_vertices"] = branches;
  for(const auto& stage : run.times) {
    json["stages"][stage.name]["seconds"] = stage.seconds;
    json["stages"][stage.name]["iterations"] = stage.iterations;
  }
  support::write_json(run.options.json, json);
}

void write_picture(const Run& run, const Skeleton& skeleton)
{
  std::vector<support::Panel> panels(2);
  panels[0].title = "input";
  panels[0].cloud.points = run.cloud.points;
  panels[0].cloud.normals = run.cloud.normals;
  panels[0].mesh = run.mesh;
  panels[1] = panels[0];
  panels[1].title = "skeleton";
  panels[1].graph = support::to_segment_graph(skeleton);
  support::write_panels(run.options.picture, panels);
}

void apply_edits(const Options& options, Skeleton& skeleton)
{
  std::ifstream edits(options.edits);
  if(!edits)
    throw support::File_error(options.edits + ": cannot be opened");
  try {
    CGAL::Curve_skeleton_editing::apply_edits(skeleton, edits);
  }
  catch(const std::invalid_argument& error) {
    throw support::File_error(options.edits + ": " + error.what());
  }
}

void check_outputs(const Options& options)
{
  for(const std::string& file : {options.output, options.json})
    support::check_output(file);
  support::check_output(options.picture, {".png"});
  support::check_distinct({options.output, options.json, options.picture});
  for(const char* const end : {".ply", ".polylines.txt", ".cgal"})
    if(ends_with(options.output, end))
      return;
  const bool has_sheets = options.method == "meso" && !options.curves_only;
  if(!has_sheets || !is_meso_output(options.output))
    throw support::File_error(options.output + ": the extension is none of .ply .polylines.txt .cgal" +
                              (has_sheets ? " .obj .ma" : ""));
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("extract_skeleton", [&] {
    Options options;
    if(!parse(options, argc, argv))
      return;
    check_outputs(options);
    const support::Thread_limit threads(options.threads);
    support::Progress_bar progress("skeleton", options.quiet);
    Run run{options, progress};
    Skeleton skeleton =
      support::with_points_of(options.input, [&] { return methods.at(options.method)(run); });
    if(!options.edits.empty())
      apply_edits(options, skeleton);
    write(run, skeleton);
    if(!options.picture.empty())
      write_picture(run, skeleton);
    if(!options.json.empty())
      report(run, skeleton);
    support::report_files(options.quiet, {options.output, options.picture, options.json});
  });
}
