#include <CGAL/Laplacian_contraction_skeletonization_3.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Curve_skeleton_3<Kernel> Skeleton;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;
typedef CGAL::Laplacian_contraction_skeletonization_3<Kernel, Concurrency_tag> Skeletonization;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // step by step
  Skeletonization skeletonization(points, params::number_of_samples(2000));
  while(!skeletonization.has_converged())
    skeletonization.contract_geometry();
  std::cout << "contracted " << skeletonization.number_of_iterations() << " times\n";
  skeletonization.build_graph();
  skeletonization.thin();
  skeletonization.recentre();
  skeletonization.extend_tips();
  Skeleton skeleton;
  skeletonization.skeleton(skeleton);
  std::cout << num_vertices(skeleton) << " vertices, " << CGAL::number_of_skeleton_cycles(skeleton)
            << " cycles\n";

  // the same in one call
  Skeleton at_once;
  CGAL::extract_laplacian_contraction_skeleton<Concurrency_tag>(points, at_once,
                                                               params::number_of_samples(2000));
  return num_vertices(at_once) == num_vertices(skeleton) &&
             CGAL::IO::write_curve_skeleton("skeleton.ply", skeleton)
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
