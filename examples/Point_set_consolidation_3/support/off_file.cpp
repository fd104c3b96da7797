// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "off_file.h"

#include "file_bytes.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace support {

namespace {

struct Header {
  bool has_normals = false;
  bool has_colours = false;
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

[[noreturn]] void line_error(const std::string& file, const Text_scanner& scanner,
                             const std::string& expected)
{
  file_error(file, "line " + std::to_string(scanner.line_number()) + ": expected " + expected);
}

/// "OFF" after any of the prefixes ST, C, N, 4, n; some programs write NOFF_SK.
Header read_signature(const std::string& file, std::string_view word)
{
  const std::size_t off = word.find("OFF");
  const std::string_view prefix = word.substr(0, (std::min)(off, word.size()));
  if(off == std::string_view::npos || prefix.find_first_not_of("STCN") != std::string_view::npos)
    file_error(file, "is not an OFF file: it does not begin with 'OFF'");
  Header header;
  header.has_colours = prefix.find('C') != std::string_view::npos;
  header.has_normals = prefix.find('N') != std::string_view::npos;
  return header;
}

std::size_t read_count(const std::string& file, Text_scanner& scanner, const char* what)
{
  double count = 0;
  if(!scanner.number(count) || !(count >= 0 && count < 1e15) || count != std::floor(count))
    line_error(file, scanner, what);
  return static_cast<std::size_t>(count);
}

/// The counts are on the line of the signature or on the next; only the first one is needed.
Header read_header(const std::string& file, Text_scanner& scanner)
{
  if(!scanner.next_line())
    file_error(file, "is not an OFF file: it does not begin with 'OFF'");
  Header header = read_signature(file, scanner.word());
  if(scanner.line().find("BINARY") != std::string_view::npos)
    file_error(file, "is a binary OFF file, which is not read (text only)");
  if(scanner.at_end_of_line() && !scanner.next_line())
    file_error(file, "is truncated: there is nothing after 'OFF'");
  header.vertices = read_count(file, scanner, "the number of vertices");
  if(!scanner.at_end_of_line())
    header.faces = read_count(file, scanner, "the number of faces");
  return header;
}

Vec3 read_vector(const std::string& file, Text_scanner& scanner, const char* what)
{
  Vec3 v;
  for(int i = 0; i < 3; ++i)
    if(!scanner.number(v[i]))
      line_error(file, scanner, what);
  return v;
}

[[noreturn]] void truncated(const std::string& file, std::size_t said, const char* what,
                            std::size_t found)
{
  file_error(file, "is truncated: the header says " + std::to_string(said) + " " + what
                       + ", the file holds " + std::to_string(found));
}

}  // namespace

bool are_colours(const std::vector<Vec3>& normals)
{
  bool has_large = false;
  for(const Vec3& n : normals)
    for(int i = 0; i < 3; ++i) {
      if(!(n[i] >= 0 && n[i] <= 255) || n[i] != std::floor(n[i]))
        return false;
      has_large = has_large || n[i] > 1;
    }
  return has_large;
}

Off_file read_off(const std::string& file)
{
  const std::string bytes = read_file(file);
  Text_scanner scanner(bytes);
  const Header header = read_header(file, scanner);

  // Every vertex takes at least the 6 characters of "0 0 0\n", every face 4, but for the last one.
  Off_file off;
  off.vertices.reserve((std::min)(header.vertices, bytes.size() / 6 + 1));
  off.faces.reserve((std::min)(header.faces, bytes.size() / 4 + 1));

  bool has_normals = false;
  for(std::size_t i = 0; i < header.vertices; ++i) {
    if(!scanner.next_line())
      truncated(file, header.vertices, "vertices", i);
    off.vertices.push_back(read_vector(file, scanner, "the coordinates of a vertex"));
    Vec3 normal = Vec3::Zero();
    // What follows the position is a normal unless the header says that it is a colour.
    if(!scanner.at_end_of_line() && (header.has_normals || !header.has_colours)) {
      normal = read_vector(file, scanner, "a normal after the coordinates");
      has_normals = true;
    }
    off.normals.push_back(normal);
  }
  if(!has_normals || (!header.has_normals && are_colours(off.normals)))
    off.normals.clear();

  for(std::size_t i = 0; i < header.faces; ++i) {
    if(!scanner.next_line())
      truncated(file, header.faces, "faces", i);
    const std::size_t size = read_count(file, scanner, "the number of a face's vertices");
    if(size > header.vertices)
      line_error(file, scanner, "a face with no more vertices than there are");
    std::vector<std::size_t> face(size);
    for(std::size_t& vertex : face) {
      vertex = read_count(file, scanner, "the vertices of a face");
      if(vertex >= header.vertices)
        line_error(file, scanner, "vertices below " + std::to_string(header.vertices));
    }
    off.faces.push_back(std::move(face));
  }
  // Lines after the last face may be edges, which no header describes well.
  if(header.faces == 0 && scanner.next_line())
    file_error(file, "holds more vertices than the " + std::to_string(header.vertices)
                         + " that its header says");
  return off;
}

}  // namespace support
