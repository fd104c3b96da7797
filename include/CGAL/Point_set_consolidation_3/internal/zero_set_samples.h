// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ZERO_SET_SAMPLES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ZERO_SET_SAMPLES_H

#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/scalar_grid.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Points on the zero set of a grid that are closer to each other than its nodes: each cell that the set crosses is
/// divided in eight, with values between the nodes by cubics (Lagrange's), and the edges of the parts are searched for
/// changes of sign.
class Zero_set_samples {
  static constexpr std::size_t nodes = 3;             ///< of a divided cell, along an axis
  static constexpr std::size_t support = 4;           ///< nodes of the grid that a cubic needs
  typedef std::array<float, nodes * nodes * nodes> Values;

public:
  /// In cells with a corner of `is_outside`; on the inner side the grid is not positive.
  static Points find(const Execution& execution, const Scalar_grid& grid, const std::vector<char>& is_outside)
  {
    std::vector<Points> of_layer(std::size_t(grid.size(2)));
    parallel_for(execution, of_layer.size(), [&](std::size_t layer) {
      const int z = int(layer);
      if(z + 1 == grid.size(2))
        return;
      for(int y = 0; y + 1 < grid.size(1); ++y)
        for(int x = 0; x + 1 < grid.size(0); ++x)
          if(is_crossed(grid, is_outside, {x, y, z}))
            add_crossings(grid, is_outside, {x, y, z}, of_layer[layer]);
    }, long_bodies);
    Points points;
    for(const Points& layer : of_layer)
      points.insert(points.end(), layer.begin(), layer.end());
    return points;
  }

private:
  /// A cell by its lowest node.
  typedef std::array<int, 3> Cell;

  static bool is_crossed(const Scalar_grid& grid, const std::vector<char>& is_outside, const Cell& cell)
  {
    bool has_outside = false, has_inside = false;
    for(int corner = 0; corner < 8; ++corner) {
      const std::size_t i =
        grid.at(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2));
      has_outside = has_outside || is_outside[i];
      has_inside = has_inside || grid[i] <= 0;
    }
    return has_outside && has_inside;
  }

  /// Whether a cell before this one, in x, y, z or several of them, is crossed; bit k of the index: in axis k.
  typedef std::array<bool, 8> Crossed_before;

  static Crossed_before crossed_before(const Scalar_grid& grid, const std::vector<char>& is_outside, const Cell& cell)
  {
    Crossed_before crossed{};
    for(int which = 1; which < 8; ++which) {
      const Cell before = {cell[0] - (which & 1), cell[1] - (which >> 1 & 1), cell[2] - (which >> 2)};
      crossed[std::size_t(which)] =
        before[0] >= 0 && before[1] >= 0 && before[2] >= 0 && is_crossed(grid, is_outside, before);
    }
    return crossed;
  }

  /// Whether one of those before has the edge along `axis` from `place` as well, and has found its point.
  static bool is_shared(const Crossed_before& crossed, const std::array<std::size_t, 3>& place, std::size_t axis)
  {
    unsigned int faces = 0;  // the lower ones that hold the edge
    for(std::size_t other = 0; other < 3; ++other)
      if(other != axis && place[other] == 0)
        faces |= 1u << other;
    for(unsigned int which = 1; which < 8; ++which)
      if((which & faces) == which && crossed[which])
        return true;
    return false;
  }

  static void add_crossings(const Scalar_grid& grid, const std::vector<char>& is_outside, const Cell& cell,
                            Points& points)
  {
    const Values values = divided(grid, cell);
    const Crossed_before crossed = crossed_before(grid, is_outside, cell);
    const double step = grid.step() / double(nodes - 1);
    const Vec3 corner = grid.node(cell[0], cell[1], cell[2]);
    for(std::size_t i = 0; i < values.size(); ++i) {
      const std::array<std::size_t, 3> place = {i % nodes, i / nodes % nodes, i / (nodes * nodes)};
      for(std::size_t axis = 0, stride = 1; axis < 3; ++axis, stride *= nodes) {
        if(place[axis] + 1 == nodes)
          continue;
        const double a = values[i], b = values[i + stride];
        if((a > 0) == (b > 0) || is_shared(crossed, place, axis))
          continue;
        Vec3 p = Vec3(double(place[0]), double(place[1]), double(place[2]));
        p[Eigen::Index(axis)] += a / (a - b);
        points.push_back(corner + step * p);
      }
    }
  }

  /// Values at the corners of the parts, x fastest: cubics along z, then y, then x.
  static Values divided(const Scalar_grid& grid, const Cell& cell)
  {
    const auto clamped = [&](int axis, int coordinate) {
      return (std::max)(0, (std::min)(grid.size(axis) - 1, coordinate));
    };
    std::array<float, support * support * nodes> along_z;
    for(std::size_t j = 0; j < support; ++j)
      for(std::size_t i = 0; i < support; ++i) {
        std::array<float, support> column;
        for(std::size_t k = 0; k < support; ++k)
          column[k] =
            grid[grid.at(clamped(0, cell[0] + int(i) - 1), clamped(1, cell[1] + int(j) - 1),
                         clamped(2, cell[2] + int(k) - 1))];
        for(std::size_t k = 0; k < nodes; ++k)
          along_z[(k * support + j) * support + i] = between(column, k);
      }
    Values values;
    for(std::size_t k = 0; k < nodes; ++k) {
      std::array<float, support * nodes> along_y;
      for(std::size_t i = 0; i < support; ++i) {
        std::array<float, support> column;
        for(std::size_t j = 0; j < support; ++j)
          column[j] = along_z[(k * support + j) * support + i];
        for(std::size_t j = 0; j < nodes; ++j)
          along_y[j * support + i] = between(column, j);
      }
      for(std::size_t j = 0; j < nodes; ++j) {
        std::array<float, support> row;
        for(std::size_t i = 0; i < support; ++i)
          row[i] = along_y[j * support + i];
        for(std::size_t i = 0; i < nodes; ++i)
          values[(k * nodes + j) * nodes + i] = between(row, i);
      }
    }
    return values;
  }

  /// At the second value, in the middle, at the third.
  static float between(const std::array<float, support>& v, std::size_t place)
  {
    return place == 0 ? v[1] : place == 2 ? v[2] : (9 * (v[1] + v[2]) - v[0] - v[3]) / 16;
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ZERO_SET_SAMPLES_H
