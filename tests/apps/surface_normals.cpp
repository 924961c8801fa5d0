// Estimated normals of `rbpa surface`: how sure they are, in files, counts, colours and words.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Lines of points of a sphere, moved by noise of so many spacings.
std::string sphere(int count, double noise) {
  std::mt19937 random(5);
  std::string lines;
  const double spacing = std::sqrt(4 * 3.14159265358979 / count);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, around = i * 2.399963229728653, s = std::sqrt(1 - z * z);
    const double r = 1 + noise * spacing * (static_cast<double>(random()) / 2147483648.0 - 1);
    lines += std::to_string(r * s * std::cos(around)) + " " + std::to_string(r * s * std::sin(around)) + " " +
             std::to_string(r * z) + "\n";
  }
  return lines;
}

struct Vertex {
  double certainty;
  std::array<std::uint8_t, 3> color;
};

/// Of a PLY file with coordinates, normals, colours if it has any, and certainties.
std::vector<Vertex> vertices_of(const std::string& ply, bool colors) {
  const std::string end = "end_header\n";
  const char* at = ply.data() + ply.find(end) + end.size();
  const std::string element = "element vertex ";
  const std::size_t count = std::stoul(ply.substr(ply.find(element) + element.size()));
  std::vector<Vertex> vertices(count);
  for (Vertex& vertex : vertices) {
    at += 6 * sizeof(double);
    if (colors) {
      std::memcpy(vertex.color.data(), at, 3);
      at += 3;
    }
    std::memcpy(&vertex.certainty, at, sizeof(double));
    at += sizeof(double);
  }
  return vertices;
}

}  // namespace

TEST_SUITE("surface normals") {
  TEST_CASE("in doubt: as many as have a certainty below a half, with a word where they are one in twenty") {
    const Folder folder;
    for (const double noise : {0.0, 2.0}) {
      CAPTURE(noise);
      folder.file("p.xyz", sphere(2000, noise));
      const Outcome outcome = folder.rbpa("surface p.xyz --radius auto -o m.ply --stats s.json --compact");
      REQUIRE(outcome.code == 0);
      REQUIRE(folder.rbpa("surface p.xyz --radius auto -o all.ply -q").code == 0);
      const std::string ply = folder.content("all.ply");
      CHECK(ply.find("property double certainty\n") != std::string::npos);
      std::size_t in_doubt = 0;
      for (const Vertex& vertex : vertices_of(ply, false)) in_doubt += vertex.certainty < 0.5;
      CHECK(json::parse(folder.content("s.json"))["normals_in_doubt"] == in_doubt);
      CHECK((in_doubt > 100) == (noise > 0));
      const bool has_word = outcome.err.find(
                                " % of the normals are in doubt: --color normals shows where, --viewpoint decides "
                                "their side\n") != std::string::npos;
      CHECK(has_word == (noise > 0));
    }
  }

  TEST_CASE("--color normals: from blue, which is sure, to orange; points left out count as in doubt") {
    const Folder folder;
    folder.file("p.xyz", sphere(2000, 1.5) + "50 50 50\n");
    REQUIRE(
        folder.rbpa("surface p.xyz --radius auto --drop-outliers auto --color normals -q -o m.ply -o m.png --width 300")
            .code == 0);
    const std::vector<Vertex> vertices = vertices_of(folder.content("m.ply"), true);
    REQUIRE(vertices.size() == 2001);
    CHECK(vertices.back().certainty == 0);
    bool blue = false;
    for (const Vertex& vertex : vertices) {
      const double from[] = {0xD5, 0x5E, 0x00}, to[] = {0x86, 0xBC, 0xE4};
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(std::abs(vertex.color[k] - (from[k] + vertex.certainty * (to[k] - from[k]))) <= 0.51);
      blue = blue || vertex.certainty > 0.8;
    }
    CHECK(blue);
    const std::string colored = folder.content("m.png");
    REQUIRE(folder.rbpa("surface p.xyz --radius auto --drop-outliers auto -q -o m.png --width 300").code == 0);
    CHECK(folder.content("m.png") != colored);
  }

  TEST_CASE("what is not estimated has no certainty, and no colour by it") {
    const Folder folder;
    folder.file("n.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
    REQUIRE(folder.rbpa("surface n.xyz --radius 1 -q -o m.ply --stats s.json").code == 0);
    CHECK(folder.content("m.ply").find("certainty") == std::string::npos);
    CHECK(json::parse(folder.content("s.json"))["normals_in_doubt"].is_null());
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply --color normals --normals none").code == 2);
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply --color normals --normals file").code == 2);
    const Outcome blue = folder.rbpa("surface n.xyz --radius 1 -o m.ply --color blue");
    CHECK(blue.code == 2);
    CHECK(blue.err == "rbpa: --color: found 'blue', expected points or normals\n");
    const Outcome of_file = folder.rbpa("surface n.xyz --radius 1 -o m.ply --color normals");
    CHECK(of_file.code == 3);
    CHECK(
        of_file.err.find("found normals, which --color normals does not show, expected none, or --normals estimate") !=
        std::string::npos);
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply -q --color normals --normals estimate").code == 0);
  }
}
