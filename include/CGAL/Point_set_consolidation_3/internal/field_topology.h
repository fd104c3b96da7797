// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_TOPOLOGY_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_TOPOLOGY_H

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Point_set_consolidation_3/internal/marching_tetrahedra.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Beyond the papers: a surface from data and a skeleton has the topology of the skeleton only if data and skeleton
/// agree everywhere. Where they do not, near parts touch (false handles) and thin parts have holes (false tunnels).
/// In: a field, and the number of handles that its surface may have. Out: the field, changed at few nodes so
/// that the weakest handles are cut, or their tunnels filled, whichever changes the field less.
///
/// The lattice with the tetrahedra of `Marching_tetrahedra` is a simplicial complex. A node changes sides without
/// a change of topology if its neighbours on either side are one connected part of its link. So a region that starts
/// with the deepest node and takes such nodes, the deepest first, ends as a ball: what is left of the inside are the
/// cuts that open its handles. Likewise, the outside leaves the membranes that close its tunnels.

/// The 14 nodes that share a tetrahedron with a node.
class Tetrahedral_link {
public:
  static constexpr std::size_t size = 14;

  Tetrahedral_link()
  {
    std::size_t k = 0;
    for(const std::int64_t sign : {-1, 1})
      for(std::int64_t code = 1; code < 8; ++code)
        m_offsets[k++] = {sign * (code & 1), sign * (code >> 1 & 1), sign * (code >> 2)};
    for(std::size_t a = 0; a < size; ++a)
      for(std::size_t b = 0; b < size; ++b) {
        bool is_up = a != b, is_down = a != b;
        for(std::size_t axis = 0; axis < 3; ++axis) {
          const std::int64_t d = m_offsets[b][axis] - m_offsets[a][axis];
          is_up = is_up && (d == 0 || d == 1);
          is_down = is_down && (d == 0 || d == -1);
        }
        if(is_up || is_down)
          m_adjacent[a] |= 1u << b;
      }
  }

  const std::array<Lattice_point, size>& offsets() const { return m_offsets; }

  /// Whether a node with these neighbours on one side can change sides without a change of topology.
  bool is_simple(unsigned side) const
  {
    constexpr unsigned all = (1u << size) - 1;
    return is_connected(side) && is_connected(all & ~side);
  }

private:
  bool is_connected(unsigned nodes) const
  {
    if(nodes == 0)
      return false;
    unsigned reached = nodes & ~(nodes - 1), fresh = reached;
    while(fresh != 0) {
      unsigned next = 0;
      for(std::size_t k = 0; k < size; ++k)
        if(fresh >> k & 1)
          next |= m_adjacent[k];
      fresh = next & nodes & ~reached;
      reached |= fresh;
    }
    return reached == nodes;
  }

  std::array<Lattice_point, size> m_offsets = {};
  std::array<unsigned, size> m_adjacent = {};
};

/// Genus of a closed surface, the sum over its components.
inline double genus_of(const Surface_triangles& surface)
{
  Disjoint_sets sets(surface.vertices.size());
  for(const auto& t : surface.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  double components = 0;
  for(std::size_t v = 0; v < surface.vertices.size(); ++v)
    components += sets.find(v) == v;
  // every edge of a closed surface has two triangles
  return components - 0.5 * (double(surface.vertices.size()) - 0.5 * double(surface.triangles.size()));
}

class Handle_removal {
  static constexpr double replaced = 0.5;   ///< value of changed nodes, in cells
  static constexpr double unresolved = 0.25;///< depth in cells that the lattice does not resolve
  static constexpr std::int64_t margin = 2; ///< of the box around the inside

public:
  /// `most`: handles stay whose bridges and tunnels are both deeper than this, in cells.
  Handle_removal(const Sparse_lattice& lattice, std::vector<double>& values, double most)
    : m_lattice(lattice), m_values(values), m_most(most)
  {}

  /// Leaves at least as many handles as are wanted, but none that the lattice does not resolve. `genus()` is that of
  /// the surface that counts; it is called after each change.
  template <typename Genus>
  void run(double wanted, const Genus& genus)
  {
    double present = genus();
    if(!(present > 0) || !make_box())
      return;
    std::vector<Change> changes = remains(-1);
    const std::vector<Change> fillings = remains(1);
    changes.insert(changes.end(), fillings.begin(), fillings.end());
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.strength < b.strength; });
    for(const Change& change : changes) {
      const double least = change.strength < unresolved ? 0 : wanted;
      if(present <= least || change.strength > m_most)
        return;
      std::vector<double> before;
      for(const std::size_t i : change.nodes) {
        before.push_back(m_values[i]);
        m_values[i] = -change.side * replaced;
      }
      const double changed = genus();
      if(changed < present && changed >= least)
        present = changed;
      else
        for(std::size_t k = 0; k < before.size(); ++k)
          m_values[change.nodes[k]] = before[k];
    }
  }

private:
  /// Nodes of one side that would not join the ball of that side.
  struct Change {
    std::vector<std::size_t> nodes;  ///< of the lattice
    double side = 0;                 ///< -1: they are inside
    double strength = 0;             ///< largest absolute value among them
  };

  std::size_t place(const Lattice_point& p) const
  {
    return std::size_t((p[2] * m_sides[1] + p[1]) * m_sides[0] + p[0]);
  }
  Lattice_point point(std::size_t i) const
  {
    const std::int64_t k = std::int64_t(i);
    return {k % m_sides[0], k / m_sides[0] % m_sides[1], k / m_sides[0] / m_sides[1]};
  }
  bool contains(const Lattice_point& p) const
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(p[axis] < 0 || p[axis] >= m_sides[axis])
        return false;
    return true;
  }
  template <typename Function>
  void for_each_neighbor(std::size_t i, const Function& f) const
  {
    const Lattice_point p = point(i);
    for(std::size_t k = 0; k < Tetrahedral_link::size; ++k) {
      const Lattice_point& d = m_link.offsets()[k];
      const Lattice_point q = {p[0] + d[0], p[1] + d[1], p[2] + d[2]};
      if(contains(q))
        f(k, place(q));
    }
  }

  /// The whole box around the inside, with values also where the lattice has no nodes: deep inside, far outside.
  bool make_box()
  {
    Lattice_point upper = {-1, -1, -1};
    m_lower = m_lattice.dimensions();
    for(std::size_t i = 0; i < m_lattice.size(); ++i)
      if(m_values[i] < 0)
        for(std::size_t axis = 0; axis < 3; ++axis) {
          m_lower[axis] = (std::min)(m_lower[axis], m_lattice.point(i)[axis]);
          upper[axis] = (std::max)(upper[axis], m_lattice.point(i)[axis]);
        }
    if(upper[0] < 0)
      return false;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      m_lower[axis] -= margin;
      m_sides[axis] = upper[axis] + margin - m_lower[axis] + 1;
    }
    constexpr float unknown = (std::numeric_limits<float>::max)();
    m_box.assign(std::size_t(m_sides[0]) * std::size_t(m_sides[1]) * std::size_t(m_sides[2]), unknown);
    for(std::size_t i = 0; i < m_lattice.size(); ++i) {
      const Lattice_point p = m_lattice.point(i);
      const Lattice_point q = {p[0] - m_lower[0], p[1] - m_lower[1], p[2] - m_lower[2]};
      if(contains(q))
        m_box[place(q)] = float(m_values[i]);
    }
    // a node without a value takes over its neighbour's, and is a little deeper on the same side
    constexpr float deeper = 1.01f;
    std::vector<std::size_t> front;
    for(std::size_t i = 0; i < m_box.size(); ++i)
      if(m_box[i] != unknown)
        front.push_back(i);
    for(std::size_t k = 0; k < front.size(); ++k)
      for_each_neighbor(front[k], [&](std::size_t, std::size_t j) {
        if(m_box[j] == unknown) {
          m_box[j] = deeper * m_box[front[k]];
          front.push_back(j);
        }
      });
    return true;
  }

  /// What is left of a side (-1: inside, 1: outside) when its ball cannot grow any more, by connected parts.
  std::vector<Change> remains(double side) const
  {
    using Entry = std::pair<float, std::size_t>;  // the deepest node of the side comes first
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto depth = [&](std::size_t i) { return side < 0 ? m_box[i] : -m_box[i]; };
    const auto is_on_side = [&](std::size_t i) { return (m_box[i] < 0) == (side < 0); };
    std::vector<char> taken(m_box.size(), 0);
    std::size_t deepest = 0;
    for(std::size_t i = 1; i < m_box.size(); ++i)
      if(depth(i) < depth(deepest))
        deepest = i;
    const auto take = [&](std::size_t i) {
      taken[i] = 1;
      for_each_neighbor(i, [&](std::size_t, std::size_t j) {
        if(!taken[j] && is_on_side(j))
          queue.emplace(depth(j), j);
      });
    };
    if(side > 0)
      take_border(taken, take);
    else
      take(deepest);
    while(!queue.empty()) {
      const std::size_t i = queue.top().second;
      queue.pop();
      if(taken[i])
        continue;
      unsigned neighbors = 0;
      for_each_neighbor(i, [&](std::size_t k, std::size_t j) { neighbors |= unsigned(taken[j]) << k; });
      if(m_link.is_simple(neighbors))
        take(i);
    }

    std::vector<Change> result;
    for(std::size_t seed = 0; seed < m_box.size(); ++seed) {
      if(taken[seed] || !is_on_side(seed))
        continue;
      Change change;
      change.side = side;
      std::vector<std::size_t> part(1, seed);
      taken[seed] = 1;
      for(std::size_t k = 0; k < part.size(); ++k) {
        const Lattice_point p = point(part[k]);
        const std::size_t node =
          m_lattice.find(p[0] + m_lower[0], p[1] + m_lower[1], p[2] + m_lower[2]);
        change.strength = (std::max)(change.strength, std::abs(double(m_box[part[k]])));
        if(node != Sparse_lattice::none)
          change.nodes.push_back(node);
        for_each_neighbor(part[k], [&](std::size_t, std::size_t j) {
          if(!taken[j] && is_on_side(j)) {
            taken[j] = 1;
            part.push_back(j);
          }
        });
      }
      result.push_back(std::move(change));
    }
    return result;
  }

  /// The outside begins with the border of the box, around which everything else is one more node.
  template <typename Take>
  void take_border(std::vector<char>& taken, const Take& take) const
  {
    std::vector<std::size_t> border;
    for(std::size_t i = 0; i < m_box.size(); ++i) {
      const Lattice_point p = point(i);
      for(std::size_t axis = 0; axis < 3; ++axis)
        if((p[axis] == 0 || p[axis] == m_sides[axis] - 1) && !taken[i]) {
          taken[i] = 1;
          border.push_back(i);
        }
    }
    for(const std::size_t i : border)
      take(i);
  }

  const Sparse_lattice& m_lattice;
  std::vector<double>& m_values;
  double m_most;
  Tetrahedral_link m_link;
  Lattice_point m_lower = {0, 0, 0}, m_sides = {0, 0, 0};
  std::vector<float> m_box;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_FIELD_TOPOLOGY_H
