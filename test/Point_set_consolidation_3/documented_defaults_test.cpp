// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The defaults that the reference manual documents are those of the code: a call with the documented values, read
// from the headers' comments, does the same as a call without them, bit for bit, and with any other value it does
// not. Every documented default that is a value must be stated here. The names of the parameters are those of
// parameters.h, and all are in the manual's list.
//
//   documented_defaults_test INCLUDE_FOLDER DOC_FOLDER

#undef NDEBUG

#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/apss_project_point_set.h>
#include <CGAL/bilateral_project_point_set.h>
#include <CGAL/deep_points_consolidate_point_set.h>
#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>
#include <CGAL/feature_enhanced_surface_reconstruction.h>
#include <CGAL/interpolatory_upsample_point_set.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/mean_shift_remove_outliers.h>
#include <CGAL/meso_skeleton_to_graph.h>
#include <CGAL/property_map.h>
#include <CGAL/repulse_along_apss.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>
#include <CGAL/wlop_project_point_set.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace pkg = CGAL::Point_set_consolidation_3;
namespace params = pkg::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Oriented_points = std::vector<Oriented_point>;
using Tag = CGAL::Parallel_if_available_tag;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point>;
using Result = std::vector<double>;
using Values = std::map<std::string, double>;

std::string include_folder, doc_folder;
int failures = 0;

void expect(bool condition, const std::string& what)
{
  if(condition)
    return;
  std::cerr << "FAILED: " << what << '\n';
  ++failures;
}

std::string read_file(const std::string& name)
{
  std::ifstream in(name);
  expect(bool(in), name + " cannot be read");
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// ---- what the manual says ----

const std::map<std::string, double> words = {
  {"true", 1}, {"false", 0},
  {"Data_term::FULL", double(pkg::Data_term::FULL)},
  {"Prior::VOLUME_PRESERVING", double(pkg::Prior::VOLUME_PRESERVING)},
  {"Laplacian_weights::COTANGENT", double(pkg::Laplacian_weights::COTANGENT)},
  {"Anisotropic_formula::SEPARATED", double(pkg::Anisotropic_formula::SEPARATED)},
  {"Upsampling_formula::WEIGHTED", double(pkg::Upsampling_formula::WEIGHTED)},
  {"Segmentation_method::SKELETON", double(pkg::Segmentation_method::SKELETON)},
  {"Part_method::AUTOMATIC", double(pkg::Part_method::AUTOMATIC)}};

// All values in a default's text, in their order: numbers, Booleans, enumerators.
std::vector<double> values_in(const std::string& text)
{
  static const std::regex token("[A-Za-z_][A-Za-z_0-9]*(::[A-Z_a-z]+)?|[0-9]+(\\.[0-9]+)?");
  std::vector<double> values;
  for(std::sregex_iterator it(text.begin(), text.end(), token), end; it != end; ++it) {
    const auto word = words.find(it->str());
    if(word != words.end())
      values.push_back(word->second);
    else if(std::isdigit(static_cast<unsigned char>(it->str()[0])))
      values.push_back(std::stod(it->str()));
  }
  return values;
}

// Whether a default is a value rather than a description.
bool is_value(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  const std::string word = text.substr(0, text.find_first_of(" :;,"));
  const bool is_word = words.count(text.substr(0, text.find_first_of(" ;,"))) > 0;
  return is_word || words.count(word) > 0 ||
         (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0])));
}

// The text in braces that begins at `begin`, the position after the opening one.
std::string braced(const std::string& text, std::size_t begin)
{
  int depth = 1;
  std::size_t end = begin;
  for(; end < text.size() && depth > 0; ++end)
    depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
  return text.substr(begin, end - begin - 1);
}

// The documented defaults of a function, by parameter.
std::map<std::string, std::string> documented_defaults(const std::string& header,
                                                       const std::string& function)
{
  const std::string text = read_file(include_folder + "/CGAL/" + header);
  std::map<std::string, std::string> defaults;
  for(std::size_t open = text.find("/*!"); open != std::string::npos; open = text.find("/*!", open + 1)) {
    const std::size_t close = text.find("*/", open), body = text.find("\n{", close);
    const std::string comment = text.substr(open, close - open);
    const std::string signature = text.substr(close, body - close);
    if(!std::regex_search(signature, std::regex("[ \n]" + function + "\\(")) ||
       comment.find("cgalParamNBegin") == std::string::npos)
      continue;
    const std::string begin = "\\cgalParamNBegin{", key = "\\cgalParamDefault{";
    for(std::size_t p = comment.find(begin); p != std::string::npos; p = comment.find(begin, p + 1)) {
      const std::size_t end = comment.find("\\cgalParamNEnd", p), d = comment.find(key, p);
      if(d < end)
        defaults[braced(comment, p + begin.size())] = braced(comment, d + key.size());
    }
    return defaults;
  }
  expect(false, header + " documents no function " + function);
  return defaults;
}

// ---- the comparison ----

// A parameter, which of the values in its text is the default, the unit it is given in, and another value. A parameter
// without another value (not-a-number) has no effect on the data of the test.
struct Parameter {
  std::string name;
  double other;
  std::size_t index = 0;
  double unit = 1;
};
const double no_effect = std::nan("");

class Function {
public:
  Function(const std::string& header, const std::string& name)
    : m_name(name), m_documented(documented_defaults(header + ".h", name))
  {
    for(const auto& [parameter, text] : m_documented)
      if(is_value(text))
        m_left.insert(parameter);
  }
  ~Function()
  {
    for(const std::string& parameter : m_left)
      expect(false, m_name + ": the default of " + parameter + " is not tested: " + m_documented[parameter]);
    std::cout << m_name << ": " << m_tested << " defaults\n";
  }

  // `plain`: the result of a call without the parameters; `with`: of one with the given values.
  template <typename Plain, typename With>
  void check(const std::vector<Parameter>& parameters, const Plain& plain, const With& with)
  {
    Values values;
    for(const Parameter& p : parameters)
      values[p.name] = documented(p);
    const Result result = plain();
    expect(!result.empty(), m_name + " has no result");
    expect(result == with(values), m_name + " with the documented values differs from the defaults");
    for(const Parameter& p : parameters) {
      if(std::isnan(p.other))
        continue;
      Values changed = values;
      changed[p.name] = p.other;
      expect(result != with(changed), m_name + ": " + p.name + " has no effect, so that its default is not tested");
    }
    m_tested += parameters.size();
  }

  double documented(const Parameter& p)
  {
    m_left.erase(p.name);
    const std::vector<double> values = values_in(m_documented[p.name]);
    if(values.size() <= p.index) {
      expect(false, m_name + ": " + p.name + " has no documented value");
      return 1;
    }
    return values[p.index] * p.unit;
  }

private:
  std::string m_name;
  std::map<std::string, std::string> m_documented;
  std::set<std::string> m_left;
  std::size_t m_tested = 0;
};

// ---- results as numbers ----

void append(Result& result, const Point& p) { result.insert(result.end(), {p.x(), p.y(), p.z()}); }

Result numbers(const Oriented_points& points)
{
  Result result;
  for(const Oriented_point& p : points) {
    append(result, p.first);
    append(result, CGAL::ORIGIN + p.second);
  }
  return result;
}
Result numbers(const std::vector<Point>& points)
{
  Result result;
  for(const Point& p : points)
    append(result, p);
  return result;
}
Result numbers(const Skeleton& skeleton)
{
  Result result;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    append(result, skeleton[v].point);
    result.push_back(skeleton[v].radius);
  }
  return result;
}
Result numbers(const Mesh& mesh)
{
  Result result;
  for(const auto v : mesh.vertices())
    append(result, mesh.point(v));
  return result;
}

// ---- data ----

// Part of a ring with noise, normals, and outliers if wanted.
Oriented_points ring(std::size_t count, double part, double noise, std::size_t outliers)
{
  CGAL::Random random(5);
  Oriented_points points;
  while(points.size() < count) {
    const double u = random.get_double(0, part), v = random.get_double(0, 6.2831853);
    const Vector n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    points.emplace_back(Point(std::cos(u), std::sin(u), 0) + (0.3 + random.get_double(-noise, noise)) * n, n);
  }
  for(std::size_t i = 0; i < outliers; ++i)
    points.emplace_back(Point(3 + 0.1 * double(i), 0.2 * double(i % 3), 1), Vector(0, 0, 1));
  return points;
}

// A noisy box with normals.
Oriented_points box(std::size_t count)
{
  CGAL::Random random(6);
  Oriented_points points;
  while(points.size() < count) {
    const int axis = random.get_int(0, 3);
    const double side = random.get_bool() ? 1 : -1;
    double x[3], n[3] = {0, 0, 0};
    for(double& c : x)
      c = random.get_double(-1, 1);
    x[axis] = side + random.get_double(-0.01, 0.01);
    n[axis] = side;
    points.emplace_back(Point(x[0], x[1], x[2]), Vector(n[0], n[1], n[2]));
  }
  return points;
}

double spacing(const Oriented_points& points)
{
  pkg::internal::Points copy;
  for(const Oriented_point& p : points)
    copy.emplace_back(p.first.x(), p.first.y(), p.first.z());
  const auto execution = pkg::internal::make_execution<CGAL::Sequential_tag>();
  return pkg::internal::data_frame(execution, copy, copy.size()).unit;
}

const auto positions = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>());
const auto maps = positions.normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());

// ---- the functions ----

void deep_points()
{
  Function f("deep_points_consolidate_point_set", "deep_points_consolidate_point_set");
  const Oriented_points points = ring(1200, 4, 0.005, 0);
  const auto run = [&](const auto& np) {
    std::vector<CGAL::Deep_point_3<Kernel> > deep;
    CGAL::deep_points_consolidate_point_set<Tag>(points, std::back_inserter(deep), np);
    Oriented_points outer;
    for(const auto& p : deep)
      outer.emplace_back(p.outer(), p.inner() - CGAL::ORIGIN);
    return numbers(outer);
  };
  const auto base = positions.number_of_output_points(500);
  f.check({{"number_of_iterations", 5}, {"require_uniform_sampling", 0}, {"collision_angle", 60},
           {"smoothing_radius", 3}, {"collision_radius", 3}, {"closing_step", 0}, {"skeleton_repulsion", 0.1},
           {"axis_epsilon", 0.5}, {"number_of_skeleton_iterations", 3}, {"surface_repulsion", 0.1},
           {"number_of_surface_iterations", 10}, {"completed_spacing", no_effect}, {"denoise_along_rays", no_effect},
           {"detect_outliers", no_effect}, {"data_term", 1}, {"prior", 1}},
          [&] { return run(base); },
          [&](Values v) {
            return run(base.number_of_iterations(unsigned(v["number_of_iterations"]))
                         .require_uniform_sampling(v["require_uniform_sampling"] != 0)
                         .collision_angle(v["collision_angle"])
                         .smoothing_radius(v["smoothing_radius"])
                         .collision_radius(v["collision_radius"])
                         .closing_step(v["closing_step"] != 0)
                         .skeleton_repulsion(v["skeleton_repulsion"])
                         .axis_epsilon(v["axis_epsilon"])
                         .number_of_skeleton_iterations(std::size_t(v["number_of_skeleton_iterations"]))
                         .surface_repulsion(v["surface_repulsion"])
                         .number_of_surface_iterations(std::size_t(v["number_of_surface_iterations"]))
                         .completed_spacing(v["completed_spacing"])
                         .denoise_along_rays(v["denoise_along_rays"] != 0)
                         .detect_outliers(v["detect_outliers"] != 0)
                         .data_term(pkg::Data_term(int(v["data_term"])))
                         .prior(pkg::Prior(int(v["prior"]))));
          });
  // "5 % of the input, at least 4000"
  const double percentage = f.documented({"number_of_output_points", 0, 0});
  const double least = f.documented({"number_of_output_points", 0, 1});
  for(const std::size_t count : {std::size_t(least) + 50, std::size_t(least / percentage * 100) + 200}) {
    const Oriented_points many = ring(count, 4, 0.005, 0);
    CGAL::Deep_points_consolidation_3<Kernel, Tag> consolidation(many, positions.number_of_iterations(1u));
    consolidation.consolidate_input();
    const double wanted = (std::max)(least, std::floor(percentage / 100 * double(count) + 0.5));
    expect(consolidation.size() == std::size_t(wanted), "number_of_output_points of deep points");
  }
}

void iterative()
{
  Function f("iterative_consolidate_point_set", "iterative_consolidate_point_set");
  const Oriented_points points = ring(6000, 4, 0.01, 12);
  const auto run_on = [](const Oriented_points& input, const auto& np) {
    Oriented_points output;
    CGAL::iterative_consolidate_point_set<Tag>(input, std::back_inserter(output), np);
    return numbers(output);
  };
  const auto run = [&](const auto& np) { return run_on(points, np); };
  const auto with = [&](const auto& base, Values v) {
    return run(base.number_of_iterations(unsigned(v["number_of_iterations"]))
                 .adaptive(v["adaptive"] != 0)
                 .two_phases(v["two_phases"] != 0)
                 .repulsion_weight(v["repulsion_weight"])
                 .number_of_repulsion_steps(unsigned(v["number_of_repulsion_steps"]))
                 .minimum_spacing(v["minimum_spacing"])
                 .far_outlier_distance(v["far_outlier_distance"])
                 .completion_guard(v["completion_guard"] != 0)
                 .hole_fairing(v["hole_fairing"] != 0)
                 .printed_values(v["printed_values"] != 0)
                 .particle_fraction(v["particle_fraction"])
                 .orientation_is_hint(v["orientation_is_hint"] != 0)
                 .random_seed(unsigned(v["random_seed"])));
  };
  f.check({{"particle_fraction", no_effect}, {"number_of_iterations", no_effect}, {"adaptive", no_effect},
           {"two_phases", no_effect}, {"repulsion_weight", no_effect}, {"number_of_repulsion_steps", no_effect},
           {"minimum_spacing", no_effect}, {"far_outlier_distance", 50}, {"completion_guard", no_effect},
           {"hole_fairing", no_effect}, {"printed_values", no_effect}, {"random_seed", no_effect},
           {"orientation_is_hint", 1}},
          [&] { return run(maps); }, [&](const Values& v) { return with(maps, v); });
  // without the guards points are added, so that all parameters count
  const auto unguarded = maps.completion_guard(false);
  f.check({{"particle_fraction", 0.2}, {"number_of_iterations", 0}, {"adaptive", no_effect}, {"two_phases", 1},
           {"repulsion_weight", 0.2}, {"number_of_repulsion_steps", 3}, {"minimum_spacing", 0.2},
           {"far_outlier_distance", 50}, {"hole_fairing", no_effect}, {"printed_values", no_effect},
           {"random_seed", 1}, {"orientation_is_hint", 1}},
          [&] { return run(unguarded); },
          [&](Values v) {
            v["completion_guard"] = 0;
            return with(unguarded, v);
          });
  // a hole that is filled
  Oriented_points open = box(6000);
  open.erase(std::remove_if(open.begin(), open.end(),
                            [](const Oriented_point& p) {
                              return CGAL::squared_distance(p.first, Point(0, 0, 1)) < 0.25;
                            }),
             open.end());
  f.check({{"hole_fairing", 0}}, [&] { return run_on(open, maps); },
          [&](Values v) { return run_on(open, maps.hole_fairing(v["hole_fairing"] != 0)); });
}

void operators()
{
  const Oriented_points points = ring(1500, 4, 0.01, 12);
  {
    Function f("mean_shift_remove_outliers", "mean_shift_remove_outliers");
    const auto run = [&](const auto& np) {
      Oriented_points output;
      CGAL::mean_shift_remove_outliers<Tag>(points, std::back_inserter(output), np);
      return numbers(output);
    };
    f.check({{"k_neighbors", 5}, {"number_of_iterations", no_effect}, {"shift_threshold", 1}},
            [&] { return run(positions); },
            [&](Values v) {
              return run(positions.k_neighbors(unsigned(v["k_neighbors"]))
                           .number_of_iterations(unsigned(v["number_of_iterations"]))
                           .shift_threshold(v["shift_threshold"]));
            });
  }
  {
    Function f("wlop_project_point_set", "wlop_project_point_set");
    const Oriented_points many = ring(8000, 4, 0.01, 0);
    const auto run = [&](const auto& np) {
      std::vector<Point> output;
      CGAL::wlop_project_point_set<Tag>(many, std::back_inserter(output), np);
      return numbers(output);
    };
    f.check({{"particle_fraction", 0.2}, {"repulsion_weight", 0.2}, {"number_of_iterations", 3}, {"random_seed", 1}},
            [&] { return run(positions); },
            [&](Values v) {
              return run(positions.particle_fraction(v["particle_fraction"])
                           .repulsion_weight(v["repulsion_weight"])
                           .number_of_iterations(unsigned(v["number_of_iterations"]))
                           .random_seed(unsigned(v["random_seed"])));
            });
  }
  const Oriented_points clean = ring(600, 4, 0.002, 0);
  {
    Function f("repulse_along_apss", "repulse_along_apss");
    const auto run = [&](const auto& np) {
      Oriented_points moved = clean;
      CGAL::repulse_along_apss<Tag>(moved, np);
      return numbers(moved);
    };
    f.check({{"repulsion_weight", 0.2}, {"number_of_repulsion_steps", 3}, {"number_of_projections", 2},
             {"printed_values", 1}},
            [&] { return run(maps); },
            [&](Values v) {
              return run(maps.repulsion_weight(v["repulsion_weight"])
                           .number_of_repulsion_steps(unsigned(v["number_of_repulsion_steps"]))
                           .number_of_projections(unsigned(v["number_of_projections"]))
                           .printed_values(v["printed_values"] != 0));
            });
  }
  {
    Function f("interpolatory_upsample_point_set", "interpolatory_upsample_point_set");
    const double h = 0.4;
    const auto run = [&](const auto& np) {
      Oriented_points output;
      CGAL::interpolatory_upsample_point_set<Tag>(clean, std::back_inserter(output), np);
      return numbers(output);
    };
    f.check({{"minimum_spacing", 0.08, 0, h}}, [&] { return run(maps.neighbor_radius(h)); },
            [&](Values v) { return run(maps.neighbor_radius(h).minimum_spacing(v["minimum_spacing"])); });
  }
  const double unit = spacing(clean);
  const auto in_place = [&](Function& f, const auto& project, const std::vector<Parameter>& list, const auto& with) {
    const auto run = [&](const auto& np) {
      Oriented_points moved = clean;
      project(moved, np);
      return numbers(moved);
    };
    f.check(list, [&] { return run(maps); }, [&](Values v) { return run(with(v)); });
  };
  {
    Function f("apss_project_point_set", "apss_project_point_set");
    in_place(f, [](auto& p, const auto& np) { CGAL::apss_project_point_set<Tag>(p, np); },
             {{"neighbor_radius", 3 * unit, 0, unit}, {"number_of_iterations", 1}}, [](Values& v) {
               return maps.neighbor_radius(v["neighbor_radius"])
                 .number_of_iterations(unsigned(v["number_of_iterations"]));
             });
  }
  {
    Function f("bilateral_project_point_set", "bilateral_project_point_set");
    in_place(f, [](auto& p, const auto& np) { CGAL::bilateral_project_point_set<Tag>(p, np); },
             {{"neighbor_radius", 2 * unit, 0, unit}, {"number_of_iterations", 1}, {"sharpness_angle", 40}},
             [](Values& v) {
               return maps.neighbor_radius(v["neighbor_radius"])
                 .sharpness_angle(v["sharpness_angle"])
                 .number_of_iterations(unsigned(v["number_of_iterations"]));
             });
  }
}

void features()
{
  const Oriented_points points = box(1500);
  {
    Function f("anisotropic_wlop_simplify_and_regularize_point_set",
               "anisotropic_wlop_simplify_and_regularize_point_set");
    const auto run = [&](const auto& np) {
      Oriented_points output;
      CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(points, std::back_inserter(output), np);
      return numbers(output);
    };
    const auto with = [&](Values v) {
      return run(maps.select_percentage(v["select_percentage"])
                   .anisotropic_formula(pkg::Anisotropic_formula(int(v["anisotropic_formula"])))
                   .repulsion_weight(v["repulsion_weight"])
                   .sharpness_angle(v["sharpness_angle"])
                   .number_of_iterations(unsigned(v["number_of_iterations"]))
                   .enhance_features(v["enhance_features"] != 0)
                   .random_seed(std::uint64_t(v["random_seed"])));
    };
    f.check({{"select_percentage", 10}, {"anisotropic_formula", double(pkg::Anisotropic_formula::LOCAL)},
             {"repulsion_weight", 0.4, 1}, {"sharpness_angle", 5}, {"number_of_iterations", 3},
             {"enhance_features", 0}, {"random_seed", 1}},
            [&] { return run(maps); }, with);
    // the printed forms have other defaults
    f.check({{"select_percentage", 10}, {"repulsion_weight", 0.1, 0}, {"sharpness_angle", no_effect},
             {"number_of_iterations", 3}, {"enhance_features", 1, 1}, {"random_seed", 1}},
            [&] { return run(maps.anisotropic_formula(pkg::Anisotropic_formula::LOCAL)); },
            [&](Values v) {
              v["anisotropic_formula"] = double(pkg::Anisotropic_formula::LOCAL);
              return with(v);
            });
  }
  {
    Function f("anisotropic_edge_aware_upsample_point_set", "anisotropic_edge_aware_upsample_point_set");
    const double unit = spacing(points);
    const auto run = [&](const auto& np) {
      Oriented_points output;
      CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(points, std::back_inserter(output), np);
      return numbers(output);
    };
    f.check({{"upsampling_formula", double(pkg::Upsampling_formula::EDGES)}, {"neighbor_radius", 2 * unit, 0, unit},
             {"sharpness_angle", 60}, {"edge_sensitivity", 0}},
            [&] { return run(maps); },
            [&](Values v) {
              return run(maps.upsampling_formula(pkg::Upsampling_formula(int(v["upsampling_formula"])))
                           .neighbor_radius(v["neighbor_radius"])
                           .sharpness_angle(v["sharpness_angle"])
                           .edge_sensitivity(v["edge_sensitivity"]));
            });
  }
  {
    Function f("anisotropic_edge_aware_upsample_point_set", "optimize_normals_across_edges");
    const auto run = [&](const auto& np) {
      Oriented_points moved = points;
      CGAL::optimize_normals_across_edges<Tag>(moved, np);
      return numbers(moved);
    };
    f.check({{"sharpness_angle", 5}, {"enhance_features", 1}}, [&] { return run(maps); },
            [&](Values v) {
              return run(maps.sharpness_angle(v["sharpness_angle"]).enhance_features(v["enhance_features"] != 0));
            });
  }
}

void segments()
{
  Function f("density_peak_segment_point_set", "density_peak_segment_point_set");
  using Labelled = std::pair<Point, int>;
  std::vector<Labelled> points;  // two balls of different size, and a stick between them
  CGAL::Random random(8);
  while(points.size() < 2500) {
    Vector d(random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1));
    d = d / std::sqrt(d.squared_length());
    const int part = random.get_int(0, 3);
    const double x = random.get_double(0.3, 2.5);
    points.emplace_back(part == 0   ? CGAL::ORIGIN + d
                        : part == 1 ? Point(3, 0, 0) + 0.6 * d
                                    : Point(x, 0.15 * std::cos(9 * x + 6 * d.y()), 0.15 * std::sin(9 * x + 6 * d.y())),
                        0);
  }
  const double diagonal = [&] {
    pkg::internal::Points copy;
    for(const Labelled& p : points)
      copy.emplace_back(p.first.x(), p.first.y(), p.first.z());
    return pkg::internal::bounding_box(copy).diagonal();
  }();
  const auto run = [&](const auto& np) {
    std::vector<Labelled> labelled = points;
    const std::size_t count = CGAL::density_peak_segment_point_set<Tag>(
      labelled, CGAL::Second_of_pair_property_map<Labelled>(), np);
    Result result{double(count)};
    for(const Labelled& p : labelled)
      result.push_back(p.second);
    return result;
  };
  const auto base = params::point_map(CGAL::First_of_pair_property_map<Labelled>());
  const auto with = [&](Values v) {
    return run(base.number_of_segments(std::size_t(v["number_of_segments"]))
                 .segmentation_method(pkg::Segmentation_method(int(v["segmentation_method"])))
                 .neighbor_radius(v["neighbor_radius"])
                 .prominence(v["prominence"])
                 .variation_penalty(v["variation_penalty"]));
  };
  f.check({{"number_of_segments", 2}, {"segmentation_method", double(pkg::Segmentation_method::DENSITY_PEAKS)},
           {"neighbor_radius", no_effect, 0, diagonal}, {"prominence", no_effect}, {"variation_penalty", 50}},
          [&] { return run(base); }, with);
  f.check({{"number_of_segments", 7}, {"neighbor_radius", 0.03 * diagonal, 0, diagonal}, {"prominence", 3},
           {"variation_penalty", no_effect}},
          [&] { return run(base.segmentation_method(pkg::Segmentation_method::PERSISTENCE)); },
          [&](Values v) {
            v["segmentation_method"] = double(pkg::Segmentation_method::PERSISTENCE);
            return with(v);
          });
}

void skeletons()
{
  const Oriented_points points = ring(900, 4, 0.005, 0);
  {
    Function f("extract_l1_medial_skeleton", "extract_l1_medial_skeleton");
    const auto run = [&](const auto& np) {
      Skeleton skeleton;
      CGAL::extract_l1_medial_skeleton<Tag>(points, skeleton, np);
      return numbers(skeleton);
    };
    f.check({{"number_of_samples", 200}, {"repulsion_weight", 0.1}, {"number_of_iterations", 2},
             {"sampling_radius", 0.1}, {"largest_merged_cycle", no_effect}, {"extend_tips", 0},
             {"random_seed", no_effect}},
            [&] { return run(positions); },
            [&](Values v) {
              return run(positions.number_of_samples(std::size_t(v["number_of_samples"]))
                           .repulsion_weight(v["repulsion_weight"])
                           .number_of_iterations(std::size_t(v["number_of_iterations"]))
                           .sampling_radius(v["sampling_radius"])
                           .largest_merged_cycle(std::size_t(v["largest_merged_cycle"]))
                           .extend_tips(v["extend_tips"] != 0)
                           .random_seed(std::uint64_t(v["random_seed"])));
            });
  }
  Function f("extract_laplacian_contraction_skeleton", "extract_laplacian_contraction_skeleton");
  const auto run = [&](const auto& np) {
    Skeleton skeleton;
    CGAL::extract_laplacian_contraction_skeleton<Tag>(points, skeleton, np);
    return numbers(skeleton);
  };
  const double share = f.documented({"k_neighbors", 0, 0}), least = f.documented({"k_neighbors", 0, 1}),
               most = f.documented({"k_neighbors", 0, 2});
  const double k = std::clamp(std::floor(share * double(points.size()) + 0.5), least, most);
  f.check({{"number_of_samples", 400}, {"laplacian_weights", double(pkg::Laplacian_weights::COMBINATORIAL)},
           {"contraction_weight", 3}, {"attraction_weight", 3}, {"contraction_factor", 2},
           {"convergence_threshold", 0.5}, {"number_of_iterations", 1}, {"sampling_radius", 0.1},
           {"largest_merged_cycle", no_effect}, {"extend_tips", 0}, {"random_seed", no_effect}},
          [&] { return run(positions); },
          [&](Values v) {
            return run(positions.k_neighbors(std::size_t(k))
                         .number_of_samples(std::size_t(v["number_of_samples"]))
                         .laplacian_weights(pkg::Laplacian_weights(int(v["laplacian_weights"])))
                         .contraction_weight(v["contraction_weight"])
                         .attraction_weight(v["attraction_weight"])
                         .contraction_factor(v["contraction_factor"])
                         .convergence_threshold(v["convergence_threshold"])
                         .number_of_iterations(std::size_t(v["number_of_iterations"]))
                         .sampling_radius(v["sampling_radius"])
                         .largest_merged_cycle(std::size_t(v["largest_merged_cycle"]))
                         .extend_tips(v["extend_tips"] != 0)
                         .random_seed(std::uint64_t(v["random_seed"])));
          });
}

void surfaces()
{
  const Oriented_points points = ring(900, 4, 0.005, 0);
  Skeleton skeleton;  // along the axis
  for(int i = 0; i <= 20; ++i) {
    CGAL::Curve_skeleton_editing::add_vertex(skeleton, Point(std::cos(0.2 * i), std::sin(0.2 * i), 0), 0.3);
    if(i > 0)
      add_edge(std::size_t(i) - 1, std::size_t(i), skeleton);
  }
  {
    Function f("skeleton_driven_surface_reconstruction", "skeleton_driven_surface_reconstruction");
    const auto run = [&](const auto& np) {
      Mesh mesh;
      CGAL::skeleton_driven_surface_reconstruction<Tag>(points, skeleton, mesh, np);
      return numbers(mesh);
    };
    f.check({{"grid_resolution", 24}, {"adaptive", no_effect}, {"smoothness_weight", 3}, {"surface_weight", 5},
             {"skeleton_weight", 5}, {"outside_weight", 0.05}, {"outside_factor", 2}},
            [&] { return run(positions); },
            [&](Values v) {
              return run(positions.grid_resolution(std::size_t(v["grid_resolution"]))
                           .adaptive(v["adaptive"] != 0)
                           .smoothness_weight(v["smoothness_weight"])
                           .surface_weight(v["surface_weight"])
                           .skeleton_weight(v["skeleton_weight"])
                           .outside_weight(v["outside_weight"])
                           .outside_factor(v["outside_factor"]));
            });
    f.check({{"adaptive", 0}}, [&] { return run(positions.grid_resolution(24)); },
            [&](Values v) { return run(positions.grid_resolution(24).adaptive(v["adaptive"] != 0)); });
  }
  Function f("feature_enhanced_surface_reconstruction", "feature_enhanced_surface_reconstruction");
  const auto run = [&](const auto& np) {
    Mesh mesh;
    Skeleton extracted;
    CGAL::feature_enhanced_surface_reconstruction<Tag>(points, extracted, mesh, np);
    return numbers(mesh);
  };
  const auto base = maps.enhance_features(true);
  f.check({{"sharpness_angle", 5}, {"upsampling_factor", 2}, {"number_of_segments", no_effect},
           {"segmentation_method", no_effect}, {"grid_resolution", 24}, {"surface_weight", 5},
           {"normal_weight", 1}},
          [&] { return run(base); },
          [&](Values v) {
            return run(base.sharpness_angle(v["sharpness_angle"])
                         .upsampling_factor(v["upsampling_factor"])
                         .number_of_segments(std::size_t(v["number_of_segments"]))
                         .segmentation_method(pkg::Segmentation_method(int(v["segmentation_method"])))
                         .grid_resolution(std::size_t(v["grid_resolution"]))
                         .surface_weight(v["surface_weight"])
                         .normal_weight(v["normal_weight"]));
          });
  f.check({{"enhance_features", 1}}, [&] { return run(maps.grid_resolution(24)); },
          [&](Values v) { return run(maps.grid_resolution(24).enhance_features(v["enhance_features"] != 0)); });
  f.documented({"segment_methods", 0});

  // values that are none of the enumerators are errors that name the parameter
  const auto rejects = [&](const auto& np, const std::string& name) {
    try {
      run(np);
      return false;
    }
    catch(const std::invalid_argument& error) {
      return std::string(error.what()).find(name) != std::string::npos;
    }
  };
  assert(rejects(base.segmentation_method(pkg::Segmentation_method(3)), "segmentation_method"));
  const std::vector<pkg::Part_method> unknown = {pkg::Part_method::DATA, pkg::Part_method(3)};
  assert(rejects(base.segment_methods(unknown), "segment_methods"));
}

void meso_skeletons()
{
  Function f("meso_skeleton_to_graph", "meso_skeleton_to_graph");
  const Oriented_points points = ring(1200, 4, 0.005, 0);
  CGAL::Deep_points_consolidation_3<Kernel, Tag> consolidation(points, maps.number_of_output_points(500));
  const auto numbers_of = [](const CGAL::Meso_skeleton_3<Kernel>& meso) { return numbers(meso.graph); };
  f.check({{"sampling_radius", 0.1}, {"largest_merged_cycle", no_effect}, {"curves_only", 1}},
          [&] {
            CGAL::Meso_skeleton_3<Kernel> meso;
            CGAL::meso_skeleton_to_graph(consolidation, meso);
            return numbers_of(meso);
          },
          [&](Values v) {
            CGAL::Meso_skeleton_3<Kernel> meso;
            CGAL::meso_skeleton_to_graph(consolidation, meso,
                                         params::sampling_radius(v["sampling_radius"])
                                           .largest_merged_cycle(std::size_t(v["largest_merged_cycle"]))
                                           .curves_only(v["curves_only"] != 0));
            return numbers_of(meso);
          });
}

// ---- names ----

void names()
{
  const std::string header = read_file(include_folder + "/CGAL/Point_set_consolidation_3/parameters.h");
  const std::string list = read_file(doc_folder + "/named_parameters.txt");
  std::set<std::string> declared;
  const std::regex line("\n +X\\((?:\\w+_t, )?(\\w+)\\)");
  for(std::sregex_iterator it(header.begin(), header.end(), line), end; it != end; ++it)
    declared.insert((*it)[1]);
  expect(declared.size() > 50, "the names in parameters.h are not found");
  for(const std::string& name : declared)
    expect(list.find('`' + name + '`') != std::string::npos, name + " is not in named_parameters.txt");
  const std::regex listed("\n\\| `(\\w+)`");
  for(std::sregex_iterator it(list.begin(), list.end(), listed), end; it != end; ++it)
    expect(declared.count((*it)[1]) > 0, (*it)[1].str() + " of named_parameters.txt is not in parameters.h");
}

}  // namespace

int main(int argc, char* argv[])
{
  if(argc != 3) {
    std::cerr << "usage: documented_defaults_test INCLUDE_FOLDER DOC_FOLDER\n";
    return 1;
  }
  include_folder = argv[1];
  doc_folder = argv[2];
  names();
  deep_points();
  iterative();
  operators();
  features();
  segments();
  skeletons();
  meso_skeletons();
  surfaces();
  std::cout << (failures == 0 ? "all documented defaults are those of the code\n" : "") << std::flush;
  return failures == 0 ? 0 : 1;
}
