// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRROR_SYMMETRY_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRROR_SYMMETRY_H

#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/normal_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sphere_directions.h>

#include <algorithm>
#include <optional>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

struct Mirror_plane {
  Vec3 normal = Vec3::UnitX();   ///< unit
  double offset = 0;             ///< the plane is normal . x = offset

  double height(const Vec3& x) const { return normal.dot(x) - offset; }
  Vec3 reflected(const Vec3& x) const { return x - 2 * height(x) * normal; }
  Vec3 reflected_vector(const Vec3& v) const { return v - 2 * normal.dot(v) * normal; }
};

/// What the scan says of a plane, by numbers of consolidated points.
struct Mirror_evidence {
  std::size_t all = 0;        ///< that were looked at
  std::size_t moved = 0;      ///< those away from the plane; of them:
  std::size_t free = 0;       ///< their images lie where a ray has passed
  std::size_t matched = 0;    ///< their images lie on the data, with the same normal
  std::size_t facing = 0;     ///< those that match or face a scanner: on the data, or hidden by other parts
};

/// Finds the mirror plane of a shape of which only some sides were scanned. The image of a point must not
/// lie where a ray has passed; it lies on the data or where the scanner could not look. A plane is accepted
/// only if many images lie on the data: hidden ones prove nothing.
/// Lengths in units of the spacing r of S.
class Mirror_symmetry {
  static constexpr std::size_t directions = 1200;       ///< of the coarse search: 4 degrees apart
  static constexpr double offset_step = 1.5;
  static constexpr double most_offsets = 1000;          ///< of one direction: parts may be far apart
  static constexpr std::size_t coarse_samples = 160;
  static constexpr std::size_t fine_samples = 1000;
  static constexpr std::size_t evidence_samples = 4000;
  static constexpr std::size_t candidates = 24;
  static constexpr int refinements = 14;
  static constexpr double coarse_tolerance = 4, fine_tolerance = 1;
  static constexpr double same_side = 0.7;              ///< cosine of normals
  static constexpr double most_cells = 2e5;
  static constexpr double near_plane = 2;               ///< points that a reflection hardly moves
  static constexpr double unmatched_cost = 0.3;         ///< of an image that faces the scanner
  static constexpr double least_cosine = 0.3;           ///< to face it
  static constexpr double least_moved = 0.5;            ///< share of all
  static constexpr double least_matched = 0.05;         ///< share of the moved ones; of noisy legs 0.07, by wrong
                                                        ///< planes that do not enter free space 0.02 at most
  static constexpr double least_agreement = 0.8;        ///< share of those that must match or are hidden
  static constexpr double most_free = 0.05;             ///< by those matched; mirror planes 0.002, nearly symmetric
                                                        ///< shapes 0.08 to 0.25, wrong planes 0.14 and more
  static constexpr double least_free = 0.02;            ///< the same if the direction is estimated
  static constexpr double exact = 0.01;

public:
  Mirror_symmetry(const Execution& execution, const Points& points, const Points& normals,
                  const Free_space& free_space)
    : m_execution(execution), m_points(points), m_normals(normals), m_free_space(free_space)
    , m_tree(points), m_box(bounding_box(points).grown(coarse_tolerance + 1))
  {
    make_cells();
  }

  /// The mirror plane of the shape, if there is one for certain; of several, as a vase has, that which tells most of
  /// the hidden side. `is_estimated`: the free space is only roughly known.
  std::optional<Mirror_plane> find(bool is_estimated) const
  {
    const double limit = is_estimated ? least_free : most_free;
    std::optional<Mirror_plane> plane;
    double best = 1;
    std::size_t most_hidden = 0;
    for(const Mirror_plane& candidate : planes()) {
      const Mirror_evidence e = evidence(candidate);
      if(!is_mirror_plane(e, limit))
        continue;
      const double violation = (std::max)(exact, double(e.free) / double(e.matched));
      const std::size_t hidden = e.moved - e.facing - e.free;
      if(violation < best || (violation == best && hidden > most_hidden)) {
        best = violation;
        most_hidden = hidden;
        plane = candidate;
      }
    }
    return plane;
  }

  bool is_mirror_plane(const Mirror_evidence& e, double limit) const
  {
    const double matched = double(e.matched), moved = double(e.moved);
    return moved > least_moved * double(e.all) && matched > least_matched * moved &&
           matched > least_agreement * double(e.facing) && double(e.free) < limit * matched;
  }

  /// Planes that might be right, best first.
  std::vector<Mirror_plane> planes() const
  {
    std::vector<Mirror_plane> result;
    if(m_points.size() < coarse_samples || m_free_space.empty())
      return result;
    std::vector<Scored> best = coarse_search();
    parallel_for(m_execution, best.size(), [&](std::size_t c) {
      best[c].plane = refined(best[c].plane, sample(fine_samples), coarse_tolerance);
      best[c].score = score(evidence(best[c].plane));
    }, long_bodies);
    std::stable_sort(best.begin(), best.end(),
                     [](const Scored& a, const Scored& b) { return a.score > b.score; });
    for(const Scored& c : best)
      if(std::none_of(result.begin(), result.end(),
                      [&](const Mirror_plane& p) { return difference(p, c.plane) < 2; }))
        result.push_back(c.plane);
    return result;
  }

  Mirror_evidence evidence(const Mirror_plane& plane) const
  {
    const std::vector<Index> samples = sample(evidence_samples);
    std::vector<Image> images(samples.size());
    parallel_for(m_execution, samples.size(), [&](std::size_t k) {
      images[k] = image(plane, samples[k], fine_tolerance);
    });
    Mirror_evidence e;
    e.all = samples.size();
    for(const Image i : images) {
      e.moved += i != Image::STILL;
      e.free += i == Image::FREE;
      e.facing += i == Image::MATCHED || i == Image::FACING;
      e.matched += i == Image::MATCHED;
    }
    return e;
  }

  /// Whether the image of a point lies where a ray has passed.
  bool is_free(const Mirror_plane& plane, std::size_t i) const
  {
    return image(plane, i, fine_tolerance) == Image::FREE;
  }

private:
  struct Scored {
    Mirror_plane plane;
    double score = 0;
  };

  enum class Image { STILL, FREE, MATCHED, FACING, HIDDEN };

  static double score(const Mirror_evidence& e)
  {
    return double(e.matched) - unmatched_cost * double(e.facing - e.matched) - double(e.free);
  }

  Image image(const Mirror_plane& plane, std::size_t i, double tolerance) const
  {
    if(std::abs(plane.height(m_points[i])) < near_plane)
      return Image::STILL;
    const Vec3 y = plane.reflected(m_points[i]), n = plane.reflected_vector(m_normals[i]);
    const Index nearest = tolerance < coarse_tolerance ? m_tree.nearest(y).index : roughly_nearest(y);
    const Vec3& at = m_normals[nearest];
    const Vec3 d = y - m_points[nearest];
    if(d.squaredNorm() < (tolerance + 1) * (tolerance + 1) && std::abs(at.dot(d)) < tolerance &&
       at.dot(n) > same_side)
      return Image::MATCHED;
    if(m_free_space(y) > tolerance)
      return Image::FREE;
    return is_facing(y, n) ? Image::FACING : Image::HIDDEN;
  }

  bool is_facing(const Vec3& x, const Vec3& n) const
  {
    for(std::size_t v = 0; v < m_free_space.number_of_views(); ++v)
      if(m_free_space.projection(v).towards_scanner(x).dot(n) > least_cosine)
        return true;
    return false;
  }

  void make_cells()
  {
    const Vec3 sides = m_box.sides();
    m_cell = (std::max)(1.5, std::cbrt(sides.x() * sides.y() * sides.z() / most_cells));
    const auto cells = [&](int axis) { return std::floor(sides[axis] / m_cell) + 1; };
    while(cells(0) * cells(1) * cells(2) > 8 * most_cells)  // a wide flat box
      m_cell *= 2;
    for(int axis = 0; axis < 3; ++axis)
      m_size[axis] = std::size_t(cells(axis));
    m_nearest.resize(m_size[0] * m_size[1] * m_size[2]);
    parallel_for(m_execution, m_nearest.size(), [&](std::size_t c) {
      const std::size_t row = c / m_size[0], layer = row / m_size[1];
      const Vec3 at(double(c % m_size[0]), double(row % m_size[1]), double(layer));
      m_nearest[c] = m_tree.nearest(m_box.lower + m_cell * (at + Vec3::Constant(0.5))).index;
    });
  }

  /// The point nearest to the middle of the cell.
  Index roughly_nearest(const Vec3& x) const
  {
    std::size_t index[3];
    for(int axis = 0; axis < 3; ++axis) {
      const double at = (x[axis] - m_box.lower[axis]) / m_cell;
      index[axis] = at > 0 ? (std::min)(m_size[axis] - 1, std::size_t(at)) : 0;
    }
    return m_nearest[(index[2] * m_size[1] + index[1]) * m_size[0] + index[0]];
  }

  std::vector<Index> sample(std::size_t count) const
  {
    std::vector<Index> indices;
    const double step = (std::max)(1., double(m_points.size()) / double(count));
    double i = 0;
    while(i < double(m_points.size())) {
      indices.push_back(Index(i));
      i += step;
    }
    return indices;
  }

  std::vector<Scored> coarse_search() const
  {
    const std::vector<Index> samples = sample(coarse_samples);
    const Vec3 centre = m_box.centre();
    std::vector<Scored> best_of(directions);
    parallel_for(m_execution, directions, [&](std::size_t d) {
      const Vec3 normal = half_sphere_direction(d, directions);
      double low = 0, high = 0;
      for(const Index i : samples) {
        low = (std::min)(low, normal.dot(m_points[i] - centre));
        high = (std::max)(high, normal.dot(m_points[i] - centre));
      }
      best_of[d].score = -1e300;
      const double step = (std::max)(offset_step, (high - low) / most_offsets);
      double o = low + step;
      while(o < high) {
        const Mirror_plane plane{normal, normal.dot(centre) + o};
        const double s = coarse_score(plane, samples, best_of[d].score);
        if(s > best_of[d].score)
          best_of[d] = {plane, s};
        o += step;
      }
    });
    std::stable_sort(best_of.begin(), best_of.end(),
                     [](const Scored& a, const Scored& b) { return a.score > b.score; });
    std::vector<Scored> result;
    for(const Scored& c : best_of) {
      if(std::none_of(result.begin(), result.end(), [&](const Scored& other) {
           return difference(other.plane, c.plane) < 1.5 * coarse_tolerance;
         }))
        result.push_back(c);
      if(result.size() == candidates)
        break;
    }
    return result;
  }

  double coarse_score(const Mirror_plane& plane, const std::vector<Index>& samples, double wanted) const
  {
    double sum = 0;
    for(std::size_t k = 0; k < samples.size(); ++k) {
      switch(image(plane, samples[k], coarse_tolerance)) {
        case Image::MATCHED: sum += 1; break;
        case Image::FREE: sum -= 1; break;
        case Image::FACING: sum -= unmatched_cost; break;
        default: break;
      }
      if(sum + double(samples.size() - 1 - k) < (std::max)(wanted, 0.))
        break;
    }
    return sum;
  }

  /// Mean distance between the images by two planes.
  double difference(const Mirror_plane& a, const Mirror_plane& b) const
  {
    double sum = 0;
    const std::vector<Index> samples = sample(32);
    for(const Index i : samples)
      sum += (a.reflected(m_points[i]) - b.reflected(m_points[i])).norm();
    return sum / double(samples.size());
  }

  /// Gauss-Newton on the distances of images from the tangent planes of their matches.
  Mirror_plane refined(Mirror_plane plane, const std::vector<Index>& samples, double tolerance) const
  {
    for(int iteration = 0; iteration < refinements; ++iteration) {
      const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
      Mat3 matrix = 1e-6 * Mat3::Identity();
      Vec3 right = Vec3::Zero();
      for(const Index i : samples) {
        const Vec3& x = m_points[i];
        const double height = plane.height(x);
        const Vec3 y = x - 2 * height * plane.normal;
        const Neighbor nearest = m_tree.nearest(y);
        const Vec3 &q = m_points[nearest.index], &at = m_normals[nearest.index];
        if(nearest.squared_distance > (tolerance + 1) * (tolerance + 1) ||
           at.dot(plane.reflected_vector(m_normals[i])) < same_side)
          continue;
        const double r = at.dot(y - q);
        if(std::abs(r) > tolerance)
          continue;
        const double along = at.dot(plane.normal);
        const Vec3 gradient(-2 * (u.dot(x) * along + height * at.dot(u)),
                            -2 * (v.dot(x) * along + height * at.dot(v)), 2 * along);
        matrix += gradient * gradient.transpose();
        right -= r * gradient;
      }
      const Vec3 step = solve_normal_equations(matrix, right);
      const Vec3 normal = plane.normal + step[0] * u + step[1] * v;
      const double length = normal.norm();
      if(!(length > 0.5 && length < 2))
        break;
      plane.offset = (plane.offset + step[2]) / length;
      plane.normal = normal / length;
      tolerance = (std::max)(fine_tolerance, 0.8 * tolerance);
    }
    return plane;
  }

  const Execution& m_execution;
  const Points& m_points;
  const Points& m_normals;
  const Free_space& m_free_space;
  Nearest_neighbors m_tree;
  Bounding_box m_box;
  double m_cell = 1;
  std::size_t m_size[3];
  std::vector<Index> m_nearest;   ///< to the middle of each cell
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MIRROR_SYMMETRY_H
