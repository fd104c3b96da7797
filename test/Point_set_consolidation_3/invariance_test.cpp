// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every function: results do not depend on the unit of length or the place of the origin, and depend on the
// direction of the axes and the order of the input, which random samples follow, by less than the spacing of the
// points; nodes of skeletons, which are few, by less than a fifth of the shape's length. Projections and removals
// that are applied to their own result have little left to do.
// Argument: [PART OF A FUNCTION'S NAME]

#undef NDEBUG

#include "every_function/clouds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

using namespace every_function;

/// Of the capsule below: the mean distance to the nearest other point is about half of it.
constexpr double spacing = 0.2;
constexpr double skeleton_tolerance = 0.8;

Output output_of(const Function& function, const Cloud& cloud)
{
  Output output;
  function.call(cloud, Run(), output);
  return output;
}

/// A noisy capsule whose coordinates are multiples of 2^-20, so that units and offsets that are powers of two or
/// their multiples change no bit of what a function computes.
Cloud dyadic_capsule()
{
  Cloud cloud = open_capsule(500, 21);
  Numbers numbers(22);
  const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
  for(Sample& s : cloud.samples) {
    const Point p = s.point + 0.02 * numbers.signed_unit() * s.normal;
    s.point = Point(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  }
  return cloud;
}

double distance(const Point& p, const Point& q)
{
  return std::sqrt((p - q).squared_length());
}

void same_in_another_frame(const Function& function, const Cloud& cloud, const Output& reference, double unit,
                           const Vector& offset)
{
  const Output output = output_of(function, transformed(cloud, unit, offset));
  assert(output.points.size() == reference.points.size());
  assert(output.numbers.size() == reference.numbers.size());
  assert(output.normals.size() == reference.normals.size());
  // The results themselves, and skeletons that are given, are rounded at the size of the offset.
  const double rounding = 1e-12 * (1 + std::sqrt(offset.squared_length()) / unit);
  for(std::size_t i = 0; i < output.points.size(); ++i) {
    const Vector moved = (output.points[i] - CGAL::ORIGIN) - offset;
    assert(distance(CGAL::ORIGIN + moved / unit, reference.points[i]) < rounding);
  }
  for(std::size_t i = 0; i < output.normals.size(); ++i)
    assert((output.normals[i] - reference.normals[i]).squared_length() < 1e-18);
}

/// Mean distance from the points to the nearest of the others.
double mean_distance(const std::vector<Point>& points, const std::vector<Point>& others)
{
  double sum = 0;
  for(const Point& p : points) {
    double nearest = 1e30;
    for(const Point& q : others)
      nearest = (std::min)(nearest, (p - q).squared_length());
    sum += std::sqrt(nearest);
  }
  return points.empty() ? 0 : sum / double(points.size());
}

double set_distance(const std::vector<Point>& a, const std::vector<Point>& b)
{
  assert(a.empty() == b.empty());
  return (std::max)(mean_distance(a, b), mean_distance(b, a));
}

Vector rotated(const Vector& v)
{
  // The rotation that takes the axes to these columns: exact in rationals.
  return Vector((2 * v.x() - v.y() + 2 * v.z()) / 3, (2 * v.x() + 2 * v.y() - v.z()) / 3,
                (-v.x() + 2 * v.y() + 2 * v.z()) / 3);
}

/// The skeleton that this function is given here follows the box and the order of the points.
bool has_skeleton_of_box(const Function& function)
{
  return std::string(function.name) == "complete_point_set_along_skeleton";
}

double change_by_rotation(const Function& function, const Cloud& cloud, const Output& reference)
{
  Cloud turned = cloud;
  for(Sample& s : turned.samples) {
    s.point = CGAL::ORIGIN + rotated(s.point - CGAL::ORIGIN);
    s.normal = rotated(s.normal);
  }
  std::vector<Point> expected;
  for(const Point& p : reference.points)
    expected.push_back(CGAL::ORIGIN + rotated(p - CGAL::ORIGIN));
  return set_distance(output_of(function, turned).points, expected);
}

double change_by_order(const Function& function, const Cloud& cloud, const Output& reference)
{
  Cloud shuffled = cloud;
  Numbers numbers(23);
  for(std::size_t i = shuffled.samples.size() - 1; i > 0; --i)
    std::swap(shuffled.samples[i], shuffled.samples[numbers.next() % (i + 1)]);
  return set_distance(output_of(function, shuffled).points, reference.points);
}

const Function& function_of(const std::string& name)
{
  static const std::vector<Function> functions = all_functions();
  for(const Function& function : functions)
    if(function.name == name)
      return function;
  std::abort();
}

/// How far the points move, on average, in the first and in the second of two calls.
void project_again(const std::string& name, double largest_ratio)
{
  Cloud cloud = dyadic_capsule();
  double moved[2];
  for(double& mean : moved) {
    const Output output = output_of(function_of(name), cloud);
    assert(output.points.size() == cloud.samples.size());
    mean = 0;
    for(std::size_t i = 0; i < cloud.samples.size(); ++i) {
      mean += distance(output.points[i], cloud.samples[i].point) / double(cloud.samples.size());
      cloud.samples[i].point = output.points[i];
      cloud.samples[i].normal = output.normals[i];
    }
  }
  std::cout << name << " again: moves by " << moved[1] << " after " << moved[0] << std::endl;
  assert(moved[0] > 0 && moved[1] <= largest_ratio * moved[0]);
}

void remove_again()
{
  Cloud cloud = dyadic_capsule();
  Numbers numbers(24);
  constexpr std::size_t outliers = 12;
  for(std::size_t i = 0; i < outliers; ++i)
    cloud.samples.push_back(
      {Point(8 * numbers.signed_unit(), 3 + 8 * numbers.uniform(), 8 * numbers.signed_unit()), Vector(0, 0, 1), 0});
  const Function& removal = function_of("mean_shift_remove_outliers");
  const std::size_t all = cloud.samples.size();
  const std::vector<Point> once = output_of(removal, cloud).points;
  cloud.samples.clear();
  for(const Point& p : once)
    cloud.samples.push_back({p, Vector(0, 0, 1), 0});
  const std::size_t twice = output_of(removal, cloud).points.size();
  std::cout << "mean_shift_remove_outliers again: " << all << " -> " << once.size() << " -> " << twice << std::endl;
  assert(once.size() <= all - outliers && once.size() >= all - 2 * outliers && twice == once.size());
}

}  // namespace

int main(int argc, char* argv[])
{
  const Cloud cloud = dyadic_capsule();
  std::size_t faults = 0;
  for(const Function& function : all_functions()) {
    if(argc > 1 && std::string(function.name).find(argv[1]) == std::string::npos)
      continue;
    std::cout << function.name << std::flush;
    const Output reference = output_of(function, cloud);
    same_in_another_frame(function, cloud, reference, std::ldexp(1., 10), Vector(0, 0, 0));
    same_in_another_frame(function, cloud, reference, std::ldexp(1., -20), Vector(0, 0, 0));
    same_in_another_frame(function, cloud, reference, 1, Vector(65536, -8192, 1024));
    if(has_skeleton_of_box(function)) {
      std::cout << std::endl;
      continue;
    }
    const double rotation = change_by_rotation(function, cloud, reference);
    const double order = change_by_order(function, cloud, reference);
    std::cout << ": changed by " << rotation << " by a rotation, by " << order << " by another order" << std::endl;
    const bool is_skeleton = std::string(function.name).compare(0, 8, "extract_") == 0 ||
                             std::string(function.name) == "meso_skeleton_to_graph";
    const double tolerance = is_skeleton ? skeleton_tolerance : spacing;
    if(!(rotation < tolerance && order < tolerance)) {
      std::cout << "  FAULT" << std::endl;
      ++faults;
    }
  }
  if(argc == 1) {
    project_again("apss_project_point_set", 0.5);
    project_again("bilateral_project_point_set", 0.9);
    remove_again();
  }
  return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
