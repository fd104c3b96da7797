// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_bytes.h"
#include "off_file.h"
#include "ply_file.h"
#include "point_file.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>

namespace support {

namespace {

using Polygon = std::vector<std::size_t>;

/// A fan of triangles, which is right for the convex faces that files hold in practice.
void append_fan(Triangle_mesh& mesh, const Polygon& polygon)
{
  for(std::size_t i = 2; i < polygon.size(); ++i)
    mesh.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

Triangle_mesh read_off_mesh(const std::string& file)
{
  Off_file off = read_off(file);
  Triangle_mesh mesh;
  mesh.vertices = std::move(off.vertices);
  for(const Polygon& face : off.faces)
    append_fan(mesh, face);
  return mesh;
}

Triangle_mesh read_ply_mesh(const std::string& file)
{
  const Ply_file ply = read_ply(file);
  Triangle_mesh mesh;
  mesh.vertices = read_vectors(vertex_element(file, ply), position_names);
  const Ply_element* face = ply.find("face");
  const Ply_property* corners = face ? face->find_list("vertex_indices") : nullptr;
  if(face && !corners)
    corners = face->find_list("vertex_index");
  if(!corners)
    file_error(file, "has no PLY element 'face' with a list of vertices");

  const double size = static_cast<double>(mesh.vertices.size());
  std::size_t begin = 0;
  for(const std::size_t end : corners->list_ends) {
    Polygon polygon;
    for(std::size_t i = begin; i < end; ++i) {
      if(!(corners->values[i] >= 0 && corners->values[i] < size))
        file_error(file, "has a face with a vertex that does not exist");
      polygon.push_back(static_cast<std::size_t>(corners->values[i]));
    }
    append_fan(mesh, polygon);
    begin = end;
  }
  return mesh;
}

/// The lines `v x y z` and `f a b c`, where a corner may be `a/texture/normal` and negative numbers
/// count from the last vertex.
Triangle_mesh read_obj_mesh(const std::string& file)
{
  const std::string bytes = read_file(file);
  Triangle_mesh mesh;
  for(Text_scanner scanner(bytes); scanner.next_line();) {
    const auto expected = [&](const char* what) {
      file_error(file, "line " + std::to_string(scanner.line_number()) + ": expected " + what);
    };
    const std::string_view keyword = scanner.word();
    if(keyword == "v") {
      Vec3 v;
      for(int i = 0; i < 3; ++i)
        if(!scanner.number(v[i]))
          expected("the coordinates of a vertex");
      mesh.vertices.push_back(v);
    } else if(keyword == "f") {
      Polygon polygon;
      while(!scanner.at_end_of_line()) {
        const std::string_view corner = scanner.word();
        Text_scanner corner_scanner(corner.substr(0, corner.find('/')));
        const double count = static_cast<double>(mesh.vertices.size());
        double index = 0;
        if(!corner_scanner.next_line() || !corner_scanner.number(index)
           || index != std::floor(index))
          expected("the vertices of a face");
        index += index < 0 ? count : -1;
        if(!(index >= 0 && index < count))
          expected("vertices that exist");
        polygon.push_back(static_cast<std::size_t>(index));
      }
      append_fan(mesh, polygon);
    }
  }
  return mesh;
}

constexpr std::size_t stl_header_size = 80;  // then a 4-byte count
constexpr std::size_t stl_facet_size = 50;   // normal, three vertices, two bytes of attributes

/// STL knows no vertices but only triangles: corners at the same place become one vertex.
class Stl_vertices {
public:
  explicit Stl_vertices(Triangle_mesh& mesh) : m_mesh(mesh) {}

  void append_corner(const Vec3& v)
  {
    const auto [place, is_new] = m_index.insert({{v[0], v[1], v[2]}, m_mesh.vertices.size()});
    if(is_new)
      m_mesh.vertices.push_back(v);
    m_corners.push_back(place->second);
    if(m_corners.size() == 3) {
      append_fan(m_mesh, m_corners);
      m_corners.clear();
    }
  }
  bool has_open_triangle() const { return !m_corners.empty(); }

private:
  Triangle_mesh& m_mesh;
  std::map<std::array<double, 3>, std::size_t> m_index;
  Polygon m_corners;
};

float stl_float(const std::string& bytes, std::size_t offset)
{
  std::uint32_t bits = 0;
  for(std::size_t i = 0; i < 4; ++i)
    bits |= std::uint32_t(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}

std::uint32_t stl_count(const std::string& bytes)
{
  std::uint32_t count = 0;
  for(std::size_t i = 0; i < 4; ++i)
    count |= std::uint32_t(static_cast<unsigned char>(bytes[stl_header_size + i])) << (8 * i);
  return count;
}

void read_binary_stl(const std::string& file, const std::string& bytes, Stl_vertices& vertices)
{
  const std::size_t available = bytes.size() < stl_header_size + 4
                                    ? 0
                                    : (bytes.size() - stl_header_size - 4) / stl_facet_size;
  if(available == 0)
    file_error(file, "is not an STL file");
  const std::size_t count = stl_count(bytes);
  if(count != available)
    file_error(file, "the STL header says " + std::to_string(count) + " triangles, the file holds "
                         + std::to_string(available));
  for(std::size_t i = 0; i < count; ++i)
    for(std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t offset
          = stl_header_size + 4 + i * stl_facet_size + 12 * (corner + 1);  // after the normal
      const Vec3 v(stl_float(bytes, offset), stl_float(bytes, offset + 4),
                   stl_float(bytes, offset + 8));
      if(!v.allFinite())  // would not be found again among the vertices
        file_error(file, "triangle " + std::to_string(i) + " has coordinates that are not finite");
      vertices.append_corner(v);
    }
}

void read_text_stl(const std::string& file, const std::string& bytes, Stl_vertices& vertices)
{
  bool has_end = false;
  for(Text_scanner scanner(bytes); scanner.next_line();) {
    const std::string_view keyword = scanner.word();
    has_end = has_end || keyword == "endsolid";
    if(keyword != "vertex")
      continue;
    Vec3 v;
    for(int i = 0; i < 3; ++i)
      if(!scanner.number(v[i]) || !std::isfinite(v[i]))
        file_error(file, "line " + std::to_string(scanner.line_number())
                             + ": expected the coordinates of a vertex");
    vertices.append_corner(v);
  }
  if(!has_end || vertices.has_open_triangle())
    file_error(file, "is truncated: there is no 'endsolid'");
}

/// Binary files may begin with "solid" as well; what follows tells.
Triangle_mesh read_stl_mesh(const std::string& file)
{
  const std::string bytes = read_file(file);
  Triangle_mesh mesh;
  Stl_vertices vertices(mesh);
  const bool is_text
      = bytes.compare(0, 5, "solid") == 0 && bytes.substr(0, 1024).find('\0') == std::string::npos;
  if(is_text)
    read_text_stl(file, bytes, vertices);
  else
    read_binary_stl(file, bytes, vertices);
  return mesh;
}

// ---- writing ----

void append_line(std::string& text, const char* begin, const Vec3& v)
{
  text += begin;
  for(int i = 0; i < 3; ++i) {
    append_number(text, v[i]);
    text += i < 2 ? ' ' : '\n';
  }
}

void append_face(std::string& text, const char* begin, const std::array<std::size_t, 3>& face,
                 std::size_t first_index)
{
  text += begin;
  for(const std::size_t vertex : face)
    text += ' ' + std::to_string(vertex + first_index);
  text += '\n';
}

void write_off_mesh(const std::string& file, const Triangle_mesh& mesh)
{
  std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + ' '
                     + std::to_string(mesh.faces.size()) + " 0\n";
  for(const Vec3& v : mesh.vertices)
    append_line(text, "", v);
  for(const auto& face : mesh.faces)
    append_face(text, "3", face, 0);
  write_file(file, text);
}

void write_obj_mesh(const std::string& file, const Triangle_mesh& mesh)
{
  std::string text;
  for(const Vec3& v : mesh.vertices)
    append_line(text, "v ", v);
  for(const auto& face : mesh.faces)
    append_face(text, "f", face, 1);
  write_file(file, text);
}

void write_ply_mesh(const std::string& file, const Triangle_mesh& mesh)
{
  Ply_element vertex{"vertex", mesh.vertices.size(), {}};
  append_vectors(vertex, position_names, Ply_type::float64, mesh.vertices);
  Ply_property corners{"vertex_indices", Ply_type::int32};
  corners.is_list = true;
  for(const auto& face : mesh.faces) {
    for(const std::size_t corner : face)
      corners.values.push_back(static_cast<double>(corner));
    corners.list_ends.push_back(corners.values.size());
  }
  write_ply(file, {{std::move(vertex), {"face", mesh.faces.size(), {std::move(corners)}}}});
}

void append_bytes(std::string& bytes, std::uint32_t bits)
{
  for(int i = 0; i < 4; ++i)
    bytes += static_cast<char>((bits >> (8 * i)) & 0xFF);
}

void append_bytes(std::string& bytes, const Vec3& v)
{
  for(int i = 0; i < 3; ++i) {
    const float value = static_cast<float>(v[i]);
    std::uint32_t bits;
    std::memcpy(&bits, &value, 4);
    append_bytes(bytes, bits);
  }
}

void write_stl_mesh(const std::string& file, const Triangle_mesh& mesh)
{
  std::string bytes(stl_header_size, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for(const auto& [a, b, c] : mesh.faces) {
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    append_bytes(bytes, (q - p).cross(r - p).normalized());
    append_bytes(bytes, p);
    append_bytes(bytes, q);
    append_bytes(bytes, r);
    bytes.append(2, '\0');
  }
  write_file(file, bytes);
}

}  // namespace

Triangle_mesh read_mesh(const std::string& file)
{
  check_extension(file, {".off", ".ply", ".obj", ".stl"});
  const std::string kind = extension(file);
  Triangle_mesh mesh = kind == ".off"   ? read_off_mesh(file)
                       : kind == ".ply" ? read_ply_mesh(file)
                       : kind == ".obj" ? read_obj_mesh(file)
                                        : read_stl_mesh(file);
  if(mesh.faces.empty())
    file_error(file, "holds no faces");
  check_finite(file, mesh.vertices);
  return mesh;
}

void check_mesh_output(const std::string& file)
{
  check_output(file, {".off", ".ply", ".obj", ".stl"});
}

void write_mesh(const std::string& file, const Triangle_mesh& mesh)
{
  check_mesh_output(file);
  const std::string kind = extension(file);
  if(kind == ".off")
    write_off_mesh(file, mesh);
  else if(kind == ".ply")
    write_ply_mesh(file, mesh);
  else if(kind == ".obj")
    write_obj_mesh(file, mesh);
  else
    write_stl_mesh(file, mesh);
}

// ---- graphs: vertices with edges ----

Segment_graph read_segment_graph(const std::string& file)
{
  check_extension(file, {".ply"});
  const Ply_file ply = read_ply(file);
  const Ply_element& vertex = vertex_element(file, ply);
  Segment_graph graph;
  graph.vertices = read_vectors(vertex, position_names);
  check_finite(file, graph.vertices);
  if(const Ply_property* radius = vertex.find_number("radius"))
    graph.radius = radius->values;

  const Ply_element* edge = ply.find("edge");
  if(!edge)
    file_error(file, "has no PLY element 'edge'");
  const Ply_property* first = edge->find_number("vertex1");
  const Ply_property* second = edge->find_number("vertex2");
  if(!first || !second)
    file_error(file, "the PLY element 'edge' lacks vertex1 or vertex2");
  const double size = static_cast<double>(vertex.count);
  for(std::size_t i = 0; i < edge->count; ++i) {
    const double a = first->values[i], b = second->values[i];
    if(!(a >= 0 && a < size && b >= 0 && b < size))
      file_error(file, "edge " + std::to_string(i) + " has a vertex that does not exist");
    graph.edges.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b)});
  }
  return graph;
}

void write_segment_graph(const std::string& file, const Segment_graph& graph)
{
  check_extension(file, {".ply"});
  Ply_element vertex{"vertex", graph.vertices.size(), {}};
  append_vectors(vertex, position_names, Ply_type::float64, graph.vertices);
  if(!graph.radius.empty())
    vertex.properties.push_back({"radius", Ply_type::float64, graph.radius});
  Ply_property first{"vertex1", Ply_type::int32};
  Ply_property second{"vertex2", Ply_type::int32};
  for(const auto& [a, b] : graph.edges) {
    first.values.push_back(static_cast<double>(a));
    second.values.push_back(static_cast<double>(b));
  }
  Ply_element edge{"edge", graph.edges.size(), {first, second}};
  write_ply(file, {{std::move(vertex), std::move(edge)}});
}

}  // namespace support
