// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_PARAMETERS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

/// \file
/// The named parameters of the package.
///
/// CGAL's packs of named parameters cannot be given new names from outside of CGAL. This header
/// wraps such a pack and adds the names that only this package knows; the names of CGAL that the
/// package uses are there as well, so that all of them can be chained in any order:
///
///     namespace params = CGAL::Point_set_consolidation_3::parameters;
///     f<Tag>(points, params::point_map(map).collision_angle(45).random_seed(7));
///
/// A pack made by `CGAL::parameters` is accepted wherever one of ours is, and
/// `params::from(pack)` continues one with our names:
///
///     f<Tag>(points, CGAL::parameters::point_map(map));
///     f<Tag>(point_set, params::from(point_set.parameters()).collision_angle(45));
///
/// In the namespace `CGAL::Point_set_consolidation_3` the names `parameters` and `internal_np`
/// mean ours; CGAL's are written `CGAL::parameters` and `CGAL::internal_np`.

/// \cond SKIP_IN_MANUAL

// To add a parameter, add one line to one of the two lists.
// clang-format off

// CGAL's own parameters: X(tag type in CGAL::internal_np, name).
#define CGAL_PSC3_CGAL_PARAMETERS(X)                       \
  X(point_t, point_map)                                    \
  X(normal_t, normal_map)                                  \
  X(geom_traits_t, geom_traits)                            \
  X(callback_t, callback)                                  \
  X(neighbor_radius_t, neighbor_radius)                    \
  X(number_of_iterations_t, number_of_iterations)          \
  X(number_of_output_points_t, number_of_output_points)    \
  X(number_of_samples_t, number_of_samples)                \
  X(select_percentage_t, select_percentage)                \
  X(random_seed_t, random_seed)                            \
  X(point_is_constrained_t, point_is_constrained_map)      \
  X(query_point_t, query_point_map)                        \
  X(vertex_point_t, vertex_point_map)                      \
  X(scalar_t, scalar_map)                                  \
  X(segment_t, segment_map)                                \
  X(sharpness_angle_t, sharpness_angle)                    \
  X(edge_sensitivity_t, edge_sensitivity)                  \
  X(require_uniform_sampling_t, require_uniform_sampling)  \
  X(sparse_linear_solver_t, sparse_linear_solver)          \
  X(diagonalize_traits_t, diagonalize_traits)              \
  X(svd_traits_t, svd_traits)                              \
  X(degree_fitting_t, degree_fitting)                      \
  X(attraction_factor_t, attraction_factor)                \
  X(maximum_variation_t, maximum_variation)                \
  X(threshold_distance_t, threshold_distance)              \
  X(threshold_percent_t, threshold_percent)                \
  X(visitor_t, visitor)                                    \
  X(verbose_t, verbose)

// The package's own parameters: X(name). The tag type is the name with "_t".
#define CGAL_PSC3_OWN_PARAMETERS(X)                                                     \
  /* what is known about the scan */                                                    \
  X(view_direction_map)      /* unit vector from a point towards its scanner */         \
  X(view_index_map)          /* index of the scanner position that saw a point */       \
  X(scanner_positions)       /* range of points, in the order of the view indices */    \
  X(orientation_is_hint)     /* given normals only tell the side */                     \
  /* particles */                                                                       \
  X(particle_fraction)       /* particles per input point */                            \
  X(k_neighbors)                                                                        \
  X(adaptive)                                                                           \
  X(initial_sample)          /* particles to start from */                              \
  X(static_sample)           /* particles that act but stay */                          \
  /* iterative consolidation */                                                         \
  X(two_phases)                                                                         \
  X(printed_values)          /* the paper's values instead of the tested defaults */    \
  X(repulsion_weight)        /* mu */                                                   \
  X(number_of_repulsion_steps)                                                          \
  X(number_of_projections)                                                              \
  X(minimum_spacing)         /* d_min of the up-sampling */                             \
  X(shift_threshold)         /* s of the mean shift */                                  \
  X(far_outlier_distance)    /* in units of h */                                        \
  X(completion_guard)        /* where completed points may lie */                       \
  X(hole_fairing)            /* completed points are moved onto smooth surfaces */      \
  X(inconsistent_neighbors)  /* receives their number */                                \
  X(completed_output_iterator)                                                          \
  X(confidence_output_iterator)                                                         \
  /* deep points */                                                                     \
  X(data_term)                                                                          \
  X(prior)                                                                              \
  X(prior_map)               /* a prior of its own for each point */                    \
  X(collision_angle)         /* omega */                                                \
  X(smoothing_radius)        /* sigma_p */                                              \
  X(collision_radius)        /* sigma_q */                                              \
  X(skeleton_repulsion)      /* mu */                                                   \
  X(surface_repulsion)       /* mu_hat */                                               \
  X(axis_epsilon)            /* epsilon, the floor of an ellipsoid's axes */            \
  X(closing_step)                                                                       \
  X(denoise_along_rays)                                                                 \
  X(detect_outliers)                                                                    \
  X(number_of_skeleton_iterations)                                                      \
  X(number_of_surface_iterations)                                                       \
  X(completed_spacing)       /* of filled regions, in r */                              \
  /* completion */                                                                      \
  X(maximum_hole_size)                                                                  \
  X(use_symmetry)                                                                       \
  X(missed_rays)             /* a point on each, and its view */                        \
  X(denoised_point_map)                                                                 \
  X(denoised_normal_map)                                                                \
  X(outlier_output_iterator)                                                            \
  /* segments, skeletons and surfaces driven by them */                                 \
  X(number_of_segments)                                                                 \
  X(contraction_factor)                                                                 \
  X(contraction_weight)      /* W_L^0, relative to its default */                       \
  X(attraction_weight)       /* W_H^0 */                                                \
  X(laplacian_weights)                                                                  \
  X(convergence_threshold)                                                              \
  X(sampling_radius)         /* of the nodes of a skeleton graph */                     \
  X(largest_merged_cycle)                                                               \
  X(extend_tips)                                                                        \
  X(curves_only)             /* of a meso-skeleton */                                   \
  X(grid_resolution)         /* cells along the longest side */                         \
  X(outside_factor)          /* K */                                                    \
  X(smoothness_weight)                                                                  \
  X(surface_weight)                                                                     \
  X(normal_weight)           /* of the gradients at the points */                       \
  X(skeleton_weight)                                                                    \
  X(outside_weight)                                                                     \
  /* feature-enhanced surfaces */                                                       \
  X(anisotropic_formula)                                                                \
  X(upsampling_formula)                                                                 \
  X(plane_width)             /* sigma_p of the tangent plane weight */                  \
  X(enhance_features)                                                                   \
  X(prominence)              /* tau, in logarithms of the density */                    \
  X(segmentation_method)                                                                \
  X(variation_penalty)       /* lambda, of a cut in a chain of the skeleton */          \
  X(segment_methods)         /* range of methods in the order of the segments */        \
  X(upsampling_factor)                                                                  \
  /* observation */                                                                     \
  X(stage_times)             /* seconds and iterations of each stage */
// clang-format on

/// \endcond

namespace CGAL {
namespace Point_set_consolidation_3 {

/// \cond SKIP_IN_MANUAL

// One tag for each name, the names of CGAL included: inside of this package
// `internal_np::NAME` is what `get_parameter()` is asked for, whoever the name belongs to.
namespace internal_np {

#define CGAL_PSC3_CGAL_TAG(TAG, NAME) \
  using CGAL::internal_np::TAG;       \
  inline constexpr TAG NAME{};
CGAL_PSC3_CGAL_PARAMETERS(CGAL_PSC3_CGAL_TAG)
#undef CGAL_PSC3_CGAL_TAG

#define CGAL_PSC3_OWN_TAG(NAME) enum NAME##_t { NAME };
CGAL_PSC3_OWN_PARAMETERS(CGAL_PSC3_OWN_TAG)
#undef CGAL_PSC3_OWN_TAG

}  // namespace internal_np

/// \endcond

/// \ingroup PkgPointSetConsolidation3Parameters
/// A pack `NP` of CGAL's named parameters that can be chained with the names of this package.
/// It has a member function for each name in \ref psc3_named_parameters.
/// \tparam NP a pack of CGAL
template <typename NP>
class Named_parameters {
  NP m_np;

  template <typename K, typename Tag>
  using Extended = Named_parameters<CGAL::Named_function_parameters<K, Tag, NP>>;

public:
  /// wraps a pack of CGAL
  explicit Named_parameters(const NP& np) : m_np(np) {}

  /// The pack as CGAL's functions take it.
  const NP& cgal_parameters() const { return m_np; }

  /// \cond SKIP_IN_MANUAL
#define CGAL_PSC3_SETTER(TAG, NAME)                                         \
  template <typename K>                                                     \
  Extended<K, internal_np::TAG> NAME(const K& k) const                      \
  {                                                                         \
    return Extended<K, internal_np::TAG>(                                   \
        CGAL::Named_function_parameters<K, internal_np::TAG, NP>(k, m_np)); \
  }
#define CGAL_PSC3_OWN_SETTER(NAME) CGAL_PSC3_SETTER(NAME##_t, NAME)
  CGAL_PSC3_CGAL_PARAMETERS(CGAL_PSC3_SETTER)
  CGAL_PSC3_OWN_PARAMETERS(CGAL_PSC3_OWN_SETTER)
#undef CGAL_PSC3_OWN_SETTER
#undef CGAL_PSC3_SETTER
  /// \endcond
};

/// \ingroup PkgPointSetConsolidation3Parameters
/// A function for each name in \ref psc3_named_parameters, which begins a pack of named parameters.
namespace parameters {

/// The pack of which every parameter has its default.
inline Named_parameters<CGAL::parameters::Default_named_parameters> default_values()
{
  return Named_parameters<CGAL::parameters::Default_named_parameters>(
      CGAL::parameters::default_values());
}

/// Continues a pack of CGAL with the names of this package.
template <typename T, typename Tag, typename Base>
Named_parameters<CGAL::Named_function_parameters<T, Tag, Base>> from(
    const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return Named_parameters<CGAL::Named_function_parameters<T, Tag, Base>>(np);
}

/// \cond SKIP_IN_MANUAL
#define CGAL_PSC3_FREE_SETTER(TAG, NAME)                                                  \
  template <typename K>                                                                   \
  Named_parameters<CGAL::Named_function_parameters<K, internal_np::TAG>> NAME(const K& k) \
  {                                                                                       \
    return from(CGAL::Named_function_parameters<K, internal_np::TAG>(k));                 \
  }
#define CGAL_PSC3_OWN_FREE_SETTER(NAME) CGAL_PSC3_FREE_SETTER(NAME##_t, NAME)
CGAL_PSC3_CGAL_PARAMETERS(CGAL_PSC3_FREE_SETTER)
CGAL_PSC3_OWN_PARAMETERS(CGAL_PSC3_OWN_FREE_SETTER)
#undef CGAL_PSC3_OWN_FREE_SETTER
#undef CGAL_PSC3_FREE_SETTER
/// \endcond

}  // namespace parameters

/// \cond SKIP_IN_MANUAL
namespace internal {

// Public functions call this once on their pack; from there on it is a pack of CGAL, which
// CGAL's own functions and traits take as it is.
template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>& cgal_np(
    const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}

template <typename NP>
const NP& cgal_np(const Named_parameters<NP>& np)
{
  return np.cgal_parameters();
}

// The type of the pack that `cgal_np()` returns.
template <typename NamedParameters>
using Cgal_np = std::decay_t<decltype(cgal_np(std::declval<const NamedParameters&>()))>;

// Whether a pack of CGAL holds the parameter with the given tag type.
template <typename NP, typename Tag>
inline constexpr bool has_parameter = !CGAL::parameters::is_default_parameter<NP, Tag>::value;

// The value of a parameter converted to `T`, or `fallback` when the pack does not hold it.
// It is a copy always: `choose_parameter()` refers to a temporary of `get_parameter()`, which
// would not outlive the caller's statement.
template <typename T, typename NP, typename Tag>
T parameter_or(const NP& np, Tag tag, const T& fallback)
{
  if constexpr(has_parameter<NP, Tag>)
    return static_cast<T>(CGAL::parameters::get_parameter(np, tag));
  else
    return fallback;
}

}  // namespace internal
/// \endcond

}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#undef CGAL_PSC3_CGAL_PARAMETERS
#undef CGAL_PSC3_OWN_PARAMETERS

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_PARAMETERS_H
