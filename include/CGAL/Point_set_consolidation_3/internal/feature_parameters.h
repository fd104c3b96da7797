// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PARAMETERS_H

#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/surface_triangles.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper: parameters and results of its sections.

struct Anisotropic_wlop_parameters {
  Anisotropic_formula formula = Anisotropic_formula::SEPARATED;
  bool oriented = false;
  double support_radius = 0;     ///< h
  double plane_width = 0;        ///< sigma_p
  double repulsion = 0.4;        ///< mu
  std::size_t iterations = 20;   ///< as in figure 2
  double sharpness_angle = 25;   ///< degrees
  double edge_attraction = 0;    ///< points of the result nearer to an edge go onto it
};

struct Edge_aware_parameters {
  Upsampling_formula formula = Upsampling_formula::WEIGHTED;
  bool oriented = false;
  std::size_t number_of_points = 0;
  double neighbor_radius = 3;    ///< bases lie between points at most so far apart
  double sharpness_angle = 25;   ///< alpha, degrees
  double edge_sensitivity = 0.5;   ///< prefers bases between normals that differ
  double plane_width = 1;        ///< sigma_p
};

struct Feature_parameters {
  bool oriented = false;
  double sharpness_angle = 25;      ///< degrees
  std::size_t rounds = 2;           ///< measured on CAD models: a third moves nothing
  std::size_t plane_neighbors = 30;
};

struct Projection_settings {
  Anisotropic_wlop_parameters wlop;   ///< lengths in the caller's unit; 0: default of the formula
  bool repulsion_is_given = false;
  bool enhances_features = true;      ///< normals and data are denoised first
  std::size_t count = 0;              ///< |Q|
  std::uint64_t seed = 0;
};

struct Oriented_points {
  Points points, normals;
};

struct Skeleton_segmentation_parameters {
  double penalty = 0.4;           ///< lambda: price of a cut, against squared deviations of log radius
  double least_share = 0.02;      ///< of the points: smaller segments are merged
  std::size_t count = 0;          ///< 0: as many as there are; else the most similar are merged
};

struct Segmentation_settings {
  Segmentation_method method = Segmentation_method::SKELETON;
  double radius = 0;        ///< h, in the caller's unit; 0: default
  double prominence = 0.1;
  Skeleton_segmentation_parameters skeleton;
};

struct Segmentation {
  std::vector<std::size_t> labels;
  std::size_t count = 0;
};

struct Feature_enhanced_settings {
  Segmentation_settings segmentation;
  std::vector<Part_method> methods;   ///< of the segments; missing ones are automatic
  bool enhances = false;  ///< on curved parts it flattens more than the field needs
  double sharpness_angle = 20;
  double upsampling_factor = 1;
  Field_parameters field = with_normals();

private:
  static Field_parameters with_normals()
  {
    Field_parameters field;
    field.normal_weight = 10;  // 5 leaves unseen parts worse, 20 makes handles
    // of exact points; 50 lets gaps bulge, and moves the surface off what was seen
    field.surface_weight = 500;
    return field;
  }
};

struct Feature_enhanced_result {
  Segmentation segmentation;
  Skeleton_graph skeleton;
  Oriented_points fused;              ///< enhanced, up-sampled and completed points
  Surface_triangles surface;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FEATURE_PARAMETERS_H
