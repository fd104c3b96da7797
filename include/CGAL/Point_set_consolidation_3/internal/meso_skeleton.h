// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_SKELETON_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_SKELETON_H

#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points paper, section 4.2: inner points are drawn to the L1 median of the anchors in an
/// anisotropic neighbourhood and repelled along it, so that they form curves and sheets.
/// Lengths in units of the spacing r of S.

/// Neighbourhood of an inner point: axes as columns, semi-axes in units of r.
struct Ellipsoid {
  Mat3 axes = Mat3::Identity();
  Vec3 semi_axes = Vec3::Ones();
};

struct Meso_skeleton {
  Points points;                       ///< Q
  std::vector<Ellipsoid> ellipsoids;
};

class Meso_skeleton_formation {
  static constexpr double support = 1.5;          ///< of vartheta, in the ellipsoid's metric
  static constexpr double least_distance = 0.5;   ///< in the L1 median
  static constexpr double least_metric = 0.05;    ///< in the repulsion
  static constexpr std::size_t least_neighbors = 8;

public:
  Meso_skeleton_formation(Execution& execution, const Points& anchors, const Points& normals,
                          const Meso_skeleton_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_normals(normals)
    , m_anchor_grid(anchors, parameters.collision_radius)
  {
    m_result.points = anchors;
    m_result.ellipsoids.resize(anchors.size());
  }

  Meso_skeleton run(Stage& stage)
  {
    for(std::size_t t = 0; t < m_parameters.iterations; ++t) {
      const Sorted_grid grid(m_result.points, m_parameters.collision_radius);
      Points next(m_result.points.size());
      parallel_for_places(m_execution, grid, [&](std::size_t i) {
        m_result.ellipsoids[i] = neighborhood(grid, i);
        next[i] = moved(grid, i);
      });
      m_result.points.swap(next);
      stage.count_iteration();
      stage.update(double(t + 1) / double(m_parameters.iterations));
    }
    return std::move(m_result);
  }

private:
  /// Axes by principal component analysis; a semi-axis is long where the surface normals of the
  /// neighbours are perpendicular to it.
  Ellipsoid neighborhood(const Sorted_grid& grid, std::size_t i) const
  {
    const Vec3& q = m_result.points[i];
    std::vector<std::pair<double, Index> > found;
    double radius = m_parameters.collision_radius;
    const double furthest = 16 * radius;
    const auto collect = [&](Index j, double d2) {
      found.emplace_back(d2, j);
      return true;
    };
    grid.for_each_neighbor(q, radius, collect);
    while(found.size() < least_neighbors && radius < furthest) {
      radius *= 2;
      found.clear();
      grid.for_each_neighbor(q, radius, collect);
    }
    if(radius > m_parameters.collision_radius && found.size() > least_neighbors) {
      std::nth_element(found.begin(), found.begin() + least_neighbors, found.end());
      found.resize(least_neighbors);
    }

    Covariance_sum sum;
    for(const auto& f : found)
      sum.add(m_result.points[f.second] - q);
    Ellipsoid ellipsoid;
    ellipsoid.axes = sum.axes().eigenvectors();
    Vec3 projection = Vec3::Zero();
    for(const auto& f : found)
      projection += (ellipsoid.axes.transpose() * m_normals[f.second]).cwiseAbs();
    projection /= double(found.size());
    const double longest = 1 / m_parameters.epsilon;
    for(int m = 0; m < 3; ++m)
      ellipsoid.semi_axes[m] = (std::min)(longest, 1 / (projection[m] + m_parameters.epsilon));
    return ellipsoid;
  }

  /// One step of the fixed point iteration of equations (4) and (5).
  Vec3 moved(const Sorted_grid& grid, std::size_t i) const
  {
    const Vec3& q = m_result.points[i];
    const Ellipsoid& e = m_result.ellipsoids[i];
    const Mat3 A = e.semi_axes.cwiseInverse().asDiagonal() * e.axes.transpose();
    Vec3 half_extents;
    for(int axis = 0; axis < 3; ++axis)
      half_extents[axis] = support * e.axes.row(axis).transpose().cwiseProduct(e.semi_axes).norm();

    Weighted_sum median, repulsion;
    m_anchor_grid.for_each_ellipsoid_block(q, A, support, half_extents,
                                           [&](const Neighbor_block& block) {
      Block_weights weights;
      weights.set_gaussian(1, block) /=
        (block.x().square() + block.y().square() + block.z().square())
          .max(least_distance * least_distance).sqrt();
      median.add(block, weights, i);
    });
    grid.for_each_ellipsoid_block(q, A, support, half_extents, [&](const Neighbor_block& block) {
      Block_weights weights;
      const auto clamped = block.squared_distance().max(least_metric * least_metric);
      weights.set_gaussian(1, block) /= clamped.square() * clamped.sqrt();
      repulsion.add(block, weights, i);
    });

    // The printed weights |l|^2 / l_m^2 push across the curve and explode: the longest axis has weight 1.
    const Vec3 along = e.semi_axes.cwiseQuotient(Vec3::Constant(e.semi_axes.maxCoeff())).cwiseAbs2();
    const Vec3 push =
      e.axes * along.asDiagonal() * e.axes.transpose() * (-repulsion.mean_offset());
    return q + median.mean_offset() + m_parameters.repulsion * push;
  }

  struct Weighted_sum {
    Vec3 offsets = Vec3::Zero();
    double weight = 0;

    void add(const Neighbor_block& block, Block_weights& weights, std::size_t excluded)
    {
      for(int k = 0; k < block.size; ++k)
        if(block.index[k] == excluded)
          weights[k] = 0;
      const auto w = weights.column(block.size);
      weight += w.sum();
      offsets += block.weighted_offset(w);
    }
    Vec3 mean_offset() const { return weight > 0 ? Vec3(offsets / weight) : Vec3(Vec3::Zero()); }
  };

  Execution& m_execution;
  Meso_skeleton_parameters m_parameters;
  const Points& m_normals;
  Sorted_grid m_anchor_grid;
  Meso_skeleton m_result;
};

inline Meso_skeleton form_meso_skeleton(Execution& execution, Stage& stage, const Points& anchors,
                                        const Points& normals,
                                        const Meso_skeleton_parameters& parameters)
{
  return Meso_skeleton_formation(execution, anchors, normals, parameters).run(stage);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_SKELETON_H
