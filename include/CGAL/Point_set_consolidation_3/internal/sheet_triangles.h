// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SHEET_TRIANGLES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SHEET_TRIANGLES_H

#include <CGAL/Point_set_consolidation_3/internal/meso_graph_types.h>
#include <CGAL/Point_set_consolidation_3/internal/spanning_disc.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_rings.h>

#include <map>
#include <set>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Triangles between points that sample sheets, which may have borders and may meet along curves.
///
/// They are taken from the points' rings in their tangent planes, first those on which most corners agree, of
/// these the ones with the smallest circumscribed circle. A triangle must not fold onto one that has been taken.
class Sheet_triangulation {
  static constexpr std::size_t ring_neighbors = 16;
  /// Smallest angle between two triangles at an edge: less is a fold.
  static constexpr double largest_fold_cosine = 0.5;

public:
  /// `links`: pairs of points, the smaller first, that may be joined. Holes of at most `largest_hole` sides, where
  /// the rings disagree, are filled.
  static std::vector<Sheet_triangle> triangulate(const Execution& execution, const Points& points,
                                                 const std::set<Ring_edge>& links,
                                                 std::size_t largest_hole)
  {
    if(points.size() < 3)
      return {};
    const Tangent_rings rings =
      find_tangent_rings(execution, points, (std::min)(ring_neighbors, points.size()));
    struct Candidate {
      int disagreement;
      double radius;
      std::size_t triangle;
      bool operator<(const Candidate& other) const
      {
        return disagreement != other.disagreement ? disagreement < other.disagreement
               : radius != other.radius           ? radius < other.radius
                                                  : triangle < other.triangle;
      }
    };
    std::vector<Candidate> candidates;
    for(std::size_t k = 0; k < rings.triangles.size(); ++k) {
      const Ring_triangle& t = rings.triangles[k];
      if(links.count({t[0], t[1]}) && links.count({t[0], t[2]}) && links.count({t[1], t[2]}))
        candidates.push_back({3 - int(rings.agreement[k]), circumradius(points, t), k});
    }
    std::sort(candidates.begin(), candidates.end());

    Sheet_triangulation result(points);
    for(const Candidate& c : candidates)
      result.add(rings.triangles[c.triangle]);
    for(std::vector<Index> hole = result.smallest_hole(largest_hole); !hole.empty();
        hole = result.smallest_hole(largest_hole))
      result.fill(hole);
    std::sort(result.m_triangles.begin(), result.m_triangles.end());
    return result.m_triangles;
  }

private:
  explicit Sheet_triangulation(const Points& points) : m_points(points) {}

  static double circumradius(const Points& points, const Ring_triangle& t)
  {
    const Vec3 a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]];
    const double twice_area = a.cross(b).norm();
    return twice_area > 0 ? a.norm() * b.norm() * (a - b).norm() / (2 * twice_area)
                          : std::numeric_limits<double>::max();
  }

  /// Unit vector from the edge a b, at a right angle to it, towards c.
  Vec3 away(Index a, Index b, Index c) const
  {
    const Vec3 along = normalized_or(m_points[b] - m_points[a], Vec3::Zero());
    const Vec3 d = m_points[c] - m_points[a];
    return normalized_or(d - d.dot(along) * along, Vec3::Zero());
  }

  void add(const Ring_triangle& t)
  {
    for(int c = 0; c < 3; ++c) {
      const Index a = t[(c + 1) % 3], b = t[(c + 2) % 3];
      const auto found = m_opposite.find({(std::min)(a, b), (std::max)(a, b)});
      if(found == m_opposite.end())
        continue;
      for(const Index other : found->second)
        if(away(a, b, t[c]).dot(away(a, b, other)) > largest_fold_cosine)
          return;
    }
    insert(t);
  }

  void insert(const Ring_triangle& t)
  {
    for(int c = 0; c < 3; ++c) {
      const Index a = t[(c + 1) % 3], b = t[(c + 2) % 3];
      m_opposite[{(std::min)(a, b), (std::max)(a, b)}].push_back(t[c]);
    }
    m_triangles.push_back({t[0], t[1], t[2]});
  }

  /// The closed chain of fewest edges with one triangle each, other than the sides of a triangle; empty if it has
  /// more than `largest`.
  std::vector<Index> smallest_hole(std::size_t largest) const
  {
    std::map<Index, std::vector<Index> > border;
    for(const auto& edge : m_opposite)
      if(edge.second.size() == 1) {
        border[edge.first[0]].push_back(edge.first[1]);
        border[edge.first[1]].push_back(edge.first[0]);
      }
    std::vector<Index> best;
    for(const auto& start : border)
      for(const Index end : start.second) {
        if(end < start.first)
          continue;
        std::vector<Index> chain =
          border_path(border, start.first, end, best.empty() ? largest : best.size() - 1);
        if(!chain.empty())
          best.swap(chain);
      }
    return best;
  }
  /// A shortest path from a to b along the border, not along their edge nor around their triangle, with at most `most`
  /// nodes; breadth first.
  std::vector<Index> border_path(const std::map<Index, std::vector<Index> >& border, Index a, Index b,
                                 std::size_t most) const
  {
    const Index own_corner = m_opposite.at({(std::min)(a, b), (std::max)(a, b)}).front();
    std::vector<std::pair<Index, std::size_t> > visited = {{a, 0}};  // node, place of its predecessor
    std::set<Index> seen = {a};
    std::size_t begin = 0;
    for(std::size_t nodes = 2; nodes <= most; ++nodes) {
      const std::size_t end = visited.size();
      for(; begin < end; ++begin)
        for(const Index next : border.at(visited[begin].first)) {
          const bool is_own = next == b && (begin == 0 || (nodes == 3 && visited[begin].first == own_corner));
          if(is_own || !seen.insert(next).second)
            continue;
          visited.emplace_back(next, begin);
          if(next == b) {
            std::vector<Index> path = {b};
            for(std::size_t at = begin; at != 0; at = visited[at].second)
              path.push_back(visited[at].first);
            path.push_back(a);
            return path;
          }
        }
    }
    return {};
  }

  void fill(const std::vector<Index>& hole)
  {
    for(const Sheet_triangle& t : triangles_of_polygon(hole, [&](Index i) -> const Vec3& { return m_points[i]; }))
      insert({Index(t[0]), Index(t[1]), Index(t[2])});
  }

  const Points& m_points;
  std::map<Ring_edge, std::vector<Index> > m_opposite;  ///< third corners of the triangles at an edge
  std::vector<Sheet_triangle> m_triangles;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SHEET_TRIANGLES_H
