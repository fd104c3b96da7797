// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The programs' readers and options on arbitrary bytes. The first byte says which reader; the rest is the
// file, the words of a command line, each ended by a zero byte, or edits of a skeleton. A reader returns what is
// finite and consistent, or has its one kind of error with a message of one line.

#include "../../../examples/Point_set_consolidation_3/support/command_line.h"
#include "../../../examples/Point_set_consolidation_3/support/point_file.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

void require(bool holds)
{
  if(!holds)
    std::abort();
}

/// A file of this process that is removed at the end.
class Scratch_file {
public:
  explicit Scratch_file(const char* extension)
    : m_name("fuzz_" + std::to_string(::getpid()) + extension)
  {}
  ~Scratch_file() { ::unlink(m_name.c_str()); }
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;

  const std::string& name() const { return m_name; }
  void write(const std::string& bytes) const { std::ofstream(m_name, std::ios::binary) << bytes; }

private:
  std::string m_name;
};

void read_points(const std::string& name)
{
  const support::Point_cloud cloud = support::read_point_cloud(name);
  require(cloud.size() > 0);
  for(const support::Vec3& p : cloud.points)
    require(p.allFinite());
  require(cloud.normals.empty() || cloud.normals.size() == cloud.size());
  for(const support::Vec3& n : cloud.normals)
    require(n.allFinite());
}

void read_surface(const std::string& name)
{
  const support::Triangle_mesh mesh = support::read_mesh(name);
  require(!mesh.faces.empty());
  for(const auto& face : mesh.faces)
    for(const std::size_t v : face)
      require(v < mesh.vertices.size());
}

void read_graph(const std::string& name)
{
  const support::Segment_graph graph = support::read_segment_graph(name);
  for(const auto& edge : graph.edges)
    require(edge[0] < graph.vertices.size() && edge[1] < graph.vertices.size());
}

void require_sound(const Skeleton& skeleton)
{
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Kernel::Point_3& p = skeleton[v].point;
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    require(std::isfinite(skeleton[v].radius) && skeleton[v].radius >= 0);
  }
}

void read_skeleton(const std::string& bytes)
{
  Skeleton skeleton;
  std::string message;
  std::istringstream stream(bytes);
  if(CGAL::IO::read_curve_skeleton_PLY(stream, skeleton, &message)) {
    require_sound(skeleton);
    std::stringstream copy;
    Skeleton same;
    require(CGAL::IO::write_curve_skeleton_PLY(copy, skeleton));
    require(CGAL::IO::read_curve_skeleton_PLY(copy, same));
    require(num_vertices(same) == num_vertices(skeleton) && num_edges(same) == num_edges(skeleton));
  }
  else
    require(!message.empty() && message.find('\n') == std::string::npos && num_vertices(skeleton) == 0);
}

/// Of a ring with two tips and an isolated vertex.
void edit_skeleton(const std::string& bytes)
{
  Skeleton skeleton;
  for(int i = 0; i < 9; ++i)
    CGAL::Curve_skeleton_editing::add_vertex<Kernel>(skeleton, Kernel::Point_3(i, i % 3, i % 2), 0.5);
  const std::size_t edges[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {1, 4}, {4, 5}, {6, 7}};
  for(const auto& edge : edges)
    add_edge(edge[0], edge[1], skeleton);
  std::istringstream text(bytes);
  try {
    CGAL::Curve_skeleton_editing::apply_edits(skeleton, text);
  }
  catch(const std::invalid_argument& error) {
    require(std::string(error.what()).compare(0, 5, "line ") == 0);
    require(num_vertices(skeleton) == 9 && num_edges(skeleton) == 7);
  }
  require_sound(skeleton);
}

/// Options of all kinds that the programs have.
void parse_options(const std::string& bytes)
{
  std::vector<std::string> words(1);
  for(const char byte : bytes)
    if(byte == 0)
      words.emplace_back();
    else
      words.back() += byte;
  std::string input, output, method = "one";
  double angle = 45;
  std::size_t threads = 0;
  std::optional<std::size_t> particles;
  std::vector<support::Vec3> scanners;
  bool quiet = false;
  support::Command_line line("fuzz", "Parses.");
  line.positional("INPUT", input, "a file");
  line.option("-o,--output", "FILE", output, "a file");
  line.option("--method", "NAME", method, "one of two").one_of({"one", "two"});
  line.option("--omega", "DEG", angle, "an angle").between(1, 170);
  line.option("--threads", "N", threads, "a number");
  line.option("--particles", "N", particles, "a number").at_least(1);
  line.option("--scanner", "X Y Z", scanners, "places");
  line.flag("-q,--quiet", quiet, "a flag");
  std::vector<const char*> arguments = {"fuzz"};
  for(const std::string& word : words)
    if(word.compare(0, 2, "-h") != 0 && word.compare(0, 3, "--h") != 0 && word.compare(0, 3, "--v") != 0)
      arguments.push_back(word.c_str());  // those print
  try {
    if(!line.parse(int(arguments.size()), arguments.data()))
      return;
  }
  catch(const support::Usage_error& error) {
    require(*error.what() != 0);
    return;
  }
  require(angle >= 1 && angle <= 170 && (method == "one" || method == "two"));
  require(!particles || *particles >= 1);
  for(const support::Vec3& s : scanners)
    require(s.allFinite());
}

/// A reader of files of the programs.
template <void (*read)(const std::string& name)>
void read_file_of(const char* extension, const std::string& bytes)
{
  const Scratch_file file(extension);
  file.write(bytes);
  try {
    read(file.name());
  }
  catch(const support::File_error& error) {
    const std::string message = error.what();
    require(message.compare(0, 5, "fuzz_") == 0 && message.find('\n') == std::string::npos);
  }
}

template <void (*read)(const std::string& bytes)>
void read_bytes(const char*, const std::string& bytes)
{
  read(bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return 0;
  struct Kind {
    const char* extension;
    void (*read)(const char* extension, const std::string& bytes);
  };
  static const Kind kinds[] = {
    {".ply", read_file_of<read_points>},  {".xyz", read_file_of<read_points>},  {".pwn", read_file_of<read_points>},
    {".off", read_file_of<read_points>},  {".noff", read_file_of<read_points>}, {".las", read_file_of<read_points>},
    {".ply", read_file_of<read_surface>}, {".off", read_file_of<read_surface>}, {".obj", read_file_of<read_surface>},
    {".stl", read_file_of<read_surface>}, {".ply", read_file_of<read_graph>},   {"", read_bytes<parse_options>},
    {"", read_bytes<read_skeleton>},      {"", read_bytes<edit_skeleton>}};
  constexpr std::size_t number = sizeof kinds / sizeof kinds[0];
  const Kind& kind = kinds[data[0] % number];
  kind.read(kind.extension, std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  return 0;
}
