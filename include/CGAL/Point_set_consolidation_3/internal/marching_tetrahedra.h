// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MARCHING_TETRAHEDRA_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MARCHING_TETRAHEDRA_H

#include <CGAL/Point_set_consolidation_3/internal/sparse_lattice.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_triangles.h>

#include <unordered_map>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The surface u = 0 of a field on the nodes of a lattice, negative inside: every cell is cut into the six
/// tetrahedra around its diagonal, the same way in all cells, so that the triangles of neighbours fit. Triangles are
/// oriented outwards. The surface is closed if the field has no zero on the border of the lattice. Coordinates are
/// those of the lattice.
class Marching_tetrahedra {
  /// A vertex keeps this distance from the nodes, as a share of the edge, so that no triangle
  /// degenerates.
  static constexpr double margin = 0.02;

public:
  Marching_tetrahedra(const Sparse_lattice& lattice, const std::vector<double>& values)
    : m_lattice(lattice), m_values(values)
  {
  }

  Surface_triangles run()
  {
    // the tetrahedra have corners 0 and 7 and two neighbouring ones of the hexagon between them
    static const std::size_t hexagon[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
    std::array<std::size_t, 8> corners;
    for(std::size_t i = 0; i < m_lattice.size(); ++i) {
      if(!m_lattice.corners(m_lattice.point(i), corners))
        continue;
      bool has_inside = false, has_outside = false;
      for(const std::size_t c : corners)
        (m_values[c] < 0 ? has_inside : has_outside) = true;
      if(!has_inside || !has_outside)
        continue;
      for(const auto& side : hexagon)
        cut({corners[0], corners[side[0]], corners[side[1]], corners[7]});
    }
    return std::move(m_surface);
  }

private:
  using Tetrahedron = std::array<std::size_t, 4>;

  void cut(const Tetrahedron& t)
  {
    std::array<std::size_t, 4> inside, outside;
    std::size_t in = 0, out = 0;
    for(std::size_t k = 0; k < 4; ++k)
      if(m_values[t[k]] < 0)
        inside[in++] = k;
      else
        outside[out++] = k;
    if(in == 1)
      triangle(t, inside[0], outside[0], inside[0], outside[1], inside[0], outside[2]);
    if(in == 3)
      triangle(t, inside[0], outside[0], inside[1], outside[0], inside[2], outside[0]);
    if(in == 2) {
      triangle(t, inside[0], outside[0], inside[0], outside[1], inside[1], outside[1]);
      triangle(t, inside[0], outside[0], inside[1], outside[1], inside[1], outside[0]);
    }
  }

  /// The triangle of the zeros on three edges of the tetrahedron, turned outwards.
  void triangle(const Tetrahedron& t, std::size_t a0, std::size_t a1, std::size_t b0, std::size_t b1,
                std::size_t c0, std::size_t c1)
  {
    std::array<std::size_t, 3> corners = {vertex(t[a0], t[a1]), vertex(t[b0], t[b1]),
                                          vertex(t[c0], t[c1])};
    // the orientation is that of the edges' middles: independent of where the zeros are
    const Vec3 a = middle(t[a0], t[a1]), b = middle(t[b0], t[b1]), c = middle(t[c0], t[c1]);
    Vec3 outwards = Vec3::Zero();
    for(const std::size_t node : t)
      outwards += (m_values[node] < 0 ? -1. : 1.) * position(node);
    const std::size_t inside_count = std::size_t(
      std::count_if(t.begin(), t.end(), [&](std::size_t node) { return m_values[node] < 0; }));
    outwards += (double(inside_count) - double(4 - inside_count)) * a;
    if((b - a).cross(c - a).dot(outwards) < 0)
      std::swap(corners[1], corners[2]);
    m_surface.triangles.push_back(corners);
  }

  Vec3 position(std::size_t node) const
  {
    const Lattice_point p = m_lattice.point(node);
    return Vec3(double(p[0]), double(p[1]), double(p[2]));
  }
  Vec3 middle(std::size_t a, std::size_t b) const { return 0.5 * (position(a) + position(b)); }

  std::size_t vertex(std::size_t a, std::size_t b)
  {
    const std::uint64_t key = std::uint64_t((std::min)(a, b)) << 32 | std::uint64_t((std::max)(a, b));
    const auto found = m_vertices.emplace(key, m_surface.vertices.size());
    if(found.second) {
      const double t = m_values[a] / (m_values[a] - m_values[b]);
      const double s = std::isfinite(t) ? (std::min)(1 - margin, (std::max)(margin, t)) : 0.5;
      m_surface.vertices.push_back(position(a) + s * (position(b) - position(a)));
    }
    return found.first->second;
  }

  const Sparse_lattice& m_lattice;
  const std::vector<double>& m_values;
  Surface_triangles m_surface;
  std::unordered_map<std::uint64_t, std::size_t> m_vertices;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MARCHING_TETRAHEDRA_H
