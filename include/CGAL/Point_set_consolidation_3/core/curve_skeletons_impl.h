// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Point_set_consolidation_3/internal/l1_medial.h>
#include <CGAL/Point_set_consolidation_3/internal/l1_medial_segments.h>
#include <CGAL/Point_set_consolidation_3/internal/laplacian_skeleton.h>
#include <CGAL/Point_set_consolidation_3/internal/random_points_on_triangles.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_edits.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_io.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_surface.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

#include <ostream>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t edit(Skeleton_graph& graph, const Skeleton_edit& edit)
{
  Skeleton_editor editor(graph);
  std::size_t added = 0;
  switch(edit.kind) {
    case Skeleton_edit::MOVE: editor.move(edit.a, edit.position); break;
    case Skeleton_edit::SET_RADIUS: editor.set_radius(edit.a, edit.length); break;
    case Skeleton_edit::CONNECT: editor.connect(edit.a, edit.b); break;
    case Skeleton_edit::DISCONNECT: editor.disconnect(edit.a, edit.b); break;
    case Skeleton_edit::DELETE_BRANCH: editor.delete_branch(edit.a); break;
    case Skeleton_edit::DELETE_CYCLE: editor.delete_cycle(edit.a); break;
    case Skeleton_edit::COLLAPSE_CYCLE: editor.collapse_cycle(edit.a); break;
    case Skeleton_edit::PRUNE_SPURS: editor.prune_spurs(edit.length); break;
    case Skeleton_edit::EXTEND_TIPS: editor.extend_tips(); break;
    case Skeleton_edit::INTERPOLATE: editor.interpolate(edit.a, edit.b); break;
    case Skeleton_edit::INTERPOLATE_UNKNOWN: editor.interpolate_unknown(); break;
    case Skeleton_edit::BRIDGE: added = editor.bridge(edit.length); break;
  }
  graph = editor.result();
  return added;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void edit(Skeleton_graph& graph, std::istream& edits)
{
  Skeleton_editor editor(graph);
  apply_edits(edits, editor);
  graph = editor.result();
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void write_ply(std::ostream& out, const Skeleton_graph& graph) { write_skeleton_ply(out, graph); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void write_polylines(std::ostream& out, const Skeleton_graph& graph) { write_skeleton_polylines(out, graph); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Skeleton_graph read_skeleton(std::istream& in) { return Ply_skeleton_reader(in).read(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Laplacian_extraction::Laplacian_extraction(Execution execution, const Points& points, const Points& normals,
                                           const Points& references,
                                           const Laplacian_skeleton_parameters& parameters)
  : m(new Laplacian_skeletonization(std::move(execution), points, normals, references, parameters))
{}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Laplacian_extraction::~Laplacian_extraction() = default;

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Laplacian_extraction::Laplacian_extraction(Laplacian_extraction&& other) noexcept = default;

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Laplacian_extraction& Laplacian_extraction::operator=(Laplacian_extraction&& other) noexcept = default;

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Laplacian_extraction::contract_geometry() { return m->contract_geometry(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void Laplacian_extraction::contract_until_convergence() { m->contract_until_convergence(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void Laplacian_extraction::build_graph() { m->build_graph(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void Laplacian_extraction::thin() { m->thin(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void Laplacian_extraction::recentre() { m->recentre(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
void Laplacian_extraction::extend_tips() { m->extend_tips(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Execution& Laplacian_extraction::execution() { return m->execution(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
const Execution& Laplacian_extraction::execution() const { return m->execution(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::size_t Laplacian_extraction::number_of_iterations() const { return m->number_of_iterations(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
double Laplacian_extraction::initial_contraction_weight() const { return m->initial_contraction_weight(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Points Laplacian_extraction::contracted_points() const { return m->contracted_points(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Skeleton_graph Laplacian_extraction::skeleton() const { return m->skeleton(); }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Points sample_triangles(const Points& vertices, const std::vector<std::array<std::size_t, 3> >& triangles,
                        std::size_t count, std::uint64_t seed)
{
  constexpr std::size_t surplus = 6;  // enough for `spread_points()` to choose evenly
  const Points candidates = random_points_on_triangles(vertices, triangles, surplus * count, seed);
  return candidates.empty() ? candidates : selected(candidates, spread_points(candidates, count));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Skeleton_graph extract_l1_skeleton(Execution& execution, const Points& points,
                                   const std::vector<std::size_t>& labels, std::size_t segments,
                                   const L1_medial_parameters& parameters)
{
  return segments == 0 ? l1_medial_skeleton(execution, 1, points, parameters)
                       : l1_medial_skeleton_of_segments(execution, points, labels, segments, parameters);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Surface_triangles reconstruct_around_skeleton(Execution& execution, const Points& points,
                                              const Skeleton_graph& skeleton, const Field_parameters& parameters)
{
  // the frame keeps lengths near one
  const Bounding_box box = bounding_box(points);
  Frame frame;
  frame.origin = box.centre();
  frame.unit = box.sides().maxCoeff();
  if(!(frame.unit > 0))
    throw Unusable_input("all points are equal");
  Surface_triangles surface = reconstruct_from_skeleton(execution, frame.to_local(points), Points(),
                                                        to_local(skeleton, frame), {}, parameters);
  surface.vertices = frame.to_world(std::move(surface.vertices));
  return surface;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_CURVE_SKELETONS_IMPL_H
