// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEEP_POINT_3_H
#define CGAL_DEEP_POINT_3_H

#include <boost/property_map/property_map.hpp>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Completion

  A deep point: an outer point on the surface and an inner point on the meso-skeleton
  \cgalCite{cgal:wshcl-dpc-15}. A range of deep points goes into Poisson reconstruction and into any
  function of the package Point Set Processing of %CGAL through the property maps
  `Deep_point_outer_map` and `Deep_point_normal_map`.

  \tparam Kernel a model of `Kernel`.
*/
template <typename Kernel>
class Deep_point_3 {
public:
  /// number type of the coordinates
  typedef typename Kernel::FT FT;
  /// type of points
  typedef typename Kernel::Point_3 Point_3;
  /// type of vectors
  typedef typename Kernel::Vector_3 Vector_3;

  /// at the origin, of confidence 0
  Deep_point_3() : m_confidence(0) {}
  /// from its parts; `normal` is of unit length
  Deep_point_3(const Point_3& outer, const Point_3& inner, const Vector_3& normal,
               const FT& confidence)
    : m_outer(outer), m_inner(inner), m_normal(normal), m_confidence(confidence)
  {}

  /// the point on the surface
  const Point_3& outer() const { return m_outer; }
  /// its partner on the meso-skeleton
  const Point_3& inner() const { return m_inner; }
  /// unit normal of the surface at `outer()`, pointing outwards
  const Vector_3& normal() const { return m_normal; }
  /// 1: measured; towards 0: completed far from any datum
  const FT& confidence() const { return m_confidence; }

private:
  Point_3 m_outer, m_inner;
  Vector_3 m_normal;
  FT m_confidence;
};

/*!
  \ingroup PkgPointSetConsolidation3Completion

  A point that `complete_point_set()` adds: a deep point whose inner point is the centre of a ball inside of
  the shape, and what is known of it. It may be assigned to a
  `Deep_point_3`.
*/
template <typename Kernel>
class Completed_point_3 : public Deep_point_3<Kernel> {
public:
  /// what it is besides
  typedef Deep_point_3<Kernel> Base;
  /// number type of the coordinates
  typedef typename Kernel::FT FT;

  /// at the origin, of confidence 0
  Completed_point_3() = default;
  /// from its parts, see the functions of the same names
  Completed_point_3(const Base& base, const FT& distance, bool is_clipped, bool is_unanchored)
    : Base(base), m_distance(distance), m_is_clipped(is_clipped), m_is_unanchored(is_unanchored)
  {}

  /// distance to the nearest input point, in the input's unit
  const FT& distance() const { return m_distance; }
  /// whether the data or known free space bound the shape here
  bool is_clipped() const { return m_is_clipped; }
  /// whether nothing opposes the surface from which this was completed: its depth is a guess
  bool is_unanchored() const { return m_is_unanchored; }

private:
  FT m_distance = FT(0);
  bool m_is_clipped = false, m_is_unanchored = false;
};

#ifdef DOXYGEN_RUNNING
#define CGAL_PSC3_DEEP_POINT_MAP(NAME, TYPE, MEMBER) \
  template <typename Kernel>                         \
  struct NAME {};
#else
#define CGAL_PSC3_DEEP_POINT_MAP(NAME, TYPE, MEMBER)                                    \
  template <typename Kernel>                                                            \
  struct NAME {                                                                         \
    typedef Deep_point_3<Kernel> key_type;                                              \
    typedef typename Kernel::TYPE value_type;                                           \
    typedef const value_type& reference;                                                \
    typedef boost::lvalue_property_map_tag category;                                    \
    const value_type& operator[](const key_type& p) const { return p.MEMBER(); }        \
    friend const value_type& get(const NAME&, const key_type& p) { return p.MEMBER(); } \
  };
#endif

/// \ingroup PkgPointSetConsolidation3Completion
/// A model of `LvaluePropertyMap` (constant) from a `Deep_point_3<Kernel>` to its `outer()` point.
/// \tparam Kernel a model of `Kernel`.
CGAL_PSC3_DEEP_POINT_MAP(Deep_point_outer_map, Point_3, outer)
/// \ingroup PkgPointSetConsolidation3Completion
/// A model of `LvaluePropertyMap` (constant) from a `Deep_point_3<Kernel>` to its `inner()` point.
/// \tparam Kernel a model of `Kernel`.
CGAL_PSC3_DEEP_POINT_MAP(Deep_point_inner_map, Point_3, inner)
/// \ingroup PkgPointSetConsolidation3Completion
/// A model of `LvaluePropertyMap` (constant) from a `Deep_point_3<Kernel>` to its `normal()`.
/// \tparam Kernel a model of `Kernel`.
CGAL_PSC3_DEEP_POINT_MAP(Deep_point_normal_map, Vector_3, normal)
/// \ingroup PkgPointSetConsolidation3Completion
/// A model of `LvaluePropertyMap` (constant) from a `Deep_point_3<Kernel>` to its `confidence()`.
/// \tparam Kernel a model of `Kernel`.
CGAL_PSC3_DEEP_POINT_MAP(Deep_point_confidence_map, FT, confidence)

#undef CGAL_PSC3_DEEP_POINT_MAP

}  // namespace CGAL

#endif  // CGAL_DEEP_POINT_3_H
