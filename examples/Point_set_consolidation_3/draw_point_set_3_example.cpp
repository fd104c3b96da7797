#include <CGAL/complete_point_set.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/draw_point_set_3.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/oni.pwn");
  Point_set points;
  if(!CGAL::IO::read_point_set(input, points)) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<CGAL::Completed_point_3<Kernel> > missing;
  CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(missing));
  for(const CGAL::Completed_point_3<Kernel>& p : missing)
    points.insert(p.outer());
  std::cout << missing.size() << " points completed\n";
  CGAL::draw(points);  // a window, which stays until it is closed
  return EXIT_SUCCESS;
}
