// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FREE_SPACE_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FREE_SPACE_H

#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/place_order.h>
#include <CGAL/Point_set_consolidation_3/internal/views.h>

#include <limits>
#include <optional>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// What is known to be empty because a ray has passed there: for each view an image of the scan with
/// the nearest data to the scanner, and the distance to the silhouette.
/// phi_w = max(distance to the silhouette - e, height - nearest height - margin),
/// Phi = max over the views; x is free where Phi(x) > 0.
class Free_space {
  static constexpr int closing_pixels = 4;   ///< gaps of the sampling that are not seen through
  static constexpr int padding_pixels = 6;
  static constexpr double max_pixels = 4e6;  ///< per view; larger images are sampled more coarsely
  static constexpr double least_pixel = 1e-3;
  static constexpr double half_diagonal = 0.7;  ///< of a pixel: no datum lies in one whose centre is farther from all

public:
  Free_space() = default;

  /// `margin`: how far in front of the data space is not yet called free. Points outside of `region`,
  /// outliers, are left out.
  Free_space(const Execution& execution, const Points& points, const Scan_directions& directions,
             const Bounding_box& region, double margin)
    : m_margin(margin)
  {
    const std::vector<std::vector<std::size_t> > views = directions.by_view();
    for(std::size_t v = 0; v < views.size(); ++v) {
      Points seen, rays;
      for(const std::size_t i : views[v]) {
        if(region.contains(points[i])) {
          seen.push_back(points[i]);
          rays.push_back(directions.towards_scanner[i]);
        }
      }
      constexpr std::size_t least_points = 16;  // fewer do not make an image
      if(seen.size() < least_points)
        continue;
      Points missed;
      for(std::size_t i = 0; i < directions.missed.size(); ++i)
        if(directions.missed_view[i] == v)
          missed.push_back(directions.missed[i]);
      m_images.push_back(make_image(execution, seen, Projection::fit(seen, rays), missed));
    }
    for(const Image& image : m_images)
      m_tolerance = (std::max)(m_tolerance, image.pixel);
  }

  Free_space(const Execution& execution, const Points& points, const Scan_directions& directions,
             double margin)
    : Free_space(execution, points, directions, bounding_box(points), margin)
  {}

  bool empty() const { return m_images.empty(); }
  std::size_t number_of_views() const { return m_images.size(); }
  const Projection& projection(std::size_t view) const { return m_images[view].projection; }

  /// Phi(x), in units of length: positive where a ray has passed.
  double operator()(const Vec3& x) const
  {
    double phi = -(std::numeric_limits<double>::max)();
    for(const Image& image : m_images) {
      const Vec3 u = image.projection(x);
      phi = (std::max)(phi, image.silhouette_distance(u) - m_tolerance);
      phi = (std::max)(phi, u.z() - image.nearest_height(u) - m_margin);
    }
    return phi;
  }

  /// Moves a point that lies in free space back towards where it may be, by at most `step`.
  Vec3 pushed_back(const Vec3& x, double silhouette_tolerance, double step) const
  {
    Vec3 moved = x;
    for(const Image& image : m_images) {
      const Vec3 u = image.projection(moved);
      const double outside = image.silhouette_distance(u) - silhouette_tolerance;
      if(outside > 0) {
        const double h = 0.5 * image.pixel;
        const double gx = image.silhouette_distance(u + h * Vec3::UnitX()) -
                          image.silhouette_distance(u - h * Vec3::UnitX());
        const double gy = image.silhouette_distance(u + h * Vec3::UnitY()) -
                          image.silhouette_distance(u - h * Vec3::UnitY());
        const Vec3 gradient = gx * image.projection.right() + gy * image.projection.up();
        moved -= (std::min)(outside, step) * normalized_or(gradient, Vec3::Zero());
      }
      else {
        const double in_front = u.z() - image.nearest_height(u) - m_margin;
        if(in_front > 0)
          moved -= (std::min)(in_front, step) * image.projection.towards_scanner(moved);
      }
    }
    return moved;
  }

private:
  struct Image {
    Projection projection;
    double pixel = 1, origin_x = 0, origin_y = 0;
    int width = 0, height = 0;
    std::vector<float> nearest;   ///< height of the data nearest to the scanner, -inf: none
    std::vector<float> distance;  ///< of the pixel's centre to the silhouette
    bool is_open_beyond = true;   ///< whether all is free beyond the image

    std::size_t number_of_pixels() const { return std::size_t(width) * std::size_t(height); }
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    Vec3 pixel_centre(std::size_t p) const
    {
      const int x = int(p % std::size_t(width)), y = int(p / std::size_t(width));
      return Vec3(origin_x + (x + 0.5) * pixel, origin_y + (y + 0.5) * pixel, 0);
    }
    /// The pixel that holds a place in the image.
    std::optional<std::size_t> pixel_at(const Vec3& u) const
    {
      const double x = std::floor((u.x() - origin_x) / pixel);
      const double y = std::floor((u.y() - origin_y) / pixel);
      if(!(x >= 0 && y >= 0 && x < width && y < height))
        return std::nullopt;
      return at(int(x), int(y));
    }
    /// Centres of the pixels that are farther from the data.
    Points centres_beyond(double from_data) const
    {
      Points centres;
      for(std::size_t p = 0; p < number_of_pixels(); ++p)
        if(distance[p] > from_data)
          centres.push_back(pixel_centre(p));
      return centres;
    }

    double nearest_height(const Vec3& u) const
    {
      const std::optional<std::size_t> p = pixel_at(u);
      return p && std::isfinite(nearest[*p]) ? double(nearest[*p]) : (std::numeric_limits<double>::max)();
    }

    /// Bilinear.
    double silhouette_distance(const Vec3& u) const
    {
      const double x = (u.x() - origin_x) / pixel - 0.5, y = (u.y() - origin_y) / pixel - 0.5;
      if(!(x >= 0 && y >= 0 && x < width - 1 && y < height - 1)) {
        const double out_x = (std::max)({-x, x - (width - 1), 0.});
        const double out_y = (std::max)({-y, y - (height - 1), 0.});
        if(!is_open_beyond)
          return -pixel;
        return pixel * (padding_pixels + std::sqrt(out_x * out_x + out_y * out_y));
      }
      const int x0 = int(x), y0 = int(y);
      const double s = x - x0, t = y - y0;
      return (1 - t) * ((1 - s) * distance[at(x0, y0)] + s * distance[at(x0 + 1, y0)]) +
             t * ((1 - s) * distance[at(x0, y0 + 1)] + s * distance[at(x0 + 1, y0 + 1)]);
    }
  };

  static Image make_image(const Execution& execution, const Points& points,
                          const Projection& projection, const Points& missed)
  {
    Image image;
    image.projection = projection;
    Points flat(points.size());
    std::vector<double> height(points.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      flat[i] = projection(points[i]);
      height[i] = flat[i].z();
      flat[i].z() = 0;
    }
    const Nearest_neighbors tree(flat);
    std::vector<double> sixth(points.size());
    parallel_for_places(execution, flat, [&](std::size_t i) {
      std::vector<Neighbor> neighbors;
      tree.find(flat[i], 7, neighbors);
      sixth[i] = std::sqrt(neighbors.back().squared_distance);
    });
    const Vec3 sides = bounding_box(flat).sides();
    image.pixel = (std::max)({mean(sixth), std::sqrt(sides.x() * sides.y() / max_pixels), least_pixel});
    const Vec3 lower = bounding_box(flat).lower;
    image.origin_x = lower.x() - padding_pixels * image.pixel;
    image.origin_y = lower.y() - padding_pixels * image.pixel;
    image.width = int(sides.x() / image.pixel) + 1 + 2 * padding_pixels;
    image.height = int(sides.y() / image.pixel) + 1 + 2 * padding_pixels;

    image.nearest.assign(image.number_of_pixels(), -std::numeric_limits<float>::infinity());
    for(std::size_t i = 0; i < flat.size(); ++i) {
      const int x = int((flat[i].x() - image.origin_x) / image.pixel);
      const int y = int((flat[i].y() - image.origin_y) / image.pixel);
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx) {
          float& value = image.nearest[image.at(x + dx, y + dy)];
          value = (std::max)(value, float(height[i]));
        }
    }
    image.distance.resize(image.number_of_pixels());
    parallel_for(execution, image.distance.size(), [&](std::size_t p) {
      image.distance[p] = float(std::sqrt(tree.nearest(image.pixel_centre(p)).squared_distance));
    });
    if(missed.empty()) {
      close_gaps(execution, image);
      sign_inside(execution, image);
    }
    else
      set_missed(execution, image, missed);
    return image;
  }

  /// The caller knows which rays met nothing: only pixels of these are seen through. A pixel without rays, where
  /// the scanner got no answer or did not look, may be solid.
  static void set_missed(const Execution& execution, Image& image, const Points& missed)
  {
    std::vector<char> is_free(image.distance.size(), 0);
    for(const Vec3& ray : missed)
      if(const std::optional<std::size_t> p = image.pixel_at(image.projection(ray)))
        is_free[*p] = char(image.distance[*p] > half_diagonal * image.pixel);
    Points free, solid;
    for(std::size_t p = 0; p < is_free.size(); ++p)
      (is_free[p] ? free : solid).push_back(image.pixel_centre(p));
    const float far = float(image.pixel * (image.width + image.height));
    const Nearest_neighbors free_tree(free), solid_tree(solid);
    parallel_for(execution, image.distance.size(), [&](std::size_t p) {
      const Nearest_neighbors& other = is_free[p] ? solid_tree : free_tree;
      const float distance =
        other.size() == 0 ? far : float(std::sqrt(other.nearest(image.pixel_centre(p)).squared_distance));
      image.distance[p] = is_free[p] ? distance : -distance;
    });
    image.is_open_beyond = false;
  }

  /// Pixels within four of the data but far from everything outside are gaps of the sampling.
  static void close_gaps(const Execution& execution, Image& image)
  {
    const double reach = closing_pixels * image.pixel;
    const Points outside = image.centres_beyond(reach);
    if(outside.empty())
      return;
    const Nearest_neighbors tree(outside);
    parallel_for(execution, image.distance.size(), [&](std::size_t p) {
      float& distance = image.distance[p];
      if(distance > reach || distance <= half_diagonal * image.pixel)
        return;
      const double to_outside = std::sqrt(tree.nearest(image.pixel_centre(p)).squared_distance);
      distance = to_outside > reach
                   ? 0.f
                   : (std::min)(distance, float(reach - to_outside + half_diagonal * image.pixel));
    });
  }

  /// Inside of the silhouette the distance to it is negative, so that thin parts survive smoothing.
  static void sign_inside(const Execution& execution, Image& image)
  {
    const Points outside = image.centres_beyond(image.pixel);
    if(outside.empty())
      return;
    const Nearest_neighbors tree(outside);
    parallel_for(execution, image.distance.size(), [&](std::size_t p) {
      float& distance = image.distance[p];
      if(distance > image.pixel)
        return;
      const double inside = std::sqrt(tree.nearest(image.pixel_centre(p)).squared_distance);
      distance = (std::min)(distance, float(image.pixel - inside));
    });
  }

  double m_margin = 0;
  double m_tolerance = 0;
  std::vector<Image> m_images;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FREE_SPACE_H
