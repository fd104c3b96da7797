// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DENSITY_PEAKS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DENSITY_PEAKS_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_denser.h>
#include <CGAL/Point_set_consolidation_3/internal/numbered_segments.h>
#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Feature-enhanced surfaces paper, section IV.A: segments around peaks of the density. In: points. Out: a
/// label for every point. Two versions: equation (7), where a point follows its nearest denser point
/// wherever that is; and the same along a neighbour graph, where peaks of little prominence are merged.

/// Representativeness nu of equation (7), with theta of support radius h, cut at 0.6 h.
inline std::vector<double> representativeness(const Execution& execution, const Points& points,
                                              double h)
{
  constexpr double cutoff = 0.6;  // theta is 3e-3 there
  const Sorted_grid grid(points, cutoff * h);
  std::vector<double> density(points.size());
  const double factor = 16 / (h * h);
  parallel_for_places(execution, grid, [&](std::size_t i) {
    double sum = 0;
    grid.for_each_neighbor_block(points[i], cutoff * h, [&](const Neighbor_block& block) {
      Block_weights theta;
      sum += theta.set_gaussian(factor, block).sum();
    });
    density[i] = sum;  // the point itself is the 1 of the formula
  });
  return density;
}

/// Points from the densest to the least dense, ties by index.
inline std::vector<Index> by_falling_density(const std::vector<double>& density)
{
  std::vector<Index> order = all_indices(density.size());
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return density[a] != density[b] ? density[a] > density[b] : a < b;
  });
  return order;
}

/// Equation (7). `count`: number of centres, 0: up to the largest drop of log nu + log delta.
inline Segmentation density_peak_segments(const Execution& execution, const Points& points,
                                          double h, std::size_t count)
{
  constexpr std::size_t most_automatic = 30;  // centres: beyond, drops are those of single points
  const std::size_t n = points.size();
  const std::vector<double> density = representativeness(execution, points, h);
  const std::vector<Index> order = by_falling_density(density);
  const Points ranked = selected(points, order);
  const Nearest_denser denser(ranked);
  std::vector<std::size_t> parent(n, 0);
  std::vector<double> value(n);  // sp of equation (7), by rank
  const double diagonal = bounding_box(points).diagonal();
  parallel_for(execution, n, [&](std::size_t r) {
    double delta = diagonal;
    if(r > 0) {
      const Neighbor found = denser.find(r);
      parent[r] = found.index;
      delta = std::sqrt(found.squared_distance);
    }
    value[r] = std::log(density[order[r]]) + std::log((std::max)(delta, tiny_length));
  });

  std::vector<std::size_t> candidates = all_indices<std::size_t>(n);
  std::sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
    return value[a] != value[b] ? value[a] > value[b] : a < b;
  });
  if(count == 0) {
    double largest = -1;
    for(std::size_t k = 1; k < (std::min)(n, most_automatic + 1); ++k) {
      const double drop = value[candidates[k - 1]] - value[candidates[k]];
      if(k >= 2 && drop > largest) {  // one centre is no segmentation
        largest = drop;
        count = k;
      }
    }
    count = (std::max)(count, std::size_t(1));
  }
  count = (std::min)(count, n);

  std::vector<char> is_centre(n, 0);
  for(std::size_t k = 0; k < count; ++k)
    is_centre[candidates[k]] = 1;
  std::vector<std::size_t> root(n), raw(n);
  for(std::size_t r = 0; r < n; ++r) {
    // the densest point of all is a centre always: its delta is the diagonal
    root[r] = is_centre[r] || r == 0 ? r : root[parent[r]];
    raw[order[r]] = root[r];
  }
  return numbered_by_size(raw);
}

/// The local version: points join the segments of denser neighbours; where two segments meet, the one with the
/// lower peak is merged if its peak is less than `prominence` (in log density) above the meeting
/// point. `count` > 0: instead, the least prominent peaks are merged until `count` are left.
inline Segmentation persistence_segments(const Execution& execution, const Points& points, double h,
                                         double prominence, std::size_t count)
{
  constexpr std::size_t graph_neighbors = 8;  // of the graph that stands for the surface
  const std::size_t n = points.size();
  const std::vector<double> density = representativeness(execution, points, h);
  const std::vector<Index> order = by_falling_density(density);
  std::vector<std::size_t> rank(n);
  for(std::size_t r = 0; r < n; ++r)
    rank[order[r]] = r;
  const Nearest_table table = nearest_table(execution, points, graph_neighbors);
  std::vector<std::vector<Index> > neighbors(n);
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t k = 0; k < table.k; ++k) {
      neighbors[i].push_back(table.row(i)[k]);
      neighbors[table.row(i)[k]].push_back(Index(i));
    }

  // the merge tree: every meeting of two peaks, with the prominence of the lower one
  struct Meeting {
    double prominence;
    std::size_t lower, upper;  // ranks of the peaks
  };
  std::vector<Meeting> meetings;
  Disjoint_sets components(n);  // by rank: the representative is the peak, since it is the smallest
  std::vector<std::size_t> peak(n);
  for(std::size_t r = 0; r < n; ++r) {
    const std::size_t i = order[r];
    std::size_t steepest = r;
    for(const Index j : neighbors[i])
      if(rank[j] < steepest)
        steepest = rank[j];
    peak[r] = steepest == r ? r : peak[steepest];
    for(const Index j : neighbors[i]) {
      if(rank[j] >= r)
        continue;
      const std::size_t a = components.find(r), b = components.find(rank[j]);
      if(a == b)
        continue;
      const std::size_t lower = (std::max)(a, b), upper = (std::min)(a, b);
      if(lower != r)
        meetings.push_back({std::log(density[order[lower]] / density[i]), lower, upper});
      components.join(lower, upper);
    }
  }
  std::stable_sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) {
    return a.prominence < b.prominence;
  });
  std::size_t peaks = 0;
  for(std::size_t r = 0; r < n; ++r)
    peaks += peak[r] == r ? 1 : 0;
  Disjoint_sets merged(n);
  for(const Meeting& m : meetings) {
    if(count > 0 ? peaks <= count : m.prominence >= prominence)
      break;
    if(merged.join(m.lower, m.upper))
      --peaks;
  }
  std::vector<std::size_t> raw(n);
  for(std::size_t r = 0; r < n; ++r)
    raw[order[r]] = merged.find(peak[r]);
  return numbered_by_size(raw);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DENSITY_PEAKS_H
