// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WRITE_BACK_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WRITE_BACK_H

#include <CGAL/Point_set_consolidation_3/internal/range_access.h>

#include <functional>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// From plain arrays back to the caller's range, maps and iterators.

template <typename Traits>
typename Traits::Point_3 to_point(const Vec3& p)
{
  typedef typename Traits::FT FT;
  return typename Traits::Point_3(FT(p.x()), FT(p.y()), FT(p.z()));
}

template <typename Traits>
typename Traits::Vector_3 to_vector(const Vec3& v)
{
  typedef typename Traits::FT FT;
  return typename Traits::Vector_3(FT(v.x()), FT(v.y()), FT(v.z()));
}

/// Pairs of a point and its normal.
template <typename Traits, typename OutputIterator>
OutputIterator write_oriented(const Points& points, const Points& normals, OutputIterator output)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    *output++ = std::make_pair(to_point<Traits>(points[i]), to_vector<Traits>(normals[i]));
  return output;
}

/// Calls `write(reference, i)` for the i-th element of the range.
template <typename PointRange, typename Write>
void for_each_indexed(PointRange& range, const Write& write)
{
  std::size_t i = 0;
  for(auto it = range.begin(); it != range.end(); ++it)
    write(*it, i++);
}

/// Positions, and normals unless empty, through the maps of a range that the function may change.
template <typename PointRange, typename NP>
void put_points(PointRange& range, const NP& np, const Points& points, const Points& normals)
{
  typedef Np_helper<PointRange, NP> Helper;
  typedef typename Helper::Geom_traits Traits;
  auto point_map = Helper::get_point_map(range, np);
  for_each_indexed(range, [&](auto&& key, std::size_t i) {
    put(point_map, key, to_point<Traits>(points[i]));
  });
  if(normals.empty())
    return;
  if constexpr(has_parameter<NP, CGAL::internal_np::normal_t>) {
    auto normal_map = CGAL::parameters::get_parameter(np, CGAL::internal_np::normal_map);
    for_each_indexed(range, [&](auto&& key, std::size_t i) {
      put(normal_map, key, to_vector<Traits>(normals[i]));
    });
  }
  else if constexpr(Carries_normals<PointRange>::value) {
    auto normal_map = range.normal_map();
    for_each_indexed(range, [&](auto&& key, std::size_t i) {
      put(normal_map, key, to_vector<Traits>(normals[i]));
    });
  }
}

template <typename T>
const T& dereferenced(const T& value)
{
  return value;
}
template <typename T>
T& dereferenced(const std::reference_wrapper<T>& value)
{
  return value.get();
}

/// A range of points given as a named parameter, by value or by `std::ref`; empty if it is not given.
template <typename NP, typename Tag>
Points points_parameter(const char* function, const char* name, const NP& np, Tag tag)
{
  Points points;
  if constexpr(has_parameter<NP, Tag>) {
    const auto parameter = CGAL::parameters::get_parameter(np, tag);
    for(const auto& p : dereferenced(parameter)) {
      points.push_back(to_vec3(p));
      if(!points.back().allFinite())
        throw_invalid(function, std::string(name) + " is not finite at index " +
                                  std::to_string(points.size() - 1));
    }
  }
  else {
    (void)function; (void)name; (void)np; (void)tag;
  }
  return points;
}

/// Flags of `point_is_constrained_map`; empty if it is not given.
template <typename PointRange, typename NP>
std::vector<char> copy_constrained(const PointRange& range, const NP& np)
{
  std::vector<char> is_constrained;
  if constexpr(has_parameter<NP, CGAL::internal_np::point_is_constrained_t>) {
    const auto map = CGAL::parameters::get_parameter(np, CGAL::internal_np::point_is_constrained);
    for(typename PointRange::const_iterator it = range.begin(); it != range.end(); ++it)
      is_constrained.push_back(get(map, *it) ? 1 : 0);
  }
  else {
    (void)range; (void)np;
  }
  return is_constrained;
}

/// Values to an output iterator that is a named parameter; nothing if it is not given.
template <typename NP, typename Tag, typename Values>
void write_to(const NP& np, Tag tag, const Values& values)
{
  if constexpr(has_parameter<NP, Tag>) {
    auto output = CGAL::parameters::get_parameter(np, tag);
    for(const auto& value : values)
      *output++ = value;
  }
  else {
    (void)np; (void)tag; (void)values;
  }
}

/// The unit normals that a function cannot do without.
template <typename PointRange, typename NP>
Points copy_unit_normals(const char* function, const PointRange& range, const NP& np)
{
  Points normals = copy_normals(function, range, np);
  if(normals.empty() && range.begin() != range.end())
    throw_invalid(function, "needs a normal_map");
  for(std::size_t i = 0; i < normals.size(); ++i) {
    const double length = normals[i].norm();
    if(!(length > 0))
      throw_invalid(function, "normal_map is zero for the point at index " + std::to_string(i));
    normals[i] /= length;
  }
  return normals;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WRITE_BACK_H
