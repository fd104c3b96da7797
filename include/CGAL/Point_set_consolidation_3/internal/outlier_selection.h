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
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/quadric_fit.h>
#include <CGAL/Point_set_consolidation_3/internal/thinning.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Iterative consolidation paper, section IV-B, end: which data points are outliers. The paper's rule, the distance
/// from the up-sampled surface, finds far ones; for those closer than h the data's own surface is the reference.

/// Heights over a tangent plane as a quadric of the plane's coordinates, fitted to neighbours of which many may
/// be outliers: iteratively reweighted least squares with Cauchy weights. The particles' surface, which is coarser
/// than the data, gives plane and first weights only.
class Robust_height {
  static constexpr std::size_t iterations = 6;
  typedef Height_frame::Vector Vector;
  typedef Height_frame::Matrix Matrix;

public:
  /// Offsets are relative to the origin of the plane.
  Robust_height(const Vec3& normal, std::size_t capacity)
  {
    Vec3::Index smallest;
    normal.cwiseAbs().minCoeff(&smallest);
    m_frame.normal = normal;
    m_frame.u = normalized_or(normal.cross(Vec3(Vec3::Unit(smallest))), Vec3::UnitX());
    m_frame.v = normal.cross(m_frame.u);
    m_offsets.reserve(capacity);
    m_first_distances.reserve(capacity);
  }

  /// `distance`: of the neighbour from the particles' surface.
  void add(const Vec3& offset, double distance)
  {
    m_offsets.push_back(offset);
    m_first_distances.push_back(distance);
  }

  /// False if there are too few neighbours. `least_scale` bounds the residuals' scale from below.
  bool fit(double least_scale)
  {
    const std::size_t n = m_offsets.size();
    if(n < 2 * Height_frame::coefficients)
      return false;
    m_frame.unit = 0;
    for(const Vec3& d : m_offsets)
      m_frame.unit = (std::max)(m_frame.unit, std::hypot(m_frame.u.dot(d), m_frame.v.dot(d)));
    if(!(m_frame.unit > 0))
      return false;
    std::vector<Vector> rows(n);
    std::vector<double> heights(n);
    for(std::size_t k = 0; k < n; ++k) {
      rows[k] = m_frame.monomials(m_offsets[k]);
      heights[k] = m_frame.height(m_offsets[k]);
    }
    m_residuals = m_first_distances;
    for(std::size_t t = 0; t < iterations; ++t) {
      const double scale = (std::max)(least_scale, 1.5 * median(m_residuals));
      Matrix A = Matrix::Zero();
      Vector b = Vector::Zero();
      for(std::size_t k = 0; k < n; ++k) {
        const double r = m_residuals[k] / scale, weight = 1 / ((1 + r * r) * (1 + r * r));
        A += weight * rows[k] * rows[k].transpose();
        b += weight * heights[k] * rows[k];
      }
      A.diagonal().array() += 1e-6 * A(0, 0);
      m_c = solve_normal_equations(A, b);
      if(!m_c.allFinite())
        return false;
      for(std::size_t k = 0; k < n; ++k)
        m_residuals[k] = std::abs(heights[k] - rows[k].dot(m_c));
    }
    return true;
  }

  double median_residual() const { return median(m_residuals); }

  /// Distance from the quadric, to first order.
  double distance(const Vec3& offset) const
  {
    const double slope = std::hypot(m_c[1], m_c[2]) / m_frame.unit;
    return std::abs(m_frame.height(offset) - m_frame.monomials(offset).dot(m_c)) /
           std::sqrt(1 + slope * slope);
  }

private:
  Height_frame m_frame;
  std::vector<Vec3> m_offsets;
  std::vector<double> m_first_distances, m_residuals;
  Vector m_c = Vector::Zero();
};

/// Of `is_candidate`, the data off the surface of the data that `is_left_out` does not flag. `feet` and `normals` are
/// those of the data on the particles' surface, `distance` their distances from it; `order` is that of places.
inline std::vector<char> near_outliers(const Execution& execution, const Points& data,
                                       const std::vector<Index>& order, const Points& feet, const Points& normals,
                                       const std::vector<double>& distance, const std::vector<char>& is_candidate,
                                       const std::vector<char>& is_left_out,
                                       const std::vector<Outlier_evidence>& evidences,
                                       const Outlier_parameters& parameters)
{
  constexpr std::size_t fitted_neighbors = 24, sparsity_neighbors = 6;
  constexpr double least_scale = 0.25;  // of the limit: smaller residuals all have full weight
  const double h = parameters.support_radius, limit = evidences.front().distance * h;
  std::vector<std::size_t> kept;
  Points points;
  for(std::size_t i = 0; i < data.size(); ++i)
    if(!is_left_out[i]) {
      kept.push_back(i);
      points.push_back(data[i]);
    }
  std::vector<char> is_outlier(data.size(), 0);
  if(kept.size() <= fitted_neighbors)
    return is_outlier;
  const Nearest_neighbors tree(execution, points);
  const auto neighbors_of = [&](std::size_t i, const Vec3& place, std::size_t k) {
    std::vector<Neighbor> found;
    tree.find(place, k + 1, found);
    const auto self = std::find_if(found.begin(), found.end(),
                                   [&](const Neighbor& n) { return kept[n.index] == i; });
    found.erase(self == found.end() ? found.end() - 1 : self);
    return found;
  };
  std::vector<double> sparsity(data.size(), 0.);
  parallel_for_places(execution, order, [&](std::size_t i) {
    for(const Neighbor& neighbor : neighbors_of(i, data[i], sparsity_neighbors))
      sparsity[i] += std::sqrt(neighbor.squared_distance);
  });
  double least_sparsity = evidences.front().sparsity;
  for(const Outlier_evidence& evidence : evidences)
    least_sparsity = (std::min)(least_sparsity, evidence.sparsity);
  // how dense the data is, the neighbours of the foot tell: those of the point may be outliers themselves
  const auto is_off = [&](std::size_t i, const Vec3& place, bool tests_sparsity) {
    const std::vector<Neighbor> found = neighbors_of(i, place, fitted_neighbors);
    std::vector<double> sparsities;
    sparsities.reserve(found.size());
    for(const Neighbor& neighbor : found)
      sparsities.push_back(sparsity[kept[neighbor.index]]);
    const double relative_sparsity = sparsity[i] / median(std::move(sparsities));
    if(tests_sparsity && relative_sparsity <= least_sparsity)
      return false;
    Robust_height quadric(normals[i], found.size());
    for(const Neighbor& neighbor : found)
      quadric.add(points[neighbor.index] - feet[i], distance[kept[neighbor.index]]);
    if(!quadric.fit(least_scale * limit))
      return false;
    const double off = quadric.distance(data[i] - feet[i]);
    return off > limit && off > parameters.near_factor * quadric.median_residual() &&
           (!tests_sparsity ||
            std::any_of(evidences.begin(), evidences.end(), [&](const Outlier_evidence& evidence) {
              return off > evidence.distance * h && relative_sparsity > evidence.sparsity;
            }));
  };
  parallel_for_places(execution, order, [&](std::size_t i) {
    is_outlier[i] = is_candidate[i] && is_off(i, feet[i], true) && is_off(i, data[i], false);
  });
  return is_outlier;
}

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
  std::vector<double> distance(data.size());  // mean, from the tangent planes
  Points feet = data, normals(data.size());   // on the particles' surface
  parallel_for_places(execution, order, [&](std::size_t i) {
    std::vector<Neighbor> found;
    tree.find(data[i], planes, found);
    const Vec3& side = surface_normals[found.front().index];
    Vec3 normal = Vec3::Zero();
    double height = 0;
    for(const Neighbor& u : found) {
      const Vec3& n = surface_normals[u.index];
      const double d = n.dot(data[i] - surface[u.index]);
      distance[i] += std::abs(d) / double(found.size());
      const double sign = n.dot(side) < 0 ? -1 : 1;
      height += sign * d / double(found.size());
      normal += sign * n;
    }
    normals[i] = normalized_or(normal, side);
    feet[i] -= height * normals[i];
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
      is_candidate[i] = !is_outlier[i] && distance[i] > suspicious * parameters.near.front().distance * h;
    const auto near_outliers_of = [&](const std::vector<Outlier_evidence>& evidences,
                                      const std::vector<char>& is_near) {
      return near_outliers(execution, data, order, feet, normals, distance, is_candidate,
                           either(is_outlier, is_near), evidences, parameters);
    };
    // without those found before, which hide others and spoil the fits
    constexpr int passes = 3;
    std::vector<char> is_near(data.size(), 0);
    for(int pass = 0; pass < passes; ++pass) {
      std::vector<char> found = near_outliers_of(parameters.near, is_near);
      const bool is_settled = found == is_near;
      is_near.swap(found);
      if(is_settled)
        break;
    }
    if(double(number_of_flagged(is_near)) <
       (std::max)(parameters.scattered_share * double(data.size()),
                  parameters.scattered_share_of_far * double(number_of_flagged(is_outlier)))) {
      is_candidate = is_near;
      is_near = near_outliers_of({parameters.scattered}, is_near);
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
