// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_SYNTHETIC_SCANS_H
#define CONSOLIDATION_BENCHMARK_SYNTHETIC_SCANS_H

#include "random_numbers.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

/// Shapes given by exact distances, and scans of them: ground truth of tests and figures.
namespace synthetic {

using Vec3 = Eigen::Vector3d;
using benchmark::Random_numbers;
using Function = std::function<double(const Vec3&)>;

/// A solid: signed distance of its surface (negative inside, exact near the surface), distance to
/// its skeleton, bounding box.
class Shape {
public:
  Shape(Function distance, Function skeleton_distance, const Vec3& lower, const Vec3& upper)
    : lower(lower), upper(upper), m_distance(std::move(distance)), m_skeleton_distance(std::move(skeleton_distance))
  {}

  double distance(const Vec3& p) const { return m_distance(p); }
  double skeleton_distance(const Vec3& p) const { return m_skeleton_distance(p); }
  double diagonal() const { return (upper - lower).norm(); }

  Vec3 normal(const Vec3& p) const
  {
    const double h = 1e-5 * diagonal();
    Vec3 g;
    for(int axis = 0; axis < 3; ++axis) {
      const Vec3 d = h * Vec3(Vec3::Unit(axis));
      g[axis] = distance(p + d) - distance(p - d);
    }
    return g.normalized();
  }

  Vec3 lower, upper;

private:
  Function m_distance, m_skeleton_distance;
};

inline Shape torus(double major, double minor)
{
  const auto to_circle = [=](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - major, p.z());
  };
  const double side = major + minor;
  return Shape([=](const Vec3& p) { return to_circle(p) - minor; }, to_circle,
               Vec3(-side, -side, -minor), Vec3(side, side, minor));
}

/// A tube from a to b with round caps.
inline Shape capsule(const Vec3& a, const Vec3& b, double radius)
{
  const auto to_segment = [=](const Vec3& p) {
    const Vec3 d = b - a;
    const double t = (std::min)(1., (std::max)(0., (p - a).dot(d) / d.squaredNorm()));
    return (p - a - t * d).norm();
  };
  const Vec3 r = Vec3::Constant(radius);
  return Shape([=](const Vec3& p) { return to_segment(p) - radius; }, to_segment,
               a.cwiseMin(b) - r, a.cwiseMax(b) + r);
}

/// width x depth x thickness around the origin; its skeleton is the mid-sheet.
inline Shape plate(double width, double depth, double thickness)
{
  const Vec3 half(0.5 * width, 0.5 * depth, 0.5 * thickness);
  return Shape(
    [=](const Vec3& p) {
      const Vec3 q = p.cwiseAbs() - half;
      return q.cwiseMax(0.).norm() + (std::min)(0., q.maxCoeff());
    },
    [](const Vec3& p) { return std::abs(p.z()); }, -half, half);
}

inline Shape united(const std::vector<Shape>& parts)
{
  Vec3 lower = parts.front().lower, upper = parts.front().upper;
  for(const Shape& part : parts) {
    lower = lower.cwiseMin(part.lower);
    upper = upper.cwiseMax(part.upper);
  }
  const auto least = [parts](double (Shape::*value)(const Vec3&) const) {
    return [parts, value](const Vec3& p) {
      double result = (parts.front().*value)(p);
      for(const Shape& part : parts)
        result = (std::min)(result, (part.*value)(p));
      return result;
    };
  };
  return Shape(least(&Shape::distance), least(&Shape::skeleton_distance), lower, upper);
}

/// First hit of the ray from `origin` along the unit vector `direction`, by sphere tracing; NaN: none.
inline Vec3 hit(const Shape& shape, const Vec3& origin, const Vec3& direction, double length)
{
  const double near = 1e-9 * shape.diagonal();
  double t = 0;
  for(int step = 0; step < 500 && t < length; ++step) {
    Vec3 p = origin + t * direction;
    const double d = shape.distance(p);
    if(d < near)
      return p;
    t += d;
  }
  return Vec3::Constant(std::nan(""));
}

struct Scan {
  std::vector<Vec3> points;
  std::vector<Vec3> directions;  ///< towards the scanner
  std::vector<Vec3> hidden;      ///< surface samples that no view sees
};

/// Points evenly spread over the surface: chords in random directions.
inline std::vector<Vec3> samples(const Shape& shape, std::size_t count, std::uint64_t seed)
{
  Random_numbers random(seed);
  std::vector<Vec3> points;
  const double radius = 0.5 * shape.diagonal();
  const Vec3 centre = 0.5 * (shape.lower + shape.upper);
  while(points.size() < count) {
    const Vec3 direction = random.direction();
    const Vec3 side = direction.unitOrthogonal(), up = direction.cross(side);
    const Vec3 origin = centre + radius * ((2 * random.uniform() - 1) * side +
                                           (2 * random.uniform() - 1) * up - 2 * direction);
    const Vec3 p = hit(shape, origin, direction, 4 * radius);
    if(p.allFinite())
      points.push_back(p);
  }
  return points;
}

/// Orthographic views; surfaces at grazing angles return nothing.
inline Scan scan(const Shape& shape, const std::vector<Vec3>& views, std::size_t count,
                 std::uint64_t seed)
{
  constexpr double grazing_cosine = 0.15;
  Random_numbers random(seed);
  Scan result;
  const double radius = 0.5 * shape.diagonal();
  const Vec3 centre = 0.5 * (shape.lower + shape.upper);
  const auto cast = [&](const Vec3& view, const Vec3& through) {
    const Vec3 p = hit(shape, through + 2 * radius * view, -view, 4 * radius);
    return p.allFinite() && shape.normal(p).dot(view) > grazing_cosine
             ? p : Vec3(Vec3::Constant(std::nan("")));
  };
  while(result.points.size() < count) {
    const Vec3 view = views[result.points.size() % views.size()].normalized();
    const Vec3 side = view.unitOrthogonal(), up = view.cross(side);
    const Vec3 p = cast(view, centre + radius * ((2 * random.uniform() - 1) * side +
                                                 (2 * random.uniform() - 1) * up));
    if(p.allFinite()) {
      result.points.push_back(p);
      result.directions.push_back(view);
    }
  }
  for(const Vec3& s : samples(shape, 1000, seed + 1)) {
    bool is_seen = false;
    for(const Vec3& v : views) {
      const Vec3 view = v.normalized();
      const Vec3 p = cast(view, s);
      is_seen = is_seen || (p.allFinite() && (p - s).norm() < 1e-3 * shape.diagonal());
    }
    if(!is_seen)
      result.hidden.push_back(s);
  }
  return result;
}

}  // namespace synthetic

#endif  // CONSOLIDATION_BENCHMARK_SYNTHETIC_SCANS_H
