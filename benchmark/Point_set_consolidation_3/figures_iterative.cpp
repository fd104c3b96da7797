// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of the iterative consolidation paper. Its scans are not public, but for the armadillo: virtual
// scans stand in.

#include "iterative_runs.h"
#include "mesh_tree.h"
#include "methods.h"
#include "paper_classes.h"
#include "paper_figure.h"
#include "point_tree.h"
#include "random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace benchmark {

namespace {

synthetic::Shape ellipsoid()
{
  const Vec3 axes(1, 0.7, 0.5);
  return synthetic::Shape(
    [axes](const Vec3& p) {
      const double k = p.cwiseQuotient(axes).norm(), g = p.cwiseQuotient(axes.cwiseAbs2()).norm();
      return g > 0 ? k * (k - 1) / g : -0.5;  // exact to first order at the surface
    },
    [](const Vec3& p) { return p.norm(); }, -axes, axes);
}

/// Even samples of a mesh with the normals of their facets.
Point_cloud oriented_samples(const Triangle_mesh& mesh, std::size_t count, std::uint64_t seed = 1)
{
  const Surface_samples samples = sample_surface(mesh, count, seed);
  Point_cloud cloud;
  cloud.points = samples.points;
  for(const std::size_t face : samples.faces)
    cloud.normals.push_back(face_normal(mesh, face));
  return cloud;
}

/// Samples outside of balls around `centres`, whose radius is chosen so that `share` of the area is missing.
struct Holes {
  Point_cloud cloud;
  std::vector<Vec3> missing;  ///< even samples of what the balls cut out

  Holes(const Triangle_mesh& truth, const std::vector<Vec3>& centres, double share, std::size_t count,
        std::uint64_t seed)
  {
    constexpr std::size_t dense = 200000;
    const auto to_centres = [&](const Vec3& p) {
      double least = (std::numeric_limits<double>::max)();
      for(const Vec3& c : centres)
        least = (std::min)(least, (p - c).norm());
      return least;
    };
    const std::vector<Vec3> all = sample_surface(truth, dense, 77).points;
    std::vector<double> distances;
    for(const Vec3& p : all)
      distances.push_back(to_centres(p));
    std::sort(distances.begin(), distances.end());
    const double radius = distances[std::size_t(share * double(dense))];
    for(const Vec3& p : all)
      if(to_centres(p) < radius)
        missing.push_back(p);
    const Point_cloud samples = oriented_samples(truth, std::size_t(double(count) / (1 - share)), seed);
    for(std::size_t i = 0; i < samples.size(); ++i)
      if(to_centres(samples.points[i]) >= radius) {
        cloud.points.push_back(samples.points[i]);
        cloud.normals.push_back(samples.normals[i]);
      }
  }

  /// Of the missing part from the nearest point, in increasing order.
  std::vector<double> distances(const Point_cloud& result) const
  {
    const Point_tree tree(result.points);
    std::vector<double> found;
    for(const Vec3& p : missing)
      found.push_back(tree.nearest(p).distance);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Share of the missing part with a point within 1.5 % of the diagonal.
  double coverage(const Point_cloud& result, double near = 0.015) const
  {
    const std::vector<double> found = distances(result);
    const auto beyond = std::lower_bound(found.begin(), found.end(), near);
    return double(beyond - found.begin()) / double(found.size());
  }
};

/// An ellipsoid of unit diagonal with semi-axes in the ratio 10 : 7 : 5.
struct Ellipsoid {
  synthetic::Shape shape = ellipsoid();
  Triangle_mesh truth = normalized(shape_mesh(shape, 100));
  Judge judge{truth};

  /// Without a cap of 12.7 % of its area at the end of an axis.
  Holes without_cap(int axis, std::size_t count, std::uint64_t seed) const
  {
    return Holes(truth, {Vec3(shape.upper[axis] / shape.diagonal() * Vec3::Unit(axis))}, 0.127, count, seed);
  }
};

constexpr std::size_t hole_points = 25000;

double error_of(const Judge& judge, const Point_cloud& cloud)
{
  return cloud.size() > 0 ? judge.points(cloud).distance.mean : std::nan("");
}

Figure_result figure_2(const std::string&)
{
  const Ellipsoid ellipsoid;
  const Holes holes = ellipsoid.without_cap(2, hole_points, 1);
  Figure_result figure;
  figure.view = Vec3(-0.3, 0.6, -0.7);
  figure.up = Vec3::UnitZ();
  Figure_table table{"ellipsoid without a cap", {"new points", "hole covered", "error of new", "seconds"}, {}};
  for(const unsigned int steps : {0, 10})
    for(const unsigned int iterations : {1, 2, 3, 10}) {
      Iterative_options options;
      options.repulsion_steps = steps;
      options.iterations = iterations;
      const Iterative_run run = consolidate_iteratively(holes.cloud, options);
      const std::string name =
        std::string(steps > 0 ? "with" : "without") + " repulsion, " + std::to_string(iterations) + " iterations";
      table.rows.push_back({name,
                            {double(run.added.size()), holes.coverage(run.cloud),
                             error_of(ellipsoid.judge, run.added), run.seconds}});
      figure.panels.push_back(cloud_panel(name, run.cloud));
    }
  figure.tables.push_back(table);
  figure.columns = 4;
  return figure;
}

/// Poisson of the points as they came and of what a run made of them.
void before_and_after(Figure_result& figure, const std::string& title, const Judge& judge, const Point_cloud& before,
                      const std::vector<std::pair<std::string, Point_cloud>>& after)
{
  Figure_table table{title, mesh_columns(), {}};
  table.columns.push_back("points");
  const auto add = [&](const std::string& name, const Point_cloud& cloud) {
    const Triangle_mesh mesh = poisson(cloud);
    table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
    table.rows.back().values.push_back(double(cloud.size()));
    figure.panels.push_back(cloud_panel(name, cloud));
    figure.panels.push_back(mesh_panel("Poisson of " + name, mesh));
  };
  add("input", before);
  for(const auto& result : after)
    add(result.first, result.second);
  figure.tables.push_back(table);
}

/// Coverage of the holes, and Poisson before and after; pictures of the first seed.
void add_holes(Figure_result& figure, const std::string& title, const Judge& judge,
               const std::function<Holes(std::uint64_t seed)>& cut)
{
  Figure_table table{title,
                     {"hole covered", "within 2.5 %", "farthest, %", "new points", "error of new", "Poisson before",
                      "after", "largest before", "after"},
                     {}};
  for(const std::uint64_t seed : {1, 2}) {
    const Holes holes = cut(seed);
    const Iterative_run run = consolidate_iteratively(holes.cloud);
    const Triangle_mesh before = poisson(holes.cloud), after = poisson(run.cloud);
    const Mesh_verdict verdict_before = judge.mesh(before), verdict_after = judge.mesh(after);
    table.rows.push_back(
        {"samples " + std::to_string(seed),
         {holes.coverage(run.cloud), holes.coverage(run.cloud, 0.025), 100 * holes.distances(run.cloud).back(),
          double(run.added.size()), error_of(judge, run.added), verdict_before.forward.mean,
          verdict_after.forward.mean, verdict_before.forward.max, verdict_after.forward.max}});
    if(seed == 1) {
      figure.panels.push_back(cloud_panel("input", holes.cloud));
      figure.panels.push_back(mesh_panel("Poisson of input", before));
      figure.panels.push_back(cloud_panel("consolidated", run.cloud));
      figure.panels.push_back(mesh_panel("Poisson of consolidated", after));
    }
  }
  figure.tables.push_back(table);
}

Figure_result cap_figure(const std::string&)
{
  const Ellipsoid ellipsoid;
  Figure_result figure;
  figure.view = Vec3(-0.8, 0.6, -0.7);
  figure.up = Vec3::UnitZ();
  figure.columns = 4;
  for(const int axis : {2, 0})
    add_holes(figure, axis == 2 ? "cap over the short axis" : "cap over the long axis", ellipsoid.judge,
              [&](std::uint64_t seed) { return ellipsoid.without_cap(axis, hole_points, seed); });
  return figure;
}

Figure_result six_holes(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "bunny00");
  /// Random places, 15 % of the diagonal apart, others for each seed.
  const auto centres = [&](std::uint64_t seed) {
    std::vector<Vec3> places;
    for(const Vec3& p : sample_surface(truth, 1000, 100 + seed).points) {
      const bool is_apart = std::all_of(places.begin(), places.end(),
                                        [&](const Vec3& c) { return (c - p).norm() > 0.15; });
      if(is_apart && places.size() < 6)
        places.push_back(p);
    }
    return places;
  };
  Figure_result figure;
  figure.view = Vec3(-0.45, -0.3, -1);
  add_holes(figure, "bunny with six holes, 4.9 % of its area", Judge(truth), [&](std::uint64_t seed) {
    return Holes(truth, centres(seed), 0.049, hole_points, seed);
  });
  return figure;
}

Figure_result figure_3(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"man", "hand"}) {
    const Triangle_mesh truth = figure_model(data, model);
    Scanner_options options;
    options.views = 2;
    options.points = 30000;
    const Scan scan = scan_mesh(truth, options);
    const Judge judge(truth, truth_cloud(scan));
    const auto oriented = [&](const char* method) {
      const Method_result result = method_called(method).run(scan.cloud);
      Point_cloud cloud;
      cloud.points = result.points;
      cloud.normals = result.normals;
      return cloud;
    };
    before_and_after(figure, std::string(model) + ", two views", judge, oriented("direct"),
                     {{"WLOP", oriented("wlop")}, {"iterative", oriented("iterative")}});
  }
  figure.columns = 6;
  return figure;
}

/// The armadillo, a share of its points displaced: near ones by up to 2 % of the diagonal in each coordinate, far ones
/// to anywhere in a box of 1.5 times its size.
struct Noisy_armadillo {
  static constexpr std::size_t points = 30000;
  static constexpr double range = 0.02, farther = 0.005;
  Point_cloud cloud;
  std::vector<char> is_outlier;  ///< farther than 0.5 % from the surface

  Noisy_armadillo(const Triangle_mesh& truth, double share, bool is_far)
  {
    const Mesh_tree tree(truth);
    cloud.points = sample_surface(truth, points, 1).points;
    Vec3 lower = cloud.points[0], upper = lower;
    for(const Vec3& p : cloud.points) {
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    Random_numbers random(1001);
    for(std::size_t i = 0; i < std::size_t(share * double(points)); ++i)
      for(int k = 0; k < 3; ++k) {
        double& x = cloud.points[i][k];
        x = is_far ? 0.5 * (lower[k] + upper[k]) + 1.5 * (upper[k] - lower[k]) * (random.uniform() - 0.5)
                   : x + range * random.uniform(-1, 1);
      }
    for(const Vec3& p : cloud.points)
      is_outlier.push_back((tree.closest(p).point - p).norm() > farther);
  }

  /// Precision and recall.
  std::pair<double, double> rates(const std::vector<std::size_t>& found) const
  {
    double right = 0;
    for(const std::size_t i : found)
      right += is_outlier[i];
    const auto all = double(std::count(is_outlier.begin(), is_outlier.end(), char(1)));
    return {right / (std::max)(1.0, double(found.size())), right / (std::max)(1.0, all)};
  }
};

Figure_result figure_10(const std::string& data)
{
  constexpr double particle_fraction = 0.05;
  const Triangle_mesh truth = figure_model(data, "armadillo");
  const Judge judge(truth);
  Figure_result figure;
  Figure_table near{"armadillo, noisy points within 2 % of the diagonal",
                    {"removed", "precision", "recall", "recall as printed", "distance before", "distance after",
                     "Poisson before", "Poisson after"},
                    {}};
  Figure_table far{"noisy points in a box of 1.5 times its size",
                   {"removed", "precision", "recall", "recall as printed", "distance before", "distance after"},
                   {}};
  for(const bool is_far : {false, true})
    for(const double share : {0.05, 0.10, 0.15, 0.20}) {
      const Noisy_armadillo noisy(truth, share, is_far);
      Iterative_options options;
      options.particle_fraction = particle_fraction;
      options.iterations = 0;
      const Iterative_run run = consolidate_iteratively(noisy.cloud, options);
      options.printed_values = true;
      const Iterative_run printed = consolidate_iteratively(noisy.cloud, options);
      // the normals of points nobody oriented: estimated and oriented by the same function, without removal
      options.is_static.assign(noisy.cloud.size(), 1);
      const Point_cloud before = consolidate_iteratively(noisy.cloud, options).cloud;
      const auto [precision, recall] = noisy.rates(run.outliers);
      const std::string percent = std::to_string(int(100 * share)) + " %";
      std::vector<double> row = {double(run.outliers.size()), precision, recall,
                                 noisy.rates(printed.outliers).second, judge.points(before).distance.mean,
                                 judge.points(run.cloud).distance.mean};
      if(!is_far) {
        const Triangle_mesh mesh_before = poisson(before), mesh_after = poisson(run.cloud);
        row.push_back(judge.mesh(mesh_before).forward.mean);
        row.push_back(judge.mesh(mesh_after).forward.mean);
        support::Panel panel = cloud_panel(percent + " noise, outliers found", noisy.cloud);
        panel.point_colors.assign(noisy.cloud.size(), support::colors::scan);
        for(const std::size_t i : run.outliers)
          panel.point_colors[i] = support::colors::completed;
        figure.panels.push_back(panel);
        figure.panels.push_back(mesh_panel("Poisson before", mesh_before));
        figure.panels.push_back(mesh_panel("Poisson after", mesh_after));
      }
      (is_far ? far : near).rows.push_back({percent, row});
    }
  figure.tables = {near, far};
  figure.columns = 6;
  return figure;
}

Figure_result figure_8(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "man");
  Scanner_options options;
  options.directions = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  options.points = 40000;
  const Scan scan = scan_mesh(truth, options);
  const Judge judge(truth, truth_cloud(scan));
  const Method_result direct = method_called("direct").run(scan.cloud);
  Point_cloud before;
  before.points = direct.points;
  before.normals = direct.normals;
  std::vector<std::pair<std::string, Point_cloud>> after;
  for(const bool guard : {true, false})
    for(const bool two_phases : {false, true}) {
      Iterative_options variant;
      variant.two_phases = two_phases;
      variant.guard = guard;
      after.emplace_back(std::string(two_phases ? "two phases" : "one phase") + (guard ? "" : ", no guards"),
                         consolidate_iteratively(scan.cloud, variant).cloud);
    }
  Figure_result figure;
  before_and_after(figure, "man, front and back", judge, before, after);
  figure.columns = 5;
  return figure;
}

/// Share of the normals that point inwards.
double flipped_share(const Triangle_mesh& truth, const Point_cloud& cloud)
{
  const Mesh_tree tree(truth);
  double flipped = 0;
  for(std::size_t i = 0; i < cloud.size(); ++i)
    flipped += tree.closest(cloud.points[i]).normal.dot(cloud.normals[i]) < 0;
  return flipped / double(cloud.size());
}

/// Points with normals by PCA, oriented by the package alone: nothing is moved and nothing is added.
Iterative_run oriented_here(const std::vector<Vec3>& points)
{
  Point_cloud cloud;
  cloud.points = points;
  Iterative_options alone;
  alone.iterations = 0;
  alone.is_static.assign(points.size(), 1);
  return consolidate_iteratively(cloud, alone);
}

/// Unoriented scans from three sides: open borders, thin parts, parts that nearly touch.
Figure_table orientation_of_scans(const std::string& data)
{
  Figure_table table{"three views, share of normals on the wrong side", {"CGAL PCA and MST", "this package"}, {}};
  for(const char* model : {"armadillo", "bull", "camel", "cow", "dino", "man", "refined_elephant"})
    for(const double noise : {0.0, 0.5}) {
      Scanner_options options;
      options.views = 3;
      options.points = 30000;
      options.noise = noise;
      const Scan scan = scan_mesh(figure_model(data, model), options);
      const auto wrong = [&](const Point_cloud& cloud) {
        double count = 0;
        for(std::size_t i = 0; i < cloud.size(); ++i)
          count += cloud.normals[i].dot(scan.true_normals[i]) < 0;
        return count / double(cloud.size());
      };
      // CGAL's function returns the points in another order
      const Point_cloud tree = oriented_by_spanning_tree(scan.cloud.points);
      std::map<std::array<double, 3>, Vec3> normal_at;
      for(std::size_t i = 0; i < tree.size(); ++i)
        normal_at[{tree.points[i].x(), tree.points[i].y(), tree.points[i].z()}] = tree.normals[i];
      Point_cloud ordered = scan.cloud;
      ordered.normals.clear();
      for(const Vec3& p : ordered.points)
        ordered.normals.push_back(normal_at.at({p.x(), p.y(), p.z()}));
      table.rows.push_back({std::string(model) + ", noise " + std::to_string(noise).substr(0, 3) + " %",
                            {wrong(ordered), wrong(oriented_here(scan.cloud.points).cloud)}});
    }
  return table;
}

Figure_result figure_11(const std::string& data)
{
  Figure_result figure;
  Figure_table table{
      "share of normals that point inwards", {"CGAL PCA and MST", "this package", "near pairs that disagree"}, {}};
  const Triangle_mesh truth = figure_model(data, "bunny00");
  for(const double noise : {0.0, 0.2, 0.5}) {
    Random_numbers random(4);
    Point_cloud cloud;
    for(const Vec3& p : sample_surface(truth, 20000, 1).points)
      cloud.points.push_back(p + noise / 100 * Vec3(random.normal(), random.normal(), random.normal()));
    const Iterative_run run = oriented_here(cloud.points);
    const Point_cloud tree = oriented_by_spanning_tree(cloud.points);
    const double mst = flipped_share(truth, tree), ours = flipped_share(truth, run.cloud);
    // a tree may turn all points inside out: that is one decision, not an inconsistency
    table.rows.push_back({"bunny, noise " + std::to_string(noise).substr(0, 3) + " %",
                          {(std::min)(mst, 1 - mst), (std::min)(ours, 1 - ours), double(run.inconsistent)}});
    const auto show = [&](const std::string& name, const Point_cloud& oriented) {
      const Mesh_tree surface(truth);
      support::Panel panel = cloud_panel(name + ", noise " + std::to_string(noise).substr(0, 3) + " %", oriented);
      for(std::size_t i = 0; i < oriented.size(); ++i)
        panel.point_colors.push_back(surface.closest(oriented.points[i]).normal.dot(oriented.normals[i]) < 0
                                       ? support::colors::completed
                                       : support::colors::scan);
      figure.panels.push_back(panel);
    };
    show("spanning tree", tree);
    show("this package", run.cloud);
  }
  figure.tables.push_back(table);
  figure.tables.push_back(orientation_of_scans(data));
  return figure;
}

Figure_result figure_12(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "refined_elephant");
  Scanner_options options;
  options.views = 3;
  options.points = 40000;
  const Scan scan = scan_mesh(truth, options);
  const Judge judge(truth, truth_cloud(scan));
  Point_cloud cloud;
  cloud.points = scan.true_points;
  cloud.normals = scan.true_normals;
  Figure_result figure;
  Figure_table table{"elephant, three views", {"new points", "mean error of new", "95 %", "largest"}, {}};
  // thin parts: a ray inwards leaves the body soon
  constexpr double thin = 0.04;
  std::vector<char> is_thin;
  const Mesh_tree tree(truth);
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 inwards = -cloud.normals[i];
    const auto hit = tree.first_hit({cloud.points[i] + 1e-6 * inwards, inwards});
    is_thin.push_back(hit && (hit->point - cloud.points[i]).norm() < thin);
  }
  figure.panels.push_back(cloud_panel("scan", cloud));
  const auto add = [&](const std::string& name, bool guard, const std::vector<char>& is_static) {
    Iterative_options o;
    o.guard = guard;
    o.is_static = is_static;
    const Iterative_run run = consolidate_iteratively(cloud, o);
    const double n = double(run.added.size());
    if(n > 0) {
      const Distance_statistics distance = judge.points(run.added).distance;
      table.rows.push_back({name, {n, distance.mean, distance.percentile_95, distance.max}});
    }
    else
      table.rows.push_back({name, {0, std::nan(""), std::nan(""), std::nan("")}});
    figure.panels.push_back(cloud_panel(name, run.cloud));
  };
  add("no guard", false, {});
  add("thin parts static, no guard", false, is_thin);
  add("guards", true, {});
  figure.tables.push_back(table);
  return figure;
}

/// Algebraic surface of noisy points with true normals, as MeshLab's filter was measured.
Figure_result apss_figure(const std::string& data)
{
  constexpr double noise = 0.005;
  const Triangle_mesh truth = figure_model(data, "armadillo");
  const Judge judge(truth);
  Point_cloud cloud = oriented_samples(truth, 10000);
  Random_numbers random(1);
  for(Vec3& p : cloud.points)
    p += noise * Vec3(random.normal(), random.normal(), random.normal());
  Figure_result figure;
  Figure_table table{"armadillo, 10000 points, noise 0.5 %, true normals", {"distance", "95 %"}, {}};
  const auto add = [&](const std::string& name, const Point_cloud& points) {
    const Distance_statistics distance = judge.points(points).distance;
    table.rows.push_back({name, {distance.mean, distance.percentile_95}});
    figure.panels.push_back(cloud_panel(name, points));
  };
  add("noisy", cloud);
  for(const int support : {3, 4, 6, 8}) {
    Point_cloud projected = cloud;
    projected.points = projected_onto_apss(cloud, support);
    add("support of " + std::to_string(support) + " spacings", projected);
  }
  figure.tables.push_back(table);
  return figure;
}

Figure_result table_1(const std::string& data)
{
  Figure_result figure;
  Figure_table table{"three views; at most as many steps as in the paper",
                     {"points", "particles", "steps", "new points", "seconds", "CPU seconds", "us per point",
                      "plain loop", "paper seconds"},
                     {}};
  support::Plot plot;
  plot.title = "Time of the iterative consolidation";
  plot.y_label = "seconds";
  plot.log_y = true;
  support::Series ours{"this package", {}, {}}, paper{"paper", {}, {}};
  for(const Paper_class& c : iterative_classes()) {
    Scanner_options options;
    options.views = 3;
    options.points = c.points;
    options.noise = 0.05;
    const Point_cloud cloud = scan_mesh(figure_model(data, c.model), options).cloud;
    Iterative_options settings;
    settings.particle_fraction = double(c.particles) / double(c.points);
    settings.iterations = c.steps;
    settings.two_phases = c.two_phases;
    const Iterative_run run = consolidate_iteratively(cloud, settings);
    settings.adaptive = false;
    const Iterative_run plain = consolidate_iteratively(cloud, settings);
    table.rows.push_back({std::string(c.name) + " (" + c.model + ")",
                          {double(cloud.size()), double(c.particles), double(run.iterations),
                           double(run.added.size()), run.seconds, run.cpu_seconds,
                           1e6 * run.cpu_seconds / double(cloud.size()), plain.seconds, c.seconds}});
    plot.categories.push_back(c.name);
    ours.y.push_back(run.seconds);
    paper.y.push_back(c.seconds);
  }
  plot.series = {ours, paper};
  figure.tables.push_back(table);
  figure.plots.push_back(plot);
  return figure;
}

}  // namespace

std::vector<Paper_figure> iterative_figures()
{
  return {
    {"iterative_figure_2", "with and without the repulsion operator", figure_2},
    {"iterative_figure_3", "detail is kept and legs are not merged, against WLOP and Poisson", figure_3},
    {"iterative_figure_8", "a body scanned from front and back, in two phases", figure_8},
    {"iterative_figure_10", "figures 5 and 10: outliers of the armadillo, 5 to 20 %", figure_10},
    {"iterative_figure_11", "normals oriented by two methods", figure_11},
    {"iterative_figure_12", "a static region keeps thin parts from growing", figure_12},
    {"iterative_cap", "figure 6, on known ground: a large smooth hole", cap_figure},
    {"iterative_six_holes", "figures 7 and 9: small holes in a detailed model", six_holes},
    {"iterative_apss", "the algebraic surface of noisy points", apss_figure},
    {"iterative_table_1", "times of the classes of table I, adaptive and plain loop", table_1},
  };
}

}  // namespace benchmark
