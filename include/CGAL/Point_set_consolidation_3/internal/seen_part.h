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
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>

#include <limits>

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
    if(seen.is_noisy)
      project(execution, points, tree, denoising_neighbors, seen.points, seen.normals);
    return seen;
  }

  /// Moves `queries` onto quadrics of so many of their neighbours among the points.
  static void project(const Execution& execution, const Points& points, const Nearest_neighbors& tree,
                      std::size_t neighbors, Points& queries, Points& normals)
  {
    normals.resize(queries.size());
    parallel_for_places(execution, queries, [&](std::size_t i) {
      std::vector<Neighbor> nearest;
      tree.find(queries[i], neighbors, nearest);
      const Quadric_fit fit = fit_quadric(points, queries[i], nearest);
      queries[i] = fit.projection;
      normals[i] = fit.normal;
    });
  }

  /// Number of neighbours that tell normals in the noise of the points: neighbourhoods within its layer are round, and
  /// the larger the rounder; larger ones become flat again. Twice those of the roundest.
  static std::size_t resolving_neighbors(const Execution& execution, const Points& points,
                                         const Nearest_neighbors& tree)
  {
    constexpr std::size_t most_samples = 1000, fewest = 15, most = 120;  // 2 % of noise needs 120 to 240
    const std::vector<std::size_t> samples =
      random_subset(points.size(), (std::min)(points.size(), most_samples), 0);
    std::size_t roundest = fewest;
    double least = (std::numeric_limits<double>::max)();
    for(std::size_t k = fewest; k <= most && 2 * k <= points.size(); k *= 2) {
      std::vector<double> extent(samples.size()), residual(samples.size());
      parallel_for(execution, samples.size(), [&](std::size_t s) {
        const Vec3& x = points[samples[s]];
        std::vector<Neighbor> nearest;
        tree.find(x, k, nearest);
        extent[s] = std::sqrt(nearest.back().squared_distance);
        residual[s] = fit_quadric(points, x, nearest).residual;
      });
      const double flatness = median(std::move(extent)) / median(std::move(residual));
      if(flatness < least) {
        least = flatness;
        roundest = k;
      }
    }
    return 2 * roundest;
  }
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SEEN_PART_H
