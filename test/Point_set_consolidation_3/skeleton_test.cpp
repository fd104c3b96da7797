// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_thinning.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
namespace editing = CGAL::Curve_skeleton_editing;
namespace core = CGAL::Point_set_consolidation_3::internal;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Tag = CGAL::Sequential_tag;

/// A torus around the z-axis: its skeleton is the circle of the larger radius.
std::vector<Point> torus(std::size_t n, double large, double small)
{
  benchmark::Random_numbers random(1);
  std::vector<Point> points;
  while(points.size() < n) {
    const double u = random.uniform(0, 2 * CGAL_PI), v = random.uniform(0, 2 * CGAL_PI);
    const double r = large + small * std::cos(v);
    if(random.uniform(0, large + small) < r)
      points.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v));
  }
  return points;
}

/// A tube along the z-axis with round ends.
std::vector<Point> capsule(std::size_t n, double radius, double half_length,
                           std::vector<Vector>* normals = nullptr, bool one_sided = false)
{
  benchmark::Random_numbers random(1);
  std::vector<Point> points;
  while(points.size() < n) {
    const double z = random.uniform(-half_length - radius, half_length + radius);
    const double a = random.uniform(0, 2 * CGAL_PI);
    const double beyond = (std::max)(0., std::abs(z) - half_length);
    const double r = std::sqrt(radius * radius - beyond * beyond);
    if(one_sided && std::sin(a) < 0)
      continue;
    points.emplace_back(r * std::cos(a), r * std::sin(a), z);
    if(normals != nullptr)
      normals->push_back(Vector(r * std::cos(a), r * std::sin(a), z < 0 ? -beyond : beyond) / radius);
  }
  return points;
}

Skeleton skeleton_of(const std::vector<Point>& points)
{
  Skeleton skeleton;
  assert(CGAL::extract_laplacian_contraction_skeleton<Tag>(points, skeleton));
  return skeleton;
}

std::size_t tips(const Skeleton& skeleton)
{
  std::size_t count = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    count += degree(v, skeleton) == 1;
  return count;
}

void check_is_finite(const Skeleton& skeleton)
{
  assert(num_vertices(skeleton) > 0);
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Point& p = skeleton[v].point;
    assert(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    assert(std::isfinite(skeleton[v].radius) && skeleton[v].radius >= 0);
  }
}

/// Every point belongs to exactly one vertex.
void check_points(const Skeleton& skeleton, std::size_t n)
{
  std::vector<int> count(n, 0);
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    for(const std::size_t i : skeleton[v].points)
      ++count.at(i);
  assert(std::all_of(count.begin(), count.end(), [](int c) { return c == 1; }));
}

bool are_equal(const Skeleton& a, const Skeleton& b, double scale = 1)
{
  if(num_vertices(a) != num_vertices(b) || num_edges(a) != num_edges(b))
    return false;
  for(std::size_t v = 0; v < num_vertices(a); ++v) {
    const Vector d = Vector(CGAL::ORIGIN, b[v].point) - scale * Vector(CGAL::ORIGIN, a[v].point);
    if(std::sqrt(d.squared_length()) > (scale == 1 ? 0 : 1e-6 * scale) || a[v].points != b[v].points)
      return false;
  }
  return true;
}

void test_torus()
{
  const std::vector<Point> points = torus(4000, 1, 0.25);
  const Skeleton skeleton = skeleton_of(points);
  check_is_finite(skeleton);
  check_points(skeleton, points.size());
  assert(CGAL::number_of_skeleton_components(skeleton) == 1);
  assert(CGAL::number_of_skeleton_cycles(skeleton) == 1);
  assert(tips(skeleton) == 0);
  double length = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Point& p = skeleton[v].point;
    assert(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) < 0.08);
    assert(std::abs(skeleton[v].radius - 0.25) < 0.05);
  }
  const auto range = edges(skeleton);
  for(auto e = range.first; e != range.second; ++e)
    length += std::sqrt(CGAL::squared_distance(skeleton[source(*e, skeleton)].point,
                                               skeleton[target(*e, skeleton)].point));
  assert(length > 0.9 * 2 * CGAL_PI && length < 1.1 * 2 * CGAL_PI);
}

void test_capsule()
{
  const std::vector<Point> points = capsule(3000, 0.3, 1.5);
  const Skeleton skeleton = skeleton_of(points);
  assert(CGAL::number_of_skeleton_components(skeleton) == 1);
  assert(CGAL::number_of_skeleton_cycles(skeleton) == 0);
  assert(tips(skeleton) == 2);
  double lowest = 0, highest = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Point& p = skeleton[v].point;
    assert(std::hypot(p.x(), p.y()) < 0.12);
    lowest = (std::min)(lowest, p.z());
    highest = (std::max)(highest, p.z());
  }
  // tips reach the end of the shape
  assert(std::abs(highest - 1.8) < 0.03 && std::abs(lowest + 1.8) < 0.03);
}

/// On one-sided data the mean lies near the visible side; with normals the axis is found.
void test_recentring_with_normals()
{
  std::vector<Vector> normals;
  const std::vector<Point> points = capsule(3000, 0.3, 1.5, &normals, true);
  std::vector<std::size_t> indices(points.size());
  for(std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  const auto mean_offset = [&](const auto& np) {
    Skeleton skeleton;
    CGAL::extract_laplacian_contraction_skeleton<Tag>(indices, skeleton, np.extend_tips(false));
    double sum = 0;
    for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
      sum += std::hypot(skeleton[v].point.x(), skeleton[v].point.y());
    return sum / double(num_vertices(skeleton));
  };
  const auto positions = params::point_map(CGAL::make_property_map(points));
  const double by_mean = mean_offset(positions);
  const double by_normals = mean_offset(positions.normal_map(CGAL::make_property_map(normals)));
  std::cerr << "one-sided capsule, distance to the axis: mean " << by_mean << ", normals "
            << by_normals << "\n";
  assert(by_normals < 0.06);
  assert(by_normals < 0.5 * by_mean);
}

void test_two_parts()
{
  std::vector<Point> points = torus(1500, 1, 0.25);
  for(const Point& p : torus(1500, 1, 0.25))
    points.push_back(p + Vector(10, 0, 0));
  Skeleton skeleton = skeleton_of(points);
  assert(CGAL::number_of_skeleton_components(skeleton) == 2);
  assert(CGAL::number_of_skeleton_cycles(skeleton) == 2 || CGAL::number_of_skeleton_cycles(skeleton) == 0);
  assert(editing::bridge_components(skeleton, 5.) == 0);
  assert(editing::bridge_components(skeleton, 20.) == 1);
  assert(CGAL::number_of_skeleton_components(skeleton) == 1);
}

/// A limb as modellers draw it: circles of many points each, farther from each other than their points.
void test_rings_apart()
{
  for(const std::size_t limbs : {1, 2}) {
    std::vector<Point> points;
    for(std::size_t limb = 0; limb < limbs; ++limb)
      for(int ring = 0; ring < 20; ++ring)
        for(int k = 0; k < 80; ++k) {
          const double a = 2 * CGAL_PI * (k + 0.3 * ring) / 80;
          points.emplace_back(20. * double(limb) + std::cos(a), std::sin(a), 0.7 * ring);
        }
    Skeleton skeleton, of_twelve;
    CGAL::extract_laplacian_contraction_skeleton<Tag>(points, skeleton);
    assert(CGAL::number_of_skeleton_components(skeleton) == limbs);
    assert(tips(skeleton) == 2 * limbs);
    CGAL::extract_laplacian_contraction_skeleton<Tag>(points, of_twelve, params::k_neighbors(12));
    assert(CGAL::number_of_skeleton_components(of_twelve) > limbs);  // the default of even samples
  }
}

void test_invariance()
{
  const std::vector<Point> points = torus(2000, 1, 0.25);
  const Skeleton skeleton = skeleton_of(points);
  std::vector<Point> scaled;
  for(const Point& p : points)
    scaled.push_back(CGAL::ORIGIN + 1e6 * Vector(CGAL::ORIGIN, p));
  assert(are_equal(skeleton, skeleton_of(scaled), 1e6));
#ifdef CGAL_LINKED_WITH_TBB
  Skeleton parallel;
  CGAL::extract_laplacian_contraction_skeleton<CGAL::Parallel_tag>(points, parallel);
  assert(are_equal(skeleton, parallel));
#endif
}

void test_weights()
{
  using CGAL::Point_set_consolidation_3::Laplacian_weights;
  const std::vector<Point> points = torus(2000, 1, 0.25);
  for(const Laplacian_weights weights : {Laplacian_weights::MEAN_VALUE, Laplacian_weights::COMBINATORIAL}) {
    Skeleton skeleton;
    CGAL::extract_laplacian_contraction_skeleton<Tag>(points, skeleton, params::laplacian_weights(weights));
    check_is_finite(skeleton);
    assert(CGAL::number_of_skeleton_components(skeleton) == 1);
  }
}

void test_steps()
{
  const std::vector<Point> points = torus(2000, 1, 0.25);
  CGAL::Laplacian_contraction_skeletonization_3<Kernel> steps(points);
  double last = 0.25;
  for(int i = 0; i < 3; ++i) {
    assert(steps.contract_geometry());
    std::vector<Point> contracted;
    steps.contracted_points(std::back_inserter(contracted));
    assert(contracted.size() == points.size());
    double mean = 0;
    for(const Point& p : contracted)
      mean += std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) / double(points.size());
    assert(mean < last);
    last = mean;
  }
  assert(steps.contract_until_convergence() && steps.has_converged());
  Skeleton graph, thin;
  assert(steps.build_graph());
  steps.skeleton(graph);
  assert(steps.thin());
  steps.skeleton(thin);
  assert(num_vertices(thin) <= num_vertices(graph));
  assert(CGAL::number_of_skeleton_cycles(thin) == 1);
}

void test_soup()
{
  // a closed box of 1 x 1 x 6, every triangle with vertices of its own
  const double x[2] = {0, 1}, z[2] = {0, 6};
  std::vector<Point> corners;
  for(int c = 0; c < 8; ++c)
    corners.emplace_back(x[c & 1], x[c >> 1 & 1], z[c >> 2]);
  const int quads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  for(const auto& quad : quads)
    for(const auto& t : {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{0, 2, 3}}) {
      polygons.emplace_back();
      for(const int k : t) {
        polygons.back().push_back(points.size());
        points.push_back(corners[std::size_t(quad[k])]);
      }
    }
  Skeleton skeleton;
  assert(CGAL::extract_laplacian_contraction_skeleton<Tag>(points, polygons, skeleton,
                                                           params::number_of_samples(2000)));
  check_is_finite(skeleton);
  check_points(skeleton, points.size());
  assert(CGAL::number_of_skeleton_components(skeleton) == 1);
  assert(CGAL::number_of_skeleton_cycles(skeleton) == 0);
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    if(skeleton[v].point.z() > 1 && skeleton[v].point.z() < 5)
      assert(std::hypot(skeleton[v].point.x() - 0.5, skeleton[v].point.y() - 0.5) < 0.1);
}

void test_degenerate_input()
{
  benchmark::Random_numbers random(1);
  {
    const Skeleton skeleton = skeleton_of(std::vector<Point>(50, Point(1, 2, 3)));
    assert(num_vertices(skeleton) == 1 && skeleton[0].point == Point(1, 2, 3));
  }
  {
    std::vector<Point> line;
    for(int i = 0; i < 100; ++i)
      line.emplace_back(random.uniform(0, 1), 0, 0);
    const Skeleton skeleton = skeleton_of(line);
    check_is_finite(skeleton);
    assert(CGAL::number_of_skeleton_components(skeleton) == 1 && tips(skeleton) == 2);
    assert(CGAL::number_of_skeleton_cycles(skeleton) == 0);
  }
  {
    std::vector<Point> sheet, grid;
    for(int i = 0; i < 2000; ++i)
      sheet.emplace_back(random.uniform(0, 1), random.uniform(0, 1), 0);
    for(int i = 0; i < 40; ++i)
      for(int j = 0; j < 40; ++j)
        grid.emplace_back(i, j, 0);
    check_is_finite(skeleton_of(sheet));
    check_is_finite(skeleton_of(grid));
  }
  {
    std::vector<Point> sphere;
    while(sphere.size() < 1500) {
      const Vector v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if(v.squared_length() < 1 && v.squared_length() > 0.01)
        sphere.push_back(CGAL::ORIGIN + v / std::sqrt(v.squared_length()));
    }
    const Skeleton skeleton = skeleton_of(sphere);
    check_is_finite(skeleton);
    assert(CGAL::number_of_skeleton_cycles(skeleton) == 0);
    std::vector<Point> outliers = sphere, twice = sphere;
    for(int i = 0; i < 45; ++i)
      outliers.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    check_is_finite(skeleton_of(outliers));
    twice.insert(twice.end(), sphere.begin(), sphere.end());
    const Skeleton doubled = skeleton_of(twice);
    assert(num_vertices(doubled) == num_vertices(skeleton));
    check_points(doubled, twice.size());
  }
  for(std::size_t n = 4; n < 12; ++n) {
    std::vector<Point> few;
    for(std::size_t i = 0; i < n; ++i)
      few.emplace_back(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    check_is_finite(skeleton_of(few));
  }
}

template <typename Work>
bool throws(const Work& work)
{
  try {
    work();
  }
  catch(const std::invalid_argument&) {
    return true;
  }
  return false;
}

void test_errors()
{
  const std::vector<Point> points = torus(200, 1, 0.25);
  Skeleton skeleton;
  const auto extract = [&](const auto& input, const auto& np) {
    return throws([&] { CGAL::extract_laplacian_contraction_skeleton<Tag>(input, skeleton, np); });
  };
  assert(extract(std::vector<Point>(3), params::default_values()));
  assert(extract(std::vector<Point>(5, Point(0, 0, std::numeric_limits<double>::quiet_NaN())),
                 params::default_values()));
  assert(extract(points, params::contraction_factor(0.5)));
  assert(extract(points, params::sampling_radius(-1.)));
  assert(extract(points, params::k_neighbors(2)));
  assert(extract(points, params::laplacian_weights(CGAL::Point_set_consolidation_3::Laplacian_weights(3))));
  assert(extract(points, params::laplacian_weights(CGAL::Point_set_consolidation_3::Laplacian_weights(-1))));
  assert(num_vertices(skeleton) == 0);
  const std::vector<std::vector<std::size_t> > bad = {{0, 1, 1000}};
  assert(throws([&] { CGAL::extract_laplacian_contraction_skeleton<Tag>(points, bad, skeleton); }));
}

void test_callback()
{
  const std::vector<Point> points = torus(1000, 1, 0.25);
  Skeleton skeleton;
  double last = 0;
  assert(CGAL::extract_laplacian_contraction_skeleton<Tag>(points, skeleton, params::callback([&](double f) {
    assert(f >= last && f <= 1);
    last = f;
    return true;
  })));
  assert(last == 1);
  const std::size_t vertices = num_vertices(skeleton);
  int calls = 0;
  assert(!CGAL::extract_laplacian_contraction_skeleton<Tag>(
    torus(500, 1, 0.3), skeleton, params::callback([&](double) { return ++calls < 3; })));
  assert(num_vertices(skeleton) == vertices);
}

/// A cycle 0 1 2 3 with a chain 3 4 5 and a spur 4 6.
Skeleton small_skeleton()
{
  Skeleton skeleton;
  const double places[7][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}, {0, 4}, {0.1, 2}};
  for(const auto& place : places)
    editing::add_vertex<Kernel>(skeleton, Point(place[0], place[1], 0), 0.5);
  const std::size_t ends[7][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}, {4, 5}, {4, 6}};
  for(const auto& e : ends)
    editing::connect(skeleton, e[0], e[1]);
  return skeleton;
}

/// Edges of the graph that is left of two strands of three nodes, joined at their ends, by what their points were on
/// the surface: two whole tubes beside a hole, or the halves of one tube.
std::size_t edges_of_strands(bool are_whole)
{
  namespace psc = CGAL::Point_set_consolidation_3::internal;
  constexpr std::size_t nodes = 6, per_ring = 40, rings = 5;
  psc::Points thin, surface;
  std::vector<std::array<std::size_t, 2>> connections;
  for(std::size_t node = 0; node < nodes; ++node) {
    // left strand upwards, right strand downwards
    const double side = node < 3 ? -1 : 1, height = node < 3 ? double(node) : double(5 - node);
    const psc::Vec3 axis(are_whole ? 1.05 * side : 0, 0, height);
    for(std::size_t ring = 0; ring < rings; ++ring)
      for(std::size_t k = 0; k < per_ring; ++k) {
        const double turn = (double(k) + 0.5) / double(per_ring);
        const double angle = are_whole ? 2 * CGAL_PI * turn : CGAL_PI * (turn - 0.5) + (side < 0 ? CGAL_PI : 0);
        const double offset = (double(ring) - 2) / double(rings);
        surface.push_back(axis + psc::Vec3(std::cos(angle), std::sin(angle), offset));
        thin.push_back(psc::Vec3(0.6 * side, 0, height));
      }
    const std::size_t next = (node + 1) % nodes * rings * per_ring;
    connections.push_back({node * rings * per_ring, next});
  }
  psc::Thinning_parameters parameters;
  parameters.sampling_radius = 0.1;
  psc::Skeleton_thinning thinning(thin, connections, parameters, surface);
  thinning.thin();
  return thinning.graph().edges.size();
}

void test_small_handles()
{
  assert(edges_of_strands(true) == 6);   // a handle of few nodes stays
  assert(edges_of_strands(false) == 0);  // two sides of one tube become one node
}

void test_editing()
{
  const Skeleton original = small_skeleton();
  assert(CGAL::number_of_skeleton_cycles(original) == 1);
  Skeleton s = original;
  editing::prune_spurs(s, 0.5);
  assert(num_vertices(s) == 6 && tips(s) == 1);
  s = original;
  editing::delete_cycle(s, 1);
  assert(CGAL::number_of_skeleton_cycles(s) == 0 && num_vertices(s) == 4);
  s = original;
  editing::delete_cycle(s, 3);
  assert(CGAL::number_of_skeleton_cycles(s) == 0 && num_vertices(s) == 7);
  s = original;
  editing::collapse_cycle(s, 3);
  assert(CGAL::number_of_skeleton_cycles(s) == 0 && num_vertices(s) == 4);
  assert(s[0].point == Point(0.5, 0.5, 0));
  s = original;
  editing::disconnect(s, 3, 4);
  assert(CGAL::number_of_skeleton_components(s) == 2);
  assert(editing::bridge_components(s, 1.5) == 1);
  assert(edge(3, 4, s).second);
  s = original;
  editing::set_radius(s, 3, 1.);
  editing::set_radius(s, 5, 4.);
  editing::interpolate_radii(s, 3, 5);
  assert(std::abs(s[4].radius - 2) < 1e-12);
  editing::set_radius(s, 4, 0.);
  editing::set_radius(s, 6, 2.);
  editing::interpolate_radii(s);
  // balanced: (r - 1) / 1 + (r - 4) / 2 + (r - 2) / 0.1 = 0
  assert(std::abs(s[4].radius - 23. / 11.5) < 1e-9);
  s = original;
  editing::move_vertex(s, 5, Point(0, 5, 0));
  editing::extend_tips(s);
  assert(num_vertices(s) == 9 && std::abs(s[7].point.y() - 5.5) < 1e-12 && s[7].radius == 0);
  s = original;
  assert(throws([&] { editing::connect(s, 0, 99); }));
  assert(throws([&] { editing::delete_branch(s, 4); }));
  assert(throws([&] { editing::delete_cycle(s, 5); }));

  std::istringstream edits("# a repair\n"
                           "remove 6\n"
                           "delete_cycle 1   # the chain of 0, 1 and 2\n"
                           "add 0 0 0 0.25\n"
                           "connect 3 7\n"
                           "radius 5 0.75\n");
  editing::apply_edits(s, edits);
  assert(num_vertices(s) == 4 && num_edges(s) == 3 && tips(s) == 2);
  assert(s[3].radius == 0.25 && s[2].radius == 0.75);
  s = original;
  std::istringstream wrong("prune 0.5\nconnect 0 6\n");
  assert(throws([&] { editing::apply_edits(s, wrong); }));
  assert(num_vertices(s) == 7);
}

struct Counting_visitor {
  std::size_t& polylines;
  std::size_t& nodes;
  void start_new_polyline() { ++polylines; }
  void add_node(std::size_t) { ++nodes; }
  void end_polyline() {}
};

void test_files()
{
  const Skeleton skeleton = small_skeleton();
  std::size_t polylines = 0, nodes = 0;
  Counting_visitor visitor{polylines, nodes};
  CGAL::split_graph_into_polylines(skeleton, visitor);
  assert(polylines == 4 && nodes == 5 + 2 + 2 + 2);
  assert(core::polylines_of(core::to_skeleton_graph(skeleton)).size() == 4);

  std::stringstream stream;
  assert(CGAL::IO::write_curve_skeleton_PLY(stream, skeleton));
  Skeleton copy;
  assert(CGAL::IO::read_curve_skeleton_PLY(stream, copy));
  assert(are_equal(skeleton, copy) && copy[2].radius == 0.5);
  std::istringstream broken("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n");
  std::string message;
  assert(!CGAL::IO::read_curve_skeleton_PLY(broken, copy, &message));
  assert(!message.empty() && num_vertices(copy) == 7);
}

}  // namespace

int main()
{
  test_small_handles();
  test_editing();
  test_files();
  test_torus();
  test_capsule();
  test_recentring_with_normals();
  test_two_parts();
  test_rings_apart();
  test_invariance();
  test_weights();
  test_steps();
  test_soup();
  test_degenerate_input();
  test_errors();
  test_callback();
  std::cout << "skeleton_test: all good\n";
}
