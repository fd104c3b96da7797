// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_IO_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_IO_H

#include <CGAL/Point_set_consolidation_3/internal/skeleton_graph.h>

#include <cstring>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Files of curve skeletons. PLY: vertices `x y z radius`, `element edge` with `vertex1 vertex2`; written in ASCII,
/// read in ASCII and binary, with any further elements and properties.

inline void write_skeleton_ply(std::ostream& out, const Skeleton_graph& graph)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\nelement vertex " << graph.nodes.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty double radius\n"
      << "element edge " << graph.edges.size()
      << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for(const Skeleton_node& node : graph.nodes)
    out << node.position.x() << ' ' << node.position.y() << ' ' << node.position.z() << ' '
        << node.radius << '\n';
  for(const Skeleton_edge& e : graph.edges)
    out << e[0] << ' ' << e[1] << '\n';
}

/// CGAL's text format: a line per polyline, the number of points, then their coordinates. An isolated node is a
/// polyline of one point.
inline void write_skeleton_polylines(std::ostream& out, const Skeleton_graph& graph)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  std::vector<std::vector<std::size_t> > chains = polylines_of(graph);
  const std::vector<std::vector<std::size_t> > neighbors = adjacency(graph);
  for(std::size_t i = 0; i < neighbors.size(); ++i)
    if(neighbors[i].empty())
      chains.push_back({i});
  for(const std::vector<std::size_t>& chain : chains) {
    out << chain.size();
    for(const std::size_t i : chain) {
      const Vec3& p = graph.nodes[i].position;
      out << ' ' << p.x() << ' ' << p.y() << ' ' << p.z();
    }
    out << '\n';
  }
}

struct Ply_property {
  std::string name;
  std::string type;
  std::string count_type;  ///< empty: not a list
};

struct Ply_element {
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  bool has_number(const std::string& property) const
  {
    return std::any_of(properties.begin(), properties.end(), [&](const Ply_property& p) {
      return p.name == property && p.count_type.empty();
    });
  }
};

class Ply_skeleton_reader {
public:
  explicit Ply_skeleton_reader(std::istream& in) : m_in(in) {}

  Skeleton_graph read()
  {
    read_header();
    Skeleton_graph graph;
    std::vector<Skeleton_edge> edges;
    for(const Ply_element& element : m_elements) {
      if(element.name == "vertex")
        for(const char* const coordinate : {"x", "y", "z"})
          if(!element.has_number(coordinate))
            fail(std::string("the vertices have no property ") + coordinate);
      if(element.properties.empty())
        continue;  // whatever its count says, it takes no place in the file
      for(std::size_t i = 0; i < element.count; ++i) {
        if(element.name == "vertex")
          graph.nodes.push_back(read_node(element, i));
        else if(element.name == "edge")
          edges.push_back(read_edge(element, i));
        else
          for(const Ply_property& p : element.properties)
            read_property(p);
      }
    }
    for(const Skeleton_edge& e : edges) {
      if(e[0] >= graph.nodes.size() || e[1] >= graph.nodes.size())
        fail("an edge refers to a vertex that does not exist");
      if(e[0] != e[1])
        graph.edges.push_back({(std::min)(e[0], e[1]), (std::max)(e[0], e[1])});
    }
    std::sort(graph.edges.begin(), graph.edges.end());
    graph.edges.erase(std::unique(graph.edges.begin(), graph.edges.end()), graph.edges.end());
    return graph;
  }

private:
  enum class Format { ascii, little_endian, big_endian };
  static constexpr double max_count = 4294967295.;  // indices of PLY files have 32 bits

  [[noreturn]] static void fail(const std::string& what)
  {
    throw std::runtime_error("PLY skeleton: " + what);
  }

  void read_header()
  {
    std::string line;
    const auto next_line = [&] {
      if(!std::getline(m_in, line))
        fail("the header is incomplete");
      if(!line.empty() && line.back() == '\r')
        line.pop_back();
    };
    next_line();
    if(line != "ply")
      fail("not a PLY file");
    for(next_line(); line != "end_header"; next_line()) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if(keyword == "format") {
        std::string format;
        words >> format;
        if(format == "ascii") m_format = Format::ascii;
        else if(format == "binary_little_endian") m_format = Format::little_endian;
        else if(format == "binary_big_endian") m_format = Format::big_endian;
        else fail("unknown format '" + format + "'");
      }
      else if(keyword == "element") {
        Ply_element element;
        if(!(words >> element.name >> element.count) || double(element.count) > max_count)
          fail("bad element line '" + line + "'");
        m_elements.push_back(element);
      }
      else if(keyword == "property") {
        Ply_property property;
        words >> property.type;
        if(property.type == "list")
          words >> property.count_type >> property.type;
        if(!(words >> property.name) || m_elements.empty())
          fail("bad property line '" + line + "'");
        m_elements.back().properties.push_back(property);
      }
    }
  }

  Skeleton_node read_node(const Ply_element& element, std::size_t i)
  {
    Skeleton_node node;
    for(const Ply_property& p : element.properties) {
      const double value = read_property(p);
      if(p.name == "x") node.position.x() = value;
      if(p.name == "y") node.position.y() = value;
      if(p.name == "z") node.position.z() = value;
      if(p.name == "radius") node.radius = value;
    }
    if(!node.position.allFinite() || !std::isfinite(node.radius))
      fail("vertex " + std::to_string(i) + " is not finite");
    if(node.radius < 0)
      fail("vertex " + std::to_string(i) + " has a negative radius");
    return node;
  }

  Skeleton_edge read_edge(const Ply_element& element, std::size_t i)
  {
    double ends[2] = {-1, -1};
    for(const Ply_property& p : element.properties) {
      const double value = read_property(p);
      if(p.name == "vertex1") ends[0] = value;
      if(p.name == "vertex2") ends[1] = value;
    }
    for(const double end : ends)
      if(!(end >= 0 && end < max_count))
        fail("edge " + std::to_string(i) + " has no valid vertex1 and vertex2");
    return {std::size_t(ends[0]), std::size_t(ends[1])};
  }

  /// The value of a property; 0 for a list, which is passed over.
  double read_property(const Ply_property& property)
  {
    if(property.count_type.empty())
      return read_value(property.type);
    const double count = read_value(property.count_type);
    if(!(count >= 0 && count < max_count))
      fail("bad length of a list");
    for(std::size_t i = 0; i < std::size_t(count); ++i)
      read_value(property.type);
    return 0;
  }

  double read_value(const std::string& type)
  {
    if(m_format == Format::ascii) {
      double value = 0;
      if(!(m_in >> value))
        fail("the file ends early, or a number cannot be read");
      return value;
    }
    if(type == "char" || type == "int8") return read_binary<std::int8_t>();
    if(type == "uchar" || type == "uint8") return read_binary<std::uint8_t>();
    if(type == "short" || type == "int16") return read_binary<std::int16_t>();
    if(type == "ushort" || type == "uint16") return read_binary<std::uint16_t>();
    if(type == "int" || type == "int32") return read_binary<std::int32_t>();
    if(type == "uint" || type == "uint32") return read_binary<std::uint32_t>();
    if(type == "float" || type == "float32") return double(read_binary<float>());
    if(type == "double" || type == "float64") return read_binary<double>();
    fail("unknown type '" + type + "'");
  }

  template <typename T>
  T read_binary()
  {
    char bytes[sizeof(T)];
    if(!m_in.read(bytes, sizeof(T)))
      fail("the file ends early");
    const std::uint16_t one = 1;
    const bool little_endian_machine = *reinterpret_cast<const unsigned char*>(&one) == 1;
    if(little_endian_machine != (m_format == Format::little_endian))
      std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  std::istream& m_in;
  Format m_format = Format::ascii;
  std::vector<Ply_element> m_elements;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_SKELETON_IO_H
