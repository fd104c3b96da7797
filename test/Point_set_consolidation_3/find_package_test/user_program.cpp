// A user's program: half of a tube, seen from one side, is completed. With TBB the compiled core is used, without it is all
// in the headers, and the results, which are written to a file, are the same.
#undef NDEBUG
#include <CGAL/Deep_point_3.h>
#include <CGAL/Point_set_consolidation_3/version.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/deep_points_consolidate_point_set.h>

#include <cassert>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#ifndef CGAL_EIGEN3_ENABLED
#error "the target must bring Eigen"
#endif

#ifdef CGAL_POINT_SET_CONSOLIDATION_3_HEADER_ONLY
const bool uses_compiled_core = false;
#else
const bool uses_compiled_core = true;
#endif

// The arguments say whether TBB has to be there and whether the compiled core has to be used, and name the file.
int main(int argc, char** argv)
{
  assert(argc == 4);
#ifdef CGAL_LINKED_WITH_TBB
  assert(std::string(argv[1]) == "ON");
#else
  assert(std::string(argv[1]) == "OFF");
#endif
  assert(std::string(argv[2]) == (uses_compiled_core ? "ON" : "OFF"));

  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points;
  for(int i = 0; i < 80; ++i)
    for(int j = 0; j < 40; ++j) {
      const double angle = CGAL_PI * (j + 0.5 * (i % 2)) / 40;
      points.emplace_back(std::cos(angle), std::sin(angle), i * 0.08);
    }
  std::vector<CGAL::Deep_point_3<Kernel>> deep_points;
  CGAL::deep_points_consolidate_point_set<CGAL::Parallel_if_available_tag>(
      points, std::back_inserter(deep_points),
      CGAL::Point_set_consolidation_3::parameters::number_of_output_points(600).number_of_surface_iterations(20));
  assert(deep_points.size() == 600);
  std::ofstream file(argv[3]);
  file.precision(17);
  for(const auto& deep_point : deep_points) {
    assert(std::isfinite(deep_point.outer().x()) && std::isfinite(deep_point.inner().x()));
    file << deep_point.outer() << ' ' << deep_point.inner() << ' ' << deep_point.normal() << '\n';
  }
  file.close();
  assert(file);
}
