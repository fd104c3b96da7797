// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_optimization.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>

#include <optional>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Beyond the 2018 paper, which has no projection that keeps edges: points move to the surface of their own
/// cluster; where two clusters meet, points that went beyond the other's plane return to the edge.
/// In: points and normals that separate clusters. Out: the same, denoised. Signs of normals do not matter.

/// Surface seen from a point, as the mean over neighbours of the same cluster.
struct Local_surface {
  Vec3 step = Vec3::Zero();   ///< from the point to the surface
  Vec3 normal = Vec3::Zero(); ///< mean, not normalised
  double weight = 0;
};

/// Adds the neighbour at `offset` with normal `other` to the surface of a point with normal `n`.
/// The offset is measured along the mean of the two normals: along n alone convex surfaces shrink, along
/// the neighbour's alone they swell; along the mean a sphere stays where it is.
inline void add_to_surface(Local_surface& surface, const Vec3& n, const Vec3& offset,
                           const Vec3& other, double weight)
{
  const Vec3 same_side = n.dot(other) < 0 ? Vec3(-other) : other;
  const Vec3 mean = normalized_or(n + same_side, n);
  surface.step += weight * mean.dot(offset) * mean;
  surface.normal += weight * same_side;
  surface.weight += weight;
}

struct Projection_parameters {
  bool oriented = false;
  double sharpness_angle = 25;  ///< degrees
  std::size_t iterations = 5;
  std::size_t neighbors = 30;
};

/// Moves every point to the surface of its cluster; normals stay.
inline void project_on_clusters(const Execution& execution, Points& points, const Points& normals,
                                const Nearest_table& table, const Projection_parameters& parameters)
{
  const Normal_similarity phi(parameters.sharpness_angle, parameters.oriented);
  const std::size_t width = (std::min)(parameters.neighbors, table.k);
  Points next(points.size());
  for(std::size_t t = 0; t < parameters.iterations && width > 0; ++t) {
    parallel_for(execution, points.size(), [&](std::size_t i) {
      const Index* row = table.row(i);
      const double reach = (points[row[width - 1]] - points[i]).squaredNorm();
      Local_surface surface;
      surface.weight = 1;  // the point itself
      for(std::size_t k = 0; k < width; ++k) {
        const Vec3 offset = points[row[k]] - points[i];
        const double theta = reach > 0 ? std::exp(-2 * offset.squaredNorm() / reach) : 1;
        add_to_surface(surface, normals[i], offset, normals[row[k]],
                       theta * phi(normals[i], normals[row[k]]));
      }
      next[i] = points[i] + surface.step / surface.weight;
    });
    points.swap(next);
  }
}

/// Where clusters of points meet, and on which side of the other's plane each of them lies.
class Edge_finder {
  static constexpr std::size_t least_points = 4;      ///< of a cluster that makes an edge: fewer are stray
  static constexpr int most_edges = 2;                ///< of one point; three planes make a corner
  static constexpr double least_edge_angle = 35;      ///< degrees, between the normals of two clusters
  static constexpr double longest_return = 0.75;      ///< in radii of the neighbourhood

public:
  /// `points` and `normals` (clusters separated) are the surface in which edges are looked for.
  Edge_finder(const Points& points, const Points& normals, std::size_t neighbors, bool oriented)
    : m_points(points), m_normals(normals), m_neighbors(neighbors)
    , m_similarity(least_edge_angle, oriented), m_edge_cosine(std::cos(least_edge_angle * CGAL_PI / 180))
    , m_tree(points)
  {}

  /// The place of a point with normal `n` that had gone across an edge: on the edge. A point nearer to
  /// an edge than `attraction` is put on it as well. Otherwise the point as it is.
  Vec3 returned_to_edge(const Vec3& p, const Vec3& n, double attraction) const
  {
    std::vector<Neighbor> near;
    m_tree.find(p, m_neighbors, near);
    Vec3 result = p;
    if(near.size() < 2 * least_points)
      return result;
    const double radius = std::sqrt(near.back().squared_distance);
    std::vector<Vec3> known(1, n);
    for(int k = 0; k < most_edges; ++k) {
      const std::optional<Vec3> seed = other_cluster(near, known);
      if(!seed)
        break;
      known.push_back(*seed);
      if(const std::optional<Plane> other = plane(near, p, *seed)) {
        const Vec3 step = step_to_edge(near, p, n, *other, attraction);
        if(step.norm() < longest_return * radius)
          result += step;
      }
    }
    return result;
  }

  double distance_from_points(const Vec3& p) const
  {
    return std::sqrt(m_tree.nearest(p).squared_distance);
  }

private:
  struct Plane {
    Vec3 centre, normal;
  };

  /// The normal of the nearest point that belongs to no known cluster.
  std::optional<Vec3> other_cluster(const std::vector<Neighbor>& near,
                                    const std::vector<Vec3>& known) const
  {
    for(const Neighbor& neighbor : near) {
      const Vec3& m = m_normals[neighbor.index];
      bool is_new = true;
      for(const Vec3& k : known)
        is_new = is_new && m_similarity.cosine(m, k) < m_edge_cosine;
      if(is_new)
        return m;
    }
    return std::nullopt;
  }

  /// The plane of the cluster around a normal, as near to `p` as the cluster comes.
  std::optional<Plane> plane(const std::vector<Neighbor>& near, const Vec3& p, const Vec3& seed) const
  {
    Vec3 normal = Vec3::Zero(), centre = Vec3::Zero();
    double weight = 0;
    std::size_t count = 0;
    const double reach = (std::max)(near.back().squared_distance, tiny_length);
    for(const Neighbor& neighbor : near) {
      const Vec3& m = m_normals[neighbor.index];
      if(m_similarity.cosine(m, seed) < m_edge_cosine)
        continue;
      // the nearest points say where a curved surface meets the edge
      const double w = std::exp(-2 * neighbor.squared_distance / reach) * m_similarity(m, seed);
      normal += w * (m.dot(seed) < 0 ? Vec3(-m) : m);
      centre += w * (m_points[neighbor.index] - p);
      weight += w;
      ++count;
    }
    if(count < least_points || !(weight > tiny_length))
      return std::nullopt;
    return Plane{p + centre / weight, normalized_or(normal, seed)};
  }

  Vec3 step_to_edge(const std::vector<Neighbor>& near, const Vec3& p, const Vec3& n,
                    const Plane& other, double attraction) const
  {
    // the side of the other plane on which the point's own cluster lies
    double side = 0;
    std::size_t count = 0;
    for(const Neighbor& neighbor : near)
      if(m_similarity.cosine(m_normals[neighbor.index], n) > m_edge_cosine &&
         m_similarity.cosine(m_normals[neighbor.index], other.normal) < m_edge_cosine) {
        side += other.normal.dot(m_points[neighbor.index] - other.centre);
        ++count;
      }
    const Vec3 tangent = other.normal - other.normal.dot(n) * n;
    const double slope = tangent.squaredNorm();
    if(count < least_points || slope < 1 - m_edge_cosine * m_edge_cosine)
      return Vec3::Zero();
    const double height = other.normal.dot(p - other.centre);
    const bool beyond = height * side < 0;
    // the length of the step to the edge is |height| / sqrt(slope)
    if(!beyond && std::abs(height) > attraction * std::sqrt(slope))
      return Vec3::Zero();
    return -height / slope * tangent;
  }

  const Points& m_points;
  const Points& m_normals;
  std::size_t m_neighbors;
  Normal_similarity m_similarity;
  double m_edge_cosine;
  Nearest_neighbors m_tree;
};

/// Puts points back that were moved across an edge.
inline void return_to_edges(const Execution& execution, Points& points, const Points& normals,
                            const Edge_finder& edges, double attraction)
{
  parallel_for(execution, points.size(), [&](std::size_t i) {
    points[i] = edges.returned_to_edge(points[i], normals[i], attraction);
  });
}

/// Denoises points and gives them normals that separate clusters: normals and positions in turn, since planes
/// fitted to denoised points tell clusters apart better.
inline void enhance_features(const Execution& execution, Points& points, Points& normals,
                             const Feature_parameters& parameters)
{
  Normal_parameters normal_parameters;
  normal_parameters.oriented = parameters.oriented;
  normal_parameters.sharpness_angle = parameters.sharpness_angle;
  normal_parameters.plane_neighbors = parameters.plane_neighbors;
  Projection_parameters projection;
  projection.oriented = parameters.oriented;
  projection.sharpness_angle = parameters.sharpness_angle;
  projection.neighbors = parameters.plane_neighbors;
  for(std::size_t round = 0; round < parameters.rounds; ++round) {
    const Normal_optimization optimization(execution, points, normal_parameters);
    normals = optimization.separated_normals(normals);
    optimization.smooth(normals);
    const Nearest_table& table = optimization.table();
    project_on_clusters(execution, points, normals, table, projection);
  }
  const Points surface = points, surface_normals = normals;
  const Edge_finder edges(surface, surface_normals, parameters.plane_neighbors, parameters.oriented);
  return_to_edges(execution, points, normals, edges, 0);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PROJECTION_H
