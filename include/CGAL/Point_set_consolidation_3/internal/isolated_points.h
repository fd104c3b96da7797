// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ISOLATED_POINTS_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ISOLATED_POINTS_H

#include <CGAL/Point_set_consolidation_3/internal/local_pca.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/parallel_for.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Points of a scan that belong to no surface: far from all others, or sparser than the points around and not on the
/// plane that these follow. Noise and sparse regions are neither. Scans of four models with 2 and 10 % of outliers
/// anywhere in the box, clean to 2 % noise: 99.9 % of those farther than four spacings from the surface are found (98 %
/// at worst), and 0.03 % of the data with them. In scans without outliers it would be 0.2 % at most. Where the noise of
/// views can be removed, what it hid is found afterwards: of outliers in noise of 2 %, seven models, the first search
/// leaves 8 to 21 %, of which the second finds 30 to 44 %, with 0.03 % of the data at most.
class Isolated_points {
  static constexpr std::size_t spacing_neighbors = 6;
  static constexpr std::size_t plane_neighbors = 12;
  /// Spacing of outliers, in median spacings of the scan; 3: 0.8 % of a noisy horse.
  static constexpr double wide = 3.5;
  /// The same in spacings of the points around; 2: five times the mistakes.
  static constexpr double sparse = 2.5;
  /// The same of points on the plane of these; without: pairs of outliers are missed.
  static constexpr double sparsest = 4;
  static constexpr double densest = 0.5;      ///< what the points around count for at least, in median spacings
  static constexpr double flat = 0.15;        ///< distance of points on a surface from their plane, in its extent
  static constexpr double least_share = 0.005;  ///< fewer lie in the sparse parts of any scan,
  static constexpr double far = 12;             ///< but not so far off, in median spacings
  /// More are another scan, noisier or sparser, or single points among copies.
  static constexpr double most_share = 0.25;
  static constexpr std::size_t least_points = 100;

public:
  Isolated_points(const Execution& execution, const Points& points) : m_execution(execution), m_points(points) {}

  /// A flag per point. `are_known`: others were found before, so that few are not those of any scan.
  std::vector<char> run(bool are_known = false) const
  {
    const std::size_t n = m_points.size();
    std::vector<char> is_outlier(n, 0);
    if(n < least_points)
      return is_outlier;
    const Pass first(m_execution, m_points, 0);
    const std::vector<Index> found = first.find();
    if(double(found.size()) > most_share * double(n))
      return is_outlier;
    if(!are_known && double(found.size()) < least_share * double(n)) {
      for(const Index i : found)
        is_outlier[i] = first.spacing[i] > far * first.scale;
      return is_outlier;
    }
    for(const Index i : found)
      is_outlier[i] = 1;
    // those that were found had hidden others
    std::vector<Index> kept = all_indices(n);
    kept.erase(std::remove_if(kept.begin(), kept.end(), [&](Index i) { return is_outlier[i] != 0; }), kept.end());
    const Points rest = selected(m_points, kept);
    const Pass second(m_execution, rest, first.scale);
    for(const Index k : second.find())
      is_outlier[kept[k]] = 1;
    return is_outlier;
  }

private:
  struct Pass {
    /// `scale_`: 0 if it is not known yet.
    Pass(const Execution& execution_, const Points& points_, double scale_)
      : execution(execution_), points(points_), tree(execution_, points_)
      , spacing(neighbor_distances(execution_, tree, points_, spacing_neighbors))
      , scale(scale_ > 0 ? scale_ : median(spacing))
    {}

    std::vector<Index> find() const
    {
      std::vector<Index> candidates;
      for(std::size_t i = 0; i < points.size(); ++i)
        if(spacing[i] > (std::min)(wide, sparse * densest) * scale)
          candidates.push_back(Index(i));
      std::vector<char> is_isolated(candidates.size(), 0);
      parallel_for(execution, candidates.size(), [&](std::size_t k) { is_isolated[k] = isolated(candidates[k]); });
      std::vector<Index> found;
      for(std::size_t k = 0; k < candidates.size(); ++k)
        if(is_isolated[k])
          found.push_back(candidates[k]);
      return found;
    }

    bool isolated(std::size_t i) const
    {
      std::vector<Neighbor> neighbors;
      tree.find(points[i], plane_neighbors + 1, neighbors);
      std::vector<double> around;
      Covariance_sum sum;
      for(const Neighbor& neighbor : neighbors) {
        if(neighbor.index == i)
          continue;
        around.push_back(spacing[neighbor.index]);
        sum.add(points[neighbor.index] - points[i]);
      }
      const double spacing_around = median(std::move(around));
      const double sparsity = spacing[i] / (std::max)(spacing_around, densest * scale);
      if(spacing[i] <= wide * scale && sparsity <= sparse)
        return false;
      if(sparsity > sparsest)
        return true;
      const auto axes = sum.axes();
      const double off_plane = std::sqrt((std::max)(0., axes.eigenvalues()[0]));
      const double extent = std::sqrt((std::max)(0., axes.eigenvalues().sum()));
      const double distance = std::abs(axes.eigenvectors().col(0).dot(sum.mean()));
      return off_plane > flat * extent || distance > 2 * off_plane + 0.5 * spacing_around;
    }

    const Execution& execution;
    const Points& points;
    Nearest_neighbors tree;
    std::vector<double> spacing;
    double scale;               ///< the median spacing of the scan
  };

  const Execution& m_execution;
  const Points& m_points;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_ISOLATED_POINTS_H
