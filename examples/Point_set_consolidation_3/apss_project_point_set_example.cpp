#include <CGAL/Algebraic_point_set_surface_3.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

double mean_distance_to_sphere(const std::vector<Oriented_point>& points)
{
  double sum = 0;
  for(const Oriented_point& p : points)
    sum += std::abs(std::sqrt((p.first - CGAL::ORIGIN).squared_length()) - 1);
  return sum / double(points.size());
}

int main()
{
  // a noisy unit sphere
  CGAL::Random random(7);
  CGAL::Random_points_on_sphere_3<Point> on_sphere(1, random);
  std::vector<Oriented_point> points;
  for(int i = 0; i < 10000; ++i) {
    const Vector normal = *on_sphere++ - CGAL::ORIGIN;
    points.emplace_back(CGAL::ORIGIN + random.get_double(0.98, 1.02) * normal, normal);
  }
  const auto maps = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());

  std::cout << "mean distance before: " << mean_distance_to_sphere(points) << '\n';
  CGAL::apss_project_point_set<Concurrency_tag>(points, maps.neighbor_radius(0.2));
  std::cout << "mean distance after:  " << mean_distance_to_sphere(points) << '\n';

  // the surface as a field
  const CGAL::Algebraic_point_set_surface_3<Kernel> surface(points, maps.neighbor_radius(0.2));
  const Point query(0.6, 0.6, 0.6);
  if(const auto sphere = surface.fit(query))
    std::cout << "distance of (" << query << "): " << *surface.signed_distance(query)
              << ", radius of curvature there: " << 1 / sphere->curvature << '\n';
  return EXIT_SUCCESS;
}
