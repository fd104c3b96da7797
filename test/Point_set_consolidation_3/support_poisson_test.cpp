// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson meshing of samples of shapes whose surface, topology and volume are known.
#undef NDEBUG

#include "poisson_mesh.h"
#include "small_handles.h"
#include "random_numbers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

using namespace support;
using benchmark::Random_numbers;

namespace {

struct Sample {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
};

/// side = -1: seen from within, the wall of a cavity.
void add_sphere(Sample& sample, const Vec3& centre, double radius, std::size_t count,
                double side = 1)
{
  Random_numbers random(count);
  for(std::size_t i = 0; i < count; ++i) {
    const Vec3 n = random.direction();
    sample.points.push_back(centre + radius * n);
    sample.normals.push_back(side * n);
  }
}

Sample torus(double major, double minor, std::size_t count)
{
  Random_numbers random(1);
  Sample sample;
  while(sample.points.size() < count) {
    const double u = 2 * EIGEN_PI * random.uniform(), v = 2 * EIGEN_PI * random.uniform();
    if(random.uniform() * (major + minor) > major + minor * std::cos(v))
      continue;  // even density
    const Vec3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    sample.points.push_back(major * Vec3(std::cos(u), std::sin(u), 0) + minor * n);
    sample.normals.push_back(n);
  }
  return sample;
}

double distance_to_torus(const Vec3& p, double major, double minor)
{
  return std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor;
}

struct Component {
  double volume = 0;
  int euler_characteristic = 0;
};

/// Largest absolute volume first. Asserts that the mesh is closed, oriented and manifold.
std::vector<Component> components(const Triangle_mesh& mesh)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of_edge;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for(int k = 0; k < 3; ++k) {
      assert(mesh.faces[f][k] < mesh.vertices.size());
      const bool is_new
          = face_of_edge.emplace(std::make_pair(mesh.faces[f][k], mesh.faces[f][(k + 1) % 3]), f)
                .second;
      assert(is_new);
    }
  }
  std::vector<std::size_t> root(mesh.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  const std::function<std::size_t(std::size_t)> find = [&](std::size_t v) {
    while(root[v] != v)
      v = root[v] = root[root[v]];
    return v;
  };
  for(const auto& edge : face_of_edge) {
    assert(face_of_edge.count({edge.first.second, edge.first.first}) == 1);
    root[find(edge.first.first)] = find(edge.first.second);
  }
  // One fan of faces around each vertex, no more, or the surface touches itself there.
  std::vector<std::size_t> degree(mesh.vertices.size(), 0), start(mesh.vertices.size());
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for(std::size_t v : mesh.faces[f]) {
      ++degree[v];
      start[v] = f;
    }
  }
  for(std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    assert(degree[v] >= 3);
    std::size_t f = start[v], steps = 0;
    do {
      const auto& face = mesh.faces[f];
      const int k = face[0] == v ? 0 : face[1] == v ? 1 : 2;
      f = face_of_edge.at({v, face[(k + 2) % 3]});
      ++steps;
    } while(f != start[v] && steps <= degree[v]);
    assert(steps == degree[v]);
  }

  const Vec3 origin = mesh.vertices.front();
  std::map<std::size_t, Component> by_root;
  for(std::size_t v = 0; v < mesh.vertices.size(); ++v)
    ++by_root[find(v)].euler_characteristic;
  for(const auto& edge : face_of_edge)
    by_root[find(edge.first.first)].euler_characteristic -= edge.first.first < edge.first.second;
  for(const auto& f : mesh.faces) {
    Component& c = by_root[find(f[0])];
    ++c.euler_characteristic;
    c.volume += (mesh.vertices[f[0]] - origin)
                    .dot((mesh.vertices[f[1]] - origin).cross(mesh.vertices[f[2]] - origin))
                / 6;
  }
  std::vector<Component> all;
  for(const auto& c : by_root)
    all.push_back(c.second);
  std::sort(all.begin(), all.end(), [](const Component& a, const Component& b) {
    return std::abs(a.volume) > std::abs(b.volume);
  });
  return all;
}

bool is_within(double value, double expected, double relative)
{
  return std::abs(value - expected) <= relative * std::abs(expected);
}

double ball_volume(double radius)
{
  return 4 * EIGEN_PI / 3 * radius * radius * radius;
}

/// Length of the edge of the square that a sample point has for itself.
double spacing(double area, std::size_t count)
{
  return std::sqrt(area / static_cast<double>(count));
}

void a_sphere_in_any_unit_and_place()
{
  Sample sample;
  add_sphere(sample, Vec3::Zero(), 1, 3000);
  const double unit = spacing(4 * EIGEN_PI, 3000);
  const Triangle_mesh reference = poisson_mesh(sample.points, sample.normals);
  const auto check = [&](const Triangle_mesh& mesh, double scale, const Vec3& offset) {
    const auto parts = components(mesh);
    assert(parts.size() == 1 && parts[0].euler_characteristic == 2);
    assert(is_within(parts[0].volume, std::pow(scale, 3) * ball_volume(1), 0.03));
    for(const Vec3& p : mesh.vertices)
      assert(std::abs(((p - offset) / scale).norm() - 1) < 0.75 * unit);  // independent samples leave gaps of 3 units
    assert(is_within(static_cast<double>(mesh.vertices.size()),
                     static_cast<double>(reference.vertices.size()), 0.1));
  };
  check(reference, 1, Vec3::Zero());

  // Repeated calls give the same bits, even with other allocations in between.
  const std::vector<std::vector<double>> elsewhere(777, std::vector<double>(333));
  const Triangle_mesh again = poisson_mesh(sample.points, sample.normals);
  assert(again.vertices == reference.vertices && again.faces == reference.faces);

  for(double scale : {1e-4, 1., 1e5}) {
    for(const Vec3& direction : {Vec3(0, 0, 0), Vec3(1, -1, 1)}) {
      // Coordinates as large as in a map's metres, with enough digits left for the shape.
      const Vec3 offset = 4e6 * std::max(scale, 1e-2) * direction;
      std::vector<Vec3> points;
      for(const Vec3& p : sample.points)
        points.push_back(scale * p + offset);
      check(poisson_mesh(points, sample.normals), scale, offset);
    }
  }
  // The length of the normals says nothing, nor do copies of points.
  Sample copies = sample;
  for(Vec3& n : copies.normals)
    n *= 1e-9;
  copies.points.insert(copies.points.end(), sample.points.begin(), sample.points.end());
  copies.normals.insert(copies.normals.end(), sample.normals.begin(), sample.normals.end());
  check(poisson_mesh(copies.points, copies.normals), 1, Vec3::Zero());
}

void a_torus_has_its_hole()
{
  const Sample sample = torus(1, 0.4, 6000);
  const double unit = spacing(4 * EIGEN_PI * EIGEN_PI * 0.4, 6000);
  const Triangle_mesh mesh = poisson_mesh(sample.points, sample.normals);
  const auto parts = components(mesh);
  assert(parts.size() == 1 && parts[0].euler_characteristic == 0);
  assert(is_within(parts[0].volume, 2 * EIGEN_PI * EIGEN_PI * 0.16, 0.04));
  for(const Vec3& p : mesh.vertices)
    assert(std::abs(distance_to_torus(p, 1, 0.4)) < 0.5 * unit);

  // A finer mesh is closer.
  Poisson_options fine;
  fine.distance = 0.1;
  const auto fine_parts = components(poisson_mesh(sample.points, sample.normals, fine));
  assert(is_within(fine_parts[0].volume, 2 * EIGEN_PI * EIGEN_PI * 0.16, 0.01));

  // Half of it is closed somehow, but close to the data.
  Sample half;
  for(std::size_t i = 0; i < sample.points.size(); ++i) {
    if(sample.normals[i].z() > 0) {
      half.points.push_back(sample.points[i]);
      half.normals.push_back(sample.normals[i]);
    }
  }
  const Triangle_mesh closed = poisson_mesh(half.points, half.normals);
  for(const Component& part : components(closed))
    assert(part.volume > 0);
  for(std::size_t i = 0; i < half.points.size(); i += 10) {
    double nearest = std::numeric_limits<double>::infinity();
    for(const Vec3& p : closed.vertices)
      nearest = std::min(nearest, (p - half.points[i]).norm());
    assert(nearest < 6 * unit);
  }
}

void regular_samples_have_flat_tetrahedra()
{
  // Rings around a torus: all neighbours are cospherical.
  Sample sample;
  const int rings = 120, sides = 40;
  for(int i = 0; i < rings; ++i) {
    for(int j = 0; j < sides; ++j) {
      const double u = 2 * EIGEN_PI * i / rings, v = 2 * EIGEN_PI * j / sides;
      const Vec3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      sample.points.push_back(Vec3(std::cos(u), std::sin(u), 0) + 0.3 * n);
      sample.normals.push_back(n);
    }
  }
  Poisson_options fine;
  fine.distance = 0.1;
  const auto parts = components(poisson_mesh(sample.points, sample.normals, fine));
  assert(parts.size() == 1 && parts[0].euler_characteristic == 0);
  assert(is_within(parts[0].volume, 2 * EIGEN_PI * EIGEN_PI * 0.09, 0.04));
}

void no_component_is_lost()
{
  // A large sphere, and 20 small ones around it that few rays would hit.
  Sample sample;
  add_sphere(sample, Vec3::Zero(), 1, 4000);
  Random_numbers random(5);
  std::vector<Vec3> centres;
  while(centres.size() < 20) {
    const Vec3 c = 1.6 * random.direction();
    if(std::all_of(centres.begin(), centres.end(),
                   [&](const Vec3& other) { return (c - other).norm() > 0.4; }))
      centres.push_back(c);
  }
  for(const Vec3& c : centres)
    add_sphere(sample, c, 0.12, 100);
  const auto parts = components(poisson_mesh(sample.points, sample.normals));
  assert(parts.size() == 21);
  assert(is_within(parts[0].volume, ball_volume(1), 0.04));
  // The function has one level for all, at which small bodies are too thin.
  for(std::size_t i = 1; i < parts.size(); ++i)
    assert(parts[i].volume > 0.3 * ball_volume(0.12) && parts[i].volume < 1.1 * ball_volume(0.12));
}

void cavities_face_inwards()
{
  Sample sample;
  add_sphere(sample, Vec3::Zero(), 1, 4000);
  add_sphere(sample, Vec3::Zero(), 0.5, 1500, -1);
  const auto parts = components(poisson_mesh(sample.points, sample.normals));
  assert(parts.size() == 2);
  assert(is_within(parts[0].volume, ball_volume(1), 0.06));
  assert(is_within(parts[1].volume, -ball_volume(0.5), 0.1));
}

void outliers_are_survived()
{
  Sample sample;
  add_sphere(sample, Vec3::Zero(), 1, 2000);
  Random_numbers random(3);
  for(int i = 0; i < 1000; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    sample.points.push_back(3 * Vec3(x - 0.5, y - 0.5, z - 0.5));
    sample.normals.push_back(random.direction());
  }
  const Triangle_mesh mesh = poisson_mesh(sample.points, sample.normals);
  assert(components(mesh)[0].volume > 2);
}

void what_cannot_be_refined_is_taken_from_the_tetrahedra()
{
  Sample sample;
  add_sphere(sample, Vec3::Zero(), 1, 600);
  Poisson_options never_reached;
  never_reached.distance = 1e-9;
  const auto parts = components(poisson_mesh(sample.points, sample.normals, never_reached));
  assert(parts.size() == 1 && parts[0].euler_characteristic == 2);
  assert(is_within(parts[0].volume, ball_volume(1), 0.05));
}

void bad_input_is_named()
{
  const auto message = [](const Sample& sample) -> std::string {
    try {
      poisson_mesh(sample.points, sample.normals);
    } catch(const Method_error& error) {
      return error.what();
    }
    return "";
  };
  const auto names = [&](const Sample& sample, const std::string& cause) {
    const std::string text = message(sample);
    return text.find("poisson_mesh") == 0 && text.find(cause) != std::string::npos
           && text.find('\n') == std::string::npos;
  };
  Sample good;
  add_sphere(good, Vec3::Zero(), 1, 500);
  assert(message(good).empty());

  assert(names(Sample(), "fewer than 4 points"));
  Sample bad = good;
  bad.normals.pop_back();
  assert(names(bad, "499 normals"));
  bad = good;
  bad.points[7].y() = std::numeric_limits<double>::quiet_NaN();
  assert(names(bad, "point 7"));
  bad = good;
  bad.normals[8].setZero();
  assert(names(bad, "normal 8 has length zero"));
  bad = good;
  bad.normals[9].x() = std::numeric_limits<double>::infinity();
  assert(names(bad, "normal 9"));
  bad = good;
  for(Vec3& p : bad.points)
    p = good.points.front();
  assert(names(bad, "distinct"));
  // Flat, also when rounding makes it not quite so.
  const Eigen::Matrix3d turn
      = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for(bool tilted : {false, true}) {
    bad = good;
    for(Vec3& p : bad.points) {
      p.z() = 0;
      if(tilted)
        p = turn * p + Vec3(100, 200, 300);
    }
    assert(names(bad, "plane"));
  }
}

/// A grid of `around` x `across` quadrilaterals, cut in two.
Triangle_mesh torus_mesh(double major, double minor, std::size_t around, std::size_t across)
{
  Triangle_mesh mesh;
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t k = 0; k < across; ++k) {
      const double u = 2 * EIGEN_PI * double(i) / double(around), v = 2 * EIGEN_PI * double(k) / double(across);
      const double r = major + minor * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
      const std::size_t a = i * across + k, b = (i + 1) % around * across + k;
      const std::size_t c = (i + 1) % around * across + (k + 1) % across, d = i * across + (k + 1) % across;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  return mesh;
}

void append(Triangle_mesh& mesh, const Triangle_mesh& other, const Vec3& offset)
{
  const std::size_t first = mesh.vertices.size();
  for(const Vec3& p : other.vertices)
    mesh.vertices.push_back(p + offset);
  for(const auto& f : other.faces)
    mesh.faces.push_back({first + f[0], first + f[1], first + f[2]});
}

void small_handles_are_parted_or_filled()
{
  // a ring is cut where it is thinnest; its volume is that of the ring
  Triangle_mesh ring = torus_mesh(1, 0.25, 96, 24);
  const Triangle_mesh whole = ring;
  const double around_tube = 2 * EIGEN_PI * 0.25, volume = 2 * EIGEN_PI * EIGEN_PI * 0.25 * 0.25;
  assert(support::remove_small_handles(ring, 0.9 * around_tube) == 0);
  assert(ring.vertices == whole.vertices && ring.faces == whole.faces);
  assert(support::remove_small_handles(ring, 1.1 * around_tube) == 1);
  std::vector<Component> parts = components(ring);
  assert(parts.size() == 1 && parts[0].euler_characteristic == 2);
  assert(is_within(parts[0].volume, volume, 0.05));

  // a narrow hole is filled where it is narrowest, and nowhere else
  Triangle_mesh bun = torus_mesh(1, 0.8, 96, 96);
  const double bun_volume = components(bun)[0].volume, through_hole = 2 * EIGEN_PI * 0.2;
  assert(support::remove_small_handles(bun, 0.9 * through_hole) == 0);
  assert(support::remove_small_handles(bun, 1.1 * through_hole) == 1);
  parts = components(bun);
  assert(parts.size() == 1 && parts[0].euler_characteristic == 2);
  assert(parts[0].volume > bun_volume && is_within(parts[0].volume, bun_volume, 0.01));
  assert(!bun.vertices.empty() && std::any_of(bun.vertices.begin(), bun.vertices.end(), [](const Vec3& p) {
    return std::hypot(p.x(), p.y()) < 0.02 && std::abs(p.z()) < 0.2;
  }));

  // of several components and handles only the small ones go, whatever the order
  Triangle_mesh several = torus_mesh(1, 0.25, 96, 24);
  append(several, torus_mesh(0.1, 0.025, 48, 12), Vec3(3, 0, 0));
  append(several, torus_mesh(0.1, 0.08, 48, 48), Vec3(0, 3, 0));
  assert(support::remove_small_handles(several, 0.9 * around_tube) == 2);
  parts = components(several);
  assert(parts.size() == 3 && parts[0].euler_characteristic == 0 && parts[1].euler_characteristic == 2
         && parts[2].euler_characteristic == 2);

  // noise as wide as half of the tube hides it, a tenth of that does not
  Triangle_mesh noisy = whole;
  assert(support::remove_handles_of_noise(noisy, 0) == 0 && support::remove_handles_of_noise(noisy, 0.025) == 0);
  assert(support::remove_handles_of_noise(noisy, 0.25) == 1);
}

}  // namespace

int main()
{
  a_sphere_in_any_unit_and_place();
  a_torus_has_its_hole();
  regular_samples_have_flat_tetrahedra();
  no_component_is_lost();
  cavities_face_inwards();
  outliers_are_survived();
  what_cannot_be_refined_is_taken_from_the_tetrahedra();
  bad_input_is_named();
  small_handles_are_parted_or_filled();
  std::cout << "Poisson meshing: all facts hold" << std::endl;
  return EXIT_SUCCESS;
}
