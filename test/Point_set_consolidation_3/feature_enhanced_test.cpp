// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Facts about the operators of the feature-enhanced surfaces paper, on a cube with noise.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>
#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using CGAL::Point_set_consolidation_3::Anisotropic_formula;
using CGAL::Point_set_consolidation_3::Upsampling_formula;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Point_map = CGAL::First_of_pair_property_map<Oriented_point>;
using Normal_map = CGAL::Second_of_pair_property_map<Oriented_point>;

// The surface of [-1, 1]^3.
std::vector<Point> noisy_cube(std::size_t n, double noise)
{
  benchmark::Random_numbers numbers(5);
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i) {
    double x[3];
    for(double& c : x)
      c = 2 * numbers.uniform() - 1;
    x[i % 3] = i % 2 == 0 ? 1 : -1;
    for(double& c : x)
      c += noise * numbers.normal();
    points.emplace_back(x[0], x[1], x[2]);
  }
  return points;
}

double distance_to_cube(const Point& p)
{
  double outside = 0, inside = -1e9;
  for(int k = 0; k < 3; ++k) {
    const double d = std::abs(p[k]) - 1;
    outside += d > 0 ? d * d : 0;
    inside = (std::max)(inside, d);
  }
  return outside > 0 ? std::sqrt(outside) : -inside;
}

bool is_near_edge(const Point& p)
{
  int faces = 0;
  for(int k = 0; k < 3; ++k)
    faces += std::abs(p[k]) > 0.85;
  return faces > 1;
}

struct Error {
  double mean = 0, near_edges = 0, tilted = 0;
};

Error error_of(const std::vector<Oriented_point>& points)
{
  Error error;
  std::size_t near = 0;
  for(const Oriented_point& p : points) {
    const double d = distance_to_cube(p.first);
    error.mean += d / double(points.size());
    // normals of the cube are axes: the largest coordinate is 1
    double largest = 0;
    for(int k = 0; k < 3; ++k)
      largest = (std::max)(largest, std::abs(p.second[k]));
    error.tilted += double(largest < std::cos(20 * CGAL_PI / 180)) / double(points.size());
    if(is_near_edge(p.first)) {
      error.near_edges += d;
      ++near;
    }
  }
  error.near_edges /= double((std::max)(near, std::size_t(1)));
  return error;
}

double distance_of_edges(const std::vector<Oriented_point>& points)
{
  double sum = 0;
  std::size_t count = 0;
  for(double t = -0.9; t <= 0.9; t += 0.05)
    for(int axis = 0; axis < 3; ++axis)
      for(const double a : {-1., 1.})
        for(const double b : {-1., 1.}) {
          double x[3];
          x[axis] = t;
          x[(axis + 1) % 3] = a;
          x[(axis + 2) % 3] = b;
          double least = 1e9;
          for(const Oriented_point& p : points)
            least = (std::min)(least, CGAL::squared_distance(p.first, Point(x[0], x[1], x[2])));
          sum += std::sqrt(least);
          ++count;
        }
  return sum / double(count);
}

template <typename Function>
bool throws_invalid(const Function& function)
{
  try {
    function();
  }
  catch(const std::invalid_argument&) {
    return true;
  }
  return false;
}

}  // namespace

int main()
{
  typedef CGAL::Sequential_tag Tag;
  const double noise = 0.02;
  const std::vector<Point> cube = noisy_cube(6000, noise);

  // Points come nearer to the surface, also at edges, and their normals belong to one face.
  std::vector<Oriented_point> projected;
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
    cube, std::back_inserter(projected), params::select_percentage(30));
  assert(projected.size() == 1800);
  const Error e = error_of(projected);
  std::cout << "projected: mean " << e.mean << ", near edges " << e.near_edges << ", tilted "
            << e.tilted << ", edges " << distance_of_edges(projected) << "\n";
  assert(e.mean < 0.4 * 0.8 * noise);
  assert(e.near_edges < 0.6 * 0.8 * noise);
  assert(e.tilted < 0.05);

  // The printed sums make faces shrink; the local ones do not.
  std::vector<Oriented_point> printed, local;
  const auto few = params::select_percentage(30).number_of_iterations(3u);
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
    cube, std::back_inserter(printed), few.anisotropic_formula(Anisotropic_formula::PRINTED));
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
    cube, std::back_inserter(local), few.anisotropic_formula(Anisotropic_formula::LOCAL));
  assert(distance_of_edges(local) < distance_of_edges(printed));
  assert(distance_of_edges(projected) < distance_of_edges(local));

  // Up-sampling keeps the given points, adds points on the surface and brings them nearer to edges.
  const auto maps = params::point_map(Point_map()).normal_map(Normal_map());
  for(const Upsampling_formula formula :
      {Upsampling_formula::PRINTED, Upsampling_formula::WEIGHTED, Upsampling_formula::EDGES}) {
    std::vector<Oriented_point> dense;
    CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(
      projected, std::back_inserter(dense),
      maps.number_of_output_points(std::size_t(5000)).upsampling_formula(formula));
    assert(dense.size() == 5000);
    assert(std::equal(projected.begin(), projected.end(), dense.begin(),
                      [](const Oriented_point& a, const Oriented_point& b) {
                        return a.first == b.first && a.second * b.second > 1 - 1e-12;
                      }));
    const Error d = error_of(dense);
    std::cout << "up-sampled: mean " << d.mean << ", near edges " << d.near_edges << ", edges "
              << distance_of_edges(dense) << "\n";
    assert(d.mean < 0.5 * 0.8 * noise);
    assert(distance_of_edges(dense) < 0.8 * distance_of_edges(projected));
  }

  // Normals alone.
  std::vector<Oriented_point> oriented;
  for(const Point& p : cube)
    oriented.emplace_back(p, Vector(0, 0, 0));
  assert(CGAL::optimize_normals_across_edges<Tag>(oriented, maps));
  assert(error_of(oriented).tilted < 0.1);
  std::size_t outwards = 0;
  for(std::size_t i = 0; i < cube.size(); ++i) {
    assert(oriented[i].first == cube[i]);
    outwards += oriented[i].second * (cube[i] - CGAL::ORIGIN) > 0;
  }
  assert(outwards > cube.size() * 99 / 100);

#ifdef CGAL_LINKED_WITH_TBB
  // The same, bit for bit, in parallel.
  std::vector<Oriented_point> parallel;
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<CGAL::Parallel_tag>(
    cube, std::back_inserter(parallel), params::select_percentage(30));
  assert(parallel == projected);
#endif

  // A cancelled call writes nothing; bad input is named.
  std::vector<Oriented_point> nothing;
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
    cube, std::back_inserter(nothing),
    params::callback([](double fraction) { return fraction < 0.5; }));
  assert(nothing.empty());
  assert(throws_invalid([&] {
    CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
      cube, std::back_inserter(nothing), params::select_percentage(120));
  }));
  assert(throws_invalid([&] {
    const std::vector<Point> same(100, Point(1, 2, 3));
    CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(same,
                                                                  std::back_inserter(nothing));
  }));
  assert(throws_invalid([&] {
    CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(cube, std::back_inserter(nothing));
  }));
  assert(throws_invalid([&] {
    CGAL::anisotropic_wlop_simplify_and_regularize_point_set<Tag>(
      cube, std::back_inserter(nothing),
      params::anisotropic_formula(Anisotropic_formula(3)));
  }));
  assert(throws_invalid([&] {
    CGAL::anisotropic_edge_aware_upsample_point_set<Tag>(projected, std::back_inserter(nothing),
                                                         maps.upsampling_formula(Upsampling_formula(3)));
  }));
  assert(nothing.empty());
  std::cout << "done\n";
}
