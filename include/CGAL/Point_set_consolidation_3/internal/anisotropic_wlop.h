// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ANISOTROPIC_WLOP_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ANISOTROPIC_WLOP_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_projection.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {

namespace internal {

/// Feature-enhanced surfaces paper, section III.A: a locally optimal projection whose weights know normals.
/// In: data P with unit normals, the points Q to project and their normals (only `SEPARATED` uses
/// them). Out: Q, projected; with `SEPARATED` on the surface of its own cluster, up to the edges.

class Anisotropic_wlop {
  static constexpr double cutoff = 0.75;               ///< of h: theta is 1e-4 there
  static constexpr double least_distance = 1e-3;       ///< of h, in alpha and beta
  // of the separated form; the unit of length is the spacing of the data
  static constexpr std::size_t edge_neighbors = 30;
  static constexpr double surface_reach = 3;           ///< data that make a point's surface
  static constexpr double longest_push = 0.5;          ///< per iteration, of the longer of spacing and h / 8
  static constexpr double furthest_from_data = 1.25;   ///< a point does not leave the data

public:
  Anisotropic_wlop(Execution& execution, const Points& data, const Points& data_normals,
                   const Anisotropic_wlop_parameters& parameters)
    : m_execution(execution), m_data(data), m_data_normals(data_normals), m_parameters(parameters)
    , m_reach(cutoff * parameters.support_radius), m_data_grid(data, m_reach)
    , m_phi(parameters.sharpness_angle, parameters.oriented)
    , m_theta_factor(16 / (parameters.support_radius * parameters.support_radius))
    , m_least(least_distance * parameters.support_radius)
  {}

  void run(Stage& stage, Points& points, Points& normals)
  {
    const bool separated = m_parameters.formula == Anisotropic_formula::SEPARATED;
    weigh_data();
    stage.update(0.1);
    if(!separated)
      project_first(points);
    std::optional<Edge_finder> edges;
    if(separated)
      edges.emplace(m_data, m_data_normals, edge_neighbors, m_parameters.oriented);
    for(std::size_t t = 0; t < m_parameters.iterations; ++t) {
      const Sorted_grid grid(points, m_reach);
      const std::vector<double> weights = sample_weights(grid, points);
      Points next(points.size()), next_normals = normals;
      parallel_for_places(m_execution, grid, [&](std::size_t i) {
        const Vec3 push = m_parameters.repulsion * repulsion(grid, points, normals, weights, i);
        next[i] = separated ? moved_on_surface(*edges, points[i], push, next_normals[i])
                            : Vec3(points[i] + attraction(points[i]) + push);
      });
      points.swap(next);
      normals.swap(next_normals);
      stage.count_iteration();
      stage.update(0.1 + 0.9 * double(t + 1) / double(m_parameters.iterations));
    }
    if(separated)
      parallel_for(m_execution, points.size(), [&](std::size_t i) {
        points[i] = edges->returned_to_edge(points[i], normals[i], m_parameters.edge_attraction);
      });
  }

private:
  /// Tangent plane weight of equation (4); the normal is that of p_j, equation (4) prints n_i.
  double plane_weight(const Vec3& n, const Vec3& offset) const
  {
    const double t = n.dot(offset) / m_parameters.plane_width;
    return std::exp(-t * t);
  }

  /// Visits (index, offset, theta) of the data that the formula sums over.
  template <typename Visitor>
  void for_each_datum(const Vec3& q, const Visitor& visit) const
  {
    if(m_parameters.formula == Anisotropic_formula::PRINTED) {
      for(std::size_t j = 0; j < m_data.size(); ++j)
        visit(j, Vec3(m_data[j] - q), 1.);
      return;
    }
    m_data_grid.for_each_neighbor_block(q, m_reach, [&](const Neighbor_block& block) {
      Block_weights weights;
      weights.set_gaussian(m_theta_factor, block);
      for(int k = 0; k < block.size; ++k)
        visit(std::size_t(block.index[k]), block.offset(k), weights[k]);
    });
  }

  /// theta / r, with r at no less than its least.
  void theta_by_distance(const Neighbor_block& block, Block_weights& weights) const
  {
    weights.set_gaussian(m_theta_factor, block) /= block.squared_distance().max(m_least * m_least).sqrt();
  }

  /// rho of equation (2).
  void weigh_data()
  {
    m_density.assign(m_data.size(), 1.);
    parallel_for_places(m_execution, m_data_grid, [&](std::size_t j) {
      double sum = 1;
      for_each_datum(m_data[j], [&](std::size_t k, const Vec3& offset, double t) {
        if(k != j)
          sum += t * plane_weight(m_data_normals[j], offset);
      });
      m_density[j] = sum;
    });
  }

  /// Equation (1).
  void project_first(Points& points) const
  {
    parallel_for_places(m_execution, points, [&](std::size_t i) {
      Vec3 offsets = Vec3::Zero();
      double weight = 0;
      for_each_datum(points[i], [&](std::size_t j, const Vec3& offset, double t) {
        const double w = t * plane_weight(m_data_normals[j], offset);
        offsets += w * offset;
        weight += w;
      });
      if(weight > tiny_length)
        points[i] += offsets / weight;
    });
  }

  /// w of equation (2).
  std::vector<double> sample_weights(const Sorted_grid& grid, const Points& points) const
  {
    std::vector<double> weights(points.size());
    parallel_for_places(m_execution, grid, [&](std::size_t i) {
      double sum = 0;
      grid.for_each_neighbor_block(points[i], m_reach, [&](const Neighbor_block& block) {
        Block_weights theta;
        sum += theta.set_gaussian(m_theta_factor, block).sum();
      });
      weights[i] = sum;  // the point itself is the 1 of the formula
    });
    return weights;
  }

  /// First sum of equation (3), as a step.
  Vec3 attraction(const Vec3& q) const
  {
    Vec3 offsets = Vec3::Zero();
    double weight = 0;
    m_data_grid.for_each_neighbor_block(q, m_reach, [&](const Neighbor_block& block) {
      Block_weights weights;
      theta_by_distance(block, weights);
      for(int k = 0; k < block.size; ++k) {
        const double w = weights[k] / m_density[block.index[k]];
        offsets += w * block.offset(k);
        weight += w;
      }
    });
    return weight > 0 ? Vec3(offsets / weight) : Vec3(Vec3::Zero());
  }

  /// First sum of equation (3) over the data of the point's cluster, as a step across their planes. Along
  /// them only the repulsion moves a point: the mean along a face lies off its rim.
  Vec3 surface_step(const Vec3& q, Vec3& n) const
  {
    Local_surface surface;
    constexpr double falloff = 2 / (surface_reach * surface_reach);
    m_data_grid.for_each_neighbor_block(q, surface_reach, [&](const Neighbor_block& block) {
      Block_weights weights;
      weights.set_gaussian(falloff, block);
      for(int k = 0; k < block.size; ++k) {
        const Index j = block.index[k];
        add_to_surface(surface, n, block.offset(k), m_data_normals[j],
                       m_phi(n, m_data_normals[j]) * weights[k] / m_density[j]);
      }
    });
    if(!(surface.weight > tiny_length))
      return Vec3::Zero();
    n = normalized_or(surface.normal, n);
    return surface.step / surface.weight;
  }

  /// A step of the separated form. A point stays where it is rather than to leave the data.
  Vec3 moved_on_surface(const Edge_finder& edges, const Vec3& q, const Vec3& push, Vec3& n) const
  {
    const double limit = longest_push * (std::max)(1., m_parameters.support_radius / 8);
    const double length = push.norm();
    Vec3 moved = q + (length > limit ? Vec3(limit / length * push) : push);
    Vec3 normal = n;
    moved += surface_step(moved, normal);
    moved = edges.returned_to_edge(moved, normal, 0);
    if(edges.distance_from_points(moved) > furthest_from_data)
      moved = q + surface_step(q, normal = n);
    n = normal;
    return moved;
  }

  /// Second sum of equation (3). The vector is q_i - q_i'; the sign of eta' cancels in the normalised sum.
  Vec3 repulsion(const Sorted_grid& grid, const Points& points, const Points& normals,
                 const std::vector<double>& weights, std::size_t i) const
  {
    const bool separated = m_parameters.formula == Anisotropic_formula::SEPARATED;
    Vec3 push = Vec3::Zero();
    double weight = 0;
    grid.for_each_neighbor_block(points[i], m_reach, [&](const Neighbor_block& block) {
      Block_weights theta;
      theta_by_distance(block, theta);
      for(int k = 0; k < block.size; ++k) {
        const Index other = block.index[k];
        if(other == i)
          continue;
        double w = weights[other] * theta[k];
        if(separated)
          w *= m_phi(normals[i], normals[other]);
        push -= w * block.offset(k);
        weight += w;
      }
    });
    if(!(weight > tiny_length))
      return Vec3::Zero();
    push /= weight;
    return separated ? Vec3(push - push.dot(normals[i]) * normals[i]) : push;
  }

  Execution& m_execution;
  const Points& m_data;
  const Points& m_data_normals;
  Anisotropic_wlop_parameters m_parameters;
  double m_reach;
  Sorted_grid m_data_grid;
  Normal_similarity m_phi;
  double m_theta_factor, m_least;
  std::vector<double> m_density;  ///< rho
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ANISOTROPIC_WLOP_H
