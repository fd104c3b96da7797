// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"
#include "file_bytes.h"
#include "json.h"
#include "picture.h"
#include "point_file.h"

#include <CGAL/density_peak_segment_point_set.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using CGAL::Point_set_consolidation_3::Segmentation_method;

using Kernel = CGAL::Simple_cartesian<double>;
using Element = std::tuple<Kernel::Point_3, Kernel::Vector_3, int>;
using Stage_times = std::vector<CGAL::Point_set_consolidation_3::Stage_time>;

const std::map<std::string, Segmentation_method> methods = {
  {"density-peaks", Segmentation_method::DENSITY_PEAKS},
  {"persistence", Segmentation_method::PERSISTENCE},
  {"skeleton", Segmentation_method::SKELETON}};

struct Options {
  std::string input, output, method = "skeleton", json, picture;
  bool quiet = false;
  std::size_t threads = 0, segments = 0;
  double radius = 0, prominence = 0.1, penalty = 0.4;
};

bool parse(Options& options, int argc, char** argv)
{
  support::Command_line line("segment_point_set", "Segments a point set into parts.");
  line.positional("INPUT", options.input, "point file: .ply .off .noff .xyz .pwn .las");
  line.option("-o,--output", "FILE", options.output,
              "points with property segment, and colours: .ply");
  line.option("--segments", "N", options.segments, "number of segments")
    .default_is("found automatically");
  std::vector<std::string> names;
  for(const auto& method : methods)
    names.push_back(method.first);
  line.option("--method", "NAME", options.method, "how segments are found").one_of(names);
  line.option("--penalty", "X", options.penalty, "skeleton: price of a cut").above(0);
  line.option("--radius", "H", options.radius, "densities: support radius, in the unit of the input")
    .at_least(0).default_is("0.15 diagonals");
  line.option("--prominence", "X", options.prominence, "persistence: least height of a peak").at_least(0);
  line.option("--picture", "FILE", options.picture, "points in the colours of their parts (.png)");
  line.option("--json", "FILE", options.json, "report: counts, seconds");
  line.option("--threads", "N", options.threads, "number of threads").default_is("all");
  line.flag("-q,--quiet", options.quiet, "no progress bar");
  if(!line.parse(argc, argv))
    return false;
  if(options.output.empty())
    throw support::Usage_error("--output is missing");
  support::check_output(options.output, {".ply"});
  support::check_output(options.picture, {".png"});
  support::check_output(options.json);
  support::check_distinct({options.output, options.picture, options.json});
  return true;
}

std::string ply(const std::vector<Element>& elements, bool has_normals)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(elements.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  if(has_normals)
    text += "property double nx\nproperty double ny\nproperty double nz\n";
  text += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int segment\n"
          "end_header\n";
  for(const Element& element : elements) {
    const auto append = [&](double value) {
      support::append_number(text, value);
      text += ' ';
    };
    for(int k = 0; k < 3; ++k)
      append(std::get<0>(element)[k]);
    if(has_normals)
      for(int k = 0; k < 3; ++k)
        append(std::get<1>(element)[k]);
    const support::Color color = support::label_color(std::size_t(std::get<2>(element)));
    for(const double channel : {color.red, color.green, color.blue})
      text += std::to_string(int(std::lround(255 * channel))) + ' ';
    text += std::to_string(std::get<2>(element)) + '\n';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("segment_point_set", [&] {
    Options options;
    if(!parse(options, argc, argv))
      return;
    const support::Thread_limit threads(options.threads);
    support::Progress_bar progress("segments", options.quiet);
    const support::Point_cloud cloud = support::read_point_cloud(options.input);
    const bool has_normals = !cloud.normals.empty();
    std::vector<Element> elements;
    for(std::size_t i = 0; i < cloud.size(); ++i) {
      const support::Vec3 p = cloud.points[i];
      const support::Vec3 n = has_normals ? cloud.normals[i] : support::Vec3(0, 0, 0);
      elements.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()),
                            Kernel::Vector_3(n.x(), n.y(), n.z()), 0);
    }
    Stage_times times;
    const std::size_t count = support::with_points_of(options.input, [&] {
      return CGAL::density_peak_segment_point_set<CGAL::Parallel_if_available_tag>(
        elements, CGAL::Nth_of_tuple_property_map<2, Element>(),
        params::point_map(CGAL::Nth_of_tuple_property_map<0, Element>())
          .segmentation_method(methods.at(options.method))
          .number_of_segments(options.segments)
          .neighbor_radius(options.radius)
          .prominence(options.prominence)
          .variation_penalty(options.penalty)
          .stage_times(std::ref(times))
          .callback([&](double fraction) { return progress(fraction); }));
    });
    support::write_file(options.output, ply(elements, has_normals));
    if(!options.picture.empty()) {
      std::vector<support::Panel> panels(2);
      panels[0].title = "input";
      panels[0].cloud.points = cloud.points;
      panels[0].cloud.normals = cloud.normals;
      panels[1] = panels[0];
      panels[1].title = std::to_string(count) + " segments";
      for(const Element& element : elements)
        panels[1].point_colors.push_back(support::label_color(std::size_t(std::get<2>(element))));
      support::write_panels(options.picture, panels);
    }
    if(!options.json.empty()) {
      support::Json json;
      json["method"] = options.method;
      json["points"] = elements.size();
      json["segments"] = count;
      for(const auto& stage : times)
        json["stages"][stage.name]["seconds"] = stage.seconds;
      support::write_json(options.json, json);
    }
    support::report_files(options.quiet, {options.output, options.picture, options.json});
  });
}
