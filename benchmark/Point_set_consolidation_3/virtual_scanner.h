// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_VIRTUAL_SCANNER_H
#define CONSOLIDATION_BENCHMARK_VIRTUAL_SCANNER_H

#include "types.h"

#include <cstdint>

/// Ground truth, methods under test and judgement.
namespace benchmark {

using support::Point_cloud;
using support::Triangle_mesh;
using support::Vec3;

/// A depth camera that looks at a closed mesh. Lengths are in percent of the mesh's bounding box diagonal.
struct Scanner_options {
  std::size_t views = 1;  ///< number of default directions (ignored if `directions` is given)
  std::vector<Vec3> directions;  ///< from the model towards the scanner, any length
  std::size_t points = 20000;    ///< of all views together; met within one percent or so
  bool perspective = false;      ///< false: parallel rays; true: rays from one point per view
  double distance = 1.5;         ///< perspective: from the box centre to the scanner, in diagonals
  double grazing_cosine = 0.15;  ///< surfaces that are hit at a smaller cosine return nothing
  double noise = 0.0;            ///< standard deviation along the ray, percent of the diagonal
  double outliers = 0.0;         ///< percent of the points that lie anywhere in the (enlarged) box
  double misalignment
      = 0.0;  ///< shift, and largest displacement by a rotation, of views after the first, percent
  std::uint64_t seed = 1;  ///< jitter of the rays, noise, outliers and misalignment
};

/// What the scanner hands out, and the truth beside it.
struct Scan {
  Point_cloud cloud;  ///< points, directions, views; outliers come last
  std::vector<Vec3>
      true_points;  ///< of the first `true_points.size()` points; the rest are outliers
  std::vector<Vec3> true_normals;  ///< of the facets that were hit, outwards
  double diagonal = 0.0;           ///< of the mesh
  double pitch = 0.0;  ///< distance of neighbouring rays (perspective: at the box centre)
};

/// `count` unit directions: three fixed ones, then always the one farthest from all before.
std::vector<Vec3> default_view_directions(std::size_t count);

/// Same seed, same scan. Throws `support::Method_error` if no ray hits the mesh.
Scan scan_mesh(const Triangle_mesh& mesh, const Scanner_options& options);

/// The noise-free samples as a point cloud with normals, directions and views.
Point_cloud truth_cloud(const Scan& scan);

/// Copy with the bounding box centred at the origin and of unit diagonal.
Triangle_mesh normalized(const Triangle_mesh& mesh);

double bounding_box_diagonal(const std::vector<Vec3>& points);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_VIRTUAL_SCANNER_H
