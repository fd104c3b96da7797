// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_CONSOLIDATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_CONSOLIDATION_H

#include <CGAL/Point_set_consolidation_3/internal/confidence.h>
#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/dipole_orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/hole_filling.h>
#include <CGAL/Point_set_consolidation_3/internal/interpolatory_upsampling.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/mean_shift.h>
#include <CGAL/Point_set_consolidation_3/internal/outlier_selection.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/particle_normals.h>
#include <CGAL/Point_set_consolidation_3/internal/particle_selection.h>
#include <CGAL/Point_set_consolidation_3/internal/placement_guard.h>
#include <CGAL/Point_set_consolidation_3/internal/repulsion.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Point_set_consolidation_3/internal/wlop_projection.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, algorithm 1: down-sampling to particles, outlier removal, repulsion along
/// the particles' surface, up-sampling and selection, repeated for the points that were added last. Members are
/// its lines.

class Iterative_consolidation {
  static constexpr std::size_t voting_passes = 3;
  static constexpr std::size_t least_new_points = 20;   ///< fewer are the noise of the selection
  static constexpr double first_phase_radius = 0.6;     ///< of h, in the first of two phases
  static constexpr double region_radius = 0.4;          ///< of h: up-sampled points of one sheet
  /// Neighbourhoods of 20 particles need some hundreds of them.
  static constexpr std::size_t least_particles = 500;

public:
  Iterative_consolidation(Execution& execution, const Iterative_input& input,
                          const Iterative_parameters& parameters)
    : m_execution(execution), m_input(input), m_parameters(parameters) {}

  Iterative_result run()
  {
    const std::size_t n = m_input.points.size();
    m_result.is_outlier.assign(n, 0);
    first_particles();
    if(m_h > 0) {
      remove_outliers();
      orient_points();
      prepare_guard();
      if(m_parameters.two_phases) {
        iterate(0.3, first_phase_radius, 0);
        sample_particles(m_points, m_number_of_particles);
      }
      iterate(m_parameters.two_phases ? 0.25 : 0.55, 1, m_parameters.repulsion.steps);
    }
    else {
      keep_all();
      orient_points();
    }
    finish();
    return std::move(m_result);
  }

private:
  /// Lines 1, 2, 5 to 8 of algorithm 1.
  void first_particles()
  {
    Stage stage(m_execution, "down-sampling", 0.15);
    const Points& data = m_input.points;
    m_number_of_particles =
      (std::min)(data.size(),
                 (std::max)(least_particles,
                            std::size_t(m_parameters.particle_fraction * double(data.size()))));
    m_nearest = nearest_table(m_execution, data, m_parameters.neighbors);
    stage.update(0.2);
    for(const std::size_t i : random_subset(data.size(), m_number_of_particles, m_parameters.seed))
      m_particles.push_back(data[i]);
    m_h = support_of(m_particles);
    if(!(m_h > 0) || m_particles.size() <= m_parameters.neighbors) {
      m_h = 0;
      return;
    }
    move_particles(stage, data, std::vector<char>());
    const std::vector<char> is_outlier =
      mean_shift_outliers(m_execution, m_particles, m_parameters.mean_shift);
    Points kept;
    for(std::size_t i = 0; i < m_particles.size(); ++i)
      if(!is_outlier[i])
        kept.push_back(m_particles[i]);
    m_particles.swap(kept);
    m_h = support_of(m_particles);
    if(m_particles.size() <= m_parameters.neighbors)
      m_h = 0;
  }

  /// h = 2 L_avg. The median over the particles: a few far outliers would spoil the mean.
  double support_of(const Points& particles) const
  {
    if(m_parameters.support_radius > 0)
      return m_parameters.support_radius;
    return 2 * median(neighbor_distances(m_execution, Nearest_neighbors(m_execution, particles), particles,
                                         m_parameters.neighbors));
  }

  /// WLOP of the particles that are not static.
  void move_particles(Stage& stage, const Points& data, const std::vector<char>& is_static)
  {
    Wlop_parameters parameters = m_parameters.wlop;
    parameters.support_radius = m_h;
    const Wlop_kernel kernel(m_h);
    const Sorted_grid grid(data, kernel.reach);
    const std::vector<double> densities = data_densities(grid, data, kernel, is_static);
    const Wlop_projection<> wlop(m_execution, {&grid, &densities}, parameters);
    wlop.run(stage, m_particles, is_static);
  }

  /// Of the data that particles which are not static may come to see.
  std::vector<double> data_densities(const Sorted_grid& grid, const Points& data,
                                     const Wlop_kernel& kernel,
                                     const std::vector<char>& is_static) const
  {
    if(is_static.empty())
      return wlop_densities(m_execution, grid, data, kernel);
    constexpr double farthest_move = 1.5;  // of h; in all iterations they move by half of h at most
    Points places;
    for(std::size_t i = 0; i < m_particles.size(); ++i)
      if(!is_static[i])
        places.push_back(m_particles[i]);
    return wlop_densities_near(m_execution, grid, data, kernel, places,
                               kernel.reach + farthest_move * m_h);
  }

  /// Line 13 of algorithm 1. The up-sampled surface is that of the particles before repulsion, so that what is
  /// an outlier does not depend on how borders are extended.
  void remove_outliers()
  {
    Stage stage(m_execution, "outliers", 0.15);
    const Nearest_table table = nearest_table(m_execution, m_particles, m_parameters.neighbors);
    Points normals = table_normals(m_execution, m_particles, table);
    if(!hints().empty())
      orient_by_hints(m_execution, m_particles, normals, m_input.points, hints());
    else
      orient_by_dipoles(m_execution, m_particles, normals);
    stage.update(0.2);
    Points surface = m_particles;
    std::vector<std::size_t> centres(surface.size());
    for(std::size_t i = 0; i < centres.size(); ++i)
      centres[i] = i;
    Interpolatory_upsampling(m_execution, upsampling_parameters(m_h))
      .run(stage, surface, normals, std::move(centres));
    Outlier_parameters parameters = m_parameters.outliers;
    parameters.support_radius = m_h;
    m_result.is_outlier = outlier_points(m_execution, m_input.points, surface, normals, parameters);
    for(std::size_t i = 0; i < m_input.is_constrained.size(); ++i)
      if(m_input.is_constrained[i])
        m_result.is_outlier[i] = 0;
    keep_all();
  }

  /// The points that are no outliers become P.
  void keep_all()
  {
    for(std::size_t i = 0; i < m_input.points.size(); ++i)
      if(!m_result.is_outlier[i]) {
        m_original.push_back(Index(i));
        m_points.push_back(m_input.points[i]);
      }
    m_nearest = restricted_table(m_execution, m_nearest, m_points, m_original);
    m_number_of_kept = m_points.size();
  }

  const Points& hints() const
  {
    return m_input.directions.empty() ? m_input.normals : m_input.directions.towards_scanner;
  }

  /// Line 9 of algorithm 1, on P: particles are coarser than thin parts, where their own normals fail.
  void orient_points()
  {
    Stage stage(m_execution, "normals", 0.1);
    m_normals = table_normals(m_execution, m_points, m_nearest);
    stage.update(0.5);
    const bool has_normals = !m_input.normals.empty() && !m_input.normals_are_hints;
    if(!has_normals && hints().empty()) {
      orient_by_dipoles(m_execution, m_points, m_normals);
      orient_by_vote(m_execution, m_points, m_normals, m_nearest, voting_passes);
    }
    else {
      Points sides;
      for(const Index i : m_original)
        sides.push_back(has_normals ? m_input.normals[i] : hints()[i]);
      orient_by_sides(m_execution, m_normals, sides, m_nearest);
      if(has_normals)
        for(std::size_t i = 0; i < m_normals.size(); ++i)
          m_normals[i] = normalized_or(sides[i], m_normals[i]);
    }
    m_result.inconsistent_neighbors = inconsistent_neighbors(m_points, m_normals, m_nearest);
    m_kept_points = m_points;
    m_kept_normals = m_normals;
  }

  void prepare_guard()
  {
    if(!m_parameters.guard.enabled)
      return;
    if(!m_input.directions.view.empty())
      m_free_space = Free_space(m_execution, m_kept_points, kept_directions(),
                                m_parameters.guard.free_space_tolerance * m_h);
    m_guard = Placement_guard(m_kept_points, m_kept_normals, m_free_space, m_h, m_parameters.guard);
  }

  /// Lines 3 to 18 of algorithm 1.
  void iterate(double share, double h_factor, std::size_t repulsion_steps)
  {
    const double h = h_factor * m_h;
    const Placement_test may_place = [this](const Vec3& x, const Vec3& n) { return m_guard(x, n); };
    const double iteration_share = share / double((std::max)(std::size_t(1), m_parameters.iterations));
    const double least_distance =
      (std::max)(m_parameters.selection_distance * h,
                 nearest_distance(m_execution, m_kept_points, m_nearest) / 2);

    std::size_t first_alive = 0, largest = 0;
    for(std::size_t i = 0; i < m_parameters.iterations; ++i) {
      Stage stage(m_execution, "iteration", iteration_share);
      stage.count_iteration();
      update_particle_normals(m_execution, m_points, m_normals, m_h, m_particles, first_alive,
                              m_particle_normals);
      std::vector<char> is_static(m_particles.size(), 0);
      for(std::size_t k = 0; k < m_particles.size(); ++k)
        is_static[k] = k < first_alive || is_in_static_region(m_particles[k]);
      Repulsion_parameters repulsion = m_parameters.repulsion;
      repulsion.support_radius = h;
      repulsion.steps = repulsion_steps;
      repulsion.largest_step = h / 2;  // L_avg
      Surface_repulsion(m_execution, m_particles, m_particle_normals, repulsion, may_place)
        .run(stage, m_particles, m_particle_normals, is_static);

      Points surface = m_particles, surface_normals = m_particle_normals;
      std::vector<std::size_t> centres;
      for(std::size_t k = first_alive; k < m_particles.size(); ++k)
        centres.push_back(k);
      Interpolatory_upsampling(m_execution, upsampling_parameters(h), may_place)
        .run(stage, surface, surface_normals, std::move(centres));

      const Sorted_grid grid(m_points, least_distance);
      const std::vector<std::size_t> selected =
        select_new_points(m_execution, grid, surface, first_alive, least_distance);
      Points added;
      for(const std::size_t k : selected) {
        if(!may_place(surface[k], surface_normals[k]))
          continue;
        added.push_back(surface[k]);
        m_points.push_back(surface[k]);
        m_normals.push_back(surface_normals[k]);
      }
      m_result.new_counts.push_back(added.size());
      largest = (std::max)(largest, added.size());
      // Holes take fewer points than there are; points of which most coincide would be spread out without end.
      constexpr std::size_t most_growth = 50;
      if(added.empty() || i + 1 == m_parameters.iterations || m_points.size() > most_growth * m_number_of_kept ||
         double(added.size()) < (std::max)(m_parameters.least_new_share > 0 ? double(least_new_points) : 1.,
                                           m_parameters.least_new_share * double(largest)))
        break;

      if(!m_parameters.adaptive) {
        first_alive = 0;
        sample_particles(m_points, m_number_of_particles * m_points.size() / m_number_of_kept);
        move_particles(stage, m_points, std::vector<char>());
        continue;
      }
      // line 17; m^i = 2 m |P^i| / |P^0|
      first_alive = m_particles.size();
      const double count = m_parameters.particles_per_new_point * double(m_number_of_particles) *
                           double(added.size()) / double(m_input.points.size());
      for(const std::size_t k : random_subset(added.size(), (std::max)(std::size_t(1), std::size_t(count)),
                                              m_parameters.seed + i + 1))
        m_particles.push_back(added[k]);
      std::vector<char> is_old(m_particles.size(), 0);
      std::fill(is_old.begin(), is_old.begin() + std::ptrdiff_t(first_alive), 1);
      move_particles(stage, m_points, is_old);
    }
  }

  void sample_particles(const Points& from, std::size_t count)
  {
    m_particles.clear();
    for(const std::size_t k : random_subset(from.size(), count, m_parameters.seed))
      m_particles.push_back(from[k]);
  }

  Scan_directions kept_directions() const
  {
    Scan_directions directions;
    for(const Index i : m_original) {
      directions.towards_scanner.push_back(m_input.directions.towards_scanner[i]);
      directions.view.push_back(m_input.directions.view[i]);
    }
    return directions;
  }

  Upsampling_parameters upsampling_parameters(double h) const
  {
    Upsampling_parameters parameters = m_parameters.upsampling;
    parameters.least_distance *= h;
    parameters.support_radius = h;
    return parameters;
  }

  bool is_in_static_region(const Vec3& x)
  {
    if(m_input.is_constrained.empty())
      return false;
    if(!m_region_tree)
      m_region_tree = std::make_unique<Nearest_neighbors>(m_input.points);
    return m_input.is_constrained[m_region_tree->nearest(x).index] != 0;
  }

  /// Takes back what closed no hole, and lists the result.
  void finish()
  {
    Stage stage(m_execution, "selection", 0.05);
    std::vector<char> removed(m_points.size(), 0);
    if(m_parameters.takes_back_open_borders && m_h > 0) {
      Peel_parameters peel = m_parameters.peel;
      peel.radius *= m_h;
      removed = peel_open_borders(m_execution, m_points, m_normals, m_number_of_kept, peel);
    }
    Points added, added_normals;
    for(std::size_t i = m_number_of_kept; i < m_points.size(); ++i)
      if(!removed[i]) {
        added.push_back(m_points[i]);
        added_normals.push_back(m_normals[i]);
      }
    const Nearest_neighbors data(m_execution, m_kept_points);
    accept(added, added_normals, data);
    for(const Vec3& x : m_result.new_points)
      m_result.new_confidence.push_back(confidence(std::sqrt(data.nearest(x).squared_distance) / spacing()));
    m_result.normals.assign(m_input.points.size(), Vec3::UnitZ());
    for(std::size_t k = 0; k < m_number_of_kept; ++k)
      m_result.normals[m_original[k]] = m_normals[k];
    if(m_number_of_kept > 0)
      parallel_for(m_execution, m_input.points.size(), [&](std::size_t i) {
        if(m_result.is_outlier[i])
          m_result.normals[i] = m_normals[data.nearest(m_input.points[i]).index];
      });
    m_result.support_radius = m_h;
  }

  /// Of the added points, takes over those in regions that close a hole, moved to fair surfaces.
  void accept(const Points& added, const Points& normals, const Nearest_neighbors& data)
  {
    if(added.empty())
      return;
    std::vector<std::vector<Index> > regions = connected_components(added, region_radius * m_h);
    for(std::vector<Index>& members : regions)
      std::sort(members.begin(), members.end());  // sums in the points' order
    const std::vector<char> is_doubtful =
      m_guard.doubtful_regions(m_execution, added, normals, regions, m_points.size() - m_number_of_kept);
    std::vector<Hole> holes(regions.size());
    for(std::size_t k = 0; k < regions.size(); ++k)
      if(!is_doubtful[k])
        holes[k] = {selected(added, regions[k]), selected(normals, regions[k])};
    if(m_parameters.fairs_holes && m_parameters.guard.enabled) {  // without guard, regions need not be holes
      const Hole_filling filling(m_execution, m_kept_points, m_kept_normals, data, m_h, region_radius * m_h, m_guard);
      parallel_for(m_execution, holes.size(), [&](std::size_t k) {
        if(!holes[k].points.empty())
          filling.run(holes[k]);
      }, long_bodies);
    }
    for(const Hole& hole : holes) {
      m_result.new_points.insert(m_result.new_points.end(), hole.points.begin(), hole.points.end());
      m_result.new_normals.insert(m_result.new_normals.end(), hole.normals.begin(), hole.normals.end());
    }
  }

  /// Of the particles: h = 2 L_avg, and the mean distance to 20 neighbours is 1.7 spacings.
  double spacing() const { return m_h > 0 ? m_h / 3.4 : 1; }

  Execution& m_execution;
  const Iterative_input& m_input;
  Iterative_parameters m_parameters;
  Iterative_result m_result;

  double m_h = 0;
  std::size_t m_number_of_particles = 0;
  Points m_particles, m_particle_normals;          ///< X
  Nearest_table m_nearest;                         ///< of the input, later of what was kept
  std::vector<Index> m_original;                   ///< input index of the kept points
  std::size_t m_number_of_kept = 0;
  Points m_points, m_normals;                      ///< P: kept points, then added ones
  Points m_kept_points, m_kept_normals;
  Free_space m_free_space;
  Placement_guard m_guard;
  std::unique_ptr<Nearest_neighbors> m_region_tree;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ITERATIVE_CONSOLIDATION_H
