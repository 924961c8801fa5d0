// meshtopo --remesh.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "support/changed_mesh.h"
#include "support/mesh_files.h"

using namespace apps_test;
using nlohmann::json;

namespace {
const std::string data = RBPA_TEST_DATA;
}

TEST_SUITE("meshtopo --remesh") {
  TEST_CASE("edges get the length, the topology stays, and the report has the counts and a bound of the distance") {
    const Folder folder;
    struct Row {
      std::string name;
      double length;
    };
    for (const Row& row : {Row{"m3_spot.off", 0.08}, Row{"m3_torus.off", 0.1}, Row{"m3_plate_holes.off", 15}}) {
      CAPTURE(row.name);
      const double length = row.length;
      const json report =
          changed(folder, data + "/" + row.name + " --remesh " + std::to_string(length) + " -o even.ply");
      for (const char* key : {"genus", "betti", "boundary_curves", "components", "euler"}) {
        CAPTURE(key);
        CHECK(report["result"][key] == report[key]);
      }
      const json& counts = report["changes"]["remesh"];
      CHECK(counts["triangles_before"] == report["faces"]);
      CHECK(counts["triangles"] == report["result"]["faces"]);
      CHECK(counts["splits"].get<int>() + counts["collapses"].get<int>() > 0);
      CHECK(counts["distance"].get<double>() < 0.6 * length);
      CHECK(counts["distance_back"].get<double>() < 0.6 * length);
      // An equilateral triangle has an area of √3/4 · length².
      const double mean = report["result"]["area"].get<double>() / counts["triangles"].get<double>();
      CHECK(std::sqrt(mean * 4 / std::sqrt(3.0)) == doctest::Approx(length).epsilon(0.15));
      CHECK(changed(folder, "even.ply")["faces"] == counts["triangles"]);
    }
    const Outcome outcome = folder.meshtopo(data + "/m3_torus.off --decimate 50% --remesh 0.2 -o even.off", 0);
    CHECK(contains(outcome.out, "\n  remeshed from 2304 to "));
  }

  TEST_CASE("the file is the same, byte by byte, whatever the order of vertices and faces") {
    const Folder folder;
    std::mt19937 random(5);
    Mesh mesh;
    for (int i = 0; i <= 12; ++i)
      for (int j = 0; j <= 12; ++j) mesh.positions.push_back({i * 1.0, j * 1.0, std::sin(0.3 * i) * std::cos(0.2 * j)});
    for (std::uint32_t i = 0; i < 12; ++i)
      for (std::uint32_t j = 0; j < 12; ++j) {
        const std::uint32_t a = 13 * i + j;
        mesh.faces.push_back({a, a + 13, a + 14});
        mesh.faces.push_back({a, a + 14, a + 1});
      }
    folder.file("m.off", mesh.off());
    changed(folder, "m.off --remesh 0.7 -o one.off");
    mesh.shuffle(random);
    folder.file("m.off", mesh.off());
    changed(folder, "m.off --remesh 0.7 -o other.off");
    CHECK(folder.content("one.off") == folder.content("other.off"));
    CHECK(folder.content("one.off").size() > 4000);
  }

  TEST_CASE("--subdivide multiplies faces, keeps the topology, and reports the rule; what does not suit is refused") {
    const Folder folder;
    for (const auto& [rule, factor] : {std::pair<std::string, int>{"loop", 4}, {"sqrt3", 3}})
      for (const std::string name : {"m3_torus.off", "m3_cube_no_bottom.off"}) {
        CAPTURE(name);
        const json report = changed(folder, data + "/" + name + " --subdivide " + rule + ":2 -o fine.ply");
        for (const char* key : {"genus", "betti", "boundary_curves", "components", "euler"})
          CHECK(report["result"][key] == report[key]);
        const int faces = report["faces"].get<int>();
        CHECK(report["changes"]["subdivide"] ==
              json{{"rule", rule}, {"times", 2}, {"triangles_before", faces}, {"triangles", factor * factor * faces}});
        CHECK(changed(folder, "fine.ply")["faces"] == factor * factor * faces);
      }
    CHECK(contains(folder.meshtopo(data + "/m3_torus.off --subdivide loop:1 -o fine.ply", 0).out,
                   "\n  subdivided by loop 1 time, from 4608 to 18432 triangles\n"));
    for (const std::string wrong : {"loop", "loop:", "loop:0", "loop:x", "butterfly:1", ":1", "loop:-1", "Loop:1"})
      meshtopo_refuses(
          folder, data + "/m3_spot.off --subdivide='" + wrong + "' -o o.off", 2,
          "--subdivide: found '" + wrong + "', expected loop:N or sqrt3:N, N the number of times, such as loop:2");
    meshtopo_says(folder, data + "/m3_spot.off --subdivide loop:20 -o o.off", 3,
                  "m3_spot.off: --subdivide: found 20 times, expected at most 6");
    folder.file("p.off", pyramid_off);
    CHECK(contains(folder.meshtopo("p.off --subdivide loop:1 -o o.off", 3).err, "as --subdivide requires"));
    CHECK_FALSE(folder.has("o.off"));
  }

  TEST_CASE("wrong lengths, lengths that do not suit the mesh, and polygons are refused, nothing written") {
    const Folder folder;
    for (const std::string wrong : {"0", "-1", "x", "nan", "inf", "10%", "1,error=0", "1,error=", "1,0.1", "error=1"})
      meshtopo_refuses(folder, data + "/m3_spot.off --remesh='" + wrong + "' -o o.off", 2,
                       "--remesh: found '" + wrong +
                           "', expected a length, such as 2.5, or a length and a distance, such as 2.5,error=0.1");
    for (const std::string wrong : {"1e-9", "100", "0.1,error=1e-12"})
      meshtopo_says(folder, data + "/m3_spot.off --remesh " + wrong + " -o o.off", 3, "m3_spot.off: --remesh: found ");
    folder.file("p.off", pyramid_off);
    CHECK(folder.meshtopo("p.off --remesh 1 -o o.off").err ==
          "meshtopo: p.off: found 1 face that is no triangle, expected triangles, as --remesh requires (--repair "
          "OUT.stl writes triangles)\n");
    CHECK(folder.meshtopo("p.off --remesh 1").err ==
          "meshtopo: --remesh changes the mesh, and requires a file for it (-o OUT or --repair OUT), or --check\n");
    CHECK_FALSE(folder.has("o.off"));
  }
}
