// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "skeleton_runs.h"

#include "cgal_conversion.h"

#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>
#include <CGAL/property_map.h>
#include <CGAL/skeleton_driven_surface_reconstruction.h>

#include <chrono>
#include <sstream>
#include <utility>

namespace benchmark {

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;
namespace core = CGAL::Point_set_consolidation_3::internal;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point>;
using Tag = CGAL::Parallel_if_available_tag;
using Oriented_point = std::pair<Point, Vector>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<Point> to_points(const std::vector<Vec3>& positions)
{
  std::vector<Point> points;
  for(const Vec3& p : positions)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

void describe(const Skeleton& skeleton, Skeleton_run& run)
{
  const core::Skeleton_graph graph = core::to_skeleton_graph(skeleton);
  run.graph = {};
  for(const core::Skeleton_node& node : graph.nodes) {
    run.graph.vertices.push_back(node.position);
    run.graph.radius.push_back(node.radius);
  }
  run.graph.edges = graph.edges;
  run.cycles = CGAL::number_of_skeleton_cycles(skeleton);
  run.components = CGAL::number_of_skeleton_components(skeleton);
  run.tips = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    run.tips += degree(v, skeleton) == 1;
}

}  // namespace

Skeleton_run laplacian_skeleton(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                                const Skeleton_options& options)
{
  using CGAL::Point_set_consolidation_3::Laplacian_weights;
  const Laplacian_weights weights =
    options.weights == Laplacian_weight::mean_value      ? Laplacian_weights::MEAN_VALUE
    : options.weights == Laplacian_weight::combinatorial ? Laplacian_weights::COMBINATORIAL
                                                         : Laplacian_weights::COTANGENT;
  std::vector<Oriented_point> points;
  for(std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = positions[i], n = normals.empty() ? Vec3(Vec3::Zero()) : normals[i];
    points.emplace_back(Point(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
  }
  Skeleton_run result;
  const auto extract = [&](const auto& np) {
    const Clock::time_point begin = Clock::now();
    CGAL::Laplacian_contraction_skeletonization_3<Kernel, Tag> steps(
      points, np.laplacian_weights(weights)
                .contraction_weight(options.contraction_weight)
                .attraction_weight(options.attraction_weight)
                .contraction_factor(options.contraction_factor)
                .number_of_samples(options.most_samples)
                .extend_tips(options.extends_tips));
    steps.extract();
    Skeleton skeleton;
    steps.skeleton(skeleton);
    result.seconds = seconds_since(begin);
    result.iterations = steps.number_of_iterations();
    describe(skeleton, result);
  };
  const auto np = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>());
  if(normals.empty())
    extract(np);
  else
    extract(np.normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()));
  return result;
}

Skeleton_run l1_medial_skeleton(const std::vector<Vec3>& positions, const std::vector<std::size_t>& segments)
{
  const std::vector<Point> points = to_points(positions);
  std::vector<std::size_t> indices;
  for(std::size_t i = 0; i < points.size(); ++i)
    indices.push_back(i);
  Skeleton_run result;
  Skeleton skeleton;
  const auto np = params::point_map(CGAL::make_property_map(points)).geom_traits(Kernel());
  const Clock::time_point begin = Clock::now();
  if(segments.empty())
    CGAL::extract_l1_medial_skeleton<Tag>(indices, skeleton, np);
  else
    CGAL::extract_l1_medial_skeleton<Tag>(indices, skeleton,
                                          np.segment_map(CGAL::make_property_map(segments)));
  result.seconds = seconds_since(begin);
  describe(skeleton, result);
  return result;
}

Skeleton_run edited(const Skeleton_run& run, const std::string& edits)
{
  Skeleton skeleton = support::to_skeleton<Skeleton>(run.graph);
  std::istringstream stream(edits);
  CGAL::Curve_skeleton_editing::apply_edits(skeleton, stream);
  Skeleton_run result = run;
  describe(skeleton, result);
  return result;
}

Triangle_mesh skeleton_driven_mesh(const std::vector<Vec3>& positions, const support::Segment_graph& graph,
                                   const Field_options& options)
{
  const std::vector<Point> points = to_points(positions);
  const Skeleton skeleton = support::to_skeleton<Skeleton>(graph);
  Mesh mesh;
  CGAL::skeleton_driven_surface_reconstruction<Tag>(points, skeleton, mesh,
                                                    params::grid_resolution(options.resolution)
                                                      .adaptive(options.adaptive)
                                                      .surface_weight(options.surface_weight)
                                                      .outside_weight(options.outside_weight)
                                                      .outside_factor(options.outside_factor));
  return support::to_triangle_mesh(mesh);
}

std::vector<Vec3> even_samples(const Triangle_mesh& mesh, std::size_t count)
{
  return core::sample_triangles(mesh.vertices, mesh.faces, count, 1);
}

}  // namespace benchmark
