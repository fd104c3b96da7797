#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_ply_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/property_map.h>

#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::pair<Point, Kernel::Vector_3> Oriented_point;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input =
    argc > 1 ? argv[1] : CGAL::data_file_path("points_3/fin90_with_PCA_normals.xyz");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "cannot read " << input << "\n";
    return 1;
  }

  // simplify and denoise; edges stay sharp
  std::vector<Oriented_point> projected;
  CGAL::anisotropic_wlop_simplify_and_regularize_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(projected), params::select_percentage(25));

  // normals of the two sides of an edge, not of their mean
  const auto maps = params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  CGAL::optimize_normals_across_edges<CGAL::Parallel_if_available_tag>(projected, maps);

  // add points, preferably at edges
  std::vector<Oriented_point> upsampled;
  CGAL::anisotropic_edge_aware_upsample_point_set<CGAL::Parallel_if_available_tag>(
    projected, std::back_inserter(upsampled), maps.number_of_output_points(points.size()));

  std::cout << points.size() << " points, " << projected.size() << " projected, "
            << upsampled.size() << " up-sampled\n";
  return CGAL::IO::write_PLY("upsampled.ply", upsampled, maps.cgal_parameters()) ? 0 : 1;
}
