// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later


#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EDGE_AWARE_UPSAMPLING_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EDGE_AWARE_UPSAMPLING_H

#include <CGAL/Point_set_consolidation_3/internal/feature_parameters.h>
#include <CGAL/Point_set_consolidation_3/internal/feature_projection.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {

namespace internal {

/// Feature-enhanced surfaces paper, section III.B: new points in the sparsest places, projected with the
/// anisotropic weights. In: points with normals that separate clusters. Out: these first and
/// unchanged, then the new ones. Lengths in units of the spacing of the input.
///
/// Insertion goes in rounds: all bases are rated on the same set, then the best are taken as long as they
/// do not crowd each other. So the result does not depend on threads, and a round is parallel.

class Edge_aware_upsampling {
  static constexpr std::size_t rating_neighbors = 18;   ///< a base's nearest points are among them
  static constexpr std::size_t projection_neighbors = 30;
  static constexpr double share_of_round = 0.4;         ///< best bases that one round may take
  static constexpr double least_clearance = 1e-3;       ///< points closer than that are no gain
  static constexpr double edge_reach = 1.5;             ///< a base goes onto an edge at most so many clearances away

public:
  Edge_aware_upsampling(Execution& execution, const Points& points, const Points& normals,
                        const Edge_aware_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_points(points), m_normals(normals)
    , m_phi(parameters.sharpness_angle, parameters.oriented)
  {}

  void run(Stage& stage)
  {
    const std::size_t start = m_points.size(), goal = m_parameters.number_of_points;
    while(m_points.size() < goal && insert_round(goal - m_points.size())) {
      stage.count_iteration();
      stage.update(double(m_points.size() - start) / double(goal - start));
    }
  }

  Points& points() { return m_points; }
  Points& normals() { return m_normals; }

private:
  struct Base {
    double score = 0;      ///< clearance, raised at edges
    double clearance = 0;
    Index first = 0, second = 0;
  };

  bool insert_round(std::size_t wanted)
  {
    const Nearest_table table =
      nearest_table(m_execution, m_points, (std::max)(rating_neighbors, projection_neighbors));
    std::vector<Base> bases(m_points.size());
    parallel_for(m_execution, bases.size(), [&](std::size_t i) { bases[i] = best_base(table, i); });
    const std::vector<Base> chosen = spread_out(std::move(bases), wanted);
    if(chosen.empty())
      return false;

    const Edge_finder edges(m_points, m_normals, projection_neighbors, m_parameters.oriented);
    Points new_points(chosen.size()), new_normals(chosen.size());
    parallel_for(m_execution, chosen.size(), [&](std::size_t k) {
      project(table, edges, chosen[k], new_points[k], new_normals[k]);
    });
    m_points.insert(m_points.end(), new_points.begin(), new_points.end());
    m_normals.insert(m_normals.end(), new_normals.begin(), new_normals.end());
    return true;
  }

  Vec3 place(const Base& base) const { return 0.5 * (m_points[base.first] + m_points[base.second]); }

  /// C(b) of equation (5): the least distance to the normal lines of the points around.
  double clearance(const Nearest_table& table, std::size_t i, const Vec3& b) const
  {
    double least = line_distance(i, b);
    for(std::size_t k = 0; k < (std::min)(rating_neighbors, table.k); ++k) {
      const Index j = table.row(i)[k];
      if(m_parameters.oriented && m_normals[i].dot(m_normals[j]) < -0.5)
        continue;  // the other side of a thin plate
      least = (std::min)(least, line_distance(j, b));
    }
    return least;
  }
  double line_distance(std::size_t j, const Vec3& b) const
  {
    const Vec3 d = b - m_points[j];
    return (d - m_normals[j].dot(d) * m_normals[j]).norm();
  }

  Base best_base(const Nearest_table& table, std::size_t i) const
  {
    Base best;
    for(std::size_t k = 0; k < (std::min)(rating_neighbors, table.k); ++k) {
      const Index j = table.row(i)[k];
      const double distance = (m_points[j] - m_points[i]).norm();
      if(distance > m_parameters.neighbor_radius)
        break;
      const double cosine = m_phi.cosine(m_normals[i], m_normals[j]);
      if(m_parameters.oriented && cosine < -0.5)
        continue;
      const double factor = std::pow(2 - cosine, m_parameters.edge_sensitivity);
      if(0.5 * distance * factor <= best.score)
        continue;  // its two ends are the nearest points at most
      const double c = clearance(table, i, 0.5 * (m_points[i] + m_points[j]));
      if(c * factor > best.score && c > least_clearance)
        best = Base{c * factor, c, Index(i), j};
    }
    return best;
  }

  /// The best bases in falling order, without those that lie in the clearance of a better one.
  std::vector<Base> spread_out(std::vector<Base> bases, std::size_t wanted) const
  {
    bases.erase(std::remove_if(bases.begin(), bases.end(),
                               [](const Base& b) { return !(b.score > 0); }),
                bases.end());
    std::sort(bases.begin(), bases.end(), [](const Base& a, const Base& b) {
      return a.score != b.score ? a.score > b.score
             : a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    const std::size_t share = (std::max)(std::size_t(share_of_round * double(bases.size())),
                                         (std::min)(bases.size(), std::size_t(1)));
    bases.resize(share);
    Points places;
    double largest = least_clearance;
    for(const Base& base : bases) {
      places.push_back(place(base));
      largest = (std::max)(largest, base.clearance);
    }
    const Sorted_grid grid(places, largest);
    std::vector<char> taken(bases.size(), 0);
    std::vector<Base> chosen;
    for(std::size_t k = 0; k < bases.size() && chosen.size() < wanted; ++k) {
      bool crowded = false;
      grid.for_each_neighbor(places[k], bases[k].clearance, [&](Index other, double) {
        crowded = crowded || taken[other];
        return !crowded;
      });
      if(!crowded) {
        taken[k] = 1;
        chosen.push_back(bases[k]);
      }
    }
    return chosen;
  }

  /// sigma(n, b - s) theta phi: weight of point j for a base.
  double weight(const Vec3& n, const Vec3& offset, std::size_t j, double reach) const
  {
    const double t = n.dot(offset) / m_parameters.plane_width;
    const double theta = m_parameters.formula == Upsampling_formula::PRINTED
                           ? 1 : std::exp(-2 * offset.squaredNorm() / reach);
    return std::exp(-t * t) * theta * m_phi(n, m_normals[j]);
  }

  /// Position of a base on the surface with normal `n`, and how well the surface fits: equation (5).
  struct Projection {
    Vec3 point, normal;
    double residual;
  };
  Projection projected(const Nearest_table& table, const Base& base, Index owner) const
  {
    const Vec3 b = place(base), n = m_normals[owner];
    const double reach = (std::max)(
      tiny_length,
      (m_points[table.row(base.first)[table.k - 1]] - m_points[base.first]).squaredNorm());
    Local_surface surface;
    double residual = 0;
    const auto add = [&](std::size_t j) {
      const Vec3 offset = m_points[j] - b;
      const double w = weight(n, offset, j, reach);
      const double height = n.dot(offset);
      residual += w * height * height;
      if(m_parameters.formula == Upsampling_formula::PRINTED) {
        surface.step += w * height * n;  // equation (6)
        surface.normal += w * (n.dot(m_normals[j]) < 0 ? Vec3(-m_normals[j]) : m_normals[j]);
        surface.weight += w;
      }
      else
        add_to_surface(surface, n, offset, m_normals[j], w);
    };
    add(base.first);
    for(std::size_t k = 0; k < table.k; ++k)
      add(table.row(base.first)[k]);
    if(!(surface.weight > tiny_length))
      return {b, n, residual};
    return {b + surface.step / surface.weight, normalized_or(surface.normal, n),
            residual / surface.weight};
  }

  void project(const Nearest_table& table, const Edge_finder& edges, const Base& base, Vec3& point,
               Vec3& normal) const
  {
    Projection best = projected(table, base, base.first);
    const Projection other = projected(table, base, base.second);
    if(other.residual < best.residual)
      best = other;
    point = best.point;
    normal = best.normal;
    if(m_parameters.formula == Upsampling_formula::EDGES) {
      const bool across = m_phi(m_normals[base.first], m_normals[base.second]) < 0.1;
      point = edges.returned_to_edge(point, normal, across ? edge_reach * base.clearance : 0);
    }
  }

  Execution& m_execution;
  Edge_aware_parameters m_parameters;
  Points m_points, m_normals;
  Normal_similarity m_phi;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EDGE_AWARE_UPSAMPLING_H
