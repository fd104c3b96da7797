#undef NDEBUG
#include <CGAL/Point_set_consolidation_3/parameters.h>
#include <CGAL/Point_set_consolidation_3/version.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/compute_average_spacing.h>

#include <cassert>
#include <string>
#include <vector>

namespace params = CGAL::Point_set_consolidation_3::parameters;

#ifndef CGAL_EIGEN3_ENABLED
#error "the target must bring Eigen"
#endif

// The argument says whether TBB has to be there.
int main(int argc, char** argv)
{
  assert(argc == 2);
#ifdef CGAL_LINKED_WITH_TBB
  assert(std::string(argv[1]) == "ON");
#else
  assert(std::string(argv[1]) == "OFF");
#endif

  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  for(int i = 0; i < 10; ++i)
    points.emplace_back(i, 0, 0);
  const auto np = params::collision_angle(45.).number_of_iterations(3);
  const double spacing = CGAL::compute_average_spacing<CGAL::Parallel_if_available_tag>(
      points, 2, np.cgal_parameters());
  assert(spacing > 0);
}
