// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SORTED_GRID_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SORTED_GRID_H

#include <CGAL/Point_set_consolidation_3/internal/neighbor_block.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Points sorted into cells, for queries of all neighbours within a radius: the only structure for
/// fixed-radius neighbourhoods of the package. Building is a stable counting sort (10-35 ns per
/// point), cheap enough to be repeated whenever the points have moved; the order in which neighbours
/// arrive depends only on the points.
///
/// Cells have the side of the usual query radius. Points and queries outside the box are clamped to its
/// border cells, which keeps every query complete. When a dense table of cells would be larger than
/// a few cells per point (a far outlier, clusters far apart), only occupied cells are kept and rows
/// are found by binary search.
class Sorted_grid {
public:
  Sorted_grid() = default;
  Sorted_grid(const Points& points, double cell_size) { build(points, cell_size); }

  std::size_t size() const { return m_x.size(); }
  double cell_size() const { return m_cell_size; }

  /// The points' indices, cell by cell.
  const std::vector<Index>& order() const& { return m_index; }
  std::vector<Index> order() && { return std::move(m_index); }

  /// Calls `body(const Neighbor_block&)` with all points p, |p - query| <= radius.
  template <typename Body>
  void for_each_neighbor_block(const Vec3& query, double radius, Body&& body) const
  {
    for_each_block(query, Vec3::Constant(radius), radius * radius,
                   [](double x, double y, double z) { return x * x + y * y + z * z; }, body);
  }

  /// The same in the metric |A (p - query)| <= limit; `half_extents` bounds that ellipsoid's box.
  template <typename Body>
  void for_each_ellipsoid_block(const Vec3& query, const Mat3& A, double limit,
                                const Vec3& half_extents, Body&& body) const
  {
    const Mat3 M = A.transpose() * A;
    const double xx = M(0, 0), yy = M(1, 1), zz = M(2, 2);
    const double xy = 2 * M(0, 1), xz = 2 * M(0, 2), yz = 2 * M(1, 2);
    for_each_block(query, half_extents, limit * limit,
                   [=](double x, double y, double z) {
                     return x * (xx * x + xy * y + xz * z) + y * (yy * y + yz * z) + zz * z * z;
                   },
                   body);
  }

  /// Calls `visit(index, squared_distance)` for each neighbour; stops when it returns false.
  template <typename Visitor>
  void for_each_neighbor(const Vec3& query, double radius, Visitor&& visit) const
  {
    const double limit = radius * radius;
    for_each_range(query, Vec3::Constant(radius), [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k) {
        const double x = m_x[k] - query.x(), y = m_y[k] - query.y(), z = m_z[k] - query.z();
        const double d2 = x * x + y * y + z * z;
        if(d2 <= limit && !visit(m_index[k], d2))
          return false;
      }
      return true;
    });
  }

private:
  struct Cell {
    std::uint64_t row;  ///< z * ny + y
    std::uint32_t x;
    bool operator<(const Cell& other) const
    {
      return row != other.row ? row < other.row : x < other.x;
    }
    bool operator==(const Cell& other) const { return row == other.row && x == other.x; }
  };

  static constexpr double max_cells_per_axis = 2147483647.;

  std::uint32_t cell_coordinate(double value, int axis) const
  {
    const double c = std::floor((value - m_origin[axis]) * m_inverse_cell_size);
    return c > 0 ? std::uint32_t((std::min)(c, double(m_dimensions[std::size_t(axis)]) - 1)) : 0;
  }
  Cell cell_of(const Vec3& p) const
  {
    const std::uint64_t y = cell_coordinate(p.y(), 1), z = cell_coordinate(p.z(), 2);
    return Cell{z * m_dimensions[1] + y, cell_coordinate(p.x(), 0)};
  }

  void build(const Points& points, double cell_size)
  {
    const std::size_t n = points.size();
    m_cell_size = cell_size > 0 ? cell_size : 1;
    m_inverse_cell_size = 1 / m_cell_size;
    m_x.resize(n); m_y.resize(n); m_z.resize(n); m_index.resize(n);
    if(n == 0)
      return;

    place_box(points);
    const double cells =
      double(m_dimensions[0]) * double(m_dimensions[1]) * double(m_dimensions[2]);
    m_is_dense = cells <= 8. * double(n) + 131072.;
    m_is_dense ? sort_dense(points, std::size_t(cells)) : sort_sparse(points);
    for(std::size_t k = 0; k < n; ++k) {
      const Vec3& p = points[m_index[k]];
      m_x[k] = p.x(); m_y[k] = p.y(); m_z[k] = p.z();
    }
  }

  /// Box of the points; around the median when an axis would need more cells than can be numbered.
  void place_box(const Points& points)
  {
    const Bounding_box box = bounding_box(points);
    m_origin = box.lower;
    for(int axis = 0; axis < 3; ++axis) {
      double count = std::floor(box.sides()[axis] * m_inverse_cell_size) + 1;
      if(!(count < max_cells_per_axis)) {
        std::vector<double> values;
        values.reserve(points.size());
        for(const Vec3& p : points)
          values.push_back(p[axis]);
        count = max_cells_per_axis;
        m_origin[axis] = median(std::move(values)) - 0.5 * count * m_cell_size;
      }
      m_dimensions[std::size_t(axis)] = std::uint64_t(count);
    }
  }

  void sort_dense(const Points& points, std::size_t cells)
  {
    std::vector<Index> cell(points.size());
    m_first.assign(cells + 1, 0);
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Cell c = cell_of(points[i]);
      cell[i] = Index(c.row * m_dimensions[0] + c.x);
      ++m_first[cell[i] + 1];
    }
    for(std::size_t c = 0; c < cells; ++c)
      m_first[c + 1] += m_first[c];
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t i = 0; i < points.size(); ++i)
      m_index[next[cell[i]]++] = Index(i);
  }

  void sort_sparse(const Points& points)
  {
    std::vector<std::pair<Cell, Index> > keyed(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      keyed[i] = std::make_pair(cell_of(points[i]), Index(i));
    std::sort(keyed.begin(), keyed.end());
    m_cells.clear();
    m_first.clear();
    for(std::size_t k = 0; k < keyed.size(); ++k) {
      m_index[k] = keyed[k].second;
      if(k == 0 || !(keyed[k].first == keyed[k - 1].first)) {
        m_cells.push_back(keyed[k].first);
        m_first.push_back(Index(k));
      }
    }
    m_first.push_back(Index(keyed.size()));
  }

  /// Calls `visit(begin, end)` for runs of sorted points that cover the box around `query`; cells of one
  /// row are consecutive, so each row is one run. Stops when `visit` returns false.
  template <typename Visitor>
  void for_each_range(const Vec3& query, const Vec3& half_extents, Visitor&& visit) const
  {
    if(m_x.empty())
      return;
    const Vec3 lower = query - half_extents, upper = query + half_extents;
    const std::uint32_t x0 = cell_coordinate(lower.x(), 0), x1 = cell_coordinate(upper.x(), 0);
    const std::uint64_t y0 = cell_coordinate(lower.y(), 1), y1 = cell_coordinate(upper.y(), 1);
    const std::uint64_t z0 = cell_coordinate(lower.z(), 2), z1 = cell_coordinate(upper.z(), 2);
    for(std::uint64_t z = z0; z <= z1; ++z) {
      for(std::uint64_t y = y0; y <= y1; ++y) {
        const std::uint64_t row = z * m_dimensions[1] + y;
        std::size_t begin, end;
        if(m_is_dense) {
          begin = m_first[std::size_t(row * m_dimensions[0] + x0)];
          end = m_first[std::size_t(row * m_dimensions[0] + x1) + 1];
        }
        else {
          const auto first = std::lower_bound(m_cells.begin(), m_cells.end(), Cell{row, x0});
          const auto last = std::upper_bound(first, m_cells.end(), Cell{row, x1});
          begin = m_first[std::size_t(first - m_cells.begin())];
          end = m_first[std::size_t(last - m_cells.begin())];
        }
        if(begin < end && !visit(begin, end))
          return;
      }
    }
  }

  /// The accumulation loop: candidates of a row are compacted into the block without branches;
  /// full blocks are handed over.
  template <typename Metric, typename Body>
  void for_each_block(const Vec3& query, const Vec3& half_extents, double limit,
                      const Metric& metric, Body&& body) const
  {
    Neighbor_block block;
    const double qx = query.x(), qy = query.y(), qz = query.z();
    int size = 0;
    for_each_range(query, half_extents, [&](std::size_t k, std::size_t end) {
      while(k < end) {
        const std::size_t stop =
          (std::min)(end, k + std::size_t(Neighbor_block::capacity - size));
        for(; k < stop; ++k) {
          const double x = m_x[k] - qx, y = m_y[k] - qy, z = m_z[k] - qz;
          const double d2 = metric(x, y, z);
          block.dx[size] = x;
          block.dy[size] = y;
          block.dz[size] = z;
          block.d2[size] = d2;
          block.index[size] = m_index[k];
          size += int(d2 <= limit);
        }
        if(size == Neighbor_block::capacity) {
          block.size = size;
          body(static_cast<const Neighbor_block&>(block));
          size = 0;
        }
      }
      return true;
    });
    if(size > 0) {
      block.size = size;
      body(static_cast<const Neighbor_block&>(block));
    }
  }

  double m_cell_size = 1, m_inverse_cell_size = 1;
  Vec3 m_origin = Vec3::Zero();
  std::uint64_t m_dimensions[3] = {1, 1, 1};
  bool m_is_dense = true;
  std::vector<double> m_x, m_y, m_z;  ///< sorted by cell
  std::vector<Index> m_index;         ///< position in the caller's order
  std::vector<Index> m_first;         ///< first sorted point of a cell (dense: all cells; else occupied ones)
  std::vector<Cell> m_cells;          ///< occupied cells in order, sparse case only
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SORTED_GRID_H
