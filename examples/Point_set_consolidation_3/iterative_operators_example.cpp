#include <CGAL/interpolatory_upsample_point_set.h>
#include <CGAL/mean_shift_remove_outliers.h>
#include <CGAL/repulse_along_apss.h>
#include <CGAL/wlop_project_point_set.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

double highest(const std::vector<Oriented_point>& points)
{
  double z = -1;
  for(const Oriented_point& p : points)
    z = (std::max)(z, p.first.z());
  return z;
}

int main()
{
  // the lower four fifths of a noisy unit sphere, and outliers
  CGAL::Random random(7);
  CGAL::Random_points_on_sphere_3<Point> on_sphere(1, random);
  std::vector<Point> points;
  while(points.size() < 8000) {
    const Point p = *on_sphere++;
    if(p.z() < 0.6)
      points.push_back(CGAL::ORIGIN + random.get_double(0.99, 1.01) * (p - CGAL::ORIGIN));
  }
  while(points.size() < 8020) {
    const Point p(random.get_double(-3, 3), random.get_double(-3, 3), random.get_double(-3, 3));
    if((p - CGAL::ORIGIN).squared_length() > 3)
      points.push_back(p);
  }

  // outliers go
  std::vector<Point> clean;
  CGAL::mean_shift_remove_outliers<Concurrency_tag>(points, std::back_inserter(clean));
  std::cout << points.size() - clean.size() << " outliers\n";

  // evenly spread particles
  std::vector<Point> particles;
  CGAL::wlop_project_point_set<Concurrency_tag>(clean, std::back_inserter(particles),
                                                params::number_of_output_points(800));

  // they extend the surface over its border
  std::vector<Oriented_point> oriented;
  for(const Point& p : particles)
    oriented.emplace_back(p, p - CGAL::ORIGIN);
  const auto maps = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  const double before = highest(oriented);
  CGAL::repulse_along_apss<Concurrency_tag>(oriented, maps.number_of_repulsion_steps(10));
  std::cout << "border raised from " << before << " to " << highest(oriented) << '\n';

  // and are up-sampled
  std::vector<Oriented_point> inserted;
  CGAL::interpolatory_upsample_point_set<Concurrency_tag>(oriented, std::back_inserter(inserted), maps);
  std::cout << oriented.size() << " particles, " << inserted.size() << " points inserted\n";
  return clean.size() < points.size() && highest(oriented) > before && !inserted.empty()
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
