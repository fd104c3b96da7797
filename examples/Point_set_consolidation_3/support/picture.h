// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_PICTURE_H
#define CONSOLIDATION_SUPPORT_PICTURE_H

#include "types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace support {

/// sRGB, each from 0 to 1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
};

namespace colors {
inline constexpr Color white{1, 1, 1};
inline constexpr Color ink{0.13, 0.14, 0.17};
inline constexpr Color surface{0.72, 0.77, 0.84};    ///< front faces of meshes
inline constexpr Color inside{0.87, 0.60, 0.42};     ///< back faces, points seen from behind
inline constexpr Color scan{0.55, 0.66, 0.79};       ///< measured points
inline constexpr Color completed{0.91, 0.45, 0.16};  ///< points that the method has added
inline constexpr Color skeleton{0.75, 0.16, 0.20};
}  // namespace colors

/// From `colors::completed` (0) to `colors::scan` (1).
Color confidence_color(double confidence);

/// From dark blue (0) over green to light yellow (1), of evenly rising lightness. Values beyond are
/// clamped; not-a-number is grey.
Color heat_color(double t);

/// Orthographic. `view` is the unit vector from the eye into the scene, `up` is orthogonal to it.
struct Camera {
  Vec3 centre = Vec3::Zero();
  Vec3 view = -Vec3::UnitZ();
  Vec3 up = Vec3::UnitY();
  double width = 2;  ///< of what must be visible, in the units of the scene
  double height = 2;

  Vec3 right() const;
};

/// The whole of `points` is visible, with a margin on each side relative to its size. `up` need not
/// be orthogonal to `view_direction`; if it is parallel, another one is chosen.
/// Points that are not finite are ignored.
Camera fit_camera(const std::vector<Vec3>& points, const Vec3& view_direction, const Vec3& up,
                  double margin = 0.04);

struct Mesh_style {
  Color color = colors::surface;
  Color back_color = colors::inside;
  std::vector<Color> vertex_colors;  ///< empty or one per vertex; replaces `color`
  std::vector<Color> face_colors;    ///< empty or one per face; replaces both
  bool smooth = true;                ///< normals vary over the faces, except across sharp edges
  bool edges = false;                ///< thin lines along the edges
};

struct Point_style {
  Color color = colors::scan;
  Color back_color = colors::inside;
  std::vector<Color> point_colors;  ///< empty or one per point; replaces `color`
  double radius
      = 0;  ///< in the units of the scene; 0: derived from the spacing (discs: from the local one)
  bool shaded = true;  ///< false: plain color, as in a map
};

struct Segment_style {
  Color color = colors::skeleton;
  std::vector<Color> vertex_colors;  ///< empty or one per vertex; replaces `color`
  double radius = 0;       ///< in the units of the scene; 0: 1/250 of the picture, less for many
  double node_radius = 0;  ///< of the balls at the vertices; 0: as the segments
};

enum class Align { left, centre, right };

struct Label_style {
  Color color = colors::ink;
  double height = 18;  ///< of a capital letter, in pixels
  Align align = Align::left;
};

/// An image, and the scene that is being drawn on it with hidden surfaces removed.
///
/// Everything drawn until the image is looked at, labelled or written is one scene: draw it with
/// one camera. What is drawn later lies on top. Edges are smoothed by 3x3 samples per pixel; light
/// comes from the upper left and from the sky, and folds are darkened (ambient occlusion in screen
/// space). The same calls give the same image. Elements with a coordinate that is not finite are
/// left out.
class Picture {
public:
  /// \throws std::invalid_argument if the size is not positive or exceeds 32000 pixels.
  Picture(int width, int height, const Color& background = colors::white);

  int width() const { return m_width; }
  int height() const { return m_height; }

  void draw_mesh(const Triangle_mesh& mesh, const Camera& camera, const Mesh_style& style = {});

  /// Discs orthogonal to their normals, blended into a surface; balls if `normals` is empty.
  void draw_points(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                   const Camera& camera, const Point_style& style = {});

  /// Round rods with balls at the ends.
  void draw_segments(const Segment_graph& graph, const Camera& camera,
                     const Segment_style& style = {});

  /// Text on the baseline y, measured in pixels from the upper left corner. Printable ASCII, others
  /// become '?'.
  void label(const std::string& text, double x, double y, const Label_style& style = {});
  static double label_width(const std::string& text, double height);

  /// A vertical bar of `map` from 0 (bottom) to 1 (top) with the upper left corner (x, y), and what
  /// both ends mean to the right of it.
  void color_bar(const std::function<Color(double)>& map, double x, double y, double width,
                 double height, const std::string& low, const std::string& high);

  void fill_rectangle(int x, int y, int width, int height, const Color& color);

  /// Pictures in rows of `columns` (0: one row), each centred in its cell.
  static Picture side_by_side(const std::vector<Picture>& pictures, std::size_t columns = 0,
                              int gap = 16);

  Color pixel(int x, int y) const;

  /// \throws File_error if it cannot be written; no partial file is left.
  void write_png(const std::string& file) const;

private:
  /// What the eye sees through one of a pixel's samples. Lengths are in samples.
  struct Sample {
    float depth = 0;                          ///< towards the eye
    std::int16_t normal_x = 0, normal_y = 0;  ///< of 32767; z is positive
    std::array<std::uint8_t, 3> color{};
    std::uint8_t kind = 0;
    float weight = 0;  ///< of the discs that are averaged here
  };
  struct View;
  class Painter;

  void flatten() const;
  std::vector<float> openness() const;

  int m_width;
  int m_height;
  mutable std::vector<std::uint8_t> m_image;  ///< RGB, rows from the top
  mutable std::vector<Sample> m_samples;      ///< the scene; empty if nothing is drawn
};

/// One picture of a figure. Parts that are empty are not drawn; the graph is drawn on top of the others.
struct Panel {
  std::string title;
  Point_cloud cloud;  ///< with confidence and without `point_colors`: colored by confidence
  std::vector<Color> point_colors;
  Triangle_mesh mesh;
  std::vector<Color> vertex_colors;
  Segment_graph graph;
  double point_radius = 0;    ///< 0: derived from the spacing
  double segment_radius = 0;  ///< 0: derived from the picture's size
};

/// What tells parts, segments or clusters apart: hues of which those with near numbers differ most.
Color label_color(std::size_t label);

/// A figure: panels side by side, seen with the same camera, each with its title below.
/// `view_direction` points from the eye into the scene. `columns` = 0: one row.
/// \throws File_error if it cannot be written.
void write_panels(const std::string& png, const std::vector<Panel>& panels,
                  const Vec3& view_direction = Vec3(-0.45, -0.3, -1),
                  const Vec3& up = Vec3::UnitY(), int panel_height = 640, std::size_t columns = 0);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_PICTURE_H
