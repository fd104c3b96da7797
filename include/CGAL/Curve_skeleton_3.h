// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVE_SKELETON_3_H
#define CGAL_CURVE_SKELETON_3_H

#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

#include <CGAL/number_utils.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgPointSetConsolidation3Skeletons

The vertex property of `Curve_skeleton_3`.

\tparam Kernel a model of `Kernel`
*/
template <typename Kernel>
struct Curve_skeleton_vertex_3
{
  /// position, in the unit of the input
  typename Kernel::Point_3 point;
  /// distance to the surface, in the unit of the input; 0 where it is not known, and at tips that were
  /// extended to the surface
  typename Kernel::FT radius = typename Kernel::FT(0);
  /// indices of the input points that the vertex stands for, in increasing order
  std::vector<std::size_t> points;
};

/*!
\ingroup PkgPointSetConsolidation3Skeletons

A curve skeleton: a graph embedded in space, whose vertices know the radius of the shape around them and
the input points they stand for. It is a Boost graph of the same shape as the skeleton of
`CGAL::Mean_curvature_flow_skeletonization`, so that what works on that one works on this one as well, for
instance `CGAL::split_graph_into_polylines()`. The bundled vertex property is `Curve_skeleton_vertex_3`:

\code{.cpp}
Curve_skeleton_3<Kernel> skeleton;
for(auto v : CGAL::make_range(vertices(skeleton)))
  std::cout << skeleton[v].point << " " << skeleton[v].radius << "\n";
\endcode

\tparam Kernel a model of `Kernel`
*/
template <typename Kernel>
using Curve_skeleton_3 = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                               Curve_skeleton_vertex_3<Kernel> >;

/// \cond SKIP_IN_MANUAL
namespace Point_set_consolidation_3 {
namespace internal {

template <typename Kernel>
Skeleton_graph to_skeleton_graph(const Curve_skeleton_3<Kernel>& skeleton)
{
  Skeleton_graph graph;
  graph.nodes.resize(num_vertices(skeleton));
  for(std::size_t v = 0; v < graph.nodes.size(); ++v) {
    const Curve_skeleton_vertex_3<Kernel>& vertex = skeleton[v];
    graph.nodes[v].position =
      Vec3(CGAL::to_double(vertex.point.x()), CGAL::to_double(vertex.point.y()),
           CGAL::to_double(vertex.point.z()));
    graph.nodes[v].radius = CGAL::to_double(vertex.radius);
    graph.nodes[v].points = vertex.points;
  }
  std::set<Skeleton_edge> known;  // `add_edge()` would look through all edges each time
  const auto range = edges(skeleton);
  for(auto e = range.first; e != range.second; ++e) {
    const std::size_t v = source(*e, skeleton), w = target(*e, skeleton);
    const Skeleton_edge edge = {(std::min)(v, w), (std::max)(v, w)};
    if(v != w && known.insert(edge).second)
      graph.edges.push_back(edge);
  }
  return graph;
}

template <typename Kernel>
void assign(Curve_skeleton_3<Kernel>& skeleton, const Skeleton_graph& graph)
{
  typedef typename Kernel::FT FT;
  Curve_skeleton_3<Kernel> result(graph.nodes.size());
  for(std::size_t v = 0; v < graph.nodes.size(); ++v) {
    const Vec3& p = graph.nodes[v].position;
    result[v].point = typename Kernel::Point_3(FT(p.x()), FT(p.y()), FT(p.z()));
    result[v].radius = FT(graph.nodes[v].radius);
    result[v].points = graph.nodes[v].points;
  }
  for(const Skeleton_edge& e : graph.edges)
    add_edge(e[0], e[1], result);
  skeleton = std::move(result);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
/// \endcond

/*!
\ingroup PkgPointSetConsolidation3Skeletons

returns the number of connected components of a skeleton.
*/
template <typename Kernel>
std::size_t number_of_skeleton_components(const Curve_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  return internal::number_of_components(internal::to_skeleton_graph<Kernel>(skeleton));
}

/*!
\ingroup PkgPointSetConsolidation3Skeletons

returns the number of independent cycles of a skeleton, which is the genus of the shape it describes.
*/
template <typename Kernel>
std::size_t number_of_skeleton_cycles(const Curve_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  return internal::number_of_cycles(internal::to_skeleton_graph<Kernel>(skeleton));
}
/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  Edits of curve skeletons (section V and figure 14 of \cgalCite{cgal:ctowz-pcsvl-10}). Vertices are named by their
  descriptors, which are numbers from 0. Functions that remove vertices renumber the others, in their
  order. Wrong arguments are `std::invalid_argument`, the skeleton is then unchanged. Each edit copies the skeleton, so
  that it takes at least linear time; a text of edits, `apply_edits()`, copies it once.
*/
namespace Curve_skeleton_editing {

/// \cond SKIP_IN_MANUAL
namespace internal {

namespace core = Point_set_consolidation_3::internal;

typedef core::Skeleton_edit Edit;

template <typename Kernel>
std::size_t edit(Curve_skeleton_3<Kernel>& skeleton, const Edit& edit)
{
  core::Skeleton_graph graph = core::to_skeleton_graph<Kernel>(skeleton);
  const std::size_t added = core::edit(graph, edit);
  core::assign<Kernel>(skeleton, graph);
  return added;
}

}  // namespace internal
/// \endcond

/// adds a vertex; returns its descriptor.
template <typename Kernel>
std::size_t add_vertex(Curve_skeleton_3<Kernel>& skeleton, const typename Kernel::Point_3& point,
                       typename Kernel::FT radius)
{
  const std::size_t v = boost::add_vertex(skeleton);
  skeleton[v].point = point;
  skeleton[v].radius = radius;
  return v;
}

/// moves a vertex.
template <typename Kernel>
void move_vertex(Curve_skeleton_3<Kernel>& skeleton, std::size_t v,
                 const typename Kernel::Point_3& point)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::MOVE, v, 0, 0,
                                          {CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                                           CGAL::to_double(point.z())}});
}

/// sets the radius of a vertex, in the unit of the skeleton; not negative, 0 if it is not known.
template <typename Kernel>
void set_radius(Curve_skeleton_3<Kernel>& skeleton, std::size_t v, typename Kernel::FT radius)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::SET_RADIUS, v, 0, CGAL::to_double(radius)});
}

/// adds an edge, if there is none yet.
template <typename Kernel>
void connect(Curve_skeleton_3<Kernel>& skeleton, std::size_t v, std::size_t w)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::CONNECT, v, w});
}

/// removes an edge.
template <typename Kernel>
void disconnect(Curve_skeleton_3<Kernel>& skeleton, std::size_t v, std::size_t w)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::DISCONNECT, v, w});
}

/// removes the chain of vertices that `v` is on, up to the branch vertices at its ends.
template <typename Kernel>
void delete_branch(Curve_skeleton_3<Kernel>& skeleton, std::size_t v)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::DELETE_BRANCH, v});
}

/// opens the shortest cycle through `v`: removes the chain of vertices that `v` is on or, if `v` is a branch vertex,
/// the longest edge of the cycle.
template <typename Kernel>
void delete_cycle(Curve_skeleton_3<Kernel>& skeleton, std::size_t v)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::DELETE_CYCLE, v});
}

/// merges the shortest cycle through `v` to one vertex.
template <typename Kernel>
void collapse_cycle(Curve_skeleton_3<Kernel>& skeleton, std::size_t v)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::COLLAPSE_CYCLE, v});
}

/// removes branches that end in a tip and are shorter than `length`, the shortest first.
template <typename Kernel>
void prune_spurs(Curve_skeleton_3<Kernel>& skeleton, typename Kernel::FT length)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::PRUNE_SPURS, 0, 0, CGAL::to_double(length)});
}

/// continues tips by their radius, to new vertices of radius 0.
template <typename Kernel>
void extend_tips(Curve_skeleton_3<Kernel>& skeleton)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::EXTEND_TIPS});
}

/// sets the radii between two vertices, along the shortest path, from theirs.
template <typename Kernel>
void interpolate_radii(Curve_skeleton_3<Kernel>& skeleton, std::size_t v, std::size_t w)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::INTERPOLATE, v, w});
}

/// sets the radii of all vertices with radius 0, other than tips, from those around them: harmonically along the
/// skeleton.
template <typename Kernel>
void interpolate_radii(Curve_skeleton_3<Kernel>& skeleton)
{
  internal::edit(skeleton, internal::Edit{internal::Edit::INTERPOLATE_UNKNOWN});
}

/// joins components by edges between their closest vertices, the shortest first, as long as the edges are not longer
/// than `longest`.
/// \return the number of edges added
template <typename Kernel>
std::size_t bridge_components(Curve_skeleton_3<Kernel>& skeleton, typename Kernel::FT longest)
{
  return internal::edit(skeleton, internal::Edit{internal::Edit::BRIDGE, 0, 0, CGAL::to_double(longest)});
}

/*!
applies edits from a text, so that a repair can be kept and repeated. One edit per line, `#` begins a comment.
Vertices have their numbers in the skeleton as it is given, whatever is removed before; added ones have the next
numbers:

    move V X Y Z          connect V W         remove V             radius V R
    add X Y Z [R]         disconnect V W      delete_branch V      scale_radii FACTOR
    prune LENGTH          bridge LENGTH       delete_cycle V       interpolate [V W]
    extend_tips                               collapse_cycle V

\throws std::invalid_argument if an edit cannot be applied; the message names the line, the skeleton is unchanged.
*/
template <typename Kernel>
void apply_edits(Curve_skeleton_3<Kernel>& skeleton, std::istream& edits)
{
  internal::core::Skeleton_graph graph = internal::core::to_skeleton_graph<Kernel>(skeleton);
  internal::core::edit(graph, edits);
  internal::core::assign<Kernel>(skeleton, graph);
}

}  // namespace Curve_skeleton_editing

namespace IO {

/*!
\ingroup PkgPointSetConsolidation3Skeletons

writes a skeleton to a stream, as an ASCII PLY file with vertices `x y z radius` and
`element edge` with `vertex1 vertex2`. The points that the vertices stand for are not written.

\return `true` if writing was successful
*/
template <typename Kernel>
bool write_curve_skeleton_PLY(std::ostream& out, const Curve_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  internal::write_ply(out, internal::to_skeleton_graph<Kernel>(skeleton));
  return bool(out);
}

/*!
\ingroup PkgPointSetConsolidation3Skeletons

writes a skeleton to a file, as a PLY file with edges, or, if the name ends with `.polylines.txt` or `.cgal`, in
CGAL's text format for polylines: a line for each polyline, with the number of its points and their coordinates.

\return `true` if writing was successful
*/
template <typename Kernel>
bool write_curve_skeleton(const std::string& name, const Curve_skeleton_3<Kernel>& skeleton)
{
  namespace internal = Point_set_consolidation_3::internal;
  const auto ends_with = [&](const std::string& end) {
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  std::ofstream out(name);
  const internal::Skeleton_graph graph = internal::to_skeleton_graph<Kernel>(skeleton);
  if(ends_with(".polylines.txt") || ends_with(".cgal"))
    internal::write_polylines(out, graph);
  else
    internal::write_ply(out, graph);
  out.flush();
  return bool(out);
}

/*!
\ingroup PkgPointSetConsolidation3Skeletons

reads a skeleton from a PLY stream, ASCII or binary, with `element vertex` (`x y z`, and `radius` if there is
one) and `element edge` (`vertex1 vertex2`). Other elements and properties are passed over.

\return `true` if reading was successful; otherwise `skeleton` is as it was, and `message`, if given, tells
why
*/
template <typename Kernel>
bool read_curve_skeleton_PLY(std::istream& in, Curve_skeleton_3<Kernel>& skeleton,
                             std::string* message = nullptr)
{
  namespace internal = Point_set_consolidation_3::internal;
  try {
    internal::assign<Kernel>(skeleton, internal::read_skeleton(in));
    return true;
  }
  catch(const std::runtime_error& error) {
    if(message != nullptr)
      *message = error.what();
    return false;
  }
}

/*!
\ingroup PkgPointSetConsolidation3Skeletons

reads a skeleton from a PLY file, see `read_curve_skeleton_PLY()`.
*/
template <typename Kernel>
bool read_curve_skeleton(const std::string& name, Curve_skeleton_3<Kernel>& skeleton,
                         std::string* message = nullptr)
{
  std::ifstream in(name, std::ios::binary);
  if(!in) {
    if(message != nullptr)
      *message = "cannot open " + name;
    return false;
  }
  return read_curve_skeleton_PLY<Kernel>(in, skeleton, message);
}

}  // namespace IO
}  // namespace CGAL

#endif  // CGAL_CURVE_SKELETON_3_H
