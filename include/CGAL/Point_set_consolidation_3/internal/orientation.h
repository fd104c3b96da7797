// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ORIENTATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ORIENTATION_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Normals whose `strength`, the mean cosine with what told their side, is small follow their neighbours on the
/// same sheet: hints that are nearly tangential tell little.
inline void follow_neighbors_where_weak(const Execution& execution, const Points& points, Points& normals,
                                        const std::vector<double>& strength)
{
  constexpr std::size_t followed = 12;
  constexpr double weak = 0.3;
  constexpr double same_sheet = 0.5;       // cosine of normals, sine of the rise
  const Nearest_neighbors tree(execution, points);
  Points oriented = normals;
  parallel_for_places(execution, points, [&](std::size_t i) {
    if(strength[i] >= weak)
      return;
    std::vector<Neighbor> neighbors;
    tree.find(points[i], followed, neighbors);
    double vote = strength[i];
    for(const Neighbor& neighbor : neighbors) {
      const std::size_t j = neighbor.index;
      const double cosine = normals[i].dot(normals[j]);
      const double rise = std::abs((points[j] - points[i]).dot(normals[i]));
      if(j != i && std::abs(cosine) > same_sheet &&
         rise < same_sheet * std::sqrt(neighbor.squared_distance))
        vote += strength[j] * cosine;
    }
    if(vote < 0)
      oriented[i] = -normals[i];
  });
  normals.swap(oriented);
}

/// Orients normals like the mean hint of the nearest data. Hints may be rough normals or directions towards the
/// scanner.
inline void orient_by_hints(const Execution& execution, const Points& points, Points& normals,
                            const Points& data, const Points& hints)
{
  constexpr std::size_t voters = 12;
  const Nearest_neighbors tree(execution, data);
  std::vector<double> strength(points.size());
  parallel_for_places(execution, points, [&](std::size_t i) {
    std::vector<Neighbor> neighbors;
    tree.find(points[i], voters, neighbors);
    double vote = 0, length = 0;
    for(const Neighbor& neighbor : neighbors) {
      vote += normals[i].dot(hints[neighbor.index]);
      length += hints[neighbor.index].norm();
    }
    if(vote < 0)
      normals[i] = -normals[i];
    strength[i] = length > 0 ? std::abs(vote) / length : 0;
  });
  follow_neighbors_where_weak(execution, points, normals, strength);
}

/// Orients the normals of data by the unit directions of each towards the scanner alone: on thin parts those of
/// the neighbours are opposite.
inline void orient_to_scanner(const Execution& execution, const Points& data, Points& normals,
                              const Points& towards_scanner)
{
  std::vector<double> strength(data.size());
  for(std::size_t i = 0; i < data.size(); ++i) {
    const double vote = normals[i].dot(towards_scanner[i]);
    if(vote < 0)
      normals[i] = -normals[i];
    strength[i] = std::abs(vote);
  }
  follow_neighbors_where_weak(execution, data, normals, strength);
}

/// Flips a component's normals if its outermost points in most directions look inwards.
inline void orient_component_outwards(const Points& points, Points& normals,
                                      const std::vector<std::size_t>& component)
{
  constexpr std::size_t outermost_share = 100;  // one percent: single points of a noisy scan tell nothing
  const std::size_t count = (component.size() + outermost_share - 1) / outermost_share;
  std::vector<std::pair<double, std::size_t> > inwards(component.size());
  double vote = 0;
  for(int x = -1; x <= 1; ++x)
    for(int y = -1; y <= 1; ++y)
      for(int z = -1; z <= 1; ++z) {
        if(x == 0 && y == 0 && z == 0)
          continue;
        const Vec3 direction = Vec3(x, y, z).normalized();
        for(std::size_t k = 0; k < component.size(); ++k)
          inwards[k] = {-points[component[k]].dot(direction), component[k]};
        const auto end = inwards.begin() + std::ptrdiff_t(count);
        std::nth_element(inwards.begin(), end - 1, inwards.end());
        std::sort(inwards.begin(), end);  // sums in one order
        for(auto it = inwards.begin(); it != end; ++it)
          vote += normals[it->second].dot(direction);
      }
  if(vote < 0)
    for(const std::size_t i : component)
      normals[i] = -normals[i];
}

/// The k nearest other points of every point, as rows of one table; short rows are padded with the point
/// itself.
struct Nearest_table {
  std::size_t k = 0;
  std::vector<Index> neighbors;

  const Index* row(std::size_t i) const { return neighbors.data() + i * k; }
  std::size_t size() const { return k == 0 ? 0 : neighbors.size() / k; }
};

inline Nearest_table nearest_table(const Execution& execution, const Points& points,
                                   std::size_t k)
{
  Nearest_table table;
  table.k = (std::min)(k, points.empty() ? 0 : points.size() - 1);
  table.neighbors.resize(points.size() * table.k);
  const Nearest_neighbors tree(execution, points);
  parallel_for_places(execution, points, [&](std::size_t i) {
    std::vector<Neighbor> found;
    tree.find(points[i], table.k + 1, found);
    std::size_t slot = i * table.k;
    const std::size_t end = slot + table.k;
    for(const Neighbor& neighbor : found)
      if(neighbor.index != i && slot < end)
        table.neighbors[slot++] = neighbor.index;
    while(slot < end)
      table.neighbors[slot++] = Index(i);
  });
  return table;
}

/// Neighbours on one sheet whose normals point to different sides. Edges across thin parts, far off both
/// tangent planes, are not counted.
inline std::size_t inconsistent_neighbors(const Points& points, const Points& normals,
                                          const Nearest_table& nearest)
{
  constexpr double within_sheet = 0.3;  // sine of the angle to the tangent plane
  std::size_t count = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t k = 0; k < nearest.k; ++k) {
      const Index j = nearest.row(i)[k];
      const Vec3 d = normalized_or(points[j] - points[i], Vec3::Zero());
      count += normals[i].dot(normals[j]) < 0 && std::abs(d.dot(normals[i])) < within_sheet &&
               std::abs(d.dot(normals[j])) < within_sheet;
    }
  return count;
}

/// Flips normals that most of their neighbours contradict; isolated wrong signs disappear.
inline void orient_by_vote(const Execution& execution, const Points& points, Points& normals,
                           const Nearest_table& nearest, std::size_t passes)
{
  for(std::size_t pass = 0; pass < passes; ++pass) {
    Points next = normals;
    parallel_for(execution, points.size(), [&](std::size_t i) {
      double vote = 0;
      for(std::size_t k = 0; k < nearest.k; ++k) {
        const Index j = nearest.row(i)[k];
        const Vec3 d = normalized_or(points[j] - points[i], Vec3::Zero());
        const double off_sheet = std::abs(d.dot(normals[i])) + std::abs(d.dot(normals[j]));
        vote += (std::max)(0., 1 - off_sheet) * normals[i].dot(normals[j]);
      }
      if(vote < 0)
        next[i] = -normals[i];
    });
    normals.swap(next);
  }
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ORIENTATION_H
