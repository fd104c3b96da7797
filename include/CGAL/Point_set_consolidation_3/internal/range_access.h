// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_ACCESS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_ACCESS_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <CGAL/Point_set_consolidation_3/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// From the caller's range, maps and named parameters to plain arrays, and the checks of public functions.
/// Bad input is `std::invalid_argument`, the message names the function and the parameter.

[[noreturn]] inline void throw_invalid(const char* function, const std::string& what)
{
  throw std::invalid_argument(std::string(function) + "(): " + what);
}

inline void require(bool condition, const char* function, const char* what)
{
  if(!condition)
    throw_invalid(function, what);
}

template <typename PointRange, typename NP>
using Np_helper = CGAL::Point_set_processing_3_np_helper<PointRange, NP>;

/// The user's callback, by value: the reference that CGAL's idiom binds may dangle.
template <typename NP>
std::function<bool(double)> callback_of(const NP& np)
{
  return parameter_or<std::function<bool(double)> >(np, CGAL::internal_np::callback,
                                                    std::function<bool(double)>());
}

template <typename T>
Vec3 to_vec3(const T& v)
{
  return Vec3(CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z()));
}

/// Values of a map over a range. `what` names it in error messages.
template <typename PointRange, typename Map>
Points copy_vectors(const char* function, const char* what, const PointRange& range, const Map& map)
{
  typedef typename std::iterator_traits<typename PointRange::const_iterator>::reference Reference;
  Points values;
  std::size_t bad = 0, first_bad = 0;
  for(typename PointRange::const_iterator it = range.begin(); it != range.end(); ++it) {
    Reference key = *it;
    const Vec3 v = to_vec3(get(map, key));
    if(!v.allFinite() && bad++ == 0)
      first_bad = values.size();
    values.push_back(v);
  }
  if(bad > 0)
    throw_invalid(function, std::string(what) + " is not finite for " + std::to_string(bad) +
                              " of " + std::to_string(values.size()) +
                              " points, the first at index " + std::to_string(first_bad));
  return values;
}

/// The points of the range; at least `least` of them are needed.
template <typename PointRange, typename NP>
Points copy_points(const char* function, const PointRange& range, const NP& np, std::size_t least)
{
  const typename Np_helper<PointRange, NP>::Const_point_map map =
    Np_helper<PointRange, NP>::get_const_point_map(range, np);
  Points points = copy_vectors(function, "point_map", range, map);
  if(points.size() < least)
    throw_invalid(function, "needs at least " + std::to_string(least) + " points, got " +
                              std::to_string(points.size()));
  const Vec3 sides = bounding_box(points).sides();
  constexpr double largest_side = 1e150;  // squares of lengths stay finite
  require(sides.maxCoeff() < largest_side, function, "the points' bounding box is too large");
  return points;
}

/// Ranges that carry normals themselves, as Point_set_3 does.
template <typename PointRange, typename = void>
struct Carries_normals : std::false_type {};
template <typename PointRange>
struct Carries_normals<PointRange,
                       std::void_t<decltype(std::declval<const PointRange&>().has_normal_map())> >
  : std::true_type {};

/// Normals of extreme length are scaled: squares of lengths neither overflow nor vanish.
inline Points with_usable_lengths(Points normals)
{
  constexpr double least = 1e-6, most = 1e6;
  for(Vec3& n : normals) {
    const double largest = n.cwiseAbs().maxCoeff();
    if(largest > 0 && (largest < least || largest > most))
      n = (n / largest).normalized();
  }
  return normals;
}

/// The caller's normals; empty if there are none. Zero vectors are kept: they are no hint.
template <typename PointRange, typename NP>
Points copy_normals(const char* function, const PointRange& range, const NP& np)
{
  (void)range;
  if constexpr(has_parameter<NP, CGAL::internal_np::normal_t>) {
    return with_usable_lengths(
      copy_vectors(function, "normal_map", range,
                   CGAL::parameters::get_parameter(np, CGAL::internal_np::normal_map)));
  }
  else {
    if constexpr(Carries_normals<PointRange>::value)
      if(range.has_normal_map())
        return with_usable_lengths(
          copy_vectors(function, "normal_map", range, range.normal_map()));
    return Points();
  }
}

/// A number from the named parameters, or its default; must be finite and positive.
template <typename NP, typename Tag>
double positive(const char* function, const NP& np, Tag tag, const char* name, double fallback)
{
  const double value = CGAL::to_double(parameter_or(np, tag, fallback));
  if(!(value > 0 && std::isfinite(value)))
    throw_invalid(function, std::string(name) + " must be positive, is " + std::to_string(value));
  return value;
}

/// The same, zero allowed.
template <typename NP, typename Tag>
double not_negative(const char* function, const NP& np, Tag tag, const char* name, double fallback)
{
  const double value = CGAL::to_double(parameter_or(np, tag, fallback));
  if(!(value >= 0 && std::isfinite(value)))
    throw_invalid(function,
                  std::string(name) + " must not be negative, is " + std::to_string(value));
  return value;
}

/// Is it one of an enumeration's values, which count from 0 to `last`?
template <typename Enumeration>
bool is_enumerator(Enumeration value, Enumeration last)
{
  return std::size_t(value) <= std::size_t(last);
}

/// One of an enumeration's values from the named parameters, or its default.
template <typename NP, typename Tag, typename Enumeration>
Enumeration enumerator(const char* function, const NP& np, Tag tag, const char* name, Enumeration fallback,
                       Enumeration last)
{
  const Enumeration value = parameter_or(np, tag, fallback);
  if(!is_enumerator(value, last))
    throw_invalid(function, std::string(name) + " is none of its values");
  return value;
}

/// Hands the stages' times to the caller who asked for them.
template <typename NP>
void report_stage_times(const NP& np, const Stage_times& times)
{
  if constexpr(has_parameter<NP, internal_np::stage_times_t>)
    CGAL::parameters::get_parameter(np, internal_np::stage_times).get() = times;
  else {
    (void)np;
    (void)times;
  }
}

/// Calls `work(execution)`, the core of a public function; false if the callback stopped it.
template <typename ConcurrencyTag, typename NP, typename Work>
bool run_core(const char* function, const NP& np, const Work& work)
{
  Execution execution = make_execution<ConcurrencyTag>(callback_of(np));
  try {
    work(execution);
    execution.progress.finish();
  }
  catch(const Cancelled&) {
    return false;
  }
  catch(const Unusable_input& error) {
    throw_invalid(function, error.what());
  }
  report_stage_times(np, execution.times);
  return true;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_ACCESS_H
