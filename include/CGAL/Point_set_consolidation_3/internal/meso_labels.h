// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_LABELS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_LABELS_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/meso_graph_types.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/sorted_grid.h>
#include <CGAL/Point_set_consolidation_3/internal/tangent_rings.h>
#include <CGAL/Point_set_consolidation_3/options.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Where the meso-skeleton is a sheet and where it is a curve. Lengths in units of the spacing r of S.
///
/// The surface normals around an anchor tell: along a sheet they are all parallel to one line, around a curve
/// they turn in a plane, at an end they point everywhere. That holds for one-sided data as well.

/// Of a ring, the point itself included.
inline std::size_t link_neighbors(const Meso_shape& shape)
{
  constexpr std::size_t ring_neighbors = 12;
  return (std::min)(ring_neighbors, shape.outer.size());
}

/// Rings join the walls of a crevice as well; their normals oppose each other.
inline bool are_opposed(const Meso_shape& shape, std::size_t i, std::size_t j)
{
  constexpr double least_cosine = -0.5;
  return shape.normals[i].dot(shape.normals[j]) < least_cosine;
}

/// Which outer points are neighbours on the surface. A few points on a thin rim that have no neighbours but opposed
/// ones keep these.
inline std::vector<Ring_edge> surface_links(const Execution& execution, const Meso_shape& shape)
{
  const std::size_t n = shape.outer.size(), few = link_neighbors(shape);
  std::vector<Ring_edge> links = find_tangent_rings(execution, shape.outer, few).edges;
  Disjoint_sets parts(n);
  for(const Ring_edge& e : links)
    if(!are_opposed(shape, e[0], e[1]))
      parts.join(e[0], e[1]);
  std::vector<std::size_t> size(n, 0);
  for(std::size_t i = 0; i < n; ++i)
    ++size[parts.find(i)];
  links.erase(std::remove_if(links.begin(), links.end(),
                             [&](const Ring_edge& e) {
                               return are_opposed(shape, e[0], e[1]) && size[parts.find(e[0])] >= few &&
                                      size[parts.find(e[1])] >= few;
                             }),
              links.end());
  return links;
}

class Sheet_finder {
  /// Mean squared cosine of the normals to their principal line: 1 on a sheet, 1/2 around a curve, 1/3 at
  /// an end.
  static constexpr double least_flatness = 0.75;
  static constexpr int smoothing_passes = 2;
  /// A sheet is wider than thick by this factor; less is the flat side of a tube.
  static constexpr double least_aspect = 2;
  static constexpr double least_width = 5;  ///< in r
  static constexpr double least_neighborhood = 2, largest_neighborhood = 8;  ///< radius, in r
  /// The rim of a sheet looks like a curve or an end; it is not thicker than the sheet, by this factor.
  static constexpr double largest_rim = 1.5;

public:
  Sheet_finder(const Execution& execution, const Meso_shape& shape, const std::vector<Ring_edge>& links)
    : m_execution(execution), m_shape(shape), m_links(links), m_radius(shape.anchors.size())
    , m_grid(shape.anchors, least_neighborhood)
  {
    const Nearest_neighbors tree(shape.outer);
    parallel_for(execution, m_radius.size(), [&](std::size_t i) {
      m_radius[i] = std::sqrt(tree.nearest(shape.anchors[i]).squared_distance);
    });
  }

  /// One flag per anchor.
  std::vector<char> find() const
  {
    const std::vector<double> flat = flatness();
    std::vector<char> is_sheet(flat.size());
    for(std::size_t i = 0; i < flat.size(); ++i)
      is_sheet[i] = flat[i] > least_flatness;
    remove_narrow(is_sheet);
    add_rims(is_sheet);
    add_remnants(is_sheet);
    return is_sheet;
  }

private:
  std::vector<double> flatness() const
  {
    const std::size_t n = m_radius.size();
    std::vector<double> flat(n);
    parallel_for(m_execution, n, [&](std::size_t i) {
      const double radius =
        (std::min)(largest_neighborhood, (std::max)(least_neighborhood, 0.5 * m_radius[i]));
      Mat3 sum = Mat3::Zero();
      m_grid.for_each_neighbor(m_shape.anchors[i], radius, [&](Index j, double) {
        sum += m_shape.normals[j] * m_shape.normals[j].transpose();
        return true;
      });
      const Vec3 spectrum = Eigen::SelfAdjointEigenSolver<Mat3>(sum, Eigen::EigenvaluesOnly).eigenvalues();
      flat[i] = spectrum[2] / spectrum.sum();
    });
    for(int pass = 0; pass < smoothing_passes; ++pass) {
      std::vector<double> sum = flat, count(n, 1.);
      for(const Ring_edge& e : m_links)
        for(int end = 0; end < 2; ++end) {
          sum[e[end]] += flat[e[1 - end]];
          count[e[end]] += 1;
        }
      for(std::size_t i = 0; i < n; ++i)
        flat[i] = sum[i] / count[i];
    }
    return flat;
  }

  void remove_narrow(std::vector<char>& is_sheet) const
  {
    const std::size_t n = m_radius.size();
    Disjoint_sets sets(n);
    for(const Ring_edge& e : m_links)
      if(is_sheet[e[0]] && is_sheet[e[1]])
        sets.join(e[0], e[1]);
    std::vector<Covariance_sum> extent(n);
    std::vector<double> radius(n, 0.);
    for(std::size_t i = 0; i < n; ++i)
      if(is_sheet[i]) {
        const std::size_t part = sets.find(i);
        extent[part].add(m_shape.anchors[i] - m_shape.anchors[part]);
        radius[part] += m_radius[i];
      }
    std::vector<char> is_wide(n, 0);
    for(std::size_t i = 0; i < n; ++i)
      if(is_sheet[i] && sets.find(i) == i) {
        const double thickness = 2 * radius[i] / double(extent[i].count());
        // of a uniformly covered rectangle
        const double width = std::sqrt(12 * (std::max)(0., extent[i].axes().eigenvalues()[1]));
        is_wide[i] = width > (std::max)(least_aspect * thickness, least_width);
      }
    for(std::size_t i = 0; i < n; ++i)
      is_sheet[i] = is_sheet[i] && is_wide[sets.find(i)];
  }

  void add_rims(std::vector<char>& is_sheet) const
  {
    const std::vector<char> was_sheet = is_sheet;
    for(std::size_t i = 0; i < was_sheet.size(); ++i) {
      if(!was_sheet[i])
        continue;
      m_grid.for_each_neighbor(m_shape.anchors[i], m_radius[i] + least_neighborhood,
                               [&](Index j, double) {
        if(m_radius[j] <= largest_rim * m_radius[i])
          is_sheet[j] = 1;
        return true;
      });
    }
  }

  /// What is left between sheets, or on their rims, smaller than a sheet may be wide, belongs to them.
  void add_remnants(std::vector<char>& is_sheet) const
  {
    const std::size_t n = m_radius.size();
    Disjoint_sets sets(n);
    for(const Ring_edge& e : m_links)
      if(!is_sheet[e[0]] && !is_sheet[e[1]])
        sets.join(e[0], e[1]);
    std::vector<char> touches(n, 0), is_small(n, 1);
    for(const Ring_edge& e : m_links)
      if(is_sheet[e[0]] != is_sheet[e[1]])
        touches[sets.find(e[is_sheet[e[0]] ? 1 : 0])] = 1;
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t part = sets.find(i);
      if((m_shape.anchors[i] - m_shape.anchors[part]).norm() > least_width)
        is_small[part] = 0;
    }
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t part = sets.find(i);
      if(!is_sheet[i] && touches[part] && is_small[part])
        is_sheet[i] = 1;
    }
  }

  const Execution& m_execution;
  const Meso_shape& m_shape;
  const std::vector<Ring_edge>& m_links;
  std::vector<double> m_radius;  ///< distance of the anchors to S
  Sorted_grid m_grid;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_MESO_LABELS_H
