// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SINKING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SINKING_H

#include <CGAL/Point_set_consolidation_3/internal/bilateral_weights.h>
#include <CGAL/Point_set_consolidation_3/internal/deep_points_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/neighbor_lists.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Deep points paper, section 4.1: inner points start on the consolidated points S and sink along the
/// negative normals until opposing fronts meet.
/// In: points and unit normals, lengths in units of the spacing r of S. Out: one anchor point per point.
/// Every step reads the previous state and writes a new one, so the order of points does not matter.

using Point_set_consolidation_3::Anchoring;

struct Sunk_points {
  Points normals;                  ///< bilaterally smoothed
  Points anchors;                  ///< H
  std::vector<Anchoring> anchoring;
  std::size_t iterations = 0;
};

class Sinking {
  /// A point whose advance falls below this has settled; 0.1 or 0.005 give the same anchors.
  static constexpr double settled_advance = 0.02;
  static constexpr int normal_smoothing_passes = 2;
  static constexpr double first_advance = 0.5;
  static constexpr double farthest_sunk = 0.5;  ///< in diagonals: what is deeper than any shape ran away

public:
  Sinking(Execution& execution, const Points& points, const Points& normals,
          const Sinking_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_points(points)
    , m_weights{std::cos(parameters.collision_angle)}
    , m_diagonal(bounding_box(points).diagonal())
  {
    const Sorted_grid grid(points, (std::min)(parameters.smoothing_radius, theta_support));
    m_neighbors = make_neighbor_lists(execution, grid, points, parameters.smoothing_radius);
    m_near = make_neighbor_lists(execution, grid, points, theta_support);
    m_near_weights.resize(m_near.neighbors.size());
    m_result.normals = normals;
    for(int pass = 0; pass < normal_smoothing_passes; ++pass) {
      update_near_weights();
      smooth_normals();
    }
    update_near_weights();
  }

  Sunk_points run(Stage& stage)
  {
    const std::size_t n = m_points.size();
    m_result.anchors = m_points;
    m_result.anchoring.assign(n, Anchoring::sinking);
    m_closing.assign(n, -1.);
    m_advance.assign(n, 0.);
    const std::size_t last = m_parameters.max_iterations;
    for(std::size_t t = 0; t < last && count(Anchoring::sinking) > 0; ++t) {
      settle_where_fronts_meet();
      advance(t == 0);
      smooth_unsettled();
      stop_runaways();
      ++m_result.iterations;
      stage.count_iteration();
      stage.update(double(t + 1) / double(last));
    }
    if(m_parameters.closing_step)
      close();
    mark_components_without_opposition();
    inherit_lengths();
    return std::move(m_result);
  }

private:
  bool is(std::size_t i, Anchoring a) const { return m_result.anchoring[i] == a; }
  std::size_t count(Anchoring a) const
  {
    return std::size_t(std::count(m_result.anchoring.begin(), m_result.anchoring.end(), a));
  }

  void update_near_weights()
  {
    parallel_for(m_execution, m_points.size(), [&](std::size_t i) {
      for(std::size_t k = m_near.begin(i); k < m_near.end(i); ++k) {
        const std::size_t j = m_near.neighbors[k];
        m_near_weights[k] = Bilateral_weights::theta((m_points[j] - m_points[i]).squaredNorm()) *
                            m_weights.phi(m_result.normals[i], m_result.normals[j]);
      }
    });
  }

  void smooth_normals()
  {
    Points smoothed(m_points.size());
    parallel_for(m_execution, m_points.size(), [&](std::size_t i) {
      smoothed[i] = normalized_or(weighted_mean(i, m_result.normals), m_result.normals[i]);
    });
    m_result.normals.swap(smoothed);
  }

  /// Equation (3). The point itself has weight 1, so the sum of weights is positive.
  Vec3 weighted_mean(std::size_t i, const Points& values) const
  {
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for(std::size_t k = m_near.begin(i); k < m_near.end(i); ++k) {
      sum += m_near_weights[k] * values[m_near.neighbors[k]];
      weight += m_near_weights[k];
    }
    return sum / weight;
  }

  /// Equation (2), read as "some neighbour" (the printed maximum over the neighbours never fires),
  /// and only for fronts that approach each other: on a concave crease normals differ as well.
  /// How far the fronts still are from where they touch is measured on the surface, where positions
  /// and normals belong together: smoothing has drawn the fronts' borders inwards meanwhile, which
  /// made lengths 2.5 % short on one side of a tube.
  void settle_where_fronts_meet()
  {
    const Points& q = m_result.anchors;
    const Points& normals = m_result.normals;
    const Sorted_grid grid(q, m_parameters.collision_radius);
    const double furthest =
      m_parameters.collision_radius / (2 * std::sin(0.5 * m_parameters.collision_angle));
    m_next_anchoring = m_result.anchoring;
    parallel_for(m_execution, q.size(), [&](std::size_t i) {
      if(!is(i, Anchoring::sinking))
        return;
      double length = 0, weight = 0;
      grid.for_each_neighbor(q[i], m_parameters.collision_radius, [&](Index j, double) {
        if(normals[j].dot(normals[i]) <= m_weights.cosine) {
          const Vec3 difference = normals[j] - normals[i];
          if((q[j] - q[i]).dot(difference) > 0) {
            length += (m_points[j] - m_points[i]).dot(difference);
            weight += difference.squaredNorm();
          }
        }
        return true;
      });
      if(weight > 0) {
        const double depth = (m_points[i] - q[i]).dot(normals[i]);
        m_next_anchoring[i] = Anchoring::collided;
        m_closing[i] = (std::min)((std::max)(length / weight - depth, 0.), furthest);
      }
    });
    m_result.anchoring.swap(m_next_anchoring);
  }

  /// Moves unsettled points by the mean of their static neighbours' previous advances.
  void advance(bool is_first)
  {
    std::vector<double> advances(m_points.size(), 0.);
    parallel_for(m_execution, m_points.size(), [&](std::size_t i) {
      if(!is(i, Anchoring::sinking))
        return;
      double t = first_advance;
      if(!is_first) {
        t = 0;
        for(std::size_t k = m_neighbors.begin(i); k < m_neighbors.end(i); ++k)
          t += m_advance[m_neighbors.neighbors[k]];
        t /= double(m_neighbors.count(i));
      }
      if(t < settled_advance) {
        m_result.anchoring[i] = Anchoring::slowed;
        return;
      }
      advances[i] = t;
      m_result.anchors[i] -= t * m_result.normals[i];
    });
    m_advance.swap(advances);
  }

  void smooth_unsettled()
  {
    Points smoothed = m_result.anchors;
    parallel_for(m_execution, m_points.size(), [&](std::size_t i) {
      if(is(i, Anchoring::sinking))
        smoothed[i] = weighted_mean(i, m_result.anchors);
    });
    m_result.anchors.swap(smoothed);
  }

  void stop_runaways()
  {
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(is(i, Anchoring::sinking) &&
         (m_result.anchors[i] - m_points[i]).norm() > farthest_sunk * m_diagonal)
        m_result.anchoring[i] = Anchoring::inherited;
  }

  /// Fronts are found to meet while still apart, up to `furthest` before a curve: each settled point
  /// goes on to where the colliding fronts touch (exact on cylinders, spheres, parallel sheets).
  void close()
  {
    constexpr int max_passes = 1000;
    constexpr int least_passes = 20;  // in which what was filled evens out
    for(int pass = 0; pass < max_passes; ++pass) {
      std::vector<double> filled = m_closing;
      parallel_for(m_execution, m_points.size(), [&](std::size_t i) {
        if(!is(i, Anchoring::slowed))
          return;
        double sum = 0, weight = 0;
        for(std::size_t k = m_near.begin(i); k < m_near.end(i); ++k) {
          const double closing = m_closing[m_near.neighbors[k]];
          if(closing >= 0) {
            sum += m_near_weights[k] * closing;
            weight += m_near_weights[k];
          }
        }
        if(weight > 0)
          filled[i] = sum / weight;
      });
      const bool is_complete = pass >= least_passes && filled_count(filled) == filled_count(m_closing);
      m_closing.swap(filled);
      if(is_complete)
        break;
    }
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(m_closing[i] > 0)
        m_result.anchors[i] -= m_closing[i] * m_result.normals[i];
  }
  static std::size_t filled_count(const std::vector<double>& closing)
  {
    return std::size_t(std::count_if(closing.begin(), closing.end(),
                                     [](double c) { return c >= 0; }));
  }

  /// A component in which no fronts met would sink for ever: its depth is that of a lens as thick as the
  /// component is wide (a standard deviation of its width, 0.58 of that, loses thin arms in the mesh).
  void mark_components_without_opposition()
  {
    std::vector<char> is_visited(m_points.size(), 0);
    std::vector<std::size_t> component;
    for(std::size_t seed = 0; seed < m_points.size(); ++seed) {
      if(is_visited[seed])
        continue;
      component.assign(1, seed);
      is_visited[seed] = 1;
      bool has_collision = false;
      for(std::size_t c = 0; c < component.size(); ++c) {
        const std::size_t i = component[c];
        has_collision = has_collision || is(i, Anchoring::collided);
        for(std::size_t k = m_neighbors.begin(i); k < m_neighbors.end(i); ++k) {
          const std::size_t j = m_neighbors.neighbors[k];
          if(!is_visited[j]) {
            is_visited[j] = 1;
            component.push_back(j);
          }
        }
      }
      if(has_collision)
        continue;
      Covariance_sum sum;
      for(const std::size_t i : component)
        sum.add(m_points[i] - m_points[seed]);
      const double depth = std::sqrt(3 * (std::max)(0., sum.axes().eigenvalues()[1]));  // half of an even width
      for(const std::size_t i : component) {
        m_result.anchoring[i] = Anchoring::unanchored;
        m_result.anchors[i] = m_points[i] - depth * m_result.normals[i];
      }
    }
  }

  /// Points that never settled take the mean length of settled neighbours, ring by ring.
  void inherit_lengths()
  {
    std::vector<char> is_known(m_points.size());
    std::vector<double> length(m_points.size());
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      if(is(i, Anchoring::sinking))
        m_result.anchoring[i] = Anchoring::inherited;
      is_known[i] = !is(i, Anchoring::inherited);
      length[i] = (m_result.anchors[i] - m_points[i]).norm();
    }
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      std::vector<char> was_known = is_known;
      for(std::size_t i = 0; i < m_points.size(); ++i) {
        if(was_known[i])
          continue;
        double sum = 0;
        std::size_t known = 0;
        for(std::size_t k = m_neighbors.begin(i); k < m_neighbors.end(i); ++k) {
          const std::size_t j = m_neighbors.neighbors[k];
          if(was_known[j]) {
            sum += length[j];
            ++known;
          }
        }
        if(known > 0) {
          length[i] = sum / double(known);
          m_result.anchors[i] = m_points[i] - length[i] * m_result.normals[i];
          is_known[i] = 1;
          has_changed = true;
        }
      }
    }
  }

  Execution& m_execution;
  Sinking_parameters m_parameters;
  const Points& m_points;
  Bilateral_weights m_weights;
  double m_diagonal;
  Neighbor_lists m_neighbors;           ///< P_i, radius sigma_p
  Neighbor_lists m_near;                ///< where theta does not vanish
  std::vector<double> m_near_weights;   ///< theta phi, per entry of `m_near`
  std::vector<double> m_advance;        ///< of the previous iteration, 0 for settled points
  std::vector<double> m_closing;        ///< distance to where the fronts touch, -1: not known
  std::vector<Anchoring> m_next_anchoring;
  Sunk_points m_result;
};

inline Sunk_points sink(Execution& execution, Stage& stage, const Points& points,
                        const Points& normals, const Sinking_parameters& parameters)
{
  return Sinking(execution, points, normals, parameters).run(stage);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SINKING_H
