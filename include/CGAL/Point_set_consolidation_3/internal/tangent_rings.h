// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_RINGS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_RINGS_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>

#include <array>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section III.A: one-rings of a point set by a Delaunay triangulation of the
/// neighbours of every point in its tangent plane. In: distinct points. Out: triangles; wherever the ring of
/// one corner has a triangle, those of the two others have it as well.

using Ring_triangle = std::array<Index, 3>;  ///< corners in increasing order
using Ring_edge = std::array<Index, 2>;      ///< ends in increasing order

struct Tangent_rings {
  std::vector<Ring_triangle> triangles;  ///< distinct, in lexicographic order
  std::vector<unsigned char> agreement;  ///< of triangles: number of corners whose rings have it, 1 to 3
  std::vector<Ring_edge> edges;          ///< distinct, in lexicographic order
  std::vector<std::size_t> first;        ///< ring of point i: neighbors[first[i] .. first[i + 1])
  std::vector<Index> neighbors;

  std::size_t number_of_points() const { return first.size() - 1; }
};

/// 0.012 n within [8, 12], the point itself included. The paper's upper bound, 30, joins parts that are close to each
/// other: of fifteen models of 5000 points four have wrong cycles with it, one with 12.
inline std::size_t default_ring_neighbors(std::size_t n)
{
  constexpr double share = 0.012;
  return (std::min)(std::size_t(12), (std::max)(std::size_t(8), std::size_t(std::round(share * double(n)))));
}

/// The paper's upper bound.
constexpr std::size_t most_ring_neighbors = 30;

/// Edges and rings of the triangles among `n` points.
inline void connect_triangles(std::size_t n, Tangent_rings& rings)
{
  rings.edges.clear();
  for(const Ring_triangle& t : rings.triangles) {
    rings.edges.push_back({t[0], t[1]});
    rings.edges.push_back({t[0], t[2]});
    rings.edges.push_back({t[1], t[2]});
  }
  std::sort(rings.edges.begin(), rings.edges.end());
  rings.edges.erase(std::unique(rings.edges.begin(), rings.edges.end()), rings.edges.end());
  rings.first.assign(n + 1, 0);
  for(const Ring_edge& e : rings.edges) {
    ++rings.first[e[0] + 1];
    ++rings.first[e[1] + 1];
  }
  for(std::size_t i = 0; i < n; ++i)
    rings.first[i + 1] += rings.first[i];
  rings.neighbors.resize(rings.first[n]);
  std::vector<std::size_t> next(rings.first.begin(), rings.first.end() - 1);
  // edges are sorted by their first ends: smaller neighbours of a point come first, all in order
  for(const Ring_edge& e : rings.edges)
    rings.neighbors[next[e[1]]++] = e[0];
  for(const Ring_edge& e : rings.edges)
    rings.neighbors[next[e[0]]++] = e[1];
}

class Tangent_ring_finder {
  /// Angle of a triangle at the centre below which it is no triangle (coincident projections).
  static constexpr double least_sine = 1e-10;
  /// A neighbourhood ends where the next point is this many times farther away than the last: in a
  /// uniformly sampled surface consecutive distances differ by less than 2 from the sixth neighbour
  /// on, a larger step leads to another part. Without it a small part would have edges across space.
  static constexpr double largest_step = 3;
  static constexpr std::size_t certain_neighbors = 6;

  struct Inverted_point {
    double x, y;
    Index index;
  };

public:
  Tangent_ring_finder(const Execution& execution, const Points& points)
    : m_execution(execution), m_points(points), m_tree(points)
  {
  }

  /// Rings among `k` neighbours, the point itself included.
  Tangent_rings find(std::size_t k) const
  {
    std::vector<std::vector<Ring_triangle> > stars(m_points.size());
    parallel_for(m_execution, m_points.size(), [&](std::size_t i) { stars[i] = star(i, k); });

    Tangent_rings rings;
    for(const std::vector<Ring_triangle>& triangles : stars)
      rings.triangles.insert(rings.triangles.end(), triangles.begin(), triangles.end());
    std::sort(rings.triangles.begin(), rings.triangles.end());
    std::size_t last = 0;
    for(const Ring_triangle& t : rings.triangles)
      if(!rings.agreement.empty() && rings.triangles[last] == t)
        ++rings.agreement.back();
      else {
        last = rings.agreement.size();
        rings.triangles[last] = t;
        rings.agreement.push_back(1);
      }
    rings.triangles.resize(rings.agreement.size());
    connect_triangles(m_points.size(), rings);
    return rings;
  }

private:
  /// Triangles at point i of the Delaunay triangulation of its neighbourhood in the tangent plane.
  ///
  /// Inversion at point i takes circles through it to lines: a circle through i, a and b is empty if
  /// all inverted neighbours are on one side of the line through the inverted a and b. The star of i is therefore
  /// the convex hull of the inverted neighbours, as far as i is on the inner side of its edges. Of
  /// cocircular points the hull keeps the corners, which is a valid triangulation as well.
  std::vector<Ring_triangle> star(std::size_t i, std::size_t k) const
  {
    std::vector<Neighbor> found;
    m_tree.find(m_points[i], k, found);
    std::size_t count = found.size();
    for(std::size_t j = certain_neighbors + 1; j < count; ++j)
      if(found[j].squared_distance > largest_step * largest_step * found[j - 1].squared_distance)
        count = j;

    Covariance_sum sum;
    for(std::size_t j = 0; j < count; ++j)
      sum.add(m_points[found[j].index] - m_points[i]);
    const Mat3 axes = sum.axes().eigenvectors();
    const Vec3 u = axes.col(2), v = axes.col(1);
    std::vector<Inverted_point> inverted;
    for(std::size_t j = 0; j < count; ++j) {
      const Vec3 offset = m_points[found[j].index] - m_points[i];
      const double x = offset.dot(u), y = offset.dot(v), d2 = x * x + y * y;
      if(found[j].index != i && d2 > least_sine * least_sine * found[j].squared_distance)
        inverted.push_back({x / d2, y / d2, found[j].index});
    }
    const std::vector<Inverted_point> hull = convex_hull(std::move(inverted));

    std::vector<Ring_triangle> triangles;
    for(std::size_t j = 0; hull.size() > 1 && j < hull.size(); ++j) {
      const Inverted_point& a = hull[j];
      const Inverted_point& b = hull[(j + 1) % hull.size()];
      if(a.x * b.y - a.y * b.x > least_sine * std::hypot(a.x, a.y) * std::hypot(b.x, b.y)) {
        Ring_triangle t = {Index(i), a.index, b.index};
        std::sort(t.begin(), t.end());
        triangles.push_back(t);
      }
    }
    return triangles;
  }

  /// Corners of the convex hull, counterclockwise (Andrew's monotone chain).
  static std::vector<Inverted_point> convex_hull(std::vector<Inverted_point> points)
  {
    std::sort(points.begin(), points.end(), [](const Inverted_point& a, const Inverted_point& b) {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.index < b.index;
    });
    points.erase(std::unique(points.begin(), points.end(),
                             [](const Inverted_point& a, const Inverted_point& b) {
                               return a.x == b.x && a.y == b.y;
                             }),
                 points.end());
    if(points.size() < 3)
      return points;
    const auto turns_left = [](const Inverted_point& a, const Inverted_point& b,
                               const Inverted_point& c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    };
    std::vector<Inverted_point> hull;
    const auto extend = [&](const Inverted_point& p, std::size_t least) {
      while(hull.size() > least && !turns_left(hull[hull.size() - 2], hull.back(), p))
        hull.pop_back();
      hull.push_back(p);
    };
    for(const Inverted_point& p : points)
      extend(p, 1);
    const std::size_t lower = hull.size();
    for(std::size_t j = points.size() - 1; j-- > 0;)
      extend(points[j], lower);
    hull.pop_back();  // the first point again
    return hull;
  }

  const Execution& m_execution;
  const Points& m_points;
  Nearest_neighbors m_tree;
};

inline Tangent_rings find_tangent_rings(const Execution& execution, const Points& points,
                                        std::size_t k)
{
  return Tangent_ring_finder(execution, points).find(k);
}

/// Of the parts that edges join.
inline std::size_t number_of_components(const Tangent_rings& rings)
{
  Disjoint_sets sets(rings.number_of_points());
  std::size_t components = rings.number_of_points();
  for(const Ring_edge& e : rings.edges)
    components -= sets.join(e[0], e[1]) ? 1 : 0;
  return components;
}

/// Rings among as few neighbours as the default has, or as many more as join all that the paper's bound joins: few
/// neighbours of a point where samples are uneven lie all on its denser side.
inline Tangent_rings find_joined_rings(const Execution& execution, const Points& points)
{
  constexpr double growth = 1.3;  // 12, 15, 19, 24: few more than needed
  const Tangent_ring_finder finder(execution, points);
  std::size_t k = default_ring_neighbors(points.size());
  Tangent_rings rings = finder.find(k);
  std::size_t components = number_of_components(rings);
  if(components == 1)
    return rings;
  Tangent_rings widest = finder.find(most_ring_neighbors);
  for(const std::size_t least = number_of_components(widest); components > least;) {
    k = std::size_t(growth * double(k));
    if(k >= most_ring_neighbors)
      return widest;
    rings = finder.find(k);
    components = number_of_components(rings);
  }
  return rings;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_TANGENT_RINGS_H
