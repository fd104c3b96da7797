// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPARSE_LATTICE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPARSE_LATTICE_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <array>
#include <limits>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// A level of an adaptive domain: some of the nodes of a cubic lattice. Level l + 1 has half the spacing
/// of level l and the same origin, as the cells of an octree.

using Lattice_point = std::array<std::int64_t, 3>;

/// Nodes in lexicographic order of (z, y, x), found by their coordinates.
class Sparse_lattice {
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Sparse_lattice() = default;

  /// `nodes_of_row(y, z, xs)` appends the increasing x of the nodes of a row to `xs`.
  template <typename Nodes_of_row>
  Sparse_lattice(const Lattice_point& dimensions, const Nodes_of_row& nodes_of_row)
    : m_dimensions(dimensions)
  {
    m_first.push_back(0);
    for(std::int64_t z = 0; z < dimensions[2]; ++z)
      for(std::int64_t y = 0; y < dimensions[1]; ++y) {
        nodes_of_row(y, z, m_x);
        for(std::size_t i = m_first.back(); i < m_x.size(); ++i)
          m_row.push_back(Index(m_first.size() - 1));
        m_first.push_back(m_x.size());
      }
  }

  std::size_t size() const { return m_x.size(); }
  const Lattice_point& dimensions() const { return m_dimensions; }
  Lattice_point point(std::size_t i) const
  {
    const std::int64_t row = m_row[i];
    return {m_x[i], row % m_dimensions[1], row / m_dimensions[1]};
  }
  std::size_t find(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    if(x < 0 || y < 0 || z < 0 || x >= m_dimensions[0] || y >= m_dimensions[1] ||
       z >= m_dimensions[2])
      return none;
    const std::size_t row = std::size_t(z * m_dimensions[1] + y);
    const std::size_t begin = m_first[row], end = m_first[row + 1];
    if(begin == end || x < m_x[begin])
      return none;
    // rows are a few runs: the place in the first one is a good guess
    const std::size_t guess = begin + std::size_t(x - m_x[begin]);
    if(guess < end && m_x[guess] == x)
      return guess;
    const auto it = std::lower_bound(m_x.begin() + std::ptrdiff_t(begin),
                                     m_x.begin() + std::ptrdiff_t((std::min)(guess, end)), x);
    const std::size_t place = std::size_t(it - m_x.begin());
    return place < end && *it == x ? place : none;
  }
  std::size_t find(const Lattice_point& p) const { return find(p[0], p[1], p[2]); }

  /// The corners of a cell, x fastest; false if one of them is no node.
  bool corners(const Lattice_point& cell, std::array<std::size_t, 8>& nodes) const
  {
    for(std::size_t c = 0; c < 8; ++c) {
      nodes[c] = find(cell[0] + std::int64_t(c & 1), cell[1] + std::int64_t(c >> 1 & 1),
                      cell[2] + std::int64_t(c >> 2));
      if(nodes[c] == none)
        return false;
    }
    return true;
  }

private:
  Lattice_point m_dimensions = {0, 0, 0};
  std::vector<std::int32_t> m_x;
  std::vector<Index> m_row;
  std::vector<std::size_t> m_first;
};

/// Cells of a lattice, as bits of a box.
class Cell_mask {
public:
  /// Of the cells of the box [lower, upper] all or none.
  Cell_mask(const Lattice_point& lower, const Lattice_point& upper, bool value = false) : m_lower(lower)
  {
    std::size_t count = 1;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      m_sides[axis] = (std::max)(std::int64_t(0), upper[axis] - lower[axis] + 1);
      count *= std::size_t(m_sides[axis]);
    }
    m_bits.assign(count, char(value));
  }

  const Lattice_point& lower() const { return m_lower; }
  Lattice_point upper() const
  {
    return {m_lower[0] + m_sides[0] - 1, m_lower[1] + m_sides[1] - 1, m_lower[2] + m_sides[2] - 1};
  }
  bool operator()(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    const std::int64_t i = x - m_lower[0], j = y - m_lower[1], k = z - m_lower[2];
    return i >= 0 && j >= 0 && k >= 0 && i < m_sides[0] && j < m_sides[1] && k < m_sides[2] &&
           m_bits[std::size_t((k * m_sides[1] + j) * m_sides[0] + i)] != 0;
  }
  void set(const Lattice_point& cell, bool value = true)
  {
    const std::int64_t i = cell[0] - m_lower[0], j = cell[1] - m_lower[1], k = cell[2] - m_lower[2];
    if(i >= 0 && j >= 0 && k >= 0 && i < m_sides[0] && j < m_sides[1] && k < m_sides[2])
      m_bits[std::size_t((k * m_sides[1] + j) * m_sides[0] + i)] = char(value);
  }

  /// Adds all cells within `width` cells along each axis.
  void dilate(std::int64_t width)
  {
    const std::array<std::int64_t, 3> stride = {1, m_sides[0], m_sides[0] * m_sides[1]};
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<char> bits = m_bits;
      for(std::size_t b = 0; b < bits.size(); ++b) {
        if(!bits[b])
          continue;
        const std::int64_t at = std::int64_t(b) / stride[axis] % m_sides[axis];
        for(std::int64_t step = -width; step <= width; ++step)
          if(at + step >= 0 && at + step < m_sides[axis])
            m_bits[std::size_t(std::int64_t(b) + step * stride[axis])] = 1;
      }
    }
  }

private:
  Lattice_point m_lower;
  Lattice_point m_sides = {0, 0, 0};
  std::vector<char> m_bits;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SPARSE_LATTICE_H
