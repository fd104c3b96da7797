// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_DENOISING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_DENOISING_H

#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/views.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// A range scanner errs along its rays: in the image of a view the places of points are exact and only their heights,
/// towards the scanner, are not. So heights are smoothed over the image, where what lies behind a part is not
/// near it; neighbourhoods in space mix the front and the back of parts that are thinner than the noise.
class Range_denoising {
  static constexpr std::size_t least_neighbors = 12;  ///< twice the coefficients of a quadric
  static constexpr std::size_t noise_samples = 4000;
  static constexpr double noise_neighbors = 30;
  static constexpr double noisy = 0.5;                ///< in spacings of the image; clean scans 0 to 0.3 (fandisk)
  /// For each spacing that the noise is large. Error of meshes relative to that of the raw scan, three views of four to
  /// six models: 0.74 and 0.72 with 20 and 40 neighbours (noise of 1.5 spacings, 0.5 % of the diagonal), 0.39, 0.40
  /// and 0.43 with 150, 240 and 400 (6 spacings, 2 %).
  static constexpr double neighbors_per_noise = 30;
  static constexpr double most_neighbors = 400;
  static constexpr double residual_width = 1.5;       ///< of the weights, in the noise; 0.5: 10 % worse, 2: 4 %
  static constexpr std::size_t iterations = 5;
  static constexpr double settled = 0.01;             ///< change of the height, in units of the noise

public:
  /// The points of one view.
  Range_denoising(const Execution& execution, const Points& points, const Projection& projection)
    : m_execution(execution), m_points(points), m_projection(projection)
  {
    for(const Vec3& p : points) {
      const Vec3 u = projection(p);
      m_flat.push_back(Vec3(u.x(), u.y(), 0));
      m_height.push_back(u.z());
    }
  }

  /// The points, moved along their rays; the same if they have next to no noise.
  Points run()
  {
    estimate_noise();
    Points denoised = m_points;
    if(!is_noisy())
      return denoised;
    const double radius =
      radius_of((std::min)(most_neighbors, neighbors_per_noise * (std::max)(1., m_noise / m_spacing)));
    const Sorted_grid grid(m_flat, radius);
    parallel_for_places(m_execution, grid, [&](std::size_t i) {
      const double shift = height_shift(neighborhood(grid, i, radius, 2));
      denoised[i] += shift * m_projection.towards_scanner(m_points[i]);
    });
    return denoised;
  }

  bool is_noisy() const { return m_noise > noisy * m_spacing; }

private:
  static constexpr int coefficients = 6;
  using Lanes = Exponential::Lanes;
  using Column = Eigen::Map<const Lanes>;
  using Coefficients = Eigen::Matrix<double, coefficients, 1>;

  /// Heights over the image around a point, which is the origin; places in units of the radius. Columns are filled up
  /// with points of no weight to a multiple of the lanes.
  struct Neighborhood {
    std::vector<double> x, y, z;
    std::vector<double> nearness;  ///< weights by distance
    std::size_t count = 0;
  };

  /// Of a disc with that many points: the six nearest are 0.98 / sqrt(density) off on average.
  double radius_of(double neighbors) const { return 0.577 * m_spacing * std::sqrt(neighbors); }

  /// Weights are exp(-falloff d^2 / radius^2).
  Neighborhood neighborhood(const Sorted_grid& grid, std::size_t i, double radius, double falloff) const
  {
    Neighborhood found;
    grid.for_each_neighbor_block(m_flat[i], radius, [&](const Neighbor_block& block) {
      Block_weights nearness;
      nearness.set_gaussian(falloff / (radius * radius), block);
      for(int k = 0; k < block.size; ++k) {
        found.x.push_back(block.dx[k] / radius);
        found.y.push_back(block.dy[k] / radius);
        found.z.push_back(m_height[block.index[k]] - m_height[i]);
        found.nearness.push_back(nearness[k]);
      }
    });
    found.count = found.x.size();
    while(found.x.size() % Exponential::lanes != 0)
      for(std::vector<double>* column : {&found.x, &found.y, &found.z, &found.nearness})
        column->push_back(0.);
    return found;
  }

  template <typename Number>
  static Number height(const Coefficients& c, const Number& x, const Number& y)
  {
    return c[0] + x * (c[1] + c[3] * x + c[4] * y) + y * (c[2] + c[5] * y);
  }

  /// The quadric c0 + c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2 of least squares, where heights have the weight
  /// exp(-r^2 / 2) by their residual r over another quadric, in units of `width`. Adds up the weights in `total`.
  static Coefficients refit(const Neighborhood& near, const Coefficients& c, double width, double& total)
  {
    // sums of w x^a y^b, a + b <= 4, by degree and then by b; the first six of them times the height
    constexpr int degree = 4, moments = 15;
    Lanes moment[moments], moment_height[coefficients], term[moments];
    for(Lanes& m : moment)
      m.setZero();
    for(Lanes& m : moment_height)
      m.setZero();
    for(std::size_t k = 0; k < near.x.size(); k += Exponential::lanes) {
      const Column x(&near.x[k]), y(&near.y[k]), z(&near.z[k]), nearness(&near.nearness[k]);
      const Lanes r = (z - height<Lanes>(c, x, y)) / width;
      term[0] = nearness * Exponential::of(-0.5 * r * r);
      for(int d = 1, lower = 0, next = 1; d <= degree; lower += d, ++d) {
        for(int b = 0; b < d; ++b)
          term[next++] = term[lower + b] * x;
        term[next++] = term[lower + d - 1] * y;
      }
      for(int m = 0; m < moments; ++m)
        moment[m] += term[m];
      for(int m = 0; m < coefficients; ++m)
        moment_height[m] += term[m] * z;
    }
    constexpr int power_x[] = {0, 1, 0, 2, 1, 0}, power_y[] = {0, 0, 1, 0, 1, 2};
    Eigen::Matrix<double, coefficients, coefficients> A;
    Coefficients b;
    for(int i = 0; i < coefficients; ++i) {
      b[i] = moment_height[i].sum();
      for(int j = 0; j < coefficients; ++j) {
        const int y = power_y[i] + power_y[j], d = power_x[i] + power_x[j] + y;
        A(i, j) = moment[d * (d + 1) / 2 + y].sum();
      }
    }
    total = A(0, 0);
    A.diagonal().array() += 1e-6 * total;
    return solve_normal_equations(A, b);
  }

  /// The median residual of quadrics over the image, at samples spread over it.
  void estimate_noise()
  {
    const std::vector<Index> order = place_order(m_flat);
    const Nearest_neighbors tree(m_flat);
    const std::size_t count = (std::min)(noise_samples, order.size());
    const auto sample = [&](std::size_t k) { return std::size_t(order[k * order.size() / count]); };
    std::vector<double> spacing(count, 0.), residual(count, 0.);
    constexpr std::size_t nearest = 6;
    parallel_for(m_execution, count, [&](std::size_t k) {
      std::vector<Neighbor> neighbors;
      tree.find(m_flat[sample(k)], nearest + 1, neighbors);
      for(const Neighbor& neighbor : neighbors)
        spacing[k] += std::sqrt(neighbor.squared_distance) / double(nearest);
    });
    m_spacing = median(spacing);
    const double radius = radius_of(noise_neighbors);
    if(!(radius > 0))
      return;
    const Sorted_grid grid(m_flat, radius);
    parallel_for(m_execution, count, [&](std::size_t k) {
      const Neighborhood near = neighborhood(grid, sample(k), radius, 0);
      if(near.count < least_neighbors)
        return;
      double total = 0, squares = 0;
      constexpr double any = (std::numeric_limits<double>::max)();  // no residual counts less
      const Coefficients c = refit(near, Coefficients::Zero(), any, total);
      for(std::size_t j = 0; j < near.count; ++j)
        squares += std::pow(near.z[j] - height(c, near.x[j], near.y[j]), 2);
      residual[k] = std::sqrt(squares / double(near.count - coefficients));
    });
    m_noise = median(residual);
  }

  /// From the point to a quadric through the heights next to its own: those beyond an edge of depth have no weight.
  double height_shift(const Neighborhood& near) const
  {
    if(near.count < least_neighbors)
      return 0;
    // first around the point's height, and as much farther as a slope of one leads
    double width = m_noise + radius_of(double(near.count));
    Coefficients c = Coefficients::Zero();
    for(std::size_t t = 0; t < iterations; ++t) {
      double total = 0;
      const double last = c[0];
      c = refit(near, c, width, total);
      if(total < 0.5 * coefficients || !c.allFinite())
        return 0;
      if(t > 0 && std::abs(c[0] - last) < settled * m_noise)
        break;
      width = residual_width * m_noise;
    }
    return c[0];
  }

  const Execution& m_execution;
  const Points& m_points;
  const Projection& m_projection;
  Points m_flat;                  ///< the image
  std::vector<double> m_height;   ///< over it
  double m_noise = 0, m_spacing = 0;
};

/// Denoises the views that have noise. True if any has; what is not known to be one view stays as it is.
inline bool denoise_along_rays(const Execution& execution, const Scan_directions& directions, Points& points)
{
  constexpr std::size_t least_points = 100;  // fewer do not make an image
  bool is_noisy = false;
  for(const std::vector<std::size_t>& view : directions.by_view()) {  // none if the rays could not be grouped
    if(view.size() < least_points)
      continue;
    Points seen, rays;
    for(const std::size_t i : view) {
      seen.push_back(points[i]);
      rays.push_back(directions.towards_scanner[i]);
    }
    const Projection projection = Projection::fit(seen, rays);
    if(!projection.has_rays(seen, rays))
      continue;  // an image of it would mix front and back
    Range_denoising denoising(execution, seen, projection);
    const Points denoised = denoising.run();
    is_noisy = is_noisy || denoising.is_noisy();
    for(std::size_t k = 0; k < view.size(); ++k)
      points[view[k]] = denoised[k];
  }
  return is_noisy;
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_RANGE_DENOISING_H
