// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_REPULSION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_REPULSION_H

#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/wlop_projection.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-C: particles repel each other along the algebraic surface
/// that they define, and so extend it over its border into missing regions.

/// Whether a particle may move to a place; a policy for what is known about empty space.
using Placement_test = std::function<bool(const Vec3& position, const Vec3& normal)>;

class Surface_repulsion {
public:
  /// The surface is that of the particles as they are now, for all steps: re-fitting it to the moved
  /// particles lets errors grow.
  Surface_repulsion(Execution& execution, const Points& particles, const Points& normals,
                    const Repulsion_parameters& parameters, Placement_test may_move = {})
    : m_execution(execution), m_parameters(parameters)
    , m_surface(particles, normals, parameters.support_radius)
    , m_kernel(parameters.support_radius), m_may_move(std::move(may_move)) {}

  /// Moves the particles that are not static; normals follow the surface. Returns the mean distance of
  /// the moving particles from where they started.
  double run(Stage& stage, Points& particles, Points& normals,
             const std::vector<char>& is_static) const
  {
    std::vector<char> stays(particles.size(), 0);
    const std::vector<Index> order = place_order(particles);
    parallel_for_places(m_execution, order, [&](std::size_t i) {
      stays[i] = (!is_static.empty() && is_static[i]) || !is_smooth(particles[i], normals[i]);
    });
    std::vector<std::size_t> moving;
    for(const Index i : order)
      if(!stays[i])
        moving.push_back(i);
    if(moving.empty())
      return 0;

    for(std::size_t step = 0; step < m_parameters.steps; ++step) {
      const Sorted_grid grid(particles, m_kernel.reach);
      const std::vector<double> densities =
        particle_densities(m_execution, grid, particles, moving, m_kernel);
      Points next(moving.size()), next_normals(moving.size());
      parallel_for(m_execution, moving.size(), [&](std::size_t k) {
        const std::size_t i = moving[k];
        next[k] = particles[i];
        next_normals[k] = normals[i];
        move(grid, densities, i, next[k], next_normals[k]);
      });
      for(std::size_t k = 0; k < moving.size(); ++k) {
        particles[moving[k]] = next[k];
        normals[moving[k]] = next_normals[k];
      }
      stage.count_iteration();
      stage.update(double(step + 1) / double(m_parameters.steps));
    }
    double distance = 0;
    for(const std::size_t i : moving)
      distance += (particles[i] - m_surface.points()[i]).norm();
    return distance / double(moving.size());
  }

private:
  bool is_smooth(const Vec3& x, const Vec3& normal) const
  {
    const Algebraic_surface::Fit fit = m_surface.fit(x, normal);
    return fit.count >= Algebraic_surface::least_points &&
           fit.normal_residual <= m_parameters.largest_normal_residual;
  }

  void move(const Sorted_grid& grid, const std::vector<double>& densities, std::size_t i, Vec3& x,
            Vec3& normal) const
  {
    const Algebraic_surface::Fit fit = m_surface.fit(x, normal);
    if(fit.count < Algebraic_surface::least_points)
      return;
    // equation (1); the "- x_i" at its end is a misprint, the sum is the displacement already
    const Vec3 l = m_parameters.repulsion *
                   wlop_repulsion(grid, densities, x, i, m_kernel, Isotropic_weights());
    const Vec3 n = fit.sphere.normal(x, normal);
    Vec3 arc = m_parameters.arc_factor * (l - l.dot(n) * n);        // equation (2)
    const double length = arc.norm(), limit = largest_arc(fit.sphere);
    if(length > limit)
      arc *= limit / length;
    Vec3 y = fit.sphere.slide(x, arc), y_normal = n;                // equations (3) and (4)
    if(!m_surface.project(y, y_normal, m_parameters.projections))   // equation (6)
      return;
    if((y - x).squaredNorm() > m_kernel.reach * m_kernel.reach)
      return;
    if(m_may_move && !m_may_move(y, y_normal))
      return;
    x = y;
    normal = y_normal;
  }

  /// Equation (5).
  double largest_arc(const Algebraic_sphere& sphere) const
  {
    const double kappa = std::abs(sphere.curvature());
    constexpr double quarter_pi = CGAL_PI / 4;
    const double limit = m_parameters.largest_step * m_parameters.arc_factor;
    return kappa * limit > quarter_pi ? quarter_pi / kappa : limit;
  }

  Execution& m_execution;
  Repulsion_parameters m_parameters;
  Algebraic_surface m_surface;
  Wlop_kernel m_kernel;
  Placement_test m_may_move;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_REPULSION_H
