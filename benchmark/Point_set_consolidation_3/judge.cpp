// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "judge.h"

#include "mesh_tree.h"
#include "point_tree.h"
#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace benchmark {

namespace {

using CGAL::Point_set_consolidation_3::internal::Disjoint_sets;

/// Scan samples looked at for each sample of the truth: more than lie within two spacings on one sheet.
constexpr std::size_t seen_candidates = 24;

/// Shrinking balls (Ma, Bae, Choi 2012) stop when the two touching points are seen from the centre under less
/// than this angle: such a ball hangs on neighbouring facets, not on the opposite side of the shape.
constexpr double separation_angle = 60.0;

/// Surface samples from which medial balls are shrunk.
constexpr std::size_t medial_samples = 6000;

/// A ball is done when it sticks out of the surface by less than this share of its radius.
constexpr double shrinking_tolerance = 1e-3;
constexpr int shrinking_iterations = 50;

/// Rays through the shape start so far inside, as a share of the diagonal, not to hit the facet they start from.
constexpr double ray_start = 1e-6;

/// A surface sample counts as covered if the skeleton comes within this many radii of its medial ball (it is
/// one radius away from the centre of it) ...
constexpr double coverage_radii = 1.5;
/// ... plus this, in percent of the diagonal, for thin parts.
constexpr double coverage_slack = 1.0;

/// Distance of samples along a skeleton, in percent of the diagonal.
constexpr double skeleton_step = 0.25;

double degrees(double cosine)
{
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / EIGEN_PI;
}

Normal_statistics normal_statistics(const std::vector<double>& cosines)
{
  Normal_statistics result;
  if(cosines.empty())
    return result;
  for(double cosine : cosines) {
    result.mean_error += degrees(std::abs(cosine));
    result.flipped += cosine < 0.0;
  }
  result.mean_error /= static_cast<double>(cosines.size());
  result.flipped /= static_cast<double>(cosines.size());
  return result;
}

double fscore(const Distance_statistics& forward, const Distance_statistics& reverse,
              std::size_t limit)
{
  const double sum = forward.share_within[limit] + reverse.share_within[limit];
  return sum > 0.0 ? 2.0 * forward.share_within[limit] * reverse.share_within[limit] / sum : 0.0;
}

struct Medial_balls {
  std::vector<Vec3> points;   ///< surface samples
  std::vector<double> radii;  ///< of the balls that touch there
  std::vector<Vec3> centres;  ///< of the balls that touch two well separated points
};

/// The largest ball inside of the surface that touches it at each sample, found by shrinking.
Medial_balls shrink_balls(const Mesh_tree& surface, const std::vector<Vec3>& points,
                          const std::vector<Vec3>& normals, double diagonal)
{
  Medial_balls balls;
  balls.points = points;
  for(std::size_t i = 0; i < points.size(); ++i) {
    // straight through the shape: the ball is at most half as wide as the shape there
    const Vec3 start = points[i] - ray_start * diagonal * normals[i];
    const std::optional<Mesh_hit> opposite = surface.first_hit({start, -normals[i]});
    double radius = opposite ? 0.5 * (opposite->point - points[i]).norm() : diagonal;
    bool separated = opposite.has_value();
    for(int iteration = 0; iteration < shrinking_iterations; ++iteration) {
      const Vec3 centre = points[i] - radius * normals[i];
      const Vec3 other = surface.closest(centre).point;
      if((other - centre).norm() >= radius * (1.0 - shrinking_tolerance))
        break;
      const Vec3 chord = points[i] - other;
      const double height = chord.dot(normals[i]);
      if(height <= 0.0)
        break;
      const double smaller = chord.squaredNorm() / (2.0 * height);
      const Vec3 smaller_centre = points[i] - smaller * normals[i];
      if(degrees(normals[i].dot((other - smaller_centre).normalized())) < separation_angle)
        break;
      radius = smaller;
      separated = true;
    }
    balls.radii.push_back(radius);
    if(separated)
      balls.centres.push_back(points[i] - radius * normals[i]);
  }
  return balls;
}

}  // namespace

Distance_statistics distance_statistics(std::vector<double> distances)
{
  Distance_statistics result;
  result.samples = distances.size();
  if(distances.empty())
    return result;
  std::sort(distances.begin(), distances.end());
  const auto count = static_cast<double>(distances.size());
  double square_sum = 0.0;
  for(double d : distances) {
    result.mean += d;
    square_sum += d * d;
  }
  result.mean /= count;
  result.rms = std::sqrt(square_sum / count);
  for(std::size_t i = 0; i < result.quantiles.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(result.quantiles.size());
    result.quantiles[i] = distances[static_cast<std::size_t>(share * (count - 1.0))];
  }
  result.percentile_95 = distances[static_cast<std::size_t>(0.95 * (count - 1.0))];
  result.max = distances.back();
  for(std::size_t i = 0; i < distribution_limits.size(); ++i) {
    const auto end = std::upper_bound(distances.begin(), distances.end(), distribution_limits[i]);
    result.share_within[i] = static_cast<double>(end - distances.begin()) / count;
  }
  return result;
}

Topology topology_of(const Triangle_mesh& mesh)
{
  Topology result;
  // per undirected edge: facets that run from the lower to the higher vertex, and the other way
  std::map<std::pair<std::size_t, std::size_t>, std::array<int, 2>> edges;
  Disjoint_sets components(mesh.vertices.size());
  std::vector<bool> used(mesh.vertices.size(), false);
  for(const auto& face : mesh.faces) {
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = face[k];
      const std::size_t b = face[(k + 1) % 3];
      ++edges[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
      components.join(a, b);
      used[a] = true;
    }
    result.volume
        += mesh.vertices[face[0]].dot(mesh.vertices[face[1]].cross(mesh.vertices[face[2]])) / 6.0;
  }
  result.closed
      = !mesh.faces.empty() && std::all_of(edges.begin(), edges.end(), [](const auto& edge) {
          return edge.second[0] == 1 && edge.second[1] == 1;
        });
  std::size_t vertices = 0;
  for(std::size_t v = 0; v < used.size(); ++v) {
    if(!used[v])
      continue;
    ++vertices;
    if(components.find(v) == v)
      ++result.components;
  }
  const double euler = static_cast<double>(vertices) - static_cast<double>(edges.size())
                       + static_cast<double>(mesh.faces.size());
  result.genus = static_cast<double>(result.components) - 0.5 * euler;
  return result;
}

Surface_samples sample_surface(const Triangle_mesh& mesh, std::size_t count, std::uint64_t seed)
{
  Surface_samples samples;
  std::vector<double> area_up_to;
  double area = 0.0;
  for(const auto& face : mesh.faces) {
    const Vec3& a = mesh.vertices[face[0]];
    area += 0.5 * (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).norm();
    area_up_to.push_back(area);
  }
  if(!(area > 0.0))
    return samples;
  Random_numbers random(seed);
  std::size_t face = 0;
  for(std::size_t i = 0; i < count; ++i) {
    // one sample in each of `count` equal slices of the area
    const double position
        = (static_cast<double>(i) + random.uniform()) / static_cast<double>(count) * area;
    while(face + 1 < area_up_to.size() && area_up_to[face] <= position)
      ++face;
    const double root = std::sqrt(random.uniform());
    const double v = random.uniform();
    const auto& corners = mesh.faces[face];
    samples.points.push_back((1.0 - root) * mesh.vertices[corners[0]]
                             + root * (1.0 - v) * mesh.vertices[corners[1]]
                             + root * v * mesh.vertices[corners[2]]);
    samples.faces.push_back(face);
  }
  return samples;
}

struct Judge::Truth {
  Triangle_mesh mesh;
  Judge_options options;
  double diagonal = 0.0;
  Mesh_tree tree;
  Topology topology;
  std::vector<Vec3> points;   ///< samples
  std::vector<Vec3> normals;  ///< at the samples
  std::vector<bool> seen;     ///< empty without a scan

  Truth(const Triangle_mesh& truth, const Judge_options& opts)
    : mesh(truth), options(opts), tree(truth), topology(topology_of(truth))
  {
    Eigen::AlignedBox3d box;
    for(const Vec3& p : mesh.vertices)
      box.extend(p);
    diagonal = box.diagonal().norm();
    const Surface_samples samples = sample_surface(mesh, options.samples, options.seed);
    points = samples.points;
    for(std::size_t face : samples.faces)
      normals.push_back(face_normal(mesh, face));
  }

  double percent(double length) const { return 100.0 * length / diagonal; }

  /// Made when the first skeleton is judged.
  const Medial_balls& medial_balls()
  {
    if(!m_balls) {
      const std::size_t stride = std::max<std::size_t>(1, points.size() / medial_samples);
      std::vector<Vec3> some_points, some_normals;
      for(std::size_t i = 0; i < points.size(); i += stride) {
        some_points.push_back(points[i]);
        some_normals.push_back(normals[i]);
      }
      m_balls = shrink_balls(tree, some_points, some_normals, diagonal);
    }
    return *m_balls;
  }

  void mark_seen(const Point_cloud& scan)
  {
    if(scan.points.empty())
      return;
    const double reach = options.seen_spacings * average_spacing(scan.points);
    const Point_tree scan_tree(scan.points);
    for(std::size_t i = 0; i < points.size(); ++i) {
      const std::vector<Neighbour> found = scan_tree.nearest(points[i], seen_candidates);
      seen.push_back(std::any_of(found.begin(), found.end(), [&](const Neighbour& sample) {
        return sample.distance <= reach
               && (scan.normals.empty()
                   || scan.normals[sample.index].dot(normals[i]) >= options.seen_cosine);
      }));
    }
  }

  double seen_share() const
  {
    return seen.empty() ? 0.0
                        : static_cast<double>(std::count(seen.begin(), seen.end(), true))
                              / static_cast<double>(seen.size());
  }

  /// The statistics of the samples that were seen, or of those that were not.
  Distance_statistics part(const std::vector<double>& distances, bool of_seen) const
  {
    std::vector<double> chosen;
    for(std::size_t i = 0; i < seen.size(); ++i) {
      if(seen[i] == of_seen)
        chosen.push_back(distances[i]);
    }
    return distance_statistics(std::move(chosen));
  }

private:
  std::optional<Medial_balls> m_balls;
};

Judge::Judge(const Triangle_mesh& truth, const Point_cloud& scan, const Judge_options& options)
  : m_truth(std::make_unique<Truth>(truth, options))
{
  m_truth->mark_seen(scan);
}

Judge::~Judge() = default;
Judge::Judge(Judge&&) noexcept = default;

Mesh_verdict Judge::mesh(const Triangle_mesh& result) const
{
  const Truth& truth = *m_truth;
  const Mesh_tree tree(result);
  Mesh_verdict verdict;

  std::vector<double> forward, cosines;
  for(std::size_t i = 0; i < truth.points.size(); ++i) {
    const Mesh_hit nearest = tree.closest(truth.points[i]);
    forward.push_back(truth.percent((nearest.point - truth.points[i]).norm()));
    cosines.push_back(nearest.normal.dot(truth.normals[i]));
  }
  std::vector<double> reverse;
  for(const Vec3& p :
      sample_surface(result, truth.options.samples, truth.options.seed + 1).points) {
    reverse.push_back(truth.percent((truth.tree.closest(p).point - p).norm()));
  }
  verdict.seen = truth.part(forward, true);
  verdict.unseen = truth.part(forward, false);
  verdict.seen_share = truth.seen_share();
  verdict.forward = distance_statistics(std::move(forward));
  verdict.reverse = distance_statistics(std::move(reverse));
  verdict.fscore_half = fscore(verdict.forward, verdict.reverse, 1);
  verdict.fscore_one = fscore(verdict.forward, verdict.reverse, 2);
  verdict.normals = normal_statistics(cosines);
  verdict.topology = topology_of(result);
  verdict.true_topology = truth.topology;
  verdict.volume_ratio = verdict.topology.volume / truth.topology.volume;
  return verdict;
}

Point_set_verdict Judge::points(const Point_cloud& result) const
{
  const Truth& truth = *m_truth;
  Point_set_verdict verdict;
  if(result.points.empty())
    throw support::Method_error("judge: empty point set");

  std::vector<double> distances, cosines;
  for(std::size_t i = 0; i < result.points.size(); ++i) {
    const Mesh_hit nearest = truth.tree.closest(result.points[i]);
    distances.push_back(truth.percent((nearest.point - result.points[i]).norm()));
    if(!result.normals.empty())
      cosines.push_back(nearest.normal.dot(result.normals[i].normalized()));
  }
  verdict.distance = distance_statistics(std::move(distances));
  verdict.normals = normal_statistics(cosines);

  const Point_tree tree(result.points);
  std::vector<double> coverage;
  for(const Vec3& p : truth.points)
    coverage.push_back(truth.percent(tree.nearest(p).distance));
  verdict.seen = truth.part(coverage, true);
  verdict.unseen = truth.part(coverage, false);
  verdict.seen_share = truth.seen_share();
  verdict.coverage = distance_statistics(std::move(coverage));

  if(result.points.size() > 1) {
    double sum = 0.0;
    double square_sum = 0.0;
    for(const Vec3& p : result.points) {
      const double spacing = truth.percent(tree.nearest(p, 2)[1].distance);
      sum += spacing;
      square_sum += spacing * spacing;
    }
    const auto count = static_cast<double>(result.points.size());
    verdict.spacing = sum / count;
    const double variance = std::max(0.0, square_sum / count - verdict.spacing * verdict.spacing);
    verdict.spacing_variation = verdict.spacing > 0.0 ? std::sqrt(variance) / verdict.spacing : 0.0;
  }
  return verdict;
}

Skeleton_verdict Judge::skeleton(const Segment_graph& result) const
{
  const Truth& truth = *m_truth;
  Skeleton_verdict verdict;
  if(result.vertices.empty())
    throw support::Method_error("judge: empty skeleton");

  // components and cycles of the graph
  Disjoint_sets components(result.vertices.size());
  for(const auto& edge : result.edges)
    components.join(edge[0], edge[1]);
  for(std::size_t v = 0; v < result.vertices.size(); ++v)
    verdict.components += components.find(v) == v;
  verdict.cycles = result.edges.size() + verdict.components - result.vertices.size();

  // samples every `skeleton_step` along the edges; a graph without edges is judged by its vertices
  std::vector<Vec3> samples;
  for(const auto& edge : result.edges) {
    const Vec3& a = result.vertices[edge[0]];
    const Vec3& b = result.vertices[edge[1]];
    const double length = truth.percent((b - a).norm());
    verdict.length += length;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / skeleton_step)));
    for(int k = 0; k < steps; ++k)
      samples.push_back(a + (b - a) * (k + 0.5) / steps);
  }
  if(samples.empty())
    samples = result.vertices;

  const Medial_balls& balls = m_truth->medial_balls();
  std::vector<double> distances;
  std::size_t inside = 0;
  const std::optional<Point_tree> centres
      = balls.centres.empty() ? std::nullopt : std::optional<Point_tree>(Point_tree(balls.centres));
  for(const Vec3& p : samples) {
    inside += truth.tree.is_inside(p);
    if(centres)
      distances.push_back(truth.percent(centres->nearest(p).distance));
  }
  verdict.inside = static_cast<double>(inside) / static_cast<double>(samples.size());
  verdict.to_medial_axis = distance_statistics(std::move(distances));

  const Point_tree skeleton_tree(samples);
  std::size_t covered = 0;
  for(std::size_t i = 0; i < balls.points.size(); ++i) {
    const double reach = coverage_radii * balls.radii[i] + coverage_slack / 100.0 * truth.diagonal;
    covered += skeleton_tree.nearest(balls.points[i]).distance <= reach;
  }
  verdict.coverage = static_cast<double>(covered) / static_cast<double>(balls.points.size());
  return verdict;
}

namespace {

/// Writes `"name": value` pairs of one JSON object.
class Json_object {
public:
  Json_object& add(const std::string& name, double value)
  {
    std::ostringstream text;
    text.precision(6);
    if(std::isfinite(value)) {
      text << value;
    } else {
      text << "null";
    }
    return raw(name, text.str());
  }
  Json_object& add(const std::string& name, bool value)
  {
    return raw(name, value ? "true" : "false");
  }
  Json_object& add(const std::string& name, const Distance_statistics& statistics)
  {
    Json_object object;
    object.add("samples", static_cast<double>(statistics.samples));
    if(statistics.samples > 0) {
      object.add("mean", statistics.mean)
          .add("rms", statistics.rms)
          .add("percentile_95", statistics.percentile_95)
          .add("max", statistics.max);
      for(std::size_t i = 0; i < distribution_limits.size(); ++i) {
        std::ostringstream limit;
        limit << "share_within_" << distribution_limits[i];
        object.add(limit.str(), statistics.share_within[i]);
      }
    }
    return raw(name, object.text());
  }
  Json_object& add(const std::string& name, const Normal_statistics& statistics)
  {
    return raw(name, Json_object()
                         .add("mean_error", statistics.mean_error)
                         .add("flipped", statistics.flipped)
                         .text());
  }
  Json_object& add(const std::string& name, const Topology& topology)
  {
    return raw(name, Json_object()
                         .add("components", static_cast<double>(topology.components))
                         .add("closed", topology.closed)
                         .add("genus", topology.genus)
                         .add("volume", topology.volume)
                         .text());
  }

  std::string text() const { return "{" + m_text + "}"; }

private:
  Json_object& raw(const std::string& name, const std::string& value)
  {
    m_text += (m_text.empty() ? "\"" : ", \"") + name + "\": " + value;
    return *this;
  }
  std::string m_text;
};

}  // namespace

std::string to_json(const Mesh_verdict& verdict)
{
  return Json_object()
      .add("truth_to_result", verdict.forward)
      .add("result_to_truth", verdict.reverse)
      .add("seen", verdict.seen)
      .add("unseen", verdict.unseen)
      .add("seen_share", verdict.seen_share)
      .add("fscore_0.5", verdict.fscore_half)
      .add("fscore_1", verdict.fscore_one)
      .add("normals", verdict.normals)
      .add("topology", verdict.topology)
      .add("true_topology", verdict.true_topology)
      .add("volume_ratio", verdict.volume_ratio)
      .text();
}

std::string to_json(const Point_set_verdict& verdict)
{
  return Json_object()
      .add("result_to_truth", verdict.distance)
      .add("coverage", verdict.coverage)
      .add("coverage_seen", verdict.seen)
      .add("coverage_unseen", verdict.unseen)
      .add("seen_share", verdict.seen_share)
      .add("spacing", verdict.spacing)
      .add("spacing_variation", verdict.spacing_variation)
      .add("normals", verdict.normals)
      .text();
}

std::string to_json(const Skeleton_verdict& verdict)
{
  return Json_object()
      .add("inside", verdict.inside)
      .add("to_medial_axis", verdict.to_medial_axis)
      .add("coverage", verdict.coverage)
      .add("components", static_cast<double>(verdict.components))
      .add("cycles", static_cast<double>(verdict.cycles))
      .add("length", verdict.length)
      .text();
}

}  // namespace benchmark
