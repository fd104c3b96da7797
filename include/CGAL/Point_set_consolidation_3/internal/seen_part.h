// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEEN_PART_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEEN_PART_H

#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/quadric_fit.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The part of the surface that was scanned, as it is handed to meshing: the caller's points, denoised if
/// noisy, with oriented normals. First step of the completion (completion.h).

struct Seen_part {
  Points points;
  Points normals;
  double spacing = 0;  ///< sp: mean distance to six neighbours, median over the points
  double noise = 0;    ///< sigma: median residual of the fits
  bool is_noisy = false;

  void change_unit(double unit)
  {
    for(Vec3& p : points)
      p /= unit;
    spacing /= unit;
    noise /= unit;
  }
};

class Seen_part_estimation {
  static constexpr std::size_t fit_neighbors = 18;
  static constexpr std::size_t denoising_neighbors = 30;  ///< 60 smooth detail away
  static constexpr double noisy_residual = 0.25;          ///< in sp; clean scans 0-0.06, 0.5 % noise 0.5

public:
  /// Its normals point to any side.
  static Seen_part estimate(const Execution& execution, const Points& points)
  {
    Seen_part seen;
    seen.points = points;
    seen.normals.resize(points.size());
    const Nearest_neighbors tree(execution, points);
    std::vector<double> residual(points.size()), spacing(points.size());
    parallel_for_places(execution, points, [&](std::size_t i) {
      std::vector<Neighbor> neighbors;
      tree.find(points[i], fit_neighbors, neighbors);
      const Quadric_fit fit = fit_quadric(points, points[i], neighbors);
      residual[i] = fit.residual;
      seen.normals[i] = fit.normal;
      const std::size_t six = (std::min)(std::size_t(7), neighbors.size());
      for(std::size_t k = 1; k < six; ++k)
        spacing[i] += std::sqrt(neighbors[k].squared_distance) / double(six - 1);
    });
    seen.noise = median(residual);
    seen.spacing = median(spacing);
    seen.is_noisy = seen.noise > noisy_residual * seen.spacing;
    if(seen.is_noisy) {
      parallel_for_places(execution, points, [&](std::size_t i) {
        std::vector<Neighbor> neighbors;
        tree.find(points[i], denoising_neighbors, neighbors);
        const Quadric_fit fit = fit_quadric(points, points[i], neighbors);
        seen.points[i] = fit.projection;
        seen.normals[i] = fit.normal;
      });
    }
    return seen;
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEEN_PART_H
