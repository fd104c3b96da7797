#include <CGAL/Curve_skeleton_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Curve_skeleton_3<Kernel> Skeleton;
typedef boost::graph_traits<Skeleton>::vertex_descriptor Vertex;

namespace editing = CGAL::Curve_skeleton_editing;

// What CGAL does with a graph of polylines works here as well.
struct Count_polylines {
  const Skeleton& skeleton;
  std::size_t polylines = 0, vertices = 0;
  void start_new_polyline() { ++polylines; }
  void add_node(Vertex) { ++vertices; }
  void end_polyline() {}
};

int main()
{
  // a trunk with a gap, and a spur
  Skeleton skeleton;
  for(const double z : {0., 1., 2., 4., 5., 6.})
    editing::add_vertex(skeleton, Point(0, 0, z), 0.5);
  editing::add_vertex(skeleton, Point(0.2, 0, 1), 0.1);
  for(const std::size_t v : {0, 1, 3, 4})
    editing::connect(skeleton, v, v + 1);
  editing::connect(skeleton, 1, 6);
  std::cout << CGAL::number_of_skeleton_components(skeleton) << " components\n";

  editing::prune_spurs(skeleton, 0.3);
  editing::bridge_components(skeleton, 3);
  editing::move_vertex(skeleton, 2, Point(0.1, 0, 2));
  editing::set_radius(skeleton, 3, 0);
  editing::interpolate_radii(skeleton);  // where they are not known
  editing::extend_tips(skeleton);        // by the radius, to where the shape ends

  Count_polylines count{skeleton};
  CGAL::split_graph_into_polylines(skeleton, count);
  std::cout << CGAL::number_of_skeleton_components(skeleton) << " component, " << count.polylines
            << " polyline of " << count.vertices << " vertices; radius of vertex 3: "
            << skeleton[3].radius << '\n';
  const bool written = CGAL::IO::write_curve_skeleton("edited.ply", skeleton);
  Skeleton read;
  return written && CGAL::IO::read_curve_skeleton("edited.ply", read) && count.polylines == 1 &&
             num_vertices(read) == count.vertices
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
