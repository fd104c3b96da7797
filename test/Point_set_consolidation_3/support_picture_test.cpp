// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The renderer on scenes whose picture is known.
#undef NDEBUG
#include "file_bytes.h"
#include "picture.h"

#include <Eigen/Geometry>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>

using namespace support;

namespace {

constexpr Color black{0, 0, 0};
constexpr Color red{1, 0, 0};
constexpr Color green{0, 1, 0};

/// Latitudes and longitudes.
Triangle_mesh sphere(const Vec3& centre, double radius, std::size_t n = 100)
{
  Triangle_mesh mesh;
  mesh.vertices = {centre + radius * Vec3::UnitZ(), centre - radius * Vec3::UnitZ()};
  const auto at = [n](std::size_t i, std::size_t j) { return 2 + (i - 1) * 2 * n + j % (2 * n); };
  for(std::size_t i = 1; i < n; ++i) {
    for(std::size_t j = 0; j < 2 * n; ++j) {
      const double u = EIGEN_PI * i / n, v = EIGEN_PI * j / n;
      mesh.vertices.push_back(
          centre
          + radius * Vec3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)));
    }
  }
  for(std::size_t j = 0; j < 2 * n; ++j) {
    mesh.faces.push_back({0, at(1, j), at(1, j + 1)});
    mesh.faces.push_back({1, at(n - 1, j + 1), at(n - 1, j)});
    for(std::size_t i = 1; i + 1 < n; ++i) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// From -1 to 1 in x and y, facing z.
Triangle_mesh square(double z)
{
  Triangle_mesh mesh;
  mesh.vertices = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Camera front_camera(double size)
{
  Camera camera;
  camera.width = camera.height = size;
  return camera;
}

/// Pixels of which more than half is covered, on white ground.
double covered_pixels(const Picture& picture)
{
  double count = 0;
  for(int y = 0; y < picture.height(); ++y) {
    for(int x = 0; x < picture.width(); ++x) {
      const Color c = picture.pixel(x, y);
      count += c.red + c.green + c.blue < 2.2;
    }
  }
  return count;
}

bool is_close(const Color& a, const Color& b, double tolerance = 0.02)
{
  return std::abs(a.red - b.red) < tolerance && std::abs(a.green - b.green) < tolerance
         && std::abs(a.blue - b.blue) < tolerance;
}

/// The colour's own hue survives the shading.
bool is_mostly_red(const Color& c)
{
  return c.red > 0.3 && c.green < 0.6 * c.red && c.blue < 0.6 * c.red;
}

bool is_mostly_green(const Color& c)
{
  return c.green > 0.3 && c.red < 0.6 * c.green && c.blue < 0.6 * c.green;
}

bool is_within(double value, double expected, double relative)
{
  return std::abs(value - expected) <= relative * expected;
}

void silhouettes_have_their_area()
{
  const double r = 0.8, pixels_per_unit = 200;
  const double expected = EIGEN_PI * std::pow(r * pixels_per_unit, 2);

  // A mesh, far from the origin and from any direction.
  const Vec3 centre(4e6, -3e6, 1e6);
  for(const Vec3& direction : {Vec3(0, 0, -1), Vec3(1, 2, 3), Vec3(0, -1, 0)}) {
    Camera camera = fit_camera({centre}, direction, Vec3::UnitY());
    camera.width = camera.height = 2;
    Picture picture(400, 400);
    Mesh_style style;
    style.color = black;
    picture.draw_mesh(sphere(centre, r), camera, style);
    assert(is_within(covered_pixels(picture), expected, 0.01));
  }

  // A ball, and a disc seen from an angle of 60 degrees.
  Point_style style;
  style.color = style.back_color = black;
  style.shaded = false;
  style.radius = r;
  Picture ball(400, 400);
  ball.draw_points({Vec3::Zero()}, {}, front_camera(2), style);
  assert(is_within(covered_pixels(ball), expected, 0.01));
  for(double sign : {-1., 1.}) {
    Picture disc(400, 400);
    disc.draw_points({Vec3::Zero()}, {sign * Vec3(0, std::sqrt(3), 1)}, front_camera(2), style);
    assert(is_within(covered_pixels(disc), 0.5 * expected, 0.01));
  }

  // A rod with its two half balls, tilted away from the picture's plane.
  Segment_graph graph;
  graph.vertices = {Vec3(-0.6, -0.6, -1), Vec3(0.6, 0.6, 1)};
  graph.edges = {{0, 1}};
  Segment_style rod_style;
  rod_style.color = black;
  rod_style.radius = 0.1;
  Picture rod(400, 400);
  rod.draw_segments(graph, front_camera(2), rod_style);
  const double rod_area = 1.2 * std::sqrt(2) * 0.2 + EIGEN_PI * 0.01;
  assert(is_within(covered_pixels(rod), rod_area * 200 * 200, 0.01));
}

void nearer_things_hide_others()
{
  const Camera camera = front_camera(4);
  Mesh_style mesh_style;
  mesh_style.color = red;
  Point_style point_style;
  point_style.color = green;
  point_style.radius = 0.3;

  // Whatever is drawn first; the camera looks along -z.
  for(bool mesh_first : {true, false}) {
    for(bool with_normals : {true, false}) {
      Picture picture(200, 200);
      const std::vector<Vec3> points = {{-0.5, 0, 1}, {0.5, 0, -1}};
      const std::vector<Vec3> normals(with_normals ? 2 : 0, Vec3::UnitZ());
      if(mesh_first)
        picture.draw_mesh(square(0), camera, mesh_style);
      picture.draw_points(points, normals, camera, point_style);
      if(!mesh_first)
        picture.draw_mesh(square(0), camera, mesh_style);
      assert(is_mostly_green(picture.pixel(75, 100)));
      assert(is_mostly_red(picture.pixel(125, 100)));
      assert(is_close(picture.pixel(5, 5), colors::white));
    }
  }

  Picture picture(200, 200);
  Segment_graph graph;
  graph.vertices = {Vec3(-0.9, 0, 1), Vec3(0.9, 0, -1)};  // pierces the square at the centre
  graph.edges = {{0, 1}};
  Segment_style style;
  style.color = green;
  style.radius = 0.1;
  picture.draw_mesh(square(0), camera, mesh_style);
  picture.draw_segments(graph, camera, style);
  assert(is_mostly_green(picture.pixel(70, 100)));
  assert(is_mostly_red(picture.pixel(130, 100)));
}

void back_faces_and_colors()
{
  Mesh_style style;
  style.color = red;
  style.back_color = green;
  Picture front(50, 50), back(50, 50);
  front.draw_mesh(square(0), front_camera(2), style);
  back.draw_mesh(square(0), fit_camera(square(0).vertices, Vec3::UnitZ(), Vec3::UnitY()), style);
  assert(is_mostly_red(front.pixel(25, 25)));
  assert(is_mostly_green(back.pixel(25, 25)));

  // Up is up and right is right.
  style.face_colors = {red, green};
  Picture faces(100, 100);
  faces.draw_mesh(square(0), front_camera(2), style);
  assert(is_mostly_red(faces.pixel(75, 90)));    // lower right
  assert(is_mostly_green(faces.pixel(25, 10)));  // upper left

  style.face_colors.clear();
  style.vertex_colors = {red, green, green, red};
  Picture vertices(100, 100);
  vertices.draw_mesh(square(0), front_camera(2), style);
  assert(is_mostly_red(vertices.pixel(3, 50)));
  assert(is_mostly_green(vertices.pixel(96, 50)));

  // Light comes from above.
  Picture ball(100, 100);
  ball.draw_mesh(sphere(Vec3::Zero(), 1), front_camera(2));
  assert(ball.pixel(50, 10).green > ball.pixel(50, 90).green + 0.15);
  // What is not shaded keeps its colour.
  Point_style plain;
  plain.shaded = false;
  plain.radius = 0.5;
  Picture dot(100, 100);
  dot.draw_points({Vec3::Zero()}, {}, front_camera(2), plain);
  assert(is_close(dot.pixel(50, 50), colors::scan, 0.005));
}

void cameras_see_everything()
{
  std::vector<Vec3> points;
  for(int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? 3 : -1, i & 2 ? 5 : 1, i & 4 ? 1e-3 : 0);
  for(const Vec3& direction : {Vec3(0, 0, -1), Vec3(1, 1, 1), Vec3(0, 1, 0), Vec3(-2, 0.1, 5)}) {
    const Camera camera = fit_camera(points, direction, Vec3::UnitY(), 0.05);
    assert(std::abs(camera.view.dot(camera.up)) < 1e-12);
    assert(std::abs(camera.view.norm() - 1) < 1e-12);
    double extent = 0;
    for(const Vec3& p : points) {
      const double x = std::abs(camera.right().dot(p - camera.centre)) / (0.5 * camera.width);
      const double y = std::abs(camera.up.dot(p - camera.centre)) / (0.5 * camera.height);
      assert(x < 1 && y < 1);
      extent = std::max({extent, x, y});
    }
    assert(extent > 0.85);
  }
  // Nothing to see, one point, values that are not finite: still a camera.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const auto& some :
      {std::vector<Vec3>{}, std::vector<Vec3>{Vec3(1, 2, 3)}, std::vector<Vec3>{Vec3(nan, 0, 0)}}) {
    const Camera camera = fit_camera(some, Vec3::Zero(), Vec3::Zero());
    assert(camera.width > 0 && camera.height > 0 && camera.centre.allFinite()
           && camera.up.allFinite() && camera.view.allFinite());
  }
}

void labels_leave_ink()
{
  Picture empty(200, 60), text(200, 60);
  Label_style style;
  style.height = 20;
  text.label("Hill", 20, 40, style);
  assert(covered_pixels(empty) == 0);
  // The first stroke of the H: 20 pixels high, above the baseline.
  assert(is_close(text.pixel(20, 30), colors::ink, 0.1));
  assert(is_close(text.pixel(20, 21), colors::ink, 0.1));
  assert(is_close(text.pixel(20, 46), colors::white));
  assert(is_close(text.pixel(20, 14), colors::white));
  const int width = static_cast<int>(Picture::label_width("Hill", 20));
  assert(is_close(text.pixel(20 + width + 5, 30), colors::white));

  // Alignment, and no harm at or beyond the border.
  Picture right(200, 60);
  style.align = Align::right;
  right.label("Hill", 20 + Picture::label_width("Hill", 20), 40, style);
  for(int x = 0; x < 200; ++x)
    assert(is_close(right.pixel(x, 30), text.pixel(x, 30), 0.1));
  right.label("far away \xff\n", -500, 1000, style);
  right.label("cut", 3, 3, style);
  // Every printable character has strokes of its own, except space.
  for(char c = '!'; c <= '~'; ++c) {
    Picture one(40, 60);
    one.label(std::string(1, c), 10, 40);
    assert(covered_pixels(one) > 0);
  }
}

void color_maps_order_values()
{
  assert(is_close(confidence_color(1), colors::scan, 1e-9));
  assert(is_close(confidence_color(0), colors::completed, 1e-9));
  assert(is_close(confidence_color(-3), colors::completed, 1e-9));
  double last = 0;
  for(double t = 0; t <= 1; t += 1. / 64) {
    const Color c = heat_color(t);
    const double luminance = 0.2126 * std::pow(c.red, 2.2) + 0.7152 * std::pow(c.green, 2.2)
                             + 0.0722 * std::pow(c.blue, 2.2);
    assert(luminance > last);
    last = luminance;
  }
  const Color unknown = heat_color(std::numeric_limits<double>::quiet_NaN());
  assert(unknown.red == unknown.green && unknown.green == unknown.blue);

  Picture bar(120, 220);
  bar.color_bar(heat_color, 10, 10, 20, 200, "0", "1");
  assert(is_close(bar.pixel(20, 10), heat_color(1)));
  assert(is_close(bar.pixel(20, 209), heat_color(0)));
}

void broken_elements_are_left_out()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = 1e300;
  const Camera camera = front_camera(2);
  Triangle_mesh mesh;
  mesh.vertices = {{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {huge, huge, 0}};
  mesh.faces = {{0, 1, 2}, {1, 1, 2}, {1, 2, 3}};
  Picture picture(50, 50);
  picture.draw_mesh(mesh, camera);
  picture.draw_points(mesh.vertices, {}, camera);
  picture.draw_points(mesh.vertices, std::vector<Vec3>(4, Vec3(nan, 0, 1)), camera);
  picture.draw_points(mesh.vertices, std::vector<Vec3>(4, Vec3::UnitZ()), camera);
  picture.draw_points({}, {}, camera);
  Segment_graph graph;
  graph.vertices = mesh.vertices;
  graph.edges = {{0, 1}, {1, 1}, {1, 3}};
  picture.draw_segments(graph, camera);
  picture.pixel(0, 0);

  int refused = 0;
  const auto expect = [&](const auto& call) {
    try {
      call();
    } catch(const std::logic_error&) {
      ++refused;
    }
  };
  expect([] { Picture(0, 10); });
  expect([] { Picture(10, 40000); });
  expect([&] { picture.draw_points({Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero()}, camera); });
  expect([&] { picture.pixel(50, 0); });
  expect([] { Picture::side_by_side({}); });
  assert(refused == 5);
}

/// Big-endian number of a PNG file's header.
std::size_t number_at(const std::string& bytes, std::size_t offset)
{
  std::size_t value = 0;
  for(std::size_t i = 0; i < 4; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes[offset + i]);
  return value;
}

void files_hold_the_picture()
{
  const std::string file = "support_picture_test.png";
  Picture a(60, 40), b(30, 50);
  a.fill_rectangle(0, 0, 60, 40, red);
  b.fill_rectangle(0, 0, 30, 50, green);
  const Picture both = Picture::side_by_side({a, b}, 0, 10);
  assert(both.width() == 100 && both.height() == 50);
  assert(is_close(both.pixel(30, 25), red) && is_close(both.pixel(85, 25), green));
  assert(is_close(both.pixel(65, 25), colors::white) && is_close(both.pixel(30, 2), colors::white));
  both.write_png(file);
  const std::string bytes = read_file(file);
  assert(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  assert(number_at(bytes, 16) == 100 && number_at(bytes, 20) == 50);
  assert(bytes.substr(bytes.size() - 8, 4) == "IEND");
  std::filesystem::remove(file);

  bool refused = false;
  try {
    both.write_png("no_such_folder/picture.png");
  } catch(const File_error& error) {
    refused = std::string(error.what()).find("no_such_folder/picture.png") != std::string::npos;
  }
  assert(refused);
}

void figures_are_complete()
{
  const std::string file = "support_picture_test_panels.png";
  std::vector<Panel> panels(3);
  panels[0].title = "Points";
  panels[0].cloud.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  panels[0].cloud.confidence = {1, 0.5, 0};
  panels[1].title = "A surface with a rather long title that needs some room";
  panels[1].mesh = sphere(Vec3::Zero(), 1, 10);
  panels[2].graph.vertices = {{0, 0, 0}, {1, 1, 1}};
  panels[2].graph.edges = {{0, 1}};
  write_panels(file, panels, Vec3(0, 0, -1), Vec3::UnitY(), 200);
  const std::string once = read_file(file);
  assert(number_at(once, 20) > 200);
  // The same calls give the same file.
  write_panels(file, panels, Vec3(0, 0, -1), Vec3::UnitY(), 200);
  assert(read_file(file) == once);
  std::filesystem::remove(file);
}

}  // namespace

int main()
{
  silhouettes_have_their_area();
  nearer_things_hide_others();
  back_faces_and_colors();
  cameras_see_everything();
  labels_leave_ink();
  color_maps_order_values();
  broken_elements_are_left_out();
  files_hold_the_picture();
  figures_are_complete();
  std::cout << "pictures: all facts hold" << std::endl;
  return EXIT_SUCCESS;
}
