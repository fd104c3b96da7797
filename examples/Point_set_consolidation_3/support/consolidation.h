// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_CONSOLIDATION_H
#define CONSOLIDATION_SUPPORT_CONSOLIDATION_H

#include "types.h"

#include <CGAL/Point_set_consolidation_3/options.h>

#include <functional>
#include <string>

namespace support {

/// The methods that consolidate a scan, by name. Lengths as in the functions of the package.
struct Consolidation_options {
  std::string method = "deep-points";  ///< deep-points, iterative, anisotropic-wlop or wlop
  bool wants_points = true;            ///< the method's own points
  bool wants_inner = false;            ///< radii and labels of the inner points
  bool wants_completed = true;         ///< the completed input, for the methods that complete
  std::vector<Vec3> scanner;           ///< positions in the order of the views
  std::size_t particles = 0;           ///< 0: the method's default
  double percentage = 0;               ///< the same in percent of the input
  double radius = 0;                   ///< 0: the method's default
  unsigned int wlop_iterations = 35;
  bool keep_density = false;
  std::string prior = "volume-preserving", data_term = "full";
  double omega = 45, sigma_p = 5, sigma_q = 2, mu = 0.4, mu_hat = 0.4, epsilon = 0.1;
  std::size_t skeleton_iterations = 10, surface_iterations = 90;
  bool no_denoising = false;     ///< of views along their rays
  bool keep_outliers = false;
  bool no_symmetry = false;      ///< do not complete by a mirror plane
  double maximum_hole = 0;       ///< in the unit of the input; 0: no bound
  double completed_spacing = 1;  ///< of filled regions, in spacings of the particles
  bool no_closing = false;
  bool no_hole_fairing = false;  ///< iterative: do not move new points onto a smooth surface
};

struct Consolidation_result {
  Point_cloud consolidated;          ///< the method's own points
  Point_cloud completed;             ///< the caller's points but outliers, then the missing ones; may be empty
  std::size_t completed_points = 0;  ///< how many of them are new
  double noise = 0;                  ///< how far denoising moved the points, root mean square; 0: clean
  std::size_t outliers = 0;          ///< how many of the caller's points are left out
  Segment_graph deep_points;         ///< outer and inner vertices, radius: length of the deep point
  Segment_graph inner;               ///< the meso-skeleton's points with radius
  std::vector<int> inner_labels;     ///< parallel: values of Meso_label
  std::vector<CGAL::Point_set_consolidation_3::Stage_time> times;
  double spacing = 0;                ///< of the consolidated points; 0: not computed
};

/// `progress` may be empty; it cannot cancel.
/// \throws std::invalid_argument if the data or an option do not allow it; Usage errors are the caller's.
Consolidation_result consolidate(const Point_cloud& cloud, const Consolidation_options& options,
                                 const std::function<void(double)>& progress);

/// Edge-aware up-sampling after bilateral smoothing of the normals (figure 15 of the deep points paper).
void upsample(Point_cloud& cloud, std::size_t count);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_CONSOLIDATION_H
