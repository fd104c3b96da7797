// What programs read and write: every format comes back as it was, and every kind of broken file is
// refused with one line that names it.
#undef NDEBUG
#include "command_line.h"
#include "file_bytes.h"
#include "json.h"
#include "ply_file.h"
#include "point_file.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace fs = std::filesystem;
using namespace support;

namespace {

/// A folder that is empty at the start and gone at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("support_files_test_" + std::to_string(::getpid()));
  Folder() { fs::create_directory(path); }
  ~Folder() { fs::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
  std::string file(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path / name, std::ios::binary) << bytes;
    return file(name);
  }
  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

/// Reading `file` fails with one line that begins with its name and says `expected`.
template <typename Read>
void check_refused(Read read, const std::string& file, const std::string& expected)
{
  try {
    read(file);
  } catch(const File_error& error) {
    const std::string message = error.what();
    if(message.compare(0, file.size() + 2, file + ": ") == 0 && message.find('\n') == message.npos
       && message.find(expected) != message.npos)
      return;
    std::cerr << "expected '" << expected << "', got '" << message << "'\n";
    std::exit(EXIT_FAILURE);
  }
  std::cerr << file << " was accepted\n";
  std::exit(EXIT_FAILURE);
}

void check_points_refused(const std::string& file, const std::string& expected)
{
  check_refused([](const std::string& f) { read_point_cloud(f); }, file, expected);
}

void check_mesh_refused(const std::string& file, const std::string& expected)
{
  check_refused([](const std::string& f) { read_mesh(f); }, file, expected);
}

Point_cloud some_cloud()
{
  Point_cloud cloud;
  for(int i = 0; i < 100; ++i) {
    cloud.points.emplace_back(4e6 + i / 3., -1e-5 * i, std::sqrt(i) * 1e5);
    cloud.normals.push_back(Vec3(i, 1, -2).normalized());
    cloud.directions.push_back(Vec3(1, i, 3).normalized());
    cloud.views.push_back(i % 3);
    cloud.confidence.push_back(i / 100.);
  }
  return cloud;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  assert(a.size() == b.size());
  double largest = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    largest = (std::max)(largest, (a[i] - b[i]).norm());
  return largest;
}

// ---- points ----

void test_points_come_back(const Folder& folder)
{
  const Point_cloud cloud = some_cloud();
  for(const char* name : {"a.ply", "a.xyz", "a.pwn", "a.off", "a.noff", "a.PLY"}) {
    write_point_cloud(folder.file(name), cloud);
    const Point_cloud read = read_point_cloud(folder.file(name));
    assert(read.points == cloud.points);  // bit for bit, also far from the origin
    assert(largest_difference(read.normals, cloud.normals) < 1e-6);
    const bool is_ply = extension(name) == ".ply";
    assert(is_ply == !read.directions.empty());
    if(is_ply) {
      assert(largest_difference(read.directions, cloud.directions) < 1e-6);
      assert(read.views == cloud.views);
      for(std::size_t i = 0; i < cloud.size(); ++i)
        assert(std::abs(read.confidence[i] - cloud.confidence[i]) < 1e-6);
    }
  }
  Point_cloud bare;
  bare.points = cloud.points;
  for(const char* name : {"b.ply", "b.xyz", "b.off"}) {
    write_point_cloud(folder.file(name), bare);
    const Point_cloud read = read_point_cloud(folder.file(name));
    assert(read.points == cloud.points);
    assert(read.normals.empty() && read.directions.empty() && read.views.empty()
           && read.confidence.empty());
  }
}

void test_text_points(const Folder& folder)
{
  const auto read = [&](const char* name, const std::string& text) {
    return read_point_cloud(folder.file(name, text));
  };
  assert(read("a.xyz", "0 0 0\n1 2 3").points[1] == Vec3(1, 2, 3));
  assert(read("a.xyz", "# comment\r\n\r\n  0\t0 0 # here too\r\n+1 2e0 .5\r\n").points[1]
         == Vec3(1, 2, 0.5));
  assert(read("a.xyz", "2\n0 0 0\n1 2 3\n").size() == 2);  // with the number of points
  assert(read("a.pwn", "0 0 0 0 0 1\n1 2 3 0 1 0\n").normals[1] == Vec3(0, 1, 0));
  assert(read("a.xyz", "0 0 0\n1 2 3 0 1 0\n").normals[0] == Vec3(0, 0, 0));
  assert(read("a.xyz", "0 0 0 255 9 0\n1 2 3 0 1 0\n").normals.empty());  // colours
  assert(read("a.xyz", "0 0 0 nan nan nan\n1 2 3 nan 0 0\n").normals.empty());
  assert(read("a.xyz", "0 0 0 nan nan nan\n1 2 3 0 0 1\n").normals[0] == Vec3(0, 0, 0));

  assert(read("a.off", "OFF\n2 0 0\n0 0 0\n1 2 3\n").size() == 2);
  assert(read("a.off", "OFF 2 0 0\n0 0 0\n1 2 3\n").size() == 2);
  assert(read("a.off", "OFF\n# comment\n\n2 0\n0 0 0\n\n1 2 3\n").size() == 2);
  assert(read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").size() == 3);
  assert(read("a.off", "COFF\n1 0 0\n0 0 0 9 9 9 255\n").normals.empty());
  assert(read("a.off", "NCOFF\n1 0 0\n0 0 0 0 0 1 9 9 9\n").normals[0] == Vec3(0, 0, 1));
  assert(read("a.off", "NOFF\n1 0\n0 0 0 0 0 1\n").normals[0] == Vec3(0, 0, 1));
  assert(read("a.noff", "NOFF_SK\n1 0\n0 0 0 0 0 1\n").normals.size() == 1);
  assert(read("a.off", "NOFF\n2 0\n0 0 0\n1 2 3\n").normals.empty());  // positions only
}

std::string ply_header(const std::string& format, const std::string& rest)
{
  return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}

const std::string xyz_floats = "property float x\nproperty float y\nproperty float z\n";

void test_ply_points(const Folder& folder)
{
  // Text, other elements before and after, lists, and other properties.
  const Point_cloud text = read_point_cloud(folder.file(
      "a.ply", ply_header("ascii",
                          "comment element vertex 9\nelement camera 1\nproperty int id\n"
                          "element vertex 2\nproperty uchar red\n"
                              + xyz_floats
                              + "property float quality\nelement face 1\n"
                                "property list uchar int vertex_indices\n")
                   + "7\n255 1 2 3 .5\n0 4 5 6 .5\n3 0 1 0\n"));
  assert(text.points[0] == Vec3(1, 2, 3) && text.points[1] == Vec3(4, 5, 6));
  assert(text.normals.empty());

  // The highest byte first.
  std::string big = ply_header("binary_big_endian", "element vertex 1\n" + xyz_floats);
  big += std::string("\x3f\x80\0\0\x40\0\0\0\xc0\x40\0\0", 12);
  assert(read_point_cloud(folder.file("a.ply", big)).points[0] == Vec3(1, 2, -3));

  // Directions of any length, and those that say nothing.
  const Point_cloud directions = read_point_cloud(
      folder.file("a.ply", ply_header("ascii", "element vertex 3\n" + xyz_floats
                                                   + "property float vx\nproperty float vy\n"
                                                     "property float vz\nproperty uchar view\n")
                               + "1 2 3 0 0 5 2\n1 2 4 0 0 0 0\n1 2 5 nan 0 0 1\n"));
  assert(directions.directions[0] == Vec3(0, 0, 1));
  assert(directions.directions[1] == Vec3::Zero() && directions.directions[2] == Vec3::Zero());
  assert((directions.views == std::vector<int>{2, 0, 1}));
}

template <typename T>
void put(std::string& bytes, std::size_t offset, T value)
{
  if(bytes.size() < offset + sizeof value)
    bytes.resize(offset + sizeof value, '\0');
  std::memcpy(&bytes[offset], &value, sizeof value);  // the test runs on little-endian machines
}

std::string las_file(int minor_version, std::uint32_t points, std::uint32_t points_in_header)
{
  const std::uint32_t header_size = minor_version == 4 ? 375 : 227;
  std::string bytes = "LASF";
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, static_cast<std::uint8_t>(minor_version));
  put<std::uint32_t>(bytes, 96, header_size);
  put<std::uint8_t>(bytes, 104, 1);
  put<std::uint16_t>(bytes, 105, 28);
  if(minor_version == 4)
    put<std::uint64_t>(bytes, 247, points_in_header);
  else
    put<std::uint32_t>(bytes, 107, points_in_header);
  for(std::size_t i = 0; i < 3; ++i) {
    put<double>(bytes, 131 + 8 * i, 0.01);
    put<double>(bytes, 155 + 8 * i, 1000. * static_cast<double>(i));
  }
  bytes.resize(header_size, '\0');
  for(std::uint32_t i = 0; i < points; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      put<std::int32_t>(bytes, header_size + 28 * i + 4 * j, -100 * static_cast<int>(i));
  bytes.resize(header_size + 28 * points, '\0');
  return bytes;
}

void test_las_points(const Folder& folder)
{
  for(const int minor_version : {0, 2, 4}) {
    const Point_cloud cloud = read_point_cloud(folder.file("a.las", las_file(minor_version, 3, 3)));
    assert(cloud.size() == 3);
    assert((cloud.points[2] - Vec3(-2, 998, 1998)).norm() < 1e-9);
  }
  check_points_refused(folder.file("b.las", las_file(2, 3, 4)), "says 4 points, the file holds 3");
  check_points_refused(folder.file("c.las", las_file(2, 3, 3).substr(0, 100)), "truncated");
  std::string compressed = las_file(2, 3, 3);
  compressed[104] = static_cast<char>(0x81);
  check_points_refused(folder.file("d.las", compressed), "compressed");
}

void test_broken_points(const Folder& folder)
{
  // not to be opened
  check_points_refused(folder.file("missing.ply"), "No such file");
  fs::create_directory(folder.path / "folder.ply");
  check_points_refused(folder.file("folder.ply"), "is a folder");
  check_points_refused(folder.file("empty.xyz", ""), "is empty");
  check_points_refused(folder.file("a.doc", "0 0 0\n"), "unknown extension .doc");
  check_points_refused(folder.file("noext", "0 0 0\n"), "no extension");

  // another format than the extension says
  check_points_refused(folder.file("p.xyz", ply_header("ascii", "element vertex 0\n")), "PLY");
  check_points_refused(folder.file("o.xyz", "OFF\n1 0 0\n0 0 0\n"), "OFF data");
  check_points_refused(folder.file("x.ply", "0 0 0\n"), "not a PLY file");
  check_points_refused(folder.file("x.off", "0 0 0\n"), "not an OFF file");
  check_points_refused(folder.file("x.las", "0 0 0\n"), "not a LAS file");

  // garbage
  std::string garbage;
  for(int i = 0; i < 5000; ++i)
    garbage += static_cast<char>((i * 7919 + i / 13) % 256);
  check_points_refused(folder.file("g.xyz", garbage), "");
  check_points_refused(folder.file("g.off", garbage), "not an OFF file");
  check_points_refused(folder.file("g.ply", garbage), "not a PLY file");
  check_points_refused(folder.file("h.ply", "ply\n" + garbage), "header");
  check_points_refused(folder.file("g.las", "LASF" + garbage), "");
  check_points_refused(folder.file("w.xyz", "0 0 0\n1 2 three\n"), "line 2: expected numbers");
  check_points_refused(folder.file("w2.xyz", "0 0 0\n1 2 3.4.5\n"), "line 2: expected numbers");

  // truncated, or a header that lies
  check_points_refused(folder.file("t.xyz", "0 0 0\n1 2"), "line 2: expected the three");
  check_points_refused(folder.file("t1.xyz", "0 0 0 0 0\n"), "line 1");
  check_points_refused(folder.file("t2.xyz", "3\n0 0 0\n1 2 3\n"),
                       "says 3 points, the file holds 2");
  check_points_refused(folder.file("t3.xyz", "1\n0 0 0\n1 2 3\n"),
                       "says 1 points, the file holds 2");
  check_points_refused(folder.file("t.off", "OFF\n3 0 0\n0 0 0\n1 2 3\n"), "the file holds 2");
  check_points_refused(folder.file("t1.off", "OFF\n1 0 0\n0 0 0\n1 2 3\n"), "more vertices");
  check_points_refused(folder.file("t2.off", "OFF\n"), "truncated");
  check_points_refused(folder.file("t3.off", "OFF\n99999999999999 0 0\n0 0 0\n"), "truncated");
  check_points_refused(folder.file("t4.off", "OFF\n-1 0 0\n"), "number of vertices");
  check_points_refused(folder.file("t5.off", "OFF\n1 0 0\n0 0\n"), "line 3");
  check_points_refused(folder.file("t6.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), "truncated");
  write_point_cloud(folder.file("whole.ply"), some_cloud());
  const std::string whole = read_file(folder.file("whole.ply"));
  for(const std::size_t size : {2u, 10u, 100u, 300u, 1000u})
    check_points_refused(folder.file("t.ply", whole.substr(0, size)), "");
  check_points_refused(folder.file("t.ply", whole.substr(0, whole.size() - 1)), "truncated");
  check_points_refused(folder.file("m.ply", whole + std::string(100, 'x')), "more data");
  for(const char* count : {"101", "4000000000", "99999999999999", "1e300", "-1", "many"}) {
    std::string lying = whole;
    lying.replace(lying.find("vertex 100") + 7, 3, count);
    check_points_refused(folder.file("l.ply", lying), "");
  }
  const std::string small = ply_header("ascii", "element vertex 2\n" + xyz_floats);
  check_points_refused(folder.file("s.ply", small + "1 2 3\n4 5"), "truncated");
  check_points_refused(folder.file("s1.ply", small + "1 2 3\n4 5 6\n7"), "more data");
  check_points_refused(folder.file("s2.ply", small + "1 2 3\n4 5 x\n"), "not a number");
  check_points_refused(
      folder.file("s3.ply", ply_header("ascii", "element vertex 1\nproperty float x\n") + "1\n"),
      "lacks x, y or z");
  check_points_refused(folder.file("s4.ply", ply_header("ascii", "element vertex 99999\n")),
                       "no properties");
  check_points_refused(folder.file("s5.ply", ply_header("ascii", "element face 0\n")), "'vertex'");
  check_points_refused(
      folder.file("s6.ply", ply_header("ascii", "element vertex 1\nproperty long x\n")), "line 4");
  check_points_refused(folder.file("s7.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"),
                       "no end");
  check_points_refused(
      folder.file("s8.ply", ply_header("binary_little_endian",
                                       "element vertex 1\nproperty list uint float x\n")
                                + "\xff\xff\xff\xff"),
      "list");

  // nothing in it
  check_points_refused(folder.file("n.xyz", "# nothing\n"), "no points");
  check_points_refused(folder.file("n.off", "OFF\n0 0 0\n"), "no points");
  check_points_refused(folder.file("n.ply", ply_header("ascii", "element vertex 0\n" + xyz_floats)),
                       "no points");

  // not finite
  check_points_refused(folder.file("f.xyz", "0 0 0\n1 nan 2\n3 3 3\ninf 0 0\n"),
                       "2 points have coordinates that are not finite, the first is number 1");
  check_points_refused(folder.file("f1.xyz", "0 0 0\n1 1e999 2\n"), "1 point has");
  check_points_refused(folder.file("f.off", "OFF\n1 0 0\n0 -inf 0\n"), "not finite");
  Point_cloud cloud = some_cloud();
  cloud.points[7][2] = std::numeric_limits<double>::quiet_NaN();
  write_point_cloud(folder.file("f.ply"), cloud);
  check_points_refused(folder.file("f.ply"),
                       "1 point has coordinates that are not finite, the first "
                       "is number 7");
}

// ---- meshes and graphs ----

Triangle_mesh tetrahedron()
{
  Triangle_mesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

double volume(const Triangle_mesh& mesh)
{
  double six_volumes = 0;
  for(const auto& [a, b, c] : mesh.faces) {
    Eigen::Matrix3d corners;
    corners << mesh.vertices[a], mesh.vertices[b], mesh.vertices[c];
    six_volumes
        += corners(0, 0) * (corners(1, 1) * corners(2, 2) - corners(1, 2) * corners(2, 1))
           - corners(0, 1) * (corners(1, 0) * corners(2, 2) - corners(1, 2) * corners(2, 0))
           + corners(0, 2) * (corners(1, 0) * corners(2, 1) - corners(1, 1) * corners(2, 0));
  }
  return six_volumes / 6;
}

void test_meshes(const Folder& folder)
{
  for(const char* name : {"m.off", "m.ply", "m.obj", "m.stl"}) {
    write_mesh(folder.file(name), tetrahedron());
    const Triangle_mesh mesh = read_mesh(folder.file(name));
    assert(mesh.vertices.size() == 4 && mesh.faces.size() == 4);
    assert(std::abs(volume(mesh) - 1. / 6) < 1e-6);
  }
  // a square as one face, corners with texture and normal, indices from the end
  const Triangle_mesh square = read_mesh(folder.file(
      "q.obj", "o name\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 -2//1 4/7/1\n"));
  assert(square.faces.size() == 2 && (square.faces[1] == std::array<std::size_t, 3>{0, 2, 3}));
  assert(read_mesh(folder.file("q.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"))
             .faces.size()
         == 2);
  const std::string text_stl
      = "solid name\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\n";
  assert(read_mesh(folder.file("t.stl", text_stl + "endsolid name\n")).faces.size() == 1);

  check_mesh_refused(folder.file("t1.stl", text_stl), "endsolid");
  check_mesh_refused(folder.file("e.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                     "vertices below 3");
  check_mesh_refused(folder.file("e1.off", "OFF\n1 0 0\n0 0 0\n"), "no faces");
  check_mesh_refused(folder.file("e2.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
                     "not finite");
  check_mesh_refused(folder.file("e3.off", "OFF BINARY\n"), "binary OFF");
  check_mesh_refused(folder.file("e.obj", "v 0 0 0\nf 1 2 3\n"), "vertices that exist");
  check_mesh_refused(folder.file("e.ply", ply_header("ascii", "element vertex 1\n" + xyz_floats
                                                                  + "element face 1\nproperty list "
                                                                    "uchar int vertex_indices\n")
                                              + "0 0 0\n3 0 1 2\n"),
                     "does not exist");
  check_mesh_refused(
      folder.file("e1.ply", ply_header("ascii", "element vertex 1\n" + xyz_floats) + "0 0 0\n"),
      "'face'");
  const std::string stl = read_file(folder.file("m.stl"));
  check_mesh_refused(folder.file("e.stl", stl.substr(0, stl.size() - 1)), "says 4 triangles");
}

void test_graphs(const Folder& folder)
{
  Segment_graph graph;
  graph.vertices = {Vec3(0, 0, 0), Vec3(1e6, 0, 0.1), Vec3(0, 2, 0)};
  graph.radius = {0.5, 1, 2.25};
  graph.edges = {{0, 1}, {2, 0}};
  write_segment_graph(folder.file("g.ply"), graph);
  Segment_graph read = read_segment_graph(folder.file("g.ply"));
  assert(read.vertices == graph.vertices && read.radius == graph.radius
         && read.edges == graph.edges);
  graph.radius.clear();
  write_segment_graph(folder.file("g.ply"), graph);
  assert(read_segment_graph(folder.file("g.ply")).radius.empty());

  const auto refuse = [](const std::string& file, const std::string& expected) {
    check_refused([](const std::string& f) { read_segment_graph(f); }, file, expected);
  };
  const std::string header
      = ply_header("ascii", "element vertex 1\n" + xyz_floats
                                + "element edge 1\nproperty int vertex1\nproperty int vertex2\n");
  refuse(folder.file("g1.ply", header + "0 0 0\n0 1\n"), "does not exist");
  refuse(folder.file("g2.ply", header + "0 0 0\n0\n"), "truncated");
  refuse(folder.file("g3.ply", ply_header("ascii", "element vertex 1\n" + xyz_floats) + "0 0 0\n"),
         "'edge'");
}

// ---- writing is all or nothing ----

void test_whole_files_only(const Folder& folder)
{
  const auto write = [](const std::string& file) { write_point_cloud(file, some_cloud()); };
  const std::size_t before = folder.number_of_files();
  check_refused(write, folder.file("no/such/folder.ply"), "there is no folder");
  check_refused(write, folder.file("out.doc"), "unknown extension");
  check_refused(write, folder.file("folder.ply"), "is a folder");
  assert(folder.number_of_files() == before);

  // What was there is replaced, also behind a link.
  folder.file("old.xyz", "old");
  fs::create_symlink(folder.file("old.xyz"), folder.path / "link.xyz");
  write(folder.file("link.xyz"));
  assert(fs::is_symlink(folder.path / "link.xyz"));
  assert(read_point_cloud(folder.file("old.xyz")).size() == 100);
  assert(folder.number_of_files() == before + 2);

  if(fs::exists("/dev/full")) {
    fs::create_symlink("/dev/full", folder.path / "full.xyz");
    check_refused(write, folder.file("full.xyz"), "No space left");
    assert(fs::is_symlink(folder.path / "full.xyz"));
  }
}

// ---- command line ----

struct Options {
  std::string input;
  double omega = 45;
  int count = -3;
  std::size_t particles = 100;
  std::optional<double> percentage;
  std::string method = "wlop";
  std::vector<Vec3> scanners;
  std::vector<std::string> names;
  bool is_quiet = false;

  bool parse(std::vector<const char*> words, std::string* help = nullptr)
  {
    Command_line line("program", "Does something.");
    line.positional("INPUT", input, "point file");
    line.option("-o,--omega", "DEG", omega, "collision angle").between(0, 180);
    line.heading("Other options");
    line.option("--count", "N", count, "count");
    line.option("--particles", "N", particles, "number of particles").at_least(10);
    line.option("--percentage", "P", percentage, "share").above(0).default_is("5");
    line.option("--method", "NAME", method, "method").one_of({"wlop", "deep-points"});
    line.option("--scanner", "X Y Z", scanners, "position");
    line.option("--name", "TEXT", names, "name");
    line.flag("-q,--quiet", is_quiet, "says nothing");
    words.insert(words.begin(), "program");
    const bool result = line.parse(static_cast<int>(words.size()), words.data());
    if(help)
      *help = line.help();
    return result;
  }
};

void check_usage(const std::vector<const char*>& words, const std::string& expected)
{
  try {
    Options().parse(words);
  } catch(const Usage_error& error) {
    if(error.what() == expected)
      return;
    std::cerr << "expected '" << expected << "', got '" << error.what() << "'\n";
    std::exit(EXIT_FAILURE);
  }
  std::cerr << "accepted, but expected: " << expected << "\n";
  std::exit(EXIT_FAILURE);
}

void test_command_line()
{
  Options defaults;
  std::string help;
  assert(defaults.parse({"in.ply"}, &help));
  assert(defaults.input == "in.ply" && defaults.omega == 45 && defaults.particles == 100);
  assert(!defaults.percentage && defaults.scanners.empty() && !defaults.is_quiet);
  for(const char* text :
      {"Usage: program INPUT [options]", "-o, --omega DEG", "collision angle (default 45)",
       "--percentage P", "(default 5)", "wlop | deep-points (default wlop)", "Other options",
       "--scanner X Y Z", "--help", "--version"})
    assert(help.find(text) != help.npos);

  Options given;
  assert(
      given.parse({"--omega",  "30",          "-q",        "--scanner",   "-1", "0",
                   "2.5",      "--count=-7",  "in.ply",    "--particles", "20", "--percentage=0.5",
                   "--method", "deep-points", "--scanner", "1",           "2",  "3",
                   "--name",   "a",           "--name",    "--b"}));
  assert(given.omega == 30 && given.is_quiet && given.count == -7 && given.particles == 20);
  assert(*given.percentage == 0.5 && given.method == "deep-points" && given.input == "in.ply");
  assert(given.scanners.size() == 2 && given.scanners[0] == Vec3(-1, 0, 2.5));
  assert((given.names == std::vector<std::string>{"a", "--b"}));
  Options dashed;
  assert(dashed.parse({"--", "--in.ply"}) && dashed.input == "--in.ply");

  check_usage({}, "INPUT is missing");
  check_usage({"a", "b"}, "unexpected argument 'b'");
  check_usage({"a", "--colour"}, "unknown option --colour");
  check_usage({"a", "-x"}, "unknown option -x");
  check_usage({"a", "-o"}, "option --omega: needs DEG");
  check_usage({"a", "--omega", "wide"}, "option --omega: 'wide' is not a number");
  check_usage({"a", "--omega", "3x"}, "option --omega: '3x' is not a number");
  check_usage({"a", "--omega", "nan"}, "option --omega: 'nan' is not a number");
  check_usage({"a", "--omega", ""}, "option --omega: '' is not a number");
  check_usage({"a", "--omega", "181"}, "option --omega: 181 is not between 0 and 180");
  check_usage({"a", "--omega", "1", "--omega", "2"}, "option --omega: is given twice");
  check_usage({"a", "--particles", "9"}, "option --particles: 9 is not at least 10");
  check_usage({"a", "--particles", "10.5"}, "option --particles: '10.5' is not a whole number");
  check_usage({"a", "--particles", "1e30"}, "option --particles: 1e30 is too large");
  check_usage({"a", "--count", "3e9"}, "option --count: 3e9 is too large");
  check_usage({"a", "--percentage", "0"}, "option --percentage: 0 is not above 0");
  check_usage({"a", "--method", "x"}, "option --method: 'x' is none of wlop, deep-points");
  check_usage({"a", "--scanner", "1", "2"}, "option --scanner: needs X Y Z");
  check_usage({"a", "--quiet=yes"}, "option --quiet: takes no value");
  check_usage({"a", "--name", ""}, "option --name: the value is empty");
}

void test_exit_status()
{
  std::cerr.setstate(std::ios::failbit);  // the messages do not matter here
  assert(run_program("p", [] {}) == 0);
  assert(run_program("p", [] { throw Usage_error("x"); }) == 1);
  assert(run_program("p", [] { throw File_error("x"); }) == 2);
  assert(run_program("p", [] { throw Method_error("x"); }) == 3);
  assert(run_program("p", [] { throw std::bad_alloc(); }) == 3);
  assert(run_program("p", [] { throw 1; }) == 3);
  std::cerr.clear();
}

// ---- JSON ----

void test_json()
{
  Json json;
  json["points"] = std::size_t(7);
  json["name"] = "a \"b\"\n\\";
  json["seconds"]["sinking"] = 0.1;
  json["nothing"] = std::nan("");
  json["good"] = true;
  json["list"] = std::vector<double>{1, 2.5};
  json["empty"] = Json::array();
  json["points"] = 8;
  assert(json.text()
         == "{\n  \"points\": 8,\n  \"name\": \"a \\\"b\\\"\\u000a\\\\\",\n"
            "  \"seconds\": {\n    \"sinking\": 0.1\n  },\n  \"nothing\": null,\n"
            "  \"good\": true,\n  \"list\": [\n    1,\n    2.5\n  ],\n  \"empty\": []\n}\n");
}

}  // namespace

int main()
{
  const Folder folder;
  test_points_come_back(folder);
  test_text_points(folder);
  test_ply_points(folder);
  test_las_points(folder);
  test_broken_points(folder);
  test_meshes(folder);
  test_graphs(folder);
  test_whole_files_only(folder);
  test_command_line();
  test_exit_status();
  test_json();
  return EXIT_SUCCESS;
}
