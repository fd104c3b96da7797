// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_TYPES_H
#define CONSOLIDATION_SUPPORT_TYPES_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

/// Plain data that the example programs and the benchmark hand to each other.
/// The heavy CGAL code behind readers, mesher and renderer is compiled once, in the support library.
namespace support {

using Vec3 = Eigen::Vector3d;

/// A scan as read from a file. Optional attributes are either empty or as long as `points`.
struct Point_cloud {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;     ///< orientation hints or results
  std::vector<Vec3> directions;  ///< unit vector from the point towards the scanner
  std::vector<int> views;        ///< index of the scanner position a point was seen from
  std::vector<double> confidence;

  std::size_t size() const { return points.size(); }
};

struct Triangle_mesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::size_t, 3>> faces;

  bool empty() const { return faces.empty(); }
};

/// A graph embedded in space (curve skeletons, deep points seen as segments).
struct Segment_graph {
  std::vector<Vec3> vertices;
  std::vector<double> radius;  ///< empty or one per vertex
  std::vector<std::array<std::size_t, 2>> edges;
};

/// Unreadable or unusable file; the message names it. Programs exit with status 2.
struct File_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The method ran but has no usable result. Programs exit with status 3.
struct Method_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_TYPES_H
