// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Denoising of views along their rays: on known surfaces with known noise.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/range_denoising.h>

#include <cassert>
#include <cmath>
#include <cstdlib>

using namespace CGAL::Point_set_consolidation_3::internal;
using benchmark::Random_numbers;

namespace {

struct Scan {
  Points truth, points;
  Scan_directions directions;

  void add(const Vec3& x, const Vec3& towards_scanner, double error, std::size_t view)
  {
    truth.push_back(x);
    points.push_back(x + error * towards_scanner);
    directions.towards_scanner.push_back(towards_scanner);
    directions.view.push_back(view);
  }
};

double root_mean_square(const Points& points, const Points& truth)
{
  double squares = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    squares += (points[i] - truth[i]).squaredNorm() / double(points.size());
  return std::sqrt(squares);
}

Points denoised(const Scan& scan, bool* is_noisy = nullptr)
{
  Points points = scan.points;
  const bool found = denoise_along_rays(make_execution<CGAL::Sequential_tag>(), scan.directions, points);
  if(is_noisy != nullptr)
    *is_noisy = found;
  return points;
}

void expect_moved_along_rays(const Scan& scan, const Points& points)
{
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 move = points[i] - scan.points[i];
    assert(move.cross(scan.directions.towards_scanner[i]).norm() < 1e-9);  // a point leaves its ray
  }
}

/// A wavy ground, far in front of its middle a strip thinner than the noise is thick, and its back from another view.
Scan ground_and_strip(double noise)
{
  Random_numbers random(7);
  Scan scan;
  constexpr std::size_t points = 4000;
  for(std::size_t i = 0; i < points; ++i) {
    const double x = random.uniform(), y = random.uniform();
    const bool is_strip = std::abs(x - 0.5) < 0.08;
    const double z = is_strip ? 0.5 : 0.05 * std::sin(5 * x) * std::cos(4 * y);
    scan.add(Vec3(x, y, z), Vec3::UnitZ(), noise * random.normal(), 0);
  }
  for(std::size_t i = 0; i < points / 6; ++i)
    scan.add(Vec3(0.42 + 0.16 * random.uniform(), random.uniform(), 0.48), -Vec3::UnitZ(), noise * random.normal(), 1);
  return scan;
}

void test_orthographic()
{
  constexpr double noise = 0.04;
  const Scan scan = ground_and_strip(noise);
  bool is_noisy = false;
  const Points points = denoised(scan, &is_noisy);
  assert(is_noisy);  // noise is found
  expect_moved_along_rays(scan, points);
  assert(root_mean_square(points, scan.truth) < 0.28 * noise);  // raw heights alone reach 0.295
  std::size_t mixed = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    mixed += (points[i] - scan.truth[i]).norm() > 3 * noise;
  assert(mixed <= points.size() / 200);  // the strip does not mix with the ground
}

/// Points on both sides of an edge that is little higher than the noise are told apart by smoothed heights.
void test_low_step()
{
  constexpr double noise = 0.04, step = 4 * noise;
  Random_numbers random(5);
  Scan scan;
  for(std::size_t i = 0; i < 6000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    scan.add(Vec3(x, y, std::abs(x - 0.5) < 0.08 ? step : 0.), Vec3::UnitZ(), noise * random.normal(), 0);
  }
  const Points points = denoised(scan);
  assert(root_mean_square(points, scan.truth) < 0.3 * noise);  // raw heights alone: 0.39
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    wrong += std::abs(points[i].z() - scan.truth[i].z()) > 0.5 * step;
  assert(wrong < points.size() / 450);  // raw heights alone: one in 350
}

void test_perspective()
{
  constexpr double noise = 0.03;
  const Vec3 scanner(0, 0, 4);
  Random_numbers random(11);
  Scan scan;
  while(scan.points.size() < 3000) {
    const Vec3 p(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    if(!(p.norm() > 0.1 && p.norm() <= 1))
      continue;
    const Vec3 x = p.normalized();
    if(x.dot(scanner - x) > 0.3 * (scanner - x).norm())
      scan.add(x, (scanner - x).normalized(), noise * random.normal(), 0);
  }
  const Points points = denoised(scan);
  expect_moved_along_rays(scan, points);
  assert(root_mean_square(points, scan.truth) < 0.5 * noise);  // a sphere seen from a point
}

void test_what_has_no_noise()
{
  const Scan clean = ground_and_strip(0);
  bool is_noisy = true;
  assert(denoised(clean, &is_noisy) == clean.points && !is_noisy);  // clean points stay where they are

  // a view that is too small for an image, points at one place, and no views
  Random_numbers random(3);
  Scan few, equal;
  for(int i = 0; i < 50; ++i)
    few.add(Vec3(random.uniform(), random.uniform(), 0), Vec3::UnitZ(), 0.1 * random.normal(), 0);
  assert(denoised(few) == few.points);  // too few points stay
  for(int i = 0; i < 200; ++i)
    equal.add(Vec3(1, 2, 3), Vec3::UnitZ(), 0, 0);
  assert(denoised(equal) == equal.points);  // equal points stay
  assert(denoised(Scan()).empty());  // no points
  Scan ungrouped = ground_and_strip(0.04);
  ungrouped.directions.view.clear();
  assert(denoised(ungrouped) == ungrouped.points);  // rays without views

  Scan turned = ground_and_strip(0.04);  // rays that neither are parallel nor meet
  for(std::size_t i = 0; i < turned.points.size(); ++i) {
    turned.directions.view[i] = 0;
    turned.directions.towards_scanner[i] = Vec3(std::cos(7. * double(i)), std::sin(5. * double(i)), 1).normalized();
  }
  assert(denoised(turned) == turned.points);  // rays of several scanners under one number
}

void test_far_outlier()
{
  Scan scan = ground_and_strip(0.04);
  scan.add(Vec3(1e7, 0, 0), Vec3::UnitZ(), 0, 0);
  scan.add(Vec3(0.2, 0.2, 1e9), Vec3::UnitZ(), 0, 0);
  const Points points = denoised(scan);
  for(std::size_t i = 0; i < points.size(); ++i)
    assert(points[i].allFinite());  // finite
  assert(points[points.size() - 2] == scan.points[points.size() - 2]);  // a lone point stays
  assert(points.back() == scan.points.back());  // a point far in front of all others stays
}

}  // namespace

int main()
{
  test_orthographic();
  test_low_step();
  test_perspective();
  test_what_has_no_noise();
  test_far_outlier();
  return EXIT_SUCCESS;
}
