// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Outliers that belong to no surface, told from noise, from sparse and from small parts.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_consolidation_3/internal/isolated_points.h>
#include <CGAL/complete_point_set.h>
#include <CGAL/deep_points_consolidate_point_set.h>

#include <cassert>
#include <iostream>
#include <iterator>
#include <numeric>

namespace psc = CGAL::Point_set_consolidation_3::internal;
namespace params = CGAL::Point_set_consolidation_3::parameters;
using benchmark::Random_numbers;
using psc::Points;
using psc::Vec3;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

/// A torus of radii 1 and 0.4, moved off it by up to `noise`, and outliers at the end in a box twice as large.
Points torus(std::size_t n, std::size_t outliers, double noise, unsigned seed)
{
  Random_numbers random(seed);
  Points points;
  while(points.size() < n) {
    const double u = random.uniform(0, 6.283185307179586), v = random.uniform(0, 6.283185307179586);
    if(random.uniform(0, 1.4) > 1 + 0.4 * std::cos(v))
      continue;
    const double r = 0.4 + random.uniform(-noise, noise);
    points.push_back(Vec3((1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v)));
  }
  for(std::size_t i = 0; i < outliers; ++i)
    points.push_back(Vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-1, 1)));
  return points;
}

double distance_to_torus(const Vec3& p)
{
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4);
}

std::vector<char> isolated(const Points& points)
{
  std::vector<char> found = psc::Isolated_points(psc::make_execution<CGAL::Sequential_tag>(), points).run();
  assert(found == psc::Isolated_points(psc::make_execution<CGAL::Parallel_if_available_tag>(), points).run());
  return found;
}

std::size_t count(const std::vector<char>& flags, std::size_t begin, std::size_t end)
{
  return std::size_t(std::count(flags.begin() + std::ptrdiff_t(begin), flags.begin() + std::ptrdiff_t(end), char(1)));
}

void outliers_are_found()
{
  constexpr std::size_t n = 6000;
  for(const double noise : {0., 0.06})
    for(const std::size_t outliers : {100, 600}) {
      const Points points = torus(n, outliers, noise, 5);
      const std::vector<char> found = isolated(points);
      const std::size_t mistaken = count(found, 0, n);
      assert(mistaken <= n / 500);  // next to no data are lost
      std::size_t far = 0, found_far = 0;
      constexpr double spacing = 0.05;  // of 6000 points
      for(std::size_t i = n; i < points.size(); ++i)
        if(distance_to_torus(points[i]) > noise + 3 * spacing) {
          ++far;
          found_far += found[i];
        }
      std::cout << "noise " << noise << ": " << found_far << " of " << far << " far outliers, " << mistaken
                << " mistaken\n";
      assert(far > outliers / 2 && double(found_far) >= 0.97 * double(far));  // outliers off the surface are found
    }
}

void data_stay()
{
  constexpr std::size_t n = 6000;
  for(const double noise : {0., 0.02, 0.06})
    assert(count(isolated(torus(n, 0, noise, 9)), 0, n) == 0);  // noise is no outlier

  // a sheet whose one half is six times as sparse, as a scanner sees what it looks along
  Random_numbers random(3);
  Points sheet;
  while(sheet.size() < 4000) {
    const double x = random.uniform(-1, 1), y = random.uniform(0, 1);
    if(x < 0 || random.uniform(0, 36) < 1)
      sheet.push_back(Vec3(x, y, 0.05 * std::sin(4 * x)));
  }
  assert(count(isolated(sheet), 0, sheet.size()) <= 4);  // sparse parts are data

  // a noisy scan beside one that is 30 times as dense, and single points among others that come eight times
  Points two;
  while(two.size() < 3000)
    two.push_back(Vec3(random.uniform(0, 0.3), random.uniform(0, 0.3), 0));
  while(two.size() < 5000)
    two.push_back(Vec3(random.uniform(1, 2.6), random.uniform(0, 1), random.uniform(-0.1, 0.1)));
  assert(count(isolated(two), 0, two.size()) == 0);
  Points copies(two.begin(), two.begin() + 400);
  for(int k = 0; k < 7; ++k)
    copies.insert(copies.end(), two.begin(), two.begin() + 300);
  copies.insert(copies.end(), two.begin() + 400, two.begin() + 1800);
  assert(count(isolated(copies), 0, copies.size()) == 0);

  // one far point in a clean scan is an outlier; fewer points than make a scan have none
  Points points = torus(n, 0, 0, 9);
  points.push_back(Vec3(0, 0, 4));
  const std::vector<char> found = isolated(points);
  assert(found[n] && count(found, 0, n) == 0);
  assert(count(isolated(Points(points.end() - 50, points.end())), 0, 50) == 0);
  assert(isolated(Points()).empty());
  assert(count(isolated(Points(500, Vec3(1, 2, 3))), 0, 500) == 0);  // equal points
}

/// What the functions say of a scan with outliers, and what they make of it.
void functions_leave_outliers_out()
{
  constexpr std::size_t n = 4000, outliers = 120;
  const Points points = torus(n, outliers, 0, 21);
  std::vector<Kernel::Point_3> cgal_points;
  for(const Vec3& p : points)
    cgal_points.push_back(Kernel::Point_3(p.x(), p.y(), p.z()));
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  std::vector<Kernel::Point_3> denoised(points.size(), Kernel::Point_3(9, 9, 9));
  std::vector<Kernel::Vector_3> normals(points.size(), Kernel::Vector_3(0, 0, 0));
  std::vector<std::size_t> found;
  std::vector<CGAL::Completed_point_3<Kernel> > completed;
  const auto np = params::point_map(CGAL::make_property_map(cgal_points)).geom_traits(Kernel());
  CGAL::complete_point_set<CGAL::Sequential_tag>(
    indices, std::back_inserter(completed),
    np.denoised_point_map(CGAL::make_property_map(denoised))
      .denoised_normal_map(CGAL::make_property_map(normals))
      .outlier_output_iterator(std::back_inserter(found)));
  assert(std::is_sorted(found.begin(), found.end()) && found.size() > outliers / 2 && found.size() <= outliers + 10);
  for(const std::size_t i : found)
    assert(i >= n || distance_to_torus(points[i]) < 1e-9);
  for(std::size_t i = 0; i < points.size(); ++i) {
    assert(denoised[i] == cgal_points[i]);  // clean data stay, and outliers
    assert(std::abs(std::sqrt(normals[i].squared_length()) - 1) < 1e-9);
  }
  for(const CGAL::Completed_point_3<Kernel>& p : completed)  // nothing is completed around outliers
    assert(distance_to_torus(Vec3(p.outer().x(), p.outer().y(), p.outer().z())) < 0.15);

  // the same points as without outliers: they have no part in the result
  std::vector<CGAL::Deep_point_3<Kernel> > with, without;
  std::vector<std::size_t> also_found, kept;
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    indices, std::back_inserter(with),
    np.number_of_output_points(600).outlier_output_iterator(std::back_inserter(also_found)));
  assert(also_found == found);
  std::set_difference(indices.begin(), indices.end(), found.begin(), found.end(), std::back_inserter(kept));
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    kept, std::back_inserter(without), np.number_of_output_points(600).detect_outliers(false));
  assert(with.size() == without.size());
  for(std::size_t i = 0; i < with.size(); ++i)
    assert(with[i].outer() == without[i].outer() && with[i].inner() == without[i].inner());

  // what is constrained is data
  std::vector<std::size_t> unconstrained;
  const std::vector<char> all(points.size(), 1);
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    indices, CGAL::Emptyset_iterator(),
    np.number_of_output_points(600)
      .number_of_surface_iterations(1)
      .point_is_constrained_map(CGAL::make_property_map(all))
      .outlier_output_iterator(std::back_inserter(unconstrained)));
  assert(unconstrained.empty());
}

}  // namespace

int main()
{
  outliers_are_found();
  data_stay();
  functions_leave_outliers_out();
  return 0;
}
