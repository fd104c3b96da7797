// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_FILLING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_FILLING_H

#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/flat_closure.h>
#include <CGAL/Point_set_consolidation_3/internal/gaps.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_consolidation.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The consolidation of the deep points paper, section 4.3, spreads |S| points over a surface that has
/// become larger, so completed regions are 2 to 6 r sparse, and Poisson's surface over them sags and
/// swells. They are filled up here to a given spacing: a point is inserted between neighbours that are
/// far apart, at the mean of their distances from the meso-skeleton, which is the volume preserving
/// prior (8). Then lengths are averaged over nearest neighbours, and normals fitted to them.
/// Lengths in units of the spacing r of S. Measured points do not change.
class Completed_filling {
  static constexpr double clearance = 0.7;         ///< of an inserted point, in the wanted spacing
  static constexpr double longest_gap = 8;         ///< wider ones are holes between fronts
  static constexpr double least_agreement = 0.3;   ///< of the normals on both sides of a gap
  static constexpr int max_insertion_passes = 8;   ///< each about halves the widest gaps
  static constexpr int smoothing_passes = 4;
  static constexpr std::size_t neighbors = 12;
  static constexpr std::size_t normal_neighbors = 16;
  static constexpr std::size_t least_normal_neighbors = 6;
  static constexpr double gap_link = 3;            ///< between completed points of one gap

public:
  Completed_filling(Execution& execution, const Points& skeleton, const std::vector<char>& frozen,
                    Consolidated_surface& surface)
    : m_execution(execution), m_skeleton(skeleton), m_skeleton_tree(skeleton), m_surface(surface)
    , m_is_moving(surface.points.size())
  {
    for(std::size_t i = 0; i < m_is_moving.size(); ++i)
      m_is_moving[i] = surface.data_density[i] < completed_density && (frozen.empty() || !frozen[i]);
    update_lengths();
  }

  /// `spacing`: of the filled regions; 0 inserts nothing.
  void run(double spacing)
  {
    if(spacing > 0)
      for(int pass = 0; pass < max_insertion_passes && insert(spacing); ++pass) {}
    for(int pass = 0; pass < smoothing_passes; ++pass)
      average_lengths();
    for(int pass = 0; pass < 2; ++pass)
      fit_normals();
  }

  /// Moves the points of gaps with a flat prior to the plane through the data at their border.
  void close_flat(const Points& data, const Nearest_neighbors& data_tree, const Gap_parameters& gaps)
  {
    std::vector<std::size_t> moving;
    Points points;
    for(std::size_t i = 0; i < m_is_moving.size(); ++i)
      if(m_is_moving[i]) {
        moving.push_back(i);
        points.push_back(m_surface.points[i]);
      }
    for(const std::vector<Index>& gap : connected_components(points, gap_link)) {
      Points of_gap;
      Vec3 outwards = Vec3::Zero();
      for(const Index k : gap) {
        of_gap.push_back(points[k]);
        outwards += m_surface.normals[moving[k]];
      }
      const std::vector<Index> border = border_of(m_execution, data_tree, of_gap);
      if(gaps.prior_of(border) != Prior::FLAT)
        continue;
      const Closing_plane plane = closing_plane(data, border, outwards);
      if(!plane.is_valid())
        continue;
      for(const Index k : gap) {
        m_surface.points[moving[k]] = plane.projected(points[k]);
        m_surface.normals[moving[k]] = plane.normal;
      }
    }
    update_lengths();
  }

private:
  void update_lengths()
  {
    m_surface.inner.resize(m_surface.points.size());
    m_length.resize(m_surface.points.size());
    parallel_for(m_execution, m_surface.points.size(), [&](std::size_t i) {
      const Neighbor q = m_skeleton_tree.nearest(m_surface.points[i]);
      m_surface.inner[i] = q.index;
      m_length[i] = std::sqrt(q.squared_distance);
    });
  }

  Vec3 deep_direction(std::size_t i) const
  {
    return normalized_or(m_surface.points[i] - m_skeleton[m_surface.inner[i]],
                         m_surface.normals[i]);
  }

  struct Candidate {
    Vec3 point, normal;
  };

  /// Middles of the gaps that begin at point i, each gap once.
  std::vector<Candidate> candidates(const Nearest_neighbors& tree, const Sorted_grid& grid,
                                    std::size_t i, double spacing) const
  {
    const double shortest_gap = 2 * clearance * spacing;
    std::vector<Candidate> result;
    std::vector<Neighbor> nearest;
    tree.find(m_surface.points[i], neighbors + 1, nearest);
    for(const Neighbor& neighbor : nearest) {
      const std::size_t j = neighbor.index;
      if(j <= i || (!m_is_moving[i] && !m_is_moving[j]) ||
         neighbor.squared_distance < shortest_gap * shortest_gap ||
         neighbor.squared_distance > longest_gap * longest_gap ||
         m_surface.normals[i].dot(m_surface.normals[j]) < least_agreement)
        continue;
      const Vec3 middle = 0.5 * (m_surface.points[i] + m_surface.points[j]);
      const Vec3& q = m_skeleton[m_skeleton_tree.nearest(middle).index];
      const Vec3 normal = normalized_or(m_surface.normals[i] + m_surface.normals[j],
                                        m_surface.normals[i]);
      const Vec3 x = q + 0.5 * (m_length[i] + m_length[j]) * normalized_or(middle - q, normal);
      bool is_clear = true;
      grid.for_each_neighbor(x, clearance * spacing, [&](Index, double) {
        is_clear = false;
        return false;
      });
      if(is_clear)
        result.push_back({x, normal});
    }
    return result;
  }

  bool insert(double spacing)
  {
    const std::size_t n = m_surface.points.size();
    const double radius = clearance * spacing;
    const Nearest_neighbors tree(m_surface.points);
    const Sorted_grid grid(m_surface.points, radius);
    std::vector<std::vector<Candidate> > found(n);
    parallel_for(m_execution, n,
                 [&](std::size_t i) { found[i] = candidates(tree, grid, i, spacing); });

    Points middles;
    std::vector<Vec3> normals;
    for(const auto& list : found)
      for(const Candidate& c : list) {
        middles.push_back(c.point);
        normals.push_back(c.normal);
      }
    if(middles.empty())
      return false;
    // of candidates closer than the clearance the first stays
    const Sorted_grid candidate_grid(middles, radius);
    std::vector<char> is_taken(middles.size(), 0);
    for(std::size_t c = 0; c < middles.size(); ++c) {
      bool is_clear = true;
      candidate_grid.for_each_neighbor(middles[c], radius, [&](Index other, double) {
        is_clear = is_clear && !is_taken[other];
        return is_clear;
      });
      if(!is_clear)
        continue;
      is_taken[c] = 1;
      m_surface.points.push_back(middles[c]);
      m_surface.normals.push_back(normals[c]);
      m_surface.data_density.push_back(1);
      m_is_moving.push_back(1);
    }
    update_lengths();
    return true;
  }

  /// Lengths, not positions: the mean position of sparse points lies inside of the solid.
  void average_lengths()
  {
    const Nearest_neighbors tree(m_surface.points);
    Points points = m_surface.points, normals = m_surface.normals;
    parallel_for(m_execution, points.size(), [&](std::size_t i) {
      if(!m_is_moving[i])
        return;
      Vec3 normal_sum = Vec3::Zero();
      double change = 0;
      std::size_t count = 0;
      for_each_on_same_side(tree, i, neighbors, [&](std::size_t j) {
        normal_sum += m_surface.normals[j];
        change += m_length[j] - m_length[i];
        ++count;
      });
      normals[i] = normalized_or(normal_sum, m_surface.normals[i]);
      if(count > 0)
        points[i] += 0.5 * change / double(count) * deep_direction(i);
    });
    m_surface.points.swap(points);
    m_surface.normals.swap(normals);
    update_lengths();
  }

  void fit_normals()
  {
    const Nearest_neighbors tree(m_surface.points);
    Points normals = m_surface.normals;
    parallel_for(m_execution, normals.size(), [&](std::size_t i) {
      if(!m_is_moving[i])
        return;
      Covariance_sum sum;
      std::size_t count = 0;
      for_each_on_same_side(tree, i, normal_neighbors, [&](std::size_t j) {
        sum.add(m_surface.points[j] - m_surface.points[i]);
        ++count;
      });
      if(count < least_normal_neighbors)
        return;
      const Vec3 normal = sum.normal();
      normals[i] = normal.dot(m_surface.normals[i]) < 0 ? Vec3(-normal) : normal;
    });
    m_surface.normals.swap(normals);
  }

  template <typename Visitor>
  void for_each_on_same_side(const Nearest_neighbors& tree, std::size_t i, std::size_t k,
                             const Visitor& visit) const
  {
    std::vector<Neighbor> nearest;
    tree.find(m_surface.points[i], k + 1, nearest);
    for(const Neighbor& neighbor : nearest)
      if(m_surface.normals[neighbor.index].dot(m_surface.normals[i]) > 0)
        visit(neighbor.index);
  }

  Execution& m_execution;
  const Points& m_skeleton;
  Nearest_neighbors m_skeleton_tree;
  Consolidated_surface& m_surface;
  std::vector<char> m_is_moving;
  std::vector<double> m_length;   ///< of the deep points
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_COMPLETED_FILLING_H
