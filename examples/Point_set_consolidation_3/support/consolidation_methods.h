// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_CONSOLIDATION_METHODS_H
#define CONSOLIDATION_SUPPORT_CONSOLIDATION_METHODS_H

#include "consolidation.h"

#include <algorithm>

namespace support {

struct Scan_ranges;

// One translation unit each: they are long to compile.
Consolidation_result consolidate_by_deep_points(const Scan_ranges& scan,
                                                const Consolidation_options& options,
                                                const std::function<void(double)>& progress);
Consolidation_result consolidate_iteratively(const Scan_ranges& scan,
                                             const Consolidation_options& options,
                                             const std::function<void(double)>& progress);
Consolidation_result consolidate_anisotropically(const Scan_ranges& scan,
                                                 const Consolidation_options& options,
                                                 const std::function<void(double)>& progress);

/// A twentieth of the data, at least 4000 points, unless the caller wants otherwise.
inline std::size_t number_of_particles(const Consolidation_options& options, std::size_t n)
{
  if(options.particles > 0)
    return options.particles;
  if(options.percentage > 0)
    return (std::max)(std::size_t(1), std::size_t(options.percentage / 100 * double(n)));
  return (std::min)(n, (std::max)(std::size_t(4000), n / 20));
}

/// CGAL's form of a callback that only listens.
inline std::function<bool(double)> reporting(const std::function<void(double)>& progress)
{
  return [progress](double fraction) {
    if(progress)
      progress(fraction);
    return true;
  };
}

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_CONSOLIDATION_METHODS_H
