// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_PLOT_H
#define CONSOLIDATION_SUPPORT_PLOT_H

#include "types.h"

#include <string>
#include <vector>

namespace support {

/// Values that belong together: they share a color and an entry of the legend.
struct Series {
  enum class Shape { line, marks, marked_line };

  std::string name;
  std::vector<double> x;  ///< empty for bars
  std::vector<double> y;
  Shape shape = Shape::line;
};

/// A diagram of lines over a numerical axis, or of bars if `categories` is not empty: then each
/// series has one value per category, drawn side by side. Values that are not finite, and those that
/// a logarithmic axis cannot show, leave gaps.
struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<std::string> categories;
  std::vector<Series> series;
  bool log_x = false;
  bool log_y = false;
  bool y_from_zero = true;  ///< for linear axes of values that are all positive
  int width = 640;
  int height = 420;
};

/// The share of values that are at most x, as a line from 0 to 1.
Series cumulative_distribution(const std::string& name, std::vector<double> values);

/// \throws std::invalid_argument if a series' lengths do not fit.
std::string svg_of_plot(const Plot& plot);

/// \throws File_error if it cannot be written; no partial file is left.
void write_plot(const std::string& svg_file, const Plot& plot);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_PLOT_H
