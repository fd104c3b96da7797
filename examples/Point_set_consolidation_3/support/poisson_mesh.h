// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_POISSON_MESH_H
#define CONSOLIDATION_SUPPORT_POISSON_MESH_H

#include "types.h"

#include <cstddef>
#include <vector>

namespace support {

/// Lengths are multiples of `spacing`. The defaults are those of
/// `CGAL::poisson_surface_reconstruction_delaunay()`.
struct Poisson_options {
  double angle = 20;        ///< lower bound of the facets' angles, in degrees
  double radius = 30;       ///< upper bound of the radii of the facets' Delaunay balls
  double distance = 0.375;  ///< upper bound of the distance between facet and iso-surface
  double spacing
      = 0;  ///< unit of the lengths; 0: average spacing of the points to their 6 neighbours
  std::size_t seeds = 500;  ///< initial points of the mesher, spread over the iso-surface
};

/// Poisson reconstruction: the implicit function is CGAL's, and so is the surface mesher; what is
/// added makes the result depend on the points only.
///
/// - All components of the iso-surface that carry data are meshed, whatever their size and place: a
/// component carries
///   data if it passes within 0.75 spacings of an input point. The others, blobs far from the scan,
///   are dropped.
/// - The mesh is a closed, orientable 2-manifold. Normals point to where the implicit function is
/// positive: outer
///   boundaries of the solid are oriented outwards (positive volume), the boundary of a cavity
///   inwards (negative volume). A cavity is kept if it carries data.
/// - Repeated calls return the same mesh bit for bit, and neither the unit nor the offset of the
/// points matters.
///
/// If the mesher fails, which happens on sets with many outliers, it starts again from fewer seeds;
/// if it still fails the iso-surface is taken from the tetrahedra of the implicit function, closed
/// and manifold but with less regular triangles.
///
/// \throws Method_error if the points or normals cannot be used (fewer than 4 distinct points,
/// different numbers of
///         points and normals, a coordinate that is not finite, a normal of length zero) or if
///         there is no surface.
Triangle_mesh poisson_mesh(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                           const Poisson_options& options = {});

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_POISSON_MESH_H
