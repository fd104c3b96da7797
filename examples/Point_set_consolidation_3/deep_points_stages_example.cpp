#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/meso_skeleton_to_graph.h>

#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;
typedef CGAL::Deep_points_consolidation_3<Kernel, Concurrency_tag> Consolidation;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  Consolidation consolidation(points, params::number_of_output_points(1500));

  consolidation.consolidate_input();
  std::cout << consolidation.size() << " consolidated points, spacing " << consolidation.spacing() << '\n';

  consolidation.sink_inner_points();
  std::size_t collided = 0;
  for(std::size_t i = 0; i < consolidation.size(); ++i)
    collided += consolidation.anchoring(i) == CGAL::Point_set_consolidation_3::Anchoring::collided;
  std::cout << collided << " of them met an opposing front, in "
            << consolidation.number_of_sinking_iterations() << " iterations\n";

  consolidation.form_meso_skeleton();
  CGAL::Meso_skeleton_3<Kernel> skeleton;
  CGAL::meso_skeleton_to_graph(consolidation, skeleton);
  std::cout << "meso-skeleton: " << num_vertices(skeleton.graph) << " vertices, "
            << number_of_sheets(skeleton) << " sheets of " << skeleton.triangles.size() << " triangles, "
            << number_of_cycles(skeleton) << " cycles\n";

  consolidation.consolidate_outer_points();
  std::vector<CGAL::Deep_point_3<Kernel> > deep_points;
  consolidation.deep_points(std::back_inserter(deep_points));
  std::size_t completed = 0;
  for(std::size_t i = 0; i < consolidation.size(); ++i)
    completed += consolidation.data_density(i) < 1.5;
  std::cout << completed << " outer points lie where there are no data\n";

  for(const auto& stage : consolidation.stage_times())
    std::cout << stage.name << ": " << stage.iterations << " iterations\n";

  const auto outer = CGAL::parameters::point_map(CGAL::Deep_point_outer_map<Kernel>())
                       .normal_map(CGAL::Deep_point_normal_map<Kernel>())
                       .stream_precision(17);
  return CGAL::IO::write_meso_skeleton("meso_skeleton.ply", skeleton) &&
             CGAL::IO::write_points("outer_points.ply", deep_points, outer)
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
