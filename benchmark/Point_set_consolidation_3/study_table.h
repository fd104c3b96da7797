// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_STUDY_TABLE_H
#define CONSOLIDATION_BENCHMARK_STUDY_TABLE_H

#include "judge.h"

#include <string>
#include <vector>

namespace benchmark {

/// One reconstruction and what the judge says about it.
struct Study_row {
  std::string model, spec, method;
  std::uint64_t seed = 1;
  std::string error;           ///< why there is no result; empty if there is one
  std::vector<double> values;  ///< one per column, none if there is no result

  bool failed() const { return values.empty(); }
  double value(const std::string& column) const;
};

/// Names of the values.
const std::vector<std::string>& study_columns();

std::vector<double> study_values(const Mesh_verdict& verdict, std::size_t points,
                                 double seconds_method, double seconds_mesh);

std::string csv_header();
std::string to_csv(const Study_row& row);
/// The row of a line that `to_csv()` wrote with the same columns; throws `std::runtime_error` otherwise.
Study_row from_csv(const std::string& line);

/// Rows of equal model, spec and method become one: the mean over the seeds. It failed if one of them failed.
std::vector<Study_row> mean_over_seeds(const std::vector<Study_row>& rows);

/// Summary per spec and method, then all cases, losses against `reference` first.
std::string markdown_report(const std::vector<Study_row>& means, const std::string& reference);

/// Geometric mean over the models of the ratio of a column to that of `reference`; not-a-number if there is none.
double mean_ratio(const std::vector<Study_row>& means, const std::string& spec,
                  const std::string& method, const std::string& reference,
                  const std::string& column);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_STUDY_TABLE_H
