// Text is the same with any byte-order mark and line ends: in every format, at once and by pieces.
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "io/cloud/point_blocks.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/polygon/read_polygons.h"
#include "support/gzip.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

/// A text with a byte-order mark and line ends.
struct Writing {
  std::string name, mark;
  std::vector<std::string> ends;  ///< of its lines in turn
};
const Writing writings[] = {{"LF", "", {"\n"}},
                            {"CRLF", "", {"\r\n"}},
                            {"CR", "", {"\r"}},
                            {"mixed", "", {"\r", "\n", "\r\n"}},
                            {"mark and LF", "\xEF\xBB\xBF", {"\n"}},
                            {"mark and CRLF", "\xEF\xBB\xBF", {"\r\n"}},
                            {"mark and CR", "\xEF\xBB\xBF", {"\r"}},
                            {"mark and mixed", "\xEF\xBB\xBF", {"\r\n", "\r", "\n"}}};

std::string written(const std::string& text, const Writing& writing) {
  std::string result = writing.mark;
  std::size_t line = 0;
  for (const char c : text) {
    if (c == '\n')
      result += writing.ends[line++ % writing.ends.size()];
    else
      result += c;
  }
  return result;
}

std::string in_utf16(const std::string& text, bool little, bool mark) {
  std::string result = !mark ? "" : little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : text) {
    if (!little) result += '\0';
    result += c;
    if (little) result += '\0';
  }
  return result;
}

struct Sample {
  Format format;
  std::string ending, text;
};
const std::string atoms =
    "HETATM    1  C   UNK     1       0.000   0.500  -1.000  1.00  0.00           C\n"
    "HETATM    2  C   UNK     1       1.000   0.000   4.000  1.00  0.00           C\n"
    "HETATM    3  C   UNK     1       2.000   3.000   0.000  1.00  0.00           C\n";
const std::string corners = "0 0.5 -1\n1 0 4\n2 3 0\n";
const std::vector<Sample> of_space = {
    {Format::text, "xyz", corners},
    {Format::text, "csv", "# of three\nx,y,z\n0,0.5,-1\n1,0,4\n2,3,0\n"},
    {Format::text, "txt", "//X Y Z\n3\n" + corners},
    {Format::text, "xyz", "3\nof three\nC 0 0.5 -1\nN 1 0 4\nO 2 3 0\n"},
    {Format::pts, "pts", "3\n" + corners},
    {Format::xyzn, "xyzn", "0 0.5 -1 0 0 1\n1 0 4 0 0 1\n2 3 0 0 0 1\n"},
    {Format::xyzrgb, "xyzrgb", "0 0.5 -1 0 0 1\n1 0 4 0 0 1\n2 3 0 0 0 1\n"},
    {Format::off, "off", "OFF\n3 1 0\n" + corners + "3 0 1 2\n"},
    {Format::obj, "obj", "v 0 0.5 -1\nv 1 0 4\nv 2 3 0\nf 1 2 3\n"},
    {Format::ply, "ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
     "property list uchar int vertex_indices\nend_header\n" +
         corners + "3 0 1 2\n"},
    {Format::pcd, "pcd",
     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n" +
         corners},
    {Format::pdb, "pdb", atoms},
    {Format::cif, "cif",
     "data_a\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
     "_atom_site.Cartn_z\n1 C 0 0.5 -1\n2 C 1 0 4\n3 C 2 3 0\n#\n"},
    {Format::pqr, "pqr", "REMARK\nATOM 1 C A 1 0 0.5 -1 0 1.7\nATOM 2 C A 1 1 0 4 0 1\nATOM 3 C A 1 2 3 0 0 1\nEND\n"},
    {Format::gro, "gro",
     "three\n3\n    1A       C1    1   0.000   0.050  -0.100\n    1A       C2    2   0.100   0.000   0.400\n"
     "    1A       C3    3   0.200   0.300   0.000\n 1 1 1\n"},
    {Format::dump, "dump",
     "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id x y z\n"
     "1 0 0.5 -1\n2 1 0 4\n3 2 3 0\n"}};
const std::string stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0.5 -1\nvertex 1 0 4\nvertex 2 3 0\nendloop\nendfacet\n"
    "endsolid a\n";
const std::vector<Sample> of_plane = {
    {Format::text, "xy", "0 0.5\n1 0\n2 3\n"},
    {Format::text, "csv", "lon,lat\n0,0.5\n1,0\n2,3\n"},
    {Format::wkt, "wkt", "MULTIPOINT (0 0.5,\n1 0)\nPOINT (2 3)\n"},
    {Format::wkt, "ewkt", "SRID=28992;MULTIPOINT (0 0.5,\n1 0,2 3)\n"},
    {Format::geojson, "geojson", "{\"type\": \"MultiPoint\",\n\"coordinates\": [[0, 0.5],\n[1, 0], [2, 3]]}\n"},
    {Format::geojson, "geojsonl",
     "{\"type\":\"Point\",\"coordinates\":[0,0.5]}\n{\"type\":\"MultiPoint\",\"coordinates\":[[1,0],[2,3]]}\n"}};
const std::vector<Sample> of_polygons = {
    {Format::wkt, "wkt", "POLYGON ((0 0, 1 0,\n1 1, 0 0))\n"},
    {Format::geojson, "geojson", "{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0], [1, 0],\n[1, 1], [0, 0]]]}\n"},
    {Format::poly, "poly", "3 2 0 0\n1 0 0\n2 1 0\n3 1 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"}};

const std::vector<rbpa::Point> points = {{0, 0.5}, {1, 0}, {2, 3}};
const std::vector<rbpa::Point3> places = {{0, 0.5, -1}, {1, 0, 4}, {2, 3, 0}};

template <typename Read>
std::string refusal(const Read& read) {
  return rbpa_test::refusal_of<BadInput>(read);
}

void check_utf16(const std::string& text, const std::function<void(const std::string&)>& read) {
  for (const bool little : {true, false})
    for (const bool mark : {true, false}) {
      const std::string name = little ? "UTF-16LE" : "UTF-16BE";
      CHECK(contains(refusal([&] { read(in_utf16(text, little, mark)); }),
                     ": found text in " + name + ", expected UTF-8 (iconv -f " + name + " -t UTF-8 "));
    }
}

}  // namespace

TEST_SUITE("text encodings") {
  TEST_CASE("points in space are the same with any byte-order mark and any line ends") {
    for (const Sample& sample : of_space) {
      CAPTURE(sample.ending);
      for (const Writing& writing : writings) {
        CAPTURE(writing.name);
        CHECK(space_points_in(written(sample.text, writing), "p." + sample.ending, sample.format).points == places);
      }
      check_utf16(sample.text, [&](const std::string& text) { space_points_in(text, "p", sample.format); });
    }
  }

  TEST_CASE("points of the plane are the same with any mark and line ends, at once, by pieces and compressed") {
    const Folder folder;
    for (const Sample& sample : of_plane) {
      CAPTURE(sample.ending);
      for (const Writing& writing : writings) {
        CAPTURE(writing.name);
        const std::string text = written(sample.text, writing);
        CHECK(points_in(text, "p", {.format = sample.format}).points == points);
        for (const std::string& path :
             {folder.file("p." + sample.ending, text), folder.file("p." + sample.ending + ".gz", compressed(text))}) {
          const auto blocks = open_point_blocks({.path = path, .format = sample.format});
          std::vector<rbpa::Point> block;
          REQUIRE(blocks->next(block));
          CHECK(block == points);
        }
      }
      check_utf16(sample.text, [&](const std::string& text) { points_in(text, "p", {.format = sample.format}); });
    }
  }

  TEST_CASE("meshes are the same with any mark and any line ends, also compressed") {
    std::vector<Sample> samples = {{Format::stl, "stl", stl}};
    for (const Sample& sample : of_space)
      if (find_format(Use::mesh, sample.ending)) samples.push_back(sample);
    CHECK(samples.size() == 4);
    const Folder folder;
    for (const Sample& sample : samples) {
      CAPTURE(sample.ending);
      for (const Writing& writing : writings) {
        CAPTURE(writing.name);
        const std::string text = written(sample.text, writing);
        for (const MeshFile& mesh :
             {mesh_in(text, "m", sample.format),
              read_mesh({folder.file("m." + sample.ending + ".gz", compressed(text)), sample.format})}) {
          CHECK(mesh.positions == std::vector<std::array<double, 3>>{{0, 0.5, -1}, {1, 0, 4}, {2, 3, 0}});
          CHECK(mesh.soup.faces() == 1);
        }
      }
      check_utf16(sample.text, [&](const std::string& text) { mesh_in(text, "m", sample.format); });
    }
  }

  TEST_CASE("polygons and sizes are the same with any mark and any line ends") {
    const Folder folder;
    for (const Sample& sample : of_polygons)
      for (const Writing& writing : writings) {
        CAPTURE(sample.ending);
        CAPTURE(writing.name);
        const PolygonFile file =
            read_polygons(folder.file("p." + sample.ending, written(sample.text, writing)), sample.format);
        REQUIRE(file.polygons.size() == 1);
        CHECK(file.polygons[0].shell.points.size() == 3);
      }
    for (const Writing& writing : writings) {
      CAPTURE(writing.name);
      const std::vector<rbpa::SizeAt> sizes =
          read_sizes(folder.file("s", written("x y size\n0 0 0.5\n1 2 3\n", writing)));
      REQUIRE(sizes.size() == 2);
      CHECK(sizes[1].size == 3);
    }
    check_utf16("0 0 1\n", [&](const std::string& text) { read_sizes(folder.file("s", text)); });
    for (const Sample& sample : of_polygons)
      check_utf16(sample.text, [&](const std::string& text) {
        read_polygons(folder.file("p." + sample.ending, text), sample.format);
      });
  }

  TEST_CASE("binary numbers after a header stay as they are, with any line ends of the header") {
    // The first number begins with LF, and CR and CRLF are among them.
    const std::string numbers("\x0A\x0D\x0D\x41\x0D\x0A\x0D\x41\x0D\x00\x0D\x41", 12);
    const std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n";
    const std::string pcd =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n";
    const std::vector<rbpa::Point3> place = space_points_in(ply + numbers, "p", Format::ply).points;
    REQUIRE(place.size() == 1);
    for (const Writing& writing : writings) {
      if (writing.ends.size() > 1) continue;  // which of them ends the header?
      CAPTURE(writing.name);
      CHECK(space_points_in(written(ply, writing) + numbers, "p", Format::ply).points == place);
      CHECK(space_points_in(written(pcd, writing) + numbers, "p", Format::pcd).points == place);
    }
  }

  TEST_CASE("a message names the line, with any line ends, and shows a mark that is elsewhere") {
    for (const Writing& writing : writings) {
      CAPTURE(writing.name);
      CHECK(refusal([&] { points_in(written("1 2\n3 4\n5 x\n", writing), "p", {}); }) ==
            "p:3: found 'x', expected a number" + skipping_hint);
      CHECK(refusal([&] { mesh_in(written("OFF\n1 0 0\n0 0 z\n", writing), "m", Format::off); }) ==
            "m:3: found 'z', expected a number");
    }
    const std::string joined = "1 2\n\xEF\xBB\xBF" + std::string("3 4\n");  // two files in one
    CHECK(points_in(joined, "p", {}).points == std::vector<rbpa::Point>{{1, 2}, {3, 4}});
  }
}
