// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCALAR_GRID_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCALAR_GRID_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/points.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Values at the nodes of a regular grid, x fastest.
class Scalar_grid {
public:
  Scalar_grid() = default;
  Scalar_grid(const Bounding_box& box, double step, float value) : m_origin(box.lower), m_step(step)
  {
    for(int axis = 0; axis < 3; ++axis)
      m_size[axis] = int(std::ceil(box.sides()[axis] / step)) + 1;
    m_values.assign(number_of_nodes(), value);
  }

  static double nodes_of(const Bounding_box& box, double step)
  {
    return (box.sides() / step).array().ceil().operator+(1).prod();
  }

  std::size_t number_of_nodes() const
  {
    return std::size_t(m_size[0]) * std::size_t(m_size[1]) * std::size_t(m_size[2]);
  }
  int size(int axis) const { return m_size[axis]; }
  double step() const { return m_step; }
  std::size_t stride(int axis) const
  {
    return axis == 0 ? 1 : axis == 1 ? std::size_t(m_size[0])
                                     : std::size_t(m_size[0]) * std::size_t(m_size[1]);
  }
  std::size_t at(int x, int y, int z) const
  {
    return std::size_t(x) + stride(1) * std::size_t(y) + stride(2) * std::size_t(z);
  }
  Vec3 node(int x, int y, int z) const { return m_origin + m_step * Vec3(x, y, z); }
  const Vec3& origin() const { return m_origin; }

  float& operator[](std::size_t i) { return m_values[i]; }
  float operator[](std::size_t i) const { return m_values[i]; }
  float* row(int y, int z) { return m_values.data() + at(0, y, z); }
  const float* row(int y, int z) const { return m_values.data() + at(0, y, z); }

  /// Trilinear; queries outside are clamped to the border.
  double operator()(const Vec3& p) const
  {
    int base[3];
    double fraction[3];
    for(int axis = 0; axis < 3; ++axis) {
      const double last = m_size[axis] - 1;
      const double c = (std::min)((std::max)((p[axis] - m_origin[axis]) / m_step, 0.), last);
      base[axis] = (std::max)(0, (std::min)(int(c), m_size[axis] - 2));
      fraction[axis] = c - base[axis];
    }
    double value = 0;
    for(int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      std::size_t index = at(base[0], base[1], base[2]);
      for(int axis = 0; axis < 3; ++axis) {
        const bool upper = (corner >> axis) & 1;
        weight *= upper ? fraction[axis] : 1 - fraction[axis];
        if(upper && m_size[axis] > 1)
          index += stride(axis);
      }
      value += weight * double(m_values[index]);
    }
    return value;
  }

  /// Central differences of the interpolated values.
  Vec3 gradient(const Vec3& p) const
  {
    Vec3 g;
    for(int axis = 0; axis < 3; ++axis) {
      const Vec3 d = m_step * Vec3(Vec3::Unit(axis));
      g[axis] = ((*this)(p + d) - (*this)(p - d)) / (2 * m_step);
    }
    return g;
  }

  /// Calls `visit(node, neighbor, axis)` for each grid edge, in order.
  template <typename Visitor>
  void for_each_edge(Visitor&& visit) const
  {
    for(int z = 0; z < m_size[2]; ++z)
      for(int y = 0; y < m_size[1]; ++y)
        for(int x = 0; x < m_size[0]; ++x) {
          const std::size_t i = at(x, y, z);
          const int coordinates[3] = {x, y, z};
          for(int axis = 0; axis < 3; ++axis)
            if(coordinates[axis] + 1 < m_size[axis])
              visit(i, i + stride(axis), axis);
        }
  }
  Vec3 node(std::size_t i) const
  {
    const std::size_t x = i % stride(1), y = i / stride(1) % std::size_t(m_size[1]),
                      z = i / stride(2);
    return node(int(x), int(y), int(z));
  }

  /// Separable Gaussian; values beyond the border are those of the border.
  void smooth(const Execution& execution, double sigma)
  {
    const int radius = int(std::ceil(3 * sigma / m_step));
    std::vector<float> kernel(std::size_t(radius) + 1);
    double sum = 0;
    for(int k = -radius; k <= radius; ++k)
      sum += std::exp(-0.5 * k * k * m_step * m_step / (sigma * sigma));
    for(int k = 0; k <= radius; ++k)
      kernel[std::size_t(k)] = float(std::exp(-0.5 * k * k * m_step * m_step / (sigma * sigma)) / sum);
    std::vector<float> source(m_values.size());
    for(int axis = 0; axis < 3; ++axis) {
      source.swap(m_values);
      const long last = m_size[axis] - 1, width = m_size[0];
      const std::size_t rows = std::size_t(m_size[1]) * std::size_t(m_size[2]);
      parallel_for(execution, rows, [&](std::size_t r) {
        typedef Eigen::Map<Eigen::ArrayXf> Row;
        typedef Eigen::Map<const Eigen::ArrayXf> Const_row;
        float* const target = m_values.data() + r * std::size_t(width);
        if(axis == 0) {
          const float* const from = source.data() + r * std::size_t(width);
          for(long x = 0; x < width; ++x) {
            float value = kernel[0] * from[x];
            for(long k = 1; k <= radius; ++k)
              value += kernel[std::size_t(k)] *
                       (from[(std::max)(0L, x - k)] + from[(std::min)(last, x + k)]);
            target[x] = value;
          }
          return;
        }
        const long y = long(r % std::size_t(m_size[1])), z = long(r / std::size_t(m_size[1]));
        const long c = axis == 1 ? y : z;
        const auto from = [&](long k) {
          const long clamped = (std::min)(last, (std::max)(0L, k));
          return Const_row(source.data() + (axis == 1 ? at(0, int(clamped), int(z))
                                                      : at(0, int(y), int(clamped))), width);
        };
        Row row(target, width);
        row = kernel[0] * from(c);
        for(long k = 1; k <= radius; ++k)
          row += kernel[std::size_t(k)] * (from(c - k) + from(c + k));
      });
    }
  }

private:
  Vec3 m_origin = Vec3::Zero();
  double m_step = 1;
  int m_size[3] = {1, 1, 1};
  std::vector<float> m_values;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SCALAR_GRID_H
