// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "virtual_scanner.h"

#include "mesh_tree.h"
#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/sphere_directions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace benchmark {

namespace {

/// Rays per axis of the first, coarse pass that only measures how much of the image the model fills:
/// about 10 000 hits, so the number of points is met within a percent.
constexpr int coarse_rays = 200;

/// Outliers fill the bounding box enlarged by this share of the diagonal on every side.
constexpr double outlier_margin = 0.1;

/// Candidate directions from which the fourth and further views are picked.
constexpr std::size_t direction_candidates = 500;

/// The image of one view: a plane through the box centre with axes u and v, seen along -towards.
struct Camera {
  Vec3 centre, towards, u, v;
  double distance = 0.0;  ///< of the eye from the plane; of the ray's origin for parallel rays
  bool perspective = false;
  double u_min, u_max, v_min, v_max;

  double area() const { return (u_max - u_min) * (v_max - v_min); }
  Vec3 eye() const { return centre + distance * towards; }

  /// Ray through the plane's point (a, b).
  Ray ray(double a, double b) const
  {
    const Vec3 on_plane = centre + a * u + b * v;
    if(perspective)
      return {eye(), (on_plane - eye()).normalized()};
    return {on_plane + distance * towards, -towards};
  }
};

Camera camera_for(const Triangle_mesh& mesh, const Vec3& direction, const Vec3& centre,
                  double diagonal, const Scanner_options& options)
{
  Camera camera;
  camera.centre = centre;
  camera.towards = direction.normalized();
  const Vec3 axis = std::abs(camera.towards.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  camera.u = axis.cross(camera.towards).normalized();
  camera.v = camera.towards.cross(camera.u);
  camera.perspective = options.perspective;
  // parallel rays start outside of the bounding sphere
  camera.distance = (options.perspective ? options.distance : 1.0) * diagonal;
  camera.u_min = camera.v_min = std::numeric_limits<double>::max();
  camera.u_max = camera.v_max = -std::numeric_limits<double>::max();
  for(const Vec3& p : mesh.vertices) {
    const Vec3 d = p - centre;
    const double scale
        = options.perspective ? camera.distance / (camera.distance - d.dot(camera.towards)) : 1.0;
    camera.u_min = std::min(camera.u_min, scale * d.dot(camera.u));
    camera.u_max = std::max(camera.u_max, scale * d.dot(camera.u));
    camera.v_min = std::min(camera.v_min, scale * d.dot(camera.v));
    camera.v_max = std::max(camera.v_max, scale * d.dot(camera.v));
  }
  return camera;
}

/// Casts one jittered ray per cell of side `pitch` and hands every accepted hit to `visit(hit)`.
template <typename Visitor>
void cast_rays(const Mesh_tree& tree, const Camera& camera, double pitch, double grazing_cosine,
               Random_numbers& random, Visitor visit)
{
  const int columns = static_cast<int>(std::ceil((camera.u_max - camera.u_min) / pitch));
  const int rows = static_cast<int>(std::ceil((camera.v_max - camera.v_min) / pitch));
  for(int row = 0; row < rows; ++row) {
    for(int column = 0; column < columns; ++column) {
      // both drawn before use: the order in which arguments are evaluated is not fixed
      const double a = camera.u_min + (column + random.uniform()) * pitch;
      const double b = camera.v_min + (row + random.uniform()) * pitch;
      const Ray ray = camera.ray(a, b);
      const std::optional<Mesh_hit> hit = tree.first_hit(ray);
      if(hit && -hit->normal.dot(ray.direction) >= grazing_cosine)
        visit(*hit, ray);
    }
  }
}

Eigen::AlignedBox3d box_of(const std::vector<Vec3>& points)
{
  Eigen::AlignedBox3d box;
  for(const Vec3& p : points)
    box.extend(p);
  return box;
}

/// The rigid motion by which a view is misregistered.
Eigen::Isometry3d misalignment(const Vec3& centre, double diagonal, double percent,
                               Random_numbers& random)
{
  const double length = percent / 100.0 * diagonal;
  const Vec3 shift = length * random.direction();
  const Vec3 axis = random.direction();
  // a point half a diagonal away from the centre moves by `length`
  const Eigen::AngleAxisd rotation(2.0 * percent / 100.0, axis);
  return Eigen::Translation3d(centre + shift) * rotation * Eigen::Translation3d(-centre);
}

}  // namespace

std::vector<Vec3> default_view_directions(std::size_t count)
{
  std::vector<Vec3> directions
      = {Vec3(1.0, 0.45, 0.35).normalized(), Vec3(-1.0, 0.3, -0.4).normalized(),
         Vec3(0.1, -1.0, 0.5).normalized()};
  while(directions.size() < count) {
    Vec3 best = Vec3::UnitX();
    double best_cosine = 2.0;
    for(std::size_t i = 0; i < direction_candidates; ++i) {
      const Vec3 candidate
          = CGAL::Point_set_consolidation_3::internal::sphere_direction(i, direction_candidates);
      double cosine = -1.0;
      for(const Vec3& d : directions)
        cosine = std::max(cosine, d.dot(candidate));
      if(cosine < best_cosine) {
        best_cosine = cosine;
        best = candidate;
      }
    }
    directions.push_back(best);
  }
  directions.resize(count);
  return directions;
}

Scan scan_mesh(const Triangle_mesh& mesh, const Scanner_options& options)
{
  const Mesh_tree tree(mesh);
  const Eigen::AlignedBox3d box = box_of(mesh.vertices);
  const Vec3 centre = box.center();
  Scan scan;
  scan.diagonal = box.diagonal().norm();

  const std::vector<Vec3> directions
      = options.directions.empty() ? default_view_directions(options.views) : options.directions;
  std::vector<Camera> cameras;
  for(const Vec3& direction : directions) {
    cameras.push_back(camera_for(mesh, direction, centre, scan.diagonal, options));
  }

  // Coarse pass: the part of all images that returns a point, hence the pitch that gives `points` of them.
  double image_area = 0.0;
  for(const Camera& camera : cameras)
    image_area = std::max(image_area, camera.area());
  const double coarse_pitch = std::sqrt(image_area) / coarse_rays;
  Random_numbers coarse_random(0);
  std::size_t coarse_hits = 0;
  for(const Camera& camera : cameras) {
    cast_rays(tree, camera, coarse_pitch, options.grazing_cosine, coarse_random,
              [&](const Mesh_hit&, const Ray&) { ++coarse_hits; });
  }
  if(coarse_hits == 0)
    throw support::Method_error("virtual scan: no ray hits the mesh");
  const double outlier_share = std::clamp(options.outliers / 100.0, 0.0, 0.99);
  const double measured = (1.0 - outlier_share) * static_cast<double>(options.points);
  scan.pitch = coarse_pitch * std::sqrt(static_cast<double>(coarse_hits) / measured);

  // Separate streams, so that the true samples are the same with and without noise.
  Random_numbers jitter(options.seed);
  Random_numbers noise(options.seed ^ 0x9e3779b97f4a7c15ULL);
  Random_numbers disturbance(options.seed ^ 0xc2b2ae3d27d4eb4fULL);

  const double sigma = options.noise / 100.0 * scan.diagonal;
  for(std::size_t view = 0; view < cameras.size(); ++view) {
    const Eigen::Isometry3d motion
        = view > 0 && options.misalignment > 0.0
              ? misalignment(centre, scan.diagonal, options.misalignment, disturbance)
              : Eigen::Isometry3d::Identity();
    cast_rays(tree, cameras[view], scan.pitch, options.grazing_cosine, jitter,
              [&](const Mesh_hit& hit, const Ray& ray) {
                const double error = sigma > 0.0 ? sigma * noise.normal() : 0.0;
                scan.true_points.push_back(hit.point);
                scan.true_normals.push_back(hit.normal);
                scan.cloud.points.push_back(motion * Vec3(hit.point + error * ray.direction));
                scan.cloud.directions.push_back(-ray.direction);
                scan.cloud.views.push_back(static_cast<int>(view));
              });
  }

  const auto outliers = static_cast<std::size_t>(std::lround(
      outlier_share / (1.0 - outlier_share) * static_cast<double>(scan.true_points.size())));
  const Vec3 margin = Vec3::Constant(outlier_margin * scan.diagonal);
  for(std::size_t i = 0; i < outliers; ++i) {
    Vec3 p;
    for(int axis = 0; axis < 3; ++axis) {
      p[axis] = disturbance.uniform(box.min()[axis] - margin[axis], box.max()[axis] + margin[axis]);
    }
    const auto view
        = static_cast<std::size_t>(disturbance.uniform() * static_cast<double>(cameras.size()));
    scan.cloud.points.push_back(p);
    scan.cloud.directions.push_back(
        options.perspective ? Vec3((cameras[view].eye() - p).normalized()) : cameras[view].towards);
    scan.cloud.views.push_back(static_cast<int>(view));
  }
  return scan;
}

Point_cloud truth_cloud(const Scan& scan)
{
  const std::size_t count = scan.true_points.size();
  Point_cloud cloud;
  cloud.points = scan.true_points;
  cloud.normals = scan.true_normals;
  cloud.directions.assign(scan.cloud.directions.begin(), scan.cloud.directions.begin() + count);
  cloud.views.assign(scan.cloud.views.begin(), scan.cloud.views.begin() + count);
  return cloud;
}

Triangle_mesh normalized(const Triangle_mesh& mesh)
{
  const Eigen::AlignedBox3d box = box_of(mesh.vertices);
  const double diagonal = box.diagonal().norm();
  Triangle_mesh result = mesh;
  for(Vec3& p : result.vertices)
    p = (p - box.center()) / diagonal;
  return result;
}

double bounding_box_diagonal(const std::vector<Vec3>& points)
{
  return box_of(points).diagonal().norm();
}

}  // namespace benchmark
