// --fill-holes and --watertight of `rbpa surface`: curves that are closed, that stay open and why; meshtopo agrees.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns a sphere of radius 1 around the origin without the parts above `top` and within 0.3 of the point (1, 0, 0),
/// and far from it a triangle; each point with its normal.
std::vector<std::string> lines(double top) {
  std::vector<std::string> lines{"3 0 0 0 0 1", "3.1 0 0 0 0 1", "3 0.1 0 0 0 1"};
  for (const rbpa::Point3& at : rbpa_test::spiral(600)) {
    const std::string p = rbpa_test::text_of(at);
    if (at.z <= top && std::hypot(at.x - 1, at.y, at.z) >= 0.3) lines.push_back(p + " " + p);
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

constexpr const char* ball = "surface s.xyz --radius 0.2 --json ";

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("holes are filled, rims and islands stay, and curves that stay keep their causes") {
    const Folder folder("s.xyz", joined(lines(0.9)));
    const json open = json::parse(folder.rbpa(std::string(ball) + "-o open.off").out);
    REQUIRE(open["curves"] == json::parse(R"({"rim": 0, "hole": 2, "island": 1})"));
    CHECK(open["filled"]["holes"] == 0);
    CHECK(open["watertight"].is_null());

    const Outcome outcome = folder.rbpa(std::string(ball) + "--fill-holes all -o m.off --holes h.obj", 0);
    const json report = json::parse(outcome.out);
    CHECK(report["filled"]["holes"] == 2);
    CHECK(report["filled"]["left"] ==
          json::parse(R"({"crosses": 0, "edge_taken": 0, "no_area": 0, "too_much_work": 0})"));
    CHECK(report["curves"] == json::parse(R"({"rim": 0, "hole": 0, "island": 1})"));
    // A hole of n edges has n - 2 triangles.
    const auto edges = open["holes"][0]["points"].get<int>() + open["holes"][1]["points"].get<int>() +
                       open["holes"][2]["points"].get<int>() - 3;
    CHECK(report["filled"]["triangles"] == edges - 4);
    CHECK(report["triangles"].get<int>() == open["triangles"].get<int>() + edges - 4);
    CHECK(report["area"].get<double>() ==
          doctest::Approx(open["area"].get<double>() + report["filled"]["area"].get<double>()));
    CHECK(report["component_list"][0]["volume"].get<double>() == doctest::Approx(4.0).epsilon(0.05));
    CHECK(contains(outcome.err, "\nrbpa: 2 holes filled by " + std::to_string(edges - 4) + " triangles of area "));
    REQUIRE(report["holes"].size() == 1);
    CHECK(report["holes"][0]["edges"] == open["holes"][0]["edges"]);
    CHECK(!contains(folder.content("h.obj"), "g hole"));
    const json topology = json::parse(folder.meshtopo("m.off --json").out);
    CHECK(topology["defects"].empty());
    CHECK(topology["boundary_curves"] == 1);
  }

  TEST_CASE("holes are chosen by edges and by length") {
    const Folder folder("s.xyz", joined(lines(0.9)));
    const json open = json::parse(folder.rbpa(std::string(ball) + "-o open.npy").out);
    std::vector<json> holes;
    for (const json& hole : open["holes"])
      if (hole["kind"] == "hole") holes.push_back(hole);
    REQUIRE(holes.size() == 2);
    const auto by = [](const char* key) {
      return [key](const json& a, const json& b) { return a[key].get<double>() < b[key].get<double>(); };
    };
    const auto filled = [&](const std::string& choice) {
      return json::parse(folder.rbpa(std::string(ball) + "-o m.npy --fill-holes " + choice, 0).out)["filled"]["holes"]
          .get<int>();
    };
    std::sort(holes.begin(), holes.end(), by("points"));
    const int fewest = holes[0]["points"].get<int>(), most = holes[1]["points"].get<int>();
    REQUIRE(fewest < most);
    CHECK(filled(std::to_string(fewest - 1)) == 0);
    CHECK(folder.content("m.npy") == folder.content("open.npy"));
    CHECK(filled(std::to_string(fewest)) == 1);
    CHECK(filled(std::to_string(most - 1)) == 1);
    CHECK(filled(std::to_string(most)) == 2);
    std::sort(holes.begin(), holes.end(), by("length"));
    const std::string shortest = holes[0]["length"].dump();
    CHECK(filled("length=" + shortest) == 1);
    CHECK(filled("length=" + std::to_string(holes[0]["length"].get<double>() * 0.999)) == 0);
    CHECK(filled("length=1e9") == 2);
  }

  TEST_CASE("a watertight surface is a closed manifold without islands, the same for any order and threads") {
    const Folder folder;
    for (const double top : {0.9, -0.2}) {  // the second is less than half a sphere: its curve is a rim
      CAPTURE(top);
      std::vector<std::string> points = lines(top);
      folder.file("s.xyz", joined(points));
      const Outcome outcome = folder.rbpa(std::string(ball) + "--watertight -o m.off -o m.stl -o m.npy --threads 1", 0);
      const json report = json::parse(outcome.out);
      CHECK(report["watertight"] == true);
      CHECK(report["manifold"] == true);
      CHECK(report["boundary_curves"] == 0);
      CHECK(report["components"] == 1);
      CHECK(report["dropped"]["triangles"] == 1);
      CHECK(contains(outcome.err, "\nrbpa: watertight: every edge has two triangles, and no two triangles cross\n"));
      CHECK(!contains(outcome.err, "--flip"));
      const std::string check = " --check closed,manifold,genus=0,components=1 -q";
      CHECK(folder.meshtopo("m.off" + check).code == 0);
      CHECK(folder.meshtopo("m.stl" + check).code == 0);
      CHECK(folder.rbpa(std::string(ball) + "--watertight -o two.off --threads 2").out == outcome.out);
      CHECK(folder.content("two.off") == folder.content("m.off"));

      std::shuffle(points.begin(), points.end(), std::mt19937(7));
      folder.file("s.xyz", joined(points));
      const json shuffled = json::parse(folder.rbpa(std::string(ball) + "--watertight -o shuffled.off").out);
      for (const std::string key : {"triangles", "area", "filled", "component_list"}) {
        CAPTURE(key);
        CHECK(shuffled[key] == report[key]);
      }
      const Outcome turned = folder.rbpa(std::string(ball) + "--watertight --flip -o turned.off", 0);
      CHECK(turned.err.ends_with("\nrbpa: the largest component faces inward (--flip turns it around)\n"));
    }
  }

  TEST_CASE("triangles around holes that cannot be filled are removed if that closes the surface") {
    const Folder folder;
    // Lines of the file, so that they can be shuffled.
    std::istringstream mesh(read_file(RBPA_TEST_DATA "/m3_spot.off"));
    std::string word;
    std::size_t count = 0, faces = 0, edges = 0;
    mesh >> word >> count >> faces >> edges;
    std::vector<std::string> points(count);
    std::getline(mesh, word);
    for (std::string& point : points) std::getline(mesh, point);
    REQUIRE(points.size() > 500);
    folder.file("p.xyz", joined(points));
    const std::string run = "surface p.xyz --radius 0.1 --keep-largest 1 --json ";
    const json open = json::parse(folder.rbpa(run + "--fill-holes all -o open.off").out);
    CHECK(open["filled"]["left"]["crosses"].get<int>() > 0);
    CHECK(open["filled"]["given_up"] == 0);
    const Outcome outcome = folder.rbpa(run + "--watertight -o m.off", 0);
    const json report = json::parse(outcome.out);
    const auto given_up = report["filled"]["given_up"].get<int>();
    CHECK(given_up > 0);
    CHECK(contains(outcome.err, "\nrbpa: " + std::to_string(given_up) + " triangles around holes removed, so that"));
    // Each point is a vertex, unused, or lost with a component.
    CHECK(report["touching_points"] == 0);
    CHECK(report["vertices"].get<int>() + report["unused"].get<int>() + report["dropped"]["points"].get<int>() ==
          report["distinct"].get<int>());
    const auto& unused = report["unused_points"];
    const auto lost =
        std::count_if(unused.begin(), unused.end(), [](const json& u) { return u["cause"] == "given_up"; });
    CHECK(lost > 0);
    CHECK(contains(outcome.err, std::to_string(lost) + " whose triangles were removed to close the surface"));
    CHECK(report["filled"]["left"] ==
          json::parse(R"({"crosses": 0, "edge_taken": 0, "no_area": 0, "too_much_work": 0})"));
    CHECK(folder.meshtopo("m.off -q --check closed,manifold,components=1").code == 0);
    CHECK(report["triangles"].get<int>() == open["triangles"].get<int>() - open["filled"]["triangles"].get<int>() -
                                                given_up + report["filled"]["triangles"].get<int>());
    std::shuffle(points.begin(), points.end(), std::mt19937(3));
    folder.file("p.xyz", joined(points));
    const json shuffled = json::parse(folder.rbpa(run + "--watertight -o s.off").out);
    for (const std::string key : {"triangles", "area", "filled", "component_list"}) {
      CAPTURE(key);
      CHECK(shuffled[key] == report[key]);
    }
    // Most of the surface is never removed: here it would be two thirds.
    const Outcome plate = folder.rbpa(
        "surface " RBPA_TEST_DATA "/m3_plate_holes.off --radius auto --keep-largest 1 --watertight -o p.off", 1);
    CHECK(!contains(plate.err, "given up"));
  }

  TEST_CASE("a surface that cannot be closed is named, nothing is written, and the exit code is 1") {
    const Folder folder("t.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
    refuses(folder, "surface t.xyz --radius 1 --watertight --json -q -o m.ply", 1,
            "--watertight: 1 boundary curve left, 1 hole not filled: 1 where any filling crosses the surface, the "
            "longest of length 3.41421 with 3 edges at 0, 0, 0; nothing is written (--fill-holes all in its place "
            "fills what can be filled; --holes FILE shows the rest)");
    CHECK(!folder.has("m.ply"));
    const Outcome none = folder.rbpa("surface t.xyz --radius 0.1 --watertight -o m.ply", 1);
    CHECK(none.err.ends_with("\nrbpa: --watertight: there is no triangle; nothing is written\n"));
    // Both sides of a sheet are closed, and coincide.
    const Outcome sides = folder.rbpa("surface t.xyz --radius 1 --normals none --watertight -o m.ply", 1);
    CHECK(
        contains(sides.err, "1 pair of triangles cross, the first of points (0 1 2) and (0 2 1) at 0, 0, 0; nothing"));
    CHECK(!folder.has("m.ply"));
  }

  TEST_CASE("wrong choices of holes are refused before anything is read") {
    const Folder folder;
    for (const std::string text : {"2", "0", "3.5", "-1", "some", "length=", "length=0", "length=nan", "length=2x"})
      refuses(folder, "surface p.xyz --radius 1 -o m.off --fill-holes=" + text, 2,
              "--fill-holes: found '" + text +
                  "', expected all, rims, a number of edges from 3, such as 30, or a length, such as length=2.5");
    CHECK(folder.rbpa("surface p.xyz --radius 1 -o m.off --fill-holes all --watertight").err ==
          "rbpa: --fill-holes cannot be combined with --watertight, which fills all holes\n");
    CHECK(folder.rbpa("surface p.xyz --radius 1 -o m.off --fill-holes all --normals none").err ==
          "rbpa: --fill-holes cannot be combined with --normals none, whose triangles have no boundary\n");
  }
}
