// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals with random signs get their outer sides back: smooth and sharp shapes, thin plates, parts that nearly touch,
// noise, open surfaces, more points than are compared, and noise in which small neighbourhoods tell nothing.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/dipole_orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/input_stage.h>

#include <cassert>
#include <cmath>
#include <iostream>
#include <string>

using namespace CGAL::Point_set_consolidation_3::internal;

namespace {

constexpr double pi = 3.14159265358979324;

struct Shape {
  Points points, normals;  // outward

  void add(const Vec3& p, const Vec3& n)
  {
    points.push_back(p);
    normals.push_back(n.normalized());
  }
};

// A ball of radius 1 at (x, 0, 0), or the part of it above z = lowest.
void add_ball(Shape& shape, std::size_t count, double x, double lowest, std::uint64_t seed)
{
  benchmark::Random_numbers random(seed);
  for(std::size_t k = 0; k < count; ++k) {
    const double z = lowest + (1 - lowest) * random.uniform(), a = 2 * pi * random.uniform();
    const double r = std::sqrt(1 - z * z);
    const Vec3 n(r * std::cos(a), r * std::sin(a), z);
    shape.add(n + Vec3(x, 0, 0), n);
  }
}

// A box with as many points per area on all faces.
Shape box(std::size_t count, double a, double b, double c)
{
  benchmark::Random_numbers random(3);
  const Vec3 half(a / 2, b / 2, c / 2);
  const double areas[3] = {b * c, a * c, a * b};
  Shape shape;
  while(shape.points.size() < count) {
    double u = random.uniform() * (areas[0] + areas[1] + areas[2]);
    int axis = 0;
    while(axis < 2 && u > areas[axis])
      u -= areas[axis++];
    Vec3 p, n = Vec3::Zero();
    for(int k = 0; k < 3; ++k)
      p[k] = (2 * random.uniform() - 1) * half[k];
    n[axis] = random.uniform() < 0.5 ? 1 : -1;
    p[axis] = n[axis] * half[axis];
    shape.add(p, n);
  }
  return shape;
}

Shape torus(std::size_t count, double radius, double noise)
{
  benchmark::Random_numbers random(4);
  Shape shape;
  while(shape.points.size() < count) {
    const double u = 2 * pi * random.uniform(), v = 2 * pi * random.uniform();
    if(random.uniform() > (1 + radius * std::cos(v)) / (1 + radius))
      continue;
    const Vec3 n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    const double r = radius + noise * (random.uniform() + random.uniform() + random.uniform() - 1.5);
    shape.add(Vec3(std::cos(u), std::sin(u), 0) + r * n, n);
  }
  return shape;
}

double wrong_share(const std::string& name, const Shape& shape, const Points& normals)
{
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < normals.size(); ++i)
    wrong += normals[i].dot(shape.normals[i]) < 0;
  const double share = double(wrong) / double(normals.size());
  std::cout << name << ": " << share << " wrong\n";
  return share;
}

// Share of normals on the wrong side after their signs were thrown away, and found again.
double wrong_share(const std::string& name, const Shape& shape)
{
  const Execution execution = make_execution<CGAL::Sequential_tag>();
  benchmark::Random_numbers random(1);
  Points normals = shape.normals;
  for(Vec3& n : normals)
    if(random.uniform() < 0.5)
      n = -n;
  orient_by_dipoles(execution, shape.points, normals);
  for(std::size_t i = 0; i < normals.size(); ++i)
    assert(std::abs(std::abs(normals[i].dot(shape.normals[i])) - 1) < 1e-12);  // only signs change
  return wrong_share(name, shape, normals);
}

// Noise of a quarter of the radius of the tube: normals of 30 neighbours, by which signs are found otherwise, are
// nearly random.
void strong_noise()
{
  const Execution execution = make_execution<CGAL::Sequential_tag>();
  const Shape shape = torus(20000, 0.3, 0.15);
  const Seen_part seen = oriented_data(execution, shape.points, Points());
  const double share = wrong_share("strong noise, many neighbours", shape, seen.normals);
  Points normals = seen.normals;
  orient_by_dipoles(execution, seen.points, normals);
  assert(share < 0.6 * wrong_share("strong noise, few neighbours", shape, normals));
  assert(share < 0.05);
}

// Degenerate sets: nothing to find, but nothing breaks either.
void few_points()
{
  const Execution execution = make_execution<CGAL::Sequential_tag>();
  for(std::size_t count : {0, 1, 2, 3, 50}) {
    const Points points(count, Vec3(1, 2, 3));
    Points normals(count, Vec3::UnitX());
    orient_by_dipoles(execution, points, normals);
    for(const Vec3& n : normals)
      assert(n.norm() == 1);
  }
}

}  // namespace

int main()
{
  Shape ball;
  add_ball(ball, 3000, 0, -1, 1);
  assert(wrong_share("ball", ball) == 0);

  Shape two_balls = ball;  // 0.02 apart, less than their spacing of 0.065
  add_ball(two_balls, 3000, 2.02, -1, 2);
  assert(wrong_share("two balls", two_balls) < 0.01);

  Shape cap;
  add_ball(cap, 2000, 0, 0.3, 1);
  assert(wrong_share("open cap", cap) == 0);

  // spacings: 0.039 for the cube, 0.022 for the plates, which are as thick
  assert(wrong_share("cube", box(4000, 1, 1, 1)) == 0);
  assert(wrong_share("plate", box(4000, 1, 1, 0.025)) < 0.01);
  assert(wrong_share("rod", box(4000, 1, 0.05, 0.05)) < 0.01);

  assert(wrong_share("torus", torus(4000, 0.3, 0)) == 0);
  assert(wrong_share("noisy torus", torus(4000, 0.3, 0.05)) < 0.01);
  assert(wrong_share("many points", torus(60000, 0.3, 0)) == 0);
  strong_noise();
  few_points();
  std::cout << std::flush;
}
