// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_tree.h"

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <tuple>

namespace benchmark {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Indexed = std::pair<Point_3, std::size_t>;
using Traits = CGAL::Search_traits_adapter<Indexed, CGAL::First_of_pair_property_map<Indexed>,
                                           CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

}  // namespace

struct Point_tree::Tree {
  Search::Tree tree;
};

Point_tree::Point_tree(const std::vector<Vec3>& points) : m_tree(std::make_unique<Tree>())
{
  for(std::size_t i = 0; i < points.size(); ++i) {
    m_tree->tree.insert(Indexed(Point_3(points[i].x(), points[i].y(), points[i].z()), i));
  }
  m_tree->tree.build();
}

Point_tree::~Point_tree() = default;
Point_tree::Point_tree(Point_tree&&) noexcept = default;

std::vector<Neighbour> Point_tree::nearest(const Vec3& query, std::size_t k) const
{
  const Search search(m_tree->tree, Point_3(query.x(), query.y(), query.z()),
                      static_cast<unsigned int>(k));
  std::vector<Neighbour> result;
  result.reserve(k);
  for(const auto& found : search)
    result.push_back({found.first.second, std::sqrt(found.second)});
  return result;
}

double average_spacing(const std::vector<Vec3>& points, std::size_t k)
{
  if(points.size() < 2)
    return 0.0;
  const Point_tree tree(points);
  double sum = 0.0;
  std::size_t count = 0;
  for(const Vec3& p : points) {
    const std::vector<Neighbour> found = tree.nearest(p, k + 1);
    // the first one is the point itself
    for(std::size_t i = 1; i < found.size(); ++i) {
      sum += found[i].distance;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

}  // namespace benchmark
