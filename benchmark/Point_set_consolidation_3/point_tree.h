// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_POINT_TREE_H
#define CONSOLIDATION_BENCHMARK_POINT_TREE_H

#include "types.h"

#include <memory>

namespace benchmark {

using support::Vec3;

struct Neighbour {
  std::size_t index;
  double distance;
};

/// Nearest neighbours in a point set (CGAL's Kd-tree behind plain data).
class Point_tree {
public:
  explicit Point_tree(const std::vector<Vec3>& points);
  ~Point_tree();
  Point_tree(Point_tree&&) noexcept;

  /// The `k` nearest points, nearest first; fewer if the set is smaller. A point of the set finds itself.
  std::vector<Neighbour> nearest(const Vec3& query, std::size_t k) const;
  Neighbour nearest(const Vec3& query) const { return nearest(query, 1).front(); }

private:
  struct Tree;
  std::unique_ptr<Tree> m_tree;
};

/// Mean distance to the `k` nearest other points, averaged over the set.
double average_spacing(const std::vector<Vec3>& points, std::size_t k = 6);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_POINT_TREE_H
