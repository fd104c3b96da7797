// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A small part of the accuracy study: what completion gains over direct Poisson reconstruction. The thresholds leave
// room for changes of the mesher, not for a method that is broken. Direct reconstruction gets the true normals.

#undef NDEBUG

#include "consolidation.h"
#include "judge.h"
#include "mesh_tree.h"
#include "point_file.h"
#include "poisson_mesh.h"
#include "synthetic_scans.h"
#include "virtual_scanner.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using benchmark::Point_cloud;
using benchmark::Triangle_mesh;
using benchmark::Vec3;

/// Coarser than in the study, for models of unit diagonal.
Triangle_mesh mesh_of(const Point_cloud& cloud)
{
  support::Poisson_options options;
  options.spacing = 0.01;
  options.distance = 0.1;
  return support::poisson_mesh(cloud.points, cloud.normals, options);
}

/// Error of completion by that of direct reconstruction, one view of a model.
double one_view_ratio(const std::string& file)
{
  const Triangle_mesh truth = benchmark::normalized(support::read_mesh(file));
  benchmark::Scanner_options options;
  options.points = 12000;
  const benchmark::Scan scan = benchmark::scan_mesh(truth, options);
  benchmark::Judge_options judging;
  judging.samples = 10000;
  const benchmark::Judge judge(truth, benchmark::truth_cloud(scan), judging);

  Point_cloud direct = scan.cloud;
  direct.normals = scan.true_normals;
  support::Consolidation_options completing;
  completing.wants_points = false;
  const support::Consolidation_result completed = support::consolidate(scan.cloud, completing, {});
  assert(completed.completed.size() == scan.cloud.size() + completed.completed_points);
  for(std::size_t i = 0; i < scan.cloud.size(); ++i)
    assert(completed.completed.points[i] == scan.cloud.points[i]);  // a clean scan stays

  const benchmark::Mesh_verdict before = judge.mesh(mesh_of(direct));
  const benchmark::Mesh_verdict after = judge.mesh(mesh_of(completed.completed));
  std::cout << file << ": direct " << before.forward.mean << " (seen " << before.seen.mean << ", unseen "
            << before.unseen.mean << "), completed " << after.forward.mean << " (seen " << after.seen.mean
            << ", unseen " << after.unseen.mean << ")\n";
  assert(after.seen.mean < 1.5 * before.seen.mean + 0.05);
  return after.forward.mean / before.forward.mean;
}

/// An ellipsoid of semi-axes 1, 0.7, 0.5 without a cap: iterative consolidation closes it, Poisson alone bulges.
double cap_ratio()
{
  const Vec3 axes(1, 0.7, 0.5);
  const double diagonal = 2 * axes.norm();
  synthetic::Random_numbers random(1);
  const auto on_surface = [&] { return Vec3(random.direction().cwiseProduct(axes)); };
  Point_cloud cloud;
  while(cloud.size() < 8000) {
    const Vec3 p = on_surface();
    if(p.z() > 0.34)
      continue;
    cloud.points.push_back(p / diagonal);
    cloud.normals.push_back(p.cwiseQuotient(axes.cwiseAbs2()).normalized());
  }
  support::Consolidation_options options;
  options.method = "iterative";
  const support::Consolidation_result result = support::consolidate(cloud, options, {});
  assert(result.completed_points > 100);
  const benchmark::Mesh_tree before(mesh_of(cloud)), after(mesh_of(result.consolidated));
  double error_before = 0, error_after = 0;
  for(int i = 0; i < 4000; ++i) {
    const Vec3 p = on_surface() / diagonal;
    error_before += (before.closest(p).point - p).norm();
    error_after += (after.closest(p).point - p).norm();
  }
  std::cout << "cap of an ellipsoid: " << error_before / 40 << " -> " << error_after / 40 << "\n";
  return error_after / error_before;
}

}  // namespace

int main()
{
  assert(cap_ratio() < 0.5);

  const char* data = std::getenv("CGAL_DATA_DIR");
  const std::string meshes = std::string(data != nullptr ? data : "") + "/meshes/";
  if(!std::ifstream(meshes + "knot1.off")) {
    std::cout << "without CGAL's data (CGAL_DATA_DIR) models are left out\n";
    return 0;
  }
  assert(one_view_ratio(meshes + "knot1.off") < 0.5);
  assert(one_view_ratio(meshes + "armadillo.off") < 0.85);
  std::cout << "done\n";
}
