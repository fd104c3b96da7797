// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The programs' readers and options on arbitrary bytes. The first byte says which reader; the rest is the
// file, or the words of a command line, each ended by a zero byte. A reader returns what is finite and
// consistent, or throws its one kind of error with a message of one line.

#include "../../../examples/Point_set_consolidation_3/support/command_line.h"
#include "../../../examples/Point_set_consolidation_3/support/point_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

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
  void write(const char* bytes, std::size_t size) const
  {
    std::ofstream file(m_name, std::ios::binary);
    file.write(bytes, std::streamsize(size));
  }

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

/// Options of all kinds that the programs have.
void parse_options(const std::vector<std::string>& words)
{
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
  if(!line.parse(int(arguments.size()), arguments.data()))
    return;
  require(!input.empty() || words.size() > 0);
  require(angle >= 1 && angle <= 170 && (method == "one" || method == "two"));
  require(!particles || *particles >= 1);
  for(const support::Vec3& s : scanners)
    require(s.allFinite());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return 0;
  struct Kind {
    const char* extension;
    void (*read)(const std::string&);
  };
  static const Kind kinds[] = {{".ply", read_points}, {".xyz", read_points}, {".pwn", read_points},
                               {".off", read_points}, {".noff", read_points}, {".las", read_points},
                               {".ply", read_surface}, {".off", read_surface}, {".obj", read_surface},
                               {".stl", read_surface}, {".ply", read_graph}};
  constexpr std::size_t number = sizeof kinds / sizeof kinds[0];
  const char* const bytes = reinterpret_cast<const char*>(data) + 1;
  const std::size_t kind = data[0] % (number + 1);
  try {
    if(kind == number) {
      std::vector<std::string> words(1);
      for(std::size_t i = 0; i + 1 < size; ++i)
        if(bytes[i] == 0)
          words.emplace_back();
        else
          words.back() += bytes[i];
      parse_options(words);
    }
    else {
      const Scratch_file file(kinds[kind].extension);
      file.write(bytes, size - 1);
      kinds[kind].read(file.name());
    }
  }
  catch(const support::Usage_error& error) {
    require(kind == number && *error.what() != 0);
  }
  catch(const support::File_error& error) {
    const std::string message = error.what();
    require(kind < number && message.compare(0, 5, "fuzz_") == 0 && message.find('\n') == std::string::npos);
  }
  return 0;
}
