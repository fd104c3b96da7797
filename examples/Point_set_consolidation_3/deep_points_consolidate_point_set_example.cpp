#include <CGAL/deep_points_consolidate_point_set.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Deep_point_3<Kernel> Deep_point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Concurrency
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char* argv[])
{
  const std::string input =
    (argc > 1) ? argv[1] : CGAL::data_file_path("points_3/hippo1.ply");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // denoised, evenly spread surface points, each with an inner point on the meso-skeleton
  namespace params = CGAL::Point_set_consolidation_3::parameters;
  std::vector<Deep_point> deep_points;
  CGAL::deep_points_consolidate_point_set<Concurrency_tag>(
    points, std::back_inserter(deep_points), params::number_of_output_points(3000));
  std::cout << points.size() << " points -> " << deep_points.size() << " deep points" << std::endl;

  // they go straight into Poisson reconstruction
  const CGAL::Deep_point_outer_map<Kernel> outer;
  const CGAL::Deep_point_normal_map<Kernel> normal;
  const double spacing = CGAL::compute_average_spacing<Concurrency_tag>(
    deep_points, 6, CGAL::parameters::point_map(outer));
  Mesh mesh;
  if(!CGAL::poisson_surface_reconstruction_delaunay(deep_points.begin(), deep_points.end(), outer,
                                                    normal, mesh, spacing)) {
    std::cerr << "Error: no surface" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << mesh.number_of_vertices() << " vertices" << std::endl;
  return CGAL::IO::write_polygon_mesh("deep_points_mesh.off", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
