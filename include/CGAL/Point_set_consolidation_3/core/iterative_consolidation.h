// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>

#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The iterative consolidation paper: the method and its operators, on points in the caller's coordinates. Lengths in
/// parameters and results are in the caller's unit as well; 0: the default.

Iterative_result consolidate_iteratively(Execution& execution, const Iterative_input& input,
                                         Iterative_parameters parameters);

/// Points that an operator has moved; no points: there was nothing to do.
struct Moved_points {
  Points points, normals;
  std::size_t number = 0;  ///< of points that moved
  double distance = 0;     ///< mean
};

Moved_points project_to_algebraic_surface(Execution& execution, const Points& points, const Points& normals,
                                          const std::vector<char>& is_constrained, double radius,
                                          std::size_t iterations);

Moved_points project_bilaterally_in_place(Execution& execution, const Points& points, const Points& normals,
                                          const std::vector<char>& is_constrained,
                                          Bilateral_parameters parameters);

Moved_points repulse_along_algebraic_surface(Execution& execution, const Points& points, const Points& normals,
                                             const std::vector<char>& is_constrained,
                                             Repulsion_parameters parameters);

/// One flag per point.
std::vector<char> find_mean_shift_outliers(Execution& execution, const Points& points,
                                           const Mean_shift_parameters& parameters);

/// What is inserted; points that are constrained are not refined.
Moved_points upsample_by_interpolation(Execution& execution, const Points& points, const Points& normals,
                                       const std::vector<char>& is_constrained, Upsampling_parameters parameters);

struct Wlop_settings {
  Wlop_parameters parameters;
  std::size_t count = 0;      ///< of the random sample to start from
  std::uint64_t seed = 0;
};

/// The projected particles; those to start from are `sample`, or a random sample if it is empty.
Points project_by_wlop(Execution& execution, const Points& data, const Points& sample, const Points& statics,
                       Wlop_settings settings);

/// An algebraic point set surface in the caller's coordinates; never changes.
class Oriented_surface {
public:
  /// The sphere fitted at a query.
  struct Fit {
    std::size_t count = 0;        ///< of points in the support
    bool is_defined = false;      ///< there are enough of them; what follows is set then
    Vec3 foot, normal, gradient;  ///< the nearest point of the sphere, its normal; of the field at the query
    double curvature = 0, signed_distance = 0, normal_residual = 0;
  };

  Oriented_surface(const Points& points, Points normals, double radius);

  double support() const;
  Fit fit(const Vec3& x) const;
  /// False, and nothing is changed, where the surface is not defined.
  bool project(Vec3& x, std::size_t iterations) const;

private:
  struct Data;
  std::shared_ptr<const Data> m;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_H
