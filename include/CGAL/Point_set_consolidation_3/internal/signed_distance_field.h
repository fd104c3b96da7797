// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SIGNED_DISTANCE_FIELD_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SIGNED_DISTANCE_FIELD_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>
#include <CGAL/Point_set_consolidation_3/internal/field_equations.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>
#include <CGAL/Point_set_consolidation_3/internal/skeleton_parameters.h>

#include <stdexcept>
#include <unordered_map>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Laplacian contraction paper, section V: the signed distance field of a shape from its points and its
/// skeleton, negative inside.
///
/// The domain is an octree of lattices: a coarse one fills the box, each finer one covers what is near points, skeleton
/// and the surface of the level before, whose field gives the guess, and the values at its border. So only cells near
/// the surface are small. Or all lattices fill the box, for a regular grid, and are the levels of a multigrid solver.

struct Distance_field {
  Frame frame;  ///< local coordinates are those of the lattice
  Sparse_lattice lattice;
  std::vector<double> values;  ///< in units of the spacing
};

class Signed_distance_field {
  static constexpr double least_padding = 0.15;  ///< of the box's longest side
  static constexpr double most_padding = 1;      ///< more would not fit the outermost level
  static constexpr double sample_spacing = 0.01; ///< of the skeleton, in diagonals
  static constexpr double most_coarse_cells = 30000;
  static constexpr double most_direct_cells = 1000;  ///< of the coarsest level of a regular grid, solved directly
  static constexpr std::int64_t band = 2;        ///< cells of the level before around what is refined

  struct Sample {
    Vec3 position;
    double radius;
    bool is_constraint;
  };

public:
  /// `normals`: outward ones of the points, or empty. `is_constraint`: edges along which the field is minus the
  /// radius; empty: all.
  Signed_distance_field(Execution& execution, const Points& points, const Points& normals,
                        const Skeleton_graph& skeleton, const std::vector<char>& is_constraint,
                        const Field_parameters& parameters)
    : m_execution(execution), m_parameters(parameters), m_points(points), m_normals(normals)
  {
    place_box(skeleton);
    sample(skeleton, is_constraint);
  }

  Distance_field compute(Stage& stage)
  {
    const int levels = number_of_levels();
    double work_done = 0, work = 0;
    for(int level = 0; level < levels; ++level)
      work += std::pow(4., level);
    m_field.frame.origin = m_lower;
    m_field.frame.unit = m_spacing * std::pow(2., levels - 1);
    m_field.lattice = full_lattice();
    for(int level = 0; level < levels; ++level) {
      std::vector<char> is_fixed;
      if(level == 0)
        start_values(is_fixed);
      else
        refine(is_fixed);
      solve(is_fixed);
      stage.count_iteration();
      work_done += std::pow(4., level);
      stage.update(work_done / work);
    }
    return std::move(m_field);
  }

private:
  void place_box(const Skeleton_graph& skeleton)
  {
    Points all = m_points;
    double largest_radius = 0;
    for(const Skeleton_node& node : skeleton.nodes) {
      all.push_back(node.position - Vec3::Constant(node.radius));
      all.push_back(node.position + Vec3::Constant(node.radius));
      largest_radius = (std::max)(largest_radius, node.radius);
    }
    const Bounding_box box = bounding_box(all);
    const double side = box.sides().maxCoeff();
    m_diagonal = box.diagonal();
    m_spacing = side / double(m_parameters.resolution);
    // Outside constraints need nodes farther than K radii away; in an octree these cost little.
    const double outside = (m_parameters.outside_factor + 1) * largest_radius;
    const double padding =
      (std::max)(least_padding * side,
                 m_parameters.adaptive ? (std::min)(most_padding * side, outside) : 0);
    m_lower = box.lower - Vec3::Constant(padding);
    m_sides = box.sides() + Vec3::Constant(2 * padding);
  }

  /// Points along the edges, and the nodes, with radii between those of the ends.
  void sample(const Skeleton_graph& skeleton, const std::vector<char>& is_constraint)
  {
    for(const Skeleton_node& node : skeleton.nodes)
      m_samples.push_back({node.position, node.radius, is_constraint.empty()});
    for(std::size_t k = 0; k < is_constraint.size(); ++k)
      if(is_constraint[k])
        for(const std::size_t end : skeleton.edges[k])
          m_samples[end].is_constraint = true;
    for(const Skeleton_edge& e : skeleton.edges) {
      const bool constrains =
        is_constraint.empty() || is_constraint[std::size_t(&e - skeleton.edges.data())];
      const Skeleton_node& a = skeleton.nodes[e[0]];
      const Skeleton_node& b = skeleton.nodes[e[1]];
      const int count = int(std::ceil(skeleton.edge_length(e) / (sample_spacing * m_diagonal)));
      for(int k = 1; k < count; ++k) {
        const double t = double(k) / double(count);
        m_samples.push_back({a.position + t * (b.position - a.position),
                             a.radius + t * (b.radius - a.radius), constrains});
      }
    }
  }

  Lattice_point dimensions(double spacing) const
  {
    Lattice_point result;
    for(int axis = 0; axis < 3; ++axis)
      result[std::size_t(axis)] = std::int64_t(std::ceil(m_sides[axis] / spacing)) + 1;
    return result;
  }

  int number_of_levels() const
  {
    const double most_cells = m_parameters.adaptive ? most_coarse_cells : most_direct_cells;
    int levels = 1;
    for(double spacing = m_spacing;; spacing *= 2, ++levels) {
      const Lattice_point d = dimensions(spacing);
      if(double(d[0]) * double(d[1]) * double(d[2]) <= most_cells)
        break;
    }
    return levels;
  }

  Sparse_lattice full_lattice() const
  {
    const Lattice_point d = dimensions(m_field.frame.unit);
    return Sparse_lattice(d, [&](std::int64_t, std::int64_t, std::vector<std::int32_t>& xs) {
      for(std::int64_t x = 0; x < d[0]; ++x)
        xs.push_back(std::int32_t(x));
    });
  }

  Vec3 node_position(std::size_t i) const
  {
    const Lattice_point p = m_field.lattice.point(i);
    return Vec3(double(p[0]), double(p[1]), double(p[2]));
  }

  Points local_sample_positions() const
  {
    Points result;
    for(const Sample& s : m_samples)
      result.push_back(m_field.frame.to_local(s.position));
    return result;
  }

  /// The distance to the balls of the nearest samples.
  void start_values(std::vector<char>& is_fixed)
  {
    is_fixed.assign(m_field.lattice.size(), 0);
    m_field.values.assign(m_field.lattice.size(), 0.);
    const Points positions = local_sample_positions();
    const Nearest_neighbors tree(positions);
    parallel_for(m_execution, m_field.values.size(), [&](std::size_t i) {
      const Neighbor nearest = tree.nearest(node_position(i));
      m_field.values[i] = std::sqrt(nearest.squared_distance) -
                          m_samples[nearest.index].radius / m_field.frame.unit;
    });
  }

  static Lattice_point cell_of(const Vec3& local)
  {
    return {std::int64_t(std::floor(local.x())), std::int64_t(std::floor(local.y())),
            std::int64_t(std::floor(local.z()))};
  }

  Cell_mask all_cells() const
  {
    Lattice_point last = m_field.lattice.dimensions();
    for(std::int64_t& d : last)
      d -= 2;
    return Cell_mask({0, 0, 0}, last, true);
  }

  /// Cells that the next level of an octree divides: those with points, with skeleton, or with a change of sign, and
  /// cells around them.
  Cell_mask cells_to_divide() const
  {
    const Sparse_lattice& lattice = m_field.lattice;
    std::vector<Lattice_point> cells;
    for(const Vec3& p : m_points)
      cells.push_back(cell_of(m_field.frame.to_local(p)));
    for(const Sample& s : m_samples)
      cells.push_back(cell_of(m_field.frame.to_local(s.position)));
    std::array<std::size_t, 8> corners;
    for(std::size_t i = 0; i < lattice.size(); ++i) {
      const Lattice_point cell = lattice.point(i);
      if(!lattice.corners(cell, corners))
        continue;
      bool has_inside = false, has_outside = false;
      for(const std::size_t c : corners)
        (m_field.values[c] < 0 ? has_inside : has_outside) = true;
      if(has_inside && has_outside)
        cells.push_back(cell);
    }
    Lattice_point lower = cells.front(), upper = cells.front();
    for(const Lattice_point& cell : cells)
      for(std::size_t axis = 0; axis < 3; ++axis) {
        lower[axis] = (std::min)(lower[axis], cell[axis]);
        upper[axis] = (std::max)(upper[axis], cell[axis]);
      }
    for(std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] -= band;
      upper[axis] += band;
    }
    Cell_mask mask(lower, upper);
    for(const Lattice_point& cell : cells)
      mask.set(cell);
    mask.dilate(band);
    // only cells of this level can be divided
    for(std::int64_t z = lower[2]; z <= upper[2]; ++z)
      for(std::int64_t y = lower[1]; y <= upper[1]; ++y)
        for(std::int64_t x = lower[0]; x <= upper[0]; ++x)
          if(mask(x, y, z) && !lattice.corners({x, y, z}, corners))
            mask.set({x, y, z}, false);
    return mask;
  }

  /// The next level. Nodes at its border, inside of the box, keep the values of this level.
  void refine(std::vector<char>& is_fixed)
  {
    const Cell_mask mask = m_parameters.adaptive ? cells_to_divide() : all_cells();
    const Lattice_point coarse = m_field.lattice.dimensions();
    Lattice_point fine;
    for(std::size_t axis = 0; axis < 3; ++axis)
      fine[axis] = 2 * (coarse[axis] - 1) + 1;
    // fine cell c is a child of coarse cell c / 2; a node has up to eight cells around it
    const auto cells_around = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
      int inside_box = 0, divided = 0;
      for(std::int64_t k = -1; k <= 0; ++k)
        for(std::int64_t j = -1; j <= 0; ++j)
          for(std::int64_t i = -1; i <= 0; ++i) {
            const std::int64_t cx = x + i, cy = y + j, cz = z + k;
            if(cx < 0 || cy < 0 || cz < 0 || cx >= fine[0] - 1 || cy >= fine[1] - 1 || cz >= fine[2] - 1)
              continue;
            ++inside_box;
            divided += mask(cx / 2, cy / 2, cz / 2);
          }
      return std::make_pair(inside_box, divided);
    };
    const Lattice_point lower = mask.lower(), upper = mask.upper();
    is_fixed.clear();
    Sparse_lattice lattice(
      fine, [&](std::int64_t y, std::int64_t z, std::vector<std::int32_t>& xs) {
        if(y < 2 * lower[1] || y > 2 * upper[1] + 2 || z < 2 * lower[2] || z > 2 * upper[2] + 2)
          return;
        const std::int64_t end = (std::min)(fine[0] - 1, 2 * upper[0] + 2);
        for(std::int64_t x = (std::max)(std::int64_t(0), 2 * lower[0]); x <= end; ++x) {
          const std::pair<int, int> cells = cells_around(x, y, z);
          if(cells.second == 0)
            continue;
          xs.push_back(std::int32_t(x));
          is_fixed.push_back(char(cells.second < cells.first));
        }
      });

    std::vector<double> values(lattice.size());
    parallel_for(m_execution, values.size(), [&](std::size_t i) {
      values[i] = 2 * interpolated(lattice.point(i));
    });
    if(!m_parameters.adaptive)
      m_interpolation = interpolation(lattice);
    m_field.lattice = std::move(lattice);
    m_field.values = std::move(values);
    m_field.frame.unit /= 2;
  }

  /// Calls `visit` with the nodes of the present level that a node of the next level is the middle of.
  template <typename Visitor>
  void for_each_coarse_node(const Lattice_point& fine, const Visitor& visit) const
  {
    for(std::int64_t k = 0; k <= (fine[2] & 1); ++k)
      for(std::int64_t j = 0; j <= (fine[1] & 1); ++j)
        for(std::int64_t i = 0; i <= (fine[0] & 1); ++i) {
          const std::size_t node = m_field.lattice.find(fine[0] / 2 + i, fine[1] / 2 + j, fine[2] / 2 + k);
          if(node != Sparse_lattice::none)
            visit(node);
        }
  }

  /// The present field at a node of the next level: the mean of the nodes around it.
  double interpolated(const Lattice_point& fine) const
  {
    double sum = 0;
    int count = 0;
    for_each_coarse_node(fine, [&](std::size_t node) {
      sum += m_field.values[node];
      ++count;
    });
    return count > 0 ? sum / double(count) : 0;
  }

  /// The same as a matrix, of a regular grid.
  Field_equations::Matrix interpolation(const Sparse_lattice& fine) const
  {
    Field_equations::Matrix result(Eigen::Index(fine.size()), Eigen::Index(m_field.lattice.size()));
    result.reserve(Eigen::VectorXi::Constant(result.rows(), 8));
    for(std::size_t row = 0; row < fine.size(); ++row) {
      const Lattice_point p = fine.point(row);
      const double share = 1. / double(1 << ((p[0] & 1) + (p[1] & 1) + (p[2] & 1)));
      for_each_coarse_node(p, [&](std::size_t node) { result.insert(Eigen::Index(row), Eigen::Index(node)) = share; });
    }
    result.makeCompressed();
    return result;
  }

  /// In units of a spacing h, the smoothness of a field U is the integral of U''^2 / h over space, the other terms are
  /// those of U^2 / h^4 and |grad U - n|^2 / h^2 over the surface, U^2 / h^2 at each sample of the skeleton and U^2
  /// / h^5 over the outside. Their weights are those of the finest level; a level with s times its spacing has the
  /// same energy with weights times s^3, s, s and s^4.
  void solve(const std::vector<char>& is_fixed)
  {
    const double s = m_field.frame.unit / m_spacing;
    Field_equations equations(m_field.lattice, is_fixed, m_field.values);
    equations.add_smoothness(m_parameters.smoothness_weight);
    add_surface(equations, s * s * s * m_parameters.surface_weight,
                s * m_parameters.normal_weight);
    const Points positions = local_sample_positions();
    for(std::size_t i = 0; i < m_samples.size(); ++i)
      if(m_samples[i].is_constraint)
        equations.add_point(s * m_parameters.skeleton_weight, positions[i],
                            -m_samples[i].radius / m_field.frame.unit);
    add_outside(equations, s * s * s * s * m_parameters.outside_weight, positions, is_fixed);
    std::vector<double> values =
      m_parameters.adaptive ? equations.solve() : equations.solve(m_multigrid, std::move(m_interpolation));
    if(values.empty())
      throw std::runtime_error("the equations of the signed distance field cannot be solved");
    m_field.values = std::move(values);
  }

  /// u = 0 at the points, and grad u is the normal: without, the skeleton alone tells inside from outside, and thin
  /// or half seen parts get handles and bulges. Each cell has the same weight, however many points it has: the
  /// result does not depend on the density of the data.
  void add_surface(Field_equations& equations, double value_weight, double normal_weight) const
  {
    std::vector<std::pair<Lattice_point, std::size_t> > cells(m_points.size());
    for(std::size_t i = 0; i < m_points.size(); ++i)
      cells[i] = std::make_pair(cell_of(m_field.frame.to_local(m_points[i])), i);
    std::sort(cells.begin(), cells.end());
    for(std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
      while(end < cells.size() && cells[end].first == cells[begin].first)
        ++end;
      const double share = 1 / double(end - begin);
      for(std::size_t k = begin; k < end; ++k) {
        const Vec3 p = m_field.frame.to_local(m_points[cells[k].second]);
        equations.add_point(share * value_weight, p, 0);
        if(!m_normals.empty())
          equations.add_gradient(share * normal_weight, p, m_normals[cells[k].second]);
      }
    }
  }

  /// u = distance - radius at nodes far from the skeleton.
  void add_outside(Field_equations& equations, double weight, const Points& positions,
                   const std::vector<char>& is_fixed) const
  {
    const Nearest_neighbors tree(positions);
    std::vector<double> distance(m_field.lattice.size(), -1.);
    parallel_for(m_execution, distance.size(), [&](std::size_t i) {
      if(is_fixed[i])
        return;
      const Neighbor nearest = tree.nearest(node_position(i));
      const double d = std::sqrt(nearest.squared_distance);
      const double radius = m_samples[nearest.index].radius / m_field.frame.unit;
      if(radius > 0 && d > m_parameters.outside_factor * radius)
        distance[i] = d - radius;
    });
    for(std::size_t i = 0; i < distance.size(); ++i)
      if(distance[i] > 0)
        equations.add_node(weight, i, distance[i]);
  }

  Execution& m_execution;
  Field_parameters m_parameters;
  const Points& m_points;
  const Points& m_normals;
  std::vector<Sample> m_samples;
  Vec3 m_lower = Vec3::Zero(), m_sides = Vec3::Zero();
  double m_spacing = 1, m_diagonal = 1;
  Distance_field m_field;
  Multigrid m_multigrid;                     ///< of a regular grid
  Field_equations::Matrix m_interpolation;   ///< from its level before
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SIGNED_DISTANCE_FIELD_H
