#include <CGAL/iterative_consolidate_point_set.h>

#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string name =
    argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(name, std::back_inserter(points))) {
    std::cerr << "cannot read " << name << '\n';
    return EXIT_FAILURE;
  }

  // what is reported besides the points
  std::vector<std::size_t> outliers;
  std::vector<bool> is_new;

  std::vector<Oriented_point> result;
  CGAL::iterative_consolidate_point_set<Concurrency_tag>(
    points, std::back_inserter(result),
    params::particle_fraction(0.1)
      .outlier_output_iterator(std::back_inserter(outliers))
      .completed_output_iterator(std::back_inserter(is_new)));

  std::cout << points.size() << " points, " << outliers.size() << " outliers, "
            << result.size() - (points.size() - outliers.size()) << " new points\n";

  const bool written = CGAL::IO::write_points(
    "consolidated.ply", result,
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())
      .stream_precision(17));
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
