#include <CGAL/feature_enhanced_surface_reconstruction.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Oriented_point;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  const auto maps = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  std::vector<Oriented_point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points), maps.cgal_parameters())) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // An empty skeleton is filled; an edited one would be used as it is.
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  Mesh mesh;
  CGAL::feature_enhanced_surface_reconstruction<Concurrency_tag>(points, skeleton, mesh,
                                                                 maps.grid_resolution(48));
  std::cout << num_faces(mesh) << " faces, skeleton of " << num_vertices(skeleton) << " vertices\n";

  // what the skeleton says of places without points
  std::vector<Oriented_point> missing;
  CGAL::complete_point_set_along_skeleton<Concurrency_tag>(points, skeleton, std::back_inserter(missing),
                                                           false, maps);
  std::cout << missing.size() << " points are missing\n";
  return CGAL::is_closed(mesh) && CGAL::IO::write_OFF("surface.off", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
