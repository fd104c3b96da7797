// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Diagrams: what must be in the drawing, and where.
#undef NDEBUG
#include "file_bytes.h"
#include "plot.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace support;

namespace {

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for(std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

/// Values of the attribute in all elements that start with `element`.
std::vector<double> values(const std::string& svg, const std::string& element,
                           const std::string& attribute)
{
  std::vector<double> all;
  for(std::size_t at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1)) {
    const std::string name = " " + attribute + "=\"";
    all.push_back(std::stod(svg.substr(svg.find(name, at) + name.size())));
  }
  return all;
}

void distributions_are_ranks()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Series s = cumulative_distribution("four", {3, 1, nan, 2, 4});
  assert(s.x == std::vector<double>({1, 1, 2, 3, 4}));
  assert(s.y == std::vector<double>({0, 0.25, 0.5, 0.75, 1}));
  assert(cumulative_distribution("none", {nan}).x.empty());
  std::vector<double> many(100000);
  for(std::size_t i = 0; i < many.size(); ++i)
    many[i] = static_cast<double>(i);
  const Series thinned = cumulative_distribution("many", many);
  assert(thinned.x.size() < 1000 && thinned.x.back() == 99999 && thinned.y.back() == 1);
}

void axes_are_to_scale()
{
  Plot plot;
  plot.series = {{"marks", {0, 1, 2}, {10, 20, 40}, Series::Shape::marks}};
  for(bool logarithmic : {false, true}) {
    plot.log_y = logarithmic;
    const std::string svg = svg_of_plot(plot);
    const auto x = values(svg, "<circle", "cx"), y = values(svg, "<circle", "cy");
    assert(x.size() == 4);  // one is in the legend
    assert(std::abs((x[1] - x[0]) - (x[2] - x[1])) < 0.05);
    const double ratio = (y[1] - y[2]) / (y[0] - y[1]);
    assert(std::abs(ratio - (logarithmic ? 1 : 2)) < 0.01);
  }
}

void gaps_and_bars()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Plot lines;
  lines.title = "a < b & \"c\"";
  lines.series = {{"gap", {1, 2, 3, 4, 5}, {1, 2, nan, 4, 5}}};
  const std::string svg = svg_of_plot(lines);
  assert(count(svg, "<polyline") == 2);
  assert(count(svg, "a &lt; b &amp; &quot;c&quot;") == 1);
  assert(count(svg, "nan") == 0 && count(svg, "inf") == 0);

  Plot bars;
  bars.categories = {"one", "two"};
  bars.series = {{"first", {}, {1, 2}}, {"second", {}, {3, nan}}};
  const auto heights = values(svg_of_plot(bars), "<rect", "height");
  // Background, three bars, two entries of the legend.
  assert(heights.size() == 6);
  assert(std::abs(heights[2] / heights[1] - 2) < 0.01);
  assert(std::abs(heights[3] / heights[1] - 3) < 0.01);

  // Nothing to show, only equal values, values no logarithm can show.
  for(const std::vector<double>& y :
      {std::vector<double>{}, std::vector<double>{0, 0}, std::vector<double>{-1, 0}}) {
    for(bool logarithmic : {false, true}) {
      Plot odd;
      odd.log_x = odd.log_y = logarithmic;
      odd.series = {{"odd", y, y}};
      const std::string text = svg_of_plot(odd);
      assert(count(text, "nan") == 0 && count(text, "inf") == 0 && count(text, "</svg>") == 1);
    }
  }
  bool refused = false;
  bars.series[0].y.pop_back();
  try {
    svg_of_plot(bars);
  } catch(const std::invalid_argument&) {
    refused = true;
  }
  assert(refused);
}

void files()
{
  const std::string file = "support_plot_test.svg";
  Plot plot;
  plot.series = {{"line", {1, 10, 1e5}, {1, 2, 3}}};
  plot.log_x = true;
  write_plot(file, plot);
  const std::string svg = read_file(file);
  assert(svg == svg_of_plot(plot));
  assert(count(svg, ">1e5<") == 1 && count(svg, ">10<") == 1 && count(svg, ">0<") == 1);
  std::filesystem::remove(file);
  bool refused = false;
  try {
    write_plot("no_such_folder/plot.svg", plot);
  } catch(const File_error&) {
    refused = true;
  }
  assert(refused);
}

}  // namespace

int main()
{
  distributions_are_ranks();
  axes_are_to_scale();
  gaps_and_bars();
  files();
  std::cout << "plots: all facts hold" << std::endl;
  return EXIT_SUCCESS;
}
