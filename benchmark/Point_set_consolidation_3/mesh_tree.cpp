// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_tree.h"

#include "cgal_compatibility.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace benchmark {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = support::Triangle_primitive<Kernel, Triangles::const_iterator>;
using Traits = support::Box_tree_traits<Kernel, Primitive>;

Point_3 to_cgal(const Vec3& p)
{
  return {p.x(), p.y(), p.z()};
}
Vec3 to_eigen(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

}  // namespace

struct Mesh_tree::Tree {
  Triangles triangles;
  std::vector<Vec3> normals;
  std::vector<std::size_t> faces;  ///< index in the caller's mesh
  CGAL::AABB_tree<Traits> tree;

  Mesh_hit hit(const Vec3& point, Triangles::const_iterator triangle) const
  {
    const auto i = static_cast<std::size_t>(triangle - triangles.begin());
    return {point, normals[i], faces[i]};
  }
};

Mesh_tree::Mesh_tree(const Triangle_mesh& mesh) : m_tree(std::make_unique<Tree>())
{
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 normal = face_normal(mesh, f);
    if(normal.isZero())
      continue;
    const auto& corners = mesh.faces[f];
    m_tree->triangles.emplace_back(to_cgal(mesh.vertices[corners[0]]),
                                   to_cgal(mesh.vertices[corners[1]]),
                                   to_cgal(mesh.vertices[corners[2]]));
    m_tree->normals.push_back(normal);
    m_tree->faces.push_back(f);
  }
  if(m_tree->triangles.empty())
    throw support::Method_error("mesh without a facet that has area");
  const Triangles& triangles = m_tree->triangles;
  m_tree->tree.insert(triangles.begin(), triangles.end());
  m_tree->tree.build();
  m_tree->tree.accelerate_distance_queries();
}

Mesh_tree::~Mesh_tree() = default;
Mesh_tree::Mesh_tree(Mesh_tree&&) noexcept = default;

std::optional<Mesh_hit> Mesh_tree::first_hit(const Ray& ray) const
{
  const Kernel::Ray_3 query(
      to_cgal(ray.origin),
      Kernel::Vector_3(ray.direction.x(), ray.direction.y(), ray.direction.z()));
  const auto primitive = m_tree->tree.first_intersected_primitive(query);
  if(!primitive)
    return std::nullopt;
  // the ray meets the facet's plane; computed here so that no variant of CGAL's intersections is needed
  Mesh_hit hit = m_tree->hit(ray.origin, *primitive);
  const double slope = hit.normal.dot(ray.direction);
  const Vec3 corner = to_eigen((*primitive)->vertex(0));
  if(slope != 0.0)
    hit.point += hit.normal.dot(corner - ray.origin) / slope * ray.direction;
  return hit;
}

Mesh_hit Mesh_tree::closest(const Vec3& query) const
{
  const auto result = m_tree->tree.closest_point_and_primitive(to_cgal(query));
  return m_tree->hit(to_eigen(result.first), result.second);
}

bool Mesh_tree::is_inside(const Vec3& query) const
{
  const Kernel::Vector_3 directions[]
      = {{0.5377, 0.8339, -0.1247}, {-0.2588, 0.3622, 0.8954}, {0.3188, -0.8077, 0.4959}};
  int inside = 0;
  for(const Kernel::Vector_3& direction : directions) {
    const Kernel::Ray_3 ray(to_cgal(query), direction);
    inside += static_cast<int>(m_tree->tree.number_of_intersected_primitives(ray) % 2);
  }
  return inside >= 2;
}

Vec3 face_normal(const Triangle_mesh& mesh, std::size_t face)
{
  const auto& corners = mesh.faces[face];
  const Vec3& a = mesh.vertices[corners[0]];
  const Vec3 normal = (mesh.vertices[corners[1]] - a).cross(mesh.vertices[corners[2]] - a);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3::Zero();
}

}  // namespace benchmark
