#include <CGAL/skeleton_driven_surface_reconstruction.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Curve_skeleton_3<Kernel> Skeleton;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace params = CGAL::Point_set_consolidation_3::parameters;

// A ring of radius 1 and thickness 0.25 of which two parts were not scanned.
std::vector<Point> incomplete_ring()
{
  const double pi = 3.14159265358979324;
  std::vector<Point> points;
  CGAL::Random random(1);
  while(points.size() < 5000) {
    const double u = random.get_double(0, 2 * pi), v = random.get_double(0, 2 * pi);
    const double r = 1 + 0.25 * std::cos(v);
    if(std::abs(std::sin(u)) > 0.3)
      points.emplace_back(r * std::cos(u), r * std::sin(u), 0.25 * std::sin(v));
  }
  return points;
}

int main()
{
  const std::vector<Point> points = incomplete_ring();
  Skeleton skeleton;
  CGAL::extract_laplacian_contraction_skeleton<Concurrency_tag>(
    points, skeleton, params::extend_tips(false).k_neighbors(30));
  std::cout << "skeleton: " << CGAL::number_of_skeleton_components(skeleton) << " components, "
            << CGAL::number_of_skeleton_cycles(skeleton) << " cycles\n";

  // At the rims of the gaps the skeleton ends in small spurs off the axis: their radii tell.
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    if(degree(v, skeleton) == 1 && skeleton[v].radius < 0.2) {
      clear_vertex(v, skeleton);
      remove_vertex(v, skeleton);
      v = std::size_t(-1);  // from the start
    }

  // The repair: both halves are joined at both ends. It could as well be a file that the user keeps.
  std::vector<std::size_t> tips[2];  // with x > 0 and x < 0
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    if(degree(v, skeleton) == 1)
      tips[skeleton[v].point.x() < 0].push_back(v);
  std::ostringstream repair;
  for(const std::vector<std::size_t>& side : tips) {
    if(side.size() != 2)
      return EXIT_FAILURE;
    const std::size_t middle = num_vertices(skeleton) + std::size_t(&side - tips);
    repair << "add " << (&side == tips ? 1 : -1) << " 0 0   # vertex " << middle << "\n"
           << "connect " << side[0] << " " << middle << "\n"
           << "connect " << side[1] << " " << middle << "\n"
           << "interpolate " << side[0] << " " << side[1] << "\n";
  }
  std::istringstream edits(repair.str());
  CGAL::Curve_skeleton_editing::apply_edits(skeleton, edits);
  CGAL::IO::write_curve_skeleton("repaired_skeleton.ply", skeleton);

  Mesh mesh;
  CGAL::skeleton_driven_surface_reconstruction<Concurrency_tag>(points, skeleton, mesh);
  const long euler = long(num_vertices(mesh)) + long(num_faces(mesh)) - long(num_edges(mesh));
  std::cout << num_faces(mesh) << " faces, genus " << (2 - euler) / 2 << "\n";
  CGAL::IO::write_OFF("ring.off", mesh);
  return CGAL::is_closed(mesh) && euler == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
