// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of the iterative consolidation paper. Its scans are not public, but for the armadillo: virtual scans stand in.

#include "mesh_tree.h"
#include "methods.h"
#include "paper_figure.h"
#include "point_tree.h"
#include "random_numbers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <chrono>
#include <cmath>
#include <iterator>

namespace benchmark {

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Tag = CGAL::Parallel_if_available_tag;
using Stage_times = std::vector<CGAL::Point_set_consolidation_3::internal::Stage_time>;

struct Iterative_options {
  double particle_fraction = 0.1;
  unsigned int iterations = 10, repulsion_steps = 10;
  bool adaptive = true, two_phases = false, guard = true;
  std::vector<char> is_static;  ///< empty: none
};

struct Iterative_run {
  Point_cloud cloud;            ///< kept points, then new ones
  Point_cloud added;
  std::vector<std::size_t> outliers;
  std::size_t inconsistent = 0, iterations = 0;
  double seconds = 0;
};

Vec3 vec3(const Point& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vec3(const Vector& v) { return {v.x(), v.y(), v.z()}; }

/// Normals of the cloud are taken as they are; directions orient estimated ones.
Iterative_run consolidate(const Point_cloud& cloud, const Iterative_options& options = {})
{
  std::vector<Point> points;
  std::vector<Vector> normals, directions;
  std::vector<std::size_t> indices;
  std::vector<char> is_static = options.is_static;
  is_static.resize(cloud.size(), 0);
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    points.emplace_back(cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z());
    indices.push_back(i);
  }
  for(const Vec3& n : cloud.normals)
    normals.emplace_back(n.x(), n.y(), n.z());
  for(const Vec3& d : cloud.directions)
    directions.emplace_back(d.x(), d.y(), d.z());
  Iterative_run run;
  std::vector<Oriented_point> output;
  std::vector<bool> is_new;
  Stage_times times;
  const auto np = params::point_map(CGAL::make_property_map(points))
                    .geom_traits(Kernel())
                    .particle_fraction(options.particle_fraction)
                    .number_of_iterations(options.iterations)
                    .number_of_repulsion_steps(options.repulsion_steps)
                    .adaptive(options.adaptive)
                    .two_phases(options.two_phases)
                    .completion_guard(options.guard)
                    .point_is_constrained_map(CGAL::make_property_map(is_static))
                    .outlier_output_iterator(std::back_inserter(run.outliers))
                    .completed_output_iterator(std::back_inserter(is_new))
                    .inconsistent_neighbors(std::ref(run.inconsistent))
                    .stage_times(std::ref(times));
  const auto call = [&](const auto& parameters) {
    const auto begin = std::chrono::steady_clock::now();
    CGAL::iterative_consolidate_point_set<Tag>(indices, std::back_inserter(output), parameters);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  if(!normals.empty())
    call(np.normal_map(CGAL::make_property_map(normals)));
  else if(!directions.empty() && !cloud.views.empty())
    call(np.view_direction_map(CGAL::make_property_map(directions))
           .view_index_map(CGAL::make_property_map(cloud.views)));
  else
    call(np);
  for(std::size_t i = 0; i < output.size(); ++i) {
    for(Point_cloud* target : {&run.cloud, &run.added}) {
      if(target == &run.added && !is_new[i])
        continue;
      target->points.push_back(vec3(output[i].first));
      target->normals.push_back(vec3(output[i].second));
    }
    run.cloud.confidence.push_back(is_new[i] ? 0.0 : 1.0);
  }
  for(const auto& time : times)
    if(time.name == "iteration")
      run.iterations += (std::max)(std::size_t(1), time.iterations);
  return run;
}

/// A complete shape without the points that `is_missing`, with true normals.
template <typename Missing>
Point_cloud shape_without(const synthetic::Shape& shape, std::size_t count, double unit, const Missing& is_missing)
{
  Point_cloud cloud;
  for(const Vec3& p : synthetic::samples(shape, count, 1))
    if(!is_missing(p)) {
      cloud.points.push_back(p / unit);
      cloud.normals.push_back(shape.normal(p));
    }
  return cloud;
}

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

/// An ellipsoid of unit diagonal without a cap.
struct Cap {
  synthetic::Shape shape = ellipsoid();
  Triangle_mesh truth = normalized(shape_mesh(shape, 100));
  Point_cloud cloud = shape_without(shape, 20000, shape.diagonal(), [](const Vec3& p) { return p.z() > 0.34; });  // 19 % of the area
  Judge judge{truth, cloud};
};

Figure_result figure_2(const std::string&)
{
  const Cap cap;
  Figure_result figure;
  figure.view = Vec3(-0.3, 0.6, -0.7);
  figure.up = Vec3::UnitZ();
  Figure_table table{"ellipsoid without a cap", {"new points", "hole covered", "error of new", "seconds"}, {}};
  for(const unsigned int steps : {0, 10})
    for(const unsigned int iterations : {1, 2, 3, 10}) {
      Iterative_options options;
      options.repulsion_steps = steps;
      options.iterations = iterations;
      const Iterative_run run = consolidate(cap.cloud, options);
      const std::string name =
        std::string(steps > 0 ? "with" : "without") + " repulsion, " + std::to_string(iterations) + " iterations";
      const double error = run.added.size() > 0 ? cap.judge.points(run.added).distance.mean : std::nan("");
      table.rows.push_back({name,
                            {double(run.added.size()), cap.judge.points(run.cloud).unseen.share_within[2], error,
                             run.seconds}});
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

Figure_result cap_figure(const std::string&)
{
  const Cap cap;
  Figure_result figure;
  figure.view = Vec3(-0.3, 0.6, -0.7);
  figure.up = Vec3::UnitZ();
  before_and_after(figure, "ellipsoid without a cap", cap.judge, cap.cloud,
                   {{"consolidated", consolidate(cap.cloud).cloud}});
  return figure;
}

/// Even samples of a mesh with the normals of their facets.
Point_cloud oriented_samples(const Triangle_mesh& mesh, std::size_t count)
{
  const Surface_samples samples = sample_surface(mesh, count, 1);
  Point_cloud cloud;
  cloud.points = samples.points;
  for(const std::size_t face : samples.faces)
    cloud.normals.push_back(face_normal(mesh, face));
  return cloud;
}

Figure_result six_holes(const std::string& data)
{
  const Triangle_mesh truth = figure_model(data, "bunny00");
  const Point_cloud all = oriented_samples(truth, 30000);
  // balls around samples that are far from each other, a first one by its index
  std::vector<Vec3> centres = {all.points[7]};
  while(centres.size() < 6) {
    double most = 0;
    Vec3 next = centres[0];
    for(const Vec3& p : all.points) {
      double least = 1;
      for(const Vec3& c : centres)
        least = (std::min)(least, (p - c).norm());
      if(least > most) {
        most = least;
        next = p;
      }
    }
    centres.push_back(next);
  }
  Point_cloud cloud;
  for(std::size_t i = 0; i < all.size(); ++i) {
    bool is_missing = false;
    for(const Vec3& c : centres)
      is_missing = is_missing || (all.points[i] - c).norm() < 0.06;
    if(!is_missing) {
      cloud.points.push_back(all.points[i]);
      cloud.normals.push_back(all.normals[i]);
    }
  }
  Figure_result figure;
  const Judge judge(truth, cloud);
  before_and_after(figure, "bunny with six holes", judge, cloud, {{"consolidated", consolidate(cloud).cloud}});
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

/// The armadillo with points that are displaced at random by up to 2 % of the diagonal, as a share of all.
struct Noisy_armadillo {
  Triangle_mesh truth;
  Point_cloud cloud;
  std::vector<char> is_outlier;  ///< farther than 0.5 % from the surface

  Noisy_armadillo(const std::string& data, double share) : truth(figure_model(data, "armadillo"))
  {
    constexpr std::size_t clean = 30000;
    constexpr double range = 0.02, farther = 0.005;
    const Mesh_tree tree(truth);
    cloud.points = sample_surface(truth, clean, 1).points;
    const auto noisy = std::size_t(share / (1 - share) * double(clean));
    Random_numbers random(3);
    for(const Vec3& p : sample_surface(truth, noisy, 2).points) {
      Vec3 step(1, 1, 1);
      while(step.norm() > 1)
        step = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      cloud.points.push_back(p + range * step);
    }
    for(const Vec3& p : cloud.points)
      is_outlier.push_back((tree.closest(p).point - p).norm() > farther);
  }
};

Figure_result figure_10(const std::string& data)
{
  Figure_result figure;
  Figure_table table{"armadillo, 30000 points and noisy ones within 2 % of the diagonal",
                     {"outliers", "removed", "precision", "recall", "distance before", "distance after",
                      "Poisson before", "Poisson after"},
                     {}};
  for(const double share : {0.05, 0.10, 0.15, 0.20}) {
    const Noisy_armadillo noisy(data, share);
    const Judge judge(noisy.truth);
    const Iterative_run run = consolidate(noisy.cloud);
    double right = 0, all = 0;
    for(const std::size_t i : run.outliers)
      right += noisy.is_outlier[i];
    for(const char is : noisy.is_outlier)
      all += is;
    // the normals of points nobody oriented: estimated and oriented by the same function, without removal
    Iterative_options as_static;
    as_static.iterations = 0;
    as_static.is_static.assign(noisy.cloud.size(), 1);
    const Point_cloud before = consolidate(noisy.cloud, as_static).cloud;
    const Triangle_mesh mesh_before = poisson(before), mesh_after = poisson(run.cloud);
    const std::string percent = std::to_string(int(100 * share)) + " %";
    table.rows.push_back({percent,
                          {all, double(run.outliers.size()), right / (std::max)(1.0, double(run.outliers.size())),
                           right / all, judge.points(before).distance.mean, judge.points(run.cloud).distance.mean,
                           judge.mesh(mesh_before).forward.mean, judge.mesh(mesh_after).forward.mean}});
    support::Panel panel = cloud_panel(percent + " noise, outliers found", noisy.cloud);
    panel.point_colors.assign(noisy.cloud.size(), support::colors::scan);
    for(const std::size_t i : run.outliers)
      panel.point_colors[i] = support::colors::completed;
    figure.panels.push_back(panel);
    figure.panels.push_back(mesh_panel("Poisson before", mesh_before));
    figure.panels.push_back(mesh_panel("Poisson after", mesh_after));
  }
  figure.tables.push_back(table);
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
  Iterative_options two;
  two.two_phases = true;
  Figure_result figure;
  before_and_after(figure, "man, front and back", judge, before,
                   {{"one phase", consolidate(scan.cloud).cloud}, {"two phases", consolidate(scan.cloud, two).cloud}});
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

Figure_result figure_11(const std::string& data)
{
  constexpr unsigned int neighbors = 18;
  Figure_result figure;
  Figure_table table{"share of normals that point inwards", {"CGAL PCA and MST", "this package", "near pairs that disagree"}, {}};
  for(const double noise : {0.0, 0.2, 0.5}) {
    const Triangle_mesh truth = figure_model(data, "bunny00");
    Random_numbers random(4);
    Point_cloud cloud;
    for(const Vec3& p : sample_surface(truth, 20000, 1).points)
      cloud.points.push_back(p + noise / 100 * Vec3(random.normal(), random.normal(), random.normal()));
    std::vector<Oriented_point> pairs;
    for(const Vec3& p : cloud.points)
      pairs.emplace_back(Point(p.x(), p.y(), p.z()), Vector(0, 0, 0));
    const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                        .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
    CGAL::pca_estimate_normals<Tag>(pairs, neighbors, maps);
    CGAL::mst_orient_normals(pairs, neighbors, maps);
    Point_cloud tree;
    for(const Oriented_point& p : pairs) {
      tree.points.push_back(vec3(p.first));
      tree.normals.push_back(vec3(p.second));
    }
    Iterative_options alone;
    alone.iterations = 0;
    alone.is_static.assign(cloud.size(), 1);
    const Iterative_run run = consolidate(cloud, alone);
    const double mst = flipped_share(truth, tree), ours = flipped_share(truth, run.cloud);
    // a tree may turn all points inside out: that is one decision, not an inconsistency
    table.rows.push_back({"bunny, noise " + std::to_string(noise).substr(0, 3) + " %",
                          {(std::min)(mst, 1 - mst), (std::min)(ours, 1 - ours), double(run.inconsistent)}});
  }
  figure.tables.push_back(table);
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
    const Iterative_run run = consolidate(cloud, o);
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

Figure_result table_1(const std::string& data)
{
  struct Class {
    const char* name;
    std::size_t points, particles;
    unsigned int steps;
    bool two_phases;
    double seconds;  ///< the paper's, on one core
  };
  const std::vector<Class> classes = {{"Inukshuk", 205858, 10293, 6, false, 193},
                                      {"Hand", 194457, 38892, 8, false, 679},
                                      {"Lady", 175514, 35103, 2, false, 266},
                                      {"Body", 170346, 8518, 8, true, 911},
                                      {"Seal", 889076, 44454, 2, false, 419}};
  const Triangle_mesh truth = figure_model(data, "bear");
  Figure_result figure;
  Figure_table table{"bear, two views; at most as many steps as in the paper",
                     {"points", "particles", "steps", "seconds", "plain loop", "paper seconds"}, {}};
  support::Plot plot;
  plot.title = "Time of the iterative consolidation";
  plot.y_label = "seconds";
  plot.log_y = true;
  support::Series ours{"this package", {}, {}}, paper{"paper", {}, {}};
  for(const Class& c : classes) {
    Scanner_options options;
    options.views = 2;
    options.points = c.points;
    options.noise = 0.05;
    const Point_cloud cloud = scan_mesh(truth, options).cloud;
    Iterative_options settings;
    settings.particle_fraction = double(c.particles) / double(c.points);
    settings.iterations = c.steps;
    settings.two_phases = c.two_phases;
    const Iterative_run run = consolidate(cloud, settings);
    settings.adaptive = false;
    const Iterative_run plain = consolidate(cloud, settings);
    table.rows.push_back({c.name,
                          {double(cloud.size()), double(c.particles), double(run.iterations), run.seconds,
                           plain.seconds, c.seconds}});
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
    {"iterative_table_1", "times of the classes of table I, adaptive and plain loop", table_1},
  };
}

}  // namespace benchmark
