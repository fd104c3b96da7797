// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares a mesh, a point set or a skeleton with a ground truth mesh.

#include "arguments.h"
#include "judge.h"
#include "point_file.h"

#include <fstream>
#include <iomanip>
#include <iostream>

using namespace benchmark;

namespace {

const char* const usage =
    R"(judge TRUTH RESULT [--scan TRUE.ply] [--kind mesh|points|skeleton] [--json FILE] [--samples N]
Compares RESULT with the closed mesh TRUTH. Distances are in percent of the diagonal of TRUTH's bounding box.
  --scan FILE    noise-free samples with normals (virtual_scan --truth): splits errors into seen and unseen parts
  --kind WORD    what RESULT is (mesh if the file has facets, points otherwise)
  --json FILE    writes everything that was measured
  --samples N    on the truth, and on the result (40000)
)";

void print(const std::string& name, const Distance_statistics& statistics)
{
  if(statistics.samples == 0)
    return;
  std::cout << std::left << std::setw(18) << name << std::right << std::fixed
            << std::setprecision(3) << std::setw(9) << statistics.mean << std::setw(9)
            << statistics.rms << std::setw(9) << statistics.percentile_95 << std::setw(9)
            << statistics.max << std::setprecision(1);
  for(double share : statistics.share_within)
    std::cout << std::setw(8) << 100.0 * share;
  std::cout << "\n";
}

void print_header()
{
  std::cout << "percent of diag.       mean      rms      95%      max";
  for(double limit : distribution_limits)
    std::cout << "   <" << std::setw(4) << limit;
  std::cout << "\n";
}

void print(const Normal_statistics& normals)
{
  std::cout << std::setprecision(2) << "normals: " << normals.mean_error << " degrees, "
            << 100.0 * normals.flipped << " % flipped\n";
}

void print(const std::string& name, const Topology& topology)
{
  std::cout << name << (topology.closed ? "closed, " : "not closed, ") << topology.components
            << " component(s), genus "
            << std::setprecision(topology.genus == static_cast<long>(topology.genus) ? 0 : 1)
            << topology.genus << "\n";
}

std::string report(const Mesh_verdict& verdict)
{
  print_header();
  print("truth to result", verdict.forward);
  print("  seen part", verdict.seen);
  print("  unseen part", verdict.unseen);
  print("result to truth", verdict.reverse);
  std::cout << std::setprecision(3) << "F-score: " << verdict.fscore_half << " at 0.5 %, "
            << verdict.fscore_one << " at 1 %\n";
  print(verdict.normals);
  print("result:  ", verdict.topology);
  print("truth:   ", verdict.true_topology);
  std::cout << std::setprecision(3) << "volume:  " << verdict.volume_ratio << " of the truth's\n";
  return to_json(verdict);
}

std::string report(const Point_set_verdict& verdict)
{
  print_header();
  print("points to truth", verdict.distance);
  print("truth to points", verdict.coverage);
  print("  seen part", verdict.seen);
  print("  unseen part", verdict.unseen);
  std::cout << std::setprecision(3) << "spacing: " << verdict.spacing << " %, variation "
            << verdict.spacing_variation << "\n";
  print(verdict.normals);
  return to_json(verdict);
}

std::string report(const Skeleton_verdict& verdict)
{
  print_header();
  print("to medial axis", verdict.to_medial_axis);
  std::cout << std::setprecision(1) << std::fixed << "inside " << 100.0 * verdict.inside
            << " %, covers " << 100.0 * verdict.coverage << " % of the surface, "
            << verdict.components << " component(s), " << verdict.cycles << " cycle(s), length "
            << verdict.length << " %\n";
  return to_json(verdict);
}

std::string kind_of(const Arguments& arguments)
{
  if(arguments.has("--kind"))
    return arguments.text("--kind");
  try {
    support::read_mesh(arguments.files()[1]);
    return "mesh";
  } catch(const support::File_error&) {
    return "points";
  }
}

void run(const Arguments& arguments)
{
  if(arguments.files().size() != 2)
    throw Usage_error("needs TRUTH and RESULT");
  Judge_options options;
  options.samples = arguments.count("--samples", options.samples);
  const Triangle_mesh truth = support::read_mesh(arguments.files()[0]);
  const Point_cloud scan = arguments.has("--scan")
                               ? support::read_point_cloud(arguments.text("--scan"))
                               : Point_cloud();
  const std::string kind = kind_of(arguments);
  const std::string& file = arguments.files()[1];
  const Judge judge(truth, scan, options);
  std::string json;
  if(kind == "mesh") {
    json = report(judge.mesh(support::read_mesh(file)));
  } else if(kind == "points") {
    json = report(judge.points(support::read_point_cloud(file)));
  } else if(kind == "skeleton") {
    json = report(judge.skeleton(support::read_segment_graph(file)));
  } else {
    throw Usage_error("--kind is mesh, points or skeleton, not '" + kind + "'");
  }
  if(arguments.has("--json")) {
    std::ofstream out(arguments.text("--json"));
    out << json << "\n";
    if(!out.flush())
      throw support::File_error(arguments.text("--json") + ": cannot be written");
  }
}

}  // namespace

int main(int argc, char** argv)
{
  return benchmark::run_program("judge", usage, argc, argv,
                                {"--scan", "--kind", "--json", "--samples"},
                                {}, run);
}
