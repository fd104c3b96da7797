// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_METHODS_H
#define CONSOLIDATION_BENCHMARK_METHODS_H

#include "types.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace benchmark {

using support::Point_cloud;
using support::Triangle_mesh;
using support::Vec3;

/// What a method makes of a scan: oriented points for Poisson reconstruction or a mesh of its own.
struct Method_result {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::optional<Triangle_mesh>
      mesh;  ///< if given, it is judged instead of the Poisson mesh of the points
  double noise = 0;  ///< of the scan; 0: not known
};

struct Method {
  std::string name;
  std::string description;
  /// Gets points, directions towards the scanner and view indices. The model has unit diagonal.
  std::function<Method_result(const Point_cloud& scan)> run;
  bool baseline;  ///< does not depend on the package: its results may be kept from run to run
};

/// Add a method by one line in `methods.cpp`.
const std::vector<Method>& methods();

/// Throws `Usage_error` for an unknown name.
const Method& method_called(const std::string& name);

/// All methods are meshed with this: lengths relative to the model, which has unit diagonal, so that no method is
/// punished for the coarser facets that a sparser point set would get.
Triangle_mesh reconstruct(const Method_result& result);

/// Part of the key under which results of baselines are kept; change it with the settings in `methods.cpp`.
extern const char* const baseline_settings;

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_METHODS_H
