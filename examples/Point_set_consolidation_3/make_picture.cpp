// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program: a figure of point sets, skeletons and meshes from files, all seen by one camera. See --help.

#include "command_line.h"
#include "file_bytes.h"
#include "picture.h"
#include "ply_file.h"
#include "point_file.h"

#include <algorithm>
#include <string>
#include <vector>

namespace {

struct Options {
  std::string output;
  std::vector<std::string> panels;
  support::Vec3 view = support::Vec3(-0.45, -0.3, -1), up = support::Vec3::UnitY();
  std::size_t height = 480, columns = 0;
  double point_radius = 0;
  bool quiet = false;
};

bool parse(Options& o, int argc, char** argv)
{
  support::Command_line line("make_picture",
                             "Draws point sets, skeletons and meshes side by side, with one camera. "
                             "OUTPUT is a .png file.");
  line.positional("OUTPUT", o.output, "the picture");
  line.option("--panel", "TITLE=FILE[,FILE]", o.panels,
              "a panel of the files: points coloured by their properties confidence or segment, meshes, "
              "skeletons (drawn on top of the others); repeated for further panels");
  line.option("--view", "X Y Z", o.view, "direction from the eye into the scene").default_is("-0.45 -0.3 -1");
  line.option("--up", "X Y Z", o.up, "direction that is above").default_is("0 1 0");
  line.option("--height", "N", o.height, "height of a panel, pixels").between(50, 4000);
  line.option("--columns", "N", o.columns, "panels in a row").default_is("all");
  line.option("--point-radius", "X", o.point_radius, "radius of the points, unit of the input")
    .at_least(0).default_is("from their spacing");
  line.flag("-q,--quiet", o.quiet, "no report");
  if(!line.parse(argc, argv))
    return false;
  if(o.panels.empty())
    throw support::Usage_error("--panel is missing");
  support::check_output(o.output, {".png"});
  return true;
}

void add_points(support::Panel& panel, const std::string& file)
{
  panel.cloud = support::read_point_cloud(file);
  if(support::extension(file) != ".ply")
    return;
  const support::Ply_file ply = support::read_ply(file);
  const support::Ply_element* vertices = ply.find("vertex");
  const support::Ply_property* segment = vertices ? vertices->find_number("segment") : nullptr;
  if(segment == nullptr)
    return;
  for(const double label : segment->values)
    panel.point_colors.push_back(support::label_color(label >= 0 && label < 1e9 ? std::size_t(label) : 0));
}

bool has_element(const std::string& file, const std::string& name)
{
  if(support::extension(file) != ".ply")
    return false;
  const support::Ply_file ply = support::read_ply(file);
  const support::Ply_element* element = ply.find(name);
  return element != nullptr && element->count > 0;
}

void add_file(support::Panel& panel, const std::string& file)
{
  const std::string extension = support::extension(file);
  if(has_element(file, "edge"))
    panel.graph = support::read_segment_graph(file);
  else if(has_element(file, "face") || extension == ".obj" || extension == ".stl" || extension == ".off")
    panel.mesh = support::read_mesh(file);
  else
    add_points(panel, file);
}

support::Panel read_panel(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if(equals == std::string::npos || equals + 1 == text.size())
    throw support::Usage_error("--panel: " + text + " is not TITLE=FILE");
  support::Panel panel;
  panel.title = text.substr(0, equals);
  for(std::size_t begin = equals + 1; begin < text.size();) {
    const std::size_t end = (std::min)(text.find(',', begin), text.size());
    add_file(panel, text.substr(begin, end - begin));
    begin = end + 1;
  }
  return panel;
}

}  // namespace

int main(int argc, char** argv)
{
  return support::run_program("make_picture", [&] {
    Options o;
    if(!parse(o, argc, argv))
      return;
    std::vector<support::Panel> panels;
    for(const std::string& text : o.panels) {
      panels.push_back(read_panel(text));
      panels.back().point_radius = o.point_radius;
    }
    support::write_panels(o.output, panels, o.view, o.up, int(o.height), o.columns);
    support::report_files(o.quiet, {o.output});
  });
}
