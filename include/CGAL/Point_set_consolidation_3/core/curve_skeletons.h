// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_triangles.h>

#include <iosfwd>
#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Curve skeletons: their extraction, editing and files, and the surfaces that they drive. Graphs and points are in the
/// caller's coordinates.

struct Skeleton_edit {
  enum Kind {
    MOVE, SET_RADIUS, CONNECT, DISCONNECT, DELETE_BRANCH, DELETE_CYCLE, COLLAPSE_CYCLE, PRUNE_SPURS, EXTEND_TIPS,
    INTERPOLATE, INTERPOLATE_UNKNOWN, BRIDGE
  };
  Kind kind;
  std::size_t a = 0, b = 0;   ///< nodes
  double length = 0;          ///< or radius
  Vec3 position = Vec3::Zero();
};

/// Returns the number of edges that a BRIDGE adds, 0 for other edits.
std::size_t edit(Skeleton_graph& graph, const Skeleton_edit& edit);
/// Edits of a text.
void edit(Skeleton_graph& graph, std::istream& edits);

void write_ply(std::ostream& out, const Skeleton_graph& graph);
/// CGAL's text format: a line per polyline, the number of points, then their coordinates. An isolated node is
/// a polyline of one point.
void write_polylines(std::ostream& out, const Skeleton_graph& graph);
/// Throws `std::runtime_error` if the file is no skeleton.
Skeleton_graph read_skeleton(std::istream& in);

class Laplacian_skeletonization;

/// The steps of the Laplacian contraction paper; a step runs those before it and throws `Cancelled` if the callback
/// wants to stop.
class Laplacian_extraction {
public:
  /// `references`: what the nodes' lists of points mean; empty: `points`.
  Laplacian_extraction(Execution execution, const Points& points, const Points& normals, const Points& references,
                       const Laplacian_skeleton_parameters& parameters);
  ~Laplacian_extraction();
  Laplacian_extraction(Laplacian_extraction&& other) noexcept;
  Laplacian_extraction& operator=(Laplacian_extraction&& other) noexcept;

  bool contract_geometry();     ///< one iteration; returns whether another one makes sense
  void contract_until_convergence();
  void build_graph();
  void thin();
  void recentre();
  void extend_tips();

  Execution& execution();
  const Execution& execution() const;
  std::size_t number_of_iterations() const;
  double initial_contraction_weight() const;
  Points contracted_points() const;
  Skeleton_graph skeleton() const;

private:
  std::unique_ptr<Laplacian_skeletonization> m;
};

/// Points spread evenly over the triangles of a soup: random points, many more than wanted, of which distant ones are
/// kept.
Points sample_triangles(const Points& vertices, const std::vector<std::array<std::size_t, 3> >& triangles,
                        std::size_t count, std::uint64_t seed);

/// L1-medial skeleton of all points or, if there are labels in [0, segments), of each segment.
Skeleton_graph extract_l1_skeleton(Execution& execution, const Points& points,
                                   const std::vector<std::size_t>& labels, std::size_t segments,
                                   const L1_medial_parameters& parameters);

/// Section V of the Laplacian contraction paper; no triangles: no surface. Throws `Unusable_input` if all points are
/// equal.
Surface_triangles reconstruct_around_skeleton(Execution& execution, const Points& points,
                                              const Skeleton_graph& skeleton, const Field_parameters& parameters);

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/curve_skeletons_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_H
