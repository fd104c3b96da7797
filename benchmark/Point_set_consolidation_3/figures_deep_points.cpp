// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of the deep points paper. Its scans are not public: virtual scans of CGAL's models and of synthetic shapes
// stand in for them.

#include "consolidation.h"
#include "mesh_tree.h"
#include "methods.h"
#include "paper_classes.h"
#include "paper_figure.h"
#include "point_tree.h"
#include "skeleton_runs.h"

#include <CGAL/Point_set_consolidation_3/internal/meso_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/sinking.h>

#include <cmath>
#include <tuple>

namespace benchmark {

namespace {

namespace core = CGAL::Point_set_consolidation_3::internal;
using support::Consolidation_options;
using support::Consolidation_result;
using synthetic::Shape;

Scan scan_of(const Triangle_mesh& truth, std::size_t views, std::size_t points, double noise = 0)
{
  Scanner_options options;
  options.views = views;
  options.points = points;
  options.noise = noise;
  return scan_mesh(truth, options);
}

Point_cloud cloud_of(const Method_result& result)
{
  Point_cloud cloud;
  cloud.points = result.points;
  cloud.normals = result.normals;
  return cloud;
}

Point_cloud run_method(const char* name, const Point_cloud& scan)
{
  return cloud_of(method_called(name).run(scan));
}

/// Consolidated points alone, by deep points with the paper's parameters if nothing else is set.
Consolidation_result deep_points(const Point_cloud& scan, std::size_t particles,
                                 const std::function<void(Consolidation_options&)>& set = {})
{
  Consolidation_options options;
  options.wants_completed = false;
  options.particles = particles;
  if(set)
    set(options);
  return support::consolidate(scan, options, {});
}

/// Inner ends of deep points.
std::vector<Vec3> inner_points(const Consolidation_result& result)
{
  std::vector<Vec3> points;
  for(std::size_t i = 1; i < result.deep_points.vertices.size(); i += 2)
    points.push_back(result.deep_points.vertices[i]);
  return points;
}

support::Panel points_panel(const std::string& title, const std::vector<Vec3>& points)
{
  support::Panel panel;
  panel.title = title;
  panel.cloud.points = points;
  panel.point_colors.assign(points.size(), support::colors::skeleton);
  return panel;
}

std::vector<double> mean_lengths(const Consolidation_result& result)
{
  std::vector<double> lengths;
  for(const auto& edge : result.deep_points.edges)
    lengths.push_back((result.deep_points.vertices[edge[0]] - result.deep_points.vertices[edge[1]]).norm());
  return lengths;
}

Figure_result figure_2(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "armadillo");
  const Scan scan = scan_of(truth, 1, 20000);
  const Judge judge(truth, truth_cloud(scan));
  Figure_result figure;
  Figure_table table{"armadillo, one view", mesh_columns(), {}};
  table.columns.push_back("normals");
  figure.panels.push_back(cloud_panel("(a) input", scan.cloud));
  const auto add = [&](const char* method, const std::string& title) {
    const Point_cloud points = run_method(method, scan.cloud);
    const std::vector<double> errors = normal_errors(truth, points);
    const Triangle_mesh mesh = poisson(points);
    std::vector<double> row = mesh_row(judge.mesh(mesh));
    row.push_back(mean(errors));
    table.rows.push_back({title, row});
    if(method != std::string("direct")) {
      support::Panel panel = cloud_panel(title + ": errors of normals", points);
      panel.point_colors = heat_colors(errors, 45);
      figure.panels.push_back(panel);
    }
    figure.panels.push_back(mesh_panel("Poisson of " + title, mesh));
  };
  add("direct", "input");
  add("wlop", "WLOP");
  add("deep-points", "deep points");
  add("completion", "completed input");
  figure.tables.push_back(table);
  figure.columns = 4;
  return figure;
}

/// The contraction that the paper compares with: medians of balls instead of ellipsoids. Lengths in spacings.
std::vector<Vec3> isotropic_contraction(const std::vector<Vec3>& anchors)
{
  constexpr double radius = 3, repulsion = 0.4, least_distance = 0.5;
  constexpr int iterations = 10;
  std::vector<Vec3> points = anchors;
  for(int t = 0; t < iterations; ++t) {
    std::vector<Vec3> next;
    for(const Vec3& q : points) {
      Vec3 median = Vec3::Zero(), push = Vec3::Zero();
      double median_weight = 0, push_weight = 0;
      for(std::size_t j = 0; j < points.size(); ++j) {
        const Vec3 to_anchor = anchors[j] - q, away = q - points[j];
        const double d2 = to_anchor.squaredNorm(), e2 = away.squaredNorm();
        if(d2 < 9 * radius * radius) {
          const double w = std::exp(-d2 / (radius * radius)) / (std::max)(least_distance, std::sqrt(d2));
          median += w * to_anchor;
          median_weight += w;
        }
        if(e2 > 0 && e2 < 9 * radius * radius) {
          const double w = std::exp(-e2 / (radius * radius)) / std::pow((std::max)(least_distance, std::sqrt(e2)), 5);
          push += w * away;
          push_weight += w;
        }
      }
      next.push_back(q + (median_weight > 0 ? Vec3(median / median_weight) : Vec3(Vec3::Zero()))
                     + repulsion * (push_weight > 0 ? Vec3(push / push_weight) : Vec3(Vec3::Zero())));
    }
    points.swap(next);
  }
  return points;
}

/// A tray with a handle: a sheet and a curve in one shape.
Shape tray_with_handle()
{
  const Shape tray = synthetic::plate(3, 2, 0.3);
  const Shape left = synthetic::capsule(Vec3(-1, 0, 0), Vec3(-0.8, 0, 1.2), 0.18);
  const Shape right = synthetic::capsule(Vec3(1, 0, 0), Vec3(0.8, 0, 1.2), 0.18);
  const Shape top = synthetic::capsule(Vec3(-0.8, 0, 1.2), Vec3(0.8, 0, 1.2), 0.18);
  return synthetic::united({tray, left, right, top});
}

Figure_result figure_5(const std::string&)
{
  Figure_result figure;
  figure.view = Vec3(-0.35, 0.75, -0.55);
  figure.up = Vec3::UnitZ();
  Figure_table table{"distance from the true skeleton, percent of the diagonal",
                     {"points", "WLOP contracted", "anchors", "isotropic", "meso-skeleton", "95 %"}, {}};
  struct Variant {
    const char* name;
    Shape shape;
    std::vector<Vec3> views;
  };
  const std::vector<Variant> variants = {
    {"torus, one view", synthetic::torus(1, 0.3), {Vec3(0.2, 0.3, 1)}},
    {"plate, two views", synthetic::plate(2, 1.5, 0.2), {Vec3(0.3, 0.2, 1), Vec3(-0.2, 0.3, -1)}},
    {"tray with a handle, two views", tray_with_handle(), {Vec3(0.4, -0.8, 0.6), Vec3(-0.3, 0.5, -0.8)}}};
  for(const Variant& variant : variants) {
    const synthetic::Scan scan = synthetic::scan(variant.shape, variant.views, 15000, 1);
    Point_cloud input;
    input.points = scan.points;
    input.directions = scan.directions;
    const Consolidation_result wlop =
      deep_points(input, 3000, [](Consolidation_options& o) { o.method = "wlop"; });
    const double unit = wlop.spacing;
    std::vector<Vec3> points;
    for(const Vec3& p : wlop.consolidated.points)
      points.push_back(p / unit);
    core::Execution execution;
    core::Stage stage(execution, "inner points", 1);
    const core::Sunk_points sunk =
      core::sink(execution, stage, points, wlop.consolidated.normals, core::Sinking_parameters());
    const auto contract = [&](const std::vector<Vec3>& anchors) {
      return core::form_meso_skeleton(execution, stage, anchors, sunk.normals, core::Meso_skeleton_parameters())
        .points;
    };
    const auto world = [&](std::vector<Vec3> local) {
      for(Vec3& p : local)
        p *= unit;
      return local;
    };
    const std::vector<Vec3> contracted = world(contract(points)), anchors = world(sunk.anchors),
                            isotropic = world(isotropic_contraction(sunk.anchors)),
                            skeleton = world(contract(sunk.anchors));
    const auto distances = [&](const std::vector<Vec3>& inner) {
      std::vector<double> result;
      for(const Vec3& q : inner)
        result.push_back(100 * variant.shape.skeleton_distance(q) / variant.shape.diagonal());
      return result;
    };
    table.rows.push_back({variant.name,
                          {double(points.size()), mean(distances(contracted)), mean(distances(anchors)),
                           mean(distances(isotropic)), mean(distances(skeleton)),
                           distance_statistics(distances(skeleton)).percentile_95}});
    if(&variant == &variants.back()) {
      figure.panels = {cloud_panel("(a) scan", input), cloud_panel("(b) WLOP", wlop.consolidated),
                       points_panel("(c) contracted directly", contracted),
                       points_panel("(d) anchors", anchors), points_panel("(e) isotropic", isotropic),
                       points_panel("(f) meso-skeleton", skeleton)};
    }
  }
  figure.tables.push_back(table);
  figure.columns = 3;
  return figure;
}

/// Share of the surface that is within two spacings of a point, in the parts that the scan has not seen.
double unseen_share_covered(const Judge& judge, const Consolidation_result& result)
{
  // the distribution of the unseen distances tells the share within 1 % of the diagonal
  return judge.points(result.consolidated).unseen.share_within[2];
}

Figure_result figure_8(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "knot1");
  const Scan scan = scan_of(truth, 1, 20000);
  const Judge judge(truth, truth_cloud(scan));
  Figure_result figure;
  Figure_table table{
      "knot1, one view; unseen part within 1 % of a point", {"covered", "to truth", "95 %", "spacing"}, {}};
  for(const char* term : {"full", "normal"})
    for(const std::size_t iterations : {1, 15, 60, 120}) {
      const Consolidation_result result = deep_points(scan.cloud, 4000, [&](Consolidation_options& o) {
        o.surface_iterations = iterations;
        o.data_term = term;
      });
      const Point_set_verdict verdict = judge.points(result.consolidated);
      const std::string title = std::string(term) + " data term, " + std::to_string(iterations) + " iterations";
      table.rows.push_back({title,
                            {unseen_share_covered(judge, result), verdict.distance.mean,
                             verdict.distance.percentile_95, verdict.spacing}});
      figure.panels.push_back(cloud_panel(title, result.consolidated));
    }
  figure.tables.push_back(table);
  figure.columns = 4;
  return figure;
}

/// Deep points for values of one parameter, on one scan.
Figure_result parameter_figure(
    const Triangle_mesh& truth, const std::vector<std::pair<std::string, Scan>>& scans,
    const std::vector<std::pair<std::string, std::function<void(Consolidation_options&)>>>& values)
{
  Figure_result figure;
  for(const auto& scan : scans) {
    const Judge judge(truth, truth_cloud(scan.second));
    Figure_table table{scan.first,
                       {"to truth", "95 %", "unseen covered", "spacing variation", "length", "inner to medial axis",
                        "Poisson error", "volume"},
                       {}};
    figure.panels.push_back(cloud_panel(scan.first, scan.second.cloud));
    for(const auto& value : values) {
      const Consolidation_result result = deep_points(scan.second.cloud, 4000, value.second);
      const Point_set_verdict verdict = judge.points(result.consolidated);
      const std::vector<Vec3> inner = inner_points(result);
      const Triangle_mesh mesh = poisson(result.consolidated);
      const Mesh_verdict of_mesh = judge.mesh(mesh);
      table.rows.push_back({value.first,
                            {verdict.distance.mean, verdict.distance.percentile_95, unseen_share_covered(judge, result),
                             verdict.spacing_variation, 100 * mean(mean_lengths(result)),
                             judge.skeleton({inner, {}, {}}).to_medial_axis.mean, of_mesh.forward.mean,
                             of_mesh.volume_ratio}});
      figure.panels.push_back(points_panel("meso-skeleton, " + value.first, inner));
      figure.panels.push_back(cloud_panel("points, " + value.first, result.consolidated));
    }
    figure.tables.push_back(table);
  }
  figure.columns = 1 + 2 * values.size();
  return figure;
}

Figure_result figure_9(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "cactus");
  const auto omega = [](double degrees) {
    return [degrees](Consolidation_options& o) { o.omega = degrees; };
  };
  return parameter_figure(truth, {{"cactus, two views", scan_of(truth, 2, 30000, 0.2)}},
                          {{"omega 25", omega(25)}, {"omega 45", omega(45)}, {"omega 90", omega(90)}});
}

Figure_result figure_10(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "refined_elephant");
  const auto sigma = [](double radius) {
    return [radius](Consolidation_options& o) { o.sigma_p = radius; };
  };
  return parameter_figure(truth,
                          {{"elephant, two views, clean", scan_of(truth, 2, 30000)},
                           {"elephant, two views, 1 % noise", scan_of(truth, 2, 30000, 1)}},
                          {{"sigma_p 3", sigma(3)}, {"sigma_p 5", sigma(5)}, {"sigma_p 8", sigma(8)}});
}

Figure_result figure_11(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "armadillo");
  Figure_result figure;
  for(const double noise : {0.0, 2.0}) {
    support::Plot plot;
    plot.title = noise > 0 ? "2 % noise" : "clean";
    plot.x_label = "distance of the truth from the mesh, percent of the diagonal";
    plot.y_label = "share of the truth's surface";
    plot.log_x = true;
    Figure_table table{"armadillo, " + plot.title, mesh_columns(), {}};
    for(const std::size_t views : {1, 2, 3}) {
      const Scan scan = scan_of(truth, views, 10000 * (views + 1), noise);
      const Judge judge(truth, truth_cloud(scan));
      const std::string number = std::to_string(views) + (views == 1 ? " scan, " : " scans, ");
      if(views == 1)
        figure.panels.push_back(cloud_panel("scan, " + plot.title, scan.cloud));
      for(const char* method : {noise > 0 ? "wlop" : "direct", "deep-points", "completion"}) {
        const Triangle_mesh mesh = poisson(run_method(method, scan.cloud));
        const Mesh_verdict verdict = judge.mesh(mesh);
        table.rows.push_back({number + method, mesh_row(verdict)});
        plot.series.push_back(support::cumulative_distribution(
          number + method, {verdict.forward.quantiles.begin(), verdict.forward.quantiles.end()}));
        if(views == 1)
          figure.panels.push_back(mesh_panel(number + method, mesh));
      }
    }
    figure.tables.push_back(table);
    figure.plots.push_back(plot);
  }
  figure.columns = 4;
  return figure;
}

Figure_result figure_12(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"cactus", "man"}) {
    const Triangle_mesh truth = figure_model(data, model);
    const Scan scan = scan_of(truth, 1, 20000);
    const Judge judge(truth, truth_cloud(scan));
    Figure_table table{std::string(model) + ", one view", mesh_columns(), {}};
    const Point_cloud direct = run_method("direct", scan.cloud);
    figure.panels.push_back(cloud_panel("scan", scan.cloud));
    const auto add = [&](const std::string& name, const Triangle_mesh& mesh) {
      table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
      figure.panels.push_back(mesh_panel(name, mesh));
    };
    add("Poisson of the scan", poisson(direct));
    const Skeleton_run laplacian = laplacian_skeleton(direct.points, direct.normals);
    add("Laplacian skeleton", skeleton_driven_mesh(direct.points, laplacian.graph));
    const Skeleton_run l1 = l1_medial_skeleton(direct.points);
    add("L1-medial skeleton", skeleton_driven_mesh(direct.points, l1.graph));
    const Consolidation_result deep = deep_points(scan.cloud, 4000);
    add("deep points", poisson(deep.consolidated));
    add("completed input", poisson(run_method("completion", scan.cloud)));
    figure.panels.push_back(points_panel("meso-skeleton", inner_points(deep)));
    figure.tables.push_back(table);
  }
  figure.columns = 7;
  return figure;
}

/// Poisson reconstructions of what some methods make of a scan.
/// With `finer` particles, WLOP and deep points are compared once more.
void compare(Figure_result& figure, const std::string& title, const Triangle_mesh& truth, const Scan& scan,
             const std::vector<const char*>& methods, std::size_t finer = 0)
{
  const Judge judge(truth, truth_cloud(scan));
  Figure_table table{title, mesh_columns(), {}};
  table.columns.push_back("true genus");
  figure.panels.push_back(cloud_panel(title, scan.cloud));
  const auto add = [&](const std::string& name, const Point_cloud& points) {
    const Triangle_mesh mesh = poisson(points);
    const Mesh_verdict verdict = judge.mesh(mesh);
    table.rows.push_back({name, mesh_row(verdict)});
    table.rows.back().values.push_back(verdict.true_topology.genus);
    figure.panels.push_back(mesh_panel(name, mesh));
  };
  for(const char* method : methods)
    add(method, run_method(method, scan.cloud));
  for(const char* method : {"wlop", "deep-points"})
    if(finer > 0)
      add(std::string(method) + ", " + std::to_string(finer) + " points",
          deep_points(scan.cloud, finer, [&](Consolidation_options& o) { o.method = method; }).consolidated);
  figure.tables.push_back(table);
  figure.columns = methods.size() + (finer > 0 ? 3 : 1);
}

Figure_result figure_13(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"hand", "knot1"}) {
    const Triangle_mesh truth = figure_model(data, model);
    compare(figure, std::string(model) + ", three views", truth, scan_of(truth, 3, 40000, 0.2),
            {"direct", "deep-points", "completion"});
  }
  return figure;
}

Figure_result figure_14(const std::string&)
{
  Figure_result figure;
  figure.shares_camera = false;
  figure.up = Vec3::UnitZ();
  figure.view = Vec3(-0.3, 0.8, -0.5);
  const Shape table_top = synthetic::plate(2, 2, 0.06);
  const auto leg = [](double x, double y) {
    return synthetic::capsule(Vec3(x, y, 0), Vec3(1.1 * x, 1.1 * y, -1.4), 0.05);
  };
  const Shape table = synthetic::united({table_top, leg(-0.8, -0.8), leg(0.8, -0.8), leg(-0.8, 0.8), leg(0.8, 0.8)});
  const Shape bowl([](const Vec3& p) {
    // an open shell of thickness 0.08
    const double shell = std::abs(p.norm() - 1) - 0.04;
    return (std::max)(shell, p.z() - 0.3);
  }, [](const Vec3& p) { return std::abs(p.norm() - 1); }, Vec3(-1.04, -1.04, -1.04), Vec3(1.04, 1.04, 0.3));
  for(const auto& [name, shape, cells] :
      {std::make_tuple("table, four views", table, 180), std::make_tuple("bowl, four views", bowl, 130)}) {
    const Triangle_mesh truth = normalized(shape_mesh(shape, std::size_t(cells)));
    Scanner_options options;
    options.directions = {Vec3(0.5, -0.6, 0.7), Vec3(-0.5, 0.6, 0.7), Vec3(-0.6, -0.4, -0.7), Vec3(0.6, 0.5, -0.7)};
    options.points = 40000;
    options.noise = 0.2;
    compare(figure, name, truth, scan_mesh(truth, options), {"direct", "wlop", "deep-points", "completion"},
            16000);
  }
  return figure;
}

/// Mean distance of the truth's sharp edges from a mesh.
double error_at_edges(const Triangle_mesh& truth, const Triangle_mesh& mesh)
{
  const Mesh_tree tree(mesh);
  std::vector<double> distances;
  for(const Vec3& p : sharp_edge_points(truth))
    distances.push_back(100 * (tree.closest(p).point - p).norm());
  return mean(distances);
}

Figure_result figure_15(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"fandisk", "armadillo"}) {
    const Triangle_mesh truth = figure_model(data, model);
    const Scan scan = scan_of(truth, 3, 60000);
    const Judge judge(truth, truth_cloud(scan));
    Figure_table table{std::string(model) + ", three views", mesh_columns(), {}};
    table.columns.push_back("at sharp edges");
    figure.panels.push_back(cloud_panel("scan", scan.cloud));
    Point_cloud points = deep_points(scan.cloud, 3000).consolidated;
    const auto add = [&](const std::string& name) {
      const Triangle_mesh mesh = poisson(points);
      table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
      table.rows.back().values.push_back(error_at_edges(truth, mesh));
      figure.panels.push_back(cloud_panel(name, points));
      figure.panels.push_back(mesh_panel("Poisson of " + name, mesh));
    };
    add("deep points");
    support::upsample(points, 20000);
    add("after EAR");
    figure.tables.push_back(table);
  }
  figure.columns = 5;
  return figure;
}

Figure_result figure_16(const std::string&)
{
  // a ball with bumps of a tenth of its radius
  std::vector<Shape> parts = {synthetic::capsule(Vec3::Zero(), Vec3(1e-6, 0, 0), 1)};
  std::vector<Vec3> bumps;
  for(const double x : {-1., 1.})
    for(const double y : {-1., 1.})
      for(const double z : {-1., 1.})
        bumps.push_back(Vec3(x, y, z).normalized());
  for(int axis = 0; axis < 3; ++axis)
    for(const double s : {-1., 1.})
      bumps.push_back(s * Vec3(Vec3::Unit(axis)));
  for(const Vec3& b : bumps)
    parts.push_back(synthetic::capsule(0.95 * b, 1.1 * b, 0.1));
  const Shape shape = synthetic::united(parts);
  const Triangle_mesh raw = shape_mesh(shape, 160);
  const Triangle_mesh truth = normalized(raw);
  const double scale = (truth.vertices[1] - truth.vertices[0]).norm() / (raw.vertices[1] - raw.vertices[0]).norm();
  const Scan scan = scan_of(truth, 3, 40000, 0.1);
  const Judge judge(truth, truth_cloud(scan));
  Figure_result figure;
  Figure_table table{"ball with bumps, three views", mesh_columns(), {}};
  table.columns.push_back("bumps kept of 14");
  figure.panels.push_back(cloud_panel("(a) scan", scan.cloud));
  const Consolidation_result deep = deep_points(scan.cloud, 6000);
  figure.panels.push_back(cloud_panel("(b) deep points", deep.consolidated));
  figure.panels.push_back(points_panel("meso-skeleton", inner_points(deep)));
  const auto add = [&](const std::string& name, const Point_cloud& points) {
    const Triangle_mesh mesh = poisson(points);
    table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
    const Mesh_tree tree(mesh);
    double kept = 0;
    for(const Vec3& b : bumps) {
      const Vec3 tip = scale * 1.2 * b;
      kept += (tree.closest(tip).point - tip).norm() < 0.05 * scale;
    }
    table.rows.back().values.push_back(kept);
    figure.panels.push_back(mesh_panel("Poisson of " + name, mesh));
  };
  add("scan", run_method("direct", scan.cloud));
  add("WLOP", run_method("wlop", scan.cloud));
  add("deep points", deep.consolidated);
  figure.tables.push_back(table);
  figure.columns = 3;
  return figure;
}

Figure_result figure_17(const std::string&)
{
  // a vase that stands on a flat base which nobody saw
  const Shape body = synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, 1), 0.6);
  const Shape vase([body](const Vec3& p) { return (std::max)(body.distance(p), -p.z()); },
                   [](const Vec3& p) { return std::hypot(p.x(), p.y()); }, Vec3(-0.6, -0.6, 0),
                   Vec3(0.6, 0.6, 1.6));
  const Triangle_mesh truth = normalized(shape_mesh(vase, 100));
  Scanner_options options;
  options.directions = {Vec3(1, 0.2, 0.4), Vec3(-0.6, 0.9, 0.4), Vec3(-0.5, -0.9, 0.4)};
  options.points = 30000;
  const Scan scan = scan_mesh(truth, options);
  const Judge judge(truth, truth_cloud(scan));
  Figure_result figure;
  figure.view = Vec3(-0.3, 0.8, 0.35);
  figure.up = Vec3::UnitZ();
  Figure_table table{"vase without its base", mesh_columns(), {}};
  table.columns.push_back("mean length");
  figure.panels.push_back(cloud_panel("scan", scan.cloud));
  for(const char* prior : {"volume-preserving", "minimal-volume", "flat"}) {
    // directions would carve the space under the base: the priors alone decide
    Point_cloud points;
    points.points = scan.cloud.points;
    points.normals = scan.true_normals;
    const Consolidation_result result = deep_points(points, 4000, [&](Consolidation_options& o) {
      o.prior = prior;
      o.data_term = "normal";
    });
    const Triangle_mesh mesh = poisson(result.consolidated);
    table.rows.push_back({prior, mesh_row(judge.mesh(mesh))});
    table.rows.back().values.push_back(100 * mean(mean_lengths(result)));
    figure.panels.push_back(cloud_panel(prior, result.consolidated));
    figure.panels.push_back(mesh_panel(std::string("Poisson, ") + prior, mesh));
  }
  const Point_cloud completed = run_method("completion", scan.cloud);
  const Triangle_mesh mesh = poisson(completed);
  table.rows.push_back({"completed input", mesh_row(judge.mesh(mesh))});
  table.rows.back().values.push_back(std::nan(""));
  figure.panels.push_back(mesh_panel("completed input", mesh));
  figure.tables.push_back(table);
  figure.columns = 3;
  return figure;
}

Figure_result table_1(const std::string& data)
{
  Figure_result figure;
  Figure_table table{"armadillo, three views, 0.1 % noise; wall seconds",
                     {"|C|", "|S|", "Tw", "Td", "paper Tw", "paper Td", "ms per deep point", "paper ms"}, {}};
  support::Plot plot;
  plot.title = "Time after WLOP per deep point";
  plot.y_label = "milliseconds";
  plot.log_y = true;
  support::Series ours{"this package", {}, {}}, paper{"paper", {}, {}};
  for(const Paper_class& c : deep_points_classes()) {
    const Point_cloud cloud = scan_of(figure_model(data, c.model), 3, c.points, 0.1).cloud;
    const Consolidation_result result
        = deep_points(cloud, (std::min)(c.particles, cloud.size()), [](Consolidation_options& o) {
            o.completed_spacing = 0;  // as many deep points as the paper has
          });
    double wlop = 0, deep = 0;
    for(const auto& time : result.times) {
      const bool is_input
          = time.name == "outliers" || time.name == "denoising" || time.name == "wlop" || time.name == "normals";
      (is_input ? wlop : deep) += time.seconds;
    }
    const double n = double(result.consolidated.size());
    table.rows.push_back({c.name,
                          {double(cloud.size()), n, wlop, deep, c.wlop_seconds, c.seconds, 1000 * deep / n,
                           1000 * c.seconds / double(c.particles)}});
    plot.categories.push_back(c.name);
    ours.y.push_back(1000 * deep / n);
    paper.y.push_back(1000 * c.seconds / double(c.particles));
  }
  plot.series = {ours, paper};
  figure.tables.push_back(table);
  figure.plots.push_back(plot);
  return figure;
}

/// Tubes seen from one side: deep points alone, with the data term for tubes, and the completed input.
Figure_result tubes(const std::string&)
{
  const std::vector<std::pair<const char*, Shape> > shapes = {
    {"torus", synthetic::torus(1, 0.35)},
    {"Y", synthetic::united({synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, -2), 0.35),
                             synthetic::capsule(Vec3(0, 0, 0), Vec3(1.4, 0, 1.4), 0.35),
                             synthetic::capsule(Vec3(0, 0, 0), Vec3(-1.4, 0, 1.4), 0.35)})},
    {"capsule", synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, 4), 0.5)}};
  Figure_result figure;
  for(const auto& [name, shape] : shapes) {
    const Triangle_mesh truth = normalized(shape_mesh(shape, 130));
    const Scan scan = scan_of(truth, 1, 20000);
    const Judge judge(truth, truth_cloud(scan));
    Figure_table table{name, mesh_columns(), {}};
    figure.panels.push_back(cloud_panel(std::string(name) + ", one view", scan.cloud));
    const auto add = [&](const std::string& title, const Point_cloud& points) {
      const Triangle_mesh mesh = poisson(points);
      table.rows.push_back({title, mesh_row(judge.mesh(mesh))});
      figure.panels.push_back(mesh_panel("Poisson of " + title, mesh));
    };
    add("the scan", run_method("direct", scan.cloud));
    for(const double spacing : {0., 1.})
      add(spacing > 0 ? "deep points" : "deep points, not filled",
          deep_points(scan.cloud, 4000, [&](Consolidation_options& o) {
            o.data_term = "normal";
            o.completed_spacing = spacing;
          }).consolidated);
    add("the completed input", run_method("completion", scan.cloud));
    figure.tables.push_back(table);
  }
  figure.columns = 5;
  return figure;
}

/// What the confidence of completed points says: the share of them that is less than one spacing of the particles
/// off the true surface.
Figure_result confidence_curve(const std::string& data)
{
  constexpr int bins = 10;
  constexpr double least_points = 200;  // in a bin
  std::vector<double> count(bins, 0.), exact(bins, 0.), error_sum(bins, 0.), confidence_sum(bins, 0.);
  for(const char* name : {"armadillo", "bear", "cow", "knot1", "man", "refined_elephant"}) {
    const Triangle_mesh truth = figure_model(data, name);
    const Mesh_tree surface(truth);
    const Scan scan = scan_of(truth, 1, 20000);
    Consolidation_options options;
    options.wants_points = false;
    const Consolidation_result result = support::consolidate(scan.cloud, options, {});
    for(std::size_t i = scan.cloud.size(); i < result.completed.size(); ++i) {
      const Vec3& p = result.completed.points[i];
      const double error = (surface.closest(p).point - p).norm() / result.spacing;
      const double confidence = result.completed.confidence[i];
      const std::size_t b = std::size_t((std::min)(bins - 1., bins * confidence));
      ++count[b];
      exact[b] += error < 1;
      error_sum[b] += error;
      confidence_sum[b] += confidence;
    }
  }
  Figure_result figure;
  Figure_table table{"completed points of one-view scans of six models, by confidence",
                     {"points", "confidence", "less than r off", "mean error / r"}, {}};
  support::Series curve{"completed points", {}, {}}, ideal{"ideal", {0, 1}, {0, 1}};
  curve.shape = support::Series::Shape::marked_line;
  for(std::size_t b = 0; b < bins; ++b) {
    if(count[b] < least_points)
      continue;
    const double confidence = confidence_sum[b] / count[b], share = exact[b] / count[b];
    table.rows.push_back({"0." + std::to_string(b) + " - ",
                          {count[b], confidence, share, error_sum[b] / count[b]}});
    curve.x.push_back(confidence);
    curve.y.push_back(share);
  }
  support::Plot plot;
  plot.title = "Confidence of completed points";
  plot.x_label = "confidence";
  plot.y_label = "share less than one spacing off";
  plot.series = {curve, ideal};
  figure.tables.push_back(table);
  figure.plots.push_back(plot);
  return figure;
}

}  // namespace

std::vector<Paper_figure> deep_points_figures()
{
  return {
    {"deep_figure_2", "Poisson of a raw scan, of WLOP and of deep points; errors of normals", figure_2},
    {"deep_figure_5", "inner points contracted directly, sunk, isotropically and anisotropically", figure_5},
    {"deep_figure_8", "missing areas close while surface points are consolidated", figure_8},
    {"deep_figure_9", "collision angle omega of 25, 45 and 90 degrees", figure_9},
    {"deep_figure_10", "neighbourhood size sigma_p of 3, 5 and 8", figure_10},
    {"deep_figure_11", "distribution of the error for 1 to 3 scans, clean and with 2 % noise", figure_11},
    {"deep_figure_12", "against completion along curve skeletons", figure_12},
    {"deep_figure_13", "thin and adjacent structures are not fused", figure_13},
    {"deep_figure_14", "thin sheets and rods", figure_14},
    {"deep_figure_15", "edge-aware resampling recovers detail and sharp features", figure_15},
    {"deep_figure_16", "features of different scales", figure_16},
    {"deep_figure_17", "volume-preserving, minimal-volume and flat priors", figure_17},
    {"deep_tubes", "tubes seen from one side: deep points alone and the completed input", tubes},
    {"deep_confidence", "confidence of completed points against their true error", confidence_curve},
    {"deep_table_1", "times of WLOP and of deep points", table_1},
  };
}

}  // namespace benchmark
