// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_file.h"

#include "file_bytes.h"
#include "off_file.h"
#include "ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace support {

namespace {

// ---- what all formats have in common ----

constexpr Vector_names normal_names{"nx", "ny", "nz"};
constexpr Vector_names direction_names{"vx", "vy", "vz"};

/// Zero vectors for those that say nothing, no vectors at all if none says anything.
void forget_unusable(std::vector<Vec3>& vectors)
{
  bool has_any = false;
  for(Vec3& v : vectors) {
    if(!v.allFinite())
      v.setZero();
    has_any = has_any || !v.isZero(0);
  }
  if(!has_any)
    vectors.clear();
}

/// A file with the wrong extension would be misread or give a puzzling message.
void check_content(const std::string& file, std::string_view bytes, std::string_view expected)
{
  const std::pair<const char*, const char*> signatures[]
      = {{"ply", "PLY"}, {"LASF", "LAS"}, {"OFF", "OFF"}, {"NOFF", "OFF"}, {"COFF", "OFF"}};
  for(const auto& [signature, name] : signatures)
    if(bytes.substr(0, std::strlen(signature)) == signature && expected != name)
      file_error(file, std::string("holds ") + name + " data, which its extension denies");
  if(expected != "LAS" && expected != "PLY"
     && bytes.substr(0, 4096).find('\0') != std::string_view::npos)
    file_error(file, "holds binary data where text is expected");
}

// ---- x y z [nx ny nz] ----

[[noreturn]] void wrong_number(const std::string& file, double announced, std::size_t found)
{
  std::string message = "the first line says ";
  append_number(message, announced);
  file_error(file, message + " points, the file holds " + std::to_string(found));
}

Point_cloud read_xyz(const std::string& file)
{
  const std::string bytes = read_file(file);
  check_content(file, bytes, "text");

  Point_cloud cloud;
  double announced = -1;  // number of points in the first line, if there is one
  bool is_first_line = true;
  bool has_normals = false;
  for(Text_scanner scanner(bytes); scanner.next_line(); is_first_line = false) {
    const auto expected = [&](const char* what) {
      file_error(file, "line " + std::to_string(scanner.line_number()) + ": expected " + what);
    };
    std::array<double, 6> numbers{};
    std::size_t n = 0;
    while(n < numbers.size() && scanner.number(numbers[n]))
      ++n;
    if(n < numbers.size() && !scanner.at_end_of_line())
      expected("numbers");
    if(n == 1 && is_first_line && numbers[0] >= 0 && numbers[0] == std::floor(numbers[0])) {
      announced = numbers[0];
      continue;
    }
    if(n < 3)
      expected("the three coordinates of a point");
    if(n == 4 || n == 5)
      expected("three coordinates, or three coordinates and a normal");
    cloud.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    cloud.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
    has_normals = has_normals || n == 6;
  }
  if(announced >= 0 && announced != static_cast<double>(cloud.size()))
    wrong_number(file, announced, cloud.size());
  if(!has_normals || are_colours(cloud.normals))
    cloud.normals.clear();
  return cloud;
}

void write_xyz(const std::string& file, const Point_cloud& cloud, std::string text = {})
{
  const auto append_vector = [&text](const Vec3& v) {
    for(int i = 0; i < 3; ++i) {
      append_number(text, v[i]);
      text += ' ';
    }
  };
  for(std::size_t i = 0; i < cloud.size(); ++i) {
    append_vector(cloud.points[i]);
    if(!cloud.normals.empty())
      append_vector(cloud.normals[i]);
    text.back() = '\n';
  }
  write_file(file, text);
}

// ---- OFF ----

Point_cloud read_off_points(const std::string& file)
{
  Off_file off = read_off(file);
  Point_cloud cloud;
  cloud.points = std::move(off.vertices);
  cloud.normals = std::move(off.normals);
  return cloud;
}

void write_off_points(const std::string& file, const Point_cloud& cloud)
{
  write_xyz(file, cloud,
            (cloud.normals.empty() ? "OFF\n" : "NOFF\n") + std::to_string(cloud.size()) + " 0 0\n");
}

// ---- PLY ----

Point_cloud read_ply_points(const std::string& file)
{
  const Ply_file ply = read_ply(file);
  const Ply_element& vertex = vertex_element(file, ply);

  Point_cloud cloud;
  cloud.points = read_vectors(vertex, position_names);
  if(has_vectors(vertex, normal_names))
    cloud.normals = read_vectors(vertex, normal_names);
  if(has_vectors(vertex, direction_names)) {
    cloud.directions = read_vectors(vertex, direction_names);
    for(Vec3& v : cloud.directions)
      v.normalize();  // leaves a zero vector as it is
  }
  const Ply_property* view = vertex.find_number("view");
  if(view && view->type != Ply_type::float32 && view->type != Ply_type::float64)
    for(const double index : view->values) {
      if(!(index >= 0 && index <= 1e9))
        file_error(file, "the PLY property 'view' holds an index that is negative or too large");
      cloud.views.push_back(static_cast<int>(index));
    }
  if(const Ply_property* confidence = vertex.find_number("confidence"))
    cloud.confidence = confidence->values;
  return cloud;
}

void write_ply_points(const std::string& file, const Point_cloud& cloud)
{
  Ply_element vertex{"vertex", cloud.size(), {}};
  append_vectors(vertex, position_names, Ply_type::float64, cloud.points);
  if(!cloud.normals.empty())
    append_vectors(vertex, normal_names, Ply_type::float32, cloud.normals);
  if(!cloud.confidence.empty())
    vertex.properties.push_back({"confidence", Ply_type::float32, cloud.confidence});
  if(!cloud.directions.empty())
    append_vectors(vertex, direction_names, Ply_type::float32, cloud.directions);
  if(!cloud.views.empty())
    vertex.properties.push_back(
        {"view", Ply_type::int32, std::vector<double>(cloud.views.begin(), cloud.views.end())});
  write_ply(file, {{std::move(vertex)}});
}

// ---- LAS ----

// Offsets in the public header block of the LAS specification, versions 1.0 to 1.4.
constexpr std::size_t las_minor_version = 25;
constexpr std::size_t las_offset_to_points = 96;
constexpr std::size_t las_point_format = 104;
constexpr std::size_t las_record_length = 105;
constexpr std::size_t las_number_of_points = 107;
constexpr std::size_t las_scale = 131;
constexpr std::size_t las_offset = 155;
constexpr std::size_t las_header_size = 227;
constexpr std::size_t las_number_of_points_1_4 = 247;
constexpr std::size_t las_header_size_1_4 = 375;

/// Numbers are stored lowest byte first.
template <typename T>
T las_number(std::string_view bytes, std::size_t offset)
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < sizeof(T); ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
  if constexpr(sizeof(T) == 8) {
    T value;
    std::memcpy(&value, &bits, 8);
    return value;
  } else {
    return static_cast<T>(bits);
  }
}

Point_cloud read_las(const std::string& file)
{
  const std::string bytes = read_file(file);
  if(bytes.compare(0, 4, "LASF") != 0)
    file_error(file, "is not a LAS file: it does not begin with 'LASF'");
  if(bytes.size() < las_header_size)
    file_error(file, "is truncated: the LAS header is not complete");
  if(las_number<std::uint8_t>(bytes, las_point_format) & 0xC0)
    file_error(file, "is a compressed LAS file, which is not read");

  std::uint64_t count = las_number<std::uint32_t>(bytes, las_number_of_points);
  if(count == 0 && las_number<std::uint8_t>(bytes, las_minor_version) >= 4
     && bytes.size() >= las_header_size_1_4)
    count = las_number<std::uint64_t>(bytes, las_number_of_points_1_4);
  const std::size_t begin = las_number<std::uint32_t>(bytes, las_offset_to_points);
  const std::size_t length = las_number<std::uint16_t>(bytes, las_record_length);
  if(length < 12 || begin < las_header_size)
    file_error(file, "has a LAS header that is not understood");
  const std::uint64_t available = begin > bytes.size() ? 0 : (bytes.size() - begin) / length;
  if(count > available)
    file_error(file, "is truncated: the header says " + std::to_string(count)
                         + " points, the file holds " + std::to_string(available));

  Point_cloud cloud;
  cloud.points.resize(count);
  for(std::size_t i = 0; i < count; ++i)
    for(std::size_t j = 0; j < 3; ++j) {
      const std::int32_t stored = las_number<std::int32_t>(bytes, begin + i * length + 4 * j);
      cloud.points[i][static_cast<Eigen::Index>(j)]
          = stored * las_number<double>(bytes, las_scale + 8 * j)
            + las_number<double>(bytes, las_offset + 8 * j);
    }
  return cloud;
}

}  // namespace

Point_cloud read_point_cloud(const std::string& file)
{
  check_extension(file, {".xyz", ".pwn", ".off", ".noff", ".ply", ".las"});
  const std::string kind = extension(file);
  Point_cloud cloud = kind == ".ply"                      ? read_ply_points(file)
                      : kind == ".las"                    ? read_las(file)
                      : kind == ".off" || kind == ".noff" ? read_off_points(file)
                                                          : read_xyz(file);
  if(cloud.points.empty())
    file_error(file, "holds no points");
  check_finite(file, cloud.points);
  forget_unusable(cloud.normals);
  forget_unusable(cloud.directions);
  return cloud;
}

void check_point_output(const std::string& file)
{
  check_output(file, {".ply", ".xyz", ".pwn", ".off", ".noff"});
}

void write_point_cloud(const std::string& file, const Point_cloud& cloud)
{
  check_point_output(file);
  const std::string kind = extension(file);
  if(kind == ".ply")
    write_ply_points(file, cloud);
  else if(kind == ".off" || kind == ".noff")
    write_off_points(file, cloud);
  else
    write_xyz(file, cloud);
}

}  // namespace support
