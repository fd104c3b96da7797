// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_GRAPHS_H
#define POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_GRAPHS_H

#include "calls.h"

#include <CGAL/Curve_skeleton_3.h>

namespace every_function {

using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

inline void append(const Skeleton& skeleton, Output& output)
{
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    output.points.push_back(skeleton[v].point);
    output.numbers.push_back(skeleton[v].radius);
    for(const std::size_t i : skeleton[v].points)
      output.numbers.push_back(double(i));
  }
  const auto range = edges(skeleton);
  for(auto e = range.first; e != range.second; ++e) {
    output.numbers.push_back(double(source(*e, skeleton)));
    output.numbers.push_back(double(target(*e, skeleton)));
  }
}

}  // namespace every_function

#endif  // POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_GRAPHS_H
