// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_OUTLIER_SELECTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_OUTLIER_SELECTION_H

#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/iterative_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/near_outliers.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/quadric_fit.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-B, end: which data points are outliers. The paper's rule, the distance
/// from the up-sampled surface, finds far ones; for those closer than h the data's own surface is the reference
/// (`Near_outliers`).

inline std::size_t number_of_flagged(const std::vector<char>& flags)
{
  return std::size_t(std::count(flags.begin(), flags.end(), char(1)));
}

inline std::vector<char> either(std::vector<char> flags, const std::vector<char>& others)
{
  for(std::size_t i = 0; i < flags.size(); ++i)
    flags[i] = flags[i] || others[i];
  return flags;
}

/// Takes back the flags of patches: neighbouring points that are as dense and as smooth as the data that have none. The
/// particles' surface misses parts so thin that particles of both sides meet in their middle, and small ones.
inline void keep_patches(const Execution& execution, const Points& data, std::vector<char>& is_outlier)
{
  constexpr std::size_t compared = 2000, fitted_neighbors = 18, sparsity_neighbors = 6, least_points = 30;
  constexpr double largest_ratio = 2;   // to the others: half of the points of a plane have up to 1.2
  constexpr double smooth = 0.25;       // residual in spacings that any data may have; clean scans 0 to 0.06
  constexpr double link = 3;            // in spacings
  std::vector<Index> flagged, others;
  for(std::size_t i = 0; i < data.size(); ++i)
    (is_outlier[i] ? flagged : others).push_back(Index(i));
  if(flagged.size() < least_points || others.empty())
    return;
  const Nearest_neighbors tree(execution, data);
  const auto measure = [&](const std::vector<Index>& indices, std::vector<double>& sparsity,
                           std::vector<double>& residual) {
    sparsity.assign(indices.size(), 0.);
    residual.assign(indices.size(), 0.);
    parallel_for(execution, indices.size(), [&](std::size_t k) {
      std::vector<Neighbor> found;
      tree.find(data[indices[k]], fitted_neighbors, found);
      residual[k] = fit_quadric(data, data[indices[k]], found).residual;
      const std::size_t count = (std::min)(found.size(), sparsity_neighbors + 1);
      for(std::size_t j = 1; j < count; ++j)
        sparsity[k] += std::sqrt(found[j].squared_distance) / double(count - 1);
    });
  };
  const std::size_t stride = 1 + others.size() / compared;
  std::vector<Index> sample;
  for(std::size_t k = 0; k < others.size(); k += stride)
    sample.push_back(others[k]);
  std::vector<double> sparsity, residual;
  measure(sample, sparsity, residual);
  const double spacing = median(sparsity);
  const double noise = (std::max)(smooth * spacing, median(residual));
  measure(flagged, sparsity, residual);
  std::vector<Index> surface_like;
  for(std::size_t k = 0; k < flagged.size(); ++k)
    if(sparsity[k] < largest_ratio * spacing && residual[k] < largest_ratio * noise)
      surface_like.push_back(flagged[k]);
  for(const std::vector<Index>& patch : connected_components(selected(data, surface_like), link * spacing))
    if(patch.size() >= least_points)
      for(const Index k : patch)
        is_outlier[surface_like[k]] = 0;
}

/// One flag per data point. `surface`: the up-sampled points.
inline std::vector<char> outlier_points(const Execution& execution, const Points& data,
                                        const Points& surface, const Points& surface_normals,
                                        const Outlier_parameters& parameters)
{
  std::vector<char> is_outlier(data.size(), 0), is_beyond(data.size(), 0);
  if(surface.empty())
    return is_outlier;
  constexpr std::size_t planes = 6;
  const double h = parameters.support_radius;
  const Nearest_neighbors tree(execution, surface);
  const std::vector<Index> order = place_order(data);
  Data_on_surface foot{data, Points(data.size()), std::vector<double>(data.size())};
  parallel_for_places(execution, order, [&](std::size_t i) {
    std::vector<Neighbor> found;
    tree.find(data[i], planes, found);
    const Vec3& side = surface_normals[found.front().index];
    Vec3 normal = Vec3::Zero();
    double height = 0;
    for(const Neighbor& u : found) {
      const Vec3& n = surface_normals[u.index];
      const double d = n.dot(data[i] - surface[u.index]);
      foot.distance[i] += std::abs(d) / double(found.size());  // mean, from the tangent planes
      const double sign = n.dot(side) < 0 ? -1 : 1;
      height += sign * d / double(found.size());
      normal += sign * n;
    }
    foot.normals[i] = normalized_or(normal, side);
    foot.feet[i] -= height * foot.normals[i];
    const double far = parameters.far_distance * h;
    is_outlier[i] = found.front().squared_distance > far * far;
    is_beyond[i] = found.front().squared_distance > (std::max)(far, h) * (std::max)(far, h);
  });

  keep_patches(execution, data, is_outlier);
  for(std::size_t i = 0; i < data.size(); ++i)
    is_beyond[i] = is_beyond[i] && is_outlier[i];

  if(parameters.removes_near) {
    constexpr double suspicious = 0.3;  // of the least distance: the particles' surface is farther from most outliers
    std::vector<char> is_candidate(data.size());
    for(std::size_t i = 0; i < data.size(); ++i)
      is_candidate[i] = !is_outlier[i] && foot.distance[i] > suspicious * parameters.near.front().distance * h;
    const Near_outliers near(execution, data, order, foot, parameters);
    // without those found before, which hide others and spoil the fits
    constexpr int passes = 3;
    std::vector<char> is_near(data.size(), 0);
    for(int pass = 0; pass < passes; ++pass) {
      std::vector<char> found = near.find(is_candidate, either(is_outlier, is_near), parameters.near);
      const bool is_settled = found == is_near;
      is_near.swap(found);
      if(is_settled)
        break;
    }
    if(double(number_of_flagged(is_near)) <
       (std::max)(parameters.scattered_share * double(data.size()),
                  parameters.scattered_share_of_far * double(number_of_flagged(is_outlier)))) {
      is_candidate = is_near;
      is_near = near.find(is_candidate, either(is_outlier, is_near), {parameters.scattered});
    }
    is_outlier = either(is_outlier, is_near);
  }
  return double(number_of_flagged(is_outlier)) < parameters.least_share * double(data.size()) ? is_beyond : is_outlier;
}

/// The table of the points that remain, `original` in increasing order; rows that have lost neighbours are
/// searched anew.
inline Nearest_table restricted_table(const Execution& execution, const Nearest_table& all,
                                      const Points& points, const std::vector<Index>& original)
{
  constexpr Index none = (std::numeric_limits<Index>::max)();
  std::vector<Index> place(all.k == 0 ? 0 : all.size(), none);
  for(std::size_t i = 0; i < original.size() && !place.empty(); ++i)
    place[original[i]] = Index(i);
  Nearest_table table;
  table.k = (std::min)(all.k, points.empty() ? 0 : points.size() - 1);
  table.neighbors.resize(points.size() * table.k);
  const Nearest_neighbors tree(execution, points);
  parallel_for(execution, points.size(), [&](std::size_t i) {
    const Index* old = all.row(original[i]);
    Index* row = table.neighbors.data() + i * table.k;
    std::size_t count = 0;
    for(std::size_t k = 0; k < all.k; ++k)
      if(place[old[k]] != none && count < table.k)
        row[count++] = place[old[k]];
    if(count == table.k)
      return;
    std::vector<Neighbor> found;
    tree.find(points[i], table.k + 1, found);
    count = 0;
    for(const Neighbor& neighbor : found)
      if(neighbor.index != i && count < table.k)
        row[count++] = neighbor.index;
    while(count < table.k)
      row[count++] = Index(i);
  });
  return table;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_OUTLIER_SELECTION_H
