#include <CGAL/wlop_project_point_set.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/IO/read_points.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

const unsigned int iterations = 6;

std::vector<Point> project(const std::vector<Point>& points, const std::vector<Point>& particles, double h)
{
  std::vector<Point> projected;
  CGAL::wlop_project_point_set<Concurrency_tag>(
    points, std::back_inserter(projected),
    params::initial_sample(std::cref(particles)).neighbor_radius(h).number_of_iterations(iterations));
  return projected;
}

std::vector<Point> between(const std::vector<Point>& points, double lower, double upper)
{
  std::vector<Point> inside;
  std::copy_if(points.begin(), points.end(), std::back_inserter(inside),
               [=](const Point& p) { return lower <= p.y() && p.y() < upper; });
  return inside;
}

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(file, std::back_inserter(points)) || points.empty()) {
    std::cerr << file << ": cannot be read\n";
    return EXIT_FAILURE;
  }
  std::vector<Point> particles;
  for(std::size_t i = 0; i < points.size(); i += 5)
    particles.push_back(points[i]);
  const double h = 6 * CGAL::compute_average_spacing<Concurrency_tag>(points, 6);

  // What lies farther than h / 2 does not act on a particle, in one iteration; weights take h / 2 more.
  const double halo = (iterations + 1) * h / 2;
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  const double side = (box.ymax() - box.ymin()) / 3;
  std::vector<Point> by_tiles;
  for(double lower = box.ymin(); lower <= box.ymax(); lower += side) {
    const std::vector<Point> around = between(particles, lower - halo, lower + side + halo);
    const std::vector<Point> projected = project(between(points, lower - halo, lower + side + halo), around, h);
    for(std::size_t i = 0; i < around.size(); ++i)
      if(lower <= around[i].y() && around[i].y() < lower + side)
        by_tiles.push_back(projected[i]);
  }

  std::vector<Point> at_once = project(points, particles, h);
  std::sort(at_once.begin(), at_once.end());
  std::sort(by_tiles.begin(), by_tiles.end());
  double furthest = at_once.size() == by_tiles.size() ? 0 : h;
  for(std::size_t i = 0; i < std::min(at_once.size(), by_tiles.size()); ++i)
    furthest = (std::max)(furthest, std::sqrt(CGAL::squared_distance(at_once[i], by_tiles[i])));
  std::cout << by_tiles.size() << " particles; tile by tile and at once differ by " << furthest / h << " h\n";
  return furthest < 1e-7 * h ? EXIT_SUCCESS : EXIT_FAILURE;
}
