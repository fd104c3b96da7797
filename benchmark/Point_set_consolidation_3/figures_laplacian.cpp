// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of the paper on skeletons by Laplacian contraction. CGAL's models and synthetic shapes stand in for its
// models.

#include "methods.h"
#include "models.h"
#include "paper_figure.h"
#include "point_tree.h"
#include "skeleton_runs.h"

#include <chrono>
#include <cmath>
#include <map>

namespace benchmark {

namespace {

using synthetic::Shape;

/// Points of complete models: the paper uses up to 10k.
constexpr std::size_t model_points = 5000;

const std::vector<std::string> skeleton_columns = {"genus", "cycles", "components", "tips",
                                                   "iterations", "inside", "seconds"};

Figure_table::Row skeleton_row(const std::string& name, double genus, const Skeleton_run& run, const Judge& judge)
{
  return {name,
          {genus, double(run.cycles), double(run.components), double(run.tips), double(run.iterations),
           judge.skeleton(run.graph).inside, run.seconds}};
}

Point_cloud as_cloud(const std::vector<Vec3>& points)
{
  Point_cloud cloud;
  cloud.points = points;
  return cloud;
}

/// Small points, so that the skeleton shows.
support::Panel skeleton_panel(const std::string& title, const Skeleton_run& run, const std::vector<Vec3>& points)
{
  support::Panel panel = graph_panel(title, run.graph, as_cloud(points));
  panel.point_radius = 0.0012;
  panel.segment_radius = 0.006;
  return panel;
}

/// A skeleton for each variant of the options, on each model.
Figure_result variants_figure(const std::string& data, const std::vector<std::string>& models,
                              const std::vector<std::pair<std::string, Skeleton_options>>& variants)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const std::string& model : models) {
    const Triangle_mesh truth = figure_model(data, model);
    const Judge judge(truth);
    const std::vector<Vec3> points = even_samples(truth, model_points);
    Figure_table table{model, skeleton_columns, {}};
    for(const auto& variant : variants) {
      const Skeleton_run run = laplacian_skeleton(points, {}, variant.second);
      table.rows.push_back(skeleton_row(variant.first, topology_of(truth).genus, run, judge));
      figure.panels.push_back(skeleton_panel(model + ", " + variant.first, run, points));
    }
    figure.tables.push_back(table);
  }
  figure.columns = variants.size();
  return figure;
}

Figure_result topology(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  Figure_table table{"cycles of the skeleton against the genus", skeleton_columns, {}};
  for(const char* model : {"armadillo", "refined_elephant", "knot1", "eight", "dino", "homer", "cow", "bear", "hand",
                           "bunny00", "cactus", "triceratops"}) {
    const Triangle_mesh truth = figure_model(data, model);
    const std::vector<Vec3> points = even_samples(truth, model_points);
    const Skeleton_run run = laplacian_skeleton(points, {});
    table.rows.push_back(skeleton_row(model, topology_of(truth).genus, run, Judge(truth)));
    figure.panels.push_back(skeleton_panel(model, run, points));
  }
  figure.tables.push_back(table);
  figure.columns = 6;
  return figure;
}

Figure_result figure_3(const std::string& data)
{
  Skeleton_options mean_value, combinatorial;
  mean_value.weights = Laplacian_weight::mean_value;
  combinatorial.weights = Laplacian_weight::combinatorial;
  return variants_figure(data, {"armadillo", "eight"},
                         {{"cotangent", {}}, {"mean value", mean_value}, {"combinatorial", combinatorial}});
}

Figure_result figure_4(const std::string& data)
{
  std::vector<std::pair<std::string, Skeleton_options>> variants;
  for(const double w : {0.1, 0.5, 2.0, 10.0}) {
    Skeleton_options options;
    options.contraction_weight = w;
    variants.emplace_back("W_L^0 x " + std::to_string(w).substr(0, 4), options);
  }
  for(const double w : {0.1, 0.5, 1.0, 10.0}) {
    Skeleton_options options;
    options.attraction_weight = w;
    variants.emplace_back("W_H^0 = " + std::to_string(w).substr(0, 4), options);
  }
  Figure_result figure = variants_figure(data, {"refined_elephant"}, variants);
  figure.columns = 4;
  return figure;
}

Figure_result figure_8(const std::string& data)
{
  Figure_result figure;
  const Triangle_mesh truth = figure_model(data, "armadillo");
  const Judge judge(truth);
  const double genus = topology_of(truth).genus;
  Figure_table table{"armadillo", skeleton_columns, {}};
  const auto add = [&](const std::string& name, const std::vector<Vec3>& points) {
    const Skeleton_run run = laplacian_skeleton(points, {});
    table.rows.push_back(skeleton_row(name, genus, run, judge));
    figure.panels.push_back(skeleton_panel(name, run, points));
  };
  const std::vector<Vec3> even = even_samples(truth, 10000);
  add("10000 even points", even);
  add("5000 even points", even_samples(truth, 5000));
  add("2500 even points", even_samples(truth, 2500));
  std::vector<Vec3> uneven;  // the upper half four times as dense as the lower
  for(std::size_t i = 0; i < even.size(); ++i)
    if(even[i].y() > 0 || i % 4 == 0)
      uneven.push_back(even[i]);
  add("uneven points", uneven);
  figure.tables.push_back(table);
  return figure;
}

Figure_result figure_9(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"dino", "armadillo"}) {
    const Triangle_mesh truth = figure_model(data, model);
    const Judge judge(truth);
    Figure_table table{std::string(model) + ", five views", skeleton_columns, {}};
    for(const double shift : {0.0, 0.5, 1.0, 1.5, 2.0}) {
      Scanner_options options;
      options.directions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
      options.points = 2 * model_points;
      options.misalignment = shift;
      const std::vector<Vec3> points = scan_mesh(truth, options).cloud.points;
      const Skeleton_run run = laplacian_skeleton(points, {});
      const std::string name = "misaligned by " + std::to_string(shift).substr(0, 3) + " %";
      table.rows.push_back(skeleton_row(name, topology_of(truth).genus, run, judge));
      figure.panels.push_back(skeleton_panel(std::string(model) + ", " + name, run, points));
    }
    figure.tables.push_back(table);
  }
  figure.columns = 5;
  return figure;
}

Figure_result figure_10(const std::string& data)
{
  Skeleton_options slow;
  slow.contraction_factor = 2;
  return variants_figure(data, {"knot1", "eight", "elk"}, {{"s_L = 3", {}}, {"s_L = 2", slow}});
}

/// A closed tube with round ends, and the same without its middle.
struct Tube {
  Shape shape = synthetic::capsule(Vec3(0, 0, -1.35), Vec3(0, 0, 1.35), 0.4);
  double gap = 0.8;
  std::vector<Vec3> points, normals;
  support::Segment_graph axis;

  Tube()
  {
    for(const Vec3& p : synthetic::samples(shape, 8000, 1))
      if(std::abs(p.z()) > gap / 2) {
        points.push_back(p);
        normals.push_back(shape.normal(p));
      }
    for(std::size_t v = 0; v < 28; ++v) {
      axis.vertices.emplace_back(0, 0, -1.35 + 0.1 * double(v));
      axis.radius.push_back(0.4);
      if(v > 0)
        axis.edges.push_back({v - 1, v});
    }
  }
};

/// Distance of the vertices from the complete shape: mean, and largest.
std::vector<double> vertex_errors(const Shape& shape, const Triangle_mesh& mesh)
{
  double sum = 0, largest = 0;
  for(const Vec3& v : mesh.vertices) {
    const double e = 100 * std::abs(shape.distance(v)) / shape.diagonal();
    sum += e;
    largest = (std::max)(largest, e);
  }
  return {sum / double(mesh.vertices.size()), largest};
}

Figure_result figure_11(const std::string&)
{
  const Tube tube;
  Figure_result figure;
  figure.view = Vec3(-1, 0.3, -0.2);
  figure.up = Vec3::UnitZ();
  Figure_table table{"tube without its middle; its axis; percent of the diagonal",
                     {"vertices", "mean", "largest", "components", "seconds"}, {}};
  figure.panels.push_back(cloud_panel("points", as_cloud(tube.points)));
  const auto add = [&](const std::string& name, bool is_shown, const auto& make) {
    const auto begin = std::chrono::steady_clock::now();
    const Triangle_mesh mesh = make();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::vector<double> errors = vertex_errors(tube.shape, mesh);
    table.rows.push_back({name,
                          {double(mesh.vertices.size()), errors[0], errors[1], double(topology_of(mesh).components),
                           seconds}});
    if(is_shown)
      figure.panels.push_back(mesh_panel(name, mesh));
  };
  add("Poisson", true, [&] {
    const double unit = tube.shape.diagonal();  // the settings are for a unit diagonal
    Point_cloud cloud;
    for(const Vec3& p : tube.points)
      cloud.points.push_back(p / unit);
    cloud.normals = tube.normals;
    Triangle_mesh mesh = poisson(cloud);
    for(Vec3& v : mesh.vertices)
      v *= unit;
    return mesh;
  });
  for(const std::size_t resolution : {32, 64, 128, 256}) {
    Field_options options;
    options.resolution = resolution;
    add("octree " + std::to_string(resolution), resolution == 64,
        [&] { return skeleton_driven_mesh(tube.points, tube.axis, options); });
  }
  for(const std::size_t resolution : {32, 48, 64}) {
    Field_options options;
    options.resolution = resolution;
    options.adaptive = false;
    add("regular grid " + std::to_string(resolution), false,
        [&] { return skeleton_driven_mesh(tube.points, tube.axis, options); });
  }
  Field_options smooth;
  smooth.surface_weight = 5;
  add("octree 64, omega_2 = 5 as printed", true,
      [&] { return skeleton_driven_mesh(tube.points, tube.axis, smooth); });
  figure.tables.push_back(table);
  return figure;
}

/// A ring of which two parts were not scanned.
Figure_result figure_14(const std::string&)
{
  const Shape ring = synthetic::torus(1, 0.25);
  Point_cloud cloud;
  for(const Vec3& p : synthetic::samples(ring, 8000, 1))
    if(std::abs(p.y()) > 0.3 * std::hypot(p.x(), p.y())) {
      cloud.points.push_back(p / ring.diagonal());
      cloud.normals.push_back(ring.normal(p));
    }
  const Triangle_mesh truth = normalized(shape_mesh(ring, 120));
  const Judge judge(truth, cloud);
  Figure_result figure;
  figure.view = Vec3(-0.2, 0.3, -1);
  Figure_table table{"ring with two gaps", mesh_columns(), {}};
  Figure_table skeletons{"skeleton", {"components", "cycles", "tips", "edits"}, {}};
  const auto add = [&](const std::string& name, const Triangle_mesh& mesh) {
    table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
    figure.panels.push_back(mesh_panel(name, mesh));
  };
  figure.panels.push_back(cloud_panel("points", cloud));
  add("Poisson", poisson(cloud));
  const Skeleton_run extracted = laplacian_skeleton(cloud.points, cloud.normals);
  figure.panels.push_back(skeleton_panel("(a) extracted", extracted, cloud.points));
  skeletons.rows.push_back({"extracted",
                            {double(extracted.components), double(extracted.cycles), double(extracted.tips), 0}});
  // tips at the rims whose radius is small lie off the axis; then both halves are joined over a point of the circle
  std::vector<std::size_t> degree(extracted.graph.vertices.size(), 0);
  for(const auto& edge : extracted.graph.edges)
    for(const std::size_t v : edge)
      ++degree[v];
  std::vector<std::size_t> tips[2];
  for(std::size_t v = 0; v < degree.size(); ++v)
    if(degree[v] == 1)
      tips[extracted.graph.vertices[v].x() < 0].push_back(v);
  std::size_t added = extracted.graph.vertices.size(), edits = 0;
  std::string text;
  for(int side = 0; side < 2; ++side) {
    if(tips[side].size() < 2)
      continue;
    // the outermost tip on either side of the gap
    std::size_t ends[2] = {tips[side][0], tips[side][0]};
    for(const std::size_t v : tips[side]) {
      const double y = extracted.graph.vertices[v].y();
      if(y > extracted.graph.vertices[ends[0]].y())
        ends[0] = v;
      if(y < extracted.graph.vertices[ends[1]].y())
        ends[1] = v;
    }
    const double x = (side == 0 ? 1 : -1) / ring.diagonal();
    text += "add " + std::to_string(x) + " 0 0\n";
    for(const std::size_t v : ends)
      text += "connect " + std::to_string(v) + " " + std::to_string(added) + "\n";
    text += "radius " + std::to_string(added) + " " + std::to_string(0.25 / ring.diagonal()) + "\n";
    edits += 4;
    ++added;
  }
  const Skeleton_run repaired = edited(extracted, text);
  figure.panels.push_back(skeleton_panel("(b) edited", repaired, cloud.points));
  skeletons.rows.push_back({"edited",
                            {double(repaired.components), double(repaired.cycles), double(repaired.tips),
                             double(edits)}});
  add("driven by (a)", skeleton_driven_mesh(cloud.points, extracted.graph));
  add("driven by (b)", skeleton_driven_mesh(cloud.points, repaired.graph));
  figure.tables = {table, skeletons};
  figure.columns = 3;
  return figure;
}

Figure_result figure_1(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"dino", "homer"}) {
    const Triangle_mesh truth = figure_model(data, model);
    Scanner_options options;
    options.views = 3;
    options.points = 15000;
    const Scan scan = scan_mesh(truth, options);
    const Judge judge(truth, truth_cloud(scan));
    Figure_table table{std::string(model) + ", three views", mesh_columns(), {}};
    const Method_result direct = method_called("direct").run(scan.cloud);
    const Skeleton_run skeleton = laplacian_skeleton(direct.points, direct.normals);
    figure.panels.push_back(cloud_panel("scan", scan.cloud));
    figure.panels.push_back(skeleton_panel("skeleton", skeleton, scan.cloud.points));
    const auto add = [&](const std::string& name, const Triangle_mesh& mesh) {
      table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
      figure.panels.push_back(mesh_panel(name, mesh));
    };
    Point_cloud oriented;
    oriented.points = direct.points;
    oriented.normals = direct.normals;
    add("Poisson", poisson(oriented));
    Field_options field;
    field.resolution = 128;
    add("skeleton-driven", skeleton_driven_mesh(direct.points, skeleton.graph, field));
    figure.tables.push_back(table);
  }
  figure.columns = 4;
  return figure;
}

Figure_result times(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "armadillo");
  Figure_result figure;
  Figure_table table{
      "armadillo; the paper: under 120 s at 10k points, in MATLAB", {"seconds", "iterations", "cycles"}, {}};
  support::Series series{"this package", {}, {}, support::Series::Shape::marked_line};
  for(const std::size_t n : {2500, 5000, 10000, 20000, 30000}) {
    const Skeleton_run run = laplacian_skeleton(even_samples(truth, n), {});
    table.rows.push_back({std::to_string(n) + " points", {run.seconds, double(run.iterations), double(run.cycles)}});
    series.x.push_back(double(n));
    series.y.push_back(run.seconds);
  }
  support::Plot plot;
  plot.title = "Time of the skeleton";
  plot.x_label = "points";
  plot.y_label = "seconds";
  plot.log_x = plot.log_y = true;
  plot.series = {series};
  figure.tables.push_back(table);
  figure.plots.push_back(plot);
  return figure;
}

/// The same numbers for each kind of skeleton, and their summary.
struct Kinds_table {
  Figure_table rows{
      "", {"genus", "cycles", "components", "tips", "inside", "coverage", "to medial axis", "seconds"}, {}};
  struct Sum {
    double right = 0, false_cycles = 0, components = 0, tips = 0, inside = 0, coverage = 0, distance = 0, seconds = 0;
    double count = 0;
  };
  std::map<std::string, Sum> sums;

  void add(const std::string& kind, const std::string& model, double genus, double tips, const Skeleton_run& run,
           const Judge& judge)
  {
    const Skeleton_verdict v = judge.skeleton(run.graph);
    rows.rows.push_back({model + ", " + kind,
                         {genus, double(run.cycles), double(run.components), double(run.tips), v.inside, v.coverage,
                          v.to_medial_axis.mean, run.seconds}});
    Sum& sum = sums[kind];
    sum.count += 1;
    sum.right += double(run.cycles) == genus && run.components == 1;
    sum.false_cycles += std::abs(double(run.cycles) - genus);
    sum.components += double(run.components) - 1;
    sum.tips += std::abs(double(run.tips) - tips);
    sum.inside += v.inside;
    sum.coverage += v.coverage;
    sum.distance += v.to_medial_axis.mean;
    sum.seconds += run.seconds;
  }
};

/// The three kinds of skeletons of scans from one to three sides.
Figure_result kinds(const std::string& data)
{
  std::vector<std::pair<std::string, Triangle_mesh>> truths;
  for(const char* model : {"armadillo", "dino", "cow", "man", "refined_elephant", "knot1", "eight"})
    truths.emplace_back(model, figure_model(data, model));
  for(const auto& [name, parts] : assembled_shapes())
    if(name != "dumbbell")
      truths.emplace_back(name, normalized(shape_mesh(synthetic::united(parts), 120)));
  Figure_result figure;
  Figure_table summary{"means over the models; tips: difference from the complete model's",
                       {"right topology", "of", "cycles off", "components too many", "tips off", "inside", "coverage",
                        "to medial axis", "seconds"}, {}};
  for(const std::size_t views : {1, 2, 3}) {
    Kinds_table table;
    table.rows.title = std::to_string(views) + (views == 1 ? " view" : " views");
    for(const auto& [name, truth] : truths) {
      Scanner_options options;
      options.views = views;
      options.points = 15000;
      const Scan scan = scan_mesh(truth, options);
      const Judge judge(truth, truth_cloud(scan));
      const double genus = topology_of(truth).genus;
      const double tips = double(laplacian_skeleton(even_samples(truth, model_points), {}).tips);
      const Method_result direct = method_called("direct").run(scan.cloud);
      const Meso_runs meso = meso_skeletons(scan.cloud);
      const std::vector<std::pair<std::string, Skeleton_run>> runs = {
        {"laplacian", laplacian_skeleton(scan.cloud.points, {})},
        {"laplacian with normals", laplacian_skeleton(direct.points, direct.normals)},
        {"l1-medial", l1_medial_skeleton(scan.cloud.points)},
        {"meso", meso.sheets},
        {"meso, curves only", meso.curves}};
      for(const auto& [kind, run] : runs) {
        table.add(kind, name, genus, tips, run, judge);
        if(name == "armadillo" && kind != "laplacian with normals") {
          support::Panel panel = skeleton_panel(kind + ", " + table.rows.title, run, scan.cloud.points);
          panel.mesh = {run.graph.vertices, run.triangles};
          figure.panels.push_back(panel);
        }
      }
    }
    for(const auto& [kind, sum] : table.sums)
      summary.rows.push_back({kind + ", " + table.rows.title,
                              {sum.right, sum.count, sum.false_cycles / sum.count, sum.components / sum.count,
                               sum.tips / sum.count, sum.inside / sum.count, sum.coverage / sum.count,
                               sum.distance / sum.count, sum.seconds / sum.count}});
    figure.tables.push_back(table.rows);
  }
  figure.tables.push_back(summary);
  figure.columns = 4;
  return figure;
}

}  // namespace

std::vector<Paper_figure> laplacian_figures()
{
  return {
    {"laplacian_topology", "section IV: skeletons have the topology of complete models", topology},
    {"laplacian_figure_1", "skeleton of a raw scan and the surface that it drives", figure_1},
    {"laplacian_figure_3", "cotangent, mean value and combinatorial weights", figure_3},
    {"laplacian_figure_4", "initial weights of contraction and attraction", figure_4},
    {"laplacian_figure_8", "sampling density", figure_8},
    {"laplacian_figure_9", "five views, misaligned", figure_9},
    {"laplacian_figure_10", "contraction factor s_L of 3 and 2", figure_10},
    {"laplacian_figure_11", "figures 11 to 13: the gap of a tube, closed along its axis; octree domain", figure_11},
    {"laplacian_figure_14", "figures 13 and 14: a skeleton is repaired by edits and drives the surface", figure_14},
    {"laplacian_kinds", "Laplacian, L1-medial and meso-skeletons of one to three views", kinds},
    {"laplacian_times", "section IV: time at 10k points", times},
  };
}

}  // namespace benchmark
