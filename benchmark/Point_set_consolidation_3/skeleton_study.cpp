// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curve skeletons by Laplacian contraction and the surfaces they drive, measured on CGAL's models: the tables and
// figures of the 2010 paper that can be told in numbers.

#include "arguments.h"
#include "judge.h"
#include "point_file.h"
#include "virtual_scanner.h"

#include <CGAL/extract_laplacian_contraction_skeleton.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
namespace core = CGAL::Point_set_consolidation_3::internal;
using CGAL::Point_set_consolidation_3::Laplacian_weights;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Tag = CGAL::Sequential_tag;

const char* const usage = "usage: skeleton_study --data FOLDER [--points N] [--models A,B,..]\n"
                          "    [--parts topology,weights,sweep,sampling,misalignment,views,time,surface]\n";

/// Complete models whose limbs do not touch, closed, one component.
const std::vector<std::string> default_models = {"elephant", "armadillo", "homer", "dino", "knot1",
                                                 "cow",      "bear",      "eight", "pig",  "hand"};

struct Result {
  Skeleton skeleton;
  std::size_t iterations = 0;
  double seconds = 0;
};

template <typename NamedParameters>
Result extract(const std::vector<Point>& points, const NamedParameters& np)
{
  Result result;
  const auto start = std::chrono::steady_clock::now();
  CGAL::Laplacian_contraction_skeletonization_3<Kernel, Tag> steps(points, np);
  steps.extract();
  steps.skeleton(result.skeleton);
  result.iterations = steps.number_of_iterations();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::vector<Point> to_points(const std::vector<support::Vec3>& positions)
{
  std::vector<Point> points;
  for(const support::Vec3& p : positions)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

/// Evenly spread points of a mesh.
std::vector<Point> sample(const support::Triangle_mesh& mesh, std::size_t count)
{
  return to_points(core::soup_samples(mesh.vertices, mesh.faces, count, 1));
}

support::Segment_graph to_graph(const Skeleton& skeleton)
{
  const core::Skeleton_graph graph = core::to_skeleton_graph(skeleton);
  support::Segment_graph result;
  for(const core::Skeleton_node& node : graph.nodes)
    result.vertices.push_back(node.position);
  result.edges = graph.edges;
  return result;
}

void print_header(const char* title)
{
  std::printf("\n%s\n%-28s %6s %6s %7s %5s %5s %5s %7s %7s\n", title, "", "points", "genus", "cycles",
              "comp", "tips", "iter", "seconds", "inside");
}

void print_row(const std::string& name, std::size_t points, double genus, const Result& result,
               const benchmark::Judge& judge)
{
  const Skeleton& s = result.skeleton;
  std::size_t tips = 0;
  for(std::size_t v = 0; v < num_vertices(s); ++v)
    tips += degree(v, s) == 1;
  std::printf("%-28s %6zu %6.0f %7zu %5zu %5zu %5zu %7.2f %7.2f\n", name.c_str(), points, genus,
              CGAL::number_of_skeleton_cycles(s), CGAL::number_of_skeleton_components(s), tips,
              result.iterations, result.seconds, judge.skeleton(to_graph(s)).inside);
  std::fflush(stdout);
}

/// A tube with round ends without its middle, its axis, and CGAL's way out of the gap: none. Errors are those of the
/// vertices to the complete tube, in percent of the diagonal.
void study_surface()
{
  constexpr double r = 0.4, half = 1.35, gap = 0.8;
  core::Points points;
  std::mt19937_64 generator(1);
  const auto uniform = [&] { return double(generator() >> 11) / 9007199254740992.; };
  while(points.size() < 5000) {
    const double z = (2 * uniform() - 1) * (half + r), a = 2 * CGAL_PI * uniform();
    const double beyond = (std::max)(0., std::abs(z) - half), at = std::sqrt(r * r - beyond * beyond);
    if(std::abs(z) > gap / 2)
      points.emplace_back(at * std::cos(a), at * std::sin(a), z);
  }
  Skeleton skeleton(28);
  for(std::size_t v = 0; v < 28; ++v) {
    skeleton[v].point = Point(0, 0, -half + 0.1 * double(v));
    skeleton[v].radius = r;
    if(v > 0)
      add_edge(v - 1, v, skeleton);
  }
  const double diagonal = std::sqrt(8 * r * r + 4 * (half + r) * (half + r));
  std::printf("\ntube with a gap: error of the vertices, percent of the diagonal\n%-28s %8s %8s %8s %8s\n",
              "", "vertices", "mean", "max", "seconds");
  const std::vector<Point> input = to_points(points);
  const auto row = [&](const std::string& name, const auto& np) {
    CGAL::Surface_mesh<Point> mesh;
    const auto start = std::chrono::steady_clock::now();
    CGAL::skeleton_driven_surface_reconstruction<Tag>(input, skeleton, mesh, np);
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    double sum = 0, largest = 0;
    for(const auto v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      const double z = (std::max)(-half, (std::min)(half, p.z()));
      const double e = std::abs(std::sqrt(CGAL::squared_distance(p, Point(0, 0, z))) - r);
      sum += e;
      largest = (std::max)(largest, e);
    }
    std::printf("%-28s %8zu %8.3f %8.3f %8.2f\n", name.c_str(), std::size_t(mesh.number_of_vertices()),
                100 * sum / double(mesh.number_of_vertices()) / diagonal, 100 * largest / diagonal,
                seconds);
    std::fflush(stdout);
  };
  for(const std::size_t resolution : {32, 48, 64, 128, 256})
    row("octree " + std::to_string(resolution), params::grid_resolution(resolution));
  for(const std::size_t resolution : {32, 48})
    row("regular " + std::to_string(resolution), params::grid_resolution(resolution).adaptive(false));
  row("octree 48, omega_2 = 5", params::grid_resolution(48).surface_weight(5));
  row("octree 48, omega_4 = 0.05, K = 2",
      params::grid_resolution(48).outside_weight(0.05).outside_factor(2));
}

void study(const benchmark::Arguments& arguments)
{
  const std::string data = arguments.text("--data");
  const std::size_t n = arguments.count("--points", 5000);
  const std::vector<std::string> parts =
    arguments.list("--parts", {"topology", "weights", "sweep", "sampling", "misalignment", "views", "time",
                               "surface"});
  const auto wants = [&](const char* part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  for(const std::string& name : arguments.list("--models", default_models)) {
    if(parts == std::vector<std::string>{"surface"})
      break;
    const support::Triangle_mesh mesh =
      benchmark::normalized(support::read_mesh(data + "/meshes/" + name + ".off"));
    const double genus = benchmark::topology_of(mesh).genus;
    const benchmark::Judge judge(mesh);
    const std::vector<Point> points = sample(mesh, n);
    const auto row = [&](const std::string& what, const std::vector<Point>& input, const auto& np) {
      print_row(what, input.size(), genus, extract(input, np), judge);
    };
    print_header(name.c_str());
    const auto defaults = params::extend_tips(false);
    if(wants("topology"))
      row("default", points, defaults);
    if(wants("weights")) {
      row("mean value weights", points, defaults.laplacian_weights(Laplacian_weights::MEAN_VALUE));
      row("combinatorial weights", points, defaults.laplacian_weights(Laplacian_weights::COMBINATORIAL));
    }
    if(wants("sweep")) {
      for(const double w : {0.1, 2., 10.})
        row("W_L^0 x " + std::to_string(w).substr(0, 4), points, defaults.contraction_weight(w));
      for(const double w : {0.1, 0.5, 10.})
        row("W_H^0 = " + std::to_string(w).substr(0, 4), points, defaults.attraction_weight(w));
      row("s_L = 2", points, defaults.contraction_factor(2));
    }
    if(wants("sampling"))
      for(const std::size_t count : {n / 2, 2 * n})
        row("other density", sample(mesh, count), defaults);
    if(wants("misalignment"))
      for(const double shift : {0., 0.5, 1., 1.5}) {
        benchmark::Scanner_options options;
        options.directions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
        options.points = 2 * n;
        options.misalignment = shift;
        row("five views, misaligned " + std::to_string(shift).substr(0, 3),
            to_points(benchmark::scan_mesh(mesh, options).cloud.points), defaults);
      }
    if(wants("views"))
      for(const std::size_t views : {1, 2, 4}) {
        benchmark::Scanner_options options;
        options.views = views;
        options.points = n;
        row(std::to_string(views) + " views",
            to_points(benchmark::scan_mesh(mesh, options).cloud.points), defaults);
      }
    if(wants("time"))
      for(const std::size_t count : {10000, 20000, 30000})
        row("time", sample(mesh, count), defaults.number_of_samples(std::size_t(30000)));
  }
  if(wants("surface"))
    study_surface();
}

}  // namespace

int main(int argc, char** argv)
{
  try {
    const benchmark::Arguments arguments(argc, argv, {"--data", "--points", "--models", "--parts"}, {});
    if(arguments.has("--help") || !arguments.has("--data")) {
      std::cout << usage;
      return arguments.has("--help") ? 0 : 1;
    }
    study(arguments);
    return 0;
  }
  catch(const benchmark::Usage_error& error) {
    std::cerr << "skeleton_study: " << error.what() << "\n" << usage;
    return 1;
  }
  catch(const std::exception& error) {
    std::cerr << "skeleton_study: " << error.what() << "\n";
    return 2;
  }
}
