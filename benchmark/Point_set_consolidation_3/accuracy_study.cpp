// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Models x scans x methods: how far reconstructions are from the truth.

#include "arguments.h"
#include "child_processes.h"
#include "judge.h"
#include "methods.h"
#include "models.h"
#include "picture.h"
#include "plot.h"
#include "point_file.h"
#include "study_table.h"
#include "virtual_scanner.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace benchmark;
namespace fs = std::filesystem;

namespace {

const char* const usage =
    R"(accuracy_study [options]
Scans ground truth meshes, reconstructs them by each method and measures the error. Writes into --out:
rows.csv (every run), cases.csv (means over the seeds), report.md (summary, then all cases, losses first) and plots.
  --data DIR        CGAL's data (environment variable CGAL_DATA_DIR)
  --models LIST     names, or groups tuning, check, extra, all (tuning,check)
  --specs LIST      noise c (clean), n (0.5 %) or h (2 %), then the number of views, then p for a perspective
                    camera, then o for 2 % of outliers (c1,c2,c3,n1,n2,n3,h1,h2,h3)
  --methods LIST    (all)
  --seeds N         scans per model and spec, whose errors are averaged (1)
  --reference NAME  method that ratios refer to (direct)
  --jobs N          processes (1)
  --cache DIR       keeps the results of methods that do not depend on the package from run to run
  --pictures DIR    writes every mesh and scan there, and a picture of each case
  --timeout N       seconds for one reconstruction (600)
  --out DIR         (accuracy_study_results)
  --quick           three models, two specs
)";

/// Percent of the diagonal per letter.
double noise_of(char letter)
{
  switch(letter) {
    case 'c': return 0.0;
    case 'n': return 0.5;
    case 'h': return 2.0;
    default: throw Usage_error(std::string("unknown noise '") + letter + "' in a spec");
  }
}

Scanner_options scanner_options(const std::string& spec, std::uint64_t seed)
{
  Scanner_options options;
  if(spec.size() < 2)
    throw Usage_error("a spec is a letter and a number, not '" + spec + "'");
  options.noise = noise_of(spec[0]);
  std::string views = spec.substr(1);
  const auto ends_with = [&](char letter) {
    const bool found = !views.empty() && views.back() == letter;
    if(found)
      views.pop_back();
    return found;
  };
  options.outliers = ends_with('o') ? 2 : 0;
  options.perspective = ends_with('p');
  if(views.empty() || views.find_first_not_of("0123456789") != std::string::npos
     || std::stoul(views) == 0) {
    throw Usage_error("a spec is a letter and a number, not '" + spec + "'");
  }
  options.views = std::stoul(views);
  options.points = 10000 * (options.views + 1);  // 20k, 30k, 40k for 1, 2, 3 views
  options.seed = seed;
  return options;
}

struct Settings {
  std::string data;
  std::vector<Method> methods;
  fs::path out, cache, pictures;
  unsigned int timeout;
};

struct Case {
  Model model;
  std::string spec;
  std::uint64_t seed;

  std::string name() const { return model.name + "_" + spec + "_" + std::to_string(seed); }
};

/// Where a run leaves its row: with the cache if it may be kept.
fs::path row_file(const Settings& settings, const Case& c, const Method& method)
{
  const std::string name = c.name() + "_" + method.name;
  if(method.baseline && !settings.cache.empty()) {
    return settings.cache / (name + "_" + baseline_settings + ".csv");
  }
  return settings.out / "rows" / (name + ".csv");
}

fs::path mesh_file(const Settings& settings, const Case& c, const Method& method)
{
  return settings.pictures / (c.name() + "_" + method.name + ".ply");
}

fs::path scan_file(const Settings& settings, const Case& c)
{
  return settings.pictures / (c.name() + "_scan.ply");
}

bool read_row(const fs::path& file, Study_row& row)
{
  std::ifstream in(file);
  std::string line;
  if(!std::getline(in, line))
    return false;
  try {
    row = from_csv(line);
  } catch(const std::exception&) {
    return false;  // written by another version
  }
  return true;
}

void write_row(const fs::path& file, const Study_row& row)
{
  const fs::path unfinished = file.string() + ".part";
  std::ofstream(unfinished) << to_csv(row) << "\n";
  fs::rename(unfinished, file);
}

bool is_kept(const Settings& settings, const Case& c, const Method& method)
{
  Study_row row;
  return method.baseline && !settings.cache.empty() && read_row(row_file(settings, c, method), row)
         && (settings.pictures.empty()
             || (fs::exists(mesh_file(settings, c, method)) && fs::exists(scan_file(settings, c))));
}

double seconds_since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<double> run_method(const Settings& settings, const Case& c, const Method& method,
                               const Scan& scan, const Judge& judge)
{
  auto begin = std::chrono::steady_clock::now();
  const Method_result result = method.run(scan.cloud);
  const double seconds_method = seconds_since(begin);
  begin = std::chrono::steady_clock::now();
  const Triangle_mesh mesh = reconstruct(result);
  const double seconds_mesh = seconds_since(begin);
  if(!settings.pictures.empty())
    support::write_mesh(mesh_file(settings, c, method).string(), mesh);
  return study_values(judge.mesh(mesh), result.points.size(), seconds_method, seconds_mesh);
}

/// One scan, all methods that are still to be run on it, each in a process of its own.
void run_case(const Settings& settings, const Case& c)
{
  std::vector<Method> pending;
  for(const Method& method : settings.methods) {
    if(is_kept(settings, c, method))
      continue;
    fs::remove(row_file(settings, c, method));
    pending.push_back(method);
  }
  if(pending.empty())
    return;
  const Triangle_mesh truth = load_model(c.model, settings.data);
  const Scan scan = scan_mesh(truth, scanner_options(c.spec, c.seed));
  const Judge judge(truth, truth_cloud(scan));
  if(!settings.pictures.empty()) {
    support::write_point_cloud(scan_file(settings, c).string(), scan.cloud);
  }
  for(const Method& method : pending) {
    Study_row row;
    row.model = c.model.name;
    row.spec = c.spec;
    row.method = method.name;
    row.seed = c.seed;
    const fs::path file = row_file(settings, c, method);
    const auto task = [&] {
      row.values = run_method(settings, c, method, scan, judge);
      write_row(file, row);
    };
    row.error = run_in_child(task, settings.timeout);
    if(!row.error.empty())
      write_row(file, row);
    read_row(file, row);
    std::cerr << c.model.name << " " << c.spec << " seed " << c.seed << " " << method.name << ": ";
    if(row.failed()) {
      std::cerr << row.error << "\n";
    } else {
      std::cerr << row.value("forward_mean") << " / " << row.value("reverse_mean") << " ("
                << row.value("seconds_method") << " + " << row.value("seconds_mesh") << " s)\n";
    }
  }
}

void write_table(const fs::path& file, const std::vector<Study_row>& rows)
{
  std::ofstream out(file);
  out << csv_header() << "\n";
  for(const Study_row& row : rows)
    out << to_csv(row) << "\n";
  if(!out.flush())
    throw support::File_error(file.string() + ": cannot be written");
}

/// Share of the truth within a distance of the result, all models of a spec together, and the ratios of all specs.
void write_plots(const Settings& settings, const std::vector<std::string>& specs,
                 const std::vector<Study_row>& means, const std::string& reference)
{
  support::Plot ratios;
  ratios.title = "Error by that of " + reference + ", geometric mean over the models";
  ratios.y_label = "ratio, truth to mesh";
  ratios.categories = specs;
  for(const Method& method : settings.methods) {
    if(method.name == reference)
      continue;
    support::Series series;
    series.name = method.name;
    for(const std::string& spec : specs) {
      series.y.push_back(mean_ratio(means, spec, method.name, reference, "forward_mean"));
    }
    ratios.series.push_back(series);
  }
  if(!ratios.series.empty())
    support::write_plot((settings.out / "ratios.svg").string(), ratios);

  for(const std::string& spec : specs) {
    support::Plot distribution;
    distribution.title = "Distance of the truth from the result, " + spec;
    distribution.x_label = "percent of the diagonal";
    distribution.y_label = "share of the truth's surface";
    for(const Method& method : settings.methods) {
      std::vector<double> distances;
      for(const Study_row& row : means) {
        if(row.spec != spec || row.method != method.name || row.failed())
          continue;
        for(const std::string& column : study_columns()) {
          if(column.rfind("forward_q", 0) == 0)
            distances.push_back(row.value(column));
        }
      }
      if(!distances.empty())
        distribution.series.push_back(support::cumulative_distribution(method.name, distances));
    }
    distribution.log_x = true;
    if(!distribution.series.empty()) {
      support::write_plot((settings.out / ("distribution_" + spec + ".svg")).string(),
                          distribution);
    }
  }
}

/// Truth, scan and the meshes of all methods, seen from between the scanned and the hidden side.
void write_picture(const Settings& settings, const Case& c)
{
  const Vec3 into_the_scene = -Vec3(-0.4, 0.35, 1.0).normalized();
  std::vector<support::Panel> panels(2);
  panels[0].title = "truth: " + c.model.name;
  panels[0].mesh = load_model(c.model, settings.data);
  panels[1].title = "scan " + c.spec;
  panels[1].cloud = support::read_point_cloud(scan_file(settings, c).string());
  for(const Method& method : settings.methods) {
    const std::string file = mesh_file(settings, c, method).string();
    if(!fs::exists(file))
      continue;
    support::Panel panel;
    panel.title = method.name;
    panel.mesh = support::read_mesh(file);
    panels.push_back(panel);
  }
  support::write_panels((settings.pictures / (c.name() + ".png")).string(), panels, into_the_scene);
}

void run(const Arguments& arguments)
{
  if(!arguments.files().empty())
    throw Usage_error("unexpected '" + arguments.files()[0] + "'");
  const bool quick = arguments.has("--quick");
  Settings settings;
  settings.data = data_folder(arguments.text("--data"));
  settings.out = arguments.text("--out", "accuracy_study_results");
  settings.cache = arguments.text("--cache");
  settings.pictures = arguments.text("--pictures");
  settings.timeout = static_cast<unsigned int>(arguments.count("--timeout", 600));
  const std::vector<Model> chosen = select_models(
      arguments.list("--models", quick ? std::vector<std::string>{"armadillo", "fandisk", "knot1"}
                                       : std::vector<std::string>{"tuning", "check"}));
  const std::vector<std::string> specs = arguments.list(
      "--specs",
      quick ? std::vector<std::string>{"c1", "n2"}
            : std::vector<std::string>{"c1", "c2", "c3", "n1", "n2", "n3", "h1", "h2", "h3"});
  if(arguments.has("--methods")) {
    for(const std::string& name : arguments.list("--methods"))
      settings.methods.push_back(method_called(name));
  } else {
    settings.methods = methods();
  }
  const std::size_t seeds = arguments.count("--seeds", 1);
  const std::size_t jobs = arguments.count("--jobs", 1);
  if(seeds == 0 || jobs == 0)
    throw Usage_error("--seeds and --jobs are at least 1");
  for(const std::string& spec : specs)
    scanner_options(spec, 1);
  fs::create_directories(settings.out / "rows");
  if(!settings.cache.empty())
    fs::create_directories(settings.cache);
  if(!settings.pictures.empty())
    fs::create_directories(settings.pictures);

  std::vector<Case> cases;
  for(const std::string& spec : specs) {
    for(const Model& model : chosen) {
      for(std::size_t seed = 1; seed <= seeds; ++seed)
        cases.push_back({model, spec, seed});
    }
  }
  run_in_children(cases.size(), jobs, [&](std::size_t i) {
    run_case(settings, cases[i]);
    if(!settings.pictures.empty())
      write_picture(settings, cases[i]);
  });

  std::vector<Study_row> rows;
  for(const Case& c : cases) {
    for(const Method& method : settings.methods) {
      Study_row row;
      if(!read_row(row_file(settings, c, method), row)) {
        row = {c.model.name, c.spec, method.name, c.seed, "not run", {}};
      }
      rows.push_back(row);
    }
  }
  const std::vector<Study_row> means = mean_over_seeds(rows);
  write_table(settings.out / "rows.csv", rows);
  write_table(settings.out / "cases.csv", means);
  const std::string reference = arguments.text("--reference", "direct");
  const std::string report = markdown_report(means, reference);
  write_plots(settings, specs, means, reference);
  std::ofstream(settings.out / "report.md") << "# Accuracy study\n\n" << report;
  std::cout << report;
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program("accuracy_study", usage, argc, argv,
                                {"--data", "--models", "--specs", "--methods", "--seeds", "--reference",
                                 "--jobs", "--cache", "--pictures", "--timeout", "--out"},
                                {"--quick"}, run);
}
