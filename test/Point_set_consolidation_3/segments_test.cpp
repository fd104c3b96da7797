// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments and L1-medial skeletons of two balls joined by a bar, of a tube and of a ring.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
using CGAL::Point_set_consolidation_3::Segmentation_method;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Labelled_point = std::pair<Point, int>;
using Point_map = CGAL::First_of_pair_property_map<Labelled_point>;
using Label_map = CGAL::Second_of_pair_property_map<Labelled_point>;
constexpr double pi = 3.14159265358979323846;

// Balls of radius 0.5 at -1 and 1 on the x axis, the bar between them has radius 0.12.
std::vector<Labelled_point> dumbbell(std::size_t n)
{
  benchmark::Random_numbers numbers(11);
  std::vector<Labelled_point> points;
  const double bar = 2 * pi * 0.12 * 1.03, ball = 4 * pi * 0.25;
  while(points.size() < n) {
    const double choice = numbers.uniform() * (2 * ball + bar), turn = 2 * pi * numbers.uniform();
    const double t = 2 * numbers.uniform() - 1;
    if(choice < bar) {
      points.emplace_back(Point(0.515 * t, 0.12 * std::cos(turn), 0.12 * std::sin(turn)), 2);
      continue;
    }
    const int side = choice < bar + ball ? 0 : 1;
    const double r = 0.5 * std::sqrt(1 - t * t), x = (side == 0 ? -1 : 1) + 0.5 * t;
    if(r < 0.12 && std::abs(x) < 1)
      continue;  // inside of the bar
    points.emplace_back(Point(x, r * std::cos(turn), r * std::sin(turn)), side);
  }
  return points;
}

// A tube of radius 0.25 along x in [0, 3] with round ends, or bent to a ring of radius 1.
std::vector<Point> tube(std::size_t n, bool is_ring)
{
  benchmark::Random_numbers numbers(11);
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double along = numbers.uniform(), turn = 2 * pi * numbers.uniform();
    const double x = 3.5 * along - 0.25, a = 2 * pi * along;
    const double cap = is_ring ? 0 : (std::max)(0., (std::max)(-x, x - 3));
    const double r = std::sqrt(0.0625 - cap * cap);  // slices of a sphere and of a tube have equal areas
    const double y = r * std::cos(turn), z = r * std::sin(turn);
    points.push_back(is_ring ? Point((1 + y) * std::cos(a), (1 + y) * std::sin(a), z)
                             : Point(x, y, z));
  }
  return points;
}

double adjusted_rand_index(const std::vector<int>& a, const std::vector<int>& b)
{
  std::array<std::array<double, 64>, 64> table{};
  std::array<double, 64> rows{}, columns{};
  for(std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t r = std::size_t(a[i]), c = std::size_t((std::min)(b[i], 63));
    table[r][c] += 1;
    rows[r] += 1;
    columns[c] += 1;
  }
  const auto pairs = [](double n) { return n * (n - 1) / 2; };
  double both = 0, in_rows = 0, in_columns = 0;
  for(std::size_t r = 0; r < 64; ++r) {
    in_rows += pairs(rows[r]);
    in_columns += pairs(columns[r]);
    for(std::size_t c = 0; c < 64; ++c)
      both += pairs(table[r][c]);
  }
  const double expected = in_rows * in_columns / pairs(double(a.size()));
  return (both - expected) / (0.5 * (in_rows + in_columns) - expected);
}

std::size_t number_of_tips(const Skeleton& skeleton)
{
  std::size_t count = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    count += degree(v, skeleton) == 1;
  return count;
}

}  // namespace

int main()
{
  typedef CGAL::Sequential_tag Tag;
  const auto maps = params::point_map(Point_map());
  std::vector<Labelled_point> points = dumbbell(3000);
  std::vector<int> truth, found;
  for(const Labelled_point& p : points)
    truth.push_back(p.second);
  const auto segment = [&](Segmentation_method method, std::size_t count) {
    const std::size_t segments = CGAL::density_peak_segment_point_set<Tag>(
      points, Label_map(), maps.segmentation_method(method).number_of_segments(count));
    found.clear();
    std::size_t largest = 0;
    for(const Labelled_point& p : points) {
      assert(p.second >= 0 && std::size_t(p.second) < segments);
      largest = (std::max)(largest, std::size_t(p.second));
      found.push_back(p.second);
    }
    assert(largest + 1 == segments);  // no segment is empty
    return segments;
  };

  try {
    segment(Segmentation_method(3), 0);
    assert(false);
  }
  catch(const std::invalid_argument& error) {
    assert(std::string(error.what()).find("segmentation_method is none") != std::string::npos);
  }

  // By the skeleton: two balls and a bar.
  assert(segment(Segmentation_method::SKELETON, 0) == 3);
  const double index = adjusted_rand_index(truth, found);
  std::cout << "skeleton: index " << index << "\n";
  assert(index > 0.85);
  // The wanted number of segments, by the densities.
  for(const Segmentation_method method :
      {Segmentation_method::DENSITY_PEAKS, Segmentation_method::PERSISTENCE}) {
    assert(segment(method, 2) == 2);
    assert(segment(method, 0) >= 1);
  }

  // A tube's skeleton is a curve in it, that of a ring is a cycle.
  const std::vector<Point> straight = tube(2500, false);
  Skeleton skeleton, again;
  assert(CGAL::extract_l1_medial_skeleton<Tag>(straight, skeleton));
  assert(CGAL::number_of_skeleton_components(skeleton) == 1);
  assert(CGAL::number_of_skeleton_cycles(skeleton) == 0);
  std::cout << "tube: " << number_of_tips(skeleton) << " tips" << std::endl;
  assert(number_of_tips(skeleton) == 2);
  double offset = 0;
  std::size_t points_of_vertices = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Point& p = skeleton[v].point;
    offset += std::hypot(p.y(), p.z()) / double(num_vertices(skeleton));
    points_of_vertices += skeleton[v].points.size();
  }
  std::cout << "tube: mean distance from the axis " << offset << "\n";
  assert(offset < 0.3 * 0.25);
  assert(points_of_vertices == straight.size());

  assert(CGAL::extract_l1_medial_skeleton<Tag>(straight, again));
  assert(num_vertices(again) == num_vertices(skeleton));
  for(std::size_t v = 0; v < num_vertices(again); ++v)
    assert(again[v].point == skeleton[v].point);

  Skeleton ring;
  assert(CGAL::extract_l1_medial_skeleton<Tag>(tube(2500, true), ring));
  assert(CGAL::number_of_skeleton_components(ring) == 1);
  assert(CGAL::number_of_skeleton_cycles(ring) == 1);

  // Halves of the tube, each with a skeleton of its own, joined.
  std::vector<Labelled_point> halves;
  for(const Point& p : straight)
    halves.emplace_back(p, p.x() < 1.5 ? 0 : 1);
  Skeleton joined;
  assert(CGAL::extract_l1_medial_skeleton<Tag>(halves, joined, maps.segment_map(Label_map())));
  assert(CGAL::number_of_skeleton_components(joined) == 1);
  assert(CGAL::number_of_skeleton_cycles(joined) == 0);

  // A cancelled call leaves the skeleton as it was.
  const std::size_t before = num_vertices(joined);
  assert(!CGAL::extract_l1_medial_skeleton<Tag>(
    straight, joined, params::callback([](double fraction) { return fraction < 0.3; })));
  assert(num_vertices(joined) == before);
  std::cout << "done\n";
}
