// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The figures and the table of the iterative consolidation paper (2012), on known shapes. The core is called
// directly, so that each of the method's parameters can be varied.

#include "arguments.h"
#include "judge.h"
#include "mesh_tree.h"
#include "models.h"
#include "picture.h"
#include "point_tree.h"
#include "poisson_mesh.h"
#include "random_numbers.h"
#include "virtual_scanner.h"

#include <CGAL/Point_set_consolidation_3/internal/iterative_consolidation.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

using namespace benchmark;
namespace core = CGAL::Point_set_consolidation_3::internal;

namespace {

const char* const usage =
  R"(iterative_study [options]
Iterative consolidation on known shapes, scaled to unit diagonal; lengths are percent of it.
  --data DIR       CGAL's data (environment variable CGAL_DATA_DIR)
  --parts LIST     apss        noisy armadillo projected onto its algebraic surface, true normals
                   outliers    figures 5 and 10: armadillo with 5 to 20 % of noise, near and far
                   ellipsoid   figure 2: one large smooth hole; with and without repulsion, printed values
                   bunny       six holes
                   body        figure 8: front and back scan of a body, in one and two phases
                   static      figure 12: a part that must not be extended
                   loops       section III: adaptive against plain loop
                   table       table I: classes of size, times
                   (all)
  --seeds N        repetitions with other samples and noise, averaged (1)
  --threads N      2: runs in parallel where the time is measured (1)
  --pictures DIR   writes pictures there
)";

struct Settings {
  std::string data, pictures;
  std::size_t seeds = 1;
  bool parallel = false;
};

struct Run {
  core::Iterative_result result;
  core::Stage_times times;
  double seconds = 0, cpu_seconds = 0;
};

Run run(const core::Iterative_input& input, const core::Iterative_parameters& parameters,
        bool parallel = false)
{
  Run r;
  core::Execution execution;
  execution.parallel = parallel;
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t cpu_begin = std::clock();
  r.result = core::consolidate_iteratively(execution, input, parameters);
  r.cpu_seconds = double(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  r.times = execution.times;
  return r;
}

/// The input's points that are no outliers, then the new ones.
Point_cloud result_cloud(const core::Iterative_input& input, const core::Iterative_result& result)
{
  Point_cloud cloud;
  for(std::size_t i = 0; i < input.points.size(); ++i)
    if(!result.is_outlier[i]) {
      cloud.points.push_back(input.points[i]);
      cloud.normals.push_back(result.normals[i]);
      cloud.confidence.push_back(1);
    }
  for(std::size_t i = 0; i < result.new_points.size(); ++i) {
    cloud.points.push_back(result.new_points[i]);
    cloud.normals.push_back(result.new_normals[i]);
    cloud.confidence.push_back(0);
  }
  return cloud;
}

/// As in the accuracy study.
Triangle_mesh mesh_of(const std::vector<Vec3>& points, const std::vector<Vec3>& normals)
{
  support::Poisson_options options;
  options.spacing = 0.004;
  options.distance = 0.2;
  return support::poisson_mesh(points, normals, options);
}

Triangle_mesh model_mesh(const Settings& settings, const std::string& name)
{
  return load_model(select_models({name}).front(), settings.data);
}

struct Samples {
  std::vector<Vec3> points, normals;
};

Samples sample(const Triangle_mesh& mesh, std::size_t count, std::uint64_t seed)
{
  const Surface_samples surface = sample_surface(mesh, count, seed);
  Samples samples;
  samples.points = surface.points;
  for(const std::size_t face : surface.faces)
    samples.normals.push_back(face_normal(mesh, face));
  return samples;
}

/// An ellipsoid with semi-axes 1, 0.7, 0.5, scaled to unit diagonal, as a fine mesh.
Triangle_mesh ellipsoid_mesh()
{
  constexpr std::size_t rows = 100, columns = 200;
  Triangle_mesh mesh;
  const Vec3 axes(1, 0.7, 0.5);
  const auto add = [&](double theta, double phi) {
    mesh.vertices.push_back(axes.cwiseProduct(Vec3(std::sin(theta) * std::cos(phi),
                                                   std::sin(theta) * std::sin(phi), std::cos(theta))));
  };
  constexpr double pi = 3.14159265358979324;
  add(0, 0);
  for(std::size_t r = 1; r < rows; ++r)
    for(std::size_t c = 0; c < columns; ++c)
      add(pi * double(r) / rows, 2 * pi * double(c) / columns);
  add(pi, 0);
  const std::size_t last = mesh.vertices.size() - 1;
  const auto at = [&](std::size_t r, std::size_t c) { return 1 + (r - 1) * columns + c % columns; };
  for(std::size_t c = 0; c < columns; ++c) {
    mesh.faces.push_back({0, at(1, c), at(1, c + 1)});
    mesh.faces.push_back({last, at(rows - 1, c + 1), at(rows - 1, c)});
    for(std::size_t r = 1; r + 1 < rows; ++r) {
      mesh.faces.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      mesh.faces.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
  return normalized(mesh);
}

// ---- APSS ---------------------------------------------------------------------------------------

void study_apss(const Settings& settings)
{
  std::printf("\nAPSS of the armadillo, 10k points with noise of 0.5 %% and true normals: mean distance, %%\n"
              "%10s %10s %10s %10s %10s %10s\n",
              "seed", "noisy", "h=3", "h=4", "h=6", "h=8 spac.");
  const Triangle_mesh mesh = model_mesh(settings, "armadillo");
  const Mesh_tree tree(mesh);
  for(std::size_t seed = 1; seed <= settings.seeds; ++seed) {
    Samples samples = sample(mesh, 10000, seed);
    Random_numbers random(seed);
    double before = 0;
    for(Vec3& p : samples.points) {
      p += 0.005 * Vec3(random.normal(), random.normal(), random.normal());
      before += (tree.closest(p).point - p).norm();
    }
    std::printf("%10zu %10.4f", seed, 100 * before / double(samples.points.size()));
    const core::Execution execution;
    const double spacing = core::data_frame(execution, samples.points, samples.points.size()).unit;
    for(const double support : {3., 4., 6., 8.}) {
      const core::Algebraic_surface surface(samples.points, samples.normals, support * spacing);
      double after = 0;
      for(std::size_t i = 0; i < samples.points.size(); ++i) {
        Vec3 x = samples.points[i], n = samples.normals[i];
        surface.project(x, n, 3);
        after += (tree.closest(x).point - x).norm();
      }
      std::printf(" %10.4f", 100 * after / double(samples.points.size()));
    }
    std::printf("\n");
  }
}

// ---- outliers -----------------------------------------------------------------------------------

struct Detection {
  double precision = 0, recall = 0, kept_error = 0;
  std::size_t true_outliers = 0;
};

/// Outliers are what lies farther than 0.5 % from the surface.
Detection detect(const core::Iterative_input& input, const std::vector<char>& flagged, const Mesh_tree& tree)
{
  Detection d;
  std::size_t found = 0, right = 0, kept = 0;
  for(std::size_t i = 0; i < input.points.size(); ++i) {
    const double distance = (tree.closest(input.points[i]).point - input.points[i]).norm();
    const bool is_outlier = distance > 0.005;
    d.true_outliers += is_outlier;
    found += flagged[i] != 0;
    right += flagged[i] != 0 && is_outlier;
    if(!flagged[i]) {
      d.kept_error += 100 * distance;
      ++kept;
    }
  }
  d.kept_error /= double((std::max)(kept, std::size_t(1)));
  d.precision = found > 0 ? double(right) / double(found) : 1;
  d.recall = d.true_outliers > 0 ? double(right) / double(d.true_outliers) : 1;
  return d;
}

/// `percent` of the points are noise: coordinates of near ones are shifted by up to 2 %, far ones are anywhere in a
/// box of 1.5 times the size.
core::Iterative_input with_noise_points(const Triangle_mesh& mesh, double percent, bool far,
                                        std::uint64_t seed)
{
  constexpr std::size_t n = 30000;
  core::Iterative_input input;
  const std::size_t noise = std::size_t(n * percent / 100);
  input.points = sample(mesh, n, seed).points;
  Random_numbers random(seed + 1000);
  const core::Bounding_box box = core::bounding_box(input.points);
  for(std::size_t i = 0; i < noise; ++i) {
    Vec3& p = input.points[i];
    if(far)
      for(int k = 0; k < 3; ++k)
        p[k] = box.lower[k] + box.sides()[k] * (0.5 + 1.5 * (random.uniform() - 0.5));
    else
      for(int k = 0; k < 3; ++k)
        p[k] += 0.02 * random.uniform(-1, 1);
  }
  return input;
}

void study_outliers(const Settings& settings)
{
  const Triangle_mesh mesh = model_mesh(settings, "armadillo");
  const Mesh_tree tree(mesh);
  std::printf("\nOutliers of the armadillo, 30k points, m = n/20: outliers are farther than 0.5 %% from it\n"
              "%-6s %6s %6s %8s %10s %8s %10s | %18s\n",
              "", "noise", "seed", "true", "precision", "recall", "kept err.", "printed: prec. rec.");
  for(const bool far : {false, true})
    for(const double percent : {0., 5., 10., 15., 20.})
      for(std::size_t seed = 1; seed <= settings.seeds; ++seed) {
        const core::Iterative_input input = with_noise_points(mesh, percent, far, seed);
        core::Iterative_parameters parameters;
        parameters.particle_fraction = 0.05;
        parameters.iterations = 0;
        const Detection d = detect(input, run(input, parameters).result.is_outlier, tree);
        core::Iterative_parameters printed = core::Iterative_parameters::printed();
        printed.particle_fraction = 0.05;
        printed.iterations = 0;
        const Detection p = detect(input, run(input, printed).result.is_outlier, tree);
        std::printf("%-6s %5.0f%% %6zu %8zu %10.4f %8.3f %10.4f | %10.3f %7.3f\n", far ? "far" : "near",
                    percent, seed, d.true_outliers, d.precision, d.recall, d.kept_error, p.precision,
                    p.recall);
        std::fflush(stdout);
      }
}

// ---- holes --------------------------------------------------------------------------------------

struct Scan_with_holes {
  core::Iterative_input input;
  std::vector<Vec3> missing;     ///< evenly spread samples of the holes
  double missing_share = 0;
};

/// Samples outside of balls; `radius` is chosen so that `share` of the area is missing.
Scan_with_holes cut_balls(const Triangle_mesh& mesh, const std::vector<Vec3>& centres, double share,
                          std::size_t n, std::uint64_t seed)
{
  const Samples truth = sample(mesh, 200000, 77);
  std::vector<double> distance;
  const auto to_centres = [&](const Vec3& p) {
    double d = (std::numeric_limits<double>::max)();
    for(const Vec3& c : centres)
      d = (std::min)(d, (p - c).norm());
    return d;
  };
  for(const Vec3& p : truth.points)
    distance.push_back(to_centres(p));
  std::vector<double> sorted = distance;
  std::sort(sorted.begin(), sorted.end());
  const double radius = sorted[std::size_t(share * double(sorted.size()))];
  Scan_with_holes scan;
  for(std::size_t i = 0; i < truth.points.size(); ++i)
    if(distance[i] < radius)
      scan.missing.push_back(truth.points[i]);
  scan.missing_share = double(scan.missing.size()) / double(truth.points.size());
  const Samples samples = sample(mesh, std::size_t(double(n) / (1 - share)), seed);
  for(std::size_t i = 0; i < samples.points.size(); ++i)
    if(to_centres(samples.points[i]) >= radius) {
      scan.input.points.push_back(samples.points[i]);
      scan.input.normals.push_back(samples.normals[i]);
    }
  scan.input.normals_are_hints = true;
  return scan;
}

/// Share of the missing part with a point within `limit`.
double coverage(const Scan_with_holes& scan, const Point_cloud& cloud, double limit)
{
  const Point_tree tree(cloud.points);
  std::size_t covered = 0;
  for(const Vec3& p : scan.missing)
    covered += tree.nearest(p).distance < limit;
  return double(covered) / double(scan.missing.size());
}

void print_holes_header(const std::string& title)
{
  std::printf("\n%s\n%-26s %5s %7s %6s %7s %7s %7s %7s %8s %8s %8s %8s\n", title.c_str(), "", "seed",
              "points", "new", "<1%", "<1.5%", "new err", "95%", "mesh", "rms", "max", "reverse");
}

void print_holes_row(const std::string& name, std::uint64_t seed, const Scan_with_holes& scan,
                     const Point_cloud& cloud, std::size_t added, const Mesh_tree& tree,
                     const Judge& judge, Triangle_mesh* kept_mesh = nullptr)
{
  std::vector<double> errors;
  for(std::size_t i = cloud.points.size() - added; i < cloud.points.size(); ++i)
    errors.push_back(100 * (tree.closest(cloud.points[i]).point - cloud.points[i]).norm());
  const Distance_statistics e = distance_statistics(errors);
  const Triangle_mesh mesh = mesh_of(cloud.points, cloud.normals);
  const Mesh_verdict verdict = judge.mesh(mesh);
  std::printf("%-26s %5zu %7zu %6zu %7.3f %7.3f %7.3f %7.3f %8.4f %8.4f %8.3f %8.4f\n", name.c_str(),
              std::size_t(seed), cloud.points.size(), added, coverage(scan, cloud, 0.01),
              coverage(scan, cloud, 0.015), e.mean, e.percentile_95, verdict.forward.mean,
              verdict.forward.rms, verdict.forward.max, verdict.reverse.mean);
  std::fflush(stdout);
  if(kept_mesh != nullptr)
    *kept_mesh = mesh;
}

struct Variant {
  std::string name;
  core::Iterative_parameters parameters;
};

void study_holes(const Settings& settings, const std::string& title, const Triangle_mesh& mesh,
                 const std::function<std::vector<Vec3>(std::uint64_t)>& centres, double share,
                 std::size_t n, const std::vector<Variant>& variants, const Vec3& view)
{
  const Mesh_tree tree(mesh);
  const Judge judge(mesh);
  print_holes_header(title);
  for(std::size_t seed = 1; seed <= settings.seeds; ++seed) {
    const Scan_with_holes scan = cut_balls(mesh, centres(seed), share, n, seed);
    Point_cloud before;
    before.points = scan.input.points;
    std::vector<support::Panel> panels;
    const auto show = [&](const std::string& name, const Point_cloud& cloud, const Triangle_mesh& m) {
      support::Panel points, surface;
      points.title = name + ", points";
      points.cloud = cloud;
      surface.title = name + ", mesh";
      surface.mesh = m;
      panels.push_back(points);
      panels.push_back(surface);
    };
    for(const Variant& variant : variants) {
      const Run r = run(scan.input, variant.parameters);
      const Point_cloud cloud = result_cloud(scan.input, r.result);
      Triangle_mesh result_mesh;
      if(&variant == &variants.front()) {
        before.normals = r.result.normals;
        before.confidence.assign(before.points.size(), 1.);
        print_holes_row("before", seed, scan, before, 0, tree, judge, &result_mesh);
        show("before", before, result_mesh);
      }
      print_holes_row(variant.name, seed, scan, cloud, r.result.new_points.size(), tree, judge,
                      &result_mesh);
      show(variant.name, cloud, result_mesh);
    }
    if(!settings.pictures.empty() && seed == 1)
      support::write_panels(settings.pictures + "/" + title.substr(0, title.find(' ')) + ".png", panels,
                            view, Vec3::UnitY(), 420, 4);
  }
}

std::vector<Variant> hole_variants()
{
  std::vector<Variant> variants(1, Variant{"default", {}});
  variants.push_back({"without repulsion", {}});
  variants.back().parameters.repulsion.steps = 0;
  variants.push_back({"without guards", {}});
  variants.back().parameters.guard.enabled = false;
  variants.push_back({"printed values", core::Iterative_parameters::printed()});
  return variants;
}

void study_ellipsoid(const Settings& settings)
{
  const Triangle_mesh mesh = ellipsoid_mesh();
  const double unit = bounding_box_diagonal(
    {Vec3(-1, -0.7, -0.5), Vec3(1, 0.7, 0.5)});
  study_holes(settings, "ellipsoid without a cap, 12.7 % of its area, 25k points; coverage and errors in %",
              mesh, [&](std::uint64_t) { return std::vector<Vec3>{Vec3(0, 0, 0.5 / unit)}; }, 0.127, 25000, hole_variants(), Vec3(-0.3, 0.5, -1));
}

/// Six random places, 15 % of the diagonal apart, other ones for each seed.
std::vector<Vec3> hole_centres(const Triangle_mesh& mesh, std::uint64_t seed)
{
  std::vector<Vec3> centres;
  for(const Vec3& p : sample(mesh, 1000, 100 + seed).points) {
    const bool is_apart = std::all_of(centres.begin(), centres.end(),
                                      [&](const Vec3& c) { return (c - p).norm() > 0.15; });
    if(is_apart && centres.size() < 6)
      centres.push_back(p);
  }
  return centres;
}

void study_bunny(const Settings& settings)
{
  const Triangle_mesh mesh = model_mesh(settings, "bunny00");
  study_holes(settings, "bunny with six holes, 4.9 % of its area, 25k points; coverage and errors in %", mesh,
              [&](std::uint64_t seed) { return hole_centres(mesh, seed); }, 0.049, 25000,
              hole_variants(), Vec3(-0.45, -0.3, -1));
}

// ---- scans --------------------------------------------------------------------------------------

core::Iterative_input to_input(const Scan& scan)
{
  core::Iterative_input input;
  input.points = scan.cloud.points;
  input.directions.towards_scanner = scan.cloud.directions;
  input.directions.view.assign(scan.cloud.views.begin(), scan.cloud.views.end());
  return input;
}

void study_body(const Settings& settings)
{
  std::printf("\nfront and back scan of a body, 170k points, m = n/20: distance truth to mesh, %%\n"
              "%-28s %8s %7s %8s %8s %8s %8s %8s\n",
              "", "points", "new", "mean", "unseen", "reverse", "cpu [s]", "wall [s]");
  const Triangle_mesh mesh = model_mesh(settings, "man");
  Scanner_options options;
  options.directions = {Vec3(0, 0.1, 1), Vec3(0, 0.1, -1)};
  options.points = 170346;
  const Scan scan = scan_mesh(mesh, options);
  const Judge judge(mesh, truth_cloud(scan));
  const core::Iterative_input input = to_input(scan);
  std::vector<support::Panel> panels;
  const auto row = [&](const std::string& name, const Point_cloud& cloud, std::size_t added, const Run& r) {
    const Triangle_mesh result = mesh_of(cloud.points, cloud.normals);
    const Mesh_verdict verdict = judge.mesh(result);
    std::printf("%-28s %8zu %7zu %8.4f %8.4f %8.4f %8.2f %8.2f\n", name.c_str(), cloud.points.size(),
                added, verdict.forward.mean, verdict.unseen.mean, verdict.reverse.mean, r.cpu_seconds,
                r.seconds);
    std::fflush(stdout);
    support::Panel points, surface;
    points.title = name;
    points.cloud = cloud;
    surface.title = name + ", mesh";
    surface.mesh = result;
    panels.push_back(points);
    panels.push_back(surface);
  };
  for(const bool guards : {true, false})
    for(const bool two_phases : {false, true}) {
      core::Iterative_parameters parameters;
      parameters.particle_fraction = 0.05;
      parameters.two_phases = two_phases;
      parameters.guard.enabled = guards;
      const Run r = run(input, parameters, settings.parallel);
      if(guards && !two_phases) {
        Point_cloud before;
        before.points = input.points;
        before.normals = r.result.normals;
        before.confidence.assign(before.points.size(), 1.);
        row("before", before, 0, Run());
      }
      row(std::string(two_phases ? "two phases" : "one phase") + (guards ? "" : ", no guards"),
          result_cloud(input, r.result), r.result.new_points.size(), r);
    }
  if(!settings.pictures.empty())
    support::write_panels(settings.pictures + "/body.png", panels, Vec3(-1, -0.1, -0.3), Vec3::UnitY(),
                          420, 4);
}

/// The border of a half sphere: without a static region its sheet grows on.
void study_static(const Settings& settings)
{
  std::printf("\nellipsoid without its upper half, borders not taken back: new points with and without a "
              "static region\n%-28s %8s %14s %14s\n",
              "", "new", "beyond border", "in hole");
  const Triangle_mesh mesh = ellipsoid_mesh();
  core::Iterative_input input;
  const Samples samples = sample(mesh, 30000, 1);
  const double top = 0.12;  // the border
  const Vec3 hole(0, 0, -0.5 / bounding_box_diagonal({Vec3(-1, -0.7, -0.5), Vec3(1, 0.7, 0.5)}));
  constexpr double hole_radius = 0.1;
  for(const Vec3& p : samples.points)
    if(p.z() < top && (p - hole).norm() > hole_radius)
      input.points.push_back(p);
  core::Iterative_parameters parameters;
  parameters.takes_back_open_borders = false;
  parameters.guard.enabled = false;
  for(const bool is_static : {false, true}) {
    input.is_constrained.clear();
    if(is_static)
      for(const Vec3& p : input.points)
        input.is_constrained.push_back(p.z() > 0);
    const Run r = run(input, parameters);
    std::size_t beyond = 0, inside = 0;
    for(const Vec3& p : r.result.new_points) {
      beyond += p.z() > top;
      inside += (p - hole).norm() < hole_radius;
    }
    std::printf("%-28s %8zu %14zu %14zu\n", is_static ? "upper part static" : "none static",
                r.result.new_points.size(), beyond, inside);
    if(!settings.pictures.empty()) {
      support::Panel panel;
      panel.title = is_static ? "upper part static" : "none static";
      panel.cloud = result_cloud(input, r.result);
      support::write_panels(settings.pictures + (is_static ? "/static.png" : "/not_static.png"), {panel},
                            Vec3(-0.3, 0.7, -1), Vec3::UnitZ(), 420);
    }
  }
}

// ---- time ---------------------------------------------------------------------------------------

void study_loops(const Settings& settings)
{
  const Triangle_mesh mesh = ellipsoid_mesh();
  const Mesh_tree tree(mesh);
  const Judge judge(mesh);
  const double unit = bounding_box_diagonal({Vec3(-1, -0.7, -0.5), Vec3(1, 0.7, 0.5)});
  const Scan_with_holes scan = cut_balls(mesh, {Vec3(0, 0, 0.5 / unit)}, 0.127, 100000, 1);
  print_holes_header("adaptive against plain loop: ellipsoid without a cap, 100k points");
  std::vector<std::string> lines;
  for(const bool adaptive : {true, false}) {
    core::Iterative_parameters parameters;
    parameters.adaptive = adaptive;
    const Run r = run(scan.input, parameters, settings.parallel);
    print_holes_row(adaptive ? "adaptive" : "plain", 1, scan, result_cloud(scan.input, r.result),
                    r.result.new_points.size(), tree, judge);
    double iterations = 0;
    for(const core::Stage_time& stage : r.times)
      iterations += stage.name == "iteration" ? stage.seconds : 0;
    char line[200];
    std::snprintf(line, sizeof line, "%-9s %zu iterations: %.2f s of %.2f s in all\n",
                  adaptive ? "adaptive" : "plain", r.result.new_counts.size(), iterations, r.seconds);
    lines.push_back(line);
  }
  for(const std::string& line : lines)
    std::printf("%s", line.c_str());
}

/// Sizes and numbers of particles are those of the paper, shapes are similar.
void study_table(const Settings& settings)
{
  struct Row {
    const char *paper, *model;
    std::size_t points, particles;
    bool two_phases;
    double paper_seconds;
  };
  const Row rows[] = {{"Inukshuk", "armadillo", 205858, 10293, false, 193},
                      {"Hand", "hand", 194457, 38892, false, 679},
                      {"Lady", "homer", 175514, 35103, false, 266},
                      {"Body", "man", 170346, 8518, true, 911},
                      {"Seal", "bunny00", 889076, 44454, false, 419}};
  std::printf("\ntable I: three views, %s\n%-9s %-10s %8s %9s %5s %8s %9s %9s %9s %9s\n",
              settings.parallel ? "all cores" : "one core", "paper", "model", "points", "particles",
              "iter.", "new", "wall [s]", "cpu [s]", "us/point", "paper [s]");
  for(const Row& row : rows) {
    Scanner_options options;
    options.views = 3;
    options.points = row.points;
    const core::Iterative_input input = to_input(scan_mesh(model_mesh(settings, row.model), options));
    core::Iterative_parameters parameters;
    parameters.particle_fraction = double(row.particles) / double(row.points);
    parameters.two_phases = row.two_phases;
    const Run r = run(input, parameters, settings.parallel);
    std::printf("%-9s %-10s %8zu %9zu %5zu %8zu %9.2f %9.2f %9.1f %9.0f\n", row.paper, row.model,
                input.points.size(), row.particles, r.result.new_counts.size(), r.result.new_points.size(),
                r.seconds, r.cpu_seconds, 1e6 * r.cpu_seconds / double(input.points.size()),
                row.paper_seconds);
    for(const core::Stage_time& stage : r.times)
      std::printf("          %-14s %8.2f s\n", stage.name.c_str(), stage.seconds);
    std::fflush(stdout);
  }
}

void study(const Arguments& arguments)
{
  Settings settings;
  settings.data = data_folder(arguments.text("--data"));
  settings.pictures = arguments.text("--pictures");
  settings.seeds = arguments.count("--seeds", 1);
  settings.parallel = arguments.count("--threads", 1) > 1;
  for(const std::string& part :
      arguments.list("--parts", {"apss", "outliers", "ellipsoid", "bunny", "body", "static", "loops",
                                 "table"})) {
    if(part == "apss")
      study_apss(settings);
    else if(part == "outliers")
      study_outliers(settings);
    else if(part == "ellipsoid")
      study_ellipsoid(settings);
    else if(part == "bunny")
      study_bunny(settings);
    else if(part == "body")
      study_body(settings);
    else if(part == "static")
      study_static(settings);
    else if(part == "loops")
      study_loops(settings);
    else if(part == "table")
      study_table(settings);
    else
      throw Usage_error("unknown part '" + part + "'");
  }
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program("iterative_study", usage, argc, argv,
                                {"--data", "--parts", "--seeds", "--threads", "--pictures"},
                                {}, study);
}
