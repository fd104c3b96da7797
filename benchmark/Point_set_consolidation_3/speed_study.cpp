// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time and memory of the package's operators and CGAL's on the same input in the same run.

#include "arguments.h"
#include "child_processes.h"
#include "models.h"
#include "point_tree.h"
#include "speed_operators.h"
#include "virtual_scanner.h"

#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

using namespace benchmark;

namespace {

const char* const usage =
    R"(speed_study [options]
Runs operators of CGAL and of the package on virtual scans (three views, 0.1 % noise) and writes speed.csv and
speed.md into --out, stages.csv with the stages of the package's operators. Each operator runs in a process of its own,
one at a time.
  --data DIR         CGAL's data (environment variable CGAL_DATA_DIR)
  --model NAME       (armadillo)
  --sizes LIST       numbers of points (20000,100000)
  --operators LIST   words that occur in their names (all)
  --classes LIST     instead: the rows of the papers' tables of times whose names contain a word, deep (table 1 of
                     the deep points) or iterative (table I of the iterative consolidation) for all of one; writes
                     classes.md
  --sequential       no parallel versions
  --repeat N         takes the fastest of N runs (1)
  --timeout N        seconds for one operator (300)
  --out DIR          (speed_study_results)
)";

struct Measurement {
  std::string error;
  double cpu_seconds = 0.0;
  double wall_seconds = 0.0;
  double megabytes = 0.0;  ///< peak above the input
  std::vector<Stage_record> stages;
};

Speed_input make_input(const std::string& data, const std::string& model, std::size_t size)
{
  Scanner_options options;
  options.views = 3;
  options.points
      = size
        + size / 50;  // the scanner meets the number within a percent or so; the rest is dropped
  options.noise = 0.1;
  const Scan scan = scan_mesh(load_model(select_models({model}).front(), data), options);
  Speed_input input;
  const std::size_t count = std::min(size, scan.cloud.size());
  const double step = static_cast<double>(scan.cloud.size()) / static_cast<double>(count);
  for(std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(step * static_cast<double>(k));
    input.points.push_back(scan.cloud.points[i]);
    input.normals.push_back(scan.true_normals[i]);
    input.directions.push_back(scan.cloud.directions[i]);
    input.views.push_back(scan.cloud.views[i]);
  }
  input.spacing = average_spacing(input.points);
  return input;
}

/// Memory that parent and child share: the child's stopwatch as the parent sees it.
class Shared_stopwatch {
public:
  Shared_stopwatch()
  {
    void* memory = mmap(nullptr, sizeof(Stopwatch), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if(memory == MAP_FAILED)
      throw std::runtime_error("no shared memory");
    m_watch = new (memory) Stopwatch;
  }
  ~Shared_stopwatch() { munmap(m_watch, sizeof(Stopwatch)); }  // what the child allocated is not ours
  Shared_stopwatch(const Shared_stopwatch&) = delete;
  Shared_stopwatch& operator=(const Shared_stopwatch&) = delete;
  Stopwatch& operator*() { return *m_watch; }
  Stopwatch* operator->() { return m_watch; }

private:
  Stopwatch* m_watch;
};

Measurement measure(const std::function<void(Stopwatch&)>& run, std::size_t repeat, unsigned int timeout)
{
  Measurement best;
  for(std::size_t i = 0; i < repeat; ++i) {
    Shared_stopwatch watch;
    best.error = run_in_child([&] { run(*watch); }, timeout);
    if(!best.error.empty())
      return best;
    if(i == 0 || watch->cpu_seconds < best.cpu_seconds) {
      best.cpu_seconds = watch->cpu_seconds;
      best.wall_seconds = watch->wall_seconds;
      best.megabytes = std::max(0.0, watch->megabytes);
      best.stages.assign(watch->stages.begin(), watch->stages.begin() + std::ptrdiff_t(watch->number_of_stages));
    }
  }
  return best;
}

std::string fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// Results by name (with "parallel" if so) and size.
using Table = std::map<std::string, std::map<std::size_t, Measurement>>;

std::string key_of(const std::string& name, bool parallel)
{
  return name + (parallel ? " (parallel)" : "");
}

/// e in seconds ~ n^e, from the smallest to the largest size that was measured.
std::string growth(const std::map<std::size_t, double>& seconds)
{
  if(seconds.size() < 2)
    return "-";
  const auto& [first_size, first] = *seconds.begin();
  const auto& [last_size, last] = *seconds.rbegin();
  return fixed(std::log(last / first)
                   / std::log(static_cast<double>(last_size) / static_cast<double>(first_size)),
               2);
}

std::string growth(const std::map<std::size_t, Measurement>& row)
{
  std::map<std::size_t, double> seconds;
  for(const auto& [size, result] : row)
    if(result.error.empty() && result.cpu_seconds > 0.0)
      seconds[size] = result.cpu_seconds;
  return growth(seconds);
}

/// The end of a table's head: a column for each size, and the growth.
std::string size_columns(const std::vector<std::size_t>& sizes)
{
  std::ostringstream out;
  for(std::size_t size : sizes)
    out << " " << size << " |";
  out << " growth |\n|---|---|";
  for(std::size_t i = 0; i < sizes.size(); ++i)
    out << "---|";
  out << "---|\n";
  return out.str();
}

/// Wall seconds and peak memory of each stage.
std::string stage_report(const std::vector<Speed_operator>& operators, const std::vector<std::size_t>& sizes,
                         const Table& table)
{
  std::ostringstream out;
  out << "\nStages: wall seconds / peak memory above the input in MB. Growth: e in wall time ~ n^e.\n\n"
      << "| operator | stage |";
  out << size_columns(sizes);
  for(const Speed_operator& op : operators) {
    const auto row = table.find(key_of(op.name, op.parallel));
    if(row == table.end())
      continue;
    std::vector<std::string> names;
    for(const auto& cell : row->second)
      for(const Stage_record& stage : cell.second.stages)
        if(std::find(names.begin(), names.end(), stage.name.data()) == names.end())
          names.emplace_back(stage.name.data());
    for(const std::string& name : names) {
      out << "| " << row->first << " | " << name << " |";
      std::map<std::size_t, double> seconds;
      for(std::size_t size : sizes) {
        const auto cell = row->second.find(size);
        const Stage_record* found = nullptr;
        if(cell != row->second.end())
          for(const Stage_record& stage : cell->second.stages)
            found = name == stage.name.data() ? &stage : found;
        if(found == nullptr) {
          out << " - |";
          continue;
        }
        if(found->seconds > 0.0)
          seconds[size] = found->seconds;
        out << " " << fixed(found->seconds, 3) << " / " << fixed(found->megabytes, 0) << " |";
      }
      out << " " << growth(seconds) << " |\n";
    }
  }
  return out.str();
}

std::string report(const std::vector<Speed_operator>& operators,
                   const std::vector<std::size_t>& sizes, const Table& table)
{
  std::ostringstream out;
  out << "CPU seconds (all threads) / wall seconds / peak memory above the input in MB; in "
         "brackets the CPU seconds by "
         "those of the operator of CGAL\nthat it is compared with (less is faster). Growth: e in "
         "CPU time ~ n^e.\n\n";
  out << "| operator | compared with |";
  out << size_columns(sizes);
  for(const Speed_operator& op : operators) {
    const auto row = table.find(key_of(op.name, op.parallel));
    if(row == table.end())
      continue;
    out << "| " << row->first << " | " << op.counterpart << " |";
    for(std::size_t size : sizes) {
      const auto cell = row->second.find(size);
      if(cell == row->second.end()) {
        out << " - |";
        continue;
      }
      const Measurement& result = cell->second;
      if(!result.error.empty()) {
        out << " " << result.error << " |";
        continue;
      }
      out << " " << fixed(result.cpu_seconds, 3) << " / " << fixed(result.wall_seconds, 3) << " / "
          << fixed(result.megabytes, 0);
      const auto other_row = table.find(op.counterpart);
      if(other_row != table.end()) {
        const auto other = other_row->second.find(size);
        if(other != other_row->second.end() && other->second.error.empty()) {
          out << " (" << fixed(result.cpu_seconds / other->second.cpu_seconds, 2) << ")";
        }
      }
      out << " |";
    }
    out << " " << growth(row->second) << " |\n";
  }
  return out.str();
}

/// Rows of the papers' tables of times, on models of as many points.
void run_classes(const Arguments& arguments, const std::string& data, const std::filesystem::path& folder,
                 std::size_t repeat, unsigned int timeout)
{
  struct Method {
    const char* name;
    Class_method method;
    const std::vector<Paper_class>* classes;
  };
  const std::vector<std::string> words = arguments.list("--classes");
  std::ostringstream out;
  out << "| table | row | model | points | particles | s, one thread | MB | s, all threads | paper s |\n"
         "|---|---|---|---|---|---|---|---|---|\n";
  for(const Method& method : {Method{"deep", Class_method::deep_points, &deep_points_classes()},
                              Method{"iterative", Class_method::iterative, &iterative_classes()}})
    for(const Paper_class& row : *method.classes) {
      const bool is_chosen = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return word == method.name || std::string(row.name).find(word) != std::string::npos;
      });
      if(!is_chosen)
        continue;
      const Speed_input input = make_input(data, row.model, row.points);
      const auto measured = [&](bool parallel) {
        return measure([&](Stopwatch& watch) { run_class(method.method, row, parallel, input, watch); }, repeat,
                       timeout);
      };
      const Measurement one = measured(false);
      const Measurement all = arguments.has("--sequential") ? Measurement{"-", 0, 0, 0, {}} : measured(true);
      const auto seconds = [](const Measurement& m) {
        return m.error.empty() ? fixed(m.wall_seconds, 2) : m.error;
      };
      out << "| " << method.name << " | " << row.name << " | " << row.model << " | " << input.points.size() << " | "
          << row.particles << " | " << seconds(one) << " | " << fixed(one.megabytes, 0) << " | " << seconds(all)
          << " | " << fixed(row.wlop_seconds + row.seconds, 1) << " |\n";
      std::cerr << row.name << ": " << seconds(one) << " s, " << seconds(all) << " s\n";
    }
  std::ofstream(folder / "classes.md") << "# Classes of the papers' tables\n\n" << out.str();
  std::cout << out.str();
}

void run(const Arguments& arguments)
{
  if(!arguments.files().empty())
    throw Usage_error("unexpected '" + arguments.files()[0] + "'");
  const std::string data = data_folder(arguments.text("--data"));
  const std::filesystem::path folder = arguments.text("--out", "speed_study_results");
  const std::size_t repeat = std::max<std::size_t>(1, arguments.count("--repeat", 1));
  const auto timeout = static_cast<unsigned int>(arguments.count("--timeout", 300));
  std::vector<std::size_t> sizes;
  for(const std::string& word : arguments.list("--sizes", {"20000", "100000"})) {
    if(word.find_first_not_of("0123456789") != std::string::npos || std::stoul(word) == 0) {
      throw Usage_error("--sizes needs numbers of points, not '" + word + "'");
    }
    sizes.push_back(std::stoul(word));
  }
  std::filesystem::create_directories(folder);
  if(arguments.has("--classes")) {
    run_classes(arguments, data, folder, repeat, timeout);
    return;
  }
  const std::vector<std::string> words = arguments.list("--operators");
  std::vector<Speed_operator> operators;
  for(const auto& list : {cgal_operators(), package_operators()}) {
    for(const Speed_operator& op : list) {
      const bool is_chosen
          = words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
              return op.name.find(word) != std::string::npos;
            });
      if(is_chosen && !(op.parallel && arguments.has("--sequential")))
        operators.push_back(op);
    }
  }

  std::ofstream csv(folder / "speed.csv"), stages(folder / "stages.csv");
  stages << "operator,points,stage,wall_seconds,megabytes\n";
  csv << "operator,points,cpu_seconds,wall_seconds,megabytes,error\n";
  Table table;
  for(std::size_t size : sizes) {
    const Speed_input input = make_input(data, arguments.text("--model", "armadillo"), size);
    for(const Speed_operator& op : operators) {
      if(size > op.largest)
        continue;
      const Measurement result = measure([&](Stopwatch& watch) { op.run(input, watch); }, repeat, timeout);
      const std::string name = key_of(op.name, op.parallel);
      table[name][size] = result;
      csv << name << "," << input.points.size() << "," << result.cpu_seconds << ","
          << result.wall_seconds << "," << result.megabytes << "," << result.error << "\n"
          << std::flush;
      for(const Stage_record& stage : result.stages)
        stages << name << "," << input.points.size() << "," << stage.name.data() << "," << stage.seconds << ","
               << stage.megabytes << "\n";
      std::cerr << size << " " << name << ": "
                << (result.error.empty() ? fixed(result.cpu_seconds, 3) + " s" : result.error)
                << "\n";
    }
  }
  const std::string text = report(operators, sizes, table) + stage_report(operators, sizes, table);
  std::ofstream(folder / "speed.md") << "# Speed study\n\n" << text;
  std::cout << text;
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program(
      "speed_study", usage, argc, argv,
      {"--data", "--model", "--sizes", "--operators", "--classes", "--repeat", "--timeout", "--out"},
      {"--sequential"}, run);
}
