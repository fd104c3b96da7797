// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_PAPER_FIGURE_H
#define CONSOLIDATION_BENCHMARK_PAPER_FIGURE_H

#include "judge.h"
#include "picture.h"
#include "plot.h"
#include "synthetic_scans.h"
#include "virtual_scanner.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace benchmark {

/// Named numbers, one row per variant.
struct Figure_table {
  std::string title;
  std::vector<std::string> columns;
  struct Row {
    std::string name;
    std::vector<double> values;  ///< not-a-number: not measured
  };
  std::vector<Row> rows;
};

/// What a figure leaves in its folder: NAME.txt and NAME.csv (tables), NAME.png (panels), NAME.svg (plot).
struct Figure_result {
  std::vector<Figure_table> tables;
  std::vector<support::Panel> panels;
  std::vector<support::Plot> plots;
  Vec3 view = -Vec3(-0.4, 0.35, 1.0);  ///< from the eye into the scene: between the seen and the hidden side
  Vec3 up = Vec3::UnitY();
  std::size_t columns = 0;             ///< of panels in a row; 0: all
  bool shares_camera = true;           ///< false: scenes of different size and place, moved to the same box
};

/// One figure or table of a paper.
struct Paper_figure {
  std::string name;
  std::string shows;  ///< in the paper
  std::function<Figure_result(const std::string& data)> make;  ///< `data`: folder of CGAL's data
};

std::vector<Paper_figure> deep_points_figures();
std::vector<Paper_figure> iterative_figures();
std::vector<Paper_figure> laplacian_figures();
std::vector<Paper_figure> feature_figures();

/// \name What figures are made of
/// @{

/// A model of the list, of unit diagonal.
Triangle_mesh figure_model(const std::string& data, const std::string& name);

/// A synthetic shape as a closed mesh with about `cells` cells along its longest side.
Triangle_mesh shape_mesh(const synthetic::Shape& shape, std::size_t cells);

/// Synthetic shapes by name, as the parts that they are unions of.
std::vector<std::pair<std::string, std::vector<synthetic::Shape>>> assembled_shapes();

/// Rows of `mesh_row()`: errors in percent of the truth's diagonal.
const std::vector<std::string>& mesh_columns();
std::vector<double> mesh_row(const Mesh_verdict& verdict);

/// The mesh of oriented points by the settings that all methods share: facets of up to 0.16 % of the diagonal from the
/// iso-surface, coarser than in the accuracy study, so that a figure takes minutes.
Triangle_mesh poisson(const Point_cloud& oriented);

support::Panel mesh_panel(const std::string& title, const Triangle_mesh& mesh);
support::Panel cloud_panel(const std::string& title, const Point_cloud& cloud);
support::Panel graph_panel(const std::string& title, const support::Segment_graph& graph,
                           const Point_cloud& cloud = {});
/// Colors from 0 (dark) to `most` (light).
std::vector<support::Color> heat_colors(const std::vector<double>& values, double most);

/// Angle between each normal and that of the nearest facet of the truth, unoriented, in degrees.
std::vector<double> normal_errors(const Triangle_mesh& truth, const Point_cloud& cloud);

/// Points along the edges where facets meet at 40 degrees or more.
std::vector<Vec3> sharp_edge_points(const Triangle_mesh& mesh);

double mean(const std::vector<double>& values);

/// A color per number, neighbours in number differ.
support::Color label_color(std::size_t label);

/// @}

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_PAPER_FIGURE_H
