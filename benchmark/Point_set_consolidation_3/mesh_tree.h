// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_MESH_TREE_H
#define CONSOLIDATION_BENCHMARK_MESH_TREE_H

#include "types.h"

#include <memory>
#include <optional>

namespace benchmark {

using support::Triangle_mesh;
using support::Vec3;

struct Ray {
  Vec3 origin;
  Vec3 direction;  ///< unit
};

struct Mesh_hit {
  Vec3 point;
  Vec3 normal;  ///< unit normal of the facet
  std::size_t face;
};

/// Closest point and ray queries on a triangle mesh (CGAL's AABB tree behind plain data).
/// Facets without area are left out. Faces are numbered as in the mesh.
class Mesh_tree {
public:
  explicit Mesh_tree(const Triangle_mesh& mesh);
  ~Mesh_tree();
  Mesh_tree(Mesh_tree&&) noexcept;

  std::optional<Mesh_hit> first_hit(const Ray& ray) const;
  Mesh_hit closest(const Vec3& query) const;

  /// Is `query` inside of the closed mesh? Majority of three rays, so that a ray through an edge does not decide.
  bool is_inside(const Vec3& query) const;

private:
  struct Tree;
  std::unique_ptr<Tree> m_tree;
};

/// Unit normal of a face, zero if the face has no area.
Vec3 face_normal(const Triangle_mesh& mesh, std::size_t face);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_MESH_TREE_H
