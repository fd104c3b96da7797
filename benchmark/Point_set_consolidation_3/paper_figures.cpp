// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures and tables of the four papers, each by its name.

#include "arguments.h"
#include "models.h"
#include "paper_figure.h"
#include "point_file.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace benchmark;
namespace fs = std::filesystem;

namespace {

const char* const usage =
    R"(paper_figures NAME... [options]
Makes figures and tables of the papers: NAME.txt and NAME.csv (numbers), NAME.png (picture), NAME.svg (plot).
NAME is a figure, the first part of the names of several (deep, iterative, laplacian, feature), or all.
  --list         names, and what the paper shows
  --data DIR     CGAL's data (environment variable CGAL_DATA_DIR)
  --out DIR      (paper_figures_results)
)";

std::vector<Paper_figure> all_figures()
{
  std::vector<Paper_figure> figures;
  for(const auto& list : {deep_points_figures(), iterative_figures(), laplacian_figures(), feature_figures()})
    figures.insert(figures.end(), list.begin(), list.end());
  return figures;
}

std::vector<Paper_figure> select(const std::vector<std::string>& words)
{
  const std::vector<Paper_figure> all = all_figures();
  std::vector<Paper_figure> selected;
  for(const std::string& word : words) {
    const std::size_t before = selected.size();
    for(const Paper_figure& figure : all)
      if(word == "all" || word == figure.name || figure.name.rfind(word + "_", 0) == 0)
        selected.push_back(figure);
    if(selected.size() == before)
      throw Usage_error("unknown figure '" + word + "'");
  }
  return selected;
}

std::string number(double value)
{
  if(std::isnan(value))
    return "-";
  std::ostringstream text;
  if(value == std::round(value) && std::abs(value) < 1e9)
    text << std::fixed << std::setprecision(0) << value;
  else
    text << std::fixed << std::setprecision(std::abs(value) < 10 ? 3 : std::abs(value) < 100 ? 2 : 1) << value;
  return text.str();
}

std::string as_text(const Figure_table& table)
{
  std::vector<std::vector<std::string>> cells = {{table.title}};
  cells[0].insert(cells[0].end(), table.columns.begin(), table.columns.end());
  for(const Figure_table::Row& row : table.rows) {
    cells.push_back({row.name});
    for(const double value : row.values)
      cells.back().push_back(number(value));
  }
  std::vector<std::size_t> width;
  for(const auto& row : cells)
    for(std::size_t c = 0; c < row.size(); ++c) {
      width.resize((std::max)(width.size(), c + 1));
      width[c] = (std::max)(width[c], row[c].size());
    }
  std::ostringstream text;
  for(const auto& row : cells) {
    for(std::size_t c = 0; c < row.size(); ++c) {
      text << (c == 0 ? std::left : std::right) << std::setw(int(width[c])) << row[c]
           << (c + 1 < row.size() ? "  " : "\n");
    }
  }
  return text.str();
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for(const char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

void write_text(const fs::path& file, const std::string& text)
{
  std::ofstream out(file);
  out << text;
  if(!out.flush())
    throw support::File_error(file.string() + ": cannot be written");
}

/// Each scene in the same box around the origin, so that one camera fits all.
void move_to_one_box(std::vector<support::Panel>& panels)
{
  for(support::Panel& panel : panels) {
    std::vector<Vec3> all = panel.cloud.points;
    all.insert(all.end(), panel.mesh.vertices.begin(), panel.mesh.vertices.end());
    all.insert(all.end(), panel.graph.vertices.begin(), panel.graph.vertices.end());
    if(all.empty())
      continue;
    Vec3 lower = all[0], upper = all[0];
    for(const Vec3& p : all) {
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    const Vec3 centre = 0.5 * (lower + upper);
    const double scale = 1 / (upper - lower).norm();
    for(auto* points : {&panel.cloud.points, &panel.mesh.vertices, &panel.graph.vertices})
      for(Vec3& p : *points)
        p = scale * (p - centre);
  }
}

void make(const Paper_figure& figure, const std::string& data, const fs::path& folder)
{
  const auto begin = std::chrono::steady_clock::now();
  Figure_result result = figure.make(data);
  std::string text = figure.name + ": " + figure.shows + "\n", csv;
  for(const Figure_table& table : result.tables) {
    text += "\n" + as_text(table);
    csv += quoted(table.title);
    for(const std::string& column : table.columns)
      csv += "," + quoted(column);
    csv += "\n";
    for(const Figure_table::Row& row : table.rows) {
      csv += quoted(row.name);
      for(const double value : row.values) {
        std::ostringstream cell;
        cell << std::setprecision(6) << value;
        csv += "," + (std::isnan(value) ? std::string() : cell.str());
      }
      csv += "\n";
    }
  }
  write_text(folder / (figure.name + ".txt"), text);
  write_text(folder / (figure.name + ".csv"), csv);
  if(!result.panels.empty()) {
    if(!result.shares_camera)
      move_to_one_box(result.panels);
    support::write_panels((folder / (figure.name + ".png")).string(), result.panels, result.view, result.up,
                          400, result.columns);
  }
  for(std::size_t k = 0; k < result.plots.size(); ++k) {
    const std::string number_of_plot = result.plots.size() > 1 ? "_" + std::to_string(k + 1) : "";
    support::write_plot((folder / (figure.name + number_of_plot + ".svg")).string(), result.plots[k]);
  }
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cout << text << "\n" << std::flush;
  std::cerr << figure.name << ": " << number(seconds) << " s\n";
}

void run(const Arguments& arguments)
{
  if(arguments.has("--list")) {
    for(const Paper_figure& figure : all_figures())
      std::cout << std::left << std::setw(28) << figure.name << figure.shows << "\n";
    return;
  }
  if(arguments.files().empty())
    throw Usage_error("which figure?");
  const std::vector<Paper_figure> figures = select(arguments.files());
  const std::string data = data_folder(arguments.text("--data"));
  const fs::path folder = arguments.text("--out", "paper_figures_results");
  fs::create_directories(folder);
  for(const Paper_figure& figure : figures)
    make(figure, data, folder);
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program("paper_figures", usage, argc, argv,
                                {"--data", "--out"},
                                {"--list"}, run);
}
