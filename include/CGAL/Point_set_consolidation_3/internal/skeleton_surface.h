// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SURFACE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SURFACE_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/field_topology.h>
#include <CGAL/Point_set_consolidation_3/internal/signed_distance_field.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_radii.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section V, as a whole: from points and skeleton to a closed surface.

/// Number of times a closed surface winds around a point, by the solid angles of its triangles.
inline double winding_number(const Surface_triangles& surface, const std::vector<std::size_t>& triangles,
                             const Vec3& x)
{
  double angle = 0;
  for(const std::size_t t : triangles) {
    const Vec3 a = surface.vertices[surface.triangles[t][0]] - x;
    const Vec3 b = surface.vertices[surface.triangles[t][1]] - x;
    const Vec3 c = surface.vertices[surface.triangles[t][2]] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::acos(-1.));
}

/// The components of a closed surface that bound the shape of the skeleton: those that hold a node of it. Bubbles
/// outside and cavities come from data that contradict the skeleton.
inline Surface_triangles components_with_skeleton(const Surface_triangles& surface,
                                                  const Skeleton_graph& skeleton)
{
  Disjoint_sets sets(surface.vertices.size());
  for(const auto& t : surface.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<std::vector<std::size_t> > triangles(surface.vertices.size());
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    triangles[sets.find(surface.triangles[t][0])].push_back(t);

  constexpr double inside = 0.5;
  std::vector<char> keep(surface.vertices.size(), 0);
  for(std::size_t v = 0; v < triangles.size(); ++v)
    for(std::size_t i = 0; i < skeleton.nodes.size() && !triangles[v].empty() && !keep[v]; ++i)
      keep[v] = skeleton.nodes[i].radius > 0 &&
                winding_number(surface, triangles[v], skeleton.nodes[i].position) > inside;

  Surface_triangles result;
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> index(surface.vertices.size(), none);
  for(const auto& t : surface.triangles) {
    if(!keep[sets.find(t[0])])
      continue;
    std::array<std::size_t, 3> corners;
    for(std::size_t k = 0; k < 3; ++k) {
      if(index[t[k]] == none) {
        index[t[k]] = result.vertices.size();
        result.vertices.push_back(surface.vertices[t[k]]);
      }
      corners[k] = index[t[k]];
    }
    result.triangles.push_back(corners);
  }
  return result;
}

/// Points and skeleton in local coordinates; `normals` and `is_constraint` as in the field. The surface may be
/// empty, if the resolution is too low for the skeleton's radii.
inline Surface_triangles reconstruct_from_skeleton(Execution& execution, const Points& points,
                                                   const Points& normals, Skeleton_graph skeleton,
                                                   const std::vector<char>& is_constraint,
                                                   const Field_parameters& parameters)
{
  {
    Stage stage(execution, "radii", 0.02);
    complete_radii(skeleton, points);
  }
  Distance_field field;
  {
    Stage stage(execution, "field", 0.88);
    field = Signed_distance_field(execution, points, normals, skeleton, is_constraint, parameters)
              .compute(stage);
  }
  Stage stage(execution, "surface", 0.1);
  const auto surface_of_field = [&] {
    Surface_triangles surface = Marching_tetrahedra(field.lattice, field.values).run();
    for(Vec3& v : surface.vertices)
      v = field.frame.to_world(v);
    return components_with_skeleton(surface, skeleton);
  };
  if(parameters.removed_handles > 0)
    Handle_removal(field.lattice, field.values, parameters.removed_handles)
      .run(double(number_of_cycles(skeleton)), [&] { return genus_of(surface_of_field()); });
  return surface_of_field();
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_SURFACE_H
