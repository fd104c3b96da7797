// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
namespace editing = CGAL::Curve_skeleton_editing;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Tag = CGAL::Sequential_tag;

constexpr double tube_radius = 0.4, half_length = 1.35, gap = 0.8;

/// A tube with round ends along the z-axis, without its middle.
std::vector<Point> tube_with_gap(std::size_t n)
{
  benchmark::Random_numbers random(1);
  std::vector<Point> points;
  while(points.size() < n) {
    const double z = random.uniform(-half_length - tube_radius, half_length + tube_radius);
    const double a = random.uniform(0, 2 * CGAL_PI);
    const double beyond = (std::max)(0., std::abs(z) - half_length);
    const double r = std::sqrt(tube_radius * tube_radius - beyond * beyond);
    if(std::abs(z) > gap / 2)
      points.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return points;
}

Skeleton axis(double radius)
{
  Skeleton skeleton;
  constexpr int count = 28;
  for(int i = 0; i < count; ++i) {
    const double z = -half_length + 2 * half_length * i / (count - 1);
    editing::add_vertex<Kernel>(skeleton, Point(0, 0, z), radius);
    if(i > 0)
      add_edge(std::size_t(i - 1), std::size_t(i), skeleton);
  }
  return skeleton;
}

std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<char> seen(mesh.number_of_vertices(), 0);
  std::size_t count = 0;
  for(const Mesh::Vertex_index start : mesh.vertices()) {
    if(seen[start])
      continue;
    ++count;
    std::vector<Mesh::Vertex_index> stack(1, start);
    seen[start] = 1;
    while(!stack.empty()) {
      const Mesh::Vertex_index v = stack.back();
      stack.pop_back();
      for(const Mesh::Vertex_index w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        if(!seen[w]) {
          seen[w] = 1;
          stack.push_back(w);
        }
    }
  }
  return count;
}

double volume(const Mesh& mesh)
{
  double sum = 0;
  for(const Mesh::Face_index f : mesh.faces()) {
    std::vector<Vector> c;
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      c.push_back(mesh.point(v) - CGAL::ORIGIN);
    sum += c[0] * CGAL::cross_product(c[1], c[2]) / 6;
  }
  return sum;
}

/// Distance to the complete tube, largest and mean over the vertices.
std::pair<double, double> errors(const Mesh& mesh)
{
  double largest = 0, sum = 0;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double z = (std::max)(-half_length, (std::min)(half_length, p.z()));
    const double d =
      std::abs(std::sqrt(CGAL::squared_distance(p, Point(0, 0, z))) - tube_radius);
    largest = (std::max)(largest, d);
    sum += d;
  }
  return std::make_pair(largest, sum / double(mesh.number_of_vertices()));
}

template <typename NamedParameters>
Mesh reconstruct(const std::vector<Point>& points, const Skeleton& skeleton, const NamedParameters& np)
{
  Mesh mesh;
  assert(CGAL::skeleton_driven_surface_reconstruction<Tag>(points, skeleton, mesh, np));
  assert(mesh.is_valid() && CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh));
  return mesh;
}

void check_tube(const Mesh& mesh, const char* name)
{
  const double diagonal = std::sqrt(2 * 0.8 * 0.8 + 3.5 * 3.5);
  const double true_volume = CGAL_PI * tube_radius * tube_radius * (2 * half_length + 4. / 3 * tube_radius);
  const std::pair<double, double> e = errors(mesh);
  std::cerr << name << ": error mean " << 100 * e.second / diagonal << " % of the diagonal, largest "
            << 100 * e.first / diagonal << " %, volume ratio " << volume(mesh) / true_volume << "\n";
  assert(number_of_components(mesh) == 1);
  assert(e.second < 0.0025 * diagonal && e.first < 0.02 * diagonal);
  assert(volume(mesh) > 0.9 * true_volume && volume(mesh) < 1.1 * true_volume);
}

void test_tube()
{
  const std::vector<Point> points = tube_with_gap(4000);
  const Mesh octree = reconstruct(points, axis(tube_radius), params::grid_resolution(48));
  check_tube(octree, "octree, radii given");
  check_tube(reconstruct(points, axis(0), params::grid_resolution(48)), "octree, radii estimated");
  const Mesh regular = reconstruct(points, axis(tube_radius), params::grid_resolution(24).adaptive(false));
  assert(number_of_components(regular) == 1);

#ifdef CGAL_LINKED_WITH_TBB
  Mesh parallel;
  CGAL::skeleton_driven_surface_reconstruction<CGAL::Parallel_tag>(
    points, axis(tube_radius), parallel, params::grid_resolution(48));
  assert(parallel.number_of_vertices() == octree.number_of_vertices());
  for(const Mesh::Vertex_index v : octree.vertices())
    assert(parallel.point(v) == octree.point(v));
#endif
}

/// The topology is the skeleton's: cut in the gap, the tube is two.
void test_topology()
{
  const std::vector<Point> points = tube_with_gap(4000);
  Skeleton skeleton = axis(tube_radius);
  std::istringstream edits("remove 12\nremove 13\nremove 14\nremove 15\nremove 11\nremove 16\nradius 10 0.3\n"
                           "radius 17 0.3\n");
  editing::apply_edits(skeleton, edits);
  assert(CGAL::number_of_skeleton_components(skeleton) == 2);
  const Mesh mesh = reconstruct(points, skeleton, params::grid_resolution(48).outside_factor(1.2).outside_weight(0.5));
  assert(number_of_components(mesh) == 2);
}

template <typename Exception, typename Work>
bool throws(const Work& work)
{
  try {
    work();
  }
  catch(const Exception&) {
    return true;
  }
  return false;
}

void test_errors()
{
  const std::vector<Point> points = tube_with_gap(500);
  Mesh mesh;
  const auto fails = [&](const auto& input, const Skeleton& skeleton, const auto& np) {
    return throws<std::invalid_argument>(
      [&] { CGAL::skeleton_driven_surface_reconstruction<Tag>(input, skeleton, mesh, np); });
  };
  assert(fails(points, Skeleton(), params::default_values()));
  assert(fails(points, axis(-1), params::default_values()));
  assert(fails(points, axis(tube_radius), params::grid_resolution(2)));
  assert(fails(points, axis(tube_radius), params::surface_weight(-1.)));
  assert(fails(std::vector<Point>(10, Point(0, 0, 0)), axis(tube_radius), params::default_values()));
  assert(mesh.is_empty());
  int calls = 0;
  assert(!CGAL::skeleton_driven_surface_reconstruction<Tag>(
    points, axis(tube_radius), mesh, params::callback([&](double) { return ++calls < 3; })));
  assert(mesh.is_empty());
}

}  // namespace

int main()
{
  test_tube();
  test_topology();
  test_errors();
  std::cout << "skeleton_reconstruction_test: all good\n";
}
