#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Curve_skeleton_3<Kernel> Skeleton;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

int main()
{
  // the upper half of a bent tube of radius 0.2, as a scanner above it sees it; a piece of it is missing
  CGAL::Random random(1);
  std::vector<Point> points;
  while(points.size() < 2000) {
    const double u = random.get_double(0, 3), v = random.get_double(0, CGAL_PI);
    if(u > 1.4 && u < 1.6)
      continue;
    const Vector along(std::cos(u), std::sin(u), 0), up(0, 0, 1);
    points.push_back(CGAL::ORIGIN + along + 0.2 * (std::cos(v) * along + std::sin(v) * up));
  }

  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton<Concurrency_tag>(points, skeleton,
                                                   params::number_of_samples(300).sampling_radius(0.03));
  double farthest = 0;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Point& p = skeleton[v].point;
    farthest = (std::max)(farthest, std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()));
  }
  std::cout << num_vertices(skeleton) << " vertices, " << num_edges(skeleton) << " edges, "
            << CGAL::number_of_skeleton_components(skeleton) << " components, at most " << farthest
            << " from the tube's axis\n";
  return CGAL::IO::write_curve_skeleton("tube_skeleton.polylines.txt", skeleton) ? EXIT_SUCCESS : EXIT_FAILURE;
}
