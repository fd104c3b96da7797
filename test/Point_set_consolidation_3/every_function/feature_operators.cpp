// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "calls.h"

#include <CGAL/anisotropic_edge_aware_upsample_point_set.h>
#include <CGAL/anisotropic_wlop_simplify_and_regularize_point_set.h>

namespace every_function {
namespace {

using CGAL::Point_set_consolidation_3::Anisotropic_formula;
using CGAL::Point_set_consolidation_3::Upsampling_formula;

template <Anisotropic_formula formula>
void wlop(const Cloud& cloud, const Run& run, Output& output)
{
  written_oriented(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::anisotropic_wlop_simplify_and_regularize_point_set<decltype(tag)>(
      cloud.samples, out, np.select_percentage(30.).anisotropic_formula(formula));
  });
}

void normals(const Cloud& cloud, const Run& run, Output& output)
{
  changed(cloud, run, output, [&](auto tag, const auto& np, auto& samples) {
    CGAL::optimize_normals_across_edges<decltype(tag)>(samples, np.enhance_features(true));
  });
}

template <Upsampling_formula formula>
void upsampling(const Cloud& cloud, const Run& run, Output& output)
{
  written_oriented(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::anisotropic_edge_aware_upsample_point_set<decltype(tag)>(
      cloud.samples, out, np.upsampling_formula(formula));
  });
}

}  // namespace

const std::vector<Function>& feature_operators()
{
  static const char* const wlop_name = "anisotropic_wlop_simplify_and_regularize_point_set";
  static const char* const upsampling_name = "anisotropic_edge_aware_upsample_point_set";
  static const std::vector<Function> functions = {
    {wlop_name, Normals::OPTIONAL, false, wlop<Anisotropic_formula::SEPARATED>},
    {wlop_name, Normals::OPTIONAL, false, wlop<Anisotropic_formula::LOCAL>},
    {wlop_name, Normals::OPTIONAL, false, wlop<Anisotropic_formula::PRINTED>},
    {"optimize_normals_across_edges", Normals::NEEDED, false, normals},
    {upsampling_name, Normals::NEEDED, false, upsampling<Upsampling_formula::WEIGHTED>},
    {upsampling_name, Normals::NEEDED, false, upsampling<Upsampling_formula::EDGES>},
    {upsampling_name, Normals::NEEDED, false, upsampling<Upsampling_formula::PRINTED>}};
  return functions;
}

}  // namespace every_function
