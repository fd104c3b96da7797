// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "graphs.h"

#include <CGAL/complete_point_set.h>
#include <CGAL/deep_points_consolidate_point_set.h>
#include <CGAL/iterative_consolidate_point_set.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <algorithm>

namespace every_function {
namespace {

using Deep_point = CGAL::Deep_point_3<Kernel>;

std::size_t particles(const Cloud& cloud)
{
  return (std::min)(std::size_t(150), (std::max)(std::size_t(1), cloud.samples.size()));
}

void append(const std::vector<Deep_point>& deep, Output& output)
{
  for(const Deep_point& p : deep) {
    output.points.push_back(p.outer());
    output.points.push_back(p.inner());
    output.normals.push_back(p.normal());
    output.numbers.push_back(p.confidence());
  }
}

void deep_points(const Cloud& cloud, const Run& run, Output& output)
{
  append(written<Deep_point>(cloud, run, output,
    [&](auto tag, const auto& np, auto out) {
      CGAL::deep_points_consolidate_point_set<decltype(tag)>(
        cloud.samples, out, np.number_of_output_points(particles(cloud)));
    }), output);
}

void completion(const Cloud& cloud, const Run& run, Output& output)
{
  append(written<Deep_point>(cloud, run, output,
    [&](auto tag, const auto& np, auto out) {
      CGAL::complete_point_set<decltype(tag)>(
        cloud.samples, out, np.number_of_output_points(particles(cloud)));
    }), output);
}

/// Each point is seen from where its normal points to, so that rays, free space and mirror planes count.
void completion_of_views(const Cloud& cloud, const Run& run, Output& output)
{
  append(written<Deep_point>(cloud, run, output,
    [&](auto tag, const auto& np, auto out) {
      CGAL::complete_point_set<decltype(tag)>(
        cloud.samples, out,
        np.number_of_output_points(particles(cloud)).view_direction_map(Normal_map{&run}));
    }), output);
}

void stages(const Cloud& cloud, const Run& run, Output& output)
{
  with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) {
    CGAL::Deep_points_consolidation_3<Kernel, decltype(tag)> c(
      cloud.samples, np.number_of_output_points(particles(cloud)));
    if(!c.form_meso_skeleton())
      return;
    output.is_untouched = false;
    for(std::size_t i = 0; i < c.size(); ++i) {
      output.points.push_back(c.consolidated_point(i));
      output.points.push_back(c.anchor_point(i));
      output.points.push_back(c.skeletal_point(i));
      output.normals.push_back(c.consolidated_normal(i));
      output.numbers.push_back(double(c.anchoring(i)));
      for(int m = 0; m < 3; ++m)
        for(int k = 0; k < 3; ++k)
          output.numbers.push_back(c.ellipsoid_axis(i, m)[k]);
    }
    output.numbers.push_back(c.spacing());
    output.numbers.push_back(double(c.number_of_sinking_iterations()));
  });
}

void meso_graph(const Cloud& cloud, const Run& run, Output& output)
{
  with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) {
    CGAL::Deep_points_consolidation_3<Kernel, decltype(tag)> c(
      cloud.samples, np.number_of_output_points(particles(cloud)));
    CGAL::Meso_skeleton_3<Kernel> skeleton;
    const auto is_untouched = [&] { return num_vertices(skeleton.graph) == 0 && skeleton.labels.empty(); };
    try {
      CGAL::meso_skeleton_to_graph(c, skeleton);
    }
    catch(...) {
      output.is_untouched = is_untouched();
      throw;
    }
    output.is_untouched = is_untouched();
    append(skeleton.graph, output);
    for(const auto& triangle : skeleton.triangles)
      for(const std::size_t v : triangle)
        output.numbers.push_back(double(v));
    for(const auto label : skeleton.labels)
      output.numbers.push_back(double(label));
    output.numbers.insert(output.numbers.end(), skeleton.radii.begin(), skeleton.radii.end());
  });
}

void iterative(const Cloud& cloud, const Run& run, Output& output)
{
  written_oriented(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::iterative_consolidate_point_set<decltype(tag)>(cloud.samples, out, np);
  });
}

}  // namespace

const std::vector<Function>& consolidations()
{
  static const std::vector<Function> functions = {
    {"deep_points_consolidate_point_set", Normals::OPTIONAL, false, deep_points},
    {"complete_point_set", Normals::OPTIONAL, true, completion},
    {"complete_point_set (views)", Normals::OPTIONAL, true, completion_of_views},
    {"Deep_points_consolidation_3", Normals::OPTIONAL, false, stages},
    {"meso_skeleton_to_graph", Normals::OPTIONAL, false, meso_graph},
    {"iterative_consolidate_point_set", Normals::OPTIONAL, false, iterative}};
  return functions;
}

}  // namespace every_function
