#include <CGAL/bilateral_project_point_set.h>
#include <CGAL/complete_point_set.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;
typedef CGAL::Completed_point_3<Kernel> Completed_point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/oni.pwn");
  Point_set points;
  if(!CGAL::IO::read_point_set(input, points)) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // A Point_set_3 brings its maps; its own pack of parameters can be continued.
  points.add_normal_map();
  std::vector<Completed_point> missing;
  CGAL::complete_point_set<Concurrency_tag>(
    points, std::back_inserter(missing),
    params::from(CGAL::parameters::point_map(points.point_map()).geom_traits(Kernel()))
      .denoised_point_map(points.point_map())
      .denoised_normal_map(points.normal_map()));

  // the new points have their confidence as a property
  Point_set::Property_map<double> confidence = points.add_property_map<double>("confidence", 1).first;
  for(const Completed_point& p : missing) {
    const Point_set::iterator added = points.insert(p.outer(), p.normal());
    confidence[*added] = p.confidence();
  }
  CGAL::bilateral_project_point_set<Concurrency_tag>(points, params::number_of_iterations(1));
  std::cout << points.size() << " points, " << missing.size() << " of them completed\n";

  return CGAL::IO::write_point_set("completed.ply", points) ? EXIT_SUCCESS : EXIT_FAILURE;
}
