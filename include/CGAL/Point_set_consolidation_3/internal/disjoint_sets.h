// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DISJOINT_SETS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Disjoint sets; the representative of a set is its smallest member.
class Disjoint_sets {
public:
  explicit Disjoint_sets(std::size_t n) : m_parent(n)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  bool join(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    if(a == b)
      return false;
    m_parent[(std::max)(a, b)] = (std::min)(a, b);
    return true;
  }

private:
  std::vector<std::size_t> m_parent;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DISJOINT_SETS_H
