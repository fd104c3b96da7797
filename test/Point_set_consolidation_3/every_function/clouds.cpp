// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clouds.h"

#include <cmath>
#include <limits>

namespace every_function {

// splitmix64
std::uint64_t Numbers::next()
{
  m_state += 0x9e3779b97f4a7c15u;
  std::uint64_t z = m_state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

Vector Numbers::direction()
{
  for(;;) {
    const double x = signed_unit(), y = signed_unit(), z = signed_unit();
    const double length = std::sqrt(x * x + y * y + z * z);
    if(length > 0.01 && length < 1)
      return Vector(x / length, y / length, z / length);
  }
}

Cloud open_capsule(std::size_t n, std::uint64_t seed)
{
  Numbers numbers(seed);
  Cloud cloud{"open capsule", {}, true};
  while(cloud.samples.size() < n) {
    const bool on_cap = numbers.uniform() < 0.5;
    const Vector d = numbers.direction();
    if(on_cap) {
      const Point p(d.x() + (d.x() > 0 ? 2 : 0), d.y(), d.z());
      if(p.x() < 2.5)
        cloud.samples.push_back({p, d, 0});
      continue;
    }
    const double r = std::sqrt(d.y() * d.y() + d.z() * d.z());
    if(r < 0.01)
      continue;
    const Vector side(0, d.y() / r, d.z() / r);
    cloud.samples.push_back({Point(2 * numbers.uniform(), side.y(), side.z()), side, 0});
  }
  return cloud;
}

Cloud without_normals(Cloud cloud)
{
  cloud.has_normals = false;
  cloud.name += ", no normals";
  return cloud;
}

Cloud transformed(Cloud cloud, double scale, const Vector& offset)
{
  for(Sample& s : cloud.samples)
    s.point = Point(scale * s.point.x() + offset.x(), scale * s.point.y() + offset.y(),
                    scale * s.point.z() + offset.z());
  return cloud;
}

namespace {

Sample up(double x, double y, double z)
{
  return {Point(x, y, z), Vector(0, 0, 1), 0};
}

Cloud named(const char* name, Cloud cloud)
{
  cloud.name = name;
  return cloud;
}

void degenerate(std::vector<Cloud>& clouds)
{
  constexpr double third = 1. / 3;
  const std::vector<Sample> few = {up(0.1, third, 7), up(1.3, -2, 7.5), up(0.5, 4, 6)};
  for(std::size_t n = 0; n <= few.size(); ++n)
    clouds.push_back({std::to_string(n) + " points",
                      std::vector<Sample>(few.begin(), few.begin() + std::ptrdiff_t(n)), true});
  clouds.push_back({"all equal", std::vector<Sample>(120, up(0.1, third, 7)), true});

  Cloud two_places{"two places", {}, true}, most_equal{"all but 20 equal", {}, true};
  Numbers numbers(3);
  for(int i = 0; i < 120; ++i) {
    two_places.samples.push_back(i % 2 ? up(1, 1, 1) : up(2, 0.1, 1));
    most_equal.samples.push_back(i >= 20 ? up(0, 0, 0)
                                         : up(numbers.uniform(), numbers.uniform(), numbers.uniform()));
  }
  clouds.push_back(two_places);
  clouds.push_back(most_equal);

  Cloud quarter_equal = open_capsule(150, 4);
  quarter_equal.samples.insert(quarter_equal.samples.end(), 50, up(1, 0, 1));
  clouds.push_back(named("a quarter equal", quarter_equal));

  Cloud twice = open_capsule(150, 4);
  const std::vector<Sample> once = twice.samples;
  twice.samples.insert(twice.samples.end(), once.begin(), once.end());
  clouds.push_back(named("every point twice", twice));

  Cloud line{"collinear", {}, true}, even_line{"evenly collinear", {}, true}, plane{"planar", {}, true},
    grid{"regular grid", {}, true}, lattice{"regular lattice", {}, true};
  for(int i = 0; i < 150; ++i) {
    const double t = numbers.uniform();
    line.samples.push_back(up(0.3 * t, 0.7 * t, 0));
    even_line.samples.push_back(up(i, 0, 0));
    plane.samples.push_back(up(numbers.uniform(), numbers.uniform(), 0));
  }
  for(int i = 0; i < 14; ++i)
    for(int j = 0; j < 14; ++j)
      grid.samples.push_back(up(i, j, 0));
  for(int i = 0; i < 6; ++i)
    for(int j = 0; j < 6; ++j)
      for(int k = 0; k < 6; ++k)
        lattice.samples.push_back(up(i, j, k));
  for(const Cloud& cloud : {line, even_line, plane, grid, lattice})
    clouds.push_back(cloud);
}

void far_apart(std::vector<Cloud>& clouds)
{
  const Cloud capsule = open_capsule(250, 5);
  Cloud far = capsule;
  far.samples.push_back(up(1e30, 0, 0));
  clouds.push_back(named("one point at 1e30", far));
  far.samples.back() = up(1e200, 0, 0);
  clouds.push_back(named("one point at 1e200", far));
  Cloud clusters = capsule;
  for(const Sample& s : capsule.samples) {
    clusters.samples.push_back(s);
    clusters.samples.back().point = s.point + Vector(1e7, 0, 0);
  }
  clouds.push_back(named("two clusters 1e7 apart", clusters));
  Cloud outliers = capsule;
  Numbers numbers(6);
  for(int i = 0; i < 200; ++i)
    outliers.samples.push_back({Point(20 * numbers.signed_unit(), 20 * numbers.signed_unit(),
                                      20 * numbers.signed_unit()), numbers.direction(), 0});
  clouds.push_back(named("nearly half outliers", outliers));
  outliers.samples.erase(outliers.samples.begin() + 22, outliers.samples.begin() + 250);
  clouds.push_back(named("nine of ten outliers", outliers));
  clouds.push_back(named("georeferenced", transformed(capsule, 1, Vector(256075, 3935300, 120))));
  clouds.push_back(named("unit of 1e-20", transformed(capsule, 1e-20, Vector(0, 0, 0))));
  clouds.push_back(named("unit of 1e20", transformed(capsule, 1e20, Vector(0, 0, 0))));
  clouds.push_back(named("unit of 1e-160", transformed(capsule, 1e-160, Vector(0, 0, 0))));
  clouds.push_back(named("offset of 1e15 units", transformed(capsule, 1, Vector(1e15, 1e15, 0))));
}

void normals(std::vector<Cloud>& clouds)
{
  const Cloud capsule = open_capsule(250, 7);
  clouds.push_back(without_normals(capsule));
  Cloud zero = capsule, one_zero = capsule, long_ones = capsule, short_ones = capsule,
    flipped = capsule, half = capsule, random = capsule;
  Numbers numbers(8);
  for(std::size_t i = 0; i < capsule.samples.size(); ++i) {
    const Vector n = capsule.samples[i].normal;
    zero.samples[i].normal = Vector(0, 0, 0);
    long_ones.samples[i].normal = (i % 3 == 0 ? 1e200 : 1 + double(i)) * n;
    short_ones.samples[i].normal = (i % 3 == 0 ? 1e-200 : 1e-13) * n;
    flipped.samples[i].normal = -n;
    half.samples[i].normal = i % 2 ? n : -n;
    random.samples[i].normal = numbers.direction();
  }
  one_zero.samples[17].normal = Vector(0, 0, 0);
  clouds.push_back(named("normals zero", zero));
  clouds.push_back(named("one normal zero", one_zero));
  clouds.push_back(named("normals long", long_ones));
  clouds.push_back(named("normals short", short_ones));
  clouds.push_back(named("normals flipped", flipped));
  clouds.push_back(named("normals half flipped", half));
  clouds.push_back(named("normals at random", random));
}

void not_finite(std::vector<Cloud>& clouds)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Cloud capsule = open_capsule(100, 9);
  for(const double bad : {nan, infinity, -infinity}) {
    Cloud point = capsule, normal = capsule;
    point.samples[17].point = Point(1, bad, 1);
    point.samples[40].point = Point(1, 1, bad);
    normal.samples[17].normal = Vector(0, 0, bad);
    normal.samples[40].normal = Vector(bad, 0, 0);
    clouds.push_back(named("point 17 not finite", point));
    clouds.push_back(named("normal 17 not finite", normal));
  }
}

}  // namespace

std::vector<Cloud> odd_clouds()
{
  std::vector<Cloud> clouds;
  degenerate(clouds);
  far_apart(clouds);
  normals(clouds);
  not_finite(clouds);
  clouds.push_back(open_capsule(300, 1));
  return clouds;
}

}  // namespace every_function
