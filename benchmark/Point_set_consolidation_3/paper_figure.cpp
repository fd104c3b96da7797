// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_figure.h"

#include "mesh_tree.h"
#include "models.h"
#include "poisson_mesh.h"

#include <CGAL/Point_set_consolidation_3/internal/marching_tetrahedra.h>

#include <cmath>
#include <map>
#include <numeric>
#include <type_traits>

namespace benchmark {

Triangle_mesh figure_model(const std::string& data, const std::string& name)
{
  return load_model(select_models({name}).front(), data);
}

Triangle_mesh shape_mesh(const synthetic::Shape& shape, std::size_t cells)
{
  namespace core = CGAL::Point_set_consolidation_3::internal;
  constexpr std::int64_t margin = 2;
  const double step = (shape.upper - shape.lower).maxCoeff() / double(cells);
  core::Lattice_point dimensions;
  for(int axis = 0; axis < 3; ++axis)
    dimensions[std::size_t(axis)] =
      std::int64_t(std::ceil((shape.upper - shape.lower)[axis] / step)) + 2 * margin + 1;
  const core::Sparse_lattice lattice(
    dimensions, [&](std::int64_t, std::int64_t, auto& xs) {
      for(std::int64_t x = 0; x < dimensions[0]; ++x)
        xs.push_back(typename std::decay_t<decltype(xs)>::value_type(x));
    });
  // the lattice is shifted by part of a cell, so that flat faces of a shape do not pass through its nodes
  const Vec3 origin = shape.lower - step * Vec3(double(margin) - 0.31, double(margin) - 0.37,
                                                double(margin) - 0.43);
  const auto place = [&](const Vec3& node) { return Vec3(origin + step * node); };
  std::vector<double> values;
  for(std::size_t i = 0; i < lattice.size(); ++i) {
    const core::Lattice_point p = lattice.point(i);
    values.push_back(shape.distance(place(Vec3(double(p[0]), double(p[1]), double(p[2])))));
  }
  core::Surface_triangles surface = core::Marching_tetrahedra(lattice, values).run();
  Triangle_mesh mesh;
  for(const Vec3& v : surface.vertices)
    mesh.vertices.push_back(place(v));
  mesh.faces = std::move(surface.triangles);
  return mesh;
}

const std::vector<std::string>& mesh_columns()
{
  static const std::vector<std::string> columns = {
    "error", "95 %", "seen", "unseen", "backward", "F 1 %", "components", "genus", "volume"};
  return columns;
}

std::vector<std::pair<std::string, std::vector<synthetic::Shape>>> assembled_shapes()
{
  using synthetic::capsule;
  const auto ball = [](const Vec3& c, double r) { return capsule(c, c + Vec3(1e-6, 0, 0), r); };
  return {
      {"dumbbell",
       {ball(Vec3(-1, 0, 0), 0.5), ball(Vec3(1, 0, 0), 0.5), capsule(Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.12)}},
      {"Y",
       {capsule(Vec3(0, 0, 0), Vec3(0, -1.2, 0), 0.2), capsule(Vec3(0, 0, 0), Vec3(-0.9, 0.9, 0), 0.2),
        capsule(Vec3(0, 0, 0), Vec3(0.9, 0.9, 0), 0.2)}},
      {"creature",
       {capsule(Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.45), capsule(Vec3(1.2, 0, 0.2), Vec3(1.8, 0, 0.9), 0.2),
        ball(Vec3(1.9, 0, 1.1), 0.35), capsule(Vec3(-0.8, 0.3, 0), Vec3(-0.9, 0.5, -1.2), 0.13),
        capsule(Vec3(-0.8, -0.3, 0), Vec3(-0.9, -0.5, -1.2), 0.13),
        capsule(Vec3(0.8, 0.3, 0), Vec3(0.9, 0.5, -1.2), 0.13),
        capsule(Vec3(0.8, -0.3, 0), Vec3(0.9, -0.5, -1.2), 0.13),
        capsule(Vec3(-1.3, 0, 0.1), Vec3(-2.2, 0, 0.5), 0.08)}},
      {"hand",
       {capsule(Vec3(0, -0.6, 0), Vec3(0, 0.2, 0), 0.42), capsule(Vec3(-0.36, 0.3, 0), Vec3(-0.6, 1.3, 0), 0.11),
        capsule(Vec3(-0.12, 0.4, 0), Vec3(-0.2, 1.55, 0), 0.11), capsule(Vec3(0.12, 0.4, 0), Vec3(0.2, 1.5, 0), 0.11),
        capsule(Vec3(0.36, 0.3, 0), Vec3(0.6, 1.2, 0), 0.1), capsule(Vec3(0.35, -0.3, 0), Vec3(1.1, 0.3, 0), 0.13)}},
  };
}

std::vector<double> mesh_row(const Mesh_verdict& v)
{
  return {v.forward.mean, v.forward.percentile_95, v.seen.mean,       v.unseen.mean, v.reverse.mean,
          v.fscore_one,   double(v.topology.components), v.topology.genus, v.volume_ratio};
}

Triangle_mesh poisson(const Point_cloud& oriented)
{
  support::Poisson_options options;
  options.spacing = 0.008;
  options.distance = 0.2;
  return support::poisson_mesh(oriented.points, oriented.normals, options);
}

support::Panel mesh_panel(const std::string& title, const Triangle_mesh& mesh)
{
  support::Panel panel;
  panel.title = title;
  panel.mesh = mesh;
  return panel;
}

support::Panel cloud_panel(const std::string& title, const Point_cloud& cloud)
{
  support::Panel panel;
  panel.title = title;
  panel.cloud = cloud;
  return panel;
}

support::Panel graph_panel(const std::string& title, const support::Segment_graph& graph,
                           const Point_cloud& cloud)
{
  support::Panel panel = cloud_panel(title, cloud);
  panel.graph = graph;
  panel.graph.radius.clear();
  return panel;
}

std::vector<support::Color> heat_colors(const std::vector<double>& values, double most)
{
  std::vector<support::Color> colors;
  for(const double value : values)
    colors.push_back(support::heat_color(value / most));
  return colors;
}

std::vector<double> normal_errors(const Triangle_mesh& truth, const Point_cloud& cloud)
{
  constexpr double degrees = 57.295779513082323;
  const Mesh_tree tree(truth);
  std::vector<double> errors;
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    const double cosine = std::abs(tree.closest(cloud.points[i]).normal.dot(cloud.normals[i]));
    errors.push_back(degrees * std::acos((std::min)(1.0, cosine)));
  }
  return errors;
}

std::vector<Vec3> sharp_edge_points(const Triangle_mesh& mesh)
{
  constexpr double cosine_of_40_degrees = 0.766;
  constexpr std::size_t samples_per_edge = 4;
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> faces;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = mesh.faces[f][k], b = mesh.faces[f][(k + 1) % 3];
      faces[{(std::min)(a, b), (std::max)(a, b)}].push_back(f);
    }
  std::vector<Vec3> points;
  for(const auto& [edge, around] : faces) {
    if(around.size() != 2
       || face_normal(mesh, around[0]).dot(face_normal(mesh, around[1])) > cosine_of_40_degrees)
      continue;
    const Vec3 a = mesh.vertices[edge[0]], b = mesh.vertices[edge[1]];
    for(std::size_t k = 0; k < samples_per_edge; ++k)
      points.push_back(a + (double(k) + 0.5) / double(samples_per_edge) * (b - a));
  }
  return points;
}

double mean(const std::vector<double>& values)
{
  return values.empty() ? std::nan("")
                        : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

support::Color label_color(std::size_t label)
{
  // hues a golden section apart
  const double hue = 6 * std::fmod(0.618033988749895 * double(label) + 0.05, 1.0);
  const double fade = 1 - std::abs(std::fmod(hue, 2.0) - 1);
  const double channels[6][3] = {{1, fade, 0}, {fade, 1, 0}, {0, 1, fade},
                                 {0, fade, 1}, {fade, 0, 1}, {1, 0, fade}};
  const auto& c = channels[std::size_t(hue) % 6];
  return {0.15 + 0.75 * c[0], 0.15 + 0.75 * c[1], 0.15 + 0.75 * c[2]};
}

}  // namespace benchmark
