// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the definitions of `every_function.h` share.

#ifndef POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CALLS_H
#define POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CALLS_H

#include "every_function.h"

#include <CGAL/Point_set_consolidation_3/parameters.h>

#include <CGAL/tags.h>

#include <cstring>
#include <iterator>
#include <utility>

namespace every_function {

namespace params = CGAL::Point_set_consolidation_3::parameters;

/// `call(tag, np)` with the run's tag, maps and callback.
template <typename Call>
void with_tag_and_maps(const Cloud& cloud, const Run& run, const Call& call)
{
  const auto np = params::point_map(Point_map{&run}).callback(run.callback);
  const auto oriented = np.normal_map(Normal_map{&run});
  if(run.parallel && cloud.has_normals)
    call(CGAL::Parallel_if_available_tag(), oriented);
  else if(run.parallel)
    call(CGAL::Parallel_if_available_tag(), np);
  else if(cloud.has_normals)
    call(CGAL::Sequential_tag(), oriented);
  else
    call(CGAL::Sequential_tag(), np);
}

/// Functions that write to an output iterator.
template <typename Element, typename Call>
std::vector<Element> written(const Cloud& cloud, const Run& run, Output& output, const Call& call)
{
  std::vector<Element> elements;
  try {
    with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) {
      call(tag, np, std::back_inserter(elements));
    });
  }
  catch(...) {
    output.is_untouched = elements.empty();
    throw;
  }
  output.is_untouched = elements.empty();
  return elements;
}

template <typename Call>
void written_oriented(const Cloud& cloud, const Run& run, Output& output, const Call& call)
{
  for(const auto& p : written<std::pair<Point, Vector> >(cloud, run, output, call)) {
    output.points.push_back(p.first);
    output.normals.push_back(p.second);
  }
}

/// Bit by bit: what is not a number is the same as itself.
inline bool are_same(const Sample& a, const Sample& b)
{
  for(int k = 0; k < 3; ++k) {
    const double x[] = {a.point[k], a.normal[k]}, y[] = {b.point[k], b.normal[k]};
    if(std::memcmp(x, y, sizeof x) != 0)
      return false;
  }
  return a.segment == b.segment;
}

/// Functions that change the range.
template <typename Call>
void changed(const Cloud& cloud, const Run& run, Output& output, const Call& call)
{
  std::vector<Sample> samples = cloud.samples;
  const auto finish = [&] {
    output.is_untouched = true;
    for(std::size_t i = 0; i < samples.size(); ++i)
      output.is_untouched = output.is_untouched && are_same(samples[i], cloud.samples[i]);
  };
  try {
    with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) { call(tag, np, samples); });
  }
  catch(...) {
    finish();
    throw;
  }
  finish();
  for(const Sample& s : samples) {
    output.points.push_back(s.point);
    if(cloud.has_normals)
      output.normals.push_back(s.normal);
    output.numbers.push_back(s.segment);
  }
}

}  // namespace every_function

#endif  // POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CALLS_H
