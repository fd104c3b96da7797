// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_SKELETON_RUNS_H
#define CONSOLIDATION_BENCHMARK_SKELETON_RUNS_H

#include "types.h"

#include <string>
#include <vector>

namespace benchmark {

using support::Triangle_mesh;
using support::Vec3;

/// The package's skeletons and the surfaces they drive, behind plain data and compiled once.

enum class Laplacian_weight { cotangent, mean_value, combinatorial };

struct Skeleton_options {
  Laplacian_weight weights = Laplacian_weight::cotangent;
  double contraction_weight = 1;    ///< W_L^0, relative to its default
  double attraction_weight = 1;     ///< W_H^0
  double contraction_factor = 3;    ///< s_L
  std::size_t most_samples = 30000;
  bool extends_tips = false;
};

struct Skeleton_run {
  support::Segment_graph graph;     ///< with radii; of a meso-skeleton also the sides of its triangles
  std::vector<std::array<std::size_t, 3>> triangles;  ///< sheets of a meso-skeleton
  std::size_t cycles = 0, components = 0, tips = 0;
  std::size_t iterations = 0;
  double seconds = 0;
};

/// `normals` may be empty.
Skeleton_run laplacian_skeleton(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                                const Skeleton_options& options = {});

/// `segments`: numbers of the points' segments, each with a skeleton of its own; empty: one skeleton.
Skeleton_run l1_medial_skeleton(const std::vector<Vec3>& points,
                                const std::vector<std::size_t>& segments = {});

/// Skeletons of the deep points; the scan has directions towards the scanner and views.
struct Meso_runs {
  Skeleton_run sheets;  ///< meso-skeleton: curves and sheets; tips are those of curves
  Skeleton_run curves;  ///< contracted to curves, tips extended
};
Meso_runs meso_skeletons(const support::Point_cloud& scan);

/// Edits as in the file that the programs apply; counts are those after it.
/// \throws std::invalid_argument if an edit is wrong
Skeleton_run edited(const Skeleton_run& run, const std::string& edits);

struct Field_options {
  std::size_t resolution = 64;
  bool adaptive = true;
  double surface_weight = 50, outside_weight = 0.005, outside_factor = 4;
};

Triangle_mesh skeleton_driven_mesh(const std::vector<Vec3>& points, const support::Segment_graph& skeleton,
                                   const Field_options& options = {});

/// Evenly spread points of a mesh.
std::vector<Vec3> even_samples(const Triangle_mesh& mesh, std::size_t count);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_SKELETON_RUNS_H
