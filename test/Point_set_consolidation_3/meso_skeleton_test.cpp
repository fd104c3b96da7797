// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meso-skeletons as curves and sheets, on shapes whose skeletons are known.

#undef NDEBUG

#include "scan_rays.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace {

namespace psc = CGAL::Point_set_consolidation_3;
namespace params = CGAL::Point_set_consolidation_3::parameters;
using synthetic::Scan;
using synthetic::Shape;

typedef CGAL::Meso_skeleton_3<Kernel> Meso_skeleton;

/// What holds for every meso-skeleton.
Meso_skeleton meso_skeleton(const Scan& scan, std::size_t particles)
{
  CGAL::Deep_points_consolidation_3<Kernel, CGAL::Parallel_if_available_tag> consolidation(
    rays(scan), params::point_map(First()).view_direction_map(Second())
                  .number_of_output_points(particles));
  Meso_skeleton skeleton;
  assert(CGAL::meso_skeleton_to_graph(consolidation, skeleton));
  const std::size_t n = num_vertices(skeleton.graph);
  assert(n > 0 && skeleton.vertex_labels.size() == n);
  assert(skeleton.labels.size() == particles && skeleton.radii.size() == particles);
  std::size_t points = 0;
  for(std::size_t v = 0; v < n; ++v) {
    assert(vec3(skeleton.graph[v].point).allFinite() && skeleton.graph[v].radius > 0);
    points += skeleton.graph[v].points.size();
  }
  assert(points == particles);
  for(const auto& t : skeleton.triangles)
    assert(t[0] < t[1] && t[1] < t[2] && t[2] < n);
  return skeleton;
}

std::size_t vertices_of_degree(const Meso_skeleton& skeleton, std::size_t wanted)
{
  std::size_t count = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton.graph); ++v)
    count += degree(v, skeleton.graph) == wanted;
  return count;
}

std::size_t count(const std::vector<psc::Meso_label>& labels, psc::Meso_label label)
{
  return std::size_t(std::count(labels.begin(), labels.end(), label));
}

/// Mean distance of the vertices to the true skeleton, percent of the diagonal.
double error(const Meso_skeleton& skeleton, const Shape& shape)
{
  double sum = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton.graph); ++v)
    sum += shape.skeleton_distance(vec3(skeleton.graph[v].point));
  return 100 * sum / double(num_vertices(skeleton.graph)) / shape.diagonal();
}

void meso_skeleton_of_tubes()
{
  std::cout << "meso-skeletons of tubes" << std::endl;
  const auto torus = synthetic::torus(1, 0.35);
  for(const bool is_complete : {true, false}) {
    std::vector<Vec3> views = {Vec3(1, .45, .35)};
    if(is_complete)
      views = {Vec3(.1, .1, 1), Vec3(.1, -.1, -1), Vec3(1, .1, .2), Vec3(-1, .1, -.1)};
    const Meso_skeleton ring = meso_skeleton(synthetic::scan(torus, views, 12000, 1), 3000);
    std::cout << "  torus: " << number_of_components(ring) << " components, " << number_of_cycles(ring)
              << " cycles, " << ring.triangles.size() << " triangles, error " << error(ring, torus) << " %"
              << std::endl;
    assert(number_of_components(ring) == 1 && number_of_cycles(ring) == 1);
    assert(ring.triangles.empty());
    assert(vertices_of_degree(ring, 2) == num_vertices(ring.graph));  // one closed curve
    assert(count(ring.labels, psc::Meso_label::CURVE) == ring.labels.size());
    assert(error(ring, torus) < 0.8);
    for(const double radius : ring.radii)
      assert(radius > 0.25 && radius < 0.45);
  }

  const auto y = synthetic::united({synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, -2), 0.35),
                                    synthetic::capsule(Vec3(0, 0, 0), Vec3(1.4, 0, 1.4), 0.35),
                                    synthetic::capsule(Vec3(0, 0, 0), Vec3(-1.4, 0, 1.4), 0.35)});
  const Meso_skeleton branches = meso_skeleton(synthetic::scan(y, {Vec3(.2, 1, .1)}, 12000, 3), 3000);
  assert(number_of_components(branches) == 1 && number_of_cycles(branches) == 0);
  assert(number_of_sheets(branches) == 0);
  assert(vertices_of_degree(branches, 1) == 3 && vertices_of_degree(branches, 3) == 1);
  assert(vertices_of_degree(branches, 2) + 4 == num_vertices(branches.graph));
  assert(count(branches.vertex_labels, psc::Meso_label::END) == 3);

  std::vector<Shape> strands;  // a trefoil knot
  const auto at = [](double t) {
    return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
  };
  constexpr int pieces = 60;
  for(int k = 0; k < pieces; ++k) {
    const double step = 2 * std::acos(-1.) / pieces;
    strands.push_back(synthetic::capsule(at(k * step), at((k + 1) * step), 0.4));
  }
  const auto knot = synthetic::united(strands);
  const std::vector<Vec3> around = {{0, 0, 1}, {0, 0, -1}, {1, 0, .2}, {-1, .1, 0}, {0, 1, 0}, {.1, -1, 0}};
  const Meso_skeleton closed = meso_skeleton(synthetic::scan(knot, around, 15000, 5), 4000);
  assert(number_of_components(closed) == 1 && number_of_cycles(closed) == 1);
  assert(number_of_sheets(closed) == 0);
}

void meso_skeleton_of_sheets()
{
  std::cout << "meso-skeletons of sheets" << std::endl;
  const std::vector<Vec3> both = {Vec3(.3, .2, 1), Vec3(-.2, -.3, -1)};
  const auto plate = synthetic::plate(2, 2, 0.12);
  const Meso_skeleton sheet = meso_skeleton(synthetic::scan(plate, both, 12000, 4), 3000);
  assert(number_of_sheets(sheet) == 1 && number_of_components(sheet) == 1);
  assert(number_of_cycles(sheet) == 0);  // no holes
  assert(num_edges(sheet.graph) == 0);   // and no strands
  assert(count(sheet.labels, psc::Meso_label::SHEET) == sheet.labels.size());
  assert(error(sheet, plate) < 0.5);
  double area = 0;
  for(const auto& t : sheet.triangles)
    area += std::sqrt(CGAL::squared_area(sheet.graph[t[0]].point, sheet.graph[t[1]].point,
                                         sheet.graph[t[2]].point));
  assert(area > 3.2 && area < 4.1);  // of 4: no fold, up to the rim

  // a rod that carries a plate
  const auto sign = synthetic::united({synthetic::plate(2, 2, 0.12),
                                       synthetic::capsule(Vec3(0, 0, 0), Vec3(0, -3, 0), 0.25)});
  const Meso_skeleton mixed = meso_skeleton(
    synthetic::scan(sign, {both[0], both[1], Vec3(1, 0, .3), Vec3(-1, 0, -.3)}, 15000, 6), 4000);
  assert(number_of_sheets(mixed) == 1 && number_of_components(mixed) == 1);
  for(std::size_t v = 0; v < num_vertices(mixed.graph); ++v) {
    const Vec3 p = vec3(mixed.graph[v].point);
    if(p.y() < -1.4)
      assert(mixed.vertex_labels[v] == psc::Meso_label::CURVE ||
             mixed.vertex_labels[v] == psc::Meso_label::END);
    if(std::abs(p.x()) > 0.6)
      assert(mixed.vertex_labels[v] == psc::Meso_label::SHEET);
  }

  // files
  const auto lines_that_begin = [](const char* file, const std::string& with) {
    std::ifstream in(file);
    std::size_t lines = 0;
    for(std::string line; std::getline(in, line);)
      lines += line.compare(0, with.size(), with) == 0;
    return lines;
  };
  for(const char* const file : {"meso.ma", "meso.obj", "meso.ply"})
    assert(CGAL::IO::write_meso_skeleton(file, mixed));
  assert(lines_that_begin("meso.ma", "v ") == num_vertices(mixed.graph));
  assert(lines_that_begin("meso.ma", "f ") == mixed.triangles.size());
  assert(lines_that_begin("meso.ma", "e ") > num_edges(mixed.graph));
  assert(lines_that_begin("meso.obj", "l ") == num_edges(mixed.graph));
  assert(lines_that_begin("meso.obj", "f ") == mixed.triangles.size());
  CGAL::Curve_skeleton_3<Kernel> read;
  assert(CGAL::IO::read_curve_skeleton("meso.ply", read));
  assert(num_vertices(read) == num_vertices(mixed.graph) && num_edges(read) == num_edges(mixed.graph));
  for(const char* const file : {"meso.ma", "meso.obj", "meso.ply"})
    std::remove(file);
  try {
    CGAL::IO::write_meso_skeleton("meso.txt", mixed);
    assert(false);
  }
  catch(const std::invalid_argument&) {}
}

/// A patch that nothing opposes: everything is a guess, but nothing is lost.
void meso_skeleton_of_a_patch()
{
  const Scan scan = synthetic::scan(synthetic::plate(2, 2, 0.4), {Vec3(0, 0, 1)}, 6000, 7);
  const Meso_skeleton guess = meso_skeleton(scan, 1500);
  assert(count(guess.labels, psc::Meso_label::UNANCHORED) == guess.labels.size());

  CGAL::Deep_points_consolidation_3<Kernel> consolidation(
    rays(scan), params::point_map(First()).number_of_output_points(300));
  Meso_skeleton skeleton;
  try {
    CGAL::meso_skeleton_to_graph(consolidation, skeleton, params::sampling_radius(2));
    assert(false);
  }
  catch(const std::invalid_argument& error) {
    assert(std::string(error.what()).find("sampling_radius") != std::string::npos);
  }
  assert(num_vertices(skeleton.graph) == 0);
}

}  // namespace

int main()
{
  meso_skeleton_of_tubes();
  meso_skeleton_of_sheets();
  meso_skeleton_of_a_patch();
  return EXIT_SUCCESS;
}
