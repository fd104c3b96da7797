// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ALGEBRAIC_POINT_SET_SURFACE_3_H
#define CGAL_ALGEBRAIC_POINT_SET_SURFACE_3_H

#include <CGAL/apss_project_point_set.h>
#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>
#include <CGAL/Point_set_consolidation_3/parameters.h>

#include <optional>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  The algebraic point set surface of oriented points \cgalCite{cgal:gg-apss-07}, as a scalar field near the
  points: for any query an algebraic sphere \f$s(y) = u_0 + (u_1, u_2, u_3) \cdot y + u_4\, y \cdot y\f$ is fitted to
  the points around it, with weights \f$(1 - r^2/h^2)^4\f$; its zero set and gradient at the query are those of
  the surface. See appendix II of \cgalCite{cgal:lcw-icupc-12}.

  The fit is exact for points on spheres and planes. The sphere's centre is never formed: planes, and offsets far
  from the origin, lose no accuracy. The object copies the points; queries are `const` and may run
  concurrently. Complexity of a query: that of finding the points within \f$h\f$.

  \tparam Traits a model of `Kernel`, floating point coordinates.
*/
template <typename Traits>
class Algebraic_point_set_surface_3 {
  /// \cond SKIP_IN_MANUAL
  typedef Point_set_consolidation_3::internal::Oriented_surface Surface;
  typedef Point_set_consolidation_3::internal::Vec3 Vec3;
  /// \endcond

public:
  /// number type of the coordinates
  typedef typename Traits::FT FT;
  /// type of points
  typedef typename Traits::Point_3 Point_3;
  /// type of vectors
  typedef typename Traits::Vector_3 Vector_3;

  /// A fitted algebraic sphere in the user's coordinates: a sphere if `curvature` is not zero, else a
  /// plane.
  struct Sphere {
    Point_3 point;     ///< the nearest point of the sphere to the query
    Vector_3 normal;   ///< its unit normal there
    FT curvature;      ///< one over the radius, positive if normals point away from the centre
    std::size_t number_of_points;  ///< in the support
    FT normal_residual;  ///< root mean square difference of the points' normals from the gradient
  };

  /// copies points and normals.
  /// \param points points with finite coordinates and oriented normals.
  /// \param np named parameters `point_map`, `normal_map`, `geom_traits` and `neighbor_radius` (\f$h\f$; default 4
  /// spacings), as for `apss_project_point_set()`.
  /// \throws std::invalid_argument as `apss_project_point_set()`.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit Algebraic_point_set_surface_3(const PointRange& points,
                                         const NamedParameters& np = parameters::default_values())
    : m_surface(make_surface(points, Point_set_consolidation_3::internal::cgal_np(np)))
  {}

  /// \f$h\f$.
  FT support_radius() const { return FT(m_surface.support()); }

  /// The sphere fitted at `query`; nothing where fewer than three points are in the support.
  std::optional<Sphere> fit(const Point_3& query) const
  {
    const Surface::Fit f = m_surface.fit(vec3(query));
    if(!f.is_defined)
      return std::nullopt;
    return Sphere{point(f.foot), vector(f.normal), FT(f.curvature), f.count, FT(f.normal_residual)};
  }

  /// Projects `query` onto the surface by up to `iterations` fits; nothing where the surface is not defined: fewer
  /// than three points in the support, or a projection that leaves it.
  std::optional<Point_3> project(const Point_3& query, std::size_t iterations = 10) const
  {
    Vec3 x = vec3(query);
    if(!m_surface.project(x, iterations))
      return std::nullopt;
    return point(x);
  }

  /// Signed distance of `query` from the sphere fitted there, positive on the side of the normals.
  std::optional<FT> signed_distance(const Point_3& query) const
  {
    const Surface::Fit f = m_surface.fit(vec3(query));
    if(!f.is_defined)
      return std::nullopt;
    return FT(f.signed_distance);
  }

  /// Gradient of the fitted field at `query`; of length about one near the surface.
  std::optional<Vector_3> gradient(const Point_3& query) const
  {
    const Surface::Fit f = m_surface.fit(vec3(query));
    if(!f.is_defined)
      return std::nullopt;
    return vector(f.gradient);
  }

private:
  /// \cond SKIP_IN_MANUAL
  template <typename PointRange, typename NP>
  static Surface make_surface(const PointRange& points, const NP& np)
  {
    using namespace Point_set_consolidation_3::internal;
    const char* const function = "Algebraic_point_set_surface_3";
    const Points input = copy_points(function, points, np, 1);
    Points normals = copy_unit_normals(function, points, np);
    const double radius =
      not_negative(function, np, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);
    return Surface(input, std::move(normals), radius);
  }
  static Vec3 vec3(const Point_3& p) { return Point_set_consolidation_3::internal::to_vec3(p); }
  static Point_3 point(const Vec3& x) { return Point_set_consolidation_3::internal::to_point<Traits>(x); }
  static Vector_3 vector(const Vec3& v) { return Point_set_consolidation_3::internal::to_vector<Traits>(v); }

  Surface m_surface;
  /// \endcond
};

}  // namespace CGAL

#endif  // CGAL_ALGEBRAIC_POINT_SET_SURFACE_3_H
