// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESO_SKELETON_TO_GRAPH_H
#define CGAL_MESO_SKELETON_TO_GRAPH_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/Point_set_consolidation_3/core/meso_skeleton.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Ref

  A meso-skeleton \cgalCite{cgal:wshcl-dpc-15} as an object: curves where the shape is tubular, sheets where it
  is flat, and what is known of each inner point.

  \tparam Kernel a model of `Kernel`.
*/
template <typename Kernel>
struct Meso_skeleton_3 {
  /// curve, sheet, end or unanchored
  typedef Point_set_consolidation_3::Meso_label Label;
  /// number type of the coordinates
  typedef typename Kernel::FT FT;

  /// All vertices, those of sheets too, with their radii and the deep points they stand for. The edges are
  /// those of curves and those that join curves and sheets.
  Curve_skeleton_3<Kernel> graph;
  /// Triangles of the sheets, as descriptors of vertices.
  std::vector<std::array<std::size_t, 3> > triangles;
  /// What each vertex is.
  std::vector<Label> vertex_labels;
  /// What each inner point is, in the order of the deep points.
  std::vector<Label> labels;
  /// The distance of each inner point to the consolidated points, in the unit of the input.
  std::vector<FT> radii;
};

/// \cond SKIP_IN_MANUAL
namespace Point_set_consolidation_3 {
namespace internal {

template <typename Kernel>
Meso_graph to_meso_graph(const Meso_skeleton_3<Kernel>& skeleton)
{
  Meso_graph meso;
  meso.graph = to_skeleton_graph<Kernel>(skeleton.graph);
  meso.triangles = skeleton.triangles;
  meso.node_labels = skeleton.vertex_labels;
  meso.node_labels.resize(meso.graph.nodes.size(), Meso_label::CURVE);
  for(const Sheet_triangle& t : meso.triangles)
    for(const std::size_t v : t)
      require(v < meso.graph.nodes.size(), "Meso_skeleton_3", "a triangle has no such vertex");
  return meso;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
/// \endcond

/// \ingroup PkgPointSetConsolidation3Ref
/// returns the number of connected components, curves and sheets together.
template <typename Kernel>
std::size_t number_of_components(const Meso_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  const internal::Meso_graph meso = internal::to_meso_graph<Kernel>(skeleton);
  return internal::topology_of(meso.graph, meso.triangles).components;
}

/// \ingroup PkgPointSetConsolidation3Ref
/// returns the number of independent cycles, curves and sheets together: the genus of the shape. Cycles on a sheet go
/// around its holes.
template <typename Kernel>
std::size_t number_of_cycles(const Meso_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  const internal::Meso_graph meso = internal::to_meso_graph<Kernel>(skeleton);
  return internal::topology_of(meso.graph, meso.triangles).cycles;
}

/// \ingroup PkgPointSetConsolidation3Ref
/// returns the number of sheets: parts that are connected through common vertices of triangles.
template <typename Kernel>
std::size_t number_of_sheets(const Meso_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  const internal::Meso_graph meso = internal::to_meso_graph<Kernel>(skeleton);
  return internal::topology_of(meso.graph, meso.triangles).sheets;
}

/*!
  \ingroup PkgPointSetConsolidation3Ref

  turns the meso-skeleton of section 4.2 of \cgalCite{cgal:wshcl-dpc-15} into curves and sheets.

  An inner point is on a sheet if the normals of the surface around its anchor are nearly parallel to one line (mean
  squared cosine above 0.75), in a region at least twice as wide as thick; the region's rim belongs to it.
  Sheets are triangulated between the means of groups of anchors, which cover them up to their rims. All other inner
  points are sampled and thinned to curves as in section III.B of \cgalCite{cgal:ctowz-pcsvl-10}, where groups are
  connected if their outer points are neighbours on the surface: nothing is joined across space. Where a curve and a
  sheet touch on the surface, an edge joins them. Cycles that do not go around a hole of the shape (a disc that spans
  them stays inside of it) are filled with triangles, those of curves with few vertices are merged.

  With `curves_only` the result is an ordinary curve skeleton: the anchors are contracted as in section III.A of
  \cgalCite{cgal:ctowz-pcsvl-10}, which draws sheets together, and thinned; no triangle is made. On scans from one to
  three sides it has far fewer false cycles and branches than the contraction of the points themselves.

  Points whose depth is a guess because nothing opposes them are part of the graph and labelled so.

  Complexity: \f$O(n \log n + n m)\f$ for \f$n\f$ deep points and \f$m\f$ vertices; 0.1 seconds for 4000 deep points.
  The result is the same, bit for bit, for any `ConcurrencyTag`, and moves with the input.

  \tparam Traits a model of `Kernel`, floating point coordinates.
  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.

  \param consolidation the deep points; stages up to `form_meso_skeleton()` are run if they have not been.
  \param skeleton receives the result; unchanged if the callback of `consolidation` cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{sampling_radius}
      \cgalParamDescription{distance of the vertices before thinning, as a share of the diagonal of the bounding box of
        the consolidated points, in [0.001, 1]; not less than twice their spacing is used}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.02}
    \cgalParamNEnd
    \cgalParamNBegin{largest_merged_cycle}
      \cgalParamDescription{cycles of curves with at most so many vertices (twice as many with `curves_only`) are
        merged to one, unless they go around a hole of the shape; 0 keeps all cycles, those of sheets too}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{6}
    \cgalParamNEnd
    \cgalParamNBegin{curves_only}
      \cgalParamDescription{whether sheets are contracted to curves}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{extend_tips}
      \cgalParamDescription{whether curves are extended to the end of the shape, to a vertex of radius 0 and without
        points}
      \cgalParamType{Boolean}
      \cgalParamDefault{the value of `curves_only`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `false` if the callback of `consolidation` cancelled, `true` otherwise.
  \throws std::invalid_argument if a parameter is out of its range; the message names it.
*/
template <typename Traits, typename ConcurrencyTag,
          typename NamedParameters = parameters::Default_named_parameters>
bool meso_skeleton_to_graph(Deep_points_consolidation_3<Traits, ConcurrencyTag>& consolidation,
                            Meso_skeleton_3<Traits>& skeleton,
                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_consolidation_3::internal;
  typedef typename Traits::FT FT;
  const char* const function = "meso_skeleton_to_graph";
  const auto cgal_np = internal::cgal_np(np);
  internal::Meso_graph_parameters parameters;
  parameters.sampling_radius =
    internal::positive(function, cgal_np, Point_set_consolidation_3::internal_np::sampling_radius,
                       "sampling_radius", parameters.sampling_radius);
  internal::require(parameters.sampling_radius >= 0.001 && parameters.sampling_radius <= 1, function,
                    "sampling_radius must be in [0.001, 1]");
  parameters.largest_merged_cycle = internal::parameter_or(
    cgal_np, Point_set_consolidation_3::internal_np::largest_merged_cycle,
    parameters.largest_merged_cycle);
  parameters.curves_only = internal::parameter_or(
    cgal_np, Point_set_consolidation_3::internal_np::curves_only, parameters.curves_only);
  parameters.extend_tips = internal::parameter_or(
    cgal_np, Point_set_consolidation_3::internal_np::extend_tips, parameters.curves_only);
  if(!consolidation.form_meso_skeleton())
    return false;

  // relative to a point of S, so that large coordinates cost no digits
  internal::Frame frame;
  frame.unit = consolidation.spacing();
  if(!(frame.unit > 0))
    frame.unit = 1;
  frame.origin = internal::to_vec3(consolidation.consolidated_point(0));
  internal::Meso_shape shape;
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    shape.outer.push_back(frame.to_local(internal::to_vec3(consolidation.consolidated_point(i))));
    shape.normals.push_back(internal::to_vec3(consolidation.consolidated_normal(i)));
    shape.anchors.push_back(frame.to_local(internal::to_vec3(consolidation.anchor_point(i))));
    shape.skeletal.push_back(frame.to_local(internal::to_vec3(consolidation.skeletal_point(i))));
    shape.is_unanchored.push_back(consolidation.anchoring(i) == Point_set_consolidation_3::Anchoring::unanchored);
  }
  const internal::Execution execution = internal::make_execution<ConcurrencyTag>();
  internal::Meso_graph meso = internal::build_meso_graph(execution, shape, parameters);

  internal::assign<Traits>(skeleton.graph, internal::to_world(std::move(meso.graph), frame));
  skeleton.triangles = std::move(meso.triangles);
  skeleton.vertex_labels = std::move(meso.node_labels);
  skeleton.labels = std::move(meso.labels);
  skeleton.radii.clear();
  for(const double radius : meso.radii)
    skeleton.radii.push_back(FT(frame.unit * radius));
  return true;
}

namespace IO {

/*!
  \ingroup PkgPointSetConsolidation3Ref

  writes a meso-skeleton to a file whose name ends with
  - `.ply`: vertices `x y z radius label`, `element edge` with `vertex1 vertex2` (curves), `element face`;
    `read_curve_skeleton()` reads its curves;
  - `.obj`: vertices, lines (curves) and faces;
  - `.ma`: the numbers of vertices, edges and faces, then `v x y z r`, `e` (curves and sides of triangles) and `f`,
    indices from 0.

  Labels are 0 for a curve, 1 for a sheet, 2 for an end, 3 for unanchored.

  \return `true` if writing was successful.
  \throws std::invalid_argument if the name ends with none of these, or a triangle has no such vertex.
*/
template <typename Kernel>
bool write_meso_skeleton(const std::string& name, const Meso_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  const auto ends_with = [&](const std::string& end) {
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  const bool is_ply = ends_with(".ply"), is_obj = ends_with(".obj");
  internal::require(is_ply || is_obj || ends_with(".ma"), "write_meso_skeleton",
                    "the name must end with .ply, .obj or .ma");
  const internal::Meso_graph meso = internal::to_meso_graph<Kernel>(skeleton);
  std::ofstream out(name);
  internal::write(out, meso, is_ply   ? internal::Meso_format::PLY
                             : is_obj ? internal::Meso_format::OBJ
                                      : internal::Meso_format::MA);
  out.flush();
  return bool(out);
}

}  // namespace IO
}  // namespace CGAL

#endif  // CGAL_MESO_SKELETON_TO_GRAPH_H
