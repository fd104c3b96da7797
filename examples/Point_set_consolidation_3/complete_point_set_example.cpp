#include <CGAL/complete_point_set.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;

int main(int argc, char* argv[])
{
  const std::string input =
    (argc > 1) ? argv[1] : CGAL::data_file_path("points_3/hippo1.ply");
  std::vector<Point> points;
  if(!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "Error: cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // The range of indices is completed; positions and results are in vectors beside it.
  std::vector<std::size_t> indices(points.size());
  for(std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  std::vector<Point> denoised(points.size());
  std::vector<Vector> normals(points.size());
  std::vector<CGAL::Completed_point_3<Kernel> > missing;
  std::vector<std::size_t> outliers;

  namespace params = CGAL::Point_set_consolidation_3::parameters;
  CGAL::complete_point_set<CGAL::Parallel_if_available_tag>(
    indices, std::back_inserter(missing),
    params::point_map(CGAL::make_property_map(points))
      .denoised_point_map(CGAL::make_property_map(denoised))
      .denoised_normal_map(CGAL::make_property_map(normals))
      .outlier_output_iterator(std::back_inserter(outliers)));

  // what to mesh: the scan without outliers, oriented and if need be denoised, and the missing points
  std::vector<Oriented_point> completed;
  for(const std::size_t i : indices)
    if(!std::binary_search(outliers.begin(), outliers.end(), i))
      completed.emplace_back(denoised[i], normals[i]);
  for(const CGAL::Completed_point_3<Kernel>& p : missing)
    completed.emplace_back(p.outer(), p.normal());
  std::cout << points.size() << " points, " << outliers.size() << " outliers, " << missing.size()
            << " completed" << std::endl;

  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())
                      .stream_precision(17);
  return CGAL::IO::write_points("completed.ply", completed, maps) ? EXIT_SUCCESS : EXIT_FAILURE;
}
