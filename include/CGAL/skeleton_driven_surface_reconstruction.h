// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SKELETON_DRIVEN_SURFACE_RECONSTRUCTION_H
#define CGAL_SKELETON_DRIVEN_SURFACE_RECONSTRUCTION_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>
#include <CGAL/Point_set_consolidation_3/parameters.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Surfaces

  reconstructs a closed surface from a point set and a curve skeleton of its shape, section V of
  \cgalCite{cgal:ctowz-pcsvl-10}.

  The surface is the zero set of a signed distance field that is smooth, vanishes at the points, equals minus the
  radius on the skeleton and is positive far from it (equation (3)). Where data are missing, the surface is that of the
  skeleton and its radii; its topology can be repaired by editing the skeleton, see `Curve_skeleton_editing`. No
  normals are needed. Where data are complete, a reconstruction from oriented points is more accurate.

  The mesh is closed and oriented outwards. It has one component if the skeleton has one and the resolution
  suffices: cells should be no larger than 2/3 of the smallest radius. Components without a vertex of the
  skeleton inside, and cavities, are left out.

  The field is solved on an octree by default, which is fine only near points, skeleton and surface, level by
  level; complexity is \f$O(a R^2)\f$ for resolution R and a surface as large as \f$a\f$ faces of the points' box.
  On a regular grid (`adaptive(false)`), by a multigrid solver, it is \f$O(R^3)\f$.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam Kernel a model of `Kernel`, floating point coordinates.
  \tparam TriangleMesh a model of `MutableFaceGraph` with a writable vertex point map.

  \param points at least 4 points with finite coordinates.
  \param skeleton a skeleton with at least one vertex. Vertices with a positive radius keep it. Radii of others are
  estimated: by the nearest point where points surround the vertex, otherwise by interpolation along the skeleton. A
  tip of radius 0 is taken to lie on the surface if other vertices have radii.
  \param mesh receives the surface; unchanged if the callback cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{grid_resolution}
      \cgalParamDescription{number of cells along the longest side of the points' and the skeleton's box, in [8, 1024]}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{64, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{adaptive}
      \cgalParamDescription{whether the domain is an octree; otherwise a regular grid}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{smoothness_weight}
      \cgalParamDescription{\f$\omega_1\f$, of the second derivatives of the field, for lengths in units of the finest
        cells; not negative}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{1}
    \cgalParamNEnd
    \cgalParamNBegin{surface_weight}
      \cgalParamDescription{\f$\omega_2\f$, of the points; all points of a cell together have this weight}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{50: the paper's 5 is too smooth in these units; less for noisy data}
    \cgalParamNEnd
    \cgalParamNBegin{skeleton_weight}
      \cgalParamDescription{\f$\omega_3\f$, of samples of the skeleton, 0.01 diagonals apart}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.5, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{outside_weight}
      \cgalParamDescription{\f$\omega_4\f$, of nodes far from the skeleton. 0.05 with an `outside_factor` of 2 is
        more accurate if all radii are right, and eats thin parts if they are not}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.005, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{outside_factor}
      \cgalParamDescription{\f$K\f$, multiple of its radius from which on a place is far from the skeleton; at least
        1. On a regular grid only as far as the grid reaches, 0.15 times the longest side beyond the data}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{4, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{stage_times}
      \cgalParamDescription{receives name, seconds and iterations of each stage}
      \cgalParamType{`std::reference_wrapper` of a `std::vector<Point_set_consolidation_3::Stage_time>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{the kernel of the points}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `false` if the callback cancelled, `true` otherwise.
  \throws std::invalid_argument if there are too few points, the skeleton has no vertex, a coordinate is not
  finite or a parameter is out of its range; the message names it.
  \throws std::runtime_error if there is no surface, because no radius is large enough for the resolution, or the
  equations cannot be solved.
*/
template <typename ConcurrencyTag, typename PointRange, typename Kernel, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
bool skeleton_driven_surface_reconstruction(
  const PointRange& points, const Curve_skeleton_3<Kernel>& skeleton, TriangleMesh& mesh,
  const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  const char* const f = "skeleton_driven_surface_reconstruction";
  const auto& cgal = cgal_np(np);

  constexpr std::size_t least_points = 4;
  const Points positions = copy_points(f, points, cgal, least_points);
  const Skeleton_graph graph = to_skeleton_graph<Kernel>(skeleton);
  require(!graph.nodes.empty(), f, "the skeleton has no vertex");
  for(const Skeleton_node& node : graph.nodes) {
    require(node.position.allFinite() && std::isfinite(node.radius), f,
            "a vertex of the skeleton is not finite");
    require(node.radius >= 0, f, "a radius of the skeleton is negative");
  }
  Field_parameters p;
  p.smoothness_weight =
    positive(f, cgal, names::smoothness_weight, "smoothness_weight", p.smoothness_weight);
  p.surface_weight = positive(f, cgal, names::surface_weight, "surface_weight", p.surface_weight);
  p.skeleton_weight =
    not_negative(f, cgal, names::skeleton_weight, "skeleton_weight", p.skeleton_weight);
  p.outside_weight =
    not_negative(f, cgal, names::outside_weight, "outside_weight", p.outside_weight);
  p.outside_factor = positive(f, cgal, names::outside_factor, "outside_factor", p.outside_factor);
  require(p.outside_factor >= 1, f, "outside_factor must be at least 1");
  p.resolution = parameter_or(cgal, names::grid_resolution, p.resolution);
  require(p.resolution >= 8 && p.resolution <= 1024, f, "grid_resolution must be in [8, 1024]");
  p.adaptive = parameter_or(cgal, names::adaptive, p.adaptive);

  Surface_triangles surface;
  const bool is_complete = run_core<ConcurrencyTag>(f, cgal, [&](Execution& execution) {
    surface = reconstruct_around_skeleton(execution, positions, graph, p);
  });
  if(!is_complete)
    return false;
  if(surface.triangles.empty())
    throw std::runtime_error(std::string(f) + "(): no surface: the skeleton's radii are too small for "
                             "the resolution, or data contradict them");

  std::vector<typename Kernel::Point_3> vertices;
  vertices.reserve(surface.vertices.size());
  for(const Vec3& v : surface.vertices)
    vertices.push_back(to_point<Kernel>(v));
  CGAL::clear(mesh);
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(vertices, surface.triangles, mesh);
  return true;
}

}  // namespace CGAL

#endif  // CGAL_SKELETON_DRIVEN_SURFACE_RECONSTRUCTION_H
