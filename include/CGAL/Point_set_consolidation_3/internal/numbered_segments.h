// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NUMBERED_SEGMENTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NUMBERED_SEGMENTS_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>

#include <algorithm>
#include <map>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Labels become 0, 1, .. in the order of their largest segments; ties in the order of the points.
inline Segmentation numbered_by_size(const std::vector<std::size_t>& raw)
{
  struct Entry {
    std::size_t size, first, raw;
  };
  std::map<std::size_t, Entry> found;
  for(std::size_t i = 0; i < raw.size(); ++i) {
    const auto inserted = found.insert({raw[i], Entry{0, i, raw[i]}});
    ++inserted.first->second.size;
  }
  std::vector<Entry> order;
  order.reserve(found.size());
  for(const auto& f : found)
    order.push_back(f.second);
  std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
    return a.size != b.size ? a.size > b.size : a.first < b.first;
  });
  std::map<std::size_t, std::size_t> label;
  for(std::size_t k = 0; k < order.size(); ++k)
    label[order[k].raw] = k;
  Segmentation segmentation;
  segmentation.count = order.size();
  for(const std::size_t r : raw)
    segmentation.labels.push_back(label[r]);
  return segmentation;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NUMBERED_SEGMENTS_H
