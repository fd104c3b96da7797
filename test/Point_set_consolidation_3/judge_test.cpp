// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The benchmark's scanner and judge on shapes whose answers are known.
#undef NDEBUG
#include "judge.h"
#include "random_numbers.h"
#include "virtual_scanner.h"

#include <Eigen/Geometry>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

using namespace benchmark;

namespace {

/// A grid of `columns` x `rows` quadrilaterals that is closed in the directions that `point` closes.
Triangle_mesh grid(std::size_t columns, std::size_t rows, bool close_columns, bool close_rows,
                   const std::function<Vec3(double, double)>& point)
{
  Triangle_mesh mesh;
  const std::size_t width = close_columns ? columns : columns + 1;
  const std::size_t height = close_rows ? rows : rows + 1;
  for(std::size_t j = 0; j < height; ++j) {
    for(std::size_t i = 0; i < width; ++i) {
      mesh.vertices.push_back(
          point(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  for(std::size_t j = 0; j < rows; ++j) {
    for(std::size_t i = 0; i < columns; ++i) {
      const auto at
          = [&](std::size_t a, std::size_t b) { return (b % height) * width + a % width; };
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

Triangle_mesh torus(double major, double minor, const Vec3& centre = Vec3::Zero())
{
  return grid(240, 120, true, true, [&](double s, double t) {
    const double u = 2.0 * EIGEN_PI * s;
    const double v = 2.0 * EIGEN_PI * t;
    const double radius = major + minor * std::cos(v);
    return Vec3(centre + Vec3(radius * std::cos(u), radius * std::sin(u), minor * std::sin(v)));
  });
}

/// Octahedron, subdivided and blown up; its octants share no vertices.
Triangle_mesh sphere(double radius, std::size_t subdivisions = 64)
{
  Triangle_mesh mesh;
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  for(int octant = 0; octant < 8; ++octant) {
    const Vec3 a = octant & 1 ? -x : x, b = octant & 2 ? -y : y, c = octant & 4 ? -z : z;
    const bool outwards = a.cross(b).dot(c) > 0.0;
    const std::size_t first = mesh.vertices.size();
    const auto at = [&](std::size_t i, std::size_t j) {
      return first + j * (subdivisions + 1) - j * (j - 1) / 2 + i;
    };
    for(std::size_t j = 0; j <= subdivisions; ++j) {
      for(std::size_t i = 0; i + j <= subdivisions; ++i) {
        const double u = static_cast<double>(i) / subdivisions,
                     v = static_cast<double>(j) / subdivisions;
        mesh.vertices.push_back(radius * (u * a + v * b + (1.0 - u - v) * c).normalized());
      }
    }
    const auto add = [&](std::size_t p, std::size_t q, std::size_t r) {
      outwards ? mesh.faces.push_back({p, q, r}) : mesh.faces.push_back({q, p, r});
    };
    for(std::size_t j = 0; j < subdivisions; ++j) {
      for(std::size_t i = 0; i + j < subdivisions; ++i) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if(i + j + 1 < subdivisions)
          add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return mesh;
}

Triangle_mesh together(const Triangle_mesh& a, const Triangle_mesh& b)
{
  Triangle_mesh mesh = a;
  mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
  for(auto face : b.faces) {
    for(std::size_t& v : face)
      v += a.vertices.size();
    mesh.faces.push_back(face);
  }
  return mesh;
}

Triangle_mesh keep_faces(const Triangle_mesh& mesh, const std::function<bool(const Vec3&)>& keep)
{
  Triangle_mesh part;
  part.vertices = mesh.vertices;
  for(const auto& face : mesh.faces) {
    const Vec3 centre
        = (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
    if(keep(centre))
      part.faces.push_back(face);
  }
  return part;
}

void check(double value, double expected, double tolerance, const char* what)
{
  if(std::abs(value - expected) <= tolerance)
    return;
  std::cerr << what << ": " << value << " instead of " << expected << " +- " << tolerance << "\n";
  std::exit(EXIT_FAILURE);
}

// A sphere's box has the diagonal 2 sqrt(3) R, so that one percent of the diagonal is 0.0346 R.
const double percent_of_radius = 100.0 / (2.0 * std::sqrt(3.0));

void concentric_spheres()
{
  const Triangle_mesh truth = sphere(2.0);
  for(const double share : {0.01, 0.05}) {
    const Mesh_verdict verdict = Judge(truth).mesh(sphere(2.0 * (1.0 + share)));
    const double expected = share * percent_of_radius;
    // the facets lie up to 2e-4 R inside of the sphere
    const double tolerance = 2e-4 * percent_of_radius;
    for(const Distance_statistics& statistics : {verdict.forward, verdict.reverse}) {
      check(statistics.mean, expected, tolerance, "mean distance of concentric spheres");
      check(statistics.rms, expected, tolerance, "rms distance of concentric spheres");
      check(statistics.percentile_95, expected, tolerance, "95 % distance of concentric spheres");
      check(statistics.max, expected, tolerance, "largest distance of concentric spheres");
    }
    check(verdict.volume_ratio, std::pow(1.0 + share, 3.0), 1e-9, "volume ratio");
    check(verdict.fscore_half, share == 0.01 ? 1.0 : 0.0, 0.0, "F-score at 0.5 %");
    check(verdict.forward.share_within[0], 0.0, 0.0, "share within 0.25 %");
    check(verdict.forward.share_within[3], 1.0, 0.0, "share within 2 %");
    check(verdict.normals.mean_error, 0.0, 1.5, "normals of concentric spheres");
    check(verdict.normals.flipped, 0.0, 0.0, "flipped normals of concentric spheres");
  }
}

void identical_meshes()
{
  const Mesh_verdict verdict = Judge(torus(3.0, 1.0)).mesh(torus(3.0, 1.0));
  check(verdict.forward.max, 0.0, 1e-9, "distance of equal meshes");
  check(verdict.reverse.max, 0.0, 1e-9, "distance of equal meshes");
  check(verdict.fscore_one, 1.0, 0.0, "F-score of equal meshes");
  check(verdict.volume_ratio, 1.0, 1e-12, "volume ratio of equal meshes");
}

void offset_plane()
{
  const auto plane = [](double height) {
    return grid(20, 20, false, false,
                [&](double u, double v) { return Vec3(4.0 * u, 3.0 * v, height); });
  };
  const Mesh_verdict verdict = Judge(plane(0.0)).mesh(plane(0.02));
  check(verdict.forward.mean, 0.4, 1e-9, "offset of planes");
  check(verdict.reverse.max, 0.4, 1e-9, "offset of planes");
  check(verdict.forward.share_within[0], 0.0, 0.0, "share of a plane within 0.25 %");
  check(verdict.forward.share_within[1], 1.0, 0.0, "share of a plane within 0.5 %");
  assert(!verdict.topology.closed && verdict.topology.components == 1);
}

void missing_half()
{
  const Triangle_mesh truth = sphere(1.0);
  const auto upper = [](const Vec3& p) { return p.z() > 0.0; };
  Point_cloud scan;  // what a noise-free scan of the upper half would see
  const Surface_samples samples = sample_surface(truth, 20000, 7);
  for(const Vec3& p : samples.points) {
    if(!upper(p))
      continue;
    scan.points.push_back(p);
    scan.normals.push_back(p.normalized());
  }
  const Mesh_verdict verdict = Judge(truth, scan).mesh(keep_faces(truth, upper));
  // mean over the lower half of the chord to the equator: 4 (1 - c) - 8 (2/3 - c + c^3/3), c = cos(pi/4)
  const double chord = 0.552285;
  check(verdict.reverse.max, 0.0, 1e-9, "distance of a part of the truth");
  check(verdict.forward.mean, 0.5 * chord * percent_of_radius, 0.02,
        "mean distance to a half sphere");
  check(verdict.forward.max, std::sqrt(2.0) * percent_of_radius, 0.3,
        "largest distance to a half sphere");
  check(verdict.seen_share, 0.5, 0.03, "seen share of the half sphere");
  check(verdict.seen.mean, 0.0, 0.05, "error of the seen half");
  // a strip of two scan spacings (0.06 R) along the equator counts as seen
  check(verdict.unseen.mean, (chord - 0.002) / 0.94 * percent_of_radius, 0.5,
        "error of the unseen half");
  assert(!verdict.topology.closed);
}

void topology()
{
  const Triangle_mesh ring = torus(3.0, 1.0);
  const Topology one = topology_of(ring);
  assert(one.closed && one.components == 1 && one.genus == 1.0);
  check(one.volume, 2.0 * EIGEN_PI * EIGEN_PI * 3.0, 0.1, "volume of a torus");
  const Topology two = topology_of(together(ring, torus(3.0, 1.0, Vec3(10.0, 0.0, 0.0))));
  assert(two.closed && two.components == 2 && two.genus == 2.0);
  Triangle_mesh turned = ring;
  std::swap(turned.faces[0][0], turned.faces[0][1]);
  assert(!topology_of(turned).closed);
  const Triangle_mesh unit
      = grid(1, 1, false, false, [](double u, double v) { return Vec3(u, v, 0.0); });
  assert(topology_of(unit).components == 1 && !topology_of(unit).closed);
}

void flipped_normals()
{
  const Triangle_mesh truth = sphere(1.0);
  Triangle_mesh inside_out = truth;
  for(auto& face : inside_out.faces)
    std::swap(face[0], face[1]);
  const Mesh_verdict mesh_verdict = Judge(truth).mesh(inside_out);
  check(mesh_verdict.normals.flipped, 1.0, 0.0, "flipped facets");
  check(mesh_verdict.normals.mean_error, 0.0, 1.0, "unoriented normals of flipped facets");
  check(mesh_verdict.volume_ratio, -1.0, 1e-9, "volume of the mesh inside out");

  // every fourth normal flipped, all tilted by 20 degrees
  const Surface_samples samples = sample_surface(truth, 4000, 3);
  Point_cloud cloud;
  for(std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vec3 normal = samples.points[i].normalized();
    const Vec3 axis = normal.unitOrthogonal();
    const Vec3 tilted = Eigen::AngleAxisd(20.0 * EIGEN_PI / 180.0, axis) * normal;
    cloud.points.push_back(samples.points[i]);
    cloud.normals.push_back(i % 4 == 0 ? Vec3(-tilted) : tilted);
  }
  const Point_set_verdict verdict = Judge(truth).points(cloud);
  check(verdict.normals.flipped, 0.25, 1e-9, "flipped normals");
  check(verdict.normals.mean_error, 20.0, 0.2, "tilted normals");
  check(verdict.distance.max, 0.0, 1e-9, "samples lie on the truth");
}

void point_spacing()
{
  const auto plane = grid(1, 1, false, false, [](double u, double v) { return Vec3(u, v, 0.0); });
  Point_cloud lattice, random;
  for(int i = 0; i < 40; ++i) {
    for(int j = 0; j < 40; ++j)
      lattice.points.emplace_back((i + 0.5) / 40.0, (j + 0.5) / 40.0, 0.01);
  }
  const Point_set_verdict regular = Judge(plane).points(lattice);
  check(regular.spacing_variation, 0.0, 1e-6, "spacing variation of a lattice");
  check(regular.spacing, 100.0 / 40.0 / std::sqrt(2.0), 1e-6, "spacing of a lattice");
  check(regular.distance.mean, 1.0 / std::sqrt(2.0), 1e-9, "height above the plane");

  // independent uniform points in the plane: sqrt(4/pi - 1). Slices of equal area would be too even.
  benchmark::Random_numbers numbers(1);
  for(int i = 0; i < 20000; ++i) {
    const double u = numbers.uniform();
    random.points.emplace_back(u, numbers.uniform(), 0.0);
  }
  check(Judge(plane).points(random).spacing_variation, std::sqrt(4.0 / EIGEN_PI - 1.0), 0.01,
        "spacing variation of random points");
}

void hidden_coverage()
{
  const Triangle_mesh truth = sphere(1.0);
  Point_cloud upper;
  for(const Vec3& p : sample_surface(truth, 20000, 7).points) {
    if(p.z() <= 0.0)
      continue;
    upper.points.push_back(p);
    upper.normals.push_back(p.normalized());
  }
  const Point_set_verdict verdict = Judge(truth, upper).points(upper);
  assert(verdict.seen.mean < 0.5 && verdict.seen.share_within[3] == 1.0);
  check(verdict.unseen.mean, 0.5503 / 0.94 * percent_of_radius, 0.5, "coverage of the hidden half");
}

Segment_graph arc(double radius, double share, double height = 0.0)
{
  Segment_graph graph;
  const std::size_t count = 200;
  const auto used = static_cast<std::size_t>(share * count);
  for(std::size_t i = 0; i < used; ++i) {
    const double angle = 2.0 * EIGEN_PI * static_cast<double>(i) / count;
    graph.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    if(i > 0)
      graph.edges.push_back({i - 1, i});
  }
  if(used == count)
    graph.edges.push_back({count - 1, 0});
  return graph;
}

void skeletons()
{
  const Judge judge(torus(3.0, 1.0));
  const Skeleton_verdict axis = judge.skeleton(arc(3.0, 1.0));
  check(axis.inside, 1.0, 0.0, "axis inside of the torus");
  check(axis.to_medial_axis.mean, 0.0, 0.4, "axis of the torus to its medial axis");
  check(axis.coverage, 1.0, 0.001, "coverage by the axis");
  assert(axis.components == 1 && axis.cycles == 1);

  // half the axis reaches a little more than half of the surface
  const Skeleton_verdict half = judge.skeleton(arc(3.0, 0.5));
  check(half.coverage, 0.58, 0.05, "coverage by half the axis");
  assert(half.components == 1 && half.cycles == 0);

  // a circle half way between axis and surface: 0.5 of the diagonal sqrt(64 + 64 + 4)
  const Skeleton_verdict high = judge.skeleton(arc(3.0, 1.0, 0.5));
  check(high.to_medial_axis.mean, 50.0 / std::sqrt(132.0), 0.4, "circle above the axis");
  check(high.inside, 1.0, 0.0, "circle above the axis is inside");
  check(judge.skeleton(arc(3.0, 1.0, 1.2)).inside, 0.0, 0.0, "circle above the torus");

  Segment_graph two = arc(3.0, 1.0);
  two.vertices.push_back(Vec3(3.0, 0.0, 0.1));
  assert(judge.skeleton(two).components == 2 && judge.skeleton(two).cycles == 1);
}

void scanner()
{
  const Triangle_mesh ball = sphere(1.0);
  Scanner_options options;
  options.points = 5000;
  options.noise = 0.5;
  const Scan scan = scan_mesh(ball, options);
  const std::size_t count = scan.cloud.size();
  check(static_cast<double>(count), 5000.0, 75.0, "number of points");
  const Vec3 towards = Vec3(1.0, 0.45, 0.35).normalized();
  double square_sum = 0.0;
  for(std::size_t i = 0; i < count; ++i) {
    check(scan.true_points[i].norm(), 1.0, 3e-4, "true sample on the sphere");
    assert((scan.cloud.directions[i] - towards).norm() < 1e-12 && scan.cloud.views[i] == 0);
    assert(scan.true_normals[i].dot(towards) >= options.grazing_cosine);
    const Vec3 error = scan.cloud.points[i] - scan.true_points[i];
    assert(error.cross(towards).norm() < 1e-12);
    square_sum += error.squaredNorm();
  }
  check(std::sqrt(square_sum / count) / scan.diagonal, 0.005, 2e-4, "noise");
  const Scan again = scan_mesh(ball, options);
  assert(again.cloud.points == scan.cloud.points);
  options.noise = 0.0;
  assert(scan_mesh(ball, options).cloud.points == scan.true_points);
  options.seed = 2;
  assert(scan_mesh(ball, options).cloud.points != scan.true_points);

  // the share of the sphere that is seen at a cosine of at least 0.15
  const Judge judge(ball, truth_cloud(scan));
  check(judge.mesh(ball).seen_share, 0.5 * (1.0 - 0.15), 0.03, "seen share");

  options.perspective = true;
  options.views = 3;
  options.outliers = 10.0;
  options.misalignment = 2.0;
  const Scan hard = scan_mesh(ball, options);
  check(static_cast<double>(hard.cloud.size()), 5000.0, 75.0, "number of points with outliers");
  const std::size_t measured = hard.true_points.size();
  check(static_cast<double>(hard.cloud.size() - measured), 500.0, 10.0, "number of outliers");
  double largest = 0.0;
  double smallest = 1.0;
  for(std::size_t i = 0; i < measured; ++i) {
    const double moved = (hard.cloud.points[i] - hard.true_points[i]).norm() / hard.diagonal;
    if(hard.cloud.views[i] == 0) {
      assert(moved == 0.0);
      const Vec3 eye = options.distance * hard.diagonal * towards;
      assert(((eye - hard.true_points[i]).normalized() - hard.cloud.directions[i]).norm() < 1e-9);
    } else {
      largest = std::max(largest, moved);
      smallest = std::min(smallest, moved);
    }
  }
  assert(largest <= 0.04 && largest > 0.015 && smallest > 0.0);

  const std::vector<Vec3> directions = default_view_directions(12);
  for(std::size_t i = 0; i < directions.size(); ++i) {
    for(std::size_t j = 0; j < i; ++j)
      assert(directions[i].dot(directions[j]) < std::cos(40.0 * EIGEN_PI / 180.0));
  }
}

}  // namespace

int main()
{
  concentric_spheres();
  identical_meshes();
  offset_plane();
  missing_half();
  topology();
  flipped_normals();
  point_spacing();
  hidden_coverage();
  skeletons();
  scanner();
  std::cout << "judge_test: all answers as known\n";
  return EXIT_SUCCESS;
}
