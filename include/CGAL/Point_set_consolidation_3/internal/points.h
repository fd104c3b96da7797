// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_POINTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_POINTS_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Points = std::vector<Vec3>;  ///< contiguous doubles, three per point
using Index = std::uint32_t;       ///< index of a point; bounds a set to 2^32 - 1 points

/// 0, 1, ..., n - 1.
template <typename Number = Index>
std::vector<Number> all_indices(std::size_t n)
{
  std::vector<Number> result(n);
  std::iota(result.begin(), result.end(), Number(0));
  return result;
}

/// The values with these indices, in their order.
template <typename T, typename Number>
std::vector<T> selected(const std::vector<T>& values, const std::vector<Number>& indices)
{
  std::vector<T> result;
  result.reserve(indices.size());
  for(const Number i : indices)
    result.push_back(values[i]);
  return result;
}

/// Length below which a vector has no usable direction (lengths are in units of the spacing).
constexpr double tiny_length = 1e-12;

inline Vec3 normalized_or(const Vec3& v, const Vec3& fallback)
{
  const double length = v.norm();
  return length > tiny_length ? Vec3(v / length) : fallback;
}

struct Bounding_box {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();

  Vec3 sides() const { return upper - lower; }
  double diagonal() const { return sides().norm(); }
  Vec3 centre() const { return lower + 0.5 * (upper - lower); }
  bool contains(const Vec3& p) const
  {
    return (lower.array() <= p.array()).all() && (p.array() <= upper.array()).all();
  }
  bool overlaps(const Bounding_box& other) const
  {
    return (lower.array() <= other.upper.array()).all() &&
           (other.lower.array() <= upper.array()).all();
  }
  Bounding_box grown(double margin) const
  {
    return {lower - Vec3::Constant(margin), upper + Vec3::Constant(margin)};
  }
};

inline Bounding_box bounding_box(const Points& points)
{
  Bounding_box box;
  if(points.empty())
    return box;
  box.lower = box.upper = points.front();
  for(const Vec3& p : points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

/// The coordinates in which all methods work: `local = (world - origin) / unit`.
/// With `unit` a spacing of the data, every threshold of a method is a pure number and results do not
/// depend on the user's unit of length or on the place of the origin.
struct Frame {
  Vec3 origin = Vec3::Zero();
  double unit = 1;

  Vec3 to_local(const Vec3& world) const { return (world - origin) / unit; }
  Vec3 to_world(const Vec3& local) const { return origin + unit * local; }
  Points to_local(Points points) const
  {
    for(Vec3& p : points)
      p = to_local(p);
    return points;
  }
  Points to_world(Points points) const
  {
    for(Vec3& p : points)
      p = to_world(p);
    return points;
  }
};

inline double median(std::vector<double> values)
{
  if(values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_POINTS_H
