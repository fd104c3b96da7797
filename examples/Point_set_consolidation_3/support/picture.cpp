// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "picture.h"

#include "file_bytes.h"
#include "stroke_font.h"

#include <Eigen/Geometry>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace support {
namespace {

constexpr int samples_per_axis = 3;
constexpr int max_size = 32000;

/// What a sample shows.
enum Kind : std::uint8_t { nothing, shaded, plain, front_splat, back_splat };

bool is_lit(std::uint8_t kind)
{
  return kind != nothing && kind != plain;
}

// ---- colors ---------------------------------------------------------------------------------

std::uint8_t to_byte(double value)
{
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0., 1.)));
}

std::array<std::uint8_t, 3> to_bytes(const Color& c)
{
  return {to_byte(c.red), to_byte(c.green), to_byte(c.blue)};
}

double srgb_to_linear(double v)
{
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double v)
{
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Intensities of light for the bytes of an image.
const std::array<float, 256>& linear_of_byte()
{
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t;
    for(int i = 0; i < 256; ++i)
      t[i] = static_cast<float>(srgb_to_linear(i / 255.));
    return t;
  }();
  return table;
}

std::uint8_t byte_of_linear(float v)
{
  constexpr int steps = 1 << 13;  // fine enough that every byte is reached
  static const std::vector<std::uint8_t> table = [] {
    std::vector<std::uint8_t> t(steps + 1);
    for(int i = 0; i <= steps; ++i)
      t[i] = to_byte(linear_to_srgb(double(i) / steps));
    return t;
  }();
  return table[static_cast<int>(std::clamp(v, 0.f, 1.f) * steps + 0.5f)];
}

Color mix(const Color& a, const Color& b, double t)
{
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

/// Björn Ottosson's OKLab: lightness, and two axes of colour, in which equal distances look equal.
Color color_of_oklab(double lightness, double a, double b)
{
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const auto encode = [](double v) { return std::clamp(linear_to_srgb(std::max(v, 0.)), 0., 1.); };
  return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

// ---- geometry -------------------------------------------------------------------------------

/// Normals of the corners of the faces. With `smooth`, the average of the faces around the vertex
/// that are not bent away across a sharp edge.
std::vector<std::array<Eigen::Vector3f, 3>> corner_normals(const Triangle_mesh& mesh, bool smooth)
{
  constexpr double sharp_edge = 40;  // degrees between normals
  const double min_cosine = std::cos(sharp_edge * EIGEN_PI / 180);

  std::vector<Vec3> area_normal(mesh.faces.size());
  std::vector<Vec3> unit_normal(mesh.faces.size());
  std::vector<std::size_t> first(mesh.vertices.size() + 1, 0);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    area_normal[f] = (mesh.vertices[face[1]] - mesh.vertices[face[0]])
                         .cross(mesh.vertices[face[2]] - mesh.vertices[face[0]]);
    unit_normal[f] = area_normal[f].stableNormalized();
    for(std::size_t v : face)
      ++first[v + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> faces_of_vertex(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for(std::size_t v : mesh.faces[f])
      faces_of_vertex[next[v]++] = f;
  }

  std::vector<std::array<Eigen::Vector3f, 3>> normals(mesh.faces.size());
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for(int k = 0; k < 3; ++k) {
      Vec3 sum = area_normal[f];
      const std::size_t v = mesh.faces[f][k];
      for(std::size_t i = first[v]; smooth && i < first[v + 1]; ++i) {
        const std::size_t g = faces_of_vertex[i];
        if(g != f && unit_normal[g].dot(unit_normal[f]) > min_cosine)
          sum += area_normal[g];
      }
      normals[f][k] = sum.stableNormalized().cast<float>();
    }
  }
  return normals;
}

/// Typical distance of a point to its neighbours: the median, over a part of the points, of the
/// distance to the fourth nearest. Robust against outliers and against copies of points.
double typical_spacing(const std::vector<Vec3>& points)
{
  constexpr std::size_t max_queries = 300;
  constexpr std::size_t rank = 4;
  if(points.size() < 2)
    return 0;
  const std::size_t step = 1 + points.size() / max_queries;
  std::vector<double> distances;
  for(std::size_t i = 0; i < points.size(); i += step) {
    std::array<double, rank> nearest;
    nearest.fill(std::numeric_limits<double>::infinity());
    for(const Vec3& p : points) {
      const double d = (p - points[i]).squaredNorm();
      if(d > 0 && d < nearest.back()) {
        nearest.back() = d;
        for(std::size_t k = rank - 1; k > 0 && nearest[k] < nearest[k - 1]; --k)
          std::swap(nearest[k], nearest[k - 1]);
      }
    }
    for(std::size_t k = rank; k-- > 0;) {
      if(std::isfinite(nearest[k])) {
        distances.push_back(std::sqrt(nearest[k]));
        break;
      }
    }
  }
  if(distances.empty())
    return 0;
  const auto middle = distances.begin() + distances.size() / 2;
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// Radii with which discs close a surface that is sampled unevenly: the distance to the fifth
/// nearest neighbour, a bit less. It is bounded by the typical spacing, so that holes stay open.
std::vector<double> local_radii(const std::vector<Vec3>& points, double spacing)
{
  constexpr std::size_t rank = 5;
  constexpr double share = 0.8;
  constexpr double least = 0.6, most = 1.5;  // times the typical spacing
  std::vector<double> radii(points.size(), most * spacing);
  if(!(spacing > 0))
    return radii;

  // Points sorted by the cell of a grid as large as the largest radius.
  const double cell = most * spacing;
  using Index = std::array<std::int64_t, 3>;
  const auto index_of = [&](const Vec3& p) {
    Index i;
    for(int k = 0; k < 3; ++k)
      i[k] = static_cast<std::int64_t>(std::floor((p[k] - points.front()[k]) / cell));
    return i;
  };
  std::vector<std::pair<Index, std::size_t>> sorted;
  sorted.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    if(((points[i] - points.front()) / cell).cwiseAbs().maxCoeff() < 1e15)
      sorted.emplace_back(index_of(points[i]), i);
  }
  std::sort(sorted.begin(), sorted.end());

  for(const auto& query : sorted) {
    std::array<double, rank> nearest;
    nearest.fill(cell * cell);
    for(int dx = -1; dx <= 1; ++dx) {
      for(int dy = -1; dy <= 1; ++dy) {
        // The three cells of a column follow each other.
        Index from = query.first;
        from[0] += dx;
        from[1] += dy;
        from[2] -= 1;
        Index last = from;
        last[2] += 2;
        auto entry
            = std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(from, std::size_t(0)));
        for(; entry != sorted.end() && entry->first <= last; ++entry) {
          const double d = (points[entry->second] - points[query.second]).squaredNorm();
          if(d == 0 || d >= nearest.back())
            continue;
          nearest.back() = d;
          for(std::size_t k = rank - 1; k > 0 && nearest[k] < nearest[k - 1]; --k)
            std::swap(nearest[k], nearest[k - 1]);
        }
      }
    }
    radii[query.second] = std::max(share * std::sqrt(nearest.back()), least * spacing);
  }
  return radii;
}

const Color& color_of(const std::vector<Color>& colors, std::size_t i, const Color& otherwise)
{
  return i < colors.size() ? colors[i] : otherwise;
}

void check_count(const char* what, std::size_t count, std::size_t expected)
{
  if(count != 0 && count != expected) {
    throw std::invalid_argument("Picture: " + std::to_string(count) + " " + what + " instead of "
                                + std::to_string(expected));
  }
}

}  // namespace

Color confidence_color(double confidence)
{
  if(std::isnan(confidence))
    return {0.5, 0.5, 0.5};
  return mix(colors::completed, colors::scan, std::clamp(confidence, 0., 1.));
}

Color heat_color(double t)
{
  if(std::isnan(t))
    return {0.5, 0.5, 0.5};
  t = std::clamp(t, 0., 1.);
  const double lightness = 0.28 + 0.64 * t;
  const double hue = (290 - 185 * t) * EIGEN_PI / 180;
  // As much as the screen has for these hues; it has least of green-blue, at 0.4.
  const double chroma = 0.095 + 0.2 * (t - 0.4) * (t - 0.4);
  return color_of_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

// ---- camera ---------------------------------------------------------------------------------

Vec3 Camera::right() const
{
  return view.cross(up);
}

Camera fit_camera(const std::vector<Vec3>& points, const Vec3& view_direction, const Vec3& up,
                  double margin)
{
  Camera camera;
  if(view_direction.allFinite() && view_direction.norm() > 0)
    camera.view = view_direction.stableNormalized();
  Vec3 vertical = up - up.dot(camera.view) * camera.view;
  if(!(vertical.norm() > 1e-6 * up.norm()))
    vertical = camera.view.unitOrthogonal();
  camera.up = vertical.normalized();

  Eigen::Matrix3d axes;
  axes << camera.right().transpose(), camera.up.transpose(), -camera.view.transpose();
  // The box is taken relative to one of the points, so that no digits are lost far from the origin.
  Vec3 origin = Vec3::Zero();
  Eigen::AlignedBox3d box;
  for(const Vec3& p : points) {
    if(!p.allFinite())
      continue;
    if(box.isEmpty())
      origin = p;
    box.extend(axes * (p - origin));
  }
  if(box.isEmpty())
    return camera;
  camera.centre = origin + axes.transpose() * box.center();
  const double least = 1e-3 * std::max(box.diagonal().norm(), std::numeric_limits<double>::min());
  const double border = 2 * margin * std::max(box.sizes().x(), box.sizes().y());
  camera.width = std::max(box.sizes().x() + border, least);
  camera.height = std::max(box.sizes().y() + border, least);
  return camera;
}

// ---- drawing --------------------------------------------------------------------------------

/// From the scene to samples: x to the right, y downwards, z towards the eye.
struct Picture::View {
  View(const Camera& camera, int width, int height)
    : origin(camera.centre),
      half_width(0.5 * width),
      half_height(0.5 * height),
      scale(std::min(width / camera.width, height / camera.height))
  {
    axes << camera.right().transpose(), camera.up.transpose(), -camera.view.transpose();
  }

  Vec3 place(const Vec3& p) const
  {
    const Vec3 q = scale * (axes * (p - origin));
    return {half_width + q.x(), half_height - q.y(), q.z()};
  }

  /// Directions keep y upwards.
  Eigen::Vector3f turn(const Vec3& n) const { return (axes * n).cast<float>(); }

  Eigen::Matrix3d axes;
  Vec3 origin;
  double half_width, half_height;
  double scale;  ///< samples per unit of the scene
};

/// Writes samples that are nearer than what is there.
class Picture::Painter {
public:
  Painter(const Picture& picture)
    : m_samples(picture.m_samples),
      m_columns(picture.m_width * samples_per_axis),
      m_rows(picture.m_height * samples_per_axis)
  {
    if(m_samples.empty())
      m_samples.resize(std::size_t(m_columns) * m_rows);
  }

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }

  bool is_hidden(int x, int y, float depth) const
  {
    const Sample& s = m_samples[std::size_t(y) * m_columns + x];
    return s.kind != nothing && s.depth >= depth;
  }

  void put(int x, int y, float depth, const Eigen::Vector3f& normal,
           const std::array<std::uint8_t, 3>& color, Kind kind)
  {
    Sample& s = m_samples[std::size_t(y) * m_columns + x];
    s.depth = depth;
    s.normal_x = static_cast<std::int16_t>(std::clamp(normal.x(), -1.f, 1.f) * 32767);
    s.normal_y = static_cast<std::int16_t>(std::clamp(normal.y(), -1.f, 1.f) * 32767);
    s.color = color;
    s.kind = kind;
  }

  /// Samples whose centres may lie within `radius` of `centre`, cut to the picture: calls
  /// f(x, y, dx, dy).
  template <typename Function>
  void around(const Vec3& centre, double radius, const Function& f)
  {
    // In double first: what is far outside has no int.
    const auto cut = [](double v, int count) { return int(std::clamp(v, 0., double(count))); };
    const int x0 = cut(std::ceil(centre.x() - radius - 0.5), m_columns);
    const int x1 = cut(std::floor(centre.x() + radius - 0.5) + 1, m_columns);
    const int y0 = cut(std::ceil(centre.y() - radius - 0.5), m_rows);
    const int y1 = cut(std::floor(centre.y() + radius - 0.5) + 1, m_rows);
    for(int y = y0; y < y1; ++y) {
      for(int x = x0; x < x1; ++x)
        f(x, y, float(x + 0.5 - centre.x()), float(y + 0.5 - centre.y()));
    }
  }

  void ball(const Vec3& centre, double radius, const std::array<std::uint8_t, 3>& color, Kind kind)
  {
    const float r = float(radius);
    around(centre, radius, [&](int x, int y, float dx, float dy) {
      const float height2 = r * r - dx * dx - dy * dy;
      if(height2 < 0)
        return;
      const float height = std::sqrt(height2);
      const float depth = float(centre.z()) + height;
      if(!is_hidden(x, y, depth))
        put(x, y, depth, Eigen::Vector3f(dx / r, -dy / r, height / r), color, kind);
    });
  }

  /// Calls f(x, y, depth, squared distance to the centre) for the samples of a disc.
  template <typename Function>
  void disc(const Vec3& centre, double radius, const Eigen::Vector3f& normal, const Function& f)
  {
    constexpr float min_slope = 0.02f;  // seen from the side, a disc is a line
    const float r2 = static_cast<float>(radius * radius);
    const float nz = std::max(normal.z(), min_slope);
    around(centre, radius, [&](int x, int y, float dx, float dy) {
      const float dz = -(normal.x() * dx - normal.y() * dy) / nz;
      const float distance2 = dx * dx + dy * dy + dz * dz;
      if(distance2 <= r2)
        f(x, y, static_cast<float>(centre.z()) + dz, distance2);
    });
  }

  void plain_disc(const Vec3& centre, double radius, const Eigen::Vector3f& normal,
                  const std::array<std::uint8_t, 3>& color)
  {
    // Bent away from the eye towards its rim, so that of two that overlap the one with the nearer
    // centre is seen, as in a Voronoi diagram.
    constexpr float bend = 0.3f;
    const float r = static_cast<float>(radius);
    disc(centre, radius, normal, [&](int x, int y, float depth, float distance2) {
      depth -= bend * distance2 / r;
      if(!is_hidden(x, y, depth))
        put(x, y, depth, normal, color, plain);
    });
  }

  /// Where discs overlap at nearly the same depth, their normals and colors are averaged with
  /// weights that vanish at the rims: the surface looks as smooth as its points are.
  void splat(const Vec3& centre, double radius, const Eigen::Vector3f& normal,
             const std::array<std::uint8_t, 3>& color, Kind side)
  {
    constexpr float same_surface = 0.5f;  // difference in depth, in radii
    constexpr float least_weight = 0.01f;
    const float r = static_cast<float>(radius);
    disc(centre, radius, normal, [&](int x, int y, float depth, float distance2) {
      Sample& s = m_samples[static_cast<std::size_t>(y) * m_columns + x];
      const float weight = 1 - distance2 / (r * r) + least_weight;
      if(s.kind != side || std::abs(depth - s.depth) > same_surface * r) {
        if(s.kind == nothing || depth > s.depth) {
          put(x, y, depth, normal, color, side);
          s.weight = weight;
        }
        return;
      }
      const float sum = s.weight + weight;
      const float share = weight / sum;
      s.depth += share * (depth - s.depth);
      s.normal_x += static_cast<std::int16_t>(share * (normal.x() * 32767 - s.normal_x));
      s.normal_y += static_cast<std::int16_t>(share * (normal.y() * 32767 - s.normal_y));
      for(int k = 0; k < 3; ++k) {
        s.color[k] = static_cast<std::uint8_t>(
            s.color[k] + share * (static_cast<float>(color[k]) - s.color[k]) + 0.5f);
      }
      s.weight = sum;
    });
  }

  void rod(const Vec3& a, const Vec3& b, double radius, const Color& color_a, const Color& color_b)
  {
    const double length2 = (b - a).head<2>().squaredNorm();
    if(length2 == 0)
      return;
    const Eigen::Vector2d along = (b - a).head<2>() / std::sqrt(length2);
    const double slope = (b.z() - a.z()) / std::sqrt(length2);
    // Along the line of sight the rod's section is an ellipse, longer by this than the circle.
    const float stretch = float(std::sqrt(1 + slope * slope));
    const float r = float(radius);
    const bool one_color = &color_a == &color_b;
    const auto color = to_bytes(color_a);

    // Row by row only the part that the rod covers, or long rods would cost their boxes' area.
    const double top = std::min(a.y(), b.y()) - radius, bottom = std::max(a.y(), b.y()) + radius;
    const int y0 = int(std::clamp(std::ceil(top - 0.5), 0., double(m_rows)));
    const int y1 = int(std::clamp(std::floor(bottom - 0.5) + 1, 0., double(m_rows)));
    const double left = std::min(a.x(), b.x()) - radius, right = std::max(a.x(), b.x()) + radius;
    for(int y = y0; y < y1; ++y) {
      double from = left, to = right;
      if(std::abs(along.y()) > 1e-6) {
        // |cross(along, (x, y) - a)| <= radius
        const double middle = a.x() + (y + 0.5 - a.y()) * along.x() / along.y();
        const double half = radius / std::abs(along.y());
        from = std::max(from, middle - half);
        to = std::min(to, middle + half);
      }
      const int x0 = int(std::clamp(std::ceil(from - 0.5), 0., double(m_columns)));
      const int x1 = int(std::clamp(std::floor(to - 0.5) + 1, 0., double(m_columns)));
      for(int x = x0; x < x1; ++x) {
        const double dx = x + 0.5 - a.x(), dy = y + 0.5 - a.y();
        const double t = (dx * along.x() + dy * along.y()) / std::sqrt(length2);
        const float across = float(dx * along.y() - dy * along.x());
        const float height2 = r * r - across * across;
        if(t < 0 || t > 1 || height2 < 0)
          continue;
        const float height = std::sqrt(height2);
        const float depth = float(a.z() + t * (b.z() - a.z())) + height * stretch;
        if(is_hidden(x, y, depth))
          continue;
        // across * (along.y, -along.x) is the offset in the picture, whose y goes down.
        const float slope_part = float(-slope) / stretch * height / r;
        const Eigen::Vector3f normal(float(across / r * along.y() + slope_part * along.x()),
                                     float(across / r * along.x() - slope_part * along.y()),
                                     height / (r * stretch));
        put(x, y, depth, normal, one_color ? color : to_bytes(mix(color_a, color_b, t)), shaded);
      }
    }
  }

private:
  std::vector<Sample>& m_samples;
  int m_columns;
  int m_rows;
};

Picture::Picture(int width, int height, const Color& background) : m_width(width), m_height(height)
{
  if(width < 1 || height < 1 || width > max_size || height > max_size) {
    throw std::invalid_argument("Picture: a size of " + std::to_string(width) + " x "
                                + std::to_string(height) + " pixels");
  }
  m_image.resize(3 * std::size_t(width) * height);
  fill_rectangle(0, 0, width, height, background);
}

void Picture::draw_mesh(const Triangle_mesh& mesh, const Camera& camera, const Mesh_style& style)
{
  check_count("vertex colors", style.vertex_colors.size(), mesh.vertices.size());
  check_count("face colors", style.face_colors.size(), mesh.faces.size());
  constexpr float line_radius = 0.4f * samples_per_axis;
  constexpr float line_darkness = 0.55f;

  Painter painter(*this);
  const View view(camera, painter.columns(), painter.rows());
  std::vector<Vec3> place(mesh.vertices.size());
  for(std::size_t v = 0; v < place.size(); ++v)
    place[v] = view.place(mesh.vertices[v]);
  const auto normals = corner_normals(mesh, style.smooth);

  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    const Vec3 &a = place[face[0]], &b = place[face[1]], &c = place[face[2]];
    // Twice the signed area; y goes down, hence front faces are negative.
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if(!std::isfinite(area) || area == 0)
      continue;
    const bool front = area < 0;
    const float facing = front ? 1.f : -1.f;

    std::array<Eigen::Vector3f, 3> normal;
    std::array<Eigen::Vector3f, 3> tint;
    for(int k = 0; k < 3; ++k) {
      normal[k] = facing * view.turn(normals[f][k].cast<double>());
      const Color& own
          = color_of(style.face_colors, f, color_of(style.vertex_colors, face[k], style.color));
      const Color& shown = front ? own : style.back_color;
      tint[k] = 255 * Eigen::Vector3f(float(shown.red), float(shown.green), float(shown.blue));
    }
    const bool one_color = !front || style.vertex_colors.empty() || !style.face_colors.empty();
    std::array<std::uint8_t, 3> color;
    for(int i = 0; i < 3; ++i)
      color[i] = static_cast<std::uint8_t>(std::clamp(tint[0][i] + 0.5f, 0.f, 255.f));

    // Barycentric coordinates are linear in the picture: w[k] = at_origin[k] + x dx[k] + y dy[k].
    const std::array<const Vec3*, 3> corner = {&a, &b, &c};
    std::array<double, 3> at_origin, dx, dy;
    std::array<float, 3> height;  // of the triangle over each edge, in samples
    for(int k = 0; k < 3; ++k) {
      const Vec3 &p = *corner[(k + 1) % 3], &q = *corner[(k + 2) % 3];
      dx[k] = (p.y() - q.y()) / area;
      dy[k] = (q.x() - p.x()) / area;
      at_origin[k] = (p.x() * q.y() - p.y() * q.x()) / area;
      height[k] = float(1 / std::hypot(dx[k], dy[k]));
    }

    const auto cut = [](double v, int count) { return int(std::clamp(v, 0., double(count))); };
    const int y0 = cut(std::ceil(std::min({a.y(), b.y(), c.y()}) - 0.5), painter.rows());
    const int y1 = cut(std::floor(std::max({a.y(), b.y(), c.y()}) - 0.5) + 1, painter.rows());
    const int x0 = cut(std::ceil(std::min({a.x(), b.x(), c.x()}) - 0.5), painter.columns());
    const int x1 = cut(std::floor(std::max({a.x(), b.x(), c.x()}) - 0.5) + 1, painter.columns());
    for(int y = y0; y < y1; ++y) {
      // The part of the row where no coordinate is negative.
      double from = x0, to = x1;
      for(int k = 0; k < 3; ++k) {
        const double at_row = at_origin[k] + (y + 0.5) * dy[k];
        if(dx[k] > 0)
          from = std::max(from, std::ceil(-at_row / dx[k] - 0.5));
        else if(dx[k] < 0)
          to = std::min(to, std::floor(-at_row / dx[k] - 0.5) + 1);
        else if(at_row < 0)
          to = from;
      }
      for(int x = int(from); x < int(to); ++x) {
        std::array<float, 3> w;
        for(int k = 0; k < 3; ++k)
          w[k] = float(at_origin[k] + (x + 0.5) * dx[k] + (y + 0.5) * dy[k]);
        const float depth = w[0] * float(a.z()) + w[1] * float(b.z()) + w[2] * float(c.z());
        if(painter.is_hidden(x, y, depth))
          continue;
        const Eigen::Vector3f n
            = (w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2]).normalized();
        auto shown = color;
        if(!one_color) {
          const Eigen::Vector3f mixed = w[0] * tint[0] + w[1] * tint[1] + w[2] * tint[2];
          for(int i = 0; i < 3; ++i)
            shown[i] = static_cast<std::uint8_t>(std::clamp(mixed[i] + 0.5f, 0.f, 255.f));
        }
        if(style.edges) {
          const float to_edge = std::min({w[0] * height[0], w[1] * height[1], w[2] * height[2]});
          if(to_edge < line_radius) {
            for(std::uint8_t& channel : shown)
              channel = static_cast<std::uint8_t>(line_darkness * channel);
          }
        }
        painter.put(x, y, depth, n, shown, shaded);
      }
    }
  }
}

void Picture::draw_points(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                          const Camera& camera, const Point_style& style)
{
  check_count("normals", normals.size(), points.size());
  check_count("point colors", style.point_colors.size(), points.size());
  constexpr double ball_share = 0.42;  // room is left to tell the balls apart
  constexpr double min_radius = 0.75 * samples_per_axis;
  // Discs that are seen almost from the side, from behind, would frame every outline.
  constexpr float least_turned_away = -0.25f;

  Painter painter(*this);
  const View view(camera, painter.columns(), painter.rows());
  const double spacing = style.radius > 0 ? 0 : typical_spacing(points);
  std::vector<double> radii;
  if(style.radius <= 0 && !normals.empty())
    radii = local_radii(points, spacing);
  const Kind kind = style.shaded ? shaded : plain;

  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = view.place(points[i]);
    if(!p.allFinite())
      continue;
    const double radius = style.radius > 0 ? style.radius
                          : radii.empty()  ? ball_share * spacing
                                           : radii[i];
    const double samples = std::max(view.scale * radius, min_radius);
    const auto color = to_bytes(color_of(style.point_colors, i, style.color));
    Eigen::Vector3f n(0, 0, 0);
    if(!normals.empty())
      n = view.turn(normals[i].stableNormalized());
    if(!n.allFinite() || n.isZero())
      painter.ball(p, samples, color, kind);
    else if(n.z() >= 0 && style.shaded)
      painter.splat(p, samples, n, color, front_splat);
    else if(n.z() >= 0)
      painter.plain_disc(p, samples, n, color);
    else if(n.z() < least_turned_away && style.shaded)
      painter.splat(p, samples, -n, to_bytes(style.back_color), back_splat);
    else if(n.z() < least_turned_away)
      painter.plain_disc(p, samples, -n, to_bytes(style.back_color));
  }
}

void Picture::draw_segments(const Segment_graph& graph, const Camera& camera,
                            const Segment_style& style)
{
  check_count("vertex colors", style.vertex_colors.size(), graph.vertices.size());
  // Many rods are drawn thinner, or they hide each other.
  constexpr double default_share = 1. / 250, least_share = 1. / 900;
  constexpr double few = 200;
  const double share
      = default_share * std::sqrt(few / std::max(few, static_cast<double>(graph.edges.size())));

  Painter painter(*this);
  const View view(camera, painter.columns(), painter.rows());
  const double radius = style.radius > 0 ? view.scale * style.radius
                                         : std::max(share, least_share)
                                               * std::min(painter.columns(), painter.rows());
  const double node_radius
      = style.node_radius > 0 ? std::max(view.scale * style.node_radius, radius) : radius;
  std::vector<Vec3> place(graph.vertices.size());
  for(std::size_t v = 0; v < place.size(); ++v) {
    place[v] = view.place(graph.vertices[v]);
    if(place[v].allFinite())
      painter.ball(place[v], node_radius, to_bytes(color_of(style.vertex_colors, v, style.color)),
                   shaded);
  }
  for(const auto& edge : graph.edges) {
    if(place[edge[0]].allFinite() && place[edge[1]].allFinite()) {
      painter.rod(place[edge[0]], place[edge[1]], radius,
                  color_of(style.vertex_colors, edge[0], style.color),
                  color_of(style.vertex_colors, edge[1], style.color));
    }
  }
}

// ---- light ----------------------------------------------------------------------------------

/// How much of the sky each pixel sees, from 0 to 1: samples of the neighbourhood that rise above
/// the pixel's tangent plane take some of it away.
std::vector<float> Picture::openness() const
{
  constexpr int directions = 8;
  constexpr int rings = 3;
  constexpr float bias = 0.12f;  // sine of the elevation that is not yet held for a fold
  constexpr float strength = 1.75f;
  constexpr int pattern = 4;  // pixels after which the turn of the directions repeats
  constexpr float max_depth_step = 6;

  struct Surfel {
    float depth;  // in pixels
    Eigen::Vector3f normal;
    bool is_shaded;
  };
  std::vector<Surfel> surfels(std::size_t(m_width) * m_height);
  const int columns = m_width * samples_per_axis;
  for(int y = 0; y < m_height; ++y) {
    for(int x = 0; x < m_width; ++x) {
      const Sample& s = m_samples[std::size_t(samples_per_axis * y + samples_per_axis / 2) * columns
                                  + samples_per_axis * x + samples_per_axis / 2];
      Surfel& t = surfels[std::size_t(y) * m_width + x];
      t.depth = s.depth / samples_per_axis;
      const float nx = s.normal_x / 32767.f, ny = s.normal_y / 32767.f;
      t.normal = {nx, ny, std::sqrt(std::max(0.f, 1 - nx * nx - ny * ny))};
      t.is_shaded = is_lit(s.kind);
    }
  }

  const float reach = 0.075f * float(std::min(m_width, m_height));
  std::array<std::array<Eigen::Vector2i, directions * rings>, pattern * pattern> offsets;
  for(int turn = 0; turn < pattern * pattern; ++turn) {
    // Neighbouring pixels get turns that are far apart.
    const float angle0 = float((turn * 7) % (pattern * pattern)) / (pattern * pattern);
    for(int d = 0; d < directions; ++d) {
      for(int r = 0; r < rings; ++r) {
        const float angle = float(2 * EIGEN_PI) * (float(d) + angle0) / directions;
        // Denser towards the pixel.
        const float t = (float(r) + 0.35f + 0.6f * angle0) / rings;
        const float length = 1 + reach * t * t;
        offsets[turn][d * rings + r] = {static_cast<int>(std::lround(length * std::cos(angle))),
                                        static_cast<int>(std::lround(length * std::sin(angle)))};
      }
    }
  }

  std::vector<float> open(surfels.size(), 1);
  for(int y = 0; y < m_height; ++y) {
    for(int x = 0; x < m_width; ++x) {
      const Surfel& s = surfels[std::size_t(y) * m_width + x];
      if(!s.is_shaded)
        continue;
      float hidden = 0;
      for(const Eigen::Vector2i& o : offsets[(y % pattern) * pattern + x % pattern]) {
        const int u = x + o.x(), v = y + o.y();
        if(u < 0 || v < 0 || u >= m_width || v >= m_height)
          continue;
        const Surfel& t = surfels[std::size_t(v) * m_width + u];
        if(!t.is_shaded)
          continue;
        const Eigen::Vector3f to(float(u - x), float(y - v), t.depth - s.depth);
        const float length = to.norm();
        const float rise = to.dot(s.normal) / std::max(length, 1e-3f) - bias;
        if(rise > 0) {
          const float far = length / reach;
          hidden += rise / (1 + far * far * far);
        }
      }
      open[std::size_t(y) * m_width + x]
          = std::max(0.f, 1 - strength * hidden / (directions * rings));
    }
  }

  // The pattern's noise is averaged away over its period, but not across jumps in depth.
  std::vector<float> smooth(open.size(), 1);
  for(int y = 0; y < m_height; ++y) {
    for(int x = 0; x < m_width; ++x) {
      const Surfel& s = surfels[std::size_t(y) * m_width + x];
      if(!s.is_shaded)
        continue;
      float sum = 0, weight = 0;
      for(int v = std::max(0, y - pattern / 2); v < std::min(m_height, y + pattern / 2); ++v) {
        for(int u = std::max(0, x - pattern / 2); u < std::min(m_width, x + pattern / 2); ++u) {
          const Surfel& t = surfels[std::size_t(v) * m_width + u];
          if(!t.is_shaded || std::abs(t.depth - s.depth) > max_depth_step)
            continue;
          sum += open[std::size_t(v) * m_width + u];
          weight += 1;
        }
      }
      smooth[std::size_t(y) * m_width + x]
          = weight > 0 ? sum / weight : open[std::size_t(y) * m_width + x];
    }
  }
  return smooth;
}

/// Lights the scene and leaves only the image.
void Picture::flatten() const
{
  if(m_samples.empty())
    return;
  using Eigen::Vector3f;
  // Camera's axes: x to the right, y upwards, z towards the eye.
  const Vector3f key = Vector3f(-0.45f, 0.62f, 0.70f).normalized();
  const Vector3f fill = Vector3f(0.75f, 0.05f, 0.55f).normalized();
  const Vector3f key_half = (key + Vector3f::UnitZ()).normalized();
  constexpr float key_light = 0.78f, fill_light = 0.12f, sky_light = 0.38f, ground_light = 0.15f;
  constexpr float gloss = 0.07f;
  constexpr int gloss_squarings = 5;  // exponent 2^5

  const std::vector<float> open = openness();
  const auto& linear = linear_of_byte();
  const int columns = m_width * samples_per_axis;
  constexpr int samples = samples_per_axis * samples_per_axis;
  for(int y = 0; y < m_height; ++y) {
    for(int x = 0; x < m_width; ++x) {
      std::uint8_t* pixel = &m_image[3 * (std::size_t(y) * m_width + x)];
      Vector3f sum(0, 0, 0);
      int empty = 0;
      for(int j = 0; j < samples_per_axis; ++j) {
        const Sample* row = &m_samples[std::size_t(samples_per_axis * y + j) * columns
                                       + std::size_t(samples_per_axis) * x];
        for(int i = 0; i < samples_per_axis; ++i) {
          const Sample& s = row[i];
          if(s.kind == nothing) {
            ++empty;
            continue;
          }
          Vector3f light(linear[s.color[0]], linear[s.color[1]], linear[s.color[2]]);
          if(is_lit(s.kind)) {
            const float nx = s.normal_x / 32767.f, ny = s.normal_y / 32767.f;
            const Vector3f n(nx, ny, std::sqrt(std::max(0.f, 1 - nx * nx - ny * ny)));
            const float o = open[std::size_t(y) * m_width + x];
            const float sky = 0.5f + 0.5f * ny;
            const float ambient = ground_light + (sky_light - ground_light) * sky;
            float shine = std::max(0.f, n.dot(key_half));
            for(int k = 0; k < gloss_squarings; ++k)
              shine *= shine;
            const float direct
                = key_light * std::max(0.f, n.dot(key)) + fill_light * std::max(0.f, n.dot(fill));
            // Folds are darker for the sky than for the lamp.
            light *= ambient * o * o + direct * (0.45f + 0.55f * o);
            light.array() += gloss * shine * o;
          }
          sum += light;
        }
      }
      if(empty == samples)
        continue;
      for(int k = 0; k < 3; ++k)
        pixel[k] = byte_of_linear((sum[k] + float(empty) * linear[pixel[k]]) / samples);
    }
  }
  m_samples.clear();
  m_samples.shrink_to_fit();
}

// ---- the image ------------------------------------------------------------------------------

double Picture::label_width(const std::string& text, double height)
{
  return height * text_width(text);
}

void Picture::label(const std::string& text, double x, double y, const Label_style& style)
{
  flatten();
  const double width = label_width(text, style.height);
  if(style.align == Align::centre)
    x -= 0.5 * width;
  else if(style.align == Align::right)
    x -= width;

  const double pen = std::max(0.6, pen_radius * style.height);
  const double reach = pen + 1;
  // Strokes are joined before they are blended, or their crossings would be darker.
  const int x0 = int(std::clamp(std::floor(x - reach), 0., double(m_width)));
  const int x1 = int(std::clamp(std::ceil(x + width + reach), 0., double(m_width)));
  const int y0 = int(std::clamp(std::floor(y - 1.4 * style.height), 0., double(m_height)));
  const int y1 = int(std::clamp(std::ceil(y + 0.6 * style.height), 0., double(m_height)));
  if(x0 >= x1 || y0 >= y1)
    return;
  std::vector<float> cover(std::size_t(x1 - x0) * (y1 - y0), 0);
  for(const Stroke& stroke : text_strokes(text)) {
    for(std::size_t i = 0; i + 1 < stroke.size(); ++i) {
      const Eigen::Vector2d a(x + style.height * stroke[i][0], y - style.height * stroke[i][1]);
      const Eigen::Vector2d b(x + style.height * stroke[i + 1][0],
                              y - style.height * stroke[i + 1][1]);
      const double length2 = (b - a).squaredNorm();
      const int u0 = std::max(x0, int(std::floor(std::min(a.x(), b.x()) - reach)));
      const int u1 = std::min(x1, int(std::ceil(std::max(a.x(), b.x()) + reach)));
      const int v0 = std::max(y0, int(std::floor(std::min(a.y(), b.y()) - reach)));
      const int v1 = std::min(y1, int(std::ceil(std::max(a.y(), b.y()) + reach)));
      for(int v = v0; v < v1; ++v) {
        for(int u = u0; u < u1; ++u) {
          const Eigen::Vector2d p(u + 0.5, v + 0.5);
          const double t = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0., 1.) : 0.;
          const double distance = (a + t * (b - a) - p).norm();
          float& c = cover[std::size_t(v - y0) * (x1 - x0) + (u - x0)];
          c = std::max(c, float(std::clamp(pen + 0.5 - distance, 0., 1.)));
        }
      }
    }
  }
  const auto ink = to_bytes(style.color);
  for(int v = y0; v < y1; ++v) {
    for(int u = x0; u < x1; ++u) {
      const float c = cover[std::size_t(v - y0) * (x1 - x0) + (u - x0)];
      std::uint8_t* pixel = &m_image[3 * (std::size_t(v) * m_width + u)];
      for(int k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(pixel[k] + c * (ink[k] - pixel[k]) + 0.5f);
    }
  }
}

void Picture::color_bar(const std::function<Color(double)>& map, double x, double y, double width,
                        double height, const std::string& low, const std::string& high)
{
  const int rows = int(std::lround(height));
  for(int i = 0; i < rows; ++i) {
    fill_rectangle(int(std::lround(x)), int(std::lround(y)) + i, int(std::lround(width)), 1,
                   map(1 - (i + 0.5) / rows));
  }
  Label_style style;
  style.height = std::clamp(0.06 * height, 9., 18.);
  label(high, x + width + 0.6 * style.height, y + style.height, style);
  label(low, x + width + 0.6 * style.height, y + height, style);
}

void Picture::fill_rectangle(int x, int y, int width, int height, const Color& color)
{
  flatten();
  const auto bytes = to_bytes(color);
  for(int v = std::max(0, y); v < std::min(m_height, y + height); ++v) {
    for(int u = std::max(0, x); u < std::min(m_width, x + width); ++u)
      std::copy(bytes.begin(), bytes.end(), &m_image[3 * (std::size_t(v) * m_width + u)]);
  }
}

Picture Picture::side_by_side(const std::vector<Picture>& pictures, std::size_t columns, int gap)
{
  if(pictures.empty())
    throw std::invalid_argument("Picture: there is nothing to put side by side");
  if(columns == 0 || columns > pictures.size())
    columns = pictures.size();
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  std::vector<int> column_x(columns + 1, 0), row_y(rows + 1, 0);
  for(std::size_t i = 0; i < pictures.size(); ++i) {
    int& width = column_x[i % columns + 1];
    int& height = row_y[i / columns + 1];
    width = std::max(width, pictures[i].width() + gap);
    height = std::max(height, pictures[i].height() + gap);
  }
  std::partial_sum(column_x.begin(), column_x.end(), column_x.begin());
  std::partial_sum(row_y.begin(), row_y.end(), row_y.begin());

  Picture all(column_x.back() - gap, row_y.back() - gap);
  for(std::size_t i = 0; i < pictures.size(); ++i) {
    const Picture& p = pictures[i];
    p.flatten();
    const std::size_t c = i % columns, r = i / columns;
    const int x = column_x[c] + (column_x[c + 1] - column_x[c] - gap - p.width()) / 2;
    const int y = row_y[r] + (row_y[r + 1] - row_y[r] - gap - p.height()) / 2;
    for(int v = 0; v < p.height(); ++v) {
      const auto row = p.m_image.begin() + 3 * std::ptrdiff_t(v) * p.width();
      std::copy(row, row + 3 * std::ptrdiff_t(p.width()),
                all.m_image.begin() + 3 * (std::ptrdiff_t(y + v) * all.width() + x));
    }
  }
  return all;
}

Color Picture::pixel(int x, int y) const
{
  if(x < 0 || y < 0 || x >= m_width || y >= m_height)
    throw std::out_of_range("Picture: there is no such pixel");
  flatten();
  const std::uint8_t* p = &m_image[3 * (std::size_t(y) * m_width + x)];
  return {p[0] / 255., p[1] / 255., p[2] / 255.};
}

void Picture::write_png(const std::string& file) const
{
  flatten();
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(m_width);
  image.height = static_cast<png_uint_32>(m_height);
  image.format = PNG_FORMAT_RGB;
  const auto release = [](png_image* i) { png_image_free(i); };
  const std::unique_ptr<png_image, decltype(release)> guard(&image, release);

  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if(!png_image_write_to_memory(&image, &bytes[0], &size, 0, m_image.data(), 0, nullptr))
    file_error(file, std::string("cannot be encoded: ") + image.message);
  bytes.resize(size);
  write_file(file, bytes);
}

// ---- figures --------------------------------------------------------------------------------

Color label_color(std::size_t label)
{
  // Hues a golden section apart.
  const double hue = 6 * std::fmod(0.618033988749895 * double(label) + 0.05, 1.);
  const double fade = 1 - std::abs(std::fmod(hue, 2.) - 1);
  const std::array<std::array<double, 3>, 6> channels = {
    {{1, fade, 0}, {fade, 1, 0}, {0, 1, fade}, {0, fade, 1}, {fade, 0, 1}, {1, 0, fade}}};
  const std::array<double, 3>& c = channels[std::size_t(hue) % 6];
  constexpr double least = 40. / 255, range = 200. / 255;  // neither black nor garish
  return Color{least + range * c[0], least + range * c[1], least + range * c[2]};
}

void write_panels(const std::string& png, const std::vector<Panel>& panels,
                  const Vec3& view_direction, const Vec3& up, int panel_height, std::size_t columns)
{
  constexpr double min_aspect = 0.55, max_aspect = 1.7;
  const double text_height = std::clamp(0.03 * panel_height, 9., 30.);
  const int title_height = int(std::lround(2.4 * text_height));

  std::vector<Vec3> all;
  for(const Panel& panel : panels) {
    for(const auto* part : {&panel.cloud.points, &panel.mesh.vertices, &panel.graph.vertices})
      all.insert(all.end(), part->begin(), part->end());
  }
  const Camera camera = fit_camera(all, view_direction, up);
  const double aspect = std::clamp(camera.width / camera.height, min_aspect, max_aspect);
  const int shortest = int(std::lround(panel_height * aspect));

  std::vector<Picture> pictures;
  for(const Panel& panel : panels) {
    const int title_width
        = int(std::ceil(Picture::label_width(panel.title, text_height) + 2 * text_height));
    const int width = std::max(shortest, title_width);
    Picture scene(width, panel_height);
    if(!panel.mesh.faces.empty()) {
      Mesh_style style;
      style.vertex_colors = panel.vertex_colors;
      scene.draw_mesh(panel.mesh, camera, style);
    }
    if(!panel.cloud.points.empty()) {
      Point_style style;
      style.point_colors = panel.point_colors;
      style.radius = panel.point_radius;
      if(style.point_colors.empty()) {
        for(double c : panel.cloud.confidence)
          style.point_colors.push_back(confidence_color(c));
      }
      scene.draw_points(panel.cloud.points, panel.cloud.normals, camera, style);
    }
    if(!panel.graph.vertices.empty()) {
      scene.pixel(0, 0);  // ends the scene, so that no surface hides the graph
      Segment_style style;
      style.radius = panel.segment_radius;
      scene.draw_segments(panel.graph, camera, style);
    }

    Picture title(width, title_height);
    Label_style style;
    style.height = text_height;
    style.align = Align::centre;
    title.label(panel.title, 0.5 * width, 1.5 * text_height, style);
    pictures.push_back(Picture::side_by_side({scene, title}, 1, 0));
  }
  Picture::side_by_side(pictures, columns).write_png(png);
}

}  // namespace support
