// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Depth camera on a closed mesh: a scan with known truth.

#include "arguments.h"
#include "point_file.h"
#include "virtual_scanner.h"

#include <iostream>

namespace {

const char* const usage =
    R"(virtual_scan MESH -o SCAN.ply [options]
Scans a closed triangle mesh with a simulated depth camera. The PLY file holds x y z, the unit vector
vx vy vz towards the scanner and the index of the view. Lengths are percent of the mesh's diagonal.
  --views N        number of views (1)
  --points N       points of all views together, about (20000)
  --noise P        standard deviation of the noise along the ray (0)
  --outliers P     percent of the points that are outliers; they come last (0)
  --misalign P     misregistration of the views after the first (0)
  --perspective    rays from one point per view (parallel rays)
  --distance X     of that point from the box centre, in diagonals (1.5)
  --grazing C      smallest cosine between ray and surface normal that returns a point (0.15)
  --seed N         of all random choices (1)
  --truth FILE     noise-free samples with the true normals, in the order of the scan, without outliers
)";

void run(const benchmark::Arguments& arguments)
{
  if(arguments.files().size() != 1 || !arguments.has("-o"))
    throw benchmark::Usage_error("needs MESH and -o SCAN.ply");
  benchmark::Scanner_options options;
  options.views = arguments.count("--views", options.views);
  options.points = arguments.count("--points", options.points);
  options.noise = arguments.number("--noise", options.noise);
  options.outliers = arguments.number("--outliers", options.outliers);
  options.misalignment = arguments.number("--misalign", options.misalignment);
  options.perspective = arguments.has("--perspective");
  options.distance = arguments.number("--distance", options.distance);
  options.grazing_cosine = arguments.number("--grazing", options.grazing_cosine);
  options.seed = arguments.count("--seed", options.seed);
  if(options.views == 0 || options.points == 0)
    throw benchmark::Usage_error("needs at least one view and one point");

  const support::Triangle_mesh mesh = support::read_mesh(arguments.files()[0]);
  const benchmark::Scan scan = benchmark::scan_mesh(mesh, options);
  support::write_point_cloud(arguments.text("-o"), scan.cloud);
  if(arguments.has("--truth"))
    support::write_point_cloud(arguments.text("--truth"), benchmark::truth_cloud(scan));
  std::cout << scan.cloud.size() << " points from " << options.views << " views, "
            << scan.cloud.size() - scan.true_points.size() << " outliers, diagonal "
            << scan.diagonal << ", ray pitch " << 100.0 * scan.pitch / scan.diagonal
            << " % of it\n";
}

}  // namespace

int main(int argc, char** argv)
try {
  const benchmark::Arguments arguments(
      argc, argv,
      {"-o", "--views", "--points", "--noise", "--outliers", "--misalign", "--distance",
       "--grazing", "--seed", "--truth"},
      {"--perspective"});
  if(arguments.has("--help")) {
    std::cout << usage;
    return 0;
  }
  run(arguments);
  return 0;
} catch(const benchmark::Usage_error& error) {
  std::cerr << "virtual_scan: " << error.what() << " (see --help)\n";
  return 1;
} catch(const support::File_error& error) {
  std::cerr << "virtual_scan: " << error.what() << "\n";
  return 2;
} catch(const std::exception& error) {
  std::cerr << "virtual_scan: " << error.what() << "\n";
  return 3;
}
