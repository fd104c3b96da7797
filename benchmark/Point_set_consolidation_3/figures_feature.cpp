// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of the feature-enhanced surfaces paper. Its scans are not public: CGAL's models stand in for them.

#include "cgal_conversion.h"
#include "mesh_tree.h"
#include "methods.h"
#include "models.h"
#include "paper_figure.h"
#include "point_tree.h"
#include "random_numbers.h"
#include "skeleton_runs.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/feature_enhanced_surface_reconstruction.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>

namespace benchmark {

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using CGAL::Point_set_consolidation_3::Anisotropic_formula;
using CGAL::Point_set_consolidation_3::Part_method;
using CGAL::Point_set_consolidation_3::Segmentation_method;
using CGAL::Point_set_consolidation_3::Upsampling_formula;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Mesh = CGAL::Surface_mesh<Point>;
using Tag = CGAL::Parallel_if_available_tag;

auto maps()
{
  return params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
    .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
}
auto cgal_maps()
{
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
    .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
}

std::vector<Oriented_point> to_pairs(const Point_cloud& cloud)
{
  std::vector<Oriented_point> pairs;
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.points[i], n = cloud.normals.empty() ? Vec3(Vec3::Zero()) : cloud.normals[i];
    pairs.emplace_back(Point(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
  }
  return pairs;
}

Point_cloud to_cloud(const std::vector<Oriented_point>& pairs)
{
  Point_cloud cloud;
  for(const Oriented_point& p : pairs) {
    cloud.points.emplace_back(p.first.x(), p.first.y(), p.first.z());
    cloud.normals.emplace_back(p.second.x(), p.second.y(), p.second.z());
  }
  return cloud;
}

/// A CAD part with noise in all directions.
struct Part {
  Triangle_mesh truth;
  Point_cloud cloud;  ///< without normals
  std::vector<Vec3> edges;
  Judge judge;

  Part(const std::string& data, bool even, const std::string& model = "fandisk")
    : truth(load_model({model, "", ""}, data)), edges(sharp_edge_points(truth)), judge(truth)
  {
    constexpr std::size_t count = 20000;
    constexpr double noise = 0.003;
    Random_numbers random(2);
    for(const Vec3& p : sample_surface(truth, even ? count : 2 * count, 1).points) {
      const Vec3 step(random.normal(), random.normal(), random.normal());
      // uneven: every second point is kept where x is positive, every tenth elsewhere
      if(even || random.uniform() < (p.x() > 0 ? 0.9 : 0.1))
        cloud.points.push_back(p + noise * step);
    }
  }

  /// Distances of the points from the surface, of those near sharp edges, and of the edges from the points.
  std::vector<double> measure(const Point_cloud& result) const
  {
    constexpr double near = 0.01;
    const Mesh_tree tree(truth);
    const Point_tree edge_tree(edges), points(result.points);
    std::vector<double> all, at_edges, of_edges;
    for(const Vec3& p : result.points) {
      const double d = 100 * (tree.closest(p).point - p).norm();
      all.push_back(d);
      if(edge_tree.nearest(p).distance < near)
        at_edges.push_back(d);
    }
    for(const Vec3& e : edges)
      of_edges.push_back(100 * points.nearest(e).distance);
    return {mean(all), mean(at_edges), mean(of_edges), judge.points(result).spacing_variation};
  }
};

const std::vector<std::string> part_columns = {"points", "error", "near edges", "edges to points",
                                               "spacing variation"};

Figure_table::Row part_row(const std::string& name, const Part& part, const Point_cloud& cloud)
{
  std::vector<double> values = part.measure(cloud);
  values.insert(values.begin(), double(cloud.size()));
  return {name, values};
}

/// CGAL's way: projection, jet normals, turned to the side of the truth. The support radius is a multiple of
/// 1 / sqrt(n); 4 was the best on the fandisk.
Point_cloud cgal_wlop(const Part& part, double share, bool uniform, double width = 4)
{
  const double radius = width / std::sqrt(double(part.cloud.size()));
  std::vector<Point> points, result;
  for(const Oriented_point& p : to_pairs(part.cloud))
    points.push_back(p.first);
  CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::select_percentage(100 * share).neighbor_radius(radius).require_uniform_sampling(uniform));
  std::vector<Oriented_point> pairs;
  for(const Point& p : result)
    pairs.emplace_back(p, Vector(0, 0, 0));
  constexpr unsigned int neighbors = 18;
  CGAL::jet_estimate_normals<Tag>(pairs, neighbors, cgal_maps());
  Point_cloud cloud = to_cloud(pairs);
  const Mesh_tree tree(part.truth);
  for(std::size_t i = 0; i < cloud.size(); ++i)
    if(cloud.normals[i].dot(tree.closest(cloud.points[i]).normal) < 0)
      cloud.normals[i] *= -1;
  return cloud;
}

Point_cloud anisotropic_wlop(const Part& part, double share, Anisotropic_formula formula)
{
  const std::vector<Oriented_point> points = to_pairs(part.cloud);
  std::vector<Oriented_point> result;
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
    points, std::back_inserter(result),
    params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
      .select_percentage(100 * share)
      .number_of_iterations(20u)
      .anisotropic_formula(formula));
  return to_cloud(result);
}

Figure_result figure_2(const std::string& data)
{
  constexpr double share = 0.25;
  Figure_result figure;
  for(const bool even : {true, false}) {
    const Part part(data, even);
    Figure_table table{
        std::string("fandisk, 0.3 % noise, ") + (even ? "even" : "uneven") + " density", part_columns, {}};
    const auto add = [&](const std::string& name, const Point_cloud& cloud) {
      table.rows.push_back(part_row(name, part, cloud));
      figure.panels.push_back(cloud_panel(name, cloud));
    };
    add("input", part.cloud);
    add("LOP (CGAL)", cgal_wlop(part, share, false));
    add("WLOP (CGAL)", cgal_wlop(part, share, true));
    add("anisotropic, default", anisotropic_wlop(part, share, Anisotropic_formula::SEPARATED));
    add("anisotropic, local sums", anisotropic_wlop(part, share, Anisotropic_formula::LOCAL));
    figure.tables.push_back(table);
  }
  figure.columns = 5;
  return figure;
}

Figure_result figure_3(const std::string& data)
{
  constexpr double share = 0.25;
  constexpr unsigned int smoothing_neighbors = 24;
  constexpr std::size_t dense = 20000;
  const Part part(data, true);
  const Judge judge(part.truth);
  Figure_result figure;
  Figure_table table{"fandisk, 0.3 % noise", part_columns, {}};
  Figure_table meshes{"Poisson of it", mesh_columns(), {}};
  const auto add = [&](const std::string& name, const Point_cloud& cloud) {
    table.rows.push_back(part_row(name, part, cloud));
    const Triangle_mesh mesh = poisson(cloud);
    meshes.rows.push_back({name, mesh_row(judge.mesh(mesh))});
    figure.panels.push_back(cloud_panel(name, cloud));
    figure.panels.push_back(mesh_panel("Poisson of " + name, mesh));
  };
  std::vector<Oriented_point> base = to_pairs(cgal_wlop(part, share, true));
  for(int pass = 0; pass < 3; ++pass)
    CGAL::bilateral_smooth_point_set<Tag>(base, smoothing_neighbors, cgal_maps());
  std::vector<Oriented_point> ear;
  CGAL::edge_aware_upsample_point_set<Tag>(
    base, std::back_inserter(ear),
    cgal_maps().sharpness_angle(25).edge_sensitivity(0.5).number_of_output_points((unsigned int)dense));
  ear.insert(ear.begin(), base.begin(), base.end());  // CGAL returns the new points only
  add("WLOP, bilateral, EAR (CGAL)", to_cloud(ear));
  const auto ours = [&](const std::vector<Oriented_point>& points, Upsampling_formula formula) {
    std::vector<Oriented_point> result;
    CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(
      points, std::back_inserter(result), maps().number_of_output_points(dense).upsampling_formula(formula));
    return to_cloud(result);
  };
  add("same base, ours", ours(base, Upsampling_formula::EDGES));
  const std::vector<Oriented_point> projected =
    to_pairs(anisotropic_wlop(part, share, Anisotropic_formula::SEPARATED));
  add("ours", ours(projected, Upsampling_formula::EDGES));
  add("ours, equation (6) with weights", ours(projected, Upsampling_formula::WEIGHTED));
  figure.tables = {table, meshes};
  figure.columns = 4;
  return figure;
}

/// CGAL's bilateral smoothing and EAR, over a grid of their parameters.
struct Cgal_setting {
  double wlop_width = 0;
  unsigned int neighbors = 0;
  double smoothing_angle = 0;
  int passes = 0;
  double upsampling_angle = 0, edge_sensitivity = 0, radius = 0;  ///< of EAR, radius in spacings

  std::string text() const
  {
    std::ostringstream out;
    out << "WLOP " << wlop_width << ", bilateral " << neighbors << "/" << smoothing_angle << "/" << passes;
    if(radius > 0)
      out << ", EAR " << upsampling_angle << "/" << edge_sensitivity << "/" << radius;
    return out.str();
  }
};

Point_cloud cgal_ear(const Point_cloud& base, const Cgal_setting& setting, double spacing, std::size_t count)
{
  const std::vector<Oriented_point> points = to_pairs(base);
  std::vector<Oriented_point> result;
  CGAL::edge_aware_upsample_point_set<Tag>(points, std::back_inserter(result),
                                           cgal_maps()
                                             .sharpness_angle(setting.upsampling_angle)
                                             .edge_sensitivity(setting.edge_sensitivity)
                                             .neighbor_radius(setting.radius * spacing)
                                             .number_of_output_points((unsigned int)count));
  result.insert(result.begin(), points.begin(), points.end());  // CGAL returns the new points only
  return to_cloud(result);
}

/// Least angle between a point's normal and those of the surface within 0.4 % of it, in degrees: a point on an
/// edge may have the normal of either face, the mean of the two is an error.
double normal_error(const Mesh_tree& tree, const Point_cloud& cloud)
{
  constexpr double degrees = 57.295779513082323;
  constexpr double reach = 0.004;
  std::vector<double> errors;
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    double cosine = std::abs(tree.closest(cloud.points[i]).normal.dot(cloud.normals[i]));
    for(int axis = 0; axis < 3; ++axis)
      for(const double side : {-reach, reach}) {
        const Vec3 beside = cloud.points[i] + side * Vec3::Unit(axis);
        cosine = (std::max)(cosine, std::abs(tree.closest(beside).normal.dot(cloud.normals[i])));
      }
    errors.push_back(degrees * std::acos((std::min)(1.0, cosine)));
  }
  return mean(errors);
}

/// How far a result is from sharp edges: error near them, and distance of the edges from the points.
double edge_error(const std::vector<double>& measured) { return measured[1] + measured[2]; }

/// CGAL's operators at their best settings of a grid, judged with the truth at hand, against ours at the defaults.
/// The grid is where trials over a wider one found the least errors. A radius of WLOP above 4 and more passes of
/// smoothing round the edges. EAR gains at most 2 % at the edges from a radius of 3 spacings, nothing from an edge
/// sensitivity of 1, and both may take minutes, as its radius grows with the largest gap.
Figure_result figure_edges(const std::string& data)
{
  constexpr double share = 0.25;
  constexpr std::size_t dense = 20000;
  Figure_result figure;
  figure.shares_camera = false;
  for(const char* model : {"fandisk", "fandisk_large", "anchor_dense", "joint"}) {
    const Part part(data, true, model);
    const Mesh_tree tree(part.truth);
    std::vector<std::string> columns = part_columns;
    columns.push_back("normals");
    Figure_table table{std::string(model) + ", 0.3 % noise; error of normals in degrees", columns, {}};
    std::vector<double> least(columns.size(), std::numeric_limits<double>::max());
    const auto row = [&](const std::string& name, const Point_cloud& cloud) {
      Figure_table::Row result = part_row(name, part, cloud);
      result.values.push_back(normal_error(tree, cloud));
      return result;
    };
    const auto measured = [&](const Point_cloud& cloud) {
      const Figure_table::Row result = row("", cloud);
      for(std::size_t k = 1; k < least.size(); ++k)
        least[k] = (std::min)(least[k], result.values[k]);
      return edge_error(std::vector<double>(result.values.begin() + 1, result.values.end()));
    };
    const auto add = [&](const std::string& name, const Point_cloud& cloud) {
      table.rows.push_back(row(name, cloud));
      figure.panels.push_back(cloud_panel(std::string(model) + ", " + name, cloud));
    };

    // the best base first, then the best up-sampling of it
    std::size_t settings = 0;
    double best = std::numeric_limits<double>::max();
    Cgal_setting setting, best_setting;
    Point_cloud best_base;
    for(const double width : {3., 4.}) {
      const Point_cloud projected = cgal_wlop(part, share, true, width);
      for(const unsigned int neighbors : {12u, 24u})
        for(const double angle : {15., 30.}) {
          std::vector<Oriented_point> base = to_pairs(projected);
          for(int pass = 1; pass <= 2; ++pass) {
            CGAL::bilateral_smooth_point_set<Tag>(base, neighbors, cgal_maps().sharpness_angle(angle));
            ++settings;
            setting = {width, neighbors, angle, pass, 0, 0, 0};
            const double error = measured(to_cloud(base));
            if(error < best) {
              best = error;
              best_setting = setting;
              best_base = to_cloud(base);
            }
          }
        }
    }
    add("CGAL, " + best_setting.text(), best_base);
    const double spacing = part.judge.points(best_base).spacing / 100;
    best = std::numeric_limits<double>::max();
    Point_cloud best_cloud;
    setting = best_setting;
    for(const double angle : {15., 30.})
      for(const double sensitivity : {0., 0.5}) {
        ++settings;
        setting.upsampling_angle = angle;
        setting.edge_sensitivity = sensitivity;
        setting.radius = 2;
        const Point_cloud cloud = cgal_ear(best_base, setting, spacing, dense);
        const double error = measured(cloud);
        if(error < best) {
          best = error;
          best_setting = setting;
          best_cloud = cloud;
        }
      }
    add("CGAL, " + best_setting.text(), best_cloud);
    least[0] = double(settings);
    table.rows.push_back({"CGAL, least of each column; number of settings", least});

    const Point_cloud projected = anisotropic_wlop(part, share, Anisotropic_formula::SEPARATED);
    add("ours, projected", projected);
    Point_cloud at_edges;
    for(const Upsampling_formula formula : {Upsampling_formula::WEIGHTED, Upsampling_formula::EDGES}) {
      std::vector<Oriented_point> upsampled;
      CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(
        to_pairs(projected), std::back_inserter(upsampled),
        maps().number_of_output_points(dense).upsampling_formula(formula));
      at_edges = to_cloud(upsampled);
      add(formula == Upsampling_formula::WEIGHTED ? "ours, up-sampled" : "ours, up-sampled onto edges", at_edges);
    }
    figure.panels.push_back(mesh_panel("Poisson of CGAL's", poisson(best_cloud)));
    figure.panels.push_back(mesh_panel("Poisson of ours", poisson(at_edges)));
    figure.tables.push_back(table);
  }
  figure.columns = 7;
  return figure;
}

std::vector<std::size_t> segments_of(const std::vector<Vec3>& positions, Segmentation_method method,
                                     std::size_t count)
{
  std::vector<std::pair<Point, std::size_t>> points;
  for(const Vec3& p : positions)
    points.emplace_back(Point(p.x(), p.y(), p.z()), 0);
  using Labelled_point = std::pair<Point, std::size_t>;
  CGAL::density_peak_segment_point_set<Tag>(
    points, CGAL::Second_of_pair_property_map<Labelled_point>(),
    params::point_map(CGAL::First_of_pair_property_map<Labelled_point>())
      .segmentation_method(method)
      .number_of_segments(count));
  std::vector<std::size_t> labels;
  for(const Labelled_point& p : points)
    labels.push_back(p.second);
  return labels;
}

/// Adjusted Rand index: 1 for equal partitions, 0 in the mean for random ones.
double rand_index(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
  const auto pairs = [](double n) { return n * (n - 1) / 2; };
  std::map<std::pair<std::size_t, std::size_t>, double> both;
  std::map<std::size_t, double> first, second;
  for(std::size_t i = 0; i < a.size(); ++i) {
    ++both[{a[i], b[i]}];
    ++first[a[i]];
    ++second[b[i]];
  }
  double together = 0, in_first = 0, in_second = 0;
  for(const auto& cell : both)
    together += pairs(cell.second);
  for(const auto& cell : first)
    in_first += pairs(cell.second);
  for(const auto& cell : second)
    in_second += pairs(cell.second);
  const double expected = in_first * in_second / pairs(double(a.size()));
  const double most = 0.5 * (in_first + in_second);
  return most > expected ? (together - expected) / (most - expected) : 1;
}

support::Panel segments_panel(const std::string& title, const std::vector<Vec3>& points,
                              const std::vector<std::size_t>& labels)
{
  support::Panel panel;
  panel.title = title;
  panel.cloud.points = points;
  for(const std::size_t label : labels)
    panel.point_colors.push_back(label_color(label));
  return panel;
}

Figure_result figure_4(const std::string& data)
{
  constexpr std::size_t count = 10000;
  Figure_result figure;
  figure.shares_camera = false;
  Figure_table table{"adjusted Rand index, number of segments found",
                     {"parts", "density peaks", "segments", "persistence", "segments", "skeleton", "segments"}, {}};
  const std::vector<std::pair<std::string, Segmentation_method>> methods = {
    {"density peaks", Segmentation_method::DENSITY_PEAKS},
    {"persistence", Segmentation_method::PERSISTENCE},
    {"skeleton", Segmentation_method::SKELETON}};
  for(const auto& [name, parts] : assembled_shapes()) {
    const std::vector<Vec3> points = synthetic::samples(synthetic::united(parts), count, 1);
    std::vector<std::size_t> truth;
    for(const Vec3& p : points) {
      std::size_t nearest = 0;
      for(std::size_t k = 1; k < parts.size(); ++k)
        if(std::abs(parts[k].distance(p)) < std::abs(parts[nearest].distance(p)))
          nearest = k;
      truth.push_back(nearest);
    }
    table.rows.push_back({name, {double(parts.size())}});
    for(const auto& method : methods) {
      const std::vector<std::size_t> labels = segments_of(points, method.second, 0);
      table.rows.back().values.push_back(rand_index(truth, labels));
      table.rows.back().values.push_back(double(1 + *std::max_element(labels.begin(), labels.end())));
      figure.panels.push_back(segments_panel(name + ", " + method.first, points, labels));
    }
  }
  for(const char* name : {"armadillo", "man"}) {
    const std::vector<Vec3> points = even_samples(figure_model(data, name), count);
    table.rows.push_back({name, {std::nan("")}});
    for(const auto& method : methods) {
      const std::vector<std::size_t> labels = segments_of(points, method.second, 0);
      table.rows.back().values.push_back(std::nan(""));
      table.rows.back().values.push_back(double(1 + *std::max_element(labels.begin(), labels.end())));
      figure.panels.push_back(segments_panel(std::string(name) + ", " + method.first, points, labels));
    }
  }
  figure.tables.push_back(table);
  figure.columns = 6;
  return figure;
}

Figure_result figure_5(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  Figure_table table{"L1-medial skeletons", {"components", "cycles", "tips", "inside", "coverage", "seconds"}, {}};
  const auto add = [&](const std::string& name, const Judge& judge, const std::vector<Vec3>& points,
                       const Skeleton_run& run) {
    const Skeleton_verdict verdict = judge.skeleton(run.graph);
    table.rows.push_back({name,
                          {double(run.components), double(run.cycles), double(run.tips), verdict.inside,
                           verdict.coverage, run.seconds}});
    Point_cloud cloud;
    cloud.points = points;
    support::Panel panel = graph_panel(name, run.graph, cloud);
    panel.point_radius = 0.0012;
    panel.segment_radius = 0.006;
    figure.panels.push_back(panel);
  };
  std::vector<std::pair<std::string, Triangle_mesh>> models;
  for(const auto& shape : assembled_shapes())
    if(shape.first == "creature")
      models.emplace_back(shape.first, normalized(shape_mesh(synthetic::united(shape.second), 120)));
  models.emplace_back("man", figure_model(data, "man"));
  for(const auto& [name, truth] : models) {
    const std::vector<Vec3> points = even_samples(truth, 5000);
    const Judge judge(truth);
    const std::vector<std::size_t> segments = segments_of(points, Segmentation_method::SKELETON, 0);
    add(name + ", whole", judge, points, l1_medial_skeleton(points));
    add(name + ", per segment", judge, points, l1_medial_skeleton(points, segments));
    add(name + ", Laplacian", judge, points, laplacian_skeleton(points, {}));
  }
  figure.tables.push_back(table);
  figure.columns = 3;
  return figure;
}

/// The whole pipeline; `methods` of the parts in the order of the segments, empty: automatic.
Triangle_mesh feature_enhanced(const Point_cloud& cloud, const support::Segment_graph& graph,
                               const std::vector<Part_method>& methods)
{
  const std::vector<Oriented_point> points = to_pairs(cloud);
  auto skeleton = support::to_skeleton<CGAL::Curve_skeleton_3<Kernel> >(graph);
  Mesh mesh;
  CGAL::feature_enhanced_surface_reconstruction<Tag>(
    points, skeleton, mesh, maps().segment_methods(methods).grid_resolution(std::size_t(96)));
  return support::to_triangle_mesh(mesh);
}

Figure_result figure_7(const std::string& data)
{
  Figure_result figure;
  figure.shares_camera = false;
  const std::vector<std::pair<std::string, double>> scans = {{"man", 0}, {"armadillo", 0}, {"refined_elephant", 0},
                                                             {"bear", 0}, {"cow", 0}, {"man", 0.3}, {"armadillo", 0.3}};
  for(const auto& [model, noise] : scans) {
    const Triangle_mesh truth = figure_model(data, model);
    Scanner_options options;
    options.views = 3;
    options.points = 40000;
    options.noise = noise;
    const Scan scan = scan_mesh(truth, options);
    const Judge judge(truth, truth_cloud(scan));
    const Method_result direct = method_called("direct").run(scan.cloud);
    Point_cloud cloud;
    cloud.points = direct.points;
    cloud.normals = direct.normals;
    Figure_table table{model + ", three views" + (noise > 0 ? ", 0.3 % noise" : "") + "; no edits of the skeleton",
                       mesh_columns(), {}};
    const auto add = [&](const std::string& name, const Triangle_mesh& mesh) {
      table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
      figure.panels.push_back(mesh_panel(name, mesh));
    };
    const Skeleton_run skeleton = laplacian_skeleton(cloud.points, cloud.normals);
    support::Panel panel = graph_panel("skeleton", skeleton.graph, scan.cloud);
    panel.point_radius = 0.001;
    figure.panels.push_back(panel);
    add("Poisson", poisson(cloud));
    add("skeleton-driven", skeleton_driven_mesh(cloud.points, skeleton.graph));
    add("feature-enhanced", feature_enhanced(cloud, {}, {}));
    figure.tables.push_back(table);
  }
  figure.columns = 4;
  return figure;
}

Figure_result figure_8(const std::string&)
{
  // a creature of which the middle of the body, half of a leg and the tail were not scanned
  const auto shapes = assembled_shapes();
  const synthetic::Shape shape = synthetic::united(shapes[2].second);
  const Triangle_mesh truth = normalized(shape_mesh(shape, 160));
  const Triangle_mesh raw = shape_mesh(shape, 160);
  const double scale =
    (truth.vertices[1] - truth.vertices[0]).norm() / (raw.vertices[1] - raw.vertices[0]).norm();
  const Vec3 shift = truth.vertices[0] - scale * raw.vertices[0];
  Point_cloud cloud;
  for(const Vec3& p : synthetic::samples(shape, 20000, 1)) {
    const bool is_missing = std::abs(p.x()) < 0.3 || (p.z() < -0.6 && p.z() > -1 && p.x() > 0 && p.y() > 0) ||
                            (p.x() < -1.6 && p.x() > -2);
    if(!is_missing) {
      cloud.points.push_back(scale * p + shift);
      cloud.normals.push_back(shape.normal(p));
    }
  }
  // its axes, as an editor would leave them
  support::Segment_graph axes;
  const auto chain = [&](std::size_t from, const Vec3& to, double radius) {
    constexpr int pieces = 6;
    const Vec3 start = axes.vertices[from], end = scale * to + shift;
    std::size_t before = from;
    for(int k = 1; k <= pieces; ++k) {
      axes.vertices.push_back(start + double(k) / pieces * (end - start));
      axes.radius.push_back(scale * radius);
      axes.edges.push_back({before, axes.vertices.size() - 1});
      before = axes.vertices.size() - 1;
    }
    return before;
  };
  axes.vertices.push_back(scale * Vec3(-1, 0, 0) + shift);
  axes.radius.push_back(scale * 0.45);
  const std::size_t rear = chain(0, Vec3(-0.8, 0, 0), 0.45), front = chain(rear, Vec3(0.8, 0, 0), 0.45);
  const std::size_t neck = chain(front, Vec3(1.2, 0, 0.2), 0.2);
  chain(neck, Vec3(1.8, 0, 0.9), 0.2);
  for(const double y : {-0.5, 0.5}) {
    chain(rear, Vec3(-0.9, y, -1.2), 0.13);
    chain(front, Vec3(0.9, y, -1.2), 0.13);
  }
  chain(0, Vec3(-2.2, 0, 0.5), 0.08);
  const Judge judge(truth, cloud);
  Figure_result figure;
  figure.up = Vec3::UnitZ();
  figure.view = Vec3(-0.3, 1, -0.4);
  Figure_table table{"creature with gaps", mesh_columns(), {}};
  figure.panels.push_back(cloud_panel("points", cloud));
  figure.panels.push_back(graph_panel("axes", axes));
  const auto add = [&](const std::string& name, const Triangle_mesh& mesh) {
    table.rows.push_back({name, mesh_row(judge.mesh(mesh))});
    figure.panels.push_back(mesh_panel(name, mesh));
  };
  constexpr std::size_t many = 64;
  add("Poisson", poisson(cloud));
  add("all parts from data", feature_enhanced(cloud, axes, std::vector<Part_method>(many, Part_method::DATA)));
  add("all along the axes", feature_enhanced(cloud, axes, std::vector<Part_method>(many, Part_method::SKELETON)));
  add("automatic", feature_enhanced(cloud, axes, {}));
  figure.tables.push_back(table);

  // table I: how many edits the extracted skeleton needs
  std::vector<std::string> columns = mesh_columns();
  columns.insert(columns.begin(), {"edits", "skeleton's components"});
  Figure_table strokes{"its extracted skeleton", columns, {}};
  auto skeleton = support::to_skeleton<CGAL::Curve_skeleton_3<Kernel>>(
    laplacian_skeleton(cloud.points, cloud.normals).graph);
  const auto add_edited = [&](const std::string& name, std::size_t edits) {
    const support::Segment_graph graph = support::to_segment_graph(skeleton);
    const Triangle_mesh mesh = feature_enhanced(cloud, graph, {});
    std::vector<double> values = mesh_row(judge.mesh(mesh));
    values.insert(values.begin(), {double(edits), double(CGAL::number_of_skeleton_components(skeleton))});
    strokes.rows.push_back({name, values});
    figure.panels.push_back(graph_panel(name, graph, cloud));
    figure.panels.push_back(mesh_panel(name, mesh));
  };
  add_edited("as extracted", 0);
  constexpr double short_branch = 0.04, widest_gap = 0.3;
  CGAL::Curve_skeleton_editing::prune_spurs(skeleton, short_branch);
  const std::size_t bridges = CGAL::Curve_skeleton_editing::bridge_components(skeleton, widest_gap);
  add_edited("spurs pruned, gaps bridged", 1 + bridges);
  figure.tables.push_back(strokes);
  figure.columns = 3;
  return figure;
}

}  // namespace

std::vector<Paper_figure> feature_figures()
{
  return {
    {"feature_figure_2", "figures 1 and 2: LOP against the anisotropic projection", figure_2},
    {"feature_figure_3", "edge-aware up-sampling: EAR against the anisotropic one", figure_3},
    {"feature_edges", "sharp edges: CGAL's operators at the best of many settings against ours", figure_edges},
    {"feature_figure_4", "segments", figure_4},
    {"feature_figure_5", "curve skeletons of a whole and of its segments", figure_5},
    {"feature_figure_7", "an incomplete scan: Poisson, skeleton-driven, the whole pipeline", figure_7},
    {"feature_figure_8", "figures 6 and 8: parts reconstructed by different methods", figure_8},
  };
}

}  // namespace benchmark
