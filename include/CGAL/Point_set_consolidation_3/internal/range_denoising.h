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
///
/// Raw heights tell on which side of an edge of depth a point is only if that is much higher than the noise.
/// So the first result guides the next: which heights belong to a surface is decided by the smoothed ones, what its
/// height is by the raw ones (rolling guidance, Zhang et al., ECCV 2014, here with quadrics). Three views of 14
/// models, error of meshes relative to that of the raw scan without and with it: 0.38 and 0.30 at 2 % of noise, with 34
/// and 10 false handles; 0.68 and 0.65 at 0.5 %.
class Range_denoising {
  static constexpr std::size_t least_neighbors = 12;  ///< twice the coefficients of a quadric
  static constexpr std::size_t noise_samples = 4000;
  static constexpr double noise_neighbors = 30;
  static constexpr double noisy = 0.5;                ///< in spacings of the image; clean scans 0 to 0.3 (fandisk)
  /// For each spacing that the noise is large. Error of meshes relative to that of the raw scan after the first pass,
  /// three views of four to six models: 0.74 and 0.72 with 20 and 40 neighbours (noise of 1.5 spacings, 0.5 % of the
  /// diagonal), 0.39, 0.40 and 0.43 with 150, 240 and 400 (6 spacings, 2 %).
  static constexpr double neighbors_per_noise = 30;
  static constexpr double most_neighbors = 400;
  static constexpr double residual_width = 1;         ///< of the weights, in the noise
  static constexpr int guided_passes = 2;             ///< 1: meshes in 2 % of noise 1 % worse; 3: 1 % better
  static constexpr double guided_width = 0.5;         ///< of their weights, in the noise; 0.7: 2 % worse
  static constexpr double guided_reach = 1.3;         ///< what does not belong is left out: more neighbours help
  static constexpr double guided_slope = 0.3;         ///< that a guided fit starts with; 0.1 to 0.6: alike
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
    m_smoothed = m_height;
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
    smooth(radius, m_noise + radius, residual_width * m_noise);  // a slope of one at first
    const double reach = guided_reach * radius, width = guided_width * m_noise;
    for(int pass = 0; pass < guided_passes; ++pass)
      smooth(reach, width + guided_slope * reach, width);
    parallel_for(m_execution, denoised.size(), [&](std::size_t i) {
      denoised[i] += (m_smoothed[i] - m_height[i]) * m_projection.towards_scanner(m_points[i]);
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
    std::vector<double> x, y;
    std::vector<double> z;         ///< raw
    std::vector<double> smoothed;  ///< by the last pass
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
        found.smoothed.push_back(m_smoothed[block.index[k]] - m_height[i]);
        found.nearness.push_back(nearness[k]);
      }
    });
    found.count = found.x.size();
    while(found.x.size() % Exponential::lanes != 0)
      for(std::vector<double>* column : {&found.x, &found.y, &found.z, &found.smoothed, &found.nearness})
        column->push_back(0.);
    return found;
  }

  template <typename Number>
  static Number height(const Coefficients& c, const Number& x, const Number& y)
  {
    return c[0] + x * (c[1] + c[3] * x + c[4] * y) + y * (c[2] + c[5] * y);
  }

  /// The quadric c0 + c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2 of least squares to `heights`, where points have the
  /// weight exp(-r^2 / 2) by the residual r of their smoothed height over another quadric, in units of `width`. Adds up
  /// the weights in `total`.
  static Coefficients refit(const Neighborhood& near, const std::vector<double>& heights, const Coefficients& c,
                            double width, double& total)
  {
    // sums of w x^a y^b, a + b <= 4, by degree and then by b; the first six of them times the height
    constexpr int degree = 4, moments = 15;
    Lanes moment[moments], moment_height[coefficients], term[moments];
    for(Lanes& m : moment)
      m.setZero();
    for(Lanes& m : moment_height)
      m.setZero();
    for(std::size_t k = 0; k < near.x.size(); k += Exponential::lanes) {
      const Column x(&near.x[k]), y(&near.y[k]), z(&heights[k]), smoothed(&near.smoothed[k]),
        nearness(&near.nearness[k]);
      const Lanes r = (smoothed - height<Lanes>(c, x, y)) / width;
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
    const Nearest_neighbors tree(m_execution, m_flat);
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
      const Coefficients c = refit(near, near.z, Coefficients::Zero(), any, total);
      for(std::size_t j = 0; j < near.count; ++j)
        squares += std::pow(near.z[j] - height(c, near.x[j], near.y[j]), 2);
      residual[k] = std::sqrt(squares / double(near.count - coefficients));
    });
    m_noise = median(residual);
  }

  /// One pass of all points over discs of the given radius.
  void smooth(double radius, double first_width, double width)
  {
    const Sorted_grid grid(m_flat, radius);
    std::vector<double> result(m_height.size());
    parallel_for_places(m_execution, grid, [&](std::size_t i) {
      const Neighborhood near = neighborhood(grid, i, radius, 2);
      result[i] = m_height[i] + smoothed_height(near, m_smoothed[i] - m_height[i], first_width, width);
    });
    m_smoothed.swap(result);
  }

  /// Of a quadric through the heights next to the point's own: those beyond an edge of depth have no weight. `own`, its
  /// smoothed height, if there are too few. First around that height, and as much farther as `first_width` allows.
  double smoothed_height(const Neighborhood& near, double own, double first_width, double width) const
  {
    if(near.count < least_neighbors)
      return own;
    Coefficients c = Coefficients::Zero();
    c[0] = own;
    for(std::size_t t = 0; t < iterations; ++t) {
      double total = 0;
      const double last = c[0];
      c = t == 0 ? refit(near, near.smoothed, c, first_width, total) : refit(near, near.z, c, width, total);
      if(total < 0.5 * coefficients || !c.allFinite())
        return own;
      if(t > 1 && std::abs(c[0] - last) < settled * m_noise)
        break;
    }
    return c[0];
  }

  const Execution& m_execution;
  const Points& m_points;
  const Projection& m_projection;
  Points m_flat;                  ///< the image
  std::vector<double> m_height;   ///< over it
  std::vector<double> m_smoothed; ///< by the last pass; at first the same
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
    const Points seen = selected(points, view), rays = selected(directions.towards_scanner, view);
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
