// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_BLOCK_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_BLOCK_H

#include <CGAL/Point_set_consolidation_3/internal/points.h>

#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The neighbours of a query, a block at a time, as aligned columns for vectorised arithmetic.
/// `dx, dy, dz` point from the query to the neighbour; `d2` is the squared length in the query's metric.
struct Neighbor_block {
  static constexpr int capacity = 512;  // 18 KB: stays in the first-level cache
  using Column = Eigen::Map<Eigen::Array<double, Eigen::Dynamic, 1>, Eigen::Aligned64>;
  using Const_column = Eigen::Map<const Eigen::Array<double, Eigen::Dynamic, 1>, Eigen::Aligned64>;

  int size = 0;
  alignas(64) double dx[capacity];
  alignas(64) double dy[capacity];
  alignas(64) double dz[capacity];
  alignas(64) double d2[capacity];
  alignas(64) Index index[capacity];

  Const_column x() const { return Const_column(dx, size); }
  Const_column y() const { return Const_column(dy, size); }
  Const_column z() const { return Const_column(dz, size); }
  Const_column squared_distance() const { return Const_column(d2, size); }
  Vec3 offset(int k) const { return Vec3(dx[k], dy[k], dz[k]); }
  /// Sum of the offsets times their weights.
  Vec3 weighted_offset(const Column& w) const { return Vec3((w * x()).sum(), (w * y()).sum(), (w * z()).sum()); }
};

/// exp(x) of `lanes` numbers at once for x in [-700, 700], limited to those ends. Relative error 2e-15 down to x =
/// -16, where weights end, and |x| times the rounding error beyond; 0 gives 1. Three times as fast as `Eigen::exp`
/// with SSE2, where that spends most of a weight's time:
/// 2^t = 2^k 2^r with k the integer next to t; k is read from, and added to, the bits of the numbers.
struct Exponential {
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<double, lanes, 1>;

  static Lanes of(const Lanes& x)
  {
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
    return x.max(-700.).min(700.).exp();  // rounding by a large summand would be "simplified" away
#else
    // 2^r over [-1/2, 1/2], interpolated at the Chebyshev nodes: 3e-16
    constexpr double c[] = {1.,                    0.69314718055995,       0.24022650695910097,
                            0.05550410866444772,   0.009618129107606888,   0.0013333558230164974,
                            0.0001540353044173605, 1.5252657260200837e-05, 1.321544258792169e-06,
                            1.0208690299958306e-07, 7.072585949269223e-09};
    constexpr double log2_e = 1.4426950408889634;
    constexpr double to_integer = 6755399441055744.;  // 1.5 * 2^52: the last bit of a sum with it is 1

    const Lanes t = x.max(-700.).min(700.) * log2_e;
    const Lanes shifted = t + to_integer;
    const Lanes r = t - (shifted - to_integer);
    Lanes power = Lanes::Constant(c[10]);
    for(int i = 9; i >= 0; --i)
      power = power * r + c[i];
    std::uint64_t bits[lanes], k[lanes];
    std::memcpy(bits, power.data(), sizeof bits);
    std::memcpy(k, shifted.data(), sizeof k);
    for(int i = 0; i < lanes; ++i)
      bits[i] += k[i] << 52;
    std::memcpy(power.data(), bits, sizeof bits);
    return power;
#endif
  }
};

/// A column of weights beside a block.
struct Block_weights {
  alignas(64) double values[Neighbor_block::capacity];

  Neighbor_block::Column column(int size) { return Neighbor_block::Column(values, size); }
  double& operator[](int k) { return values[k]; }

  /// exp(-factor d^2) of the block's neighbours.
  Neighbor_block::Column set_gaussian(double factor, const Neighbor_block& block)
  {
    using Lanes = Exponential::Lanes;
    constexpr int lanes = Exponential::lanes;
    int k = 0;
    for(; k + lanes <= block.size; k += lanes)
      Eigen::Map<Lanes, Eigen::Aligned64>(values + k) =
        Exponential::of(-factor * Eigen::Map<const Lanes, Eigen::Aligned64>(block.d2 + k));
    if(k < block.size) {
      const std::size_t bytes = sizeof(double) * std::size_t(block.size - k);
      Lanes rest = Lanes::Zero();
      std::memcpy(rest.data(), block.d2 + k, bytes);
      rest = Exponential::of(-factor * rest);
      std::memcpy(values + k, rest.data(), bytes);
    }
    return column(block.size);
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEIGHBOR_BLOCK_H
