// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DIPOLE_ORIENTATION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DIPOLE_ORIENTATION_H

#include <CGAL/Point_set_consolidation_3/internal/orientation.h>
#include <CGAL/Point_set_consolidation_3/internal/sampling.h>

#include <queue>
#include <tuple>
#include <unordered_map>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Which side of each normal is the outer one, where nothing tells. Oriented surface elements are dipoles; those of a
/// closed surface, and of smooth sheets, agree the most (Metzer et al., Orienting point clouds with dipole
/// propagation, 2021): two elements in direction d of each other by n . n' - 3 (n . d)(n' . d), on a common
/// sheet as well as on opposite sides of a thin part. Signs are found by greedy additive contraction: the two groups
/// that agree or disagree the most are joined, what they think of others is added up, and so on. A spanning tree takes
/// one pair's word for a whole part.
class Dipole_orientation {
  struct Join {
    double strength;
    Index a, b;
    bool operator<(const Join& other) const  // the queue's top is the strongest
    {
      return std::tie(strength, other.a, other.b) < std::tie(other.strength, a, b);
    }
  };
  struct Member {
    Index group;
    bool is_flipped;  ///< against the group
  };

public:
  /// `nearest`: the pairs that are compared.
  Dipole_orientation(const Points& points, Points& normals, const Nearest_table& nearest)
    : m_points(points), m_normals(normals)
    , m_agreement(points.size()), m_parent(points.size())
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      m_parent[i] = {Index(i), false};
    compare(nearest);
  }

  /// Each component of the pairs is oriented outwards.
  void run()
  {
    while(!m_queue.empty()) {
      const Join join = m_queue.top();
      m_queue.pop();
      const auto current = m_agreement[join.a].find(join.b);
      if(current != m_agreement[join.a].end() && std::abs(current->second) == join.strength)
        contract(join.a, join.b);
    }
    std::vector<std::vector<std::size_t> > components(m_points.size());
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      const Member member = find(Index(i));
      if(member.is_flipped)
        m_normals[i] = -m_normals[i];
      components[member.group].push_back(i);
    }
    for(const std::vector<std::size_t>& component : components)
      if(!component.empty())
        orient_component_outwards(m_points, m_normals, component);
  }

private:
  /// Mean distance to the nearest six, and the layer of noise they lie in: of most points a third of their neighbours
  /// is nearer to the tangent plane. (All would be too many: opposite sides of thin parts are no noise.)
  void measure(const Nearest_table& nearest, std::vector<double>& spacing, double& noise) const
  {
    const std::size_t count = (std::min)(std::size_t(6), nearest.k), third = count / 3;
    spacing.assign(m_points.size(), 0);
    std::vector<double> heights(count), shares;
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      for(std::size_t k = 0; k < count; ++k) {
        const Vec3 d = m_points[nearest.row(i)[k]] - m_points[i];
        spacing[i] += d.norm() / double(count);
        heights[k] = std::abs(m_normals[i].dot(d));
      }
      if(!(spacing[i] > 0))
        continue;
      std::nth_element(heights.begin(), heights.begin() + std::ptrdiff_t(third), heights.end());
      shares.push_back(heights[third] / spacing[i]);
    }
    noise = shares.empty() ? 0 : median(std::move(shares));
  }

  void compare(const Nearest_table& nearest)
  {
    constexpr double layer = 9;  // of 4, 6, 9 and 13 the best for 0 to 1 % of noise; more and thin plates get lost
    std::vector<double> spacing;
    double noise = 0;
    measure(nearest, spacing, noise);
    const double thickness = layer * noise;  // elements of a layer of noise are no opposite sides
    for(std::size_t i = 0; i < m_points.size(); ++i)
      for(std::size_t k = 0; k < nearest.k; ++k) {
        const Index j = nearest.row(i)[k];
        const Vec3 d = m_points[j] - m_points[i];
        const double squared_distance = d.squaredNorm();
        if(!(squared_distance > 0) || m_agreement[i].count(j) > 0)
          continue;
        const Vec3 &a = m_normals[i], &b = m_normals[j];
        const double unit = spacing[i] * spacing[j];
        const double dipoles =
          a.dot(b) - 3 * a.dot(d) * b.dot(d) / (squared_distance + thickness * thickness * unit);
        set_agreement(Index(i), j, dipoles / (squared_distance / unit + 1));
      }
  }

  void set_agreement(Index a, Index b, double value)
  {
    m_agreement[a][b] = m_agreement[b][a] = value;
    m_queue.push({std::abs(value), (std::min)(a, b), (std::max)(a, b)});
  }

  /// The group that knows fewer others joins the other one.
  void contract(Index a, Index b)
  {
    if(m_agreement[a].size() < m_agreement[b].size())
      std::swap(a, b);
    const bool is_flipped = m_agreement[a][b] < 0;
    m_parent[b] = {a, is_flipped};
    m_agreement[a].erase(b);
    const std::unordered_map<Index, double> others = std::move(m_agreement[b]);
    for(const auto& [c, value] : others) {
      if(c == a)
        continue;
      m_agreement[c].erase(b);
      const auto known = m_agreement[a].find(c);
      set_agreement(a, c, (known == m_agreement[a].end() ? 0 : known->second) + (is_flipped ? -value : value));
    }
    m_agreement[b].clear();
  }

  Member find(Index i)
  {
    Member member = {i, false};
    while(m_parent[member.group].group != member.group) {
      member.is_flipped ^= m_parent[member.group].is_flipped;
      member.group = m_parent[member.group].group;
    }
    m_parent[i] = member.group == i ? m_parent[i] : member;
    return member;
  }

  const Points& m_points;
  Points& m_normals;
  std::vector<std::unordered_map<Index, double> > m_agreement;  ///< of groups
  std::vector<Member> m_parent;
  std::priority_queue<Join> m_queue;
};

/// Orients normals towards the outside of the shape. O(n log n); large sets follow a part of them, which bounds the
/// memory (130 MB were measured).
inline void orient_by_dipoles(const Execution& execution, const Points& points, Points& normals)
{
  constexpr std::size_t neighbors = 30;  // up to the other side of thin parts
  constexpr std::size_t most_points = 50000;
  if(points.size() <= most_points) {
    Dipole_orientation(points, normals, nearest_table(execution, points, neighbors)).run();
    return;
  }
  const std::vector<std::size_t> chosen = random_subset(points.size(), most_points, 0);
  const Points part = selected(points, chosen);
  Points part_normals = selected(normals, chosen);
  orient_by_dipoles(execution, part, part_normals);
  orient_by_hints(execution, points, normals, part, part_normals);
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_DIPOLE_ORIENTATION_H
