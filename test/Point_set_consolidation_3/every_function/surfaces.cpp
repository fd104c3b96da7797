// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "graphs.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/feature_enhanced_surface_reconstruction.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <algorithm>
#include <cmath>

namespace every_function {
namespace {

using Mesh = CGAL::Surface_mesh<Point>;

constexpr std::size_t resolution = 16;

/// Functions that assign to a mesh.
template <typename Call>
void reconstructed(const Cloud& cloud, const Run& run, Output& output, const Call& call)
{
  Mesh mesh;
  mesh.add_vertex(Point(1, 2, 3));
  const auto finish = [&] { output.is_untouched = mesh.number_of_vertices() == 1; };
  try {
    with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) { call(tag, np, mesh); });
  }
  catch(...) {
    finish();
    throw;
  }
  finish();
  for(const Mesh::Vertex_index v : mesh.vertices())
    output.points.push_back(mesh.point(v));
  for(const Mesh::Face_index f : mesh.faces())
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      output.numbers.push_back(double(std::size_t(v)));
}

/// A chain along the diagonal of the box around the points.
Skeleton diagonal_skeleton(const Cloud& cloud)
{
  Skeleton skeleton;
  if(cloud.samples.empty())
    return skeleton;
  double lower[3], upper[3];
  for(int k = 0; k < 3; ++k) {
    lower[k] = upper[k] = cloud.samples[0].point[k];
    for(const Sample& s : cloud.samples) {
      lower[k] = (std::min)(lower[k], s.point[k]);
      upper[k] = (std::max)(upper[k], s.point[k]);
    }
  }
  double side = 0;
  for(int k = 0; k < 3; ++k)
    side = (std::max)(side, upper[k] - lower[k]);
  constexpr std::size_t number = 9;
  for(std::size_t v = 0; v < number; ++v) {
    const double t = double(v + 1) / double(number + 1);
    double x[3];
    for(int k = 0; k < 3; ++k)
      x[k] = (1 - t) * lower[k] + t * upper[k];
    CGAL::Curve_skeleton_editing::add_vertex<Kernel>(skeleton, Point(x[0], x[1], x[2]), 0.2 * side);
    if(v > 0)
      add_edge(v - 1, v, skeleton);
  }
  for(std::size_t i = 0; i < cloud.samples.size(); ++i)
    skeleton[i % number].points.push_back(i);
  return skeleton;
}

void skeleton_driven(const Cloud& cloud, const Run& run, Output& output)
{
  const Skeleton skeleton = diagonal_skeleton(cloud);
  reconstructed(cloud, run, output, [&](auto tag, const auto& np, Mesh& mesh) {
    CGAL::skeleton_driven_surface_reconstruction<decltype(tag)>(
      cloud.samples, skeleton, mesh, np.grid_resolution(resolution));
  });
}

void feature_enhanced(const Cloud& cloud, const Run& run, Output& output)
{
  reconstructed(cloud, run, output, [&](auto tag, const auto& np, Mesh& mesh) {
    Skeleton skeleton;
    CGAL::feature_enhanced_surface_reconstruction<decltype(tag)>(
      cloud.samples, skeleton, mesh, np.grid_resolution(resolution));
    append(skeleton, output);
  });
}

void along_skeleton(const Cloud& cloud, const Run& run, Output& output)
{
  const Skeleton skeleton = diagonal_skeleton(cloud);
  written_oriented(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::complete_point_set_along_skeleton<decltype(tag)>(cloud.samples, skeleton, out, true, np);
  });
}

}  // namespace

const std::vector<Function>& surfaces()
{
  static const std::vector<Function> functions = {
    {"skeleton_driven_surface_reconstruction", Normals::UNUSED, false, skeleton_driven},
    {"feature_enhanced_surface_reconstruction", Normals::OPTIONAL, false, feature_enhanced},
    {"complete_point_set_along_skeleton", Normals::OPTIONAL, true, along_skeleton}};
  return functions;
}

}  // namespace every_function
