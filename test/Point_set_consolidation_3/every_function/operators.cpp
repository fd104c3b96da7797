// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "calls.h"

#include <CGAL/Algebraic_point_set_surface_3.h>
#include <CGAL/apss_project_point_set.h>
#include <CGAL/bilateral_project_point_set.h>
#include <CGAL/interpolatory_upsample_point_set.h>
#include <CGAL/mean_shift_remove_outliers.h>
#include <CGAL/repulse_along_apss.h>
#include <CGAL/wlop_project_point_set.h>

namespace every_function {
namespace {

void mean_shift(const Cloud& cloud, const Run& run, Output& output)
{
  for(const Sample& s : written<Sample>(cloud, run, output,
        [&](auto tag, const auto& np, auto out) {
          CGAL::mean_shift_remove_outliers<decltype(tag)>(cloud.samples, out, np);
        }))
    output.points.push_back(s.point);
}

void repulsion(const Cloud& cloud, const Run& run, Output& output)
{
  changed(cloud, run, output, [&](auto tag, const auto& np, auto& samples) {
    output.numbers.push_back(CGAL::repulse_along_apss<decltype(tag)>(samples, np));
  });
}

void upsampling(const Cloud& cloud, const Run& run, Output& output)
{
  written_oriented(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::interpolatory_upsample_point_set<decltype(tag)>(cloud.samples, out, np);
  });
}

void bilateral(const Cloud& cloud, const Run& run, Output& output)
{
  changed(cloud, run, output, [&](auto tag, const auto& np, auto& samples) {
    output.numbers.push_back(CGAL::bilateral_project_point_set<decltype(tag)>(samples, np));
  });
}

void apss(const Cloud& cloud, const Run& run, Output& output)
{
  changed(cloud, run, output, [&](auto tag, const auto& np, auto& samples) {
    output.numbers.push_back(double(CGAL::apss_project_point_set<decltype(tag)>(samples, np)));
  });
}

void apss_queries(const Cloud& cloud, const Run& run, Output& output)
{
  with_tag_and_maps(cloud, run, [&](auto, const auto& np) {
    const CGAL::Algebraic_point_set_surface_3<Kernel> surface(cloud.samples, np);
    output.is_untouched = false;
    output.numbers.push_back(surface.support_radius());
    for(const Sample& s : cloud.samples) {
      if(const auto p = surface.project(s.point))
        output.points.push_back(*p);
      if(const auto fit = surface.fit(s.point)) {
        output.points.push_back(fit->point);
        output.normals.push_back(fit->normal);
        output.numbers.push_back(fit->curvature);
        output.numbers.push_back(fit->normal_residual);
      }
      if(const auto d = surface.signed_distance(s.point))
        output.numbers.push_back(*d);
      if(const auto g = surface.gradient(s.point))
        output.numbers.push_back(g->squared_length());
    }
  });
}

void wlop(const Cloud& cloud, const Run& run, Output& output)
{
  output.points = written<Point>(cloud, run, output, [&](auto tag, const auto& np, auto out) {
    CGAL::wlop_project_point_set<decltype(tag)>(cloud.samples, out, np);
  });
}

}  // namespace

const std::vector<Function>& operators()
{
  static const std::vector<Function> functions = {
    {"mean_shift_remove_outliers", Normals::UNUSED, true, mean_shift},
    {"repulse_along_apss", Normals::NEEDED, true, repulsion},
    {"interpolatory_upsample_point_set", Normals::NEEDED, true, upsampling},
    {"bilateral_project_point_set", Normals::NEEDED, true, bilateral},
    {"apss_project_point_set", Normals::NEEDED, true, apss},
    {"Algebraic_point_set_surface_3", Normals::NEEDED, true, apss_queries},
    {"wlop_project_point_set", Normals::UNUSED, false, wlop}};
  return functions;
}

}  // namespace every_function
