#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::pair<Kernel::Point_3, int> Labelled_point;
typedef CGAL::First_of_pair_property_map<Labelled_point> Point_map;
typedef CGAL::Second_of_pair_property_map<Labelled_point> Label_map;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Labelled_point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points),
                            CGAL::parameters::point_map(Point_map()))) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // parts, numbered by falling size
  const std::size_t number = CGAL::density_peak_segment_point_set<Concurrency_tag>(
    points, Label_map(), params::point_map(Point_map()).number_of_segments(4));
  std::vector<std::size_t> sizes(number, 0);
  for(const Labelled_point& p : points)
    ++sizes[std::size_t(p.second)];
  for(std::size_t s = 0; s < number; ++s)
    std::cout << "segment " << s << ": " << sizes[s] << " points\n";

  // an L1-medial skeleton of each part, joined where parts touch
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::extract_l1_medial_skeleton<Concurrency_tag>(
    points, skeleton,
    params::point_map(Point_map()).segment_map(Label_map()).number_of_samples(300));
  std::cout << num_vertices(skeleton) << " vertices, " << CGAL::number_of_skeleton_components(skeleton)
            << " components\n";
  return CGAL::IO::write_curve_skeleton("l1_skeleton.ply", skeleton) ? EXIT_SUCCESS : EXIT_FAILURE;
}
