// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curve skeletons by Laplacian contraction, measured on CGAL's models.

#include "arguments.h"
#include "judge.h"
#include "models.h"
#include "point_file.h"
#include "skeleton_runs.h"
#include "virtual_scanner.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace benchmark;

const char* const usage =
  "usage: skeleton_study [--data FOLDER] [--points N] [--models A,B,..]\n"
  "    [--parts topology,weights,sweep,sampling,misalignment,views,time]\n"
  "Curve skeletons by Laplacian contraction of CGAL's models; paper_figures laplacian makes the paper's figures.\n";

/// Complete models whose limbs do not touch, closed, one component.
const std::vector<std::string> default_models = {"elephant", "armadillo", "homer", "dino", "knot1",
                                                 "cow",      "bear",      "eight", "pig",  "hand"};

void print_header(const char* title)
{
  std::printf("\n%s\n%-28s %6s %6s %7s %5s %5s %5s %7s %7s\n", title, "", "points", "genus", "cycles",
              "comp", "tips", "iter", "seconds", "inside");
}

void print_row(const std::string& name, std::size_t points, double genus, const Skeleton_run& run,
               const Judge& judge)
{
  std::printf("%-28s %6zu %6.0f %7zu %5zu %5zu %5zu %7.2f %7.2f\n", name.c_str(), points, genus, run.cycles,
              run.components, run.tips, run.iterations, run.seconds, judge.skeleton(run.graph).inside);
  std::fflush(stdout);
}

void study(const Arguments& arguments)
{
  const std::string data = data_folder(arguments.text("--data"));
  const std::size_t n = arguments.count("--points", 5000);
  const std::vector<std::string> parts = arguments.list(
    "--parts", {"topology", "weights", "sweep", "sampling", "misalignment", "views", "time"});
  const auto wants = [&](const char* part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  const auto changed = [](const auto& change) {
    Skeleton_options options;
    change(options);
    return options;
  };
  for(const std::string& name : arguments.list("--models", default_models)) {
    const Triangle_mesh mesh = normalized(support::read_mesh(data + "/meshes/" + name + ".off"));
    const double genus = topology_of(mesh).genus;
    const Judge judge(mesh);
    const std::vector<Vec3> points = even_samples(mesh, n);
    const auto row = [&](const std::string& what, const std::vector<Vec3>& input,
                         const Skeleton_options& options = {}) {
      print_row(what, input.size(), genus, laplacian_skeleton(input, {}, options), judge);
    };
    const auto short_number = [](double value) { return std::to_string(value).substr(0, 4); };
    print_header(name.c_str());
    if(wants("topology"))
      row("default", points);
    if(wants("weights")) {
      row("mean value weights", points,
          changed([](Skeleton_options& o) { o.weights = Laplacian_weight::mean_value; }));
      row("combinatorial weights", points,
          changed([](Skeleton_options& o) { o.weights = Laplacian_weight::combinatorial; }));
    }
    if(wants("sweep")) {
      for(const double w : {0.1, 2., 10.})
        row("W_L^0 x " + short_number(w), points,
            changed([&](Skeleton_options& o) { o.contraction_weight = w; }));
      for(const double w : {0.1, 0.5, 10.})
        row("W_H^0 = " + short_number(w), points,
            changed([&](Skeleton_options& o) { o.attraction_weight = w; }));
      row("s_L = 2", points, changed([](Skeleton_options& o) { o.contraction_factor = 2; }));
    }
    if(wants("sampling"))
      for(const std::size_t count : {n / 2, 2 * n})
        row("other density", even_samples(mesh, count));
    const auto scanned = [&](const Scanner_options& options) { return scan_mesh(mesh, options).cloud.points; };
    if(wants("misalignment"))
      for(const double shift : {0., 0.5, 1., 1.5}) {
        Scanner_options options;
        options.directions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
        options.points = 2 * n;
        options.misalignment = shift;
        row("five views, misaligned " + short_number(shift), scanned(options));
      }
    if(wants("views"))
      for(const std::size_t views : {1, 2, 4}) {
        Scanner_options options;
        options.views = views;
        options.points = n;
        row(std::to_string(views) + " views", scanned(options));
      }
    if(wants("time"))
      for(const std::size_t count : {10000, 20000, 30000})
        row("time", even_samples(mesh, count));
  }
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program("skeleton_study", usage, argc, argv,
                                {"--data", "--points", "--models", "--parts"},
                                {}, study);
}
