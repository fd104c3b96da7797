// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Small point sets, most of them odd.

#ifndef POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CLOUDS_H
#define POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CLOUDS_H

#include "every_function.h"

#include <cstdint>

namespace every_function {

/// The same numbers with any standard library.
class Numbers {
public:
  explicit Numbers(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t next();
  double uniform() { return double(next() >> 11) * 0x1.0p-53; }
  double signed_unit() { return 2 * uniform() - 1; }
  Vector direction();

private:
  std::uint64_t m_state;
};

/// A capsule of radius 1 and length 4 along x, the end beyond x > 2.5 missing; outward normals.
Cloud open_capsule(std::size_t n, std::uint64_t seed);

Cloud without_normals(Cloud cloud);
/// `p` goes to `scale * p + offset`.
Cloud transformed(Cloud cloud, double scale, const Vector& offset);

/// Point sets that have a sensible result, or that a function rejects by name.
std::vector<Cloud> odd_clouds();

}  // namespace every_function

#endif  // POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_CLOUDS_H
