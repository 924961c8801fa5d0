// Estimated normals of `rbpa surface`: their confidence in files, counts, colors and messages.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns lines of points of a sphere, moved by noise of so many spacings.
std::string sphere(int count, double noise) {
  std::mt19937 random(5);
  std::string lines;
  const double spacing = std::sqrt(4 * 3.14159265358979 / count);
  for (const rbpa::Point3& p : rbpa_test::spiral(count)) {
    const double r = 1 + noise * spacing * (static_cast<double>(random()) / 2147483648.0 - 1);
    lines += rbpa_test::text_of({r * p.x, r * p.y, r * p.z}) + "\n";
  }
  return lines;
}

struct Vertex {
  double confidence;
  std::array<std::uint8_t, 3> color;
};

/// Returns the vertices of a PLY file with coordinates, normals, confidences, and colors if it has any.
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
    std::memcpy(&vertex.confidence, at, sizeof(double));
    at += sizeof(double);
  }
  return vertices;
}

}  // namespace

TEST_SUITE("surface normals") {
  TEST_CASE("normals of a confidence below a half are counted as in doubt, with a warning from one in twenty") {
    const Folder folder;
    for (const double noise : {0.0, 2.0}) {
      CAPTURE(noise);
      folder.file("p.xyz", sphere(2000, noise));
      const Outcome outcome = folder.rbpa("surface p.xyz --radius auto -o m.ply --stats s.json --compact", 0);
      REQUIRE(folder.rbpa("surface p.xyz --radius auto -o all.ply -q").code == 0);
      const std::string ply = folder.content("all.ply");
      CHECK(contains(ply, "property double confidence\n"));
      std::size_t in_doubt = 0;
      for (const Vertex& vertex : vertices_of(ply, false)) in_doubt += vertex.confidence < 0.5;
      CHECK(json::parse(folder.content("s.json"))["normals_in_doubt"] == in_doubt);
      CHECK((in_doubt > 100) == (noise > 0));
      const bool has_word = contains(
          outcome.err, " % of the normals are in doubt: --color normals shows where, --viewpoint decides their side\n");
      CHECK(has_word == (noise > 0));
    }
  }

  TEST_CASE("--color normals goes from blue for confidence to orange; points left out count as in doubt") {
    const Folder folder("p.xyz", sphere(2000, 1.5) + "50 50 50\n");
    REQUIRE(
        folder.rbpa("surface p.xyz --radius auto --drop-outliers auto --color normals -q -o m.ply -o m.png --width 300")
            .code == 0);
    const std::vector<Vertex> vertices = vertices_of(folder.content("m.ply"), true);
    REQUIRE(vertices.size() == 2001);
    CHECK(vertices.back().confidence == 0);
    bool blue = false;
    for (const Vertex& vertex : vertices) {
      const double from[] = {0xD5, 0x5E, 0x00}, to[] = {0x86, 0xBC, 0xE4};
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(std::abs(vertex.color[k] - (from[k] + vertex.confidence * (to[k] - from[k]))) <= 0.51);
      blue = blue || vertex.confidence > 0.8;
    }
    CHECK(blue);
    const std::string colored = folder.content("m.png");
    REQUIRE(folder.rbpa("surface p.xyz --radius auto --drop-outliers auto -q -o m.png --width 300").code == 0);
    CHECK(folder.content("m.png") != colored);
  }

  TEST_CASE("normals that are not estimated have no confidence, and no color by it") {
    const Folder folder("n.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
    REQUIRE(folder.rbpa("surface n.xyz --radius 1 -q -o m.ply --stats s.json").code == 0);
    CHECK(!contains(folder.content("m.ply"), "confidence"));
    CHECK(json::parse(folder.content("s.json"))["normals_in_doubt"].is_null());
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply --color normals --normals none").code == 2);
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply --color normals --normals file").code == 2);
    refuses(folder, "surface n.xyz --radius 1 -o m.ply --color blue", 2,
            "--color: found 'blue', expected points or normals");
    says(folder, "surface n.xyz --radius 1 -o m.ply --color normals", 3,
         "found normals, whose confidence is not known, expected none, as --color normals requires (or --normals "
         "estimate)");
    CHECK(folder.rbpa("surface n.xyz --radius 1 -o m.ply -q --color normals --normals estimate").code == 0);
  }

  TEST_CASE("columns give the viewpoint of each point, also if some points are left out") {
    const Folder folder;
    // Two level sheets, the upper one seen from below.
    std::string lines = "x,y,z,vx,vy,vz\n900,900,900,0,0,0\n";
    for (int i = 0; i < 200; ++i) {
      const int up = i / 100, x = i % 10, y = i / 10 % 10;
      lines += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(50 * up) + ",5,5,25\n";
    }
    folder.file("p.csv", lines);
    const std::string run = "surface p.csv --radius 1 --drop-outliers auto --viewpoint vx,vy,vz --fields none -o m.ply";
    REQUIRE(folder.rbpa(run + " -q").code == 0);
    const std::string ply = folder.content("m.ply");
    const std::string end = "end_header\n";
    std::vector<double> normals;  // the last coordinate of each, after five numbers, before the confidence
    for (std::size_t at = ply.find(end) + end.size(); normals.size() < 201; at += 7 * sizeof(double))
      std::memcpy(&normals.emplace_back(), ply.data() + at + 5 * sizeof(double), sizeof(double));
    REQUIRE(normals.size() == 201);
    for (std::size_t i = 1; i < normals.size(); ++i) CHECK(normals[i] == (i <= 100 ? 1 : -1));
    const Outcome both = folder.rbpa(run + " --stats s.json --where 'z>10'", 0);
    CHECK_MESSAGE(contains(both.err, "--where selects 101 of 201 lines"), both.err);
    for (const auto& [bad, code, text] : {std::tuple{"vx,vy,v", 3, "expected a header with a column 'v'"},
                                          {"vx,vy", 2, "three names of columns"},
                                          {"1,2,vx", 2, "three coordinates"},
                                          {"vx,vx,vy", 2, "three names"},
                                          {"1,2,", 2, "three coordinates"},
                                          {"1,2,3,4", 2, "three coordinates"}}) {
      const std::string viewpoint = bad;
      CAPTURE(viewpoint);
      const Outcome outcome = folder.rbpa("surface p.csv --radius 1 -o m.obj --viewpoint " + viewpoint, code);
      CHECK_MESSAGE(contains(outcome.err, text), outcome.err);
    }
    folder.file("q.csv", "x,y,z,vx,vy,vz\n0,0,0,1,1,1\n1,0,0,1,1,nan\n0,1,0,1,1,1\n");
    const Outcome nan = folder.rbpa("surface q.csv --radius 1 -o m.obj --viewpoint vx,vy,vz", 3);
    CHECK_MESSAGE(contains(nan.err, "q.csv:3: found 'nan', expected a finite number"), nan.err);
  }

  TEST_CASE("--max-radius replaces larger radii of auto, once") {
    const Folder folder;
    std::string lines;
    for (int i = 0; i < 900; ++i) lines += std::to_string(i % 30) + " " + std::to_string(i / 30) + " 0\n";
    for (int i = 0; i < 900; ++i)
      lines += std::to_string(8 * (i % 30) + 40) + " " + std::to_string(8 * (i / 30)) + " 0\n";
    folder.file("p.xyz", lines);
    const auto radii = [&](const std::string& options) {
      REQUIRE(folder.rbpa("surface p.xyz --radius auto -q --stats s.json" + options).code == 0);
      return json::parse(folder.content("s.json"))["radii"].get<std::vector<double>>();
    };
    const std::vector<double> all = radii("");
    REQUIRE(all.size() > 1);
    CHECK(radii(" --max-radius 1000") == all);
    std::vector<double> capped = all;
    capped.back() = (all[all.size() - 2] + all.back()) / 2;
    CHECK(radii(" --max-radius " + json(capped.back()).dump()) == capped);
    CHECK(radii(" --max-radius 0.125") == std::vector<double>{0.125});
    CHECK(radii(" --max-radius 0.125 --normals none") == std::vector<double>{0.125});
    CHECK(folder.rbpa("surface p.xyz --radius 2 --max-radius 3").err ==
          "rbpa: --max-radius applies only to --radius auto\n");
    CHECK(folder.rbpa("surface p.xyz --radius auto --max-radius 0").code == 2);
    CHECK(folder.rbpa("surface p.xyz --radius auto --max-radius x").code == 2);
  }
}
