// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_CGAL_CONVERSION_H
#define CONSOLIDATION_SUPPORT_CGAL_CONVERSION_H

#include "types.h"

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>

namespace support {

template <typename Point>
Triangle_mesh to_triangle_mesh(const CGAL::Surface_mesh<Point>& mesh)
{
  typedef CGAL::Surface_mesh<Point> Mesh;
  Triangle_mesh result;
  for(const typename Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for(const typename Mesh::Face_index face : mesh.faces()) {
    std::array<std::size_t, 3> corners;
    std::size_t k = 0;
    for(const typename Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      corners[k++] = std::size_t(v);
    result.faces.push_back(corners);
  }
  return result;
}

/// \tparam Skeleton a `CGAL::Curve_skeleton_3`.
template <typename Skeleton>
Skeleton to_skeleton(const Segment_graph& graph)
{
  Skeleton skeleton(graph.vertices.size());
  for(std::size_t v = 0; v < graph.vertices.size(); ++v) {
    const Vec3& p = graph.vertices[v];
    skeleton[v].point = {p.x(), p.y(), p.z()};
    if(!graph.radius.empty())
      skeleton[v].radius = graph.radius[v];
  }
  for(const auto& edge : graph.edges)
    add_edge(edge[0], edge[1], skeleton);
  return skeleton;
}

/// \tparam Skeleton a `CGAL::Curve_skeleton_3`.
template <typename Skeleton>
Segment_graph to_segment_graph(const Skeleton& skeleton)
{
  Segment_graph graph;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const auto& p = skeleton[v].point;
    graph.vertices.emplace_back(p.x(), p.y(), p.z());
    graph.radius.push_back(skeleton[v].radius);
  }
  const auto range = edges(skeleton);
  for(auto e = range.first; e != range.second; ++e)
    graph.edges.push_back({source(*e, skeleton), target(*e, skeleton)});
  return graph;
}

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_CGAL_CONVERSION_H
