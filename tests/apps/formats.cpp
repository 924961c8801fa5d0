// Points and meshes mean the same in every format.
#include <doctest/doctest.h>

#include <random>

#include "io/cloud/read_points.h"
#include "support/program.h"

using namespace apps_test;
using rbpa::Point;
using rbpa::app::Format;

namespace {

/// Doubles of every kind: short, long, tiny, huge, denormal.
std::vector<Point> awkward_points() {
  std::vector<Point> points = {{0, 0}, {0.1, 1e-310}, {1e300, -1e300}, {5e-324, 3}, {-0.0, 1.7976931348623157e308}};
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 * 1e6 - 5e5; };
    const double x = coordinate();
    points.push_back({x, coordinate()});
  }
  return points;
}

std::string as_text(const std::vector<Point>& points, const std::string& separator) {
  std::string text;
  char line[80];
  for (const Point& p : points) {
    std::snprintf(line, sizeof line, "%.17g%s%.17g\n", p.x, separator.c_str(), p.y);
    text += line;
  }
  return text;
}

std::vector<Point> read(const std::string& path, Format format) {
  return rbpa::app::read_points({path, format}).points;
}

}  // namespace

TEST_SUITE("formats") {
  TEST_CASE("coordinates read back to the same doubles through every mesh file") {
    const Folder folder;
    const auto points = awkward_points();
    folder.file("p.xy", as_text(points, " "));
    REQUIRE(read(folder.path("p.xy"), Format::text) == points);
    REQUIRE(folder.rbpa("mesh p.xy --alpha inf -o m.off -o m.ply -o m.obj -q").code == 0);
    CHECK(read(folder.path("m.off"), Format::off) == points);
    CHECK(read(folder.path("m.ply"), Format::ply) == points);
    // Each file gives the same mesh.
    REQUIRE(folder.rbpa("mesh m.off --alpha inf -o again.ply -q").code == 0);
    CHECK(folder.content("again.ply") == folder.content("m.ply"));
    REQUIRE(folder.rbpa("mesh m.ply --alpha inf -o again.obj -q").code == 0);
    CHECK(folder.content("again.obj") == folder.content("m.obj"));
  }

  TEST_CASE("any separators, headers, comments, blank lines and line ends are read") {
    const std::vector<Point> points = {{1, 2}, {-3.5, 4e2}, {5, 6}};
    const Folder folder;
    for (const std::string separator : {" ", "\t", ",", ";", " , ", "   "}) {
      CAPTURE(separator);
      CHECK(read(folder.file("p.csv", as_text(points, separator)), Format::text) == points);
      CHECK(read(folder.file("p.csv", "x" + separator + "y\n" + as_text(points, separator)), Format::text) == points);
    }
    CHECK(read(folder.file("p.txt", "# points\r\n\r\n1 2 # first\r\n-3.5 4e2\r\n\r\n5 6"), Format::text) == points);
  }

  TEST_CASE("columns are chosen by number and by name") {
    const Folder folder("p.csv", "id,lat,lon\n7,0,0\n8,0,1\n9,1,0\n");
    for (const char* columns : {"lon,lat", "3,2"}) {
      const Outcome outcome =
          folder.rbpa(std::string("mesh p.csv --columns ") + columns + " --alpha inf -o - --output-format off -q", 0);
      CHECK(outcome.out == "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    }
  }

  TEST_CASE("numpy arrays of all types, byte orders and memory orders are read") {
    struct Case {
      const char* description;
      std::string data;
    };
    const auto bytes = [](std::initializer_list<int> values) { return std::string(values.begin(), values.end()); };
    const std::vector<Point> points = {{1, 2}, {3, 4}, {5, 6}};
    const Case cases[] = {
        {"{'descr': '|i1', 'fortran_order': False, 'shape': (3, 2), }", bytes({1, 2, 3, 4, 5, 6})},
        {"{'descr': '|u1', 'fortran_order': True, 'shape': (3, 2), }", bytes({1, 3, 5, 2, 4, 6})},
        {"{'descr': '>i2', 'fortran_order': False, 'shape': (3, 2), }", bytes({0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6})},
        {"{'descr': '<u2', 'fortran_order': False, 'shape': (3, 3), }",
         bytes({1, 0, 2, 0, 9, 0, 3, 0, 4, 0, 9, 0, 5, 0, 6, 0, 9, 0})},
        {"{'descr': '>f4', 'fortran_order': False, 'shape': (3, 2), }",
         bytes(
             {0x3f, -128, 0, 0, 0x40, 0, 0, 0, 0x40, 0x40, 0, 0, 0x40, -128, 0, 0, 0x40, -96, 0, 0, 0x40, -64, 0, 0})}};
    const Folder folder;
    for (const Case& c : cases) {
      CAPTURE(c.description);
      std::string header = c.description;
      header.resize(117, ' ');
      header += '\n';
      std::string file = std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header + c.data;
      CHECK(read(folder.file("p.npy", file), Format::npy) == points);
    }
    const std::string complex_numbers = std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(118) + '\0' +
                                        "{'descr': '<c16', 'fortran_order': False, 'shape': (3, 2), }" +
                                        std::string(57, ' ') + "\n";
    folder.file("p.npy", complex_numbers);
    CHECK(folder.rbpa("info p.npy").code == 3);
  }

  TEST_CASE("PLY is read as ASCII and big-endian, and other elements and lists are skipped") {
    const std::vector<Point> points = {{1, 2}, {3, 4}, {5, 6}};
    const Folder folder;
    CHECK(read(folder.file("a.ply",
                           "ply\nformat ascii 1.0\ncomment c\nelement face 2\nproperty list uchar int vertex_indices\n"
                           "element vertex 3\nproperty float z\nproperty double y\nproperty int x\nend_header\n"
                           "3 0 1 2\n4 0 1 2 2\n9 2 1\n9 4 3\n9 6 5\n"),
               Format::ply) == points);
    const std::string data("\0\1\0\2\0\3\0\4\0\5\0\6", 12);
    CHECK(read(folder.file("b.ply",
                           "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\n"
                           "end_header\n" +
                               data),
               Format::ply) == points);
  }

  TEST_CASE("standard input and output are read and written") {
    const Folder folder("p.xy", corner);
    const Outcome outcome = folder.rbpa("mesh - --alpha 1 -o - --output-format obj -q < p.xy", 0);
    CHECK(outcome.out == "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(outcome.err.empty());
  }
}
