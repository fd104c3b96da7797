// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_JUDGE_H
#define CONSOLIDATION_BENCHMARK_JUDGE_H

#include "types.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace benchmark {

using support::Point_cloud;
using support::Segment_graph;
using support::Triangle_mesh;
using support::Vec3;

/// Distances at which the distribution is read, in percent of the truth's diagonal.
constexpr std::array<double, 5> distribution_limits = {0.25, 0.5, 1.0, 2.0, 5.0};

/// All distances are in percent of the truth's bounding box diagonal.
struct Distance_statistics {
  std::size_t samples = 0;
  double mean = 0.0;
  double rms = 0.0;
  double percentile_95 = 0.0;
  double max = 0.0;
  std::array<double, 5> share_within = {};  ///< of the samples, at `distribution_limits`
  std::array<double, 20> quantiles = {};    ///< 5 %, 10 %, ... 100 %, to draw the distribution
};

Distance_statistics distance_statistics(std::vector<double> distances);

struct Judge_options {
  std::size_t samples = 40000;  ///< of the truth, and of the result
  std::uint64_t seed = 1;
  double seen_spacings
      = 2.0;  ///< seen: a noise-free scan sample at most so many scan spacings away ...
  double seen_cosine = 0.5;  ///< ... whose normal agrees
};

struct Normal_statistics {
  double mean_error = 0.0;  ///< degrees, of the unoriented normals
  double flipped = 0.0;     ///< share of the samples whose normal points to the wrong side
};

/// Combinatorial facts about a mesh.
struct Topology {
  std::size_t components = 0;
  bool closed = false;  ///< every edge has two facets of opposite orientation
  double genus = 0.0;   ///< sum over the components; from the Euler number, also if not closed
  double volume = 0.0;  ///< signed, meaningful if closed
};

struct Mesh_verdict {
  Distance_statistics forward;       ///< truth to result
  Distance_statistics reverse;       ///< result to truth
  Distance_statistics seen, unseen;  ///< forward, split by what the scan saw; empty without a scan
  double seen_share = 0.0;           ///< of the truth's area
  double fscore_half = 0.0;          ///< at 0.5 percent
  double fscore_one = 0.0;           ///< at 1 percent
  Normal_statistics normals;  ///< at the truth's samples, against the nearest facet of the result
  Topology topology, true_topology;
  double volume_ratio = 0.0;  ///< result to truth
};

struct Point_set_verdict {
  Distance_statistics distance;      ///< points to truth
  Distance_statistics coverage;      ///< truth to the nearest point
  Distance_statistics seen, unseen;  ///< coverage, split by what the scan saw
  double seen_share = 0.0;
  double spacing = 0.0;  ///< mean distance to the nearest other point, percent
  double spacing_variation
      = 0.0;  ///< its standard deviation by its mean: 0.52 for random points, 0 for a lattice
  Normal_statistics normals;  ///< against the nearest facet of the truth
};

struct Skeleton_verdict {
  double inside = 0.0;  ///< share of its length inside of the truth
  Distance_statistics
      to_medial_axis;  ///< samples of the skeleton to the nearest medial ball centre
  double coverage
      = 0.0;  ///< share of the surface whose medial ball the skeleton reaches, see `judge.cpp`
  std::size_t components = 0;
  std::size_t cycles = 0;
  double length = 0.0;  ///< percent
};

/// Compares results with one ground truth mesh, which must be closed and oriented outwards.
class Judge {
public:
  /// `scan`: noise-free samples with normals; they tell the seen part of the truth from the unseen.
  explicit Judge(const Triangle_mesh& truth, const Point_cloud& scan = {},
                 const Judge_options& options = {});
  ~Judge();
  Judge(Judge&&) noexcept;

  Mesh_verdict mesh(const Triangle_mesh& result) const;
  Point_set_verdict points(const Point_cloud& result) const;
  Skeleton_verdict skeleton(const Segment_graph& result) const;

private:
  struct Truth;
  std::unique_ptr<Truth> m_truth;
};

Topology topology_of(const Triangle_mesh& mesh);

/// `count` points spread evenly (in expectation) over the area, with the index of their face.
struct Surface_samples {
  std::vector<Vec3> points;
  std::vector<std::size_t> faces;
};
Surface_samples sample_surface(const Triangle_mesh& mesh, std::size_t count, std::uint64_t seed);

std::string to_json(const Mesh_verdict& verdict);
std::string to_json(const Point_set_verdict& verdict);
std::string to_json(const Skeleton_verdict& verdict);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_JUDGE_H
