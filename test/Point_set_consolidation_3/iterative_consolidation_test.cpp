// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts of known geometry about the iterative consolidation and its operators.

#undef NDEBUG

#include "random_numbers.h"

#include <CGAL/Point_set_consolidation_3/internal/algebraic_sphere.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>
#include <CGAL/Point_set_consolidation_3/internal/hermite_surface.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/placement_guard.h>
#include <CGAL/Point_set_consolidation_3/internal/sphere_directions.h>
#include <CGAL/iterative_consolidate_point_set.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <Eigen/QR>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef std::vector<Oriented_point> Oriented_points;
typedef CGAL::First_of_pair_property_map<Oriented_point> Point_map;
typedef CGAL::Second_of_pair_property_map<Oriented_point> Normal_map;

namespace core = CGAL::Point_set_consolidation_3::internal;
namespace params = CGAL::Point_set_consolidation_3::parameters;
using benchmark::Random_numbers;
using core::Vec3;

namespace {

auto maps() { return params::point_map(Point_map()).normal_map(Normal_map()); }

Point to_point(const Vec3& p) { return Point(p.x(), p.y(), p.z()); }
Vector to_vector(const Vec3& v) { return Vector(v.x(), v.y(), v.z()); }
Vec3 to_vec3(const Point& p) { return Vec3(p.x(), p.y(), p.z()); }
Vec3 to_vec3(const Vector& v) { return Vec3(v.x(), v.y(), v.z()); }

/// Points of an ellipsoid with semi-axes 1, 0.7, 0.5, outside of a ball around its pole.
Oriented_points ellipsoid(std::size_t n, double hole, double noise = 0)
{
  Random_numbers random(7);
  Oriented_points points;
  while(points.size() < n) {
    const Vec3 d = random.direction();
    const Vec3 p(d.x(), 0.7 * d.y(), 0.5 * d.z());
    const Vec3 normal = Vec3(d.x(), d.y() / 0.7, d.z() / 0.5).normalized();
    const double shift = noise * random.uniform(-1, 1);
    if((p - Vec3(0, 0, 0.5)).norm() > hole)
      points.emplace_back(to_point(p + shift * normal), to_vector(normal));
  }
  return points;
}

double ellipsoid_distance(const Vec3& p)
{
  const Vec3 q(p.x(), p.y() / 0.7, p.z() / 0.5);
  const Vec3 gradient = 2 * Vec3(q.x(), q.y() / 0.7, q.z() / 0.5);
  return std::abs(q.squaredNorm() - 1) / gradient.norm();  // to first order
}

void closed_form_is_the_least_squares_fit()
{
  Random_numbers random(7);
  for(int trial = 0; trial < 50; ++trial) {
    const double h = std::pow(10., random.uniform(-1, 1) * 3), offset = trial % 2 == 0 ? 0 : 1e4 * h;
    const Vec3 x = offset * random.direction();
    constexpr int n = 12;
    Eigen::MatrixXd D(4 * n, 5);
    Eigen::VectorXd b(4 * n);
    core::Algebraic_sphere_fit fit(x, h);
    for(int i = 0; i < n; ++i) {
      const Vec3 y = random.uniform() * random.direction(), normal = random.direction();
      const double w = random.uniform() + 0.1, root = std::sqrt(w), beta = 1e12;
      fit.add(w, h * y, normal);
      D.row(4 * i) << root, root * y.transpose(), root * y.squaredNorm();
      b[4 * i] = 0;
      for(int k = 0; k < 3; ++k) {
        Eigen::Matrix<double, 1, 5> row;
        row << 0, Vec3(Vec3::Unit(k)).transpose(), 2 * y[k];
        D.row(4 * i + 1 + k) = std::sqrt(beta) * root * row;
        b[4 * i + 1 + k] = std::sqrt(beta) * root * normal[k];
      }
    }
    const Eigen::VectorXd u = D.colPivHouseholderQr().solve(b);
    const core::Algebraic_sphere sphere = fit.sphere();
    assert((u.segment<3>(1) - sphere.u).norm() < 1e-9);
    assert(std::abs(u[4] - sphere.u4) < 1e-9);
    assert(std::abs(u[0] - sphere.u0) < 1e-9);
  }
}

void algebraic_surface_is_exact_on_spheres_and_planes()
{
  Random_numbers random(7);
  const Vec3 centre(100, -50, 20);
  Oriented_points sphere, plane;
  for(int i = 0; i < 500; ++i) {
    const Vec3 d = random.direction();
    sphere.emplace_back(to_point(centre + 2 * d), to_vector(d));
    plane.emplace_back(Point(random.uniform(), random.uniform(), 3), Vector(0, 0, 1));
  }
  const CGAL::Algebraic_point_set_surface_3<Kernel> on_sphere(sphere,
                                                              maps().neighbor_radius(1.));
  const CGAL::Algebraic_point_set_surface_3<Kernel> on_plane(plane, maps().neighbor_radius(0.5));
  assert(on_sphere.support_radius() > 0.999999 && on_sphere.support_radius() < 1.000001);
  for(int i = 0; i < 100; ++i) {
    const Vec3 d = random.direction();
    const Point query = to_point(centre + (2 + 0.3 * random.uniform(-1, 1)) * d);
    const double distance = (to_vec3(query) - centre).norm() - 2;
    assert((to_vec3(*on_sphere.project(query)) - (centre + 2 * d)).norm() < 1e-9);
    assert(std::abs(*on_sphere.signed_distance(query) - distance) < 1e-9);
    assert(std::abs(on_sphere.fit(query)->curvature - 0.5) < 1e-9);
    assert(to_vec3(*on_sphere.gradient(query)).normalized().dot(d) > 1 - 1e-9);

    const Point above(0.2 + 0.6 * random.uniform(), 0.2 + 0.6 * random.uniform(), 3 + 0.3 * random.uniform(-1, 1));
    assert(std::abs(on_plane.project(above)->z() - 3) < 1e-12);
    assert(std::abs(*on_plane.signed_distance(above) - (above.z() - 3)) < 1e-12);
  }
  assert(!on_sphere.project(to_point(centre)));  // no points in the support

  Oriented_points noisy = ellipsoid(4000, 0, 0.01);
  const std::size_t moved = CGAL::apss_project_point_set<CGAL::Sequential_tag>(
    noisy, maps().neighbor_radius(0.2));
  double mean = 0;
  for(const Oriented_point& p : noisy)
    mean += ellipsoid_distance(to_vec3(p.first)) / double(noisy.size());
  assert(moved == noisy.size());
  assert(mean < 0.0015);  // 0.005 before
}

void rotation_is_exact()
{
  core::Algebraic_sphere_fit fit(Vec3(3, 0, 0), 1.);
  Random_numbers random(7);
  for(int i = 0; i < 20; ++i) {  // the unit sphere around the origin, far from where it is fitted
    const Vec3 d = random.direction();
    fit.add(1, d - Vec3(3, 0, 0), d);
  }
  const core::Algebraic_sphere sphere = fit.sphere();
  const Vec3 moved = sphere.slide(Vec3(0, 0, 1), Vec3(0.7, 0, 0));
  assert((moved - Vec3(std::sin(0.7), 0, std::cos(0.7))).norm() < 1e-9);
}

void wlop_is_accurate_and_even_and_static_particles_stay()
{
  const Oriented_points noisy = ellipsoid(6000, 0, 0.01);
  std::vector<Point> particles;
  CGAL::wlop_project_point_set<CGAL::Sequential_tag>(
    noisy, std::back_inserter(particles), maps().number_of_output_points(600));
  assert(particles.size() == 600);
  double mean = 0;
  for(const Point& p : particles)
    mean += ellipsoid_distance(to_vec3(p)) / 600;
  assert(mean < 0.003);  // 0.005 before

  core::Points positions;
  for(const Point& p : particles)
    positions.push_back(to_vec3(p));
  const core::Execution sequential;
  const std::vector<double> distances = core::neighbor_distances(
    sequential, core::Nearest_neighbors(positions), positions, 1);
  const double spacing = core::mean(distances);
  double variance = 0;
  for(const double d : distances)
    variance += (d - spacing) * (d - spacing) / 600;
  assert(std::sqrt(variance) < 0.2 * spacing);  // random points: 0.52

  // a static particle pushes a moving one away
  const std::vector<Point> start(1, noisy.front().first), fixed(1, noisy[0].first);
  std::vector<Point> alone, pushed;
  CGAL::wlop_project_point_set<CGAL::Sequential_tag>(
    noisy, std::back_inserter(alone), maps().initial_sample(start).neighbor_radius(0.4));
  Vec3 beside = to_vec3(alone[0]) + Vec3(0.02, 0.02, 0);
  const std::vector<Point> neighbor(1, to_point(beside));
  CGAL::wlop_project_point_set<CGAL::Sequential_tag>(
    noisy, std::back_inserter(pushed),
    maps().initial_sample(start).static_sample(std::cref(neighbor)).neighbor_radius(0.4));
  assert(alone.size() == 1 && pushed.size() == 1);
  assert((to_vec3(pushed[0]) - beside).norm() > (to_vec3(alone[0]) - beside).norm() + 0.02);
}

void mean_shift_finds_far_outliers()
{
  Random_numbers random(7);
  Oriented_points points = ellipsoid(2000, 0);
  constexpr std::size_t far = 20;
  for(std::size_t i = 0; i < far; ++i)
    points.emplace_back(to_point(4 * random.direction()), Vector(0, 0, 1));
  Oriented_points kept;
  std::vector<std::size_t> outliers;
  CGAL::mean_shift_remove_outliers<CGAL::Sequential_tag>(
    points, std::back_inserter(kept),
    maps().outlier_output_iterator(std::back_inserter(outliers)));
  assert(kept.size() + outliers.size() == points.size());
  assert(outliers.size() == far);
  for(const std::size_t i : outliers)
    assert(i >= 2000);
}

/// Evenly spread points of the unit sphere around `centre`, below the height `top`.
Oriented_points spiral(std::size_t n, double top, const Vec3& centre)
{
  Oriented_points points;
  for(std::size_t i = 0; i < n; ++i) {
    const Vec3 d = core::sphere_direction(i, n);
    if(d.z() < top)
      points.emplace_back(to_point(centre + d), to_vector(d));
  }
  return points;
}

void repulsion_extends_the_sphere()
{
  const Vec3 centre(100, 100, 100);  // away from the origin: the misprint of equation (1) would show
  Oriented_points points = spiral(1000, 0.8, centre);
  const Oriented_points before = points;
  double highest = 0, highest_before = 0;
  const double moved = CGAL::repulse_along_apss<CGAL::Sequential_tag>(points, maps());
  assert(moved > 0);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = to_vec3(points[i].first) - centre;
    assert(std::abs(p.norm() - 1) < 1e-6);
    assert(to_vec3(points[i].second).dot(p.normalized()) > 1 - 1e-6);
    highest = (std::max)(highest, p.z());
    highest_before = (std::max)(highest_before, to_vec3(before[i].first).z() - centre.z());
  }
  assert(highest_before < 0.8 && highest > 0.86);

  // one printed step hardly advances
  Oriented_points printed = before;
  CGAL::repulse_along_apss<CGAL::Sequential_tag>(printed, maps().printed_values(true));
  double highest_printed = 0;
  for(const Oriented_point& p : printed)
    highest_printed = (std::max)(highest_printed, p.first.z() - centre.z());
  assert(highest_printed < 0.82);
}

void upsampling_is_exact_to_second_order()
{
  const Oriented_points points = spiral(1000, 2, Vec3(5, 0, 0));
  Oriented_points added;
  CGAL::interpolatory_upsample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(added),
                                                               maps());
  assert(added.size() > 2 * points.size());
  for(const Oriented_point& p : added)
    assert(std::abs((to_vec3(p.first) - Vec3(5, 0, 0)).norm() - 1) < 2e-4);

  Oriented_points none;
  CGAL::interpolatory_upsample_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(none), maps().minimum_spacing(0.2));
  assert(none.empty());
}

void bilateral_projection_keeps_an_edge()
{
  // two half planes at a right angle, with noise along their normals
  Random_numbers random(7);
  Oriented_points points;
  for(int i = 0; i < 8000; ++i) {
    const double u = random.uniform(), v = random.uniform(), noise = 0.004 * random.uniform(-1, 1);
    if(i % 2 == 0)
      points.emplace_back(Point(u, v, noise), Vector(0, 0, 1));
    else
      points.emplace_back(Point(noise, v, -u), Vector(-1, 0, 0));
  }
  CGAL::bilateral_project_point_set<CGAL::Sequential_tag>(points, maps().neighbor_radius(0.08));
  double mean = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    mean += std::abs(i % 2 == 0 ? points[i].first.z() : points[i].first.x()) / 8000;
  assert(mean < 0.0007);  // 0.002 before
}

void closes_a_large_hole(bool with_normals)
{
  const Oriented_points points = ellipsoid(10000, 0.35);
  Oriented_points result;
  std::vector<bool> is_new;
  std::vector<double> confidence;
  std::size_t inconsistent = 0;
  const auto outputs = params::completed_output_iterator(std::back_inserter(is_new))
                         .confidence_output_iterator(std::back_inserter(confidence))
                         .inconsistent_neighbors(std::ref(inconsistent))
                         .point_map(Point_map());
  if(with_normals)
    CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
      points, std::back_inserter(result), outputs.normal_map(Normal_map()));
  else
    CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result),
                                                                outputs);
  assert(result.size() == is_new.size() && result.size() == confidence.size());
  assert(inconsistent == 0);
  std::size_t kept = 0, wrong = 0, added = 0;
  double error = 0;
  for(std::size_t i = 0; i < result.size(); ++i) {
    const Vec3 p = to_vec3(result[i].first), n = to_vec3(result[i].second);
    wrong += n.dot(Vec3(p.x(), p.y() / 0.49, p.z() / 0.25)) < 0;
    if(!is_new[i]) {
      assert(confidence[i] == 1);
      ++kept;
      continue;
    }
    assert(confidence[i] > 0 && confidence[i] <= 1);
    assert((p - Vec3(0, 0, 0.5)).norm() < 0.45);  // in the hole
    error += ellipsoid_distance(p);
    ++added;
  }
  assert(kept == points.size() && wrong == 0 && added > 100);
  assert(error / double(added) < 0.015);  // 0.6 % of the diagonal
  for(std::size_t i = 0; i < kept; ++i)
    assert(result[i].first == points[i].first);

  // every place in the hole has a point near it
  Random_numbers random(7);
  std::size_t covered = 0, places = 0;
  core::Points positions;
  for(const Oriented_point& p : result)
    positions.push_back(to_vec3(p.first));
  const core::Nearest_neighbors tree(positions);
  for(int i = 0; i < 20000; ++i) {
    const Vec3 d = random.direction(), p(d.x(), 0.7 * d.y(), 0.5 * d.z());
    if((p - Vec3(0, 0, 0.5)).norm() > 0.35)
      continue;
    ++places;
    covered += tree.nearest(p).squared_distance < 0.05 * 0.05;
  }
  assert(double(covered) > 0.95 * double(places));
}

void open_sheets_are_not_extended()
{
  Random_numbers random(7);
  std::vector<Point> sheet;
  for(int i = 0; i < 3000; ++i)
    sheet.emplace_back(random.uniform(), random.uniform(), 0.);
  Oriented_points result;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(sheet, std::back_inserter(result));
  assert(result.size() == sheet.size());
}

// Indices of the outliers that iterative consolidation finds without normals.
std::vector<std::size_t> outliers_of(const Oriented_points& points)
{
  Oriented_points result;
  std::vector<std::size_t> outliers;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result),
    params::point_map(Point_map()).outlier_output_iterator(std::back_inserter(outliers)));
  return outliers;
}

void reports_outliers_and_keeps_the_static_region()
{
  Random_numbers random(7);
  Oriented_points points = ellipsoid(5000, 0.);
  constexpr std::size_t number = 250;
  for(std::size_t i = 0; i < number; ++i)
    points.emplace_back(Point(2 * random.uniform(-1, 1), 2 * random.uniform(-1, 1),
                              2 * random.uniform(-1, 1)), Vector(0, 0, 1));
  const std::vector<std::size_t> outliers = outliers_of(points);
  std::size_t found = 0;
  for(const std::size_t i : outliers)
    found += i >= 5000;
  assert(found >= 0.95 * number && double(found) >= 0.99 * double(outliers.size()));

  // constrained points are never removed
  Oriented_points result;
  std::vector<std::size_t> others;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result),
    params::point_map(Point_map())
      .point_is_constrained_map(CGAL::Constant_property_map<Oriented_point, bool>(true))
      .outlier_output_iterator(std::back_inserter(others)));
  assert(others.empty() && result.size() == points.size());  // nothing moves, nothing is added
}

/// Outliers in a layer around the surface, closer to it than h.
void finds_outliers_near_the_surface()
{
  constexpr std::size_t number = 500;
  constexpr double layer = 0.08, farther = 0.02;  // diagonal 2.6
  Random_numbers random(11);
  Oriented_points points = ellipsoid(20 * number, 0.);
  for(std::size_t i = 0; i < number; ++i) {
    Point& p = points[i].first;
    p = p + layer * Vector(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  const std::vector<std::size_t> outliers = outliers_of(points);
  const auto is_off = [&](std::size_t i) { return ellipsoid_distance(to_vec3(points[i].first)) > farther; };
  std::size_t all = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    all += is_off(i);
  const auto found = std::size_t(std::count_if(outliers.begin(), outliers.end(), is_off));
  assert(double(found) >= 0.85 * double(all) && double(found) >= 0.97 * double(outliers.size()));
}

// A small part that was seen apart has no particles of its own; it is as dense and as smooth as the rest, unlike the
// scattered points around.
void keeps_small_parts_seen_apart()
{
  constexpr std::size_t number = 10000, part = 48, scattered = 100;
  Random_numbers random(12);
  Oriented_points points = ellipsoid(number, 0.);
  const double spacing = std::sqrt(6.8 / double(number));  // of the ellipsoid
  for(std::size_t i = 0; i < part; ++i)
    points.emplace_back(Point(2.5, spacing * double(i % 12), spacing * double(i / 12)), Vector(1, 0, 0));
  for(std::size_t i = 0; i < scattered; ++i)
    points.emplace_back(Point(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(2.2, 3)), Vector(1, 0, 0));
  const std::vector<std::size_t> outliers = outliers_of(points);
  std::size_t found = 0;
  for(const std::size_t i : outliers) {
    assert(i < number || i >= number + part);
    found += i >= number;
  }
  assert(found == scattered);
}

void options_run_and_results_do_not_depend_on_the_frame_or_threads()
{
  const Oriented_points points = ellipsoid(4000, 0.35);
  Oriented_points first, moved, other;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(points, std::back_inserter(first),
                                                              maps());
  assert(first.size() > points.size());
  Oriented_points far = points;
  for(Oriented_point& p : far)
    p.first = Point(1e-3 * p.first.x() + 7, 1e-3 * p.first.y() - 3, 1e-3 * p.first.z());
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(far, std::back_inserter(moved),
                                                              maps());
  assert(std::abs(double(moved.size()) - double(first.size())) < 0.02 * double(first.size()));
#ifdef CGAL_LINKED_WITH_TBB
  CGAL::iterative_consolidate_point_set<CGAL::Parallel_tag>(points, std::back_inserter(other),
                                                            maps());
  assert(other == first);
#endif
  for(const bool adaptive : {false, true}) {
    other.clear();
    CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
      points, std::back_inserter(other), maps().adaptive(adaptive).two_phases(true));
    assert(other.size() > points.size());
  }
  other.clear();
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(other), maps().printed_values(true));
  const auto near_the_pole = [](const Oriented_points& set) {
    std::size_t count = 0;
    for(const Oriented_point& p : set)
      count += (to_vec3(p.first) - Vec3(0, 0, 0.5)).norm() < 0.15;
    return count;
  };
  assert(near_the_pole(other) < near_the_pole(first));  // the printed steps do not close the hole
}

void callback_is_monotone_and_cancels()
{
  const Oriented_points points = ellipsoid(3000, 0.3);
  double last = 0;
  Oriented_points result;
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result), maps().callback([&](double f) {
      assert(f >= last && f <= 1);
      last = f;
      return true;
    }));
  assert(last == 1 && result.size() >= points.size());
  result.clear();
  CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result), maps().callback([](double f) { return f < 0.5; }));
  assert(result.empty());
}

void degenerate_input_is_handled()
{
  Random_numbers random(7);
  std::vector<std::vector<Point> > sets;
  sets.push_back(std::vector<Point>(1, Point(1, 2, 3)));
  sets.push_back({Point(0, 0, 0), Point(1, 0, 0)});
  sets.push_back(std::vector<Point>(1500, Point(1, 1, 1)));
  sets.emplace_back();
  for(int i = 0; i < 300; ++i)
    sets.back().emplace_back(i * 0.1, 0., 0.);  // a line
  sets.emplace_back();
  for(int i = 0; i < 600; ++i)
    sets.back().emplace_back(random.uniform(), random.uniform(), random.uniform());  // a volume
  sets.emplace_back();
  for(int i = 0; i < 15; ++i)
    sets.back().emplace_back(random.uniform(), random.uniform(), random.uniform());
  for(const std::vector<Point>& set : sets) {
    Oriented_points result;
    CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(set, std::back_inserter(result));
    assert(!result.empty());
    for(const Oriented_point& p : result)
      assert(to_vec3(p.first).allFinite() && std::abs(to_vec3(p.second).norm() - 1) < 1e-6);
  }
  for(const double bad : {std::nan(""), 1. / 0.}) {
    const std::vector<Point> set(30, Point(bad, 0, 0));
    bool thrown = false;
    Oriented_points result;
    try {
      CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(set, std::back_inserter(result));
    }
    catch(const std::invalid_argument&) {
      thrown = true;
    }
    assert(thrown && result.empty());
  }
}

/// A hole of a plane, of radius 0.7 h, filled: what is added is kept if the data close around it.
void only_holes_with_data_all_around_are_filled()
{
  constexpr double h = 1, hole = 0.7, spacing = 0.05;
  const auto is_filling_kept = [&](double opening) {
    core::Points data, filling;
    for(int i = -40; i <= 40; ++i)
      for(int j = -40; j <= 40; ++j) {
        const Vec3 p(i * spacing, j * spacing, 0);
        if(p.norm() < hole)
          filling.push_back(p);
        else if(std::abs(std::atan2(p.y(), p.x())) > opening / 2)
          data.push_back(p);
      }
    const core::Points normals(data.size(), Vec3::UnitZ());
    const core::Free_space space;
    const core::Placement_guard guard(data, normals, space, h, core::Guard_parameters());
    const core::Execution execution = {false, core::Progress(), {}};
    std::vector<core::Index> region(filling.size());
    std::iota(region.begin(), region.end(), core::Index(0));
    return !guard.doubtful_regions(execution, filling, core::Points(filling.size(), Vec3::UnitZ()), {region},
                                   filling.size()).front();
  };
  const double degree = 3.14159265358979324 / 180;
  assert(is_filling_kept(0) && is_filling_kept(60 * degree));
  assert(!is_filling_kept(120 * degree) && !is_filling_kept(180 * degree));
}

/// Points and normals are interpolated, planes reproduced, and a sphere's missing cap hardly missed.
void hermite_surface_goes_on_where_points_are_missing()
{
  Random_numbers random(5);
  core::Points cap, normals, plane;
  while(cap.size() < 100) {
    const Vec3 d = random.direction();
    if(d.z() < 0.3 || d.z() > 0.8)
      continue;
    cap.push_back(Vec3(5, -3, 2) + 2 * d);
    normals.push_back(d);
    plane.push_back(Vec3(d.x(), d.y(), 7));
  }
  const core::Hermite_surface sphere(cap, normals), flat(plane, core::Points(plane.size(), Vec3::UnitZ()));
  for(std::size_t i = 0; i < cap.size(); ++i) {
    Vec3 x = cap[i] + 0.05 * random.direction(), n;
    assert(sphere.project(x, n) && std::abs((x - Vec3(5, -3, 2)).norm() - 2) < 0.02);
    x = cap[i];
    assert(sphere.project(x, n) && (x - cap[i]).norm() < 1e-6 && (n - normals[i]).norm() < 1e-6);
    x = Vec3(3, 1, 7.5);
    assert(flat.project(x, n) && std::abs(x.z() - 7) < 1e-5 && (n - Vec3::UnitZ()).norm() < 1e-5);
  }
  Vec3 pole(5, -3, 3.9), normal;
  assert(sphere.project(pole, normal) && std::abs(pole.z() - 4) < 0.04 && normal.z() > 0.999);
  // it knows how far off it is likely to be: not at all at a point, most in the middle of the hole
  const double deviation = sphere.deviation(pole);
  assert(sphere.deviation(cap[0]) < 1e-3 && deviation > 0.5 * std::abs(pole.z() - 4) && deviation < 0.2);
}

/// The end of the long axis is more curved than anything around the hole: growing along spheres cuts it off.
void fairing_restores_tips()
{
  Oriented_points points = ellipsoid(9000, 0.);
  const auto is_missing = [](const Oriented_point& p) { return (to_vec3(p.first) - Vec3(1, 0, 0)).norm() < 0.5; };
  points.erase(std::remove_if(points.begin(), points.end(), is_missing), points.end());
  const auto error = [&](bool fairing) {
    Oriented_points result;
    CGAL::iterative_consolidate_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result),
                                                                maps().hole_fairing(fairing));
    assert(result.size() > points.size() + 100);
    double sum = 0;
    for(std::size_t i = points.size(); i < result.size(); ++i)
      sum += ellipsoid_distance(to_vec3(result[i].first));
    return sum / double(result.size() - points.size());
  };
  const double grown = error(false), faired = error(true);
  assert(faired < 0.02 && faired < 0.7 * grown);
}

}  // namespace

int main()
{
#define RUN(FACT)                    \
  std::cout << #FACT << std::endl;   \
  FACT
  RUN(closed_form_is_the_least_squares_fit());
  RUN(algebraic_surface_is_exact_on_spheres_and_planes());
  RUN(rotation_is_exact());
  RUN(wlop_is_accurate_and_even_and_static_particles_stay());
  RUN(mean_shift_finds_far_outliers());
  RUN(repulsion_extends_the_sphere());
  RUN(upsampling_is_exact_to_second_order());
  RUN(bilateral_projection_keeps_an_edge());
  RUN(closes_a_large_hole(true));
  RUN(closes_a_large_hole(false));
  RUN(open_sheets_are_not_extended());
  RUN(only_holes_with_data_all_around_are_filled());
  RUN(hermite_surface_goes_on_where_points_are_missing());
  RUN(fairing_restores_tips());
  RUN(reports_outliers_and_keeps_the_static_region());
  RUN(finds_outliers_near_the_surface());
  RUN(keeps_small_parts_seen_apart());
  RUN(options_run_and_results_do_not_depend_on_the_frame_or_threads());
  RUN(callback_is_monotone_and_cancels());
  RUN(degenerate_input_is_handled());
  return EXIT_SUCCESS;
}
