// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_H

#include <CGAL/Point_set_consolidation_3/core/configuration.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>

#include <memory>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

struct Deep_points_settings {
  const char* function = "";  ///< named in error messages; a literal
  Input_parameters input;
  Sinking_parameters sinking;
  Meso_skeleton_parameters skeleton;
  Surface_parameters surface;
  double largest_gap = (std::numeric_limits<double>::max)();  ///< in the caller's unit
  bool use_symmetry = true;
};

/// A missing point. Lengths in the caller's unit.
struct Completed_place {
  Vec3 point, inner, normal;
  double confidence = 0;
  double distance = 0;      ///< to the nearest datum
  bool is_clipped = false, is_unanchored = false;
};

/// The stages of the deep points paper and of the completion. A stage runs those before it; it returns false if the
/// callback stopped it, and the object is as before. Input that cannot be consolidated is `std::invalid_argument`.
/// Results are in the caller's coordinates.
class Deep_points {
public:
  Deep_points(Execution execution, Raw_scan scan, const Deep_points_settings& settings);
  ~Deep_points();
  Deep_points(const Deep_points& other);
  Deep_points(Deep_points&& other) noexcept;
  Deep_points& operator=(Deep_points other) noexcept;

  bool consolidate_input();
  bool sink_inner_points();
  bool form_meso_skeleton();
  bool consolidate_outer_points();
  bool complete_missing_parts();

  const Execution& execution() const;
  double spacing() const;           ///< r, equation (1)

  std::size_t size() const;         ///< |S|
  Vec3 consolidated_point(std::size_t i) const;
  Vec3 consolidated_normal(std::size_t i) const;  ///< bilaterally smoothed once the inner points have sunk
  Vec3 anchor_point(std::size_t i) const;
  Anchoring anchoring(std::size_t i) const;
  std::size_t number_of_sinking_iterations() const;
  Vec3 skeletal_point(std::size_t i) const;
  Vec3 ellipsoid_axis(std::size_t i, int m) const;  ///< as long as the semi-axis

  std::size_t number_of_outer_points() const;  ///< |P|; 0 before its stage
  Vec3 outer_point(std::size_t i) const;
  Vec3 outer_normal(std::size_t i) const;
  std::size_t partner(std::size_t i) const;     ///< its skeletal point
  double data_density(std::size_t i) const;     ///< eta
  double outer_confidence(std::size_t i) const;

  std::size_t number_of_completed_points() const;
  Completed_place completed_point(std::size_t i) const;
  const std::vector<std::size_t>& outliers() const;
  bool is_outlier(std::size_t i) const;
  Vec3 denoised_point(std::size_t i) const;
  Vec3 denoised_normal(std::size_t i) const;

private:
  struct State;
  std::unique_ptr<State> m;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
#include <CGAL/Point_set_consolidation_3/core/deep_points_impl.h>
#endif

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_DEEP_POINTS_H
