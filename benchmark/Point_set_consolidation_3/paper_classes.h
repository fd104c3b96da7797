// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_PAPER_CLASSES_H
#define CONSOLIDATION_BENCHMARK_PAPER_CLASSES_H

#include <cstddef>
#include <vector>

namespace benchmark {

/// A row of a paper's table of times.
struct Paper_class {
  const char* name;
  const char* model;      ///< of this study, instead of the paper's scan
  std::size_t points, particles;
  double seconds;         ///< the paper's; for the deep points those after WLOP
  double wlop_seconds;    ///< 0: not given
  unsigned int steps;     ///< 0: not given
  bool two_phases;
};

/// Table 1 of the deep points paper, on six cores.
inline const std::vector<Paper_class>& deep_points_classes()
{
  static const std::vector<Paper_class> classes = {
    {"Fig. 1", "armadillo", 84772, 2143, 26.3, 3.1, 0, false},
    {"Fig. 5 & 8", "armadillo", 58710, 6870, 41.2, 4.8, 0, false},
    {"Fig. 9", "armadillo", 22148, 5234, 30.5, 2.7, 0, false},
    {"Fig. 10 T", "armadillo", 43545, 3996, 83.9, 4.1, 0, false},
    {"Fig. 10 B", "armadillo", 78630, 6727, 87.3, 8.4, 0, false},
    {"Fig. 12 T", "armadillo", 24292, 13812, 112.9, 3.2, 0, false},
    {"Fig. 12 B", "armadillo", 32614, 7252, 61.5, 5.5, 0, false},
    {"Fig. 13 T", "armadillo", 40509, 40509, 259.6, 10.5, 0, false},
    {"Fig. 13 B", "armadillo", 67131, 67131, 408.8, 18.9, 0, false},
    {"Fig. 14 T", "armadillo", 175312, 19721, 197.3, 17.8, 0, false},
    {"Fig. 14 B", "armadillo", 300283, 57791, 449.9, 47.3, 0, false},
    {"Fig. 15 T", "armadillo", 292910, 32142, 355.3, 30.3, 0, false},
    {"Fig. 15 B", "armadillo", 483583, 47083, 723.7, 134.9, 0, false}};
  return classes;
}

/// Table I of the iterative consolidation paper, on one core.
inline const std::vector<Paper_class>& iterative_classes()
{
  static const std::vector<Paper_class> classes = {
    {"Inukshuk", "armadillo", 205858, 10293, 193, 0, 6, false},
    {"Hand", "hand", 194457, 38892, 679, 0, 8, false},
    {"Lady", "homer", 175514, 35103, 266, 0, 2, false},
    {"Body", "man", 170346, 8518, 911, 0, 8, true},
    {"Seal", "bunny00", 889076, 44454, 419, 0, 2, false}};
  return classes;
}

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_PAPER_CLASSES_H
