// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEW_ESTIMATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEW_ESTIMATION_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/sphere_directions.h>
#include <CGAL/Point_set_consolidation_3/internal/views.h>

#include <optional>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Whether points with normals can have been seen from one side, and from which: all normals face it and no
/// point hides another. A scan from one position without its directions is recognised by that; to know
/// where its rays have passed keeps completion from swelling. Lengths in units of the spacing of the points.
class View_estimation {
  static constexpr double outlying = 0.03;        ///< share of points that need not fit
  static constexpr double hidden_share = 0.1;
  static constexpr double unoriented_share = 0.05;  ///< the same if no normal can be relied upon
  static constexpr double reliable_share = 0.7;   ///< of normals that face the axis then
  static constexpr double first_turn = 0.04, last_turn = 0.009;  ///< radians
  static constexpr double stiffness = 1;          ///< six degrees must spare one percent of the points
  static constexpr double grazing = 0.4;          ///< cosine: steeper parts rise without hiding
  static constexpr double least_rise = 3;         ///< between a point and one that it hides
  static constexpr int steps = 200;
  static constexpr std::size_t coarse_directions = 300;

public:
  View_estimation(const Execution& execution, const Points& points, const Points& normals)
    : m_execution(execution), m_points(points), m_normals(normals)
  {}

  /// Direction towards the scanner; none if there is no such direction. If `is_oriented` is false some
  /// normals may point to the wrong side.
  std::optional<Vec3> run(bool is_oriented = true)
  {
    std::optional<Vec3> axis = refined_axis(hidden_share);
    if(axis || is_oriented)
      return axis;
    // Both sides of a body hide each other from any side, however they are oriented.
    axis = least_hiding_axis();
    if(!axis)
      return std::nullopt;
    for(Vec3& n : m_normals)
      if(n.dot(*axis) < 0)
        n = -n;
    return refined_axis(unoriented_share);
  }

private:
  /// An axis that all normals face and along which at most this share of the points hides others.
  std::optional<Vec3> refined_axis(double largest_share) const
  {
    std::optional<Vec3> axis = axis_of_normals();
    if(axis && refine(*axis) > largest_share)
      axis.reset();
    return axis;
  }

  /// The centre of the smallest cap that holds the normals, by steps towards the farthest (Badoiu, Clarkson); none if
  /// it is no less than a hemisphere.
  std::optional<Vec3> axis_of_normals() const
  {
    Vec3 axis = Vec3::Zero();
    for(const Vec3& n : m_normals)
      axis += n;
    axis = normalized_or(axis, Vec3::UnitZ());
    for(int k = 1; k <= steps; ++k)
      axis = normalized_or(axis + (farthest(axis) - axis) / double(k + 1), axis);
    if(farthest(axis).dot(axis) > 0)
      return axis;
    return std::nullopt;
  }

  /// Of evenly spread axes from which hardly any point hides another, that which most normals face.
  std::optional<Vec3> least_hiding_axis() const
  {
    constexpr double alike = 0.02;   // shares
    Points directions;
    std::vector<double> shares;
    for(std::size_t k = 0; k < coarse_directions; ++k) {
      directions.push_back(half_sphere_direction(k, coarse_directions));
      shares.push_back(share_of_hidden(directions.back(), false));
    }
    const double least = *std::min_element(shares.begin(), shares.end());
    if(least > unoriented_share)
      return std::nullopt;
    Vec3 axis = Vec3::Zero();
    double best = 0;
    for(std::size_t k = 0; k < coarse_directions; ++k)
      if(shares[k] <= least + alike)
        for(const double sign : {1., -1.}) {
          const double facing = share_of_facing(sign * directions[k]);
          if(facing > best) {
            best = facing;
            axis = sign * directions[k];
          }
        }
    if(best > reliable_share)
      return axis;
    return std::nullopt;
  }

  double share_of_facing(const Vec3& axis) const
  {
    return double(std::count_if(m_normals.begin(), m_normals.end(),
                                [&](const Vec3& n) { return n.dot(axis) > 0; })) /
           double(m_normals.size());
  }

  /// Normal at the greatest angle, but for the outlying ones.
  Vec3 farthest(const Vec3& axis) const
  {
    std::vector<std::pair<double, Index> > cosines(m_normals.size());
    for(std::size_t i = 0; i < cosines.size(); ++i)
      cosines[i] = {m_normals[i].dot(axis), Index(i)};
    const auto nth = cosines.begin() + std::ptrdiff_t(outlying * double(cosines.size()));
    std::nth_element(cosines.begin(), nth, cosines.end());
    return m_normals[nth->second];
  }

  /// Turns the axis to where fewer points hide others, though not far; returns their share.
  double refine(Vec3& axis) const
  {
    const Vec3 centre = axis;
    const auto cost = [&](const Vec3& d) {
      return share_of_hidden(d, true) + stiffness * (d - centre).squaredNorm();
    };
    double least = cost(axis);
    double angle = first_turn;
    while(angle >= last_turn) {
      for(bool has_turned = true; has_turned;) {
        has_turned = false;
        const Projection projection = Projection::orthographic(axis);
        for(const Vec3& side : {projection.right(), Vec3(-projection.right()), projection.up(),
                                Vec3(-projection.up())}) {
          const Vec3 turned = (axis + angle * side).normalized();
          const double turned_cost = cost(turned);
          if(turned_cost < least) {
            least = turned_cost;
            axis = turned;
            has_turned = true;
          }
        }
      }
      angle /= 2;
    }
    return share_of_hidden(axis, true);
  }

  /// Points that face the scanner with another such point before or behind them; `is_oriented`: normals on the
  /// other side do not.
  double share_of_hidden(const Vec3& axis, bool is_oriented) const
  {
    const auto faces = [&](std::size_t i) {
      const double cosine = m_normals[i].dot(axis);
      return (is_oriented ? cosine : std::abs(cosine)) > grazing;
    };
    const Projection projection = Projection::orthographic(axis);
    Points image(m_points.size());
    std::vector<double> height(m_points.size());
    for(std::size_t i = 0; i < image.size(); ++i) {
      const Vec3 p = projection(m_points[i]);
      image[i] = Vec3(p.x(), p.y(), 0);
      height[i] = p.z();
    }
    const Sorted_grid grid(image, 1);
    std::vector<char> is_hidden(image.size(), 0);
    parallel_for(m_execution, image.size(), [&](std::size_t i) {
      if(faces(i))
        grid.for_each_neighbor(image[i], 1, [&](Index j, double) {
          is_hidden[i] = faces(j) && std::abs(height[j] - height[i]) > least_rise;
          return !is_hidden[i];
        });
    });
    return double(std::count(is_hidden.begin(), is_hidden.end(), 1)) / double(image.size());
  }

  const Execution& m_execution;
  const Points& m_points;
  Points m_normals;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_VIEW_ESTIMATION_H
