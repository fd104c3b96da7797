// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_MODELS_H
#define CONSOLIDATION_BENCHMARK_MODELS_H

#include "types.h"

#include <string>
#include <vector>

namespace benchmark {

/// A ground truth mesh of CGAL's data set `meshes/`: closed, one component, outwards oriented.
struct Model {
  std::string name;   ///< file name without ".off"
  std::string group;  ///< tuning: looked at while choosing parameters; check: not; extra: on demand
  std::string reason;  ///< what it adds to the list
};

const std::vector<Model>& models();

/// Names, groups ("tuning", "check", "extra") or "all" to models. Throws `Usage_error` for unknown words.
std::vector<Model> select_models(const std::vector<std::string>& words);

/// The folder given, or that of the environment variable CGAL_DATA_DIR.
std::string data_folder(const std::string& given);

/// Reads meshes/NAME.off below `data`, moved and scaled to a unit diagonal around the origin.
/// Throws `support::File_error` if the file is not what the list says.
support::Triangle_mesh load_model(const Model& model, const std::string& data);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_MODELS_H
