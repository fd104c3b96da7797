// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H

#include <CGAL/Point_set_consolidation_3/internal/bilateral_weights.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points paper, section 4.3: outer points start on S, spread into the missing regions and take
/// their distance from the meso-skeleton there from their neighbours' deep points.
/// Lengths in units of the spacing r of S.

struct Surface_parameters {
  double smoothing_radius = 5;   ///< sigma_p
  double repulsion = 0.4;        ///< mu hat
  Data_term data_term = Data_term::FULL;
  Prior prior = Prior::VOLUME_PRESERVING;
  double shrinkage = 0.1;        ///< of the minimal volume prior, per iteration
  std::size_t iterations = 90;   ///< until the fronts of half a tube of 60 r around have met
  double completed_spacing = 1;  ///< to which completed regions are filled; 0: not at all
};

struct Consolidated_surface {
  Points points;                       ///< P
  Points normals;
  std::vector<Index> inner;            ///< skeletal point of each outer point
  std::vector<double> data_density;    ///< eta(p): 1 = no data near
};

/// Below this eta a point is completed rather than measured.
constexpr double completed_density = 1.5;

class Surface_consolidation {
  static constexpr double least_distance = 0.01;        ///< to data, in the L1 median
  static constexpr double least_repulsion_distance = 0.1;
  static constexpr double cooled_repulsion = 0.02;      ///< else the set creeps for ever
  static constexpr double cooling_share = 1. / 3;       ///< of the iterations
  static constexpr double longest_step = 1;
  static constexpr double silhouette_tolerance = 1.5;
  static constexpr std::size_t normal_neighbors = 16;

public:
  /// `frozen`: points that stay where they are (empty: none). `priors`: one per point (empty: as in the
  /// parameters).
  Surface_consolidation(Execution& execution, const Points& data, const Points& points,
                        const Points& normals, const Points& skeleton,
                        const Surface_parameters& parameters, const Free_space& free_space,
                        const std::vector<char>& frozen, const std::vector<Prior>& priors)
    : m_execution(execution), m_parameters(parameters), m_skeleton(skeleton)
    , m_free_space(free_space), m_frozen(frozen), m_priors(priors)
    , m_data_grid(data, theta_support), m_skeleton_tree(skeleton)
  {
    m_result.points = points;
    m_result.normals = normals;
    m_result.inner.assign(points.size(), 0);
    m_result.data_density.assign(points.size(), 1.);
    m_length.assign(points.size(), 0.);
  }

  Consolidated_surface run(Stage& stage)
  {
    const std::size_t n = m_result.points.size();
    update_partners();
    for(std::size_t t = 0; t < m_parameters.iterations; ++t) {
      const Sorted_grid grid(m_result.points, m_parameters.smoothing_radius);
      if(t > 0)
        update_normals(grid);
      const double repulsion = repulsion_at(t);
      Points next(n);
      parallel_for(m_execution, n, [&](std::size_t i) { next[i] = moved(grid, i, repulsion); });
      m_result.points.swap(next);
      update_partners();
      stage.count_iteration();
      stage.update(0.9 * double(t + 1) / double(m_parameters.iterations));
    }
    return std::move(m_result);
  }

private:
  bool is_frozen(std::size_t i) const { return !m_frozen.empty() && m_frozen[i]; }
  Prior prior(std::size_t i) const { return m_priors.empty() ? m_parameters.prior : m_priors[i]; }

  double repulsion_at(std::size_t t) const
  {
    const double start = (1 - cooling_share) * double(m_parameters.iterations);
    const double span = (std::max)(1., double(m_parameters.iterations) - start);
    const double s = (std::min)(1., (std::max)(0., (double(t) - start) / span));
    return m_parameters.repulsion + s * (cooled_repulsion * m_parameters.repulsion / 0.4 -
                                         m_parameters.repulsion);
  }

  /// A point's partner is the nearest skeletal point: fixed pairs turn oblique as points slide.
  void update_partners()
  {
    parallel_for(m_execution, m_result.points.size(), [&](std::size_t i) {
      const Neighbor q = m_skeleton_tree.nearest(m_result.points[i]);
      m_result.inner[i] = q.index;
      m_length[i] = std::sqrt(q.squared_distance);
    });
  }

  Vec3 deep_direction(std::size_t i) const
  {
    return normalized_or(m_result.points[i] - m_skeleton[m_result.inner[i]], m_result.normals[i]);
  }

  void update_normals(const Sorted_grid& grid)
  {
    Points next(m_result.points.size());
    parallel_for(m_execution, next.size(), [&](std::size_t i) {
      next[i] = is_frozen(i) ? m_result.normals[i] : normal(grid, i);
    });
    m_result.normals.swap(next);
  }

  Vec3 normal(const Sorted_grid& grid, std::size_t i) const
  {
    const Vec3& n = m_result.normals[i];
    Vec3 plane_normal = n;
    std::vector<std::pair<double, Index> > found;
    grid.for_each_neighbor(m_result.points[i], m_parameters.smoothing_radius,
                           [&](Index j, double d2) {
                             if(m_result.normals[j].dot(n) > 0)
                               found.emplace_back(d2, j);
                             return true;
                           });
    keep_nearest(found, normal_neighbors);
    if(found.size() >= 4) {
      Covariance_sum sum;
      for(const auto& f : found)
        sum.add(m_result.points[f.second] - m_result.points[i]);
      plane_normal = sum.normal();
      if(plane_normal.dot(n) < 0)
        plane_normal = -plane_normal;
    }
    return normalized_or((m_result.data_density[i] - 1) * plane_normal + deep_direction(i), n);
  }

  static void keep_nearest(std::vector<std::pair<double, Index> >& found, std::size_t k)
  {
    if(found.size() > k) {
      std::nth_element(found.begin(), found.begin() + std::ptrdiff_t(k), found.end());
      found.resize(k);
    }
    std::sort(found.begin(), found.end());
  }

  /// One step of the fixed point iteration of equations (6) to (9).
  Vec3 moved(const Sorted_grid& grid, std::size_t i, double repulsion)
  {
    const Vec3& p = m_result.points[i];
    const Vec3& n = m_result.normals[i];

    // data term
    double density = 0, attraction = 0;
    Vec3 offsets = Vec3::Zero();
    m_data_grid.for_each_neighbor_block(p, theta_support, [&](const Neighbor_block& block) {
      Block_weights weights;
      auto w = weights.column(block.size);
      const auto d2 = block.squared_distance();
      w = (-d2).exp();
      density += w.sum();
      w /= d2.max(least_distance * least_distance).sqrt();
      attraction += w.sum();
      offsets += Vec3((w * block.x()).sum(), (w * block.y()).sum(), (w * block.z()).sum());
    });
    const double eta = 1 + density;
    m_result.data_density[i] = eta;
    if(is_frozen(i))
      return p;
    const double A = eta * attraction;
    Vec3 to_median = attraction > 0 ? Vec3(offsets / attraction) : Vec3(Vec3::Zero());
    if(m_parameters.data_term == Data_term::NORMAL)
      to_median = n.dot(to_median) * n;

    // neighbours on the same side: lengths for the prior, repulsion in the tangent plane
    double length_sum = 0, length_weight = 0, mean_length = 0, squares = 0, push_weight = 0;
    std::size_t count = 0;
    Vec3 push = Vec3::Zero();
    grid.for_each_neighbor_block(p, m_parameters.smoothing_radius, [&](const Neighbor_block& block) {
      for(int k = 0; k < block.size; ++k) {
        const std::size_t j = block.index[k];
        if(m_result.normals[j].dot(n) < 0)
          continue;
        mean_length += m_length[j];
        squares += m_length[j] * m_length[j];
        ++count;
        const double d2 = block.d2[k];
        if(d2 > theta_support * theta_support)
          continue;
        const double theta = Bilateral_weights::theta(d2);
        length_sum += theta * m_length[j];
        length_weight += theta;
        if(j == i)
          continue;
        const Vec3 d = -block.offset(k);
        const Vec3 tangential = d - n.dot(d) * n;
        const double reach = (std::max)(tangential.norm(), least_repulsion_distance);
        const double b = theta / (reach * reach * reach * reach * reach);
        push += b * tangential;
        push_weight += b;
      }
    });
    const double length = length_weight > 0 ? length_sum / length_weight : m_length[i];
    double variance = 0;
    if(count > 0) {
      mean_length /= double(count);
      variance = (std::max)(0., squares / double(count) - mean_length * mean_length);
    }
    const double gamma = 1 / (1 + variance);

    // the gradient of (9) has no fixed point but zero length; used as decay per iteration
    const double target =
      prior(i) == Prior::MINIMAL_VOLUME ? (1 - m_parameters.shrinkage) * length : length;
    const Vec3& q = m_skeleton[m_result.inner[i]];
    const Vec3 x = (A * (p + to_median) + gamma * (q + target * deep_direction(i))) / (A + gamma);
    Vec3 y = x;
    if(push_weight > 0)
      y += repulsion * push / push_weight;

    // tangential steps lengthen dpoints: put back the length reached at x
    const Vec3& partner = m_skeleton[m_skeleton_tree.nearest(y).index];
    const double new_length = (y - partner).norm();
    if(new_length > tiny_length)
      y += gamma / (A + gamma) *
           (partner + (x - q).norm() / new_length * (y - partner) - y);
    if(eta < completed_density && !m_free_space.empty())
      y = m_free_space.pushed_back(y, silhouette_tolerance, longest_step);

    const Vec3 step = y - p;
    const double distance = step.norm();
    return distance > longest_step ? Vec3(p + longest_step / distance * step) : y;
  }

  Execution& m_execution;
  Surface_parameters m_parameters;
  const Points& m_skeleton;
  const Free_space& m_free_space;
  const std::vector<char>& m_frozen;
  const std::vector<Prior>& m_priors;
  Sorted_grid m_data_grid;
  Nearest_neighbors m_skeleton_tree;
  std::vector<double> m_length;   ///< of the deep points
  Consolidated_surface m_result;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
