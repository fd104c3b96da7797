// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Facts about the field that fuses the parts of a feature-enhanced reconstruction: of two tubes side by side, seen
// from two sides only.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/core/feature_enhanced.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_reconstruction.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <set>
#include <string>

namespace {

using namespace CGAL::Point_set_consolidation_3;
using benchmark::Random_numbers;
using internal::Points;
using internal::Vec3;

constexpr double radius = 0.25, length = 3, gap = 0.12;

// Two tubes with round ends along x, held together by a bar along y at x = 0.
double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - (std::min)(1., (std::max)(0., t)) * (b - a)).norm();
}
double distance(const Vec3& p)
{
  const double y = radius + gap / 2;
  const Vec3 a(0, -y, 0), b(0, y, 0), along(length, 0, 0);
  return (std::min)({distance_to_segment(p, a, a + along), distance_to_segment(p, b, b + along),
                     distance_to_segment(p, a, b)}) - radius;
}
Vec3 normal(const Vec3& p)
{
  constexpr double h = 1e-5;
  Vec3 g;
  for(int k = 0; k < 3; ++k)
    g[k] = distance(p + h * Vec3::Unit(k)) - distance(p - h * Vec3::Unit(k));
  return g.normalized();
}

// Samples that one of two viewers, 120 degrees apart, sees at a cosine above 0.2.
void scan(std::size_t n, Points& points, Points& normals)
{
  Random_numbers random(3);
  const Vec3 views[2] = {Vec3(-0.2, 0, 1).normalized(), Vec3(0.2, 0.866, -0.5).normalized()};
  while(points.size() < n) {
    Vec3 p(random.uniform(-0.5, 3.5), random.uniform(-0.8, 0.8), random.uniform(-0.4, 0.4));
    if(std::abs(distance(p)) > 0.05)
      continue;
    for(int step = 0; step < 3; ++step)
      p -= distance(p) * normal(p);
    const Vec3 m = normal(p);
    if(std::abs(distance(p)) < 1e-6 && (m.dot(views[0]) > 0.2 || m.dot(views[1]) > 0.2)) {
      points.push_back(p);
      normals.push_back(m);
    }
  }
}

// 1 - half of the Euler number: the genus of one closed component.
double genus(const internal::Surface_triangles& surface)
{
  std::set<std::pair<std::size_t, std::size_t> > edges;
  for(const auto& t : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
  const double faces = double(surface.triangles.size());
  return 1 - (double(surface.vertices.size()) - double(edges.size()) + faces) / 2;
}

double mean_error(const internal::Surface_triangles& surface)
{
  double sum = 0;
  for(const Vec3& v : surface.vertices)
    sum += std::abs(distance(v)) / double(surface.vertices.size());
  return sum;
}

internal::Surface_triangles reconstruct(const Points& points, const Points& normals, double normal_weight,
                                        bool parallel)
{
  internal::Feature_enhanced_settings settings;
  settings.field.resolution = 64;
  settings.field.normal_weight = normal_weight;
  internal::Execution execution = {parallel, internal::Progress(), {}};
  return internal::reconstruct_feature_enhanced(execution, points, normals, {}, settings).surface;
}

// The noise of a point set is measured, whether it is smaller or larger than the spacing allows to see at once.
void measure_noise()
{
  for(const double noise : {0.1, 0.6}) {
    Random_numbers random(5);
    Points plane;
    for(int i = 0; i < 3600; ++i)
      plane.emplace_back(i % 60 + 0.3 * random.normal(), i / 60 + 0.3 * random.normal(), noise * random.normal());
    internal::Execution execution = {false, internal::Progress(), {}};
    const double measured = internal::measured_noise(execution, plane);
    std::cout << "noise " << noise << " of the spacing, measured " << measured << std::endl;
    assert(std::abs(measured - noise) < 0.25 * noise);
  }
}

// Points with noise have less weight: with the weight of exact points the surface follows the noise.
void reconstruct_noisy(const Points& points, const Points& normals)
{
  constexpr double noise = 0.06 * radius;
  Random_numbers random(5);
  Points noisy;
  for(std::size_t i = 0; i < points.size(); ++i)
    noisy.push_back(points[i] + noise * random.normal() * normals[i]);
  internal::Feature_enhanced_settings settings;
  internal::Execution execution = {false, internal::Progress(), {}};
  const double error =
    mean_error(internal::reconstruct_feature_enhanced(execution, noisy, normals, {}, settings).surface);
  settings.field.surface_weight *= 100;
  const double error_of_much_weight =
    mean_error(internal::reconstruct_feature_enhanced(execution, noisy, normals, {}, settings).surface);
  std::cout << "noise " << noise << ": error " << error << ", with a hundred times the weight "
            << error_of_much_weight << std::endl;
  assert(error < 0.4 * noise);
  assert(error < 0.8 * error_of_much_weight);
}

// A ring around z on a lattice, and what is left of its handle if none is wanted.
struct Ring {
  internal::Sparse_lattice lattice;
  std::vector<double> values;

  Ring(double major, double minor)
    : lattice({48, 48, 48}, [](std::int64_t, std::int64_t, std::vector<std::int32_t>& xs) {
        for(int x = 0; x < 48; ++x)
          xs.push_back(x);
      })
  {
    for(std::size_t i = 0; i < lattice.size(); ++i) {
      const internal::Lattice_point p = lattice.point(i);
      const double x = double(p[0]) - 23.6, y = double(p[1]) - 23.7, z = double(p[2]) - 23.3;
      values.push_back(std::hypot(std::hypot(x, y) - major, z) - minor);
    }
  }
  double surface_genus() const { return genus(internal::Marching_tetrahedra(lattice, values).run()); }
  std::size_t size_of_inside() const
  {
    return std::size_t(std::count_if(values.begin(), values.end(), [](double v) { return v < 0; }));
  }
  void remove(double wanted, double most)
  {
    internal::Handle_removal(lattice, values, most).run(wanted, [&] { return surface_genus(); });
  }
};

void remove_handles()
{
  // The weaker of bridge and tunnel is changed: a thin ring is cut, the hole of a thick one is filled.
  Ring thin(14, 3.2), thick(11, 8.8);
  const std::size_t thin_size = thin.size_of_inside(), thick_size = thick.size_of_inside();
  assert(thin.surface_genus() == 1 && thick.surface_genus() == 1);
  assert(internal::genus_of(internal::Marching_tetrahedra(thin.lattice, thin.values).run()) == 1);
  // A handle that is wanted, or deep, stays.
  thin.remove(1, 100);
  thick.remove(1, 100);
  thin.remove(0, 1);
  thick.remove(0, 1);
  assert(thin.size_of_inside() == thin_size && thick.size_of_inside() == thick_size);
  thin.remove(0, 4);
  thick.remove(0, 4);
  std::cout << "thin ring: genus " << thin.surface_genus() << ", " << thin_size - thin.size_of_inside()
            << " nodes cut; thick ring: genus " << thick.surface_genus() << ", "
            << thick.size_of_inside() - thick_size << " filled" << std::endl;
  assert(thin.surface_genus() == 0 && thick.surface_genus() == 0);
  assert(thin.size_of_inside() < thin_size && thin_size < thin.size_of_inside() + 60);    // a disc of radius 3.2
  assert(thick.size_of_inside() > thick_size && thick.size_of_inside() < thick_size + 40); // one of radius 2.2
}

// A tube along the x-axis whose middle is missing, and its axis.
struct Rod {
  static constexpr double length = 2, seen = 0.45, axis_radius = 0.08;
  Points points, normals;
  internal::Skeleton_graph axis;

  explicit Rod(double tube_radius)
  {
    for(int ring = 0; ring <= 100; ++ring) {
      const double x = ring / 50.;
      if(x > seen && x < length - seen)
        continue;
      for(int k = 0; k < 24; ++k) {
        const double turn = 6.283185307179586 * (k + 0.5 * (ring % 2)) / 24;
        normals.emplace_back(0, std::cos(turn), std::sin(turn));
        points.push_back(Vec3(x, 0, 0) + tube_radius * normals.back());
      }
    }
    for(int k = 0; k <= 10; ++k) {
      axis.nodes.push_back({Vec3(k / 5., 0, 0), axis_radius, {}});
      if(k > 0)
        axis.edges.push_back({std::size_t(k) - 1, std::size_t(k)});
    }
  }
};

// Of an axis that is given, what is completed in any case: where the data have a gap, not where a thick part is around.
void gaps_of_axis()
{
  const auto gaps = [](const Rod& rod) {
    std::string text;
    for(const char flag : internal::gap_edges(rod.axis, rod.points, rod.normals))
      text += flag ? '1' : '0';
    return text;
  };
  const Rod thin(Rod::axis_radius), thick(0.7);
  std::cout << "gaps of a rod " << gaps(thin) << ", in a thick tube " << gaps(thick) << std::endl;
  assert(gaps(thin) == "0011111100");
  assert(gaps(thick) == "0000000000");  // its gap is as long as it is wide: all around faces away
}

// The surface follows an axis that is given where there are no data.
void reconstruct_around_given_axis()
{
  const Rod rod(Rod::axis_radius);
  const auto middle = [&](const internal::Skeleton_graph& axis) {
    internal::Execution execution = {false, internal::Progress(), {}};
    const internal::Surface_triangles surface =
      internal::reconstruct_feature_enhanced(execution, rod.points, rod.normals, axis, {}).surface;
    double count = 0, error = 0;
    for(const Vec3& v : surface.vertices)
      if(std::abs(v.x() - 0.5 * Rod::length) < 0.3) {
        ++count;
        error += std::abs(std::hypot(v.y(), v.z()) - Rod::axis_radius);
      }
    std::cout << count << " vertices in the gap of a rod, error " << error / (std::max)(1., count) << std::endl;
    return std::make_pair(count, error / (std::max)(1., count));
  };
  const auto given = middle(rod.axis), none = middle({});
  assert(given.first > 50 && given.second < 0.15 * Rod::axis_radius);
  assert(none.first == 0);
}

internal::Sparse_lattice full_lattice(int nodes)
{
  return internal::Sparse_lattice({nodes, nodes, nodes}, [=](std::int64_t, std::int64_t, std::vector<std::int32_t>& xs) {
    for(int x = 0; x < nodes; ++x)
      xs.push_back(x);
  });
}

Vec3 node(const internal::Sparse_lattice& lattice, std::size_t i)
{
  const internal::Lattice_point p = lattice.point(i);
  return Vec3(double(p[0]), double(p[1]), double(p[2]));
}

// One value and gradients at points make a linear field.
void linear_field()
{
  const internal::Sparse_lattice lattice = full_lattice(6);
  const std::vector<char> is_fixed(lattice.size(), 0);
  const std::vector<double> start(lattice.size(), 0.);
  internal::Field_equations equations(lattice, is_fixed, start);
  const Vec3 gradient(0.3, -0.7, 0.2), place(2.3, 1.6, 3.1);
  equations.add_smoothness(1);
  equations.add_point(10, place, 0.5);
  for(int k = 0; k < 125; ++k)
    equations.add_gradient(10, Vec3(k % 5 + 0.3, k / 5 % 5 + 0.6, k / 25 + 0.1), gradient);
  const std::vector<double> field = equations.solve();
  double largest = 0;
  for(std::size_t i = 0; i < lattice.size(); ++i)
    largest = (std::max)(largest, std::abs(field[i] - 0.5 - gradient.dot(node(lattice, i) - place)));
  std::cout << "linear field: largest error " << largest << std::endl;
  assert(largest < 0.05);  // that of the solver
}

// A matrix whose rows are the trilinear weights of the coarse nodes around a fine node.
internal::Multigrid::Matrix interpolation(const internal::Sparse_lattice& coarse, const internal::Sparse_lattice& fine)
{
  internal::Multigrid::Matrix result(Eigen::Index(fine.size()), Eigen::Index(coarse.size()));
  for(std::size_t i = 0; i < fine.size(); ++i)
    for(std::size_t j = 0; j < coarse.size(); ++j) {
      const Vec3 offset = (node(fine, i) / 2 - node(coarse, j)).cwiseAbs();
      if(offset.maxCoeff() < 1)
        result.insert(Eigen::Index(i), Eigen::Index(j)) = (Vec3::Ones() - offset).prod();
    }
  return result;
}

// From no guess, a sphere's field: as many iterations on any number of levels, and the field of the other solver.
void multigrid()
{
  internal::Multigrid grid;
  for(int level = 0; level < 3; ++level) {
    const int cells = 6 << level;
    const internal::Sparse_lattice lattice = full_lattice(cells + 1);
    const std::vector<char> is_fixed(lattice.size(), 0);
    const std::vector<double> start(lattice.size(), 0.);
    internal::Field_equations equations(lattice, is_fixed, start), same(lattice, is_fixed, start);
    Random_numbers random(1);
    for(internal::Field_equations* e : {&equations, &same}) {
      e->add_smoothness(1);
      e->add_point(1, Vec3::Constant(cells / 2.), -cells / 4.);
    }
    for(int k = 0; k < 500; ++k) {
      const Vec3 direction = Vec3(random.normal(), random.normal(), random.normal()).normalized();
      for(internal::Field_equations* e : {&equations, &same})
        e->add_point(1, Vec3::Constant(cells / 2.) + cells / 4. * direction, 0);
    }
    internal::Multigrid::Matrix from_coarse;
    if(level > 0)
      from_coarse = interpolation(full_lattice(cells / 2 + 1), lattice);
    const std::vector<double> field = equations.solve(grid, std::move(from_coarse)), other = same.solve();
    double largest = 0;
    for(std::size_t i = 0; i < lattice.size(); ++i)
      if((node(lattice, i) - Vec3::Constant(cells / 2.)).norm() < 0.3 * cells)  // beyond, nothing holds it
        largest = (std::max)(largest, std::abs(field[i] - other[i]));
    std::cout << "multigrid of " << level + 1 << " levels: " << equations.number_of_iterations() << " iterations for "
              << same.number_of_iterations() << ", largest difference " << largest << std::endl;
    assert(equations.number_of_iterations() <= 15);
    assert(largest < 1e-3 * cells);
  }
}

}  // namespace

int main()
{
  Points points, normals;
  scan(8000, points, normals);
  const double weight = internal::Feature_enhanced_settings().field.normal_weight;
  const internal::Surface_triangles with = reconstruct(points, normals, weight, false);
  const internal::Surface_triangles without = reconstruct(points, normals, 0, false);
  std::cout << "with normals: genus " << genus(with) << ", error " << mean_error(with) << "\n"
            << "without: genus " << genus(without) << ", error " << mean_error(without) << std::endl;
  // The normals bound the unseen side.
  assert(genus(with) == 0);
  assert(mean_error(with) < 0.015 * radius);
  assert(mean_error(with) < 0.6 * mean_error(without));

  const internal::Surface_triangles again = reconstruct(points, normals, weight, true);
  assert(again.triangles == with.triangles && again.vertices == with.vertices);

  remove_handles();
  gaps_of_axis();
  reconstruct_around_given_axis();
  measure_noise();
  reconstruct_noisy(points, normals);

  linear_field();
  multigrid();
  std::cout << "done\n";
}
