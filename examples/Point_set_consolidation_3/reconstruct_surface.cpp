// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cgal_conversion.h"
#include "command_line.h"
#include "file_bytes.h"
#include "json.h"
#include "picture.h"
#include "point_file.h"
#include "poisson_mesh.h"

#include <CGAL/feature_enhanced_surface_reconstruction.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;
using Stage_times = std::vector<CGAL::Point_set_consolidation_3::Stage_time>;

struct Options {
  std::string input, output, method = "poisson", skeleton, json, picture;
  bool quiet = false;
  std::size_t threads = 0;
  // poisson
  support::Poisson_options poisson;
  // skeleton-driven
  std::size_t resolution = 64;
  bool is_regular = false;
  double smoothness_weight = 1, surface_weight = 0, skeleton_weight = 0.5, outside_weight = 0.005;
  double outside_factor = 4;
  // feature-enhanced
  std::size_t segments = 0;
  std::vector<std::string> segment_methods;
  double normal_weight = 10, sharpness_angle = 20, upsampling = 1;
  bool denoises = false;
};

// Of the points in the equations of the field, unless told.
double surface_weight(const Options& options)
{
  if(options.surface_weight > 0)
    return options.surface_weight;
  return options.method == "feature-enhanced" ? 500 : 50;
}

struct Run {
  const Options& options;
  support::Progress_bar& progress;
  Stage_times times = {};
  support::Point_cloud cloud = {};
};

support::Triangle_mesh poisson(Run& run)
{
  run.cloud = support::read_point_cloud(run.options.input);
  const support::Point_cloud& cloud = run.cloud;
  if(cloud.normals.empty())
    support::file_error(run.options.input, "method poisson needs normals");
  if(cloud.size() < 4)
    support::file_error(run.options.input, "method poisson needs at least 4 points");
  return support::poisson_mesh(cloud.points, cloud.normals, run.options.poisson);
}

support::Triangle_mesh skeleton_driven(Run& run)
{
  const Options& options = run.options;
  if(options.skeleton.empty())
    throw support::Usage_error("method skeleton-driven needs --skeleton");
  run.cloud = support::read_point_cloud(options.input);
  const support::Point_cloud& cloud = run.cloud;
  std::vector<Point> points;
  for(const support::Vec3& p : cloud.points)
    points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  std::string message;
  if(!CGAL::IO::read_curve_skeleton(options.skeleton, skeleton, &message))
    throw support::File_error(options.skeleton + ": " + message);

  Mesh mesh;
  CGAL::skeleton_driven_surface_reconstruction<Concurrency_tag>(
    points, skeleton, mesh,
    params::grid_resolution(options.resolution)
      .adaptive(!options.is_regular)
      .smoothness_weight(options.smoothness_weight)
      .surface_weight(surface_weight(options))
      .skeleton_weight(options.skeleton_weight)
      .outside_weight(options.outside_weight)
      .outside_factor(options.outside_factor)
      .stage_times(std::ref(run.times))
      .callback([&](double fraction) { return run.progress(fraction); }));

  return support::to_triangle_mesh(mesh);
}

// Words NAME, or S:NAME for segment S only.
std::vector<CGAL::Point_set_consolidation_3::Part_method>
segment_methods(const std::vector<std::string>& words)
{
  using CGAL::Point_set_consolidation_3::Part_method;
  static const std::map<std::string, Part_method> names = {{"automatic", Part_method::AUTOMATIC},
                                                           {"data", Part_method::DATA},
                                                           {"skeleton", Part_method::SKELETON}};
  std::vector<Part_method> methods;
  for(const std::string& word : words) {
    const std::size_t colon = word.find(':');
    const std::string number = word.substr(0, colon);
    const auto found = colon == std::string::npos ? names.end() : names.find(word.substr(colon + 1));
    if(found == names.end() || number.empty() || number.size() > 4 ||
       number.find_first_not_of("0123456789") != std::string::npos)
      throw support::Usage_error("--segment-method: " + word +
                                 " is not S:automatic, S:data or S:skeleton with a segment's number S");
    const std::size_t segment = std::stoul(number);
    if(methods.size() <= segment)
      methods.resize(segment + 1, Part_method::AUTOMATIC);
    methods[segment] = found->second;
  }
  return methods;
}

support::Triangle_mesh feature_enhanced(Run& run)
{
  typedef std::pair<Point, Kernel::Vector_3> Oriented_point;
  const Options& options = run.options;
  run.cloud = support::read_point_cloud(options.input);
  const support::Point_cloud& cloud = run.cloud;
  std::vector<Oriented_point> points;
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    const support::Vec3 p = cloud.points[i];
    const support::Vec3 n = cloud.normals.empty() ? support::Vec3(0, 0, 0) : cloud.normals[i];
    points.emplace_back(Point(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  std::string message;
  if(!options.skeleton.empty() &&
     !CGAL::IO::read_curve_skeleton(options.skeleton, skeleton, &message))
    throw support::File_error(options.skeleton + ": " + message);

  Mesh mesh;
  const auto reconstruct = [&](const auto& np) {
    CGAL::feature_enhanced_surface_reconstruction<Concurrency_tag>(
      points, skeleton, mesh,
      np.number_of_segments(options.segments)
        .segment_methods(segment_methods(options.segment_methods))
        .sharpness_angle(options.sharpness_angle)
        .upsampling_factor(options.upsampling)
        .grid_resolution(options.resolution)
        .surface_weight(surface_weight(options))
        .normal_weight(options.normal_weight)
        .enhance_features(options.denoises)
        .stage_times(std::ref(run.times))
        .callback([&](double fraction) { return run.progress(fraction); }));
  };
  const auto positions = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>());
  if(cloud.normals.empty())
    reconstruct(positions);
  else
    reconstruct(positions.normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()));
  return support::to_triangle_mesh(mesh);
}

using Method = support::Triangle_mesh (*)(Run&);
const std::map<std::string, Method> methods = {
  {"poisson", poisson},
  {"skeleton-driven", skeleton_driven},
  {"feature-enhanced", feature_enhanced},
};

bool parse(Options& options, int argc, char** argv)
{
  support::Command_line line("reconstruct_surface", "Reconstructs a surface from a point set.");
  line.positional("INPUT", options.input, "point file: .ply .off .noff .xyz .pwn .las");
  line.option("-o,--output", "FILE", options.output, "mesh: .off .ply .obj .stl");
  std::vector<std::string> names;
  for(const auto& method : methods)
    names.push_back(method.first);
  line.option("--method", "NAME", options.method, "how the surface is found").one_of(names);
  line.option("--picture", "FILE", options.picture, "input and surface, side by side (.png)");
  line.option("--json", "FILE", options.json, "report: counts, seconds of each stage");
  line.option("--threads", "N", options.threads, "number of threads").default_is("all");
  line.flag("-q,--quiet", options.quiet, "no progress bar");

  line.heading("Method poisson (CGAL's; the points have outward normals)");
  line.option("--spacing", "X", options.poisson.spacing, "unit of the facets' sizes")
    .at_least(0).default_is("average spacing of the points");
  line.option("--facet-angle", "DEG", options.poisson.angle, "smallest angle of facets").between(0, 30);
  line.option("--facet-radius", "X", options.poisson.radius, "largest facets, in spacings").above(0);
  line.option("--facet-distance", "X", options.poisson.distance,
              "largest distance to the iso-surface, in spacings").above(0);

  line.heading("Method skeleton-driven");
  line.option("--skeleton", "FILE", options.skeleton, "curve skeleton with radii: .ply with edges");
  line.option("--resolution", "N", options.resolution, "cells along the longest side").between(8, 1024);
  line.flag("--regular-grid", options.is_regular, "a regular grid instead of an octree");
  line.option("--smoothness-weight", "X", options.smoothness_weight, "omega_1").above(0);
  line.option("--surface-weight", "X", options.surface_weight, "omega_2, of the points").above(0)
    .default_is("50; feature-enhanced: 500");
  line.option("--skeleton-weight", "X", options.skeleton_weight, "omega_3").at_least(0);
  line.option("--outside-weight", "X", options.outside_weight, "omega_4").at_least(0);
  line.option("--outside-factor", "K", options.outside_factor,
              "radii from the skeleton that are outside").at_least(1);

  line.heading("Method feature-enhanced (and --skeleton, --resolution, --surface-weight)");
  line.option("--segments", "N", options.segments, "number of segments")
    .default_is("found automatically");
  line.option("--segment-method", "S:NAME", options.segment_methods,
              "what the surface of segment S is made from: automatic, data or skeleton; may be repeated");
  line.option("--sharpness-angle", "DEG", options.sharpness_angle,
              "normals that differ by more are not averaged").between(1, 89);
  line.option("--upsampling", "X", options.upsampling, "points after up-sampling, in numbers of points")
    .between(1, 100);
  line.option("--normal-weight", "X", options.normal_weight, "of the normals as gradients of the field")
    .at_least(0);
  line.flag("--denoise", options.denoises, "denoise the points first: for flat faces and sharp edges");
  if(!line.parse(argc, argv))
    return false;
  if(options.output.empty())
    throw support::Usage_error("--output is missing");
  return true;
}

void report(const Run& run, const support::Triangle_mesh& mesh)
{
  support::Json json;
  json["method"] = run.options.method;
  json["points"] = run.cloud.size();
  json["vertices"] = mesh.vertices.size();
  json["faces"] = mesh.faces.size();
  for(const auto& stage : run.times) {
    json["stages"][stage.name]["seconds"] = stage.seconds;
    json["stages"][stage.name]["iterations"] = stage.iterations;
  }
  support::write_json(run.options.json, json);
}

void write_picture(const Run& run, const support::Triangle_mesh& mesh)
{
  std::vector<support::Panel> panels(2);
  panels[0].title = "input";
  panels[0].cloud.points = run.cloud.points;
  panels[0].cloud.normals = run.cloud.normals;
  if(!run.options.skeleton.empty())
    panels[0].graph = support::read_segment_graph(run.options.skeleton);
  panels[1].title = run.options.method;
  panels[1].mesh = mesh;
  support::write_panels(run.options.picture, panels);
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("reconstruct_surface", [&] {
    Options options;
    if(!parse(options, argc, argv))
      return;
    support::check_mesh_output(options.output);
    support::check_output(options.picture, {".png"});
    support::check_output(options.json);
    support::check_distinct({options.output, options.picture, options.json});
    const support::Thread_limit threads(options.threads);
    support::Progress_bar progress("surface", options.quiet);
    Run run{options, progress};
    const support::Triangle_mesh mesh =
      support::with_points_of(options.input, [&] { return methods.at(options.method)(run); });
    support::write_mesh(options.output, mesh);
    if(!options.picture.empty())
      write_picture(run, mesh);
    if(!options.json.empty())
      report(run, mesh);
    support::report_files(options.quiet, {options.output, options.picture, options.json});
  });
}
