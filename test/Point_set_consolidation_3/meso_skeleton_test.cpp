// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meso-skeletons as curves and sheets, on shapes whose skeletons are known.

#undef NDEBUG

#include "scan_rays.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_homology.h>
#include <CGAL/Point_set_consolidation_3/internal/spanning_disc.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace {

namespace psc = CGAL::Point_set_consolidation_3;
namespace core = CGAL::Point_set_consolidation_3::internal;
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

/// Cycles modulo the triangles between them.
void homology()
{
  std::cout << "homology" << std::endl;
  core::Skeleton_graph graph;
  graph.nodes.resize(6);
  for(std::size_t v = 0; v < 6; ++v)
    graph.nodes[v].position = (v < 3 ? 1. : 3.) * Vec3(std::cos(2.1 * double(v)), std::sin(2.1 * double(v)), 0);
  // a ring of six triangles between an inner triangle 0 1 2 and an outer one 3 4 5
  std::vector<core::Sheet_triangle> ring = {{0, 1, 4}, {0, 3, 4}, {1, 2, 5}, {1, 4, 5}, {0, 2, 3}, {2, 3, 5}};
  graph.edges = core::all_edges({}, ring);
  const core::Skeleton_homology one(graph, ring);
  assert(one.number_of_cycles() == 1);
  std::vector<std::size_t> inner = one.shortest_basis().front();
  std::sort(inner.begin(), inner.end());
  assert((inner == std::vector<std::size_t>{0, 1, 2}));
  ring.push_back({0, 1, 2});
  assert(core::Skeleton_homology(graph, ring).number_of_cycles() == 0);
  const core::Skeleton_homology bare(graph, {});
  assert(bare.number_of_cycles() == 7 && bare.shortest_basis().size() == 7);
  // the sides of a tetrahedron enclose a cavity, and no cycle
  const std::vector<core::Sheet_triangle> closed = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  graph.nodes.resize(4);
  graph.edges = core::all_edges({}, closed);
  assert(core::Skeleton_homology(graph, closed).number_of_cycles() == 0);
}

/// Discs across a hole leave the shape, others do not.
void spanning_discs()
{
  std::cout << "spanning discs" << std::endl;
  const Shape ring = synthetic::torus(10, 3);
  const std::vector<Vec3> points = synthetic::samples(ring, 1500, 1);
  std::vector<Vec3> normals;
  for(const Vec3& p : points)
    normals.push_back(ring.normal(p));
  const core::Spanning_disc disc(points, normals);
  std::vector<Vec3> around, within;
  for(int k = 0; k < 12; ++k) {
    const double angle = k * std::acos(-1.) / 6;
    around.emplace_back(10 * std::cos(angle), 10 * std::sin(angle), 0);
    within.emplace_back(10 + 2 * std::cos(angle), 0, 2 * std::sin(angle));
  }
  assert(disc.leaves_the_shape(around) && disc.share_inside(around) < 0.6);
  assert(!disc.leaves_the_shape(within) && disc.share_inside(within) == 1);
}

/// A hole of a sheet is a cycle, gaps between its triangles are none; with curves only a ring is left of it.
void holes_of_sheets()
{
  std::cout << "holes of sheets" << std::endl;
  const Shape plate = synthetic::plate(3, 3, 0.12);
  const Shape washer([&](const Vec3& p) { return (std::max)(plate.distance(p), 0.7 - std::hypot(p.x(), p.y())); },
                     [](const Vec3& p) { return std::abs(p.z()); }, plate.lower, plate.upper);
  CGAL::Deep_points_consolidation_3<Kernel, CGAL::Parallel_if_available_tag> consolidation(
    rays(synthetic::scan(washer, {Vec3(.3, .2, 1), Vec3(-.2, -.3, -1)}, 12000, 8)),
    params::point_map(First()).view_direction_map(Second()).number_of_output_points(3000));
  Meso_skeleton sheet, curves;
  assert(CGAL::meso_skeleton_to_graph(consolidation, sheet));
  assert(number_of_sheets(sheet) == 1 && number_of_components(sheet) == 1 && number_of_cycles(sheet) == 1);
  assert(CGAL::meso_skeleton_to_graph(consolidation, curves, params::curves_only(true)));
  assert(curves.triangles.empty() && number_of_components(curves) == 1 && number_of_cycles(curves) == 1);
}

/// One view of three limbs: curves to their ends.
void curves_of_one_view()
{
  std::cout << "curves of one view" << std::endl;
  const Vec3 ends[] = {Vec3(0, 0, -2), Vec3(1.4, 0, 1.4), Vec3(-1.4, 0, 1.4)};
  std::vector<Shape> limbs;
  for(const Vec3& end : ends)
    limbs.push_back(synthetic::capsule(Vec3(0, 0, 0), end, 0.35));
  CGAL::Deep_points_consolidation_3<Kernel, CGAL::Parallel_if_available_tag> consolidation(
    rays(synthetic::scan(synthetic::united(limbs), {Vec3(.2, 1, .1)}, 12000, 3)),
    params::point_map(First()).view_direction_map(Second()).number_of_output_points(3000));
  Meso_skeleton kept, extended;
  assert(CGAL::meso_skeleton_to_graph(consolidation, kept,
                                      params::curves_only(true).extend_tips(false)));
  assert(CGAL::meso_skeleton_to_graph(consolidation, extended, params::curves_only(true)));
  assert(num_vertices(extended.graph) == num_vertices(kept.graph) + 3);
  assert(extended.vertex_labels.size() == num_vertices(extended.graph));
  for(const Meso_skeleton* skeleton : {&kept, &extended}) {
    assert(number_of_components(*skeleton) == 1 && number_of_cycles(*skeleton) == 0);
    assert(vertices_of_degree(*skeleton, 1) == 3 && vertices_of_degree(*skeleton, 3) == 1);
  }
  for(std::size_t v = num_vertices(kept.graph); v < num_vertices(extended.graph); ++v) {
    double nearest = 10;
    for(const Vec3& end : ends)
      nearest = (std::min)(nearest, (vec3(extended.graph[v].point) - (1 + 0.35 / end.norm()) * end).norm());
    assert(nearest < 0.2);  // of the end of the cap
    assert(extended.graph[v].radius == 0 && extended.graph[v].points.empty());
  }
}

}  // namespace

int main()
{
  homology();
  spanning_discs();
  meso_skeleton_of_tubes();
  meso_skeleton_of_sheets();
  meso_skeleton_of_a_patch();
  holes_of_sheets();
  curves_of_one_view();
  return EXIT_SUCCESS;
}
