// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_NEIGHBORS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_NEIGHBORS_H

#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>

#include <CGAL/Dimension.h>
#include <CGAL/Euclidean_distance.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Splitters.h>

#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

struct Indexed_point {
  double coordinates[3];
  Index index;
};

struct Indexed_point_coordinates {
  typedef const double* result_type;
  const double* operator()(const Indexed_point& p) const { return p.coordinates; }
  const double* operator()(const Indexed_point& p, int) const { return p.coordinates + 3; }
};

struct Neighbor {
  Index index;
  double squared_distance;
};

/// Nearest neighbours of arbitrary queries, by CGAL's Kd_tree. Neighbours come in increasing distance;
/// those at equal distance in increasing index.
class Nearest_neighbors {
  typedef CGAL::Search_traits<double, Indexed_point, const double*, Indexed_point_coordinates,
                              CGAL::Dimension_tag<3> > Traits;
  typedef CGAL::Euclidean_distance<Traits> Distance;
  typedef CGAL::Sliding_midpoint<Traits> Splitter;
  typedef CGAL::Kd_tree<Traits, Splitter> Tree;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree> Search;

public:
  explicit Nearest_neighbors(const Points& points) : Nearest_neighbors(Execution(), points) {}

  /// The same, built by all threads.
  Nearest_neighbors(const Execution& execution, const Points& points)
  {
    std::vector<Indexed_point> indexed(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      indexed[i] = {{points[i].x(), points[i].y(), points[i].z()}, Index(i)};
    constexpr unsigned int bucket_size = 20;
    m_tree = std::make_unique<Tree>(indexed.begin(), indexed.end(), Splitter(bucket_size));
    if(!points.empty())
      with_concurrency_tag(execution, [&](auto tag) { m_tree->template build<decltype(tag)>(); });
  }

  std::size_t size() const { return m_tree->size(); }

  /// The `k` nearest points (fewer if there are fewer), into `neighbors`.
  void find(const Vec3& query, std::size_t k, std::vector<Neighbor>& neighbors) const
  {
    neighbors.clear();
    if(size() == 0 || k == 0)
      return;
    const Indexed_point q = {{query.x(), query.y(), query.z()}, 0};
    Search search(*m_tree, q, (unsigned int)((std::min)(k, size())));
    for(typename Search::iterator it = search.begin(); it != search.end(); ++it)
      neighbors.push_back({it->first.index, it->second});
    std::sort(neighbors.begin(), neighbors.end(), [](const Neighbor& a, const Neighbor& b) {
      return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                      : a.index < b.index;
    });
  }

  /// The nearest point. The set must not be empty.
  Neighbor nearest(const Vec3& query) const
  {
    const Indexed_point q = {{query.x(), query.y(), query.z()}, 0};
    Search search(*m_tree, q, 1);
    return {search.begin()->first.index, search.begin()->second};
  }

private:
  std::unique_ptr<Tree> m_tree;
};

/// Mean distance of every point to its `k` nearest others; 0 for a point without others.
inline std::vector<double> neighbor_distances(const Execution& execution,
                                              const Nearest_neighbors& tree, const Points& points,
                                              std::size_t k)
{
  std::vector<double> distances(points.size(), 0.);
  parallel_for_places(execution, points, [&](std::size_t i) {
    std::vector<Neighbor> neighbors;
    tree.find(points[i], k + 1, neighbors);  // the point itself is the first
    for(std::size_t j = 1; j < neighbors.size(); ++j)
      distances[i] += std::sqrt(neighbors[j].squared_distance);
    if(neighbors.size() > 1)
      distances[i] /= double(neighbors.size() - 1);
  });
  return distances;
}

inline double mean(const std::vector<double>& values)
{
  double sum = 0;
  for(const double v : values)
    sum += v;
  return values.empty() ? 0 : sum / double(values.size());
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_NEAREST_NEIGHBORS_H
