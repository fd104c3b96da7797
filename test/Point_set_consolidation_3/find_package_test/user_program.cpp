// A user's program: half of a tube, seen from one side, is completed. That takes a minute to compile and with TBB other
// tests do it, so with TBB only one step is taken.
#undef NDEBUG
#include <CGAL/Point_set_consolidation_3/version.h>
#include <CGAL/Simple_cartesian.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <CGAL/mean_shift_remove_outliers.h>
#else
#include <CGAL/Deep_point_3.h>
#include <CGAL/deep_points_consolidate_point_set.h>
#endif

#include <cassert>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

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

  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points;
  for(int i = 0; i < 80; ++i)
    for(int j = 0; j < 40; ++j) {
      const double angle = CGAL_PI * (j + 0.5 * (i % 2)) / 40;
      points.emplace_back(std::cos(angle), std::sin(angle), i * 0.08);
    }

#ifdef CGAL_LINKED_WITH_TBB
  points.emplace_back(0, 0, 30);
  std::vector<Kernel::Point_3> inliers;
  CGAL::mean_shift_remove_outliers<CGAL::Parallel_tag>(points, std::back_inserter(inliers));
  points.pop_back();
  assert(inliers == points);
#else
  std::vector<CGAL::Deep_point_3<Kernel>> deep_points;
  CGAL::deep_points_consolidate_point_set<CGAL::Parallel_if_available_tag>(
      points, std::back_inserter(deep_points),
      CGAL::Point_set_consolidation_3::parameters::number_of_output_points(600).number_of_surface_iterations(20));
  assert(deep_points.size() == 600);
  for(const auto& deep_point : deep_points)
    assert(std::isfinite(deep_point.outer().x()) && std::isfinite(deep_point.inner().x()));
#endif
}
