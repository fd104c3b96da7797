// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The neighbour structure against all pairs, and the exponential of the weights against the library's.

#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/place_order.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace CGAL::Point_set_consolidation_3::internal;

namespace {

void expect(bool condition, const std::string& what)
{
  if(!condition) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(EXIT_FAILURE);
  }
}

Points random_points(std::size_t n, unsigned seed)
{
  benchmark::Random_numbers random(seed);
  Points points(n);
  for(Vec3& p : points)
    for(int axis = 0; axis < 3; ++axis)
      p[axis] = random.uniform();
  return points;
}

/// Blocks of `query` hold exactly the points that `is_inside`, each once, with their offsets.
template <typename Inside>
struct Collector {
  const Points& points;
  const Vec3& query;
  const Inside& is_inside;
  std::vector<int> found;

  void operator()(const Neighbor_block& block)
  {
    expect(block.size > 0 && block.size <= Neighbor_block::capacity, "size of a block");
    for(int k = 0; k < block.size; ++k) {
      ++found[block.index[k]];
      expect((points[block.index[k]] - query - block.offset(k)).norm() == 0, "offset");
    }
  }
  void expect_all(const std::string& what) const
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      expect(found[i] == int(is_inside(points[i])), what);
  }
};

void expect_neighbors(const Points& points, double cell, double radius, const std::vector<Vec3>& queries,
                      const std::string& what)
{
  const Sorted_grid grid(points, cell);
  Mat3 A;
  A << 1, 0.5, 0.2, 0, 0.8, 0.3, 0, 0, 0.5;
  const Vec3 extents = radius * A.inverse().rowwise().norm();  // of the box of |A x| <= radius
  for(const Vec3& q : queries) {
    const auto in_ball = [&](const Vec3& p) { return (p - q).squaredNorm() <= radius * radius; };
    Collector<decltype(in_ball)> ball{points, q, in_ball, std::vector<int>(points.size(), 0)};
    grid.for_each_neighbor_block(q, radius, ball);
    ball.expect_all(what + ": ball");

    const auto in_ellipsoid = [&](const Vec3& p) { return (A * (p - q)).norm() <= radius; };
    Collector<decltype(in_ellipsoid)> ellipsoid{points, q, in_ellipsoid, std::vector<int>(points.size(), 0)};
    grid.for_each_ellipsoid_block(q, A, radius, extents, ellipsoid);
    ellipsoid.expect_all(what + ": ellipsoid");

    std::vector<int> visited(points.size(), 0);
    grid.for_each_neighbor(q, radius, [&](Index j, double d2) {
      expect(d2 <= radius * radius, what + ": squared distance");
      ++visited[j];
      return true;
    });
    expect(visited == ball.found, what + ": visits");
    std::size_t visits = 0;
    grid.for_each_neighbor(q, radius, [&](Index, double) { return ++visits < 3; });
    expect(visits <= 3, what + ": a visit that ends");
  }
}

void test_neighbors()
{
  Points points = random_points(3000, 1);
  std::vector<Vec3> queries = random_points(40, 2);
  queries.push_back(Vec3(-5, 0.5, 0.5));      // outside the box
  queries.push_back(Vec3(0.5, 1e12, -1e12));
  for(const double radius : {0.02, 0.1, 0.3, 2., 20.})
    for(const double cell : {0.05, 0.1, 0.5})
      expect_neighbors(points, cell, radius, queries, "cube");
  points.push_back(Vec3(1e9, -1e9, 1e9));     // too many cells for a table
  points.push_back(Vec3(1e9, -1e9, 1e9));
  queries.push_back(points.back());
  expect_neighbors(points, 0.1, 0.1, queries, "far outlier");
  points.push_back(Vec3(1e30, 0, 0));         // more cells than can be numbered
  expect_neighbors(points, 0.1, 0.1, queries, "very far outlier");
  expect_neighbors(Points(1500, Vec3(1, 2, 3)), 0.1, 0.1, {Vec3(1, 2, 3), Vec3(1, 2, 3.2)}, "equal points");
  expect_neighbors(Points(), 0.1, 0.1, queries, "no points");
}

void test_order()
{
  for(const std::size_t n : {0, 1, 7, 5000}) {
    std::vector<int> seen(n, 0);
    const Points points = random_points(n, 3);
    Execution execution;
    parallel_for_places(execution, points, [&](std::size_t i) { ++seen[i]; });
    expect(seen == std::vector<int>(n, 1), "every place once");
  }
  // close in the order, close in space: on average a small part of the box apart
  const Points points = random_points(5000, 3);
  const std::vector<Index> order = place_order(points);
  double step = 0;
  for(std::size_t k = 1; k < order.size(); ++k)
    step += (points[order[k]] - points[order[k - 1]]).norm() / double(order.size());
  expect(step < 0.25, "order of places");  // 0.66 at random
}

void test_exponential()
{
  double largest = 0;
  for(int first = -5600; first < 5600; first += Exponential::lanes) {
    Exponential::Lanes x;
    for(int k = 0; k < Exponential::lanes; ++k)
      x[k] = (first + k) * 0.124999;
    const Exponential::Lanes y = Exponential::of(x);
    for(int k = 0; k < Exponential::lanes; ++k)
      largest = (std::max)(largest, std::abs(y[k] / std::exp(x[k]) - 1));
  }
  expect(largest < 3e-13, "exponential over the whole range");  // the argument's rounding, 700 eps
  Exponential::Lanes x;
  x << 0, -0., -1e-300, -1e300, -1e4, -20, -1, -0.5;
  const Exponential::Lanes y = Exponential::of(x);
  expect(y[0] == 1 && y[1] == 1 && y[2] == 1, "exponential of 0");
  expect(y[3] >= 0 && y[3] < 1e-300 && y[4] >= 0 && y[4] < 1e-300, "exponential of large negative numbers");

  Neighbor_block block;
  for(const int size : {1, 7, 8, 9, 125, Neighbor_block::capacity}) {
    block.size = size;
    for(int k = 0; k < size; ++k)
      block.d2[k] = 0.03 * k;
    Block_weights weights;
    const auto w = weights.set_gaussian(1.5, block);
    expect(w.size() == size, "number of weights");
    for(int k = 0; k < size; ++k)
      expect(std::abs(w[k] / std::exp(-1.5 * block.d2[k]) - 1) < 1e-14, "weight");
  }
}

}  // namespace

int main()
{
  test_neighbors();
  test_order();
  test_exponential();
  return EXIT_SUCCESS;
}
