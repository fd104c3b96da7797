// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Deep points consolidation and completion on shapes whose axes, sheets and surfaces are known.

#undef NDEBUG

#include "mirror_symmetry_cases.h"
#include "scan_rays.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_consolidation_3/internal/nearest_neighbors.h>
#include <CGAL/Point_set_consolidation_3/internal/view_estimation.h>
#include <CGAL/Point_set_consolidation_3/internal/working_boxes.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/complete_point_set.h>
#include <CGAL/deep_points_consolidate_point_set.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <boost/property_map/function_property_map.hpp>

#include <cassert>
#include <iostream>
#include <limits>

namespace {

namespace psc = CGAL::Point_set_consolidation_3;
namespace params = CGAL::Point_set_consolidation_3::parameters;
using synthetic::Scan;
using synthetic::Shape;

typedef CGAL::Deep_point_3<Kernel> Deep_point;
typedef CGAL::Completed_point_3<Kernel> Completed_point;

template <typename Tag = CGAL::Parallel_if_available_tag>
std::vector<Deep_point> consolidate(const Rays& scan, psc::Data_term data_term,
                                    std::size_t particles = 3000, double completed_spacing = 1)
{
  std::vector<Deep_point> points;
  CGAL::deep_points_consolidate_point_set<Tag>(
    scan, std::back_inserter(points),
    params::point_map(First()).view_direction_map(Second())
      .number_of_output_points(particles).data_term(data_term)
      .completed_spacing(completed_spacing));
  return points;
}

struct Quality {
  double inner = 0;       ///< mean distance of inner points to the skeleton, % of the diagonal
  double outer = 0;       ///< mean distance of outer points to the surface, %
  double coverage = 0;    ///< share of the hidden surface with an outer point within 2.5 %
  double normal = 0;      ///< mean angle to the true normals, degrees
};

Quality judge(const Shape& shape, const Scan& scan, const std::vector<Deep_point>& points)
{
  Quality q;
  const double percent = 100 / shape.diagonal();
  for(const Deep_point& p : points) {
    const Vec3 outer = vec3(p.outer());
    q.inner += percent * shape.skeleton_distance(vec3(p.inner())) / double(points.size());
    q.outer += percent * std::abs(shape.distance(outer)) / double(points.size());
    const double cosine = vec3(p.normal()).dot(shape.normal(outer));
    q.normal += std::acos((std::max)(-1., (std::min)(1., cosine))) * 180 / CGAL_PI /
                double(points.size());
    assert(std::abs(vec3(p.normal()).norm() - 1) < 1e-9);
    assert(p.confidence() >= 0 && p.confidence() <= 1);
  }
  std::size_t covered = 0;
  for(const Vec3& h : scan.hidden) {
    double nearest = (std::numeric_limits<double>::max)();
    for(const Deep_point& p : points)
      nearest = (std::min)(nearest, (vec3(p.outer()) - h).norm());
    covered += percent * nearest < 2.5;
  }
  q.coverage = scan.hidden.empty() ? 1 : double(covered) / double(scan.hidden.size());
  std::cout << "  inner " << q.inner << " %, outer " << q.outer << " %, hidden side covered "
            << q.coverage << ", normals " << q.normal << " deg" << std::endl;
  return q;
}

/// The stages one by one: mean distance of the intermediate results to the true skeleton, in percent.
void stages(const Shape& shape, const Scan& scan, std::size_t particles, double anchor_limit,
            double skeleton_limit)
{
  const Rays input = rays(scan);
  CGAL::Deep_points_consolidation_3<Kernel, CGAL::Parallel_if_available_tag> consolidation(
    input, params::point_map(First()).view_direction_map(Second())
             .number_of_output_points(particles));
  assert(consolidation.form_meso_skeleton());
  const double percent = 100 / shape.diagonal() / double(consolidation.size());
  double anchors = 0, skeleton = 0, surface = 0;
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    anchors += percent * shape.skeleton_distance(vec3(consolidation.anchor_point(i)));
    skeleton += percent * shape.skeleton_distance(vec3(consolidation.skeletal_point(i)));
    surface += percent * std::abs(shape.distance(vec3(consolidation.consolidated_point(i))));
  }
  std::cout << "  r " << 100 * consolidation.spacing() / shape.diagonal() << " %: S " << surface
            << " %, anchors " << anchors << " %, meso-skeleton " << skeleton << " %" << std::endl;
  assert(surface < 0.05);
  assert(anchors < anchor_limit);
  assert(skeleton < skeleton_limit);
}

void one_sided_torus()
{
  std::cout << "one-sided torus" << std::endl;
  const auto torus = synthetic::torus(1, 0.35);
  const Scan scan = synthetic::scan(torus, {Vec3(1, .45, .35)}, 12000, 1);
  stages(torus, scan, 3000, 0.3, 0.22);
  const Quality normal = judge(torus, scan, consolidate(rays(scan), psc::Data_term::NORMAL));
  assert(normal.inner < 0.45);
  const auto unfilled = consolidate(rays(scan), psc::Data_term::NORMAL, 3000, 0);
  assert(unfilled.size() == 3000);                 // as many as the paper has
  assert(judge(torus, scan, unfilled).coverage < normal.coverage);
  assert(normal.outer < 0.15);
  assert(normal.coverage > 0.97);
  assert(normal.normal < 3);
  const Quality full = judge(torus, scan, consolidate(rays(scan), psc::Data_term::FULL));
  assert(full.outer < 0.05);                       // stays on the data
  assert(full.coverage < normal.coverage);         // and therefore completes less
}

void half_cylinder()
{
  std::cout << "capped cylinder, one half missing" << std::endl;
  const auto cylinder = synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, 4), 0.5);
  const Scan scan = synthetic::scan(cylinder, {Vec3(1, 0, 0)}, 10000, 2);
  const Quality q = judge(cylinder, scan, consolidate(rays(scan), psc::Data_term::NORMAL, 2000));
  assert(q.inner < 0.6);
  assert(q.outer < 0.35);
  assert(q.coverage > 0.85);
}

void y_of_tubes()
{
  std::cout << "Y of tubes" << std::endl;
  const auto y = synthetic::united({synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, -2), 0.35),
                                    synthetic::capsule(Vec3(0, 0, 0), Vec3(1.4, 0, 1.4), 0.35),
                                    synthetic::capsule(Vec3(0, 0, 0), Vec3(-1.4, 0, 1.4), 0.35)});
  const Scan scan = synthetic::scan(y, {Vec3(.2, 1, .1)}, 12000, 3);
  // filled points crowd the hidden side of the joint, where three axes merge into a small sheet
  const Quality q = judge(y, scan, consolidate(rays(scan), psc::Data_term::NORMAL));
  assert(q.inner < 0.6);
  assert(judge(y, scan, consolidate(rays(scan), psc::Data_term::NORMAL, 3000, 0)).inner < 0.5);
  assert(q.outer < 0.3);
  assert(q.coverage > 0.85);
}

void thin_plate()
{
  std::cout << "thin plate, both sides" << std::endl;
  const auto plate = synthetic::plate(2, 2, 0.12);
  const Scan scan = synthetic::scan(plate, {Vec3(.1, .1, 1), Vec3(.1, -.1, -1)}, 12000, 4);
  const std::vector<Deep_point> points = consolidate(rays(scan), psc::Data_term::FULL);
  const Quality q = judge(plate, scan, points);
  assert(q.inner < 0.6);   // a sheet in the middle, not one of the faces
  assert(q.outer < 0.25);  // the faces stay apart
  std::size_t upper = 0;
  for(const Deep_point& p : points)
    upper += p.outer().z() > 0;
  assert(upper > points.size() / 3 && upper < 2 * points.size() / 3);
}

/// A flat strip that nothing opposes is taken for half as deep as it is wide.
void strip()
{
  std::cout << "strip" << std::endl;
  constexpr double width = 0.2;
  Rays strip;
  for(int i = 0; i < 200; ++i)
    for(int j = 0; j < 20; ++j)
      strip.emplace_back(Point((i + 0.5 * (j % 2)) / 200., width * (j + 0.5) / 20, 0), Vector(0, 0, 1));
  CGAL::Deep_points_consolidation_3<Kernel> consolidation(
    strip, params::point_map(First()).view_direction_map(Second()).number_of_output_points(1000));
  consolidation.sink_inner_points();
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    assert(consolidation.anchoring(i) == psc::Anchoring::unanchored);
    const double depth = consolidation.consolidated_point(i).z() - consolidation.anchor_point(i).z();
    assert(std::abs(depth - 0.5 * width) < 0.15 * 0.5 * width);
  }
}

void completion()
{
  std::cout << "completion of the one-sided torus" << std::endl;
  const auto torus = synthetic::torus(1, 0.35);
  const Vec3 view = Vec3(1, .45, .35).normalized();
  const Scan scan = synthetic::scan(torus, {view}, 12000, 1);
  const Indexed_rays rays = indexed_rays(scan);
  const std::vector<Point>& points = rays.points;
  std::vector<Point> denoised(points.size());
  std::vector<Vector> normals(points.size());
  std::vector<Completed_point> completed;
  CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
    rays.indices, std::back_inserter(completed),
    params::point_map(rays.point_map())
      .view_direction_map(rays.view_direction_map())
      .number_of_output_points(3000)
      .denoised_point_map(CGAL::make_property_map(denoised))
      .denoised_normal_map(CGAL::make_property_map(normals)));

  assert(completed.size() > 1000);
  assert(denoised == points);  // clean data stay as they are
  for(std::size_t i = 0; i < points.size(); ++i)
    assert(vec3(normals[i]).dot(torus.normal(vec3(points[i]))) > 0.7);
  double error = 0;
  std::size_t covered = 0;
  for(const Completed_point& p : completed)
    error += 100 * std::abs(torus.distance(vec3(p.outer()))) / torus.diagonal() /
             double(completed.size());
  for(const Vec3& h : scan.hidden) {
    double nearest = (std::numeric_limits<double>::max)();
    for(const Completed_point& p : completed)
      nearest = (std::min)(nearest, (vec3(p.outer()) - h).norm());
    for(const Point& p : points)
      nearest = (std::min)(nearest, (vec3(p) - h).norm());
    covered += 100 * nearest / torus.diagonal() < 2.5;
  }
  std::cout << "  " << completed.size() << " points, error " << error << " %, hidden side covered "
            << double(covered) / double(scan.hidden.size()) << std::endl;
  assert(error < 1.0);
  assert(covered > 0.9 * double(scan.hidden.size()));

  // no completed point where a ray has passed: none lies far in front of all data next to its ray
  const double pixel = 0.01 * torus.diagonal();
  std::size_t in_front = 0;
  for(const Completed_point& c : completed) {
    const Vec3 x = vec3(c.outer());
    std::size_t passed = 0, rays_near = 0;
    for(const Vec3& p : scan.points) {
      const Vec3 d = x - p;
      if((d - d.dot(view) * view).norm() < pixel) {
        ++rays_near;
        passed += d.dot(view) > 2 * pixel;
      }
    }
    in_front += rays_near > 0 && passed == rays_near;
    assert(c.distance() > 0);
  }
  assert(in_front == 0);
  std::size_t clipped = 0;
  for(const Completed_point& c : completed)
    clipped += c.is_clipped();
  assert(clipped > 0 && clipped < completed.size());  // it tells some points from others
}

/// Without directions a scan from one side is recognised, and completed as well as with them; what was seen
/// all around is not taken for such a scan.
void unknown_scanner()
{
  using namespace CGAL::Point_set_consolidation_3::internal;
  std::cout << "scans without directions" << std::endl;
  const auto torus = synthetic::torus(1, 0.35);
  const Vec3 view = Vec3(1, .45, .35).normalized();
  const Execution execution = make_execution<CGAL::Sequential_tag>();
  for(const std::size_t views : {1u, 2u, 4u}) {
    const std::vector<Vec3> all = {view, -view, Vec3(-.4, 1, .2).normalized(), Vec3(.4, -1, .2).normalized()};
    const Scan scan =
      synthetic::scan(torus, std::vector<Vec3>(all.begin(), all.begin() + std::ptrdiff_t(views)), 4000, 1);
    const double r =
      mean(neighbor_distances(execution, Nearest_neighbors(scan.points), scan.points, 1));
    Points points, normals;
    for(const Vec3& p : scan.points) {
      points.push_back(p / r);
      normals.push_back(torus.normal(p));
    }
    std::optional<Vec3> found = View_estimation(execution, points, normals).run();
    assert(found.has_value() == (views == 1));
    assert(!found || found->dot(view) > std::cos(CGAL_PI / 18));

    // a part turned the wrong way hides it from the strict test only
    for(std::size_t i = 0; i < points.size(); ++i)
      if(scan.points[i].z() > 0.3)
        normals[i] = -normals[i];
    assert(!View_estimation(execution, points, normals).run().has_value());
    assert(View_estimation(execution, points, normals).run(false).has_value() == (views == 1));
  }

  const Scan scan = synthetic::scan(torus, {view}, 12000, 1);
  std::vector<Point> points;
  for(const Vec3& p : scan.points)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<Completed_point> completed;
  CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(completed),
                                                            params::number_of_output_points(3000));
  double error = 0;
  for(const Completed_point& p : completed)
    error += 100 * std::abs(torus.distance(vec3(p.outer()))) / torus.diagonal() /
             double(completed.size());
  std::cout << "  " << completed.size() << " points, error " << error << " %" << std::endl;
  assert(completed.size() > 1000 && error < 1.0);
}

void boxes()
{
  using psc::internal::Bounding_box;
  // the last two unite, and only their common box reaches the first
  const std::vector<Bounding_box> united = psc::internal::united(
    {Bounding_box{Vec3(0, 5, 0), Vec3(1, 6, 1)}, Bounding_box{Vec3(3, 0, 0), Vec3(4, 6, 1)},
     Bounding_box{Vec3(0, 0, 0), Vec3(3.5, 1, 1)}, Bounding_box{Vec3(9, 9, 9), Vec3(10, 10, 10)}});
  assert(united.size() == 2);
  assert(united[0].lower == Vec3(0, 0, 0) && united[0].upper == Vec3(4, 6, 1));
}

/// An upright tube of radius 1 and height 3, open at both ends, normals known.
struct Open_tube {
  std::vector<std::size_t> indices;
  std::vector<Point> points;
  std::vector<Vector> normals;
  std::vector<psc::Prior> priors;   ///< flat at the lower end, volume preserving at the upper
  std::vector<bool> is_upper;

  Open_tube()
  {
    benchmark::Random_numbers random(8);
    for(std::size_t i = 0; i < 8000; ++i) {
      const double a = 2 * CGAL_PI * random.uniform(), z = 3 * random.uniform();
      indices.push_back(i);
      points.emplace_back(std::cos(a), std::sin(a), z);
      normals.emplace_back(std::cos(a), std::sin(a), 0);
      is_upper.push_back(z > 1.5);
      priors.push_back(z > 1.5 ? psc::Prior::VOLUME_PRESERVING : psc::Prior::FLAT);
    }
  }

  template <typename NP>
  std::vector<Completed_point> completed(const NP& np) const
  {
    std::vector<Completed_point> result;
    CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
      indices, std::back_inserter(result),
      np.point_map(CGAL::make_property_map(points)).normal_map(CGAL::make_property_map(normals))
        .number_of_output_points(2000));
    return result;
  }
};

/// Priors, the largest hole and frozen regions act on the gaps they are meant for.
void closures()
{
  std::cout << "closures of an open tube" << std::endl;
  const Open_tube tube;
  // at the ends: points, and the largest distance from the end's plane
  struct Ends {
    std::size_t lower = 0, upper = 0;
    double lower_height = 0, upper_height = 0;
  };
  const auto ends = [](const std::vector<Completed_point>& points) {
    Ends result;
    for(const Completed_point& p : points) {
      const double z = p.outer().z();
      if(z > 1.5) {
        ++result.upper;
        result.upper_height = (std::max)(result.upper_height, std::abs(z - 3));
      }
      else {
        ++result.lower;
        result.lower_height = (std::max)(result.lower_height, std::abs(z));
      }
    }
    std::cout << "  lower end " << result.lower << " points, height " << result.lower_height
              << ", upper end " << result.upper << ", " << result.upper_height << std::endl;
    return result;
  };
  const Ends round = ends(tube.completed(params::prior(psc::Prior::VOLUME_PRESERVING)));
  assert(round.lower > 100 && round.upper > 100);
  assert(round.lower_height > 0.3 && round.upper_height > 0.3);
  const Ends small = ends(tube.completed(params::prior(psc::Prior::MINIMAL_VOLUME)));
  assert(small.lower > 100 && small.lower_height < 0.8 * round.lower_height);
  const Ends mixed =
    ends(tube.completed(params::prior_map(CGAL::make_property_map(tube.priors))));
  assert(mixed.lower > 100 && mixed.lower_height < 0.05);
  assert(mixed.upper == round.upper && mixed.upper_height == round.upper_height);
  const std::vector<Completed_point> flat = tube.completed(params::prior(psc::Prior::FLAT));
  for(const Completed_point& p : flat)
    assert(std::abs(p.normal().z()) > 0.999);
  assert(tube.completed(params::maximum_hole_size(0.5)).empty());
  assert(ends(tube.completed(params::maximum_hole_size(6.))).lower == round.lower);
  std::vector<char> is_upper(tube.is_upper.begin(), tube.is_upper.end());
  const Ends frozen =
    ends(tube.completed(params::point_is_constrained_map(CGAL::make_property_map(is_upper))));
  assert(frozen.upper == 0 && frozen.lower == round.lower);

  // deep points: the flat prior puts what has spread beyond the border on its plane
  std::vector<Deep_point> deep;
  CGAL::deep_points_consolidate_point_set<CGAL::Parallel_if_available_tag>(
    tube.indices, std::back_inserter(deep),
    params::point_map(CGAL::make_property_map(tube.points))
      .normal_map(CGAL::make_property_map(tube.normals)).number_of_output_points(2000)
      .data_term(psc::Data_term::NORMAL).prior(psc::Prior::FLAT));
  for(const Deep_point& p : deep)
    assert(p.outer().z() > -0.1 && p.outer().z() < 3.1);
}

/// A ball with a dropout of the scanner in the middle of the image.
void missed_rays()
{
  std::cout << "dropout" << std::endl;
  const auto ball = synthetic::capsule(Vec3(0, 0, -1e-3), Vec3(0, 0, 1e-3), 1);
  const Scan whole = synthetic::scan(ball, {Vec3(0, 0, 1)}, 12000, 9);
  Rays scan;
  for(const Point_and_direction& ray : rays(whole))
    if(std::hypot(ray.first.x(), ray.first.y()) > 0.5)
      scan.push_back(ray);
  std::vector<std::pair<Point, std::size_t> > missed;
  for(int x = -80; x <= 80; ++x)
    for(int y = -80; y <= 80; ++y)
      if(std::hypot(0.02 * x, 0.02 * y) > 1.03)
        missed.emplace_back(Point(0.02 * x, 0.02 * y, 5), 0);
  const auto in_dropout = [&](const auto& np) {
    std::vector<Completed_point> points;
    CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
      scan, std::back_inserter(points),
      np.point_map(First()).view_direction_map(Second()).number_of_output_points(2500));
    std::size_t count = 0;
    for(const Completed_point& p : points)
      count += p.outer().z() > 0.5 && std::hypot(p.outer().x(), p.outer().y()) < 0.3;
    std::cout << "  " << count << " points in the dropout" << std::endl;
    return count;
  };
  assert(in_dropout(params::closing_step(true)) == 0);   // taken for seen through
  // as dense as the data
  const auto seen = double(std::count_if(whole.points.begin(), whole.points.end(), [](const Vec3& p) {
    return p.z() > 0.5 && std::hypot(p.x(), p.y()) < 0.3;
  }));
  const auto completed = double(in_dropout(params::missed_rays(missed)));
  std::cout << "  a whole scan has " << seen << std::endl;
  assert(completed > 0.5 * seen && completed < 1.5 * seen);
}

/// Anchors and skeletal points of a scan.
std::vector<Vec3> inner_points(const Scan& scan)
{
  CGAL::Deep_points_consolidation_3<Kernel, CGAL::Parallel_if_available_tag> consolidation(
    rays(scan),
    params::point_map(First()).view_direction_map(Second()).number_of_output_points(1000));
  assert(consolidation.form_meso_skeleton());
  std::vector<Vec3> points;
  for(std::size_t i = 0; i < consolidation.size(); ++i) {
    points.push_back(vec3(consolidation.anchor_point(i)));
    points.push_back(vec3(consolidation.skeletal_point(i)));
  }
  return points;
}

/// The inner points of a moved scan are those of the scan, moved. The outer points' iteration amplifies
/// the last digits, so these are other points, but as good.
void invariance()
{
  const auto torus = synthetic::torus(1, 0.35);
  const Scan scan = synthetic::scan(torus, {Vec3(1, .45, .35)}, 5000, 5);
  const std::vector<Vec3> inner = inner_points(scan);
  const Quality before = judge(torus, scan, consolidate(rays(scan), psc::Data_term::NORMAL, 1000));
  const auto check = [&](const char* name, const Eigen::Affine3d& motion, double tolerance) {
    Scan moved = scan;
    for(Vec3& p : moved.points)
      p = motion * p;
    for(Vec3& d : moved.directions)
      d = (motion.linear() * d).normalized();
    const Eigen::Affine3d back = motion.inverse();
    const std::vector<Vec3> moved_inner = inner_points(moved);
    double deviation = 0;
    for(std::size_t i = 0; i < inner.size(); ++i)
      deviation += (back * moved_inner[i] - inner[i]).norm() / double(inner.size());
    std::cout << name << ": deviation of the inner points " << deviation << std::endl;
    assert(deviation < tolerance * torus.diagonal());
    std::vector<Deep_point> outer;
    const auto point = [&](const Point& p) {
      const Vec3 x = back * vec3(p);
      return Point(x.x(), x.y(), x.z());
    };
    for(const Deep_point& p : consolidate(rays(moved), psc::Data_term::NORMAL, 1000)) {
      const Vec3 n = (back.linear() * vec3(p.normal())).normalized();
      outer.emplace_back(point(p.outer()), point(p.inner()), Vector(n.x(), n.y(), n.z()),
                         p.confidence());
    }
    const Quality after = judge(torus, scan, outer);
    assert(after.inner < 1.2 * before.inner);
    assert(after.outer < 1.2 * before.outer);
    assert(after.normal < 1.2 * before.normal);
    assert(after.coverage > before.coverage - 0.02);
  };
  using Motion = Eigen::Affine3d;
  check("scale 1e-4", Motion(Eigen::Scaling(1e-4)), 1e-6);
  check("scale 1e5", Motion(Eigen::Scaling(1e5)), 1e-6);
  check("rotation", Motion(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), 1e-6);
  // leaves nine digits of the coordinates
  check("offset", Motion(Eigen::Translation3d(4e6, -4e6, 4e6)), 1e-3);
}

bool same_bits(const std::vector<Deep_point>& a, const std::vector<Deep_point>& b)
{
  if(a.size() != b.size())
    return false;
  for(std::size_t i = 0; i < a.size(); ++i)
    if(a[i].outer() != b[i].outer() || a[i].inner() != b[i].inner() ||
       a[i].normal() != b[i].normal() || a[i].confidence() != b[i].confidence())
      return false;
  return true;
}

template <typename Tag>
std::vector<Deep_point> completed(const Rays& scan)
{
  std::vector<Deep_point> points;
  CGAL::complete_point_set<Tag>(scan, std::back_inserter(points),
                                params::point_map(First()).view_direction_map(Second())
                                  .number_of_output_points(1000));
  return points;
}

void parallel_equals_sequential()
{
  const auto torus = synthetic::torus(1, 0.35);
  const Rays scan = rays(synthetic::scan(torus, {Vec3(1, .45, .35)}, 5000, 5));
  const auto reference = consolidate<CGAL::Sequential_tag>(scan, psc::Data_term::FULL, 1000);
  const auto reference_completed = completed<CGAL::Sequential_tag>(scan);
  assert(!reference_completed.empty());
  assert(same_bits(reference, consolidate<CGAL::Sequential_tag>(scan, psc::Data_term::FULL, 1000)));
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    assert(same_bits(reference,
                     consolidate<CGAL::Parallel_tag>(scan, psc::Data_term::FULL, 1000)));
    assert(same_bits(reference_completed, completed<CGAL::Parallel_tag>(scan)));
  }
#endif
}

template <typename K>
void kernels_and_ranges()
{
  typedef typename K::Point_3 P;
  typedef typename K::Vector_3 V;
  typedef typename K::FT FT;
  typedef std::pair<P, V> Pair;
  const auto tube = synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, 2), 0.4);
  const Scan scan = synthetic::scan(tube, {Vec3(1, 0, 0)}, 1500, 6);
  std::vector<P> points;
  std::vector<Pair> pairs;
  CGAL::Point_set_3<P, V> set(true);
  std::vector<std::size_t> indices;
  for(std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vec3 &p = scan.points[i], n = tube.normal(p);
    points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    pairs.emplace_back(points.back(), V(FT(n.x()), FT(n.y()), FT(n.z())));
    set.insert(points.back(), pairs.back().second);
    indices.push_back(i);
  }
  const auto np = params::number_of_output_points(300).completed_spacing(0);
  std::vector<CGAL::Deep_point_3<K> > results[4];
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(results[0]), np);
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    pairs, std::back_inserter(results[1]),
    np.point_map(CGAL::First_of_pair_property_map<Pair>())
      .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    set, std::back_inserter(results[2]), np);
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    indices, std::back_inserter(results[3]), np.point_map(CGAL::make_property_map(points)));
  for(std::size_t k = 0; k < 4; ++k) {
    assert(results[k].size() == 300);
    std::size_t outwards = 0;
    for(const auto& p : results[k]) {
      const Vec3 x(CGAL::to_double(p.outer().x()), CGAL::to_double(p.outer().y()),
                   CGAL::to_double(p.outer().z()));
      const Vec3 n(CGAL::to_double(p.normal().x()), CGAL::to_double(p.normal().y()),
                   CGAL::to_double(p.normal().z()));
      assert(std::abs(tube.distance(x)) < 0.1);
      outwards += n.dot(tube.normal(x)) > 0;
    }
    assert(outwards > 0.95 * 300);
  }
  // the same points, with and without maps, and normals from a map or the point set's own
  for(std::size_t i = 0; i < 300; ++i) {
    assert(results[0][i].outer() == results[3][i].outer());
    assert(results[1][i].outer() == results[2][i].outer());
  }
}

void cancellation()
{
  const auto torus = synthetic::torus(1, 0.35);
  const Rays scan = rays(synthetic::scan(torus, {Vec3(1, .45, .35)}, 3000, 7));
  const auto np = params::point_map(First()).view_direction_map(Second())
                    .number_of_output_points(600).completed_spacing(0);
  double last = 0;
  std::size_t calls = 0;
  std::vector<Deep_point> all;
  CGAL::deep_points_consolidate_point_set<CGAL::Parallel_if_available_tag>(
    scan, std::back_inserter(all), np.callback([&](double fraction) {
      assert(fraction >= last && fraction <= 1);
      last = fraction;
      ++calls;
      return true;
    }));
  assert(all.size() == 600 && last == 1 && calls > 60);
  for(int k = 0; k < 20; ++k) {
    const double stop_at = k / 20.;
    std::vector<Deep_point> output;
    CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
      scan, std::back_inserter(output), np.callback([&](double f) { return f < stop_at; }));
    assert(output.empty());
    CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
      scan, std::back_inserter(output), np.callback([&](double f) { return f < stop_at; }));
    assert(output.empty());
  }
  struct Stop {};
  bool was_thrown = false;
  try {
    CGAL::deep_points_consolidate_point_set<CGAL::Parallel_if_available_tag>(
      scan, std::back_inserter(all), np.callback([](double f) -> bool {
        if(f > 0.5)
          throw Stop();
        return true;
      }));
  }
  catch(const Stop&) {
    was_thrown = true;
  }
  assert(was_thrown && all.size() == 600);
}

/// The message of the `std::invalid_argument` that both functions must throw.
template <typename NP>
std::string rejected(const std::vector<Point>& points, const NP& np)
{
  std::string message;
  std::vector<Deep_point> output;
  try {
    CGAL::complete_point_set<CGAL::Sequential_tag>(points, std::back_inserter(output), np);
    assert(false);
  }
  catch(const std::invalid_argument&) {
  }
  try {
    CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(points,
                                                                  std::back_inserter(output), np);
    assert(false);
  }
  catch(const std::invalid_argument& error) {
    message = error.what();
  }
  assert(output.empty());
  return message;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Odd input that has a sensible result: finite points, one for each particle.
void accepted(const char* name, const std::vector<Point>& points)
{
  std::vector<Deep_point> output, missing;
  CGAL::deep_points_consolidate_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(output), params::number_of_output_points(300));
  CGAL::complete_point_set<CGAL::Sequential_tag>(points, std::back_inserter(missing),
                                                 params::number_of_output_points(300));
  std::cout << "  " << name << ": " << output.size() << " points, " << missing.size()
            << " completed" << std::endl;
  assert(!output.empty());
  output.insert(output.end(), missing.begin(), missing.end());
  for(const Deep_point& p : output)
    assert(vec3(p.outer()).allFinite() && vec3(p.inner()).allFinite() &&
           std::abs(vec3(p.normal()).norm() - 1) < 1e-6);
}

template <typename Value, typename F>
auto map_of(const F& f)
{
  return boost::make_function_property_map<Point, Value>(f);
}

void bad_views(const std::vector<Point>& points)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto is_bad = [bad = points[17]](const Point& p) { return p == bad; };
  const auto directions = [=](const Vector& bad) {
    return params::view_direction_map(
      map_of<Vector>([=](const Point& p) { return is_bad(p) ? bad : Vector(0, 0, 1); }));
  };
  assert(contains(rejected(points, directions(Vector(0, nan, 1))), "view_direction_map is not finite for 1 of"));
  assert(contains(rejected(points, directions(Vector(0, nan, 1))), "index 17"));
  assert(contains(rejected(points, directions(Vector(0, 0, 0))), "index 17"));

  const auto views = [=](auto bad) {
    return directions(Vector(0, 0, 1)).view_index_map(
      map_of<decltype(bad)>([=](const Point& p) { return is_bad(p) ? bad : decltype(bad)(0); }));
  };
  assert(contains(rejected(points, views(-1)), "index 17"));
  assert(contains(rejected(points, views(100001)), "index 17"));
  assert(contains(rejected(points, views(std::size_t(-1))), "index 17"));
  const std::vector<Point> scanners = {Point(0, 0, 9), Point(9, 0, nan)};
  assert(contains(rejected(points, views(2).scanner_positions(scanners)), "beyond scanner_positions"));
  assert(contains(rejected(points, views(1).scanner_positions(scanners)), "index 17"));
  assert(contains(rejected(points, params::scanner_positions(scanners)), "view_index_map"));
  assert(contains(rejected(points, params::scanner_positions(std::vector<Point>())), "empty"));
  assert(contains(rejected(points, params::view_index_map(map_of<int>([](const Point&) { return 0; }))),
                  "view_index_map needs"));

  const auto missed = [=](const Point& p, std::size_t view) {
    return directions(Vector(0, 0, 1)).missed_rays(std::vector<std::pair<Point, std::size_t> >{{p, view}});
  };
  assert(contains(rejected(points, missed(Point(0, nan, 0), 0)), "missed_rays"));
  assert(contains(rejected(points, missed(Point(0, 0, 0), 1)), "missed_rays"));
}

void bad_input()
{
  std::cout << "bad input" << std::endl;
  const auto np = params::default_values();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> points;
  assert(contains(rejected(points, np), "points"));
  for(int n = 1; n <= 3; ++n) {
    points.emplace_back(n, 0, 0);
    assert(contains(rejected(points, np), "needs at least 10 points"));
  }
  assert(contains(rejected(std::vector<Point>(50, Point(1, 2, 3)), np), "coincide"));

  std::vector<Point> sphere;
  const auto ball = synthetic::capsule(Vec3(0, 0, 0), Vec3(0, 0, 1e-3), 1);
  for(const Vec3& p : synthetic::samples(ball, 600, 8))
    sphere.emplace_back(p.x(), p.y(), p.z());
  std::vector<Point> bad = sphere;
  bad[17] = Point(0, nan, 0);
  const std::string message = rejected(bad, np);
  assert(contains(message, "index 17") && contains(message, "point_map"));
  bad[17] = Point(0, 0, std::numeric_limits<double>::infinity());
  assert(contains(rejected(bad, np), "index 17"));
  assert(contains(rejected(sphere, params::collision_angle(0)), "collision_angle"));
  assert(contains(rejected(sphere, params::collision_angle(171)), "collision_angle"));
  assert(contains(rejected(sphere, params::smoothing_radius(-1)), "smoothing_radius"));
  assert(contains(rejected(sphere, params::collision_radius(nan)), "collision_radius"));
  assert(contains(rejected(sphere, params::neighbor_radius(-2)), "neighbor_radius"));
  assert(contains(rejected(sphere, params::select_percentage(120)), "select_percentage"));
  assert(contains(rejected(sphere, params::number_of_iterations(0)), "number_of_iterations"));
  assert(contains(rejected(sphere, params::number_of_output_points(0)), "number_of_output_points"));
  assert(contains(rejected(sphere, params::view_direction_map(
                                     CGAL::Constant_property_map<Point, Vector>(Vector(0, 0, 0)))),
                  "scanner"));
  using CGAL::Point_set_consolidation_3::Prior;
  using CGAL::Point_set_consolidation_3::Data_term;
  assert(contains(rejected(sphere, params::prior(Prior(3))), "prior is none"));
  assert(contains(rejected(sphere, params::data_term(Data_term(2))), "data_term is none"));
  assert(contains(rejected(sphere, params::prior_map(CGAL::Constant_property_map<Point, Prior>(Prior(200)))),
                  "prior_map: point 0"));
  bad_views(sphere);

  accepted("sphere", sphere);
  std::vector<Point> twice = sphere;
  twice.insert(twice.end(), sphere.begin(), sphere.end());
  accepted("every point twice", twice);
  std::vector<Point> line, plane, grid;
  for(int i = 0; i < 500; ++i)
    line.emplace_back(0.01 * i, 0.02 * i, 0);
  for(int i = 0; i < 25; ++i)
    for(int j = 0; j < 25; ++j)
      plane.emplace_back(i, j, 0);
  for(int i = 0; i < 9; ++i)
    for(int j = 0; j < 9; ++j)
      for(int k = 0; k < 9; ++k)
        grid.emplace_back(i, j, k);
  accepted("line", line);
  accepted("plane", plane);
  accepted("regular grid", grid);
  std::vector<Point> outlier = sphere;
  outlier.push_back(Point(1e30, 0, 0));
  accepted("outlier at 1e30", outlier);
  std::vector<Point> clusters = sphere;
  for(const Point& p : sphere)
    clusters.emplace_back(p.x() + 1e7, p.y(), p.z());
  accepted("clusters 1e7 apart", clusters);
  for(const double scale : {1e-20, 1e20}) {
    std::vector<Point> scaled;
    for(const Point& p : sphere)
      scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    accepted("extreme unit", scaled);
  }
}

}  // namespace

int main()
{
  one_sided_torus();
  half_cylinder();
  y_of_tubes();
  thin_plate();
  strip();
  completion();
  unknown_scanner();
  mirror_symmetry_cases::symmetric();
  mirror_symmetry_cases::asymmetric();
  boxes();
  closures();
  missed_rays();
  invariance();
  parallel_equals_sequential();
  kernels_and_ranges<CGAL::Simple_cartesian<double> >();
  kernels_and_ranges<CGAL::Simple_cartesian<float> >();
  kernels_and_ranges<CGAL::Exact_predicates_inexact_constructions_kernel>();
  cancellation();
  bad_input();
  return EXIT_SUCCESS;
}
