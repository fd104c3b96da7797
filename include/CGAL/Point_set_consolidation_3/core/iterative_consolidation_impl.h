// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_IMPL_H
#define CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_IMPL_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/bilateral_projection.h>
#include <CGAL/Point_set_consolidation_3/internal/interpolatory_upsampling.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/mean_shift.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/repulsion.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Point_set_consolidation_3/internal/wlop_projection.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Iterative_result consolidate_iteratively(Execution& execution, const Iterative_input& world,
                                         Iterative_parameters parameters)
{
  constexpr std::size_t sample = 2000;  // enough for the unit, whose exact value does not matter
  Frame frame = data_frame(execution, world.points, sample);
  if(!(frame.unit > 0))
    frame.unit = 1;
  Iterative_input input = world;
  input.points = frame.to_local(world.points);
  parameters.support_radius /= frame.unit;
  Iterative_result result = Iterative_consolidation(execution, input, parameters).run();
  result.new_points = frame.to_world(std::move(result.new_points));
  result.support_radius *= frame.unit;
  return result;
}

/// The frame of a surface: unit is its spacing.
inline Frame surface_frame(const Execution& execution, const Points& points)
{
  Frame frame;
  if(!points.empty())
    frame = data_frame(execution, points, points.size());
  if(!(frame.unit > 0))
    frame.unit = 1;  // most points coincide
  return frame;
}

/// `radius` in the caller's unit; default in spacings of the points (the mean distance to six neighbours): smooths
/// noise of a third of the spacing well and keeps features of twice the support.
inline Algebraic_surface surface_in(const Frame& frame, const Points& points, Points normals, double radius)
{
  constexpr double default_support = 4;
  return Algebraic_surface(frame.to_local(points), std::move(normals),
                           radius > 0 ? radius / frame.unit : default_support);
}

/// h of particles that no one gave one: twice L_avg.
inline double usual_support(const Execution& execution, const Points& particles)
{
  constexpr std::size_t neighbors = 20;
  return 2 * median(neighbor_distances(execution, Nearest_neighbors(particles), particles, neighbors));
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Moved_points project_to_algebraic_surface(Execution& execution, const Points& points, const Points& normals,
                                          const std::vector<char>& is_constrained, double radius,
                                          std::size_t iterations)
{
  Stage stage(execution, "projection", 1);
  const Frame frame = surface_frame(execution, points);
  const Algebraic_surface surface = surface_in(frame, points, normals, radius);
  Moved_points result;
  result.points = points;
  result.normals = normals;
  std::vector<char> moved(points.size(), 0);
  parallel_for_places(execution, points, [&](std::size_t i) {
    if(!is_constrained.empty() && is_constrained[i])
      return;
    Vec3 x = surface.points()[i];
    moved[i] = surface.project(x, result.normals[i], iterations);
    if(moved[i])
      result.points[i] = frame.to_world(x);
  });
  for(const char m : moved)
    result.number += m != 0;
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Moved_points project_bilaterally_in_place(Execution& execution, const Points& points, const Points& normals,
                                          const std::vector<char>& is_constrained,
                                          Bilateral_parameters parameters)
{
  Frame frame = data_frame(execution, points, points.size());
  if(!(frame.unit > 0)) {
    if(!(parameters.radius > 0))
      return Moved_points();
    frame.unit = parameters.radius;
  }
  Moved_points result;
  result.points = frame.to_local(points);
  result.normals = normals;
  constexpr double default_radius = 3;  // spacings: some 28 neighbours
  parameters.radius = parameters.radius > 0 ? parameters.radius / frame.unit : default_radius;
  {
    Stage stage(execution, "bilateral projection", 1);
    project_bilaterally(execution, stage, result.points, result.normals, is_constrained, parameters);
  }
  result.points = frame.to_world(std::move(result.points));
  for(std::size_t i = 0; i < points.size(); ++i)
    result.distance += (result.points[i] - points[i]).norm() / double(points.size());
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Moved_points repulse_along_algebraic_surface(Execution& execution, const Points& points, const Points& normals,
                                             const std::vector<char>& is_constrained,
                                             Repulsion_parameters parameters)
{
  const Frame frame = data_frame(execution, points, points.size());
  if(!(frame.unit > 0))
    return Moved_points();
  Moved_points result;
  result.points = frame.to_local(points);
  result.normals = normals;
  parameters.support_radius = parameters.support_radius > 0 ? parameters.support_radius / frame.unit
                                                            : usual_support(execution, result.points);
  parameters.largest_step = parameters.support_radius / 2;  // L_avg
  Stage stage(execution, "repulsion", 1);
  result.distance = frame.unit * Surface_repulsion(execution, result.points, result.normals, parameters)
                                   .run(stage, result.points, result.normals, is_constrained);
  result.points = frame.to_world(std::move(result.points));
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
std::vector<char> find_mean_shift_outliers(Execution& execution, const Points& points,
                                           const Mean_shift_parameters& parameters)
{
  const Stage stage(execution, "mean shift", 1);
  return mean_shift_outliers(execution, points, parameters);
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Moved_points upsample_by_interpolation(Execution& execution, const Points& points, const Points& normals,
                                       const std::vector<char>& is_constrained, Upsampling_parameters parameters)
{
  const Frame frame = data_frame(execution, points, points.size());
  if(!(frame.unit > 0))
    return Moved_points();
  Points all = frame.to_local(points), all_normals = normals;
  constexpr double default_share = 0.1;  // of h
  parameters.support_radius =
    parameters.support_radius > 0 ? parameters.support_radius / frame.unit : usual_support(execution, all);
  parameters.least_distance = parameters.least_distance > 0 ? parameters.least_distance / frame.unit
                                                            : default_share * parameters.support_radius;
  std::vector<std::size_t> centres;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(is_constrained.empty() || !is_constrained[i])
      centres.push_back(i);
  Stage stage(execution, "up-sampling", 1);
  Interpolatory_upsampling(execution, parameters).run(stage, all, all_normals, std::move(centres));
  Moved_points result;
  result.points.assign(all.begin() + std::ptrdiff_t(points.size()), all.end());
  result.points = frame.to_world(std::move(result.points));
  result.normals.assign(all_normals.begin() + std::ptrdiff_t(points.size()), all_normals.end());
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Points project_by_wlop(Execution& execution, const Points& world, const Points& sample, const Points& statics,
                       Wlop_settings settings)
{
  Frame frame = data_frame(execution, world, (std::min)(settings.count, world.size()));
  if(!(frame.unit > 0))
    frame.unit = 1;  // most points coincide: h decides
  const Points data = frame.to_local(world);
  Points particles = frame.to_local(statics);
  const std::size_t number_of_statics = particles.size();
  for(const Vec3& p : sample)
    particles.push_back(frame.to_local(p));
  if(sample.empty())
    for(const std::size_t i : random_subset(data.size(), settings.count, settings.seed))
      particles.push_back(data[i]);
  double& h = settings.parameters.support_radius;
  h = h > 0 ? h / frame.unit : usual_support(execution, particles);
  if(h > 0) {
    Stage stage(execution, "wlop", 1);
    const Wlop_kernel kernel(h);
    const Sorted_grid grid(data, kernel.reach);
    const std::vector<double> densities = wlop_densities(execution, grid, data, kernel);
    std::vector<char> is_static(particles.size(), 0);
    std::fill_n(is_static.begin(), number_of_statics, 1);
    Wlop_projection<>(execution, {&grid, &densities}, settings.parameters).run(stage, particles, is_static);
  }
  particles.erase(particles.begin(), particles.begin() + std::ptrdiff_t(number_of_statics));
  return frame.to_world(std::move(particles));
}

struct Oriented_surface::Data {
  Frame frame;
  Algebraic_surface surface;
};

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_surface::Oriented_surface(const Points& points, Points normals, double radius)
{
  const Frame frame = surface_frame(make_execution<Sequential_tag>(), points);
  m = std::make_shared<const Data>(Data{frame, surface_in(frame, points, std::move(normals), radius)});
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
double Oriented_surface::support() const { return m->surface.support() * m->frame.unit; }

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
Oriented_surface::Fit Oriented_surface::fit(const Vec3& world) const
{
  const Vec3 x = m->frame.to_local(world);
  const Algebraic_surface::Fit fit = m->surface.fit(x, Vec3::Zero());
  Fit result;
  result.count = fit.count;
  result.is_defined = fit.count >= Algebraic_surface::least_points;
  if(!result.is_defined)
    return result;
  const Vec3 y = fit.sphere.project(x);
  result.foot = m->frame.to_world(y);
  result.normal = fit.sphere.normal(y, Vec3::UnitZ());
  result.gradient = fit.sphere.gradient(x);
  result.curvature = fit.sphere.curvature() / m->frame.unit;
  result.signed_distance = fit.sphere.signed_distance(x) * m->frame.unit;
  result.normal_residual = fit.normal_residual;
  return result;
}

CGAL_POINT_SET_CONSOLIDATION_3_INLINE
bool Oriented_surface::project(Vec3& world, std::size_t iterations) const
{
  Vec3 x = m->frame.to_local(world), normal = Vec3::Zero();  // zero: neighbours of all sides count
  if(!m->surface.project(x, normal, iterations))
    return false;
  world = m->frame.to_world(x);
  return true;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_CORE_ITERATIVE_CONSOLIDATION_IMPL_H
