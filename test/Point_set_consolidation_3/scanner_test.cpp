// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the functions do with what is known of the scanner, and what they find out where nothing is.

#undef NDEBUG

#include "scan_rays.h"

#include <CGAL/complete_point_set.h>
#include <CGAL/iterative_consolidate_point_set.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace params = CGAL::Point_set_consolidation_3::parameters;

typedef CGAL::Completed_point_3<Kernel> Completed_point;
typedef CGAL::Parallel_if_available_tag Tag;

/// Two views of a capsule, each from a point; directions as long as the way to it.
struct Two_views : Indexed_rays {
  std::vector<Point> scanners = {Point(4, 1, 0.5), Point(0.5, 4, 1)};

  Two_views()
  {
    const auto capsule = synthetic::capsule(Vec3(0, 0, -1), Vec3(0, 0, 1), 0.4);
    for(std::size_t k = 0; k < scanners.size(); ++k)
      for(const Vec3& p : synthetic::samples(capsule, 9000, 5 + k)) {
        const Vec3 d = vec3(scanners[k]) - p;
        if(capsule.normal(p).dot(d.normalized()) >= 0.15)
          add(p, d, int(k));
      }
  }
};

template <typename NP>
std::vector<Completed_point> completed(const std::vector<std::size_t>& range, const NP& np)
{
  std::vector<Completed_point> result;
  CGAL::complete_point_set<Tag>(range, std::back_inserter(result), np);
  return result;
}

void positions_are_as_good_as_directions()
{
  const Two_views scan;
  const auto np = params::point_map(scan.point_map()).view_index_map(scan.view_index_map());
  const auto by_position = completed(scan.indices, np.scanner_positions(scan.scanners));
  const auto by_direction = completed(scan.indices, np.view_direction_map(scan.view_direction_map()));
  assert(!by_position.empty() && by_position.size() == by_direction.size());
  for(std::size_t i = 0; i < by_position.size(); ++i)
    assert(by_position[i].outer() == by_direction[i].outer() && by_position[i].normal() == by_direction[i].normal());

  const auto error_of = [&](const auto& arguments) {
    try {
      completed(scan.indices, arguments);
    } catch(const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const auto says = [](const std::string& error, const std::string& cause) {
    return error.find("complete_point_set") == 0 && error.find(cause) != std::string::npos;
  };
  const std::vector<Point> none, one(1, scan.scanners[0]);
  const auto without_views = params::point_map(scan.point_map());
  assert(says(error_of(np.scanner_positions(none)), "scanner_positions is empty"));
  assert(says(error_of(np.scanner_positions(one)), "view_index_map has an index beyond scanner_positions"));
  assert(says(error_of(without_views.scanner_positions(scan.scanners)), "view_index_map"));
  const std::vector<int> negative(scan.points.size(), -1);
  assert(says(error_of(without_views.view_index_map(CGAL::make_property_map(negative)).scanner_positions(one)),
              "view_index_map is -1 for the point at index 0"));
  assert(!completed(scan.indices, without_views.scanner_positions(one)).empty());  // one scanner needs no views
}

/// An ellipsoid with a hole around its pole, and a floor inside that was seen through the hole.
void a_hole_that_was_looked_through_stays_open()
{
  constexpr double hole = 0.35, floor = -0.2;
  benchmark::Random_numbers random(7);
  Indexed_rays scan;
  std::vector<Vector> normals;
  const auto add = [&](const Vec3& p, const Vec3& normal) {
    scan.add(p, Vec3(0, 0, normal.z() > 0 ? 1 : -1), normal.z() > 0 ? 0 : 1);
    normals.emplace_back(normal.x(), normal.y(), normal.z());
  };
  while(scan.points.size() < 5000) {
    const Vec3 d = random.direction(), p(d.x(), 0.7 * d.y(), 0.5 * d.z());
    if((p - Vec3(0, 0, 0.5)).norm() > hole)
      add(p, Vec3(d.x(), d.y() / 0.7, d.z() / 0.5).normalized());
  }
  while(scan.points.size() < 5800) {
    const Vec3 p(random.uniform(-hole, hole), random.uniform(-hole, hole), floor);
    if(std::hypot(p.x(), p.y()) < 0.9 * hole)
      add(p, Vec3::UnitZ());
  }
  const auto points_in_hole = [&](const auto& np) {
    std::vector<Point_and_direction> result;
    CGAL::iterative_consolidate_point_set<Tag>(scan.indices, std::back_inserter(result), np);
    std::size_t count = 0;
    for(std::size_t k = scan.indices.size(); k < result.size(); ++k) {
      const Point& p = result[k].first;
      count += std::hypot(p.x(), p.y()) < 0.5 * hole && p.z() > 0.3;
    }
    return count;
  };
  const auto np = params::point_map(scan.point_map()).normal_map(CGAL::make_property_map(normals));
  const std::size_t unknown = points_in_hole(np);
  const std::size_t known =
    points_in_hole(np.view_direction_map(scan.view_direction_map()).view_index_map(scan.view_index_map()));
  std::cout << "points in a hole: " << unknown << ", with known rays " << known << std::endl;
  assert(unknown > 20 && known == 0);
}

/// One noisy view whose direction is not given.
void the_direction_of_one_view_is_found_and_its_noise_removed()
{
  const auto torus = synthetic::torus(1, 0.35);
  const synthetic::Scan exact = synthetic::scan(torus, {Vec3(0.3, 0.2, 1)}, 12000, 1);
  const double noise = 0.01 * torus.diagonal();
  benchmark::Random_numbers random(3);
  Indexed_rays scan;
  for(std::size_t i = 0; i < exact.points.size(); ++i)
    scan.add(exact.points[i] + noise * random.normal() * exact.directions[i], exact.directions[i]);
  std::vector<Point> denoised(scan.points.size());
  const auto result = completed(scan.indices, params::point_map(scan.point_map())
                                                .denoised_point_map(CGAL::make_property_map(denoised)));
  double before = 0, after = 0;
  for(const std::size_t i : scan.indices) {
    before += std::abs(torus.distance(vec3(scan.points[i]))) / double(scan.points.size());
    after += std::abs(torus.distance(vec3(denoised[i]))) / double(scan.points.size());
  }
  std::cout << "error of a noisy view " << 100 * before / torus.diagonal() << " %, denoised "
            << 100 * after / torus.diagonal() << " %" << std::endl;
  assert(after < 0.3 * before);
  assert(!result.empty());
}

/// Outliers within the noise of a view stand out when it is removed.
void outliers_that_noise_hides_are_found()
{
  const auto rod = synthetic::capsule(Vec3(-1.5, 0, 0), Vec3(1.5, 0, 0), 0.12);
  const synthetic::Scan exact = synthetic::scan(rod, {Vec3(0.3, 0.2, 1)}, 6000, 1);
  const double noise = 0.02 * rod.diagonal();
  constexpr std::size_t outliers = 300;
  benchmark::Random_numbers random(3);
  const Vec3 d = exact.directions[0];
  Indexed_rays scan;
  for(const Vec3& p : exact.points)
    scan.add(p + noise * random.normal() * d, d);
  for(std::size_t i = 0; i < outliers; ++i)
    scan.add(Vec3(random.uniform(-1.8, 1.8), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)), d);
  std::vector<std::size_t> found;
  std::vector<Point> denoised(scan.points.size());
  completed(scan.indices, params::point_map(scan.point_map())
                            .view_direction_map(scan.view_direction_map())
                            .denoised_point_map(CGAL::make_property_map(denoised))
                            .outlier_output_iterator(std::back_inserter(found)));
  assert(std::is_sorted(found.begin(), found.end()));
  const std::size_t mistaken =
    std::size_t(std::count_if(found.begin(), found.end(), [&](std::size_t i) { return i < exact.points.size(); }));
  std::size_t off = 0, left = 0;
  for(std::size_t i = exact.points.size(); i < scan.points.size(); ++i)
    if(!std::binary_search(found.begin(), found.end(), i)) {
      ++left;
      off += rod.distance(vec3(denoised[i])) > 0.05;
    }
  std::cout << left << " of " << outliers << " outliers left in noise, " << off << " of them off the surface; "
            << mistaken << " mistaken" << std::endl;
  assert(off <= 2);  // 11 without a second search after denoising
  assert(mistaken <= exact.points.size() / 200);
}

}  // namespace

int main()
{
  positions_are_as_good_as_directions();
  a_hole_that_was_looked_through_stays_open();
  the_direction_of_one_view_is_found_and_its_noise_removed();
  outliers_that_noise_hides_are_found();
  return EXIT_SUCCESS;
}
