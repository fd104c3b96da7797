// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LAPLACIAN_CONTRACTION_SKELETONIZATION_3_H
#define CGAL_LAPLACIAN_CONTRACTION_SKELETONIZATION_3_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_consolidation_3/core/curve_skeletons.h>
#include <CGAL/Point_set_consolidation_3/internal/range_access.h>
#include <CGAL/Point_set_consolidation_3/parameters.h>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Skeletons

  Curve skeletons of point sets by Laplacian contraction \cgalCite{cgal:ctowz-pcsvl-10}, with the paper's steps as
  members, for users who want to look at, or change, what happens in between. The function
  `extract_laplacian_contraction_skeleton()` runs all of them.

  The object copies what it needs at construction; the input is neither changed nor reordered. A step runs
  the steps that it needs before it. Results do not depend on `ConcurrencyTag`, bit for bit, nor on the
  unit of the input.

  Complexity: \f$O(n^{1.5})\f$ in the number of contracted points, nearly all of it the factorisations of
  `contract_geometry()`.

  \tparam Traits a model of `Kernel`, floating point coordinates.
  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
*/
template <typename Traits, typename ConcurrencyTag = Sequential_tag>
class Laplacian_contraction_skeletonization_3 {
  /// \cond SKIP_IN_MANUAL
  typedef Point_set_consolidation_3::internal::Vec3 Vec3;
  typedef Point_set_consolidation_3::internal::Points Points;
  typedef Point_set_consolidation_3::internal::Cancelled Cancelled;
  typedef Point_set_consolidation_3::internal::Laplacian_extraction Core;
  typedef Point_set_consolidation_3::internal::Laplacian_skeleton_parameters Parameters;
  static constexpr const char* function_name = "extract_laplacian_contraction_skeleton";
  /// \endcond

public:
  /// number type of the coordinates
  typedef typename Traits::FT FT;
  /// type of points
  typedef typename Traits::Point_3 Point_3;
  /// the graph
  typedef Curve_skeleton_3<Traits> Skeleton;
  /// Name, seconds and iterations of a stage.
  typedef Point_set_consolidation_3::Stage_time Stage_time;

  /*!
    copies the points and reads the parameters.

    \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
    \param points at least 4 points, all coordinates finite.
    \param np the named parameters of `extract_laplacian_contraction_skeleton()`.
    \throws std::invalid_argument if a parameter or a coordinate is out of its range.
  */
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit Laplacian_contraction_skeletonization_3(
    const PointRange& points, const NamedParameters& np = parameters::default_values())
  {
    using namespace Point_set_consolidation_3::internal;
    const auto& cgal = cgal_np(np);
    const Parameters read = read_parameters(cgal, default_samples);
    const Points positions = copy_points(function_name, points, cgal, least_points);
    const Points normals = copy_normals(function_name, points, cgal);
    m_core = std::make_unique<Core>(make_execution<ConcurrencyTag>(callback_of(cgal)), positions,
                                    normals, Points(), read);
  }

  /*!
    samples a soup of polygons: surfaces with or without boundary, in any orientation, connected or not. The
    vertices of the skeleton stand for vertices of the soup.

    \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
    \tparam PolygonRange a model of `ConstRange` whose value type is a range of indices; polygons with more than three
    vertices should be convex.
    \param points the vertices, all coordinates finite.
    \param polygons at least three indices each.
    \param np the named parameters of `extract_laplacian_contraction_skeleton()`.
    \throws std::invalid_argument if a parameter, an index or a coordinate is out of its range, or the
    polygons have no area.
  */
  template <typename PointRange, typename PolygonRange, typename NamedParameters>
  Laplacian_contraction_skeletonization_3(const PointRange& points, const PolygonRange& polygons,
                                          const NamedParameters& np)
  {
    using namespace Point_set_consolidation_3::internal;
    const auto& cgal = cgal_np(np);
    const Parameters read = read_parameters(cgal, default_soup_samples);
    const Points vertices = copy_points(function_name, points, cgal, 3);
    std::vector<std::array<std::size_t, 3> > triangles;
    for(const auto& polygon : polygons) {
      std::vector<std::size_t> corners;
      for(const auto& corner : polygon) {
        corners.push_back(std::size_t(corner));
        require(corners.back() < vertices.size(), function_name,
                "polygons has an index that no point has");
      }
      for(std::size_t k = 2; k < corners.size(); ++k)
        triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
    const std::uint64_t seed = parameter_or(
      cgal, Point_set_consolidation_3::internal_np::random_seed, std::uint64_t(0));
    const Points samples = sample_triangles(vertices, triangles, read.most_samples, seed);
    require(samples.size() >= least_points, function_name, "polygons have no area");
    m_core = std::make_unique<Core>(make_execution<ConcurrencyTag>(callback_of(cgal)), samples, Points(),
                                    vertices, read);
  }

  /// \name Steps
  /// Each returns `false` if the callback stopped it.
  /// @{

  /// contracts the points once: one solution of equation (1). The rings are computed before the
  /// first time. `has_converged()` tells whether another time makes sense.
  bool contract_geometry()
  {
    return run([&] { m_has_converged = !m_core->contract_geometry(); });
  }

  /// contracts the points until their mean extent decreases no more (section III.A).
  bool contract_until_convergence()
  {
    return run([&] {
      m_core->contract_until_convergence();
      m_has_converged = true;
    });
  }

  /// samples the contracted points and connects samples that are neighbours on the surface (section
  /// III.B). The points are those contracted so far.
  bool build_graph()
  {
    return run([&] {
      m_core->build_graph();
      m_state = GRAPH;
    });
  }

  /// collapses edges until the graph has no triangle, and merges short cycles (section III.B).
  bool thin()
  {
    return (m_state >= GRAPH || build_graph()) && run([&] {
      m_core->thin();
      m_state = THIN;
    });
  }

  /// moves nodes to the centre of their points, by normals if they were given, and gives them radii.
  bool recentre()
  {
    return (m_state >= THIN || thin()) && run([&] { m_core->recentre(); });
  }

  /// adds nodes where the skeleton, continued beyond its tips, meets the end of the shape.
  bool extend_tips()
  {
    return (m_state >= THIN || thin()) && run([&] { m_core->extend_tips(); });
  }

  /// runs all steps that are left.
  bool extract()
  {
    return contract_until_convergence() && build_graph() && thin() && recentre() && extend_tips() &&
           run([&] { m_core->execution().progress.finish(); });
  }

  /// @}
  /// \name Results
  /// @{

  /// whether the contraction has come to its end
  bool has_converged() const { return m_has_converged; }
  /// number of contractions so far
  std::size_t number_of_iterations() const { return m_core->number_of_iterations(); }
  /// \f$W_L^0\f$, for points scaled to a longest box side of 1.6; 0 before the first contraction
  double initial_contraction_weight() const { return m_core->initial_contraction_weight(); }
  /// writes the contracted place of each point, in the order of the input (soups: of the samples), as `Point_3`.
  template <typename OutputIterator>
  OutputIterator contracted_points(OutputIterator output) const
  {
    for(const Vec3& p : m_core->contracted_points())
      *output++ = Point_3(FT(p.x()), FT(p.y()), FT(p.z()));
    return output;
  }
  /// assigns the graph in its present state to `skeleton`.
  void skeleton(Skeleton& skeleton) const
  {
    Point_set_consolidation_3::internal::assign<Traits>(skeleton, m_core->skeleton());
  }
  /// seconds and iterations of the stages so far
  const std::vector<Stage_time>& stage_times() const { return m_core->execution().times; }

  /// @}

private:
  /// \cond SKIP_IN_MANUAL
  enum State { POINTS, GRAPH, THIN };
  static constexpr std::size_t least_points = 4;
  static constexpr std::size_t default_samples = 20000;       // about five seconds
  static constexpr std::size_t default_soup_samples = 10000;  // the paper's number

  template <typename Work>
  bool run(const Work& work)
  {
    try {
      work();
    }
    catch(const Cancelled&) {
      return false;
    }
    return true;
  }

  template <typename NP>
  static Parameters read_parameters(const NP& np, std::size_t samples)
  {
    using namespace Point_set_consolidation_3::internal;
    namespace names = Point_set_consolidation_3::internal_np;
    const char* const f = function_name;
    Parameters p;
    if constexpr(has_parameter<NP, names::k_neighbors_t>) {
      p.neighbors = parameter_or(np, names::k_neighbors, std::size_t(0));
      require(p.neighbors >= 4, f, "k_neighbors must be at least 4");
    }
    p.most_samples = parameter_or(np, names::number_of_samples, samples);
    require(p.most_samples >= least_points, f, "number_of_samples must be at least 4");
    Point_set_consolidation_3::internal::Contraction_parameters& c = p.contraction;
    c.weights = enumerator(f, np, names::laplacian_weights, "laplacian_weights", c.weights,
                           Point_set_consolidation_3::Laplacian_weights::COMBINATORIAL);
    c.contraction_weight =
      positive(f, np, names::contraction_weight, "contraction_weight", c.contraction_weight);
    c.attraction_weight =
      positive(f, np, names::attraction_weight, "attraction_weight", c.attraction_weight);
    c.contraction_factor =
      positive(f, np, names::contraction_factor, "contraction_factor", c.contraction_factor);
    require(c.contraction_factor >= 1, f, "contraction_factor must be at least 1");
    c.threshold =
      positive(f, np, names::convergence_threshold, "convergence_threshold", c.threshold);
    c.max_iterations = parameter_or(np, names::number_of_iterations, c.max_iterations);
    require(c.max_iterations >= 1 && c.max_iterations <= 1000, f,
            "number_of_iterations must be in [1, 1000]");
    p.sampling_radius =
      positive(f, np, names::sampling_radius, "sampling_radius", p.sampling_radius);
    require(p.sampling_radius >= 0.001 && p.sampling_radius <= 1, f,
            "sampling_radius must be in [0.001, 1]");
    p.largest_merged_cycle =
      parameter_or(np, names::largest_merged_cycle, p.largest_merged_cycle);
    p.extend_tips = parameter_or(np, names::extend_tips, p.extend_tips);
    return p;
  }

  std::unique_ptr<Core> m_core;
  State m_state = POINTS;
  bool m_has_converged = false;
  /// \endcond
};

}  // namespace CGAL

#endif  // CGAL_LAPLACIAN_CONTRACTION_SKELETONIZATION_3_H
