#include <CGAL/bilateral_project_point_set.h>

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
typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Oriented_point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char* argv[])
{
  const std::string input =
    argc > 1 ? argv[1] : CGAL::data_file_path("points_3/fin90_with_PCA_normals.xyz");
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  std::vector<Oriented_point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points), maps)) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // The package's functions take CGAL's packs of named parameters as they are.
  const double displacement =
    CGAL::bilateral_project_point_set<Concurrency_tag>(points, maps.number_of_iterations(5));
  std::cout << "points moved by " << displacement << " in the mean\n";
  return displacement > 0 && CGAL::IO::write_points("smoothed.ply", points, maps.stream_precision(17))
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
