// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/internal/raw_scan.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper: parameters of the operators and of algorithm 1, input and result. Deviations from the
/// printed values are defaults; `printed()` has the paper's.

struct Wlop_parameters {
  double support_radius = 1;         ///< h
  double repulsion = 0.45;           ///< mu, in [0, 0.5)
  std::size_t iterations = 30;       ///< accuracy is best at 20 to 30
  double least_move = 0.003;         ///< mean move per iteration, in units of h, at which it stops
};

struct Mean_shift_parameters {
  std::size_t neighbors = 20;  ///< k
  std::size_t iterations = 3;  ///< b
  double threshold = 3;        ///< s
};

struct Repulsion_parameters {
  double support_radius = 1;         ///< h, of the surface and of the repulsion
  double repulsion = 0.45;           ///< mu
  /// Steps per call. One step, as printed, advances a border by 0.06 h and leaves large holes open.
  std::size_t steps = 10;
  std::size_t projections = 1;       ///< per step; the paper makes three, with equal results
  /// Arc length by |l'|. Printed: 1 / (2 pi), but an arc of length l on a circle of radius R is the angle l / R.
  double arc_factor = 1;
  /// Residual of the normals from which a particle stays: the surface of a fold or of a thin part is not a
  /// sphere, and its extension would fly off. Replaces the static region that the paper's user draws.
  double largest_normal_residual = 0.4;
  double largest_step = (std::numeric_limits<double>::max)();  ///< L_avg in equation (5)

  static Repulsion_parameters printed()
  {
    Repulsion_parameters p;
    p.steps = 1;
    p.projections = 3;
    p.arc_factor = 0.15915494309189535;  // 1 / (2 pi)
    p.largest_normal_residual = (std::numeric_limits<double>::max)();
    return p;
  }
};

struct Upsampling_parameters {
  double least_distance = 0.1;   ///< d_min: no point is inserted closer to another
  double support_radius = 1;     ///< h: rings reach no farther
  /// Triangles with a larger angle at the centre stay open, in degrees. 135 bridges holes of radius 0.7 h.
  double largest_gap = 135;
  /// Share of the tangent planes' projection in the bulge; 1/2 is exact to second order on spheres.
  double bulge = 0.5;
  std::size_t most_points = (std::numeric_limits<std::size_t>::max)();  ///< to be inserted
};

/// What makes a point near the surface an outlier: how far off the surface of the data it is, in units of h, and how
/// sparse, the distance of its neighbours by the median of that around.
struct Outlier_evidence {
  double distance, sparsity;
};

struct Outlier_parameters {
  double support_radius = 1;        ///< h
  /// Data farther from the up-sampled surface are outliers, in units of h. Printed: 1, which keeps clusters.
  double far_distance = 0.35;
  /// h is larger than usual noise, so the printed rule alone finds none of it. Outliers are as well data off the
  /// quadrics that the data around themselves and around their feet on the particles' surface follow, ...
  bool removes_near = true;
  /// ... by more than this many median residuals, ...
  double near_factor = 2.25;
  /// ... that reach one of these; by increasing distance. Points of sharp details are off the quadrics as well, but
  /// no sparser than the data around; few are as far off as the last, which points inside of thin parts reach.
  std::vector<Outlier_evidence> near = {{0.073, 1.35}, {0.13, 1.2}, {0.17, 1}};
  /// If fewer than this share of the data are found so, or fewer than that share of the far outliers, there is no layer
  /// of noise: what is near the surface are single points out of the space around it, alone and far off, ...
  double scattered_share = 0.01, scattered_share_of_far = 0.25;
  /// ... as this says, or details.
  Outlier_evidence scattered = {0.1, 2};
  /// Flagged points closer than h are kept if they are a smaller share of the data: a clean scan has about
  /// 0.2 % of points in crevices and on tips that the particles do not resolve.
  double least_share = 0.005;
};

struct Peel_parameters {
  double radius = 0.5;          ///< of the neighbourhood that must surround a point
  double largest_gap = 150;     ///< degrees
};

struct Guard_parameters {
  bool enabled = true;
  /// A ray of the scanner passed there. The tolerance covers the silhouettes' sampling.
  double free_space_tolerance = 0.25;
  /// Points nearer than this to a sheet that faces the other way lie in a thin part or in a gap.
  double opposite_distance = 0.5;
  /// Sine of the largest elevation over the tangent plane of the nearest data: more than 45 degrees, what
  /// the pole of a missing hemisphere has, is no continuation of its rim.
  double largest_elevation = 0.75;
  /// A region of completed points is taken back as a whole if the data do not close around it: if, seen from its
  /// middle, no data within `opening_reach` distances of the nearest lie in an angle as wide as this, in radians.
  /// Holes are closed all around; creases between parts that hid each other, and borders of views, are open or
  /// long. ...
  double largest_opening = 1.6;
  double opening_reach = 1.3;
  /// ... or if the rim's normals cancel (length of their mean): around a strip of a tube there is no such plane; ...
  double least_rim_flatness = 0.25;
  /// ... or if its normals differ more from the data's along its rim (mean cosine): it bends off instead of
  /// going on; ...
  double least_rim_cosine = 0.85;
  /// ... or if it reaches no farther from the data: Poisson reconstruction closes such holes as well.
  double least_reach = 0.45;
  /// Share of all added points that must pass, else all are taken back: where most extensions fail, gaps are
  /// occlusions rather than holes, and the regions that pass are not better founded. (Holes cut into models: 0.56
  /// and more; scans from one to three sides: up to 0.3.)
  double least_accepted_share = 0.5;
};

struct Bilateral_parameters {
  double radius = 2;               ///< neighbourhood, in the unit of the points
  double sharpness_angle = 25;     ///< degrees: normals that differ by more belong to another face
  std::size_t iterations = 3;
  bool updates_normals = true;
};

struct Iterative_parameters {
  double particle_fraction = 0.1;      ///< m / |P^0|, 1/20 to 1/5 in the paper
  std::size_t neighbors = 20;          ///< k of L_avg
  double support_radius = 0;           ///< h, in the frame's unit; 0: 2 L_avg
  std::size_t iterations = 10;
  bool adaptive = true;                ///< false: all particles anew in each iteration
  bool two_phases = false;             ///< first without repulsion at a smaller h, then as usual
  std::uint64_t seed = 0;

  Wlop_parameters wlop;
  Mean_shift_parameters mean_shift;
  Repulsion_parameters repulsion;
  Upsampling_parameters upsampling;    ///< its lengths in units of h
  Outlier_parameters outliers;
  Guard_parameters guard;
  /// Up-sampled points nearer to the data than this are no new points, in units of h; at least L_pnt / 2. L_pnt / 2
  /// alone, as printed, fills the gaps of any random sample.
  double selection_distance = 0.2;
  double particles_per_new_point = 2;  ///< m^i = 2 m |P^i| / |P^0|
  bool takes_back_open_borders = true;
  Peel_parameters peel;                ///< its radius in units of h
  bool fairs_holes = true;             ///< completed points are moved onto smooth surfaces through their rims
  double least_new_share = 0.1;        ///< of the largest |P^j|; the printed stop test cannot be met

  static Iterative_parameters printed()
  {
    Iterative_parameters p;
    p.repulsion = Repulsion_parameters::printed();
    p.upsampling.least_distance = 1. / 3;
    p.outliers.far_distance = 1;
    p.outliers.removes_near = false;
    p.outliers.least_share = 0;
    p.guard.enabled = false;
    p.selection_distance = 0;
    p.takes_back_open_borders = false;
    p.fairs_holes = false;
    p.least_new_share = 0;
    return p;
  }
};

/// What the method starts from; lengths in the frame's unit.
struct Iterative_input {
  Points points;
  Points normals;                      ///< empty: none
  bool normals_are_hints = false;      ///< they only tell the side
  Scan_directions directions;          ///< empty: none
  std::vector<char> is_constrained;    ///< the static region; empty: none
};

struct Iterative_result {
  Points normals;                      ///< of all input points
  std::vector<char> is_outlier;        ///< of all input points
  Points new_points, new_normals;
  std::vector<double> new_confidence;  ///< in (0, 1]
  std::vector<std::size_t> new_counts; ///< |P^i|, i = 1, 2, ...
  std::size_t inconsistent_neighbors = 0;
  double support_radius = 0;           ///< h
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_PARAMETERS_H
