// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INPUT_STAGE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INPUT_STAGE_H

#include <CGAL/Point_set_consolidation_3/internal/consolidated_input.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/dipole_orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/isolated_points.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/range_denoising.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>
#include <CGAL/Point_set_consolidation_3/internal/seen_part.h>
#include <CGAL/Point_set_consolidation_3/internal/view_estimation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <functional>
#include <iterator>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points paper, section 3: the raw points C become a denoised, oriented, evenly spread set S, by CGAL's
/// WLOP and jet fitting, in the frame whose unit is the spacing r of S, equation (1).

typedef CGAL::Simple_cartesian<double> Core_kernel;

/// Points by their indices.
struct Indexed_point_map {
  typedef Index key_type;
  typedef Core_kernel::Point_3 value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;
  const Points* points;

  friend reference get(const Indexed_point_map& map, Index i)
  {
    const Vec3& p = (*map.points)[i];
    return value_type(p.x(), p.y(), p.z());
  }
};

/// Normals by the same indices, to write.
struct Indexed_normal_map {
  typedef Index key_type;
  typedef Core_kernel::Vector_3 value_type;
  typedef value_type reference;
  typedef boost::writable_property_map_tag category;
  Points* normals;

  friend void put(const Indexed_normal_map& map, Index i, const value_type& n)
  {
    (*map.normals)[i] = Vec3(n.x(), n.y(), n.z());
  }
};

/// CGAL's WLOP with the neighbourhood that measured best: twice the spacing of the output. (Its own
/// default, eight spacings of the input, depends on the share that is kept.) Works on indices:
/// CGAL shuffles the range it is given, and this is where most memory is in use.
inline Points wlop(Execution& execution, Stage& stage, const Points& data, std::size_t count,
                   double neighbor_radius, unsigned int iterations, bool require_uniform_sampling)
{
  if(count >= data.size())
    count = data.size();
  const Indexed_point_map point_map{&data};
  std::vector<Index> shuffled = all_indices(data.size());
  std::vector<Core_kernel::Point_3> output;
  output.reserve(count);
  // half a point more, so that the truncation inside gives `count`
  const double percentage =
    (std::min)(100., 100. * (double(count) + 0.5) / double(data.size()));
  run_observed(stage, execution, [&](const std::function<bool(double)>& observer) {
    output.clear();
    const auto np = CGAL::parameters::point_map(point_map)
                      .select_percentage(percentage)
                      .neighbor_radius(neighbor_radius)
                      .number_of_iterations(iterations)
                      .require_uniform_sampling(require_uniform_sampling);
    with_concurrency_tag(execution, [&](auto tag) {
      typedef decltype(tag) Tag;
      if(observer)
        CGAL::wlop_simplify_and_regularize_point_set<Tag>(
          shuffled, std::back_inserter(output), np.callback([&](double f) { return observer(f); }));
      else
        CGAL::wlop_simplify_and_regularize_point_set<Tag>(shuffled, std::back_inserter(output), np);
    });
  });
  Points points;
  points.reserve(output.size());
  for(const Core_kernel::Point_3& p : output) {
    const Vec3 q(p.x(), p.y(), p.z());
    if(q.allFinite())
      points.push_back(q);
  }
  return points;
}

/// The points that do not coincide with all of their nearest others.
inline Points points_with_extent(const Execution& execution, const Points& points, unsigned int neighbors)
{
  constexpr double least = 1e-100;  // squares do not vanish
  const std::vector<double> distance =
    neighbor_distances(execution, Nearest_neighbors(execution, points), points, neighbors);
  Points result;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(distance[i] > least)
      result.push_back(points[i]);
  return result;
}

/// Unoriented normals by CGAL's jet fitting; +z where the fit fails.
inline Points jet_normals(const Execution& execution, const Points& points, unsigned int neighbors)
{
  Points normals(points.size(), Vec3::UnitZ());
  if(points.size() < 3)
    return normals;
  // a jet of degree 2 needs six points; small sets get a plane
  constexpr std::size_t jet_points = 6;
  neighbors = (unsigned int)((std::min)(std::size_t(neighbors), points.size() - 1));
  // CGAL divides by the extent of the neighbours; where it is 0, Eigen's decomposition reads what it has not written
  const Points others = points_with_extent(execution, points, neighbors);
  if(others.size() < points.size()) {
    const Points of_others = jet_normals(execution, others, neighbors);
    const Nearest_neighbors tree(others);
    for(std::size_t i = 0; i < points.size() && !others.empty(); ++i)
      normals[i] = of_others[tree.nearest(points[i]).index];
    return normals;
  }
  std::vector<Index> indices = all_indices(points.size());
  const auto np =
    CGAL::parameters::point_map(Indexed_point_map{&points}).normal_map(Indexed_normal_map{&normals});
  with_concurrency_tag(execution, [&](auto tag) {
    typedef decltype(tag) Tag;
    if(neighbors + 1 >= jet_points)
      CGAL::jet_estimate_normals<Tag>(indices, neighbors, np);
    else
      CGAL::pca_estimate_normals<Tag>(indices, (std::max)(2u, neighbors), np);
  });
  for(Vec3& n : normals)
    n = n.allFinite() ? normalized_or(n, Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
  return normals;
}

/// A twentieth of the data, at least 4000 points: enough for the shapes of the accuracy study.
inline std::size_t default_particles(std::size_t n)
{
  return (std::min)(n, (std::max)(std::size_t(4000), n / 20));
}

inline std::size_t number_of_particles(const Input_parameters& parameters, std::size_t n)
{
  return parameters.particles > 0 ? (std::min)(parameters.particles, n) : default_particles(n);
}

/// Outliers that stayed in the scan, as all do where none are looked for, leave lone particles, which would stretch
/// every box. These are far from all others: nothing of what tells outliers of the scan from its sparse parts is
/// needed.
inline void remove_lone_particles(const Execution& execution, Points& points)
{
  constexpr std::size_t neighbors = 6;
  constexpr double far = 8;  // times the median distance to them
  const std::vector<double> distance =
    neighbor_distances(execution, Nearest_neighbors(execution, points), points, neighbors);
  const double largest = far * median(distance);
  std::vector<Index> kept;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(distance[i] <= largest)
      kept.push_back(Index(i));
  points = selected(points, kept);
}

/// Finds the outer sides of the data. In strong noise their normals, of few neighbours, are no help: some of the data
/// with normals of as many as the noise needs are oriented first. (Two and three views, 2 % of noise: of 14 models 17 %
/// of the sides were wrong in the mean, 12 % then; with 0.5 % of noise thin parts got lost.)
inline void orient_outwards(const Execution& execution, const Points& data, Seen_part& seen)
{
  constexpr std::size_t usual_neighbors = 30, most_neighbors = 60;  // as many as 0.5 % of noise needs
  if(seen.is_noisy) {
    const Nearest_neighbors tree(execution, data);
    const std::size_t neighbors = Seen_part_estimation::resolving_neighbors(execution, data, tree);
    if(neighbors > most_neighbors) {
      const std::size_t count = data.size() * usual_neighbors / neighbors;
      Points points = selected(data, random_subset(data.size(), count, 0)), normals;
      Seen_part_estimation::project(execution, data, tree, neighbors, points, normals);
      orient_by_dipoles(execution, points, normals);
      orient_by_hints(execution, seen.points, seen.normals, points, normals);
      return;
    }
  }
  orient_by_dipoles(execution, seen.points, seen.normals);
}

/// The data with outward normals: on the side of the rough ones in `hints`, or found. Particles are coarser than thin
/// parts, where they get 20 times as many sides wrong.
inline Seen_part oriented_data(const Execution& execution, const Points& data, const Points& hints)
{
  Seen_part seen = Seen_part_estimation::estimate(execution, data);
  if(!hints.empty())
    orient_by_hints(execution, data, seen.normals, data, hints);
  else
    orient_outwards(execution, data, seen);
  return seen;
}

/// A scan that can have been taken from one side is taken for one from there, with parallel rays.
inline void assume_single_view(const Execution& execution, bool is_oriented, Consolidated_input& input)
{
  const std::optional<Vec3> axis = View_estimation(execution, input.points, input.normals).run(is_oriented);
  if(!axis)
    return;
  input.directions.towards_scanner.assign(input.data.size(), *axis);
  input.directions.view.assign(input.data.size(), 0);
  input.directions.is_estimated = true;
  for(Vec3& n : input.normals)
    if(n.dot(*axis) < 0)
      n = -n;
}

/// Particles of the data in `input`, whose unit becomes their spacing r, equation (1). The data get sides beside it if
/// they have to be found, to which the particles are nothing: CGAL's WLOP, sequential in part, leaves a thread free.
inline void project_particles(Execution& execution, double share, bool find_sides, const Points& hints,
                              const Input_parameters& parameters, Consolidated_input& input)
{
  Stage stage(execution, "wlop", share);
  const auto project = [&] {
    const std::size_t count = number_of_particles(parameters, input.data.size());
    const double radius = parameters.neighbor_radius > 0 ? parameters.neighbor_radius / input.frame.unit : 2;
    input.points = wlop(execution, stage, input.data, count, radius, parameters.iterations,
                        parameters.require_uniform_sampling);
    remove_lone_particles(execution, input.points);
  };
  if(find_sides)
    run_both(execution, project, [&] { input.seen = oriented_data(execution, input.data, hints); });
  else
    project();
  const double r =
    mean(neighbor_distances(execution, Nearest_neighbors(input.points), input.points, 1));
  if(!(r > 0))
    throw Unusable_input(parameters.neighbor_radius > 0
                                  ? "neighbor_radius is far too large: WLOP draws all points together"
                                  : "the consolidated points coincide: no spacing to work with");
  input.frame.unit *= r;
  for(Points* points : {&input.points, &input.data})
    for(Vec3& p : *points)
      p /= r;
  input.seen.change_unit(r);
}

/// Their normals. Where the scanner is not known, its direction is looked for.
inline void orient_particles(Execution& execution, double share, bool is_oriented, const Input_parameters& parameters,
                             Consolidated_input& input)
{
  Stage stage(execution, "normals", share);
  input.normals = jet_normals(execution, input.points, parameters.normal_neighbors);
  stage.update(0.5);
  if(!input.directions.empty())
    orient_by_hints(execution, input.points, input.normals, input.data, input.directions.towards_scanner);
  else {
    orient_by_hints(execution, input.points, input.normals, input.data, input.seen.normals);
    assume_single_view(execution, is_oriented, input);
  }
}

/// Indices of the points that belong to a surface or to a frozen region. `are_known`: outliers were found before.
inline std::vector<Index> without_outliers(const Execution& execution, const Points& points,
                                           const std::vector<char>& is_frozen, bool are_known)
{
  const std::vector<char> is_isolated = Isolated_points(execution, points).run(are_known);
  std::vector<Index> kept;
  kept.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!is_isolated[i] || (!is_frozen.empty() && is_frozen[i]))
      kept.push_back(Index(i));
  return kept;
}

/// Those of [0, n) that are not among `kept`, which increase.
inline std::vector<std::size_t> others(const std::vector<Index>& kept, std::size_t n)
{
  std::vector<std::size_t> result;
  result.reserve(n - kept.size());
  for(std::size_t i = 0, next = 0; i < n; ++i)
    if(next < kept.size() && kept[next] == i)
      ++next;
    else
      result.push_back(i);
  return result;
}

/// Of the scan's points in `kept`. Noise along rays goes before all else; where it went, the outliers that it had
/// hidden stand out and go from `kept` as well; where the rays were found, particles are made anew. Parts of the scan
/// are taken when they are needed, not before, for the sake of memory.
inline Consolidated_input consolidate_data(Execution& execution, double share, const Raw_scan& scan,
                                           std::vector<Index>& kept, const Input_parameters& parameters)
{
  const bool had_outliers = kept.size() < scan.points.size();
  Consolidated_input input;
  input.data = selected(scan.points, kept);
  input.frame = data_frame(execution, input.data, number_of_particles(parameters, input.data.size()));
  const Frame frame = input.frame;
  if(!(frame.unit > 0))
    throw Unusable_input("more than half of the points coincide: no spacing to work with");
  for(Vec3& p : input.data)
    p = frame.to_local(p);
  const auto denoise = [&](const Scan_directions& directions) {
    if(!parameters.denoise_along_rays || directions.empty())
      return;
    Stage stage(execution, "denoising", 0.05 * share);
    input.is_denoised = denoise_along_rays(execution, directions, input.data);
    if(!input.is_denoised || !parameters.detect_outliers)
      return;
    const std::vector<Index> rest =
      without_outliers(execution, input.data, selected_if_any(scan.gaps.is_frozen, kept), had_outliers);
    input.data = selected(input.data, rest);
    kept = selected(kept, rest);
  };
  const auto make_particles = [&](double part) {
    project_particles(execution, 0.9 * part, scan.directions.empty(), selected_if_any(scan.hints, kept), parameters,
                      input);
    if(!scan.directions.empty()) {
      input.directions = scan.directions.part(kept);
      for(Vec3& p : input.directions.missed)
        p = input.frame.to_local(p);
    }
    orient_particles(execution, 0.1 * part, !scan.hints.empty(), parameters, input);
  };
  if(!scan.directions.empty()) {
    denoise(scan.directions.part(kept));
    make_particles(0.9 * share);
  }
  else {
    make_particles(0.5 * share);
    denoise(input.directions);
    if(input.is_denoised) {
      const double r = input.frame.unit / frame.unit;
      for(Vec3& p : input.data)
        p *= r;
      input.frame = frame;
      input.seen = Seen_part();
      input.directions = Scan_directions();
      make_particles(0.4 * share);
    }
  }
  input.gaps = scan.gaps.part(kept);
  return input;
}

/// Leaves the outliers out.
inline Consolidated_input consolidate_input(Execution& execution, double share, const Raw_scan& scan,
                                            const Input_parameters& parameters)
{
  const std::size_t n = scan.points.size();
  std::vector<Index> kept = all_indices(n);
  if(parameters.detect_outliers) {
    Stage stage(execution, "outliers", 0.02 * share);
    kept = without_outliers(execution, scan.points, scan.gaps.is_frozen, false);
  }
  Consolidated_input input = consolidate_data(execution, share, scan, kept, parameters);
  input.outliers = others(kept, n);
  if(!input.outliers.empty()) {
    input.place.resize(n);
    for(std::size_t k = 0; k < kept.size(); ++k)
      input.place[kept[k]] = Index(k);
    const Nearest_neighbors tree(selected(scan.points, kept));
    for(const std::size_t i : input.outliers)
      input.place[i] = tree.nearest(scan.points[i]).index;
  }
  return input;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_INPUT_STAGE_H
