// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "graphs.h"

#include <CGAL/density_peak_segment_point_set.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_laplacian_contraction_skeleton.h>

#include <array>

namespace every_function {
namespace {

using CGAL::Point_set_consolidation_3::Segmentation_method;

/// Functions that assign to a skeleton.
template <typename Call>
void extracted(const Cloud& cloud, const Run& run, Output& output, const Call& call)
{
  Skeleton skeleton(7);  // vertices that no result has
  const auto finish = [&] { output.is_untouched = num_vertices(skeleton) == 7 && num_edges(skeleton) == 0; };
  try {
    with_tag_and_maps(cloud, run, [&](auto tag, const auto& np) { call(tag, np, skeleton); });
  }
  catch(...) {
    finish();
    throw;
  }
  finish();
  append(skeleton, output);
}

void laplacian(const Cloud& cloud, const Run& run, Output& output)
{
  extracted(cloud, run, output, [&](auto tag, const auto& np, Skeleton& skeleton) {
    CGAL::extract_laplacian_contraction_skeleton<decltype(tag)>(cloud.samples, skeleton, np);
  });
}

void laplacian_of_soup(const Cloud& cloud, const Run& run, Output& output)
{
  std::vector<std::array<std::size_t, 3> > triangles;
  for(std::size_t i = 2; i < cloud.samples.size(); ++i)
    triangles.push_back({i - 2, i - 1, i});
  extracted(cloud, run, output, [&](auto tag, const auto& np, Skeleton& skeleton) {
    CGAL::extract_laplacian_contraction_skeleton<decltype(tag)>(
      cloud.samples, triangles, skeleton, np.number_of_samples(std::size_t(300)));
  });
}

void l1_medial(const Cloud& cloud, const Run& run, Output& output)
{
  extracted(cloud, run, output, [&](auto tag, const auto& np, Skeleton& skeleton) {
    CGAL::extract_l1_medial_skeleton<decltype(tag)>(cloud.samples, skeleton,
                                                    np.number_of_samples(std::size_t(100)));
  });
}

void l1_medial_of_segments(const Cloud& cloud, const Run& run, Output& output)
{
  std::vector<Sample> samples = cloud.samples;
  for(std::size_t i = 0; i < samples.size(); ++i)
    samples[i].segment = i < samples.size() / 2 ? 0 : 2;  // segment 1 is empty
  extracted(cloud, run, output, [&](auto tag, const auto& np, Skeleton& skeleton) {
    CGAL::extract_l1_medial_skeleton<decltype(tag)>(
      samples, skeleton, np.segment_map(Segment_map()).number_of_samples(std::size_t(100)));
  });
}

template <Segmentation_method method>
void segmentation(const Cloud& cloud, const Run& run, Output& output)
{
  changed(cloud, run, output, [&](auto tag, const auto& np, auto& samples) {
    output.numbers.push_back(double(CGAL::density_peak_segment_point_set<decltype(tag)>(
      samples, Segment_map(), np.segmentation_method(method))));
  });
  output.normals.clear();  // the caller's, of any length
}

}  // namespace

const std::vector<Function>& skeletons()
{
  static const char* const laplacian_name = "extract_laplacian_contraction_skeleton";
  static const char* const l1_name = "extract_l1_medial_skeleton";
  static const char* const segments_name = "density_peak_segment_point_set";
  static const std::vector<Function> functions = {
    {laplacian_name, Normals::OPTIONAL, false, laplacian},
    {laplacian_name, Normals::UNUSED, false, laplacian_of_soup},
    {l1_name, Normals::UNUSED, false, l1_medial},
    {l1_name, Normals::UNUSED, false, l1_medial_of_segments},
    {segments_name, Normals::OPTIONAL, true, segmentation<Segmentation_method::DENSITY_PEAKS>},
    {segments_name, Normals::OPTIONAL, true, segmentation<Segmentation_method::PERSISTENCE>},
    {segments_name, Normals::OPTIONAL, true, segmentation<Segmentation_method::SKELETON>}};
  return functions;
}

}  // namespace every_function
