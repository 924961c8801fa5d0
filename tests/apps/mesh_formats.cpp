// Readers of meshes, and that written meshes read back.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/write_mesh.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

using Positions = std::vector<std::array<double, 3>>;
using Faces = std::vector<std::vector<std::uint32_t>>;

MeshFile read(const std::string& content, Format format) {
  const Folder folder;
  return read_mesh({folder.file("m", content), format});
}

Faces faces_of(const MeshFile& mesh) {
  Faces faces;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f)
    faces.emplace_back(mesh.soup.face(f).begin(), mesh.soup.face(f).end());
  return faces;
}

void is_pyramid(const MeshFile& mesh) {
  CHECK(mesh.positions == pyramid_positions);
  CHECK(mesh.soup.points == 5);
  CHECK(faces_of(mesh) == pyramid_faces);
}

}  // namespace

TEST_SUITE("mesh formats") {
  TEST_CASE("OFF is read with prefixes, comments, blank lines, counts next to the word, normals and colors") {
    is_pyramid(read(pyramid_off, Format::off));
    is_pyramid(
        read("OFF 5 5 0 # counts\n\n0 0 0\n1 0 0 # here\n1 1 0\n0 1 0\n0.5 0.5 1\n"
             "4 3 2 1 0 # base\n# sides\n3 0 1 4 0.5 0.5 0.5\n3 1 2 4 255 0 0 255\r\n3 2 3 4 7\n3 3 0 4",
             Format::off));
    is_pyramid(
        read("STCNOFF\n5 5 8\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1\n"
             "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n",
             Format::off));
    is_pyramid(
        read("5 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n", Format::off));
  }

  TEST_CASE("the lines of points and faces are those of the file") {
    const MeshFile off = read("OFF\n# a comment\n3 1 0\n0 0 0\n\n1 0 0\n0 1 0\n# another\n3 0 1 2\n", Format::off);
    CHECK(off.point_lines == std::vector<std::size_t>{4, 6, 7});
    CHECK(off.face_lines == std::vector<std::size_t>{9});
    const MeshFile obj = read("v 0 0 0\nv 1 0 0\nv 0 1 \\\n0\nf 1 \\\n2 \\\n3\nf 3 2 1\n", Format::obj);
    CHECK(obj.point_lines == std::vector<std::size_t>{1, 2, 3});
    CHECK(obj.face_lines == std::vector<std::size_t>{5, 8});
    const MeshFile stl = read(stl_text(pyramid_triangles), Format::stl);
    CHECK(stl.point_lines == std::vector<std::size_t>{4, 5, 6, 13, 20});
    CHECK(stl.face_lines == std::vector<std::size_t>{2, 9, 16, 23, 30, 37});
    CHECK(read(ply_binary(std::endian::big), Format::ply).face_lines.empty());
  }

  TEST_CASE(
      "OBJ is read with texture and normal references, negative numbers and continued lines; the rest is skipped") {
    is_pyramid(
        read("# a pyramid\nmtllib a.mtl\no pyramid\nv 0 0 0 1 0 0\nv 1 0 0\nvt 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\n"
             "v 0.5 0.5 1\ng sides\ns 1\nusemtl red\nf 4/1/1 3/1/1 2/1/1 1/1/1\nf 1/1 2/1 5/1\nf 2//1 3//1 5//1\n"
             "f -3 -2 -1 # side\nf 4 \\\n  1 \\\n  5\nl 1 2\np 3\nvp 0.5\n",
             Format::obj));
    // A negative number counts back from its line, a positive one may refer to later vertices.
    const MeshFile mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf 1 2 4\nv 0 0 1\nf -4 -3 -1\n", Format::obj);
    CHECK(faces_of(mesh) == Faces{{0, 1, 2}, {0, 1, 3}, {0, 1, 3}});
  }

  TEST_CASE("PLY is read as ASCII and in both byte orders, with any types, other elements, and faces before vertices") {
    is_pyramid(read(ply_binary(std::endian::little), Format::ply));
    is_pyramid(read(ply_binary(std::endian::big), Format::ply));
    is_pyramid(
        read("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 5\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
             "0.5 0.5 1\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n",
             Format::ply));
    is_pyramid(
        read("ply\nformat ascii 1.0\nelement material 1\nproperty float shine\nelement face 5\n"
             "property list uint uint neighbors\nproperty uchar red\nproperty list ushort short vertex_index\n"
             "element vertex 5\nproperty double z\nproperty list uchar int near\nproperty double x\nproperty double "
             "y\nelement edge 1\nproperty int a\nend_header\n7\n2 8 9 255 4 3 2 1 0\n0 1 3 0 1 4\n0 1 3 1 2 4\n0 1 3 2 "
             "3 4\n0 1 3 3 0 4\n0 0 0 0\n0 1 5 1 0\n0 2 5 6 1 1\n0 0 0 1\n1 0 0.5 0.5\n3\n",
             Format::ply));
    CHECK(read("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n1 "
               "2 3\n",
               Format::ply)
              .positions == Positions{{1, 2, 3}});
  }

  TEST_CASE("corners of STL with equal coordinates are one point, in ASCII and binary") {
    for (const std::string& content : {stl_text(pyramid_triangles), stl_binary(pyramid_triangles)}) {
      const MeshFile mesh = read(content, Format::stl);
      CHECK(mesh.positions.size() == 5);
      REQUIRE(mesh.soup.faces() == 6);
      for (std::size_t f = 0; f < 6; ++f)
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(mesh.positions[mesh.soup.face(f)[k]] == pyramid_positions[pyramid_triangles[f][k]]);
    }
  }

  TEST_CASE("minus zero is zero in STL, and the next number is another") {
    const MeshFile mesh = read(
        "solid\nfacet normal nan 0 0\nouter loop\nvertex -0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "FACET NORMAL 0 0 0\nOUTER LOOP\nVERTEX 0 -0.0 0\nVERTEX 1.0000000000000002 0 0\nVERTEX 0 1.0e0 0\nENDLOOP\n"
        "ENDFACET\nendsolid\nsolid two words\nendsolid two words\n",
        Format::stl);
    CHECK(faces_of(mesh) == Faces{{0, 1, 2}, {0, 3, 2}});
    CHECK_FALSE(std::signbit(mesh.positions[0][0]));
  }

  TEST_CASE("STL is binary by its size, also when its header begins with 'solid'") {
    std::string content = stl_binary(pyramid_triangles);
    std::memcpy(content.data(), "solid of some exporter", 22);
    CHECK(read(content, Format::stl).soup.faces() == 6);
  }

  TEST_CASE("written files read back with the same doubles and faces") {
    const Positions positions = {
        {0.1, 1e-310, -5e-324}, {1e300, -1.7976931348623157e308, -0.0}, {1.0 / 3, 3, 4}, {1, 2, 3}};
    meshops::PolygonSoup soup;
    soup.points = positions.size();
    soup.add_face(std::vector<std::uint32_t>{0, 1, 2});
    soup.add_face(std::vector<std::uint32_t>{3, 2, 1, 0});
    for (const bool long_face : {false, true}) {
      if (long_face) soup.add_face(std::vector<std::uint32_t>(300, 1));
      for (const Format format : {Format::off, Format::ply, Format::obj}) {
        const Folder folder;
        OutputFile file(folder.path("m"));
        write_mesh(file, format, positions, soup);
        file.finish();
        file.publish();
        const MeshFile mesh = read_mesh({folder.path("m"), format});
        CHECK(mesh.soup.corners == soup.corners);
        CHECK(mesh.soup.begin == soup.begin);
        REQUIRE(mesh.positions.size() == positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i)
          for (std::size_t k = 0; k < 3; ++k)
            CHECK(std::bit_cast<std::uint64_t>(mesh.positions[i][k]) == std::bit_cast<std::uint64_t>(positions[i][k]));
      }
    }
  }

  TEST_CASE("a file with a few bytes changed, dropped or doubled is read as a sound mesh or refused") {
    const std::pair<Format, std::string> files[] = {{Format::off, pyramid_off},
                                                    {Format::obj, pyramid_obj},
                                                    {Format::ply, pyramid_ply},
                                                    {Format::ply, ply_binary(std::endian::little)},
                                                    {Format::stl, stl_text(pyramid_triangles)},
                                                    {Format::stl, stl_binary(pyramid_triangles)}};
    const Folder folder;
    std::mt19937_64 random(11);
    std::size_t read_well = 0, refused = 0;
    for (const auto& [format, original] : files)
      for (int run = 0; run < 400; ++run) {
        std::string content = original;
        for (auto changes = 1 + random() % 3; changes > 0 && !content.empty(); --changes) {
          const std::size_t at = random() % content.size();
          switch (random() % 4) {
            case 0:
              content[at] = static_cast<char>(random());
              break;
            case 1:
              content[at] = "0123456789-. \n#\\/"[random() % 17];
              break;
            case 2:
              content.erase(at, 1 + random() % 8);
              break;
            default:
              content.insert(at, content.substr(random() % content.size(), 1 + random() % 8));
          }
        }
        try {
          const MeshFile mesh = read_mesh({folder.file("m", content), format});
          ++read_well;
          CHECK(mesh.soup.points == mesh.positions.size());
          CHECK(mesh.soup.begin.back() == mesh.soup.corners.size());
          for (const std::uint32_t corner : mesh.soup.corners) CHECK(corner < mesh.positions.size());
          for (const auto& p : mesh.positions)
            for (const double coordinate : p) CHECK(std::isfinite(coordinate));
          CHECK((mesh.face_lines.empty() || mesh.face_lines.size() == mesh.soup.faces()));
          CHECK((mesh.point_lines.empty() || mesh.point_lines.size() == mesh.positions.size()));
        } catch (const BadInput& e) {
          ++refused;
          CHECK(std::string(e.what()).find('\n') == std::string::npos);
        }
      }
    CHECK(read_well > 200);
    CHECK(refused > 200);
  }
}
