// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "poisson_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Point_set_consolidation_3/internal/disjoint_sets.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/Random.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/make_surface_mesh.h>
#include <CGAL/property_map.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace support {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Oriented_point = std::pair<Point_3, Kernel::Vector_3>;
using Poisson_function = CGAL::Poisson_reconstruction_function<Kernel>;
using Tetrahedra = std::decay_t<decltype(std::declval<Poisson_function>().tr())>;

/// Numbers vertices and cells in the order of their creation. Without, CGAL's sets of handles are
/// ordered by address, and the mesher's result changes from call to call.
template <class Base>
class Numbered : public Base {
public:
  using Has_timestamp = CGAL::Tag_true;
  template <class Tds>
  struct Rebind_TDS {
    using Other = Numbered<typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using Base::Base;

  std::size_t time_stamp() const { return m_number; }
  void set_time_stamp(std::size_t number) { m_number = number; }

private:
  std::size_t m_number = std::size_t(-1);
};

// CGAL's Surface_mesh_default_triangulation_3, numbered.
using Mesher_traits = CGAL::Robust_circumcenter_traits_3<Kernel>;
using Mesher_vertex = Numbered<CGAL::Surface_mesh_vertex_base_3<Mesher_traits>>;
using Mesher_cell = Numbered<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
    Mesher_traits, CGAL::Surface_mesh_cell_base_3<Mesher_traits>>>;
using Mesher_triangulation = CGAL::Delaunay_triangulation_3<
    Mesher_traits, CGAL::Triangulation_data_structure_3<Mesher_vertex, Mesher_cell>>;
using Complex = CGAL::Surface_mesh_complex_2_in_triangulation_3<Mesher_triangulation>;
using CGAL::Point_set_consolidation_3::internal::Disjoint_sets;  // components are numbered by their first member
using Face = std::array<std::size_t, 3>;

/// A component carries data if it comes this close to an input point, in spacings: less than one, so that bubbles
/// between the points of a noisy part do not count.
constexpr double data_distance = 0.75;

/// Every component gets at least this many seeds: the restricted Delaunay triangulation of fewer
/// than about ten points of a small closed surface may have no facet at all.
constexpr std::size_t min_seeds_per_component = 12;

/// A component carries no data either if its diameter is less than this, in spacings: a vertex
/// whose value is positive by chance between negative ones makes such a bubble, while a body takes
/// some points to be sampled.
constexpr double min_component_diameter = 2;

/// Farthest-point sampling looks at no more candidates than this (its cost is seeds x candidates).
constexpr std::size_t max_seed_candidates = 20000;

/// The iso-surface is looked for on the mesh again at this many times more points than there were
/// seeds.
constexpr std::size_t checks_per_seed = 3;

/// A point of the iso-surface is missing if it is farther than this from the mesh, in spacings. The
/// mesher's own bound holds at the centres of facets only, 0.375 by default.
constexpr double missing_distance = 3;

/// The mesh of n points takes 5 to 250 n evaluations of about a microsecond; beyond this the mesher
/// is lost.
constexpr std::size_t max_evaluations_per_point = 2000;

/// CGAL's generators are seeded with the time and its errors are printed: both are set aside during
/// a call.
class Quiet_and_deterministic {
public:
  Quiet_and_deterministic()
    : m_random(CGAL::get_default_random()),
      m_handler(CGAL::set_error_handler(&be_silent)),
      m_buffer(std::cerr.rdbuf(nullptr))
  {
    CGAL::get_default_random() = CGAL::Random(0);
  }
  ~Quiet_and_deterministic()
  {
    CGAL::get_default_random() = m_random;
    CGAL::set_error_handler(m_handler);
    std::cerr.rdbuf(m_buffer);  // also clears the error state that writing to no buffer has set
  }
  Quiet_and_deterministic(const Quiet_and_deterministic&) = delete;
  Quiet_and_deterministic& operator=(const Quiet_and_deterministic&) = delete;

private:
  static void be_silent(const char*, const char*, const char*, int, const char*) {}

  CGAL::Random m_random;
  CGAL::Failure_function m_handler;
  std::streambuf* m_buffer;
};

/// Points are shifted to their box's centre and scaled to unit spacing, so that no absolute
/// tolerance ever meets the caller's unit.
struct Frame {
  Vec3 centre;
  double spacing;

  Vec3 to_local(const Vec3& p) const { return (p - centre) / spacing; }
  Vec3 to_caller(const Vec3& p) const { return centre + spacing * p; }
};

void check_input(const std::vector<Vec3>& points, const std::vector<Vec3>& normals)
{
  if(points.size() != normals.size())
    throw Method_error("poisson_mesh: " + std::to_string(points.size()) + " points but "
                       + std::to_string(normals.size()) + " normals");
  if(points.size() < 4)
    throw Method_error("poisson_mesh: fewer than 4 points");
  for(std::size_t i = 0; i < points.size(); ++i) {
    if(!points[i].allFinite())
      throw Method_error("poisson_mesh: a coordinate of point " + std::to_string(i)
                         + " is not finite");
    const double length = normals[i].stableNorm();
    if(!std::isfinite(length))
      throw Method_error("poisson_mesh: a coordinate of normal " + std::to_string(i)
                         + " is not finite");
    if(!(length > 0))
      throw Method_error("poisson_mesh: normal " + std::to_string(i) + " has length zero");
  }
}

bool lexicographically_less(const Vec3& a, const Vec3& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Average spacing counts copies of a point as neighbours at distance zero, hence they are removed
/// first (the first copy stays). Input order is kept.
std::vector<std::size_t> distinct_points(const std::vector<Vec3>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lexicographically_less(points[a], points[b]);
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::size_t a, std::size_t b) { return points[a] == points[b]; }),
              order.end());
  std::sort(order.begin(), order.end());
  return order;
}

/// Do the points lie on a plane, up to rounding? The Poisson function has no tetrahedra to be
/// defined on then.
bool is_flat(const std::vector<Vec3>& points)
{
  constexpr double rounding = 1e-9;
  Vec3 mean = Vec3::Zero();
  for(const Vec3& p : points)
    mean += p / double(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(const Vec3& p : points)
    covariance += (p - mean) * (p - mean).transpose();
  const Vec3 normal
      = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  double thickness = 0, extent = 0;
  for(const Vec3& p : points) {
    thickness = std::max(thickness, std::abs(normal.dot(p - mean)));
    extent = std::max(extent, (p - mean).norm());
  }
  return thickness <= rounding * extent;
}

/// Conjugate gradients, as CGAL's default solver, with two changes.
///
/// - The residual need not reach the precision of double: the mesher asks for 1e-3 of a spacing at
/// most.
/// - Regularly placed points (grids, rings of a tube) have cospherical neighbours, hence flat
/// tetrahedra, hence
///   weights of any size; they are cut, which ties the two vertices' values as well and keeps the
///   system solvable.
class Poisson_solver {
public:
  using Traits = CGAL::Eigen_solver_traits<
      Eigen::ConjugateGradient<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>;
  using Matrix = Traits::Matrix;
  using Vector = Traits::Vector;

  bool linear_solver(const Matrix& matrix, const Vector& b, Vector& x, double& d)
  {
    constexpr double tolerance = 1e-9;
    constexpr double usable = 1e-5;
    Sparse A = matrix.eigen_object();
    cut_weights(A);
    Eigen::ConjugateGradient<Sparse> solver;
    solver.setTolerance(tolerance);
    solver.compute(A);
    x = solver.solve(b.eigen_object());
    d = 1;
    return solver.info() != Eigen::NumericalIssue && solver.error() < usable;
  }

private:
  using Sparse = CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType;

  /// The lower triangle of A holds -weight off the diagonal and the sum of the row's weights (and
  /// more) on it.
  static void cut_weights(Sparse& A)
  {
    constexpr double max_weight
        = 1e4;  // times the median diagonal; a well-shaped tetrahedron's weights are below 1
    std::vector<double> diagonal(A.rows());
    for(int i = 0; i < A.rows(); ++i)
      diagonal[i] = A.coeff(i, i);
    std::nth_element(diagonal.begin(), diagonal.begin() + diagonal.size() / 2, diagonal.end());
    const double limit = max_weight * diagonal[diagonal.size() / 2];

    Eigen::VectorXd row_sum = Eigen::VectorXd::Zero(A.rows());
    std::vector<char> is_cut(A.rows(), false);
    for(int column = 0; column < A.outerSize(); ++column)
      for(Sparse::InnerIterator entry(A, column); entry; ++entry) {
        if(entry.row() == entry.col())
          continue;
        if(!(-entry.value() <= limit)) {
          entry.valueRef() = -limit;
          is_cut[entry.row()] = is_cut[entry.col()] = true;
        }
        row_sum[entry.row()] -= entry.value();
        row_sum[entry.col()] -= entry.value();
      }
    for(int i = 0; i < A.rows(); ++i)
      if(is_cut[i])
        A.coeffRef(i, i) = row_sum[i];
  }
};

/// Points in the cells of a cubic grid, to answer: is a point of the set within the grid's cell
/// size?
class Point_grid {
public:
  Point_grid(const std::vector<Vec3>& points, double cell) : m_points(points), m_cell(cell)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      m_cells[key(index(points[i]), 0, 0, 0)].push_back(i);
  }

  bool has_point_near(const Vec3& x) const
  {
    const auto centre = index(x);
    for(int dx = -1; dx <= 1; ++dx)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dz = -1; dz <= 1; ++dz) {
          const auto found = m_cells.find(key(centre, dx, dy, dz));
          if(found == m_cells.end())
            continue;
          for(std::size_t i : found->second)
            if((m_points[i] - x).squaredNorm() <= m_cell * m_cell)
              return true;
        }
    return false;
  }

private:
  using Index = std::array<std::int64_t, 3>;

  Index index(const Vec3& x) const
  {
    return {std::int64_t(std::floor(x[0] / m_cell)), std::int64_t(std::floor(x[1] / m_cell)),
            std::int64_t(std::floor(x[2] / m_cell))};
  }
  /// 21 bits per axis; cells that share a key only cost time, the distance decides.
  static std::uint64_t key(const Index& i, int dx, int dy, int dz)
  {
    constexpr std::uint64_t mask = (std::uint64_t(1) << 21) - 1;
    return (std::uint64_t(i[0] + dx) & mask) << 42 | (std::uint64_t(i[1] + dy) & mask) << 21
           | (std::uint64_t(i[2] + dz) & mask);
  }

  const std::vector<Vec3>& m_points;
  double m_cell;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> m_cells;
};

struct Too_many_evaluations : std::exception {};

/// The Poisson function, piecewise linear on the tetrahedra of a Delaunay triangulation.
///
/// Beyond the tetrahedra it is positive (outside), so that its zero set is closed. A vertex of
/// value zero counts as positive; thus sign changes along edges describe a 2-manifold without
/// special cases.
class Implicit_function {
public:
  using Cell = Tetrahedra::Cell_handle;

  Implicit_function(const Tetrahedra& tetrahedra, std::size_t max_evaluations)
    : m_tetrahedra(tetrahedra), m_budget(max_evaluations)
  {
    std::size_t count = 0;
    for(auto c = tetrahedra.all_cells_begin(); c != tetrahedra.all_cells_end(); ++c)
      c->info() = tetrahedra.is_infinite(c) ? -1 : int(count++);
    m_pieces.resize(count);
    for(auto c = tetrahedra.finite_cells_begin(); c != tetrahedra.finite_cells_end(); ++c)
      m_pieces[c->info()] = linear_piece(c);
    for(auto v = tetrahedra.finite_vertices_begin(); v != tetrahedra.finite_vertices_end(); ++v)
      m_extent = std::max(m_extent, position(v).norm());
    m_hint = tetrahedra.finite_cells_begin();
  }

  double operator()(const Point_3& p)
  {
    if(m_budget == 0)
      throw Too_many_evaluations();
    --m_budget;
    m_hint = m_tetrahedra.locate(Tetrahedra::Point(p), m_hint);
    if(m_tetrahedra.is_infinite(m_hint))
      return 1;
    const Piece& piece = m_pieces[m_hint->info()];
    return piece.value + piece.gradient.dot(Vec3(p.x(), p.y(), p.z()) - piece.origin);
  }

  void set_budget(std::size_t evaluations) { m_budget = evaluations; }
  const Tetrahedra& tetrahedra() const { return m_tetrahedra; }

  /// Radius of the sphere around the origin that holds all tetrahedra.
  double extent() const { return m_extent; }

  /// Index of the finite cell that holds p; -1 if there is none.
  int cell_of(const Vec3& p)
  {
    m_hint = m_tetrahedra.locate(Tetrahedra::Point(Point_3(p.x(), p.y(), p.z())), m_hint);
    return m_hint->info();
  }
  std::size_t number_of_cells() const { return m_pieces.size(); }

  static Vec3 position(Tetrahedra::Vertex_handle v)
  {
    return {v->point().x(), v->point().y(), v->point().z()};
  }
  static bool is_inside(Tetrahedra::Vertex_handle v) { return v->f() < 0; }

private:
  struct Piece {
    Vec3 origin;
    Vec3 gradient;
    double value;
  };

  static Piece linear_piece(Cell c)
  {
    const Vec3 origin = position(c->vertex(3));
    Eigen::Matrix3d edges;
    Vec3 differences;
    for(int i = 0; i < 3; ++i) {
      edges.row(i) = (position(c->vertex(i)) - origin).transpose();
      differences[i] = c->vertex(i)->f() - c->vertex(3)->f();
    }
    Vec3 gradient = edges.inverse() * differences;
    // A flat tetrahedron has no gradient; its neighbours carry the function.
    if(!gradient.allFinite())
      gradient.setZero();
    return {origin, gradient, c->vertex(3)->f()};
  }

  const Tetrahedra& m_tetrahedra;
  std::size_t m_budget;
  std::vector<Piece> m_pieces;
  double m_extent = 0;
  Cell m_hint;
};

/// The zero set, cell by cell: which cells it crosses, and which of them are joined through faces
/// it crosses.
struct Iso_surface {
  static constexpr int none = -1;

  struct Crossing {
    Implicit_function::Cell cell;
    int component;
    Vec3 point;  ///< centre of the zero set in the cell
  };
  std::vector<Crossing> crossings;
  std::vector<int> component_of_cell;  ///< none if the cell is not crossed
  std::vector<char> carries_data;      ///< per component
};

/// Point of the zero set on the edge from an inside vertex to an outside vertex.
Vec3 zero_on_edge(Tetrahedra::Vertex_handle inside, Tetrahedra::Vertex_handle outside)
{
  const double t = inside->f() / (inside->f() - outside->f());
  return Implicit_function::position(inside)
         + t * (Implicit_function::position(outside) - Implicit_function::position(inside));
}

Iso_surface trace_iso_surface(const Implicit_function& function, const Point_grid& data)
{
  const Tetrahedra& tetrahedra = function.tetrahedra();
  Iso_surface surface;
  surface.component_of_cell.assign(function.number_of_cells(), Iso_surface::none);
  Disjoint_sets joined(function.number_of_cells());

  for(auto c = tetrahedra.finite_cells_begin(); c != tetrahedra.finite_cells_end(); ++c) {
    Vec3 sum = Vec3::Zero();
    int zeros = 0;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        if(Implicit_function::is_inside(c->vertex(i))
           && !Implicit_function::is_inside(c->vertex(j))) {
          sum += zero_on_edge(c->vertex(i), c->vertex(j));
          ++zeros;
        }
    if(zeros == 0)
      continue;
    surface.crossings.push_back({c, Iso_surface::none, sum / zeros});
    for(int i = 0; i < 4; ++i) {
      if(tetrahedra.is_infinite(c->neighbor(i)))
        continue;
      int inside = 0;
      for(int j = 0; j < 4; ++j)
        if(j != i)
          inside += Implicit_function::is_inside(c->vertex(j));
      if(inside == 1 || inside == 2)
        joined.join(c->info(), c->neighbor(i)->info());
    }
  }

  std::vector<Eigen::AlignedBox3d> boxes;
  for(Iso_surface::Crossing& crossing : surface.crossings) {
    const std::size_t root = joined.find(crossing.cell->info());
    if(surface.component_of_cell[root] == Iso_surface::none) {
      surface.component_of_cell[root] = int(surface.carries_data.size());
      surface.carries_data.push_back(false);
      boxes.emplace_back();
    }
    crossing.component = surface.component_of_cell[root];
    surface.component_of_cell[crossing.cell->info()] = crossing.component;
    boxes[crossing.component].extend(crossing.point);
    if(!surface.carries_data[crossing.component] && data.has_point_near(crossing.point))
      surface.carries_data[crossing.component] = true;
  }
  for(std::size_t k = 0; k < boxes.size(); ++k)
    if(boxes[k].diagonal().norm() < min_component_diameter)
      surface.carries_data[k] = false;
  return surface;
}

/// Farthest-point sampling. Starts with `chosen` if it is not empty and appends until it holds
/// `count` points.
void sample_farthest_points(const std::vector<Vec3>& candidates, std::size_t count,
                            std::vector<Vec3>& chosen)
{
  if(candidates.empty())
    return;
  std::vector<double> distance(candidates.size(), std::numeric_limits<double>::infinity());
  const auto look_at = [&](const Vec3& p) {
    for(std::size_t i = 0; i < candidates.size(); ++i)
      distance[i] = std::min(distance[i], (candidates[i] - p).squaredNorm());
  };
  for(const Vec3& p : chosen)
    look_at(p);
  while(chosen.size() < count) {
    const std::size_t farthest
        = std::max_element(distance.begin(), distance.end()) - distance.begin();
    if(distance[farthest] == 0)
      return;
    chosen.push_back(candidates[farthest]);
    look_at(candidates[farthest]);
  }
}

/// Points of the iso-surface, well spread, enough on each component. The first of them are the
/// mesher's seeds, all of them are looked for on its mesh.
struct Seeds {
  std::vector<Vec3> points;
  std::vector<Vec3> checks;
};

Seeds spread_seeds(const Iso_surface& surface, std::size_t count)
{
  std::vector<std::vector<Vec3>> per_component(surface.carries_data.size());
  std::size_t total = 0;
  for(const auto& crossing : surface.crossings)
    if(surface.carries_data[crossing.component]) {
      per_component[crossing.component].push_back(crossing.point);
      ++total;
    }

  // Thin out evenly, but never to less than a component needs.
  const std::size_t stride = 1 + total / max_seed_candidates;
  std::vector<Vec3> candidates;
  for(const auto& all : per_component) {
    const std::size_t step
        = std::max<std::size_t>(1, std::min(stride, all.size() / (4 * min_seeds_per_component)));
    for(std::size_t i = 0; i < all.size(); i += step)
      candidates.push_back(all[i]);
  }

  Seeds seeds;
  sample_farthest_points(candidates, count, seeds.points);
  seeds.checks = seeds.points;
  sample_farthest_points(candidates, count * checks_per_seed, seeds.checks);
  for(const auto& all : per_component) {
    if(all.empty())
      continue;
    if(all.size() > max_seed_candidates / 4)
      continue;  // as large as this it has its share of the seeds
    std::vector<Vec3> own;
    sample_farthest_points(all, min_seeds_per_component, own);
    seeds.points.insert(seeds.points.end(), own.begin(), own.end());
    seeds.checks.insert(seeds.checks.end(), own.begin(), own.end());
  }
  return seeds;
}

Vec3 to_vec3(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

/// CGAL's surface mesher on the given seeds.
///
/// A facet belongs to the mesh if its two cells' circumcentres lie on different sides of the
/// surface. The facets are therefore the boundary of the cells with their centre inside, which also
/// orients them.
Triangle_mesh refine(Implicit_function& function, const std::vector<Vec3>& seeds,
                     const Poisson_options& options)
{
  using Surface = CGAL::Implicit_surface_3<Kernel, Implicit_function>;

  Mesher_triangulation triangulation;
  for(const Vec3& p : seeds)
    triangulation.insert(Point_3(p.x(), p.y(), p.z()));

  const double sphere_radius = 1.5 * function.extent();
  const double bisection_error = options.distance / 1000;
  const Surface surface([&function](const Point_3& p) { return function(p); },
                        Kernel::Sphere_3(CGAL::ORIGIN, sphere_radius * sphere_radius),
                        bisection_error / sphere_radius);
  const CGAL::Surface_mesh_default_criteria_3<Mesher_triangulation> criteria(
      options.angle, options.radius, options.distance);
  Complex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag(), 0);

  Triangle_mesh mesh;
  std::unordered_map<const void*, std::size_t> vertex_index;
  const auto index_of = [&](Mesher_triangulation::Vertex_handle v) {
    const auto inserted = vertex_index.emplace(&*v, mesh.vertices.size());
    if(inserted.second)
      mesh.vertices.push_back(to_vec3(v->point()));
    return inserted.first->second;
  };
  const auto is_inside = [&](Mesher_triangulation::Cell_handle c) {
    return !triangulation.is_infinite(c) && function(triangulation.dual(c)) < 0;
  };
  for(auto f = complex.facets_begin(); f != complex.facets_end(); ++f) {
    const auto cell = f->first;
    const int i = f->second;
    Face face;
    for(int k = 0; k < 3; ++k)
      face[k] = index_of(cell->vertex(Mesher_triangulation::vertex_triple_index(i, k)));
    // vertex_triple_index() lists the facet clockwise as seen from outside the cell.
    if(is_inside(cell))
      std::swap(face[1], face[2]);
    mesh.faces.push_back(face);
  }
  return mesh;
}

/// The iso-surface as it is: one or two triangles in each cell of the components that carry data.
Triangle_mesh marching_tetrahedra(const Iso_surface& surface)
{
  using Vertex = Tetrahedra::Vertex_handle;
  struct Pair_hash {
    std::size_t operator()(const std::pair<const void*, const void*>& e) const
    {
      return std::hash<const void*>()(e.first) * 1000003u + std::hash<const void*>()(e.second);
    }
  };
  Triangle_mesh mesh;
  std::unordered_map<std::pair<const void*, const void*>, std::size_t, Pair_hash> vertex_index;
  const auto index_of = [&](Vertex inside, Vertex outside) {
    const auto inserted
        = vertex_index.emplace(std::make_pair(&*inside, &*outside), mesh.vertices.size());
    if(inserted.second)
      mesh.vertices.push_back(zero_on_edge(inside, outside));
    return inserted.first->second;
  };

  for(const auto& crossing : surface.crossings) {
    if(!surface.carries_data[crossing.component])
      continue;
    // An even permutation of a positively oriented cell's vertices that lists the inside ones
    // first.
    std::array<Vertex, 4> v;
    int inside = 0;
    std::array<int, 4> order;
    for(int i = 0; i < 4; ++i)
      if(Implicit_function::is_inside(crossing.cell->vertex(i)))
        order[inside++] = i;
    for(int i = 0, k = inside; i < 4; ++i)
      if(!Implicit_function::is_inside(crossing.cell->vertex(i)))
        order[k++] = i;
    int inversions = 0;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
        inversions += order[i] > order[j];
    if(inversions % 2 == 1) {
      if(inside == 1)
        std::swap(order[2], order[3]);
      else
        std::swap(order[0], order[1]);
    }
    for(int i = 0; i < 4; ++i)
      v[i] = crossing.cell->vertex(order[i]);

    if(inside == 1) {
      mesh.faces.push_back({index_of(v[0], v[1]), index_of(v[0], v[2]), index_of(v[0], v[3])});
    } else if(inside == 3) {
      mesh.faces.push_back({index_of(v[0], v[3]), index_of(v[1], v[3]), index_of(v[2], v[3])});
    } else {
      const std::size_t a = index_of(v[0], v[2]), b = index_of(v[0], v[3]);
      const std::size_t c = index_of(v[1], v[3]), d = index_of(v[1], v[2]);
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Every edge has exactly two faces, in opposite directions, and the faces around every vertex form
/// one fan.
bool is_closed_manifold(const Triangle_mesh& mesh)
{
  std::unordered_map<std::uint64_t, std::size_t> face_of_edge;
  face_of_edge.reserve(3 * mesh.faces.size());
  const std::uint64_t n = mesh.vertices.size();
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    for(int k = 0; k < 3; ++k)
      if(!face_of_edge.emplace(mesh.faces[f][k] * n + mesh.faces[f][(k + 1) % 3], f).second)
        return false;

  std::vector<std::size_t> degree(n, 0);
  std::vector<std::size_t> a_face(n, 0);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    for(std::size_t v : mesh.faces[f]) {
      ++degree[v];
      a_face[v] = f;
    }
  for(std::size_t v = 0; v < n; ++v) {
    if(degree[v] == 0)
      continue;
    std::size_t walked = 0;
    std::size_t f = a_face[v];
    do {
      const Face& face = mesh.faces[f];
      const int k = face[0] == v ? 0 : face[1] == v ? 1 : 2;
      const auto next = face_of_edge.find(v * n + face[(k + 2) % 3]);
      if(next == face_of_edge.end())
        return false;
      f = next->second;
      ++walked;
    } while(f != a_face[v] && walked <= degree[v]);
    if(walked != degree[v])
      return false;
  }
  return true;
}

/// Keeps the connected components that lie on components of the iso-surface with data: where most
/// of their vertices are found decides. Bubbles, see min_component_diameter, are dropped here as
/// well.
Triangle_mesh keep_data_components(const Triangle_mesh& mesh, const Iso_surface& surface,
                                   Implicit_function& function)
{
  Disjoint_sets joined(mesh.vertices.size());
  for(const Face& f : mesh.faces) {
    joined.join(f[0], f[1]);
    joined.join(f[1], f[2]);
  }
  std::vector<long> votes(mesh.vertices.size(), 0);
  std::vector<Eigen::AlignedBox3d> boxes(mesh.vertices.size());
  for(std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    boxes[joined.find(v)].extend(mesh.vertices[v]);
    const int cell = function.cell_of(mesh.vertices[v]);
    const int component = cell < 0 ? Iso_surface::none : surface.component_of_cell[cell];
    if(component != Iso_surface::none)
      votes[joined.find(v)] += surface.carries_data[component] ? 1 : -1;
  }

  Triangle_mesh kept;
  constexpr std::size_t not_yet = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> new_index(mesh.vertices.size(), not_yet);
  for(const Face& f : mesh.faces) {
    const std::size_t root = joined.find(f[0]);
    if(votes[root] <= 0 || boxes[root].diagonal().norm() < min_component_diameter)
      continue;
    Face face;
    for(int k = 0; k < 3; ++k) {
      if(new_index[f[k]] == not_yet) {
        new_index[f[k]] = kept.vertices.size();
        kept.vertices.push_back(mesh.vertices[f[k]]);
      }
      face[k] = new_index[f[k]];
    }
    kept.faces.push_back(face);
  }
  return kept;
}

double squared_distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 n = (b - a).cross(c - a);
  const bool over_ab = n.cross(b - a).dot(p - a) >= 0;
  const bool over_bc = n.cross(c - b).dot(p - b) >= 0;
  const bool over_ca = n.cross(a - c).dot(p - c) >= 0;
  if(n.squaredNorm() > 0 && over_ab && over_bc && over_ca)
    return std::pow(n.dot(p - a), 2) / n.squaredNorm();
  const auto to_segment = [&](const Vec3& s, const Vec3& t) {
    const double length = (t - s).squaredNorm();
    const double u = length > 0 ? std::clamp((p - s).dot(t - s) / length, 0., 1.) : 0.;
    return (s + u * (t - s) - p).squaredNorm();
  };
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

/// Those of `points` that are farther than `distance` from the mesh.
std::vector<Vec3> points_off_mesh(const std::vector<Vec3>& points, const Triangle_mesh& mesh,
                                  double distance)
{
  std::vector<char> near(points.size(), false);
  std::vector<std::size_t> by_x(points.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t(0));
  std::sort(by_x.begin(), by_x.end(),
            [&](std::size_t a, std::size_t b) { return points[a].x() < points[b].x(); });
  std::vector<double> x(points.size());
  for(std::size_t i = 0; i < by_x.size(); ++i)
    x[i] = points[by_x[i]].x();

  for(const Face& f : mesh.faces) {
    const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
    const Vec3 low = a.cwiseMin(b).cwiseMin(c).array() - distance;
    const Vec3 high = a.cwiseMax(b).cwiseMax(c).array() + distance;
    for(std::size_t i = std::lower_bound(x.begin(), x.end(), low.x()) - x.begin();
        i < x.size() && x[i] <= high.x(); ++i) {
      const Vec3& p = points[by_x[i]];
      if(near[by_x[i]] || p.y() < low.y() || p.y() > high.y() || p.z() < low.z()
         || p.z() > high.z())
        continue;
      near[by_x[i]] = squared_distance_to_triangle(p, a, b, c) <= distance * distance;
    }
  }
  std::vector<Vec3> off;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!near[i])
      off.push_back(points[i]);
  return off;
}

/// The mesher, given more seeds where its mesh misses a part, fewer where it fails; in the end
/// marching tetrahedra.
Triangle_mesh mesh_iso_surface(Implicit_function& function, const Iso_surface& surface,
                               const Poisson_options& options, std::size_t max_evaluations)
{
  constexpr int max_attempts = 3;
  std::size_t count = std::max(options.seeds, min_seeds_per_component);
  for(int attempt = 0; attempt < max_attempts;
      ++attempt, count = std::max(count / 4, min_seeds_per_component)) {
    Triangle_mesh best;
    std::size_t fewest_missing = std::numeric_limits<std::size_t>::max();
    try {
      Seeds seeds = spread_seeds(surface, count);
      // Spikes thinner than a spacing, as outliers make them, stay missing whatever the seeds: more
      // seeds are worth their time only while they help.
      for(;;) {
        function.set_budget(max_evaluations);
        Triangle_mesh mesh
            = keep_data_components(refine(function, seeds.points, options), surface, function);
        if(mesh.empty() || !is_closed_manifold(mesh))
          break;
        const std::vector<Vec3> missing = points_off_mesh(seeds.checks, mesh, missing_distance);
        const bool helped = missing.size() <= fewest_missing / 2;
        if(missing.size() < fewest_missing) {
          best = std::move(mesh);
          fewest_missing = missing.size();
        }
        if(missing.empty() || !helped)
          break;
        seeds.points.insert(seeds.points.end(), missing.begin(), missing.end());
      }
    } catch(const CGAL::Failure_exception&) {
      // "... is already inserted on surface": the mesher cannot separate two points.
    } catch(const std::overflow_error&) {
      // "Division by zero": the exact circumcentre of a flat tetrahedron.
    } catch(const Too_many_evaluations&) {
      // The mesher does not come to an end, with fewer seeds neither.
      attempt = max_attempts;
    }
    if(!best.empty())
      return best;
  }
  return marching_tetrahedra(surface);
}

}  // namespace

Triangle_mesh poisson_mesh(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                           const Poisson_options& options)
{
  check_input(points, normals);
  const Quiet_and_deterministic guard;

  Frame frame;
  Vec3 low = points.front(), high = points.front();
  for(const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  frame.centre = low + 0.5 * (high - low);
  const double diagonal = (high - low).norm();
  if(!std::isfinite(diagonal))
    throw Method_error("poisson_mesh: the points' extent is not finite");

  const std::vector<std::size_t> distinct = distinct_points(points);
  if(distinct.size() < 4)
    throw Method_error("poisson_mesh: fewer than 4 distinct points");

  // First in units of the diagonal, to compute the spacing; then in units of the spacing.
  frame.spacing = diagonal;
  std::vector<Oriented_point> oriented(distinct.size());
  for(std::size_t i = 0; i < distinct.size(); ++i) {
    const Vec3 p = frame.to_local(points[distinct[i]]);
    const Vec3 n = normals[distinct[i]].stableNormalized();
    oriented[i] = {Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z())};
  }
  const auto point_map = CGAL::First_of_pair_property_map<Oriented_point>();
  const auto normal_map = CGAL::Second_of_pair_property_map<Oriented_point>();
  const double spacing = options.spacing > 0
                             ? options.spacing / diagonal
                             : CGAL::compute_average_spacing<CGAL::Sequential_tag>(
                                 oriented, 6, CGAL::parameters::point_map(point_map));
  if(!(spacing > 0) || !std::isfinite(1 / spacing))
    throw Method_error("poisson_mesh: the points' spacing is zero");

  frame.spacing = spacing * diagonal;
  std::vector<Vec3> local(distinct.size());
  for(std::size_t i = 0; i < distinct.size(); ++i) {
    local[i] = frame.to_local(points[distinct[i]]);
    oriented[i].first = Point_3(local[i].x(), local[i].y(), local[i].z());
  }

  if(is_flat(local))
    throw Method_error("poisson_mesh: the points lie on a plane or a line");

  const std::size_t max_evaluations
      = max_evaluations_per_point * std::max<std::size_t>(distinct.size(), 1000);
  Triangle_mesh mesh;
  try {
    Poisson_function poisson(oriented.begin(), oriented.end(), point_map, normal_map);
    if(!poisson.compute_implicit_function(Poisson_solver()))
      throw Method_error("poisson_mesh: the Poisson equation could not be solved");
    Implicit_function function(poisson.tr(), max_evaluations);
    const Point_grid data(local, data_distance);
    const Iso_surface surface = trace_iso_surface(function, data);
    if(std::find(surface.carries_data.begin(), surface.carries_data.end(), char(true))
       == surface.carries_data.end())
      throw Method_error("poisson_mesh: the implicit function has no zero set near the points");
    mesh = mesh_iso_surface(function, surface, options, max_evaluations);
  } catch(const CGAL::Failure_exception& e) {
    throw Method_error("poisson_mesh: the implicit function could not be computed (" + e.message()
                       + ")");
  } catch(const std::overflow_error& e) {
    throw Method_error(std::string("poisson_mesh: the implicit function could not be computed (") + e.what()
                       + ")");
  }
  if(mesh.empty())
    throw Method_error("poisson_mesh: there is no surface");

  for(Vec3& p : mesh.vertices)
    p = frame.to_caller(p);
  return mesh;
}

}  // namespace support
