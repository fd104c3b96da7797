// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H

#include <CGAL/Point_set_consolidation_3/internal/bilateral_weights.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points paper, section 4.3: outer points start on S, spread into the missing regions and take
/// their distance from the meso-skeleton there from their neighbours' deep points.
/// Lengths in units of the spacing r of S.

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
  static constexpr double cooled_repulsion = 0.05;      ///< share; without cooling the set creeps for ever
  static constexpr double cooling_share = 1. / 3;       ///< of the iterations
  /// The fronts stand when the share of completed points has grown by less in so many iterations.
  static constexpr std::size_t standing_iterations = 10;
  static constexpr double standing_growth = 0.0005;
  /// Points amid the data hover about their places and matter little to the fronts: they move in every
  /// third iteration only, which gives surfaces as good in 0.6 of the time.
  static constexpr std::size_t resting_period = 3;
  static constexpr double full_density = 0.4;           ///< share of the median eta
  static constexpr double longest_step = 1;
  static constexpr double silhouette_tolerance = 1.5;
  static constexpr std::size_t normal_neighbors = 16;
  static constexpr double data_cell = 1.5, cell = 2.5;  ///< half the usual radii of queries

public:
  /// `frozen`: points that stay where they are (empty: none). `priors`: one per point (empty: as in the
  /// parameters).
  Surface_consolidation(Execution& execution, const Points& data, const Points& points,
                        const Points& normals, const Points& skeleton,
                        const Surface_parameters& parameters, const Free_space& free_space,
                        const std::vector<char>& frozen, const std::vector<Prior>& priors)
    : m_execution(execution), m_parameters(parameters), m_skeleton(skeleton)
    , m_free_space(free_space), m_frozen(frozen), m_priors(priors)
    , m_data_grid(data, data_cell), m_skeleton_tree(skeleton)
  {
    m_result.points = points;
    m_result.normals = normals;
    m_result.inner.assign(points.size(), 0);
    m_result.data_density.assign(points.size(), 1.);
    m_length.assign(points.size(), 0.);
    m_length_variance.assign(points.size(), 0.);
    m_is_amid_data.assign(points.size(), 0);
  }

  Consolidated_surface run(Stage& stage)
  {
    const std::size_t n = m_result.points.size();
    const std::size_t cooling = std::size_t(cooling_share * double(m_parameters.iterations));
    std::size_t last = m_parameters.iterations;
    std::vector<std::size_t> completed;
    find_partners();
    for(std::size_t t = 0; t < last; ++t) {
      const Sorted_grid grid(m_result.points, cell);
      m_all_move = t % resting_period == 0;
      survey(grid, t > 0);
      const double repulsion = repulsion_at(t, last, cooling);
      Points next = m_result.points;
      parallel_for_places(m_execution, grid, [&](std::size_t i) {
        if(moves(i))
          next[i] = moved(grid, i, repulsion);
      });
      m_result.points.swap(next);
      for(std::size_t i = 0; i < n; ++i)
        m_length[i] = (m_result.points[i] - partner(i)).norm();
      completed.push_back(number_of_completed_points());
      if(t + 1 + cooling < last && fronts_stand(completed, n))
        last = t + 1 + cooling;
      stage.count_iteration();
      stage.update(0.9 * double(t + 1) / double(last));
    }
    find_partners();
    return std::move(m_result);
  }

private:
  bool is_frozen(std::size_t i) const { return !m_frozen.empty() && m_frozen[i]; }
  Prior prior(std::size_t i) const { return m_priors.empty() ? m_parameters.prior : m_priors[i]; }
  const Vec3& partner(std::size_t i) const { return m_skeleton[m_result.inner[i]]; }
  bool moves(std::size_t i) const { return m_all_move || !m_is_amid_data[i]; }

  /// Constant while the fronts spread, then linear to the cooled one.
  double repulsion_at(std::size_t t, std::size_t last, std::size_t cooling) const
  {
    const double s = t + cooling < last ? 0 : double(t + cooling - last) / double(cooling);
    return m_parameters.repulsion * (1 - s * (1 - cooled_repulsion));
  }

  std::size_t number_of_completed_points() const
  {
    return std::size_t(std::count_if(m_result.data_density.begin(), m_result.data_density.end(),
                                     [](double eta) { return eta < completed_density; }));
  }
  static bool fronts_stand(const std::vector<std::size_t>& completed, std::size_t n)
  {
    const std::size_t t = completed.size();
    return t > standing_iterations &&
           double(completed[t - 1]) <
             double(completed[t - 1 - standing_iterations]) + standing_growth * double(n);
  }

  /// A point's partner is the nearest skeletal point: fixed pairs turn oblique as points slide.
  void find_partners()
  {
    parallel_for(m_execution, m_result.points.size(), [&](std::size_t i) {
      const Neighbor q = m_skeleton_tree.nearest(m_result.points[i]);
      m_result.inner[i] = q.index;
      m_length[i] = std::sqrt(q.squared_distance);
    });
  }

  Vec3 deep_direction(std::size_t i) const
  {
    return normalized_or(m_result.points[i] - partner(i), m_result.normals[i]);
  }

  /// Normals, how much lengths vary over the neighbours on the same side, and whether these all have data.
  void survey(const Sorted_grid& grid, bool updates_normals)
  {
    const double dense =
      (std::max)(completed_density, full_density * median(m_result.data_density));
    Points next = m_result.normals;
    parallel_for_places(m_execution, grid, [&](std::size_t i) {
      if(!moves(i))
        return;
      const Vec3& p = m_result.points[i];
      const Vec3& n = m_result.normals[i];
      double mean = 0, squares = 0, least_density = m_result.data_density[i];
      std::size_t count = 0;
      std::vector<std::pair<double, Index> > near, far;
      near.reserve(64);
      grid.for_each_neighbor(p, m_parameters.smoothing_radius, [&](Index j, double d2) {
        if(m_result.normals[j].dot(n) >= 0) {
          mean += m_length[j];
          squares += m_length[j] * m_length[j];
          ++count;
          least_density = (std::min)(least_density, m_result.data_density[j]);
          (d2 <= theta_support * theta_support ? near : far).emplace_back(d2, j);
        }
        return true;
      });
      mean /= double(count);  // the point itself is one of them
      m_length_variance[i] = (std::max)(0., squares / double(count) - mean * mean);
      m_is_amid_data[i] = least_density > dense;
      if(!updates_normals || is_frozen(i))
        return;
      if(near.size() < normal_neighbors)
        near.insert(near.end(), far.begin(), far.end());
      next[i] = normal(i, near);
    });
    m_result.normals.swap(next);
  }

  Vec3 normal(std::size_t i, std::vector<std::pair<double, Index> >& neighbors) const
  {
    const Vec3& n = m_result.normals[i];
    Vec3 plane_normal = n;
    if(neighbors.size() > normal_neighbors) {
      std::nth_element(neighbors.begin(), neighbors.begin() + std::ptrdiff_t(normal_neighbors),
                       neighbors.end());
      neighbors.resize(normal_neighbors);
    }
    if(neighbors.size() >= 4) {
      Covariance_sum sum;
      for(const auto& neighbor : neighbors)
        sum.add(m_result.points[neighbor.second] - m_result.points[i]);
      plane_normal = sum.normal();
      if(plane_normal.dot(n) < 0)
        plane_normal = -plane_normal;
    }
    return normalized_or((m_result.data_density[i] - 1) * plane_normal + deep_direction(i), n);
  }

  /// Sums of a point over the data: eta - 1, and those of the L1 median.
  struct Data_sums {
    double density = 0, attraction = 0;
    Vec3 offsets = Vec3::Zero();
  };
  Data_sums data_sums(const Vec3& p) const
  {
    Data_sums sums;
    m_data_grid.for_each_neighbor_block(p, theta_support, [&](const Neighbor_block& block) {
      Block_weights weights;
      auto w = weights.set_gaussian(1, block);
      sums.density += w.sum();
      w /= block.squared_distance().max(least_distance * least_distance).sqrt();
      sums.attraction += w.sum();
      sums.offsets += block.weighted_offset(w);
    });
    return sums;
  }

  /// Sums of a point over the neighbours on the same side: lengths for the prior, repulsion in the
  /// tangent plane.
  struct Neighbor_sums {
    double length = 0, length_weight = 0, push_weight = 0;
    Vec3 push = Vec3::Zero();
  };
  Neighbor_sums neighbor_sums(const Sorted_grid& grid, std::size_t i) const
  {
    const Vec3& n = m_result.normals[i];
    const double radius = (std::min)(m_parameters.smoothing_radius, theta_support);
    Neighbor_sums sums;
    grid.for_each_neighbor_block(m_result.points[i], radius, [&](const Neighbor_block& block) {
      Block_weights weights, lengths;
      int itself = -1;
      auto w = weights.set_gaussian(1, block);
      for(int k = 0; k < block.size; ++k) {
        const std::size_t j = block.index[k];
        if(m_result.normals[j].dot(n) < 0)
          weights[k] = 0;
        lengths[k] = m_length[j];
        if(j == i)
          itself = k;
      }
      const auto d2 = block.squared_distance();
      sums.length += (w * lengths.column(block.size)).sum();
      sums.length_weight += w.sum();
      if(itself >= 0)
        weights[itself] = 0;
      auto tangential = lengths.column(block.size);  // squared
      tangential = (d2 - (n.x() * block.x() + n.y() * block.y() + n.z() * block.z()).square())
                     .max(least_repulsion_distance * least_repulsion_distance);
      w /= tangential.square() * tangential.sqrt();
      sums.push_weight += w.sum();
      sums.push -= block.weighted_offset(w);
    });
    sums.push -= n.dot(sums.push) * n;
    return sums;
  }

  /// One step of the fixed point iteration of equations (6) to (9).
  Vec3 moved(const Sorted_grid& grid, std::size_t i, double repulsion)
  {
    const Vec3& p = m_result.points[i];
    const Vec3& n = m_result.normals[i];
    const Data_sums data = data_sums(p);
    const double eta = 1 + data.density;
    m_result.data_density[i] = eta;
    if(is_frozen(i))
      return p;
    const double A = eta * data.attraction;
    Vec3 to_median = data.attraction > 0 ? Vec3(data.offsets / data.attraction) : Vec3(Vec3::Zero());
    if(m_parameters.data_term == Data_term::NORMAL)
      to_median = n.dot(to_median) * n;

    const Neighbor_sums others = neighbor_sums(grid, i);
    const double length =
      others.length_weight > 0 ? others.length / others.length_weight : m_length[i];
    const double gamma = 1 / (1 + m_length_variance[i]);

    // the gradient of (9) has no fixed point but zero length; used as decay per iteration
    const double target =
      prior(i) == Prior::MINIMAL_VOLUME ? (1 - m_parameters.shrinkage) * length : length;
    const Vec3 q = partner(i);
    const Vec3 x = (A * (p + to_median) + gamma * (q + target * deep_direction(i))) / (A + gamma);
    Vec3 y = x;
    if(others.push_weight > 0)
      y += repulsion * others.push / others.push_weight;

    // tangential steps lengthen dpoints: put back the length reached at x
    m_result.inner[i] = m_skeleton_tree.nearest(y).index;
    const double new_length = (y - partner(i)).norm();
    if(new_length > tiny_length)
      y += gamma / (A + gamma) *
           (partner(i) + (x - q).norm() / new_length * (y - partner(i)) - y);
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
  std::vector<double> m_length;           ///< of the deep points
  std::vector<double> m_length_variance;  ///< among neighbours on the same side
  std::vector<char> m_is_amid_data;       ///< these all have data
  bool m_all_move = true;                 ///< in this iteration
  Consolidated_surface m_result;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
