// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WLOP_PROJECT_POINT_SET_H
#define CGAL_WLOP_PROJECT_POINT_SET_H

#include <CGAL/Point_set_consolidation_3/core/iterative_consolidation.h>
#include <CGAL/Point_set_consolidation_3/internal/write_back.h>

#include <algorithm>

namespace CGAL {

/*!
  \ingroup PkgPointSetConsolidation3Operators

  projects particles onto a noisy, unevenly spread point set by the weighted locally optimal projection
  (WLOP) \cgalCite{cgal:hlzac-cupcsr-09}, as printed in appendix I, equation (7), of
  \cgalCite{cgal:lcw-icupc-12}: a particle is drawn to the L1 median of the points around it, weighted by the inverse
  of their density, and repelled by the other particles.

  Compared with `CGAL::wlop_simplify_and_regularize_point_set()` the data term has its factor \f$1/r\f$, the
  first particles can be given, and some particles can be static: they act on the others, but do not move.
  With \f$\theta(r) = e^{-16 r^2 / h^2}\f$, cut at \f$h/2\f$, the value \f$h\f$ corresponds to a
  `neighbor_radius` of \f$h/2\f$ there. \f$1/r\f$ is taken at no less than 0.05 \f$h\f$.

  The input is neither changed nor reordered. The result does not depend on unit and origin of the
  coordinates. Complexity: for each iteration, the number of particles times that of the points within
  \f$h/2\f$.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The result is the same,
  bit for bit, for any of them and any number of threads.
  \tparam PointRange a model of `ConstRange` whose iterator is a `ForwardIterator`.
  \tparam OutputIterator a model of `OutputIterator` for `geom_traits::Point_3`.

  \param points at least one point, with finite coordinates.
  \param output receives the moved particles, in the order of the initial sample; nothing if the callback
  cancels.
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{positions of the points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_output_points}
      \cgalParamDescription{number of particles, at most that of the points}
      \cgalParamType{`std::size_t`}
      \cgalParamDefault{a share of `particle_fraction` of the points, at least 500}
    \cgalParamNEnd
    \cgalParamNBegin{particle_fraction}
      \cgalParamDescription{the same as a share of the points, in (0, 1]}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.1; 1/20 for dense sets}
    \cgalParamNEnd
    \cgalParamNBegin{initial_sample}
      \cgalParamDescription{particles to start from, instead of random points}
      \cgalParamType{a range of `geom_traits::Point_3`, or `std::ref` of one}
      \cgalParamDefault{a random subset of the points}
    \cgalParamNEnd
    \cgalParamNBegin{static_sample}
      \cgalParamDescription{particles that repel others, but do not move; they are not written}
      \cgalParamType{a range of `geom_traits::Point_3`, or `std::ref` of one}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{\f$h\f$, in the unit of the input}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{twice the median over the particles of the mean distance to 20 others}
      \cgalParamExtra{The paper takes the mean, which a few far outliers spoil.}
    \cgalParamNEnd
    \cgalParamNBegin{repulsion_weight}
      \cgalParamDescription{\f$\mu\f$, in [0, 0.5); 0.25 is more accurate and less even}
      \cgalParamType{floating scalar value}
      \cgalParamDefault{0.45, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{largest number of iterations; it stops before if particles move by less than
        0.003 \f$h\f$ in the mean}
      \cgalParamType{unsigned int}
      \cgalParamDefault{30: accuracy is best from 20 to 30}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{of the random subset}
      \cgalParamType{unsigned int}
      \cgalParamDefault{0}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called on the calling thread with the progress in [0, 1], never decreasing; returning
        `false` stops the call, which then writes nothing}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{stage_times}
      \cgalParamDescription{receives name, seconds and iterations of each stage}
      \cgalParamType{`std::reference_wrapper` of a `std::vector<Point_set_consolidation_3::Stage_time>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{the kernel of the points}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `output` past the last particle.
  \throws std::invalid_argument if there is no point, a coordinate is not finite or a parameter is out of its
  range; the message names it.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
wlop_project_point_set(const PointRange& points, OutputIterator output,
                       const NamedParameters& np = parameters::default_values())
{
  using namespace Point_set_consolidation_3::internal;
  namespace names = Point_set_consolidation_3::internal_np;
  typedef Point_set_consolidation_3::internal::Cgal_np<NamedParameters> NP;
  typedef typename Np_helper<PointRange, NP>::Geom_traits Traits;
  const char* const function = "wlop_project_point_set";
  const auto& pack = cgal_np(np);

  const Points data = copy_points(function, points, pack, 1);
  const Points sample = points_parameter(function, "initial_sample", pack, names::initial_sample);
  const Points statics = points_parameter(function, "static_sample", pack, names::static_sample);
  const double fraction =
    positive(function, pack, names::particle_fraction, "particle_fraction", 0.1);
  require(fraction <= 1, function, "particle_fraction must be at most 1");
  constexpr std::size_t least_particles = 500;
  Wlop_settings settings;
  settings.count = parameter_or(
    pack, CGAL::internal_np::number_of_output_points,
    (std::max)(least_particles, std::size_t(fraction * double(data.size()))));
  require(settings.count > 0, function, "number_of_output_points must be positive");
  settings.seed = parameter_or(pack, CGAL::internal_np::random_seed, 0u);
  Wlop_parameters& parameters = settings.parameters;
  parameters.repulsion =
    not_negative(function, pack, names::repulsion_weight, "repulsion_weight", 0.45);
  require(parameters.repulsion < 0.5, function, "repulsion_weight must be less than 0.5");
  parameters.iterations = parameter_or(pack, CGAL::internal_np::number_of_iterations, 30u);
  require(parameters.iterations <= 100000, function, "number_of_iterations is too large");
  parameters.support_radius =
    not_negative(function, pack, CGAL::internal_np::neighbor_radius, "neighbor_radius", 0);

  Points particles;
  const bool is_complete = run_core<ConcurrencyTag>(function, pack, [&](Execution& execution) {
    particles = project_by_wlop(execution, data, sample, statics, settings);
  });
  if(!is_complete)
    return output;
  for(const Vec3& p : particles)
    *output++ = to_point<Traits>(p);
  return output;
}

}  // namespace CGAL

#endif  // CGAL_WLOP_PROJECT_POINT_SET_H
