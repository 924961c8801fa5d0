// --suggest-repairs of `rbpa surface`: the suggested repair of a hole closes it.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

struct Line {
  double x, y, z;
  bool is_turned = false;
};

/// Returns a sphere of radius 1 without the part above `top`, with the normal of one point turned around.
std::vector<Line> sphere_lines(double top, int wrong) {
  std::vector<Line> lines;
  int number = 0;
  for (const auto& [x, y, z] : rbpa_test::spiral(600)) {
    if (z <= top) lines.push_back({x, y, z, number == wrong});
    ++number;
  }
  return lines;
}

std::string text_of(const std::vector<Line>& lines) {
  std::ostringstream text;
  text.precision(17);
  for (const Line& line : lines) {
    const double sign = line.is_turned ? -1 : 1;
    text << line.x << ' ' << line.y << ' ' << line.z << ' ' << sign * line.x << ' ' << sign * line.y << ' '
         << sign * line.z << '\n';
  }
  return text.str();
}

std::vector<json> repairs_of(const json& report) {
  std::vector<json> repairs;
  for (const json& hole : report["holes"]) repairs.push_back(hole["suggested_repair"]);
  return repairs;
}

/// The numbers of repairs by a ball, and by turned normals.
struct Named {
  double radius = 0;
  int point = -1;
};

Named named(const json& report) {
  Named result;
  for (const json& repair : repairs_of(report)) {
    if (repair["kind"] == "larger_ball") result.radius = repair["radius"].get<double>();
    if (repair["kind"] == "turn_normals") result.point = repair["points"].at(0).get<int>();
  }
  return result;
}

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("each hole has a suggested repair, which closes it") {
    const Folder folder;
    std::vector<Line> lines = sphere_lines(0.93, 300);
    folder.file("s.xyz", text_of(lines));
    const Outcome outcome = folder.rbpa("surface s.xyz --radius 0.13 --suggest-repairs --json -o m.off", 0);
    const json report = json::parse(outcome.out);
    CHECK(report["suggested_repairs"] ==
          json::parse(R"({"turn_normals": 1, "larger_ball": 1, "filling": 0, "none": 0})"));
    const Named found = named(report);
    REQUIRE(found.point >= 0);
    REQUIRE(found.radius > 0.13);
    CHECK(lines[static_cast<std::size_t>(found.point)].is_turned);
    const std::string radii = "0.13," + json(found.radius).dump();
    CHECK(contains(outcome.err, "; closed by --radius " + radii + "\n"));
    CHECK(
        contains(outcome.err, "; closed with the normal of point " + std::to_string(found.point) + " turned around\n"));

    lines[static_cast<std::size_t>(found.point)].is_turned = false;
    folder.file("s.xyz", text_of(lines));
    const json closed =
        json::parse(folder.rbpa("surface s.xyz --radius " + radii + " --suggest-repairs --json -o m.off").out);
    CHECK(closed["boundary_curves"] == 0);
    CHECK(closed["suggested_repairs"] ==
          json::parse(R"({"turn_normals": 0, "larger_ball": 0, "filling": 0, "none": 0})"));
    const json without = json::parse(folder.rbpa("surface s.xyz --radius 0.13 --json -o m.off").out);
    CHECK(without["suggested_repairs"].is_null());
    CHECK(!without["holes"][0].contains("suggested_repair"));
  }

  TEST_CASE("repairs name points of the file also without outliers, and stay if components are dropped") {
    const Folder folder;
    const std::vector<Line> lines = sphere_lines(1, 300);
    folder.file("s.xyz", "9 9 9 0 0 1\n" + text_of(lines));
    const json report = json::parse(
        folder
            .rbpa("surface s.xyz --radius 0.15 --drop-outliers auto --keep-largest 1 --suggest-repairs --json -o m.off")
            .out);
    REQUIRE(report["outliers"]["points"] == 1);
    REQUIRE(repairs_of(report).size() == 1);
    CHECK(repairs_of(report)[0] == json::parse(R"({"kind": "turn_normals", "points": [301]})"));
  }

  TEST_CASE("rims have no suggested repair, a hole in a sheet is closed by a ball, and wrong usage is refused") {
    const Folder folder;
    std::string sheet;
    for (int x = 0; x < 8; ++x)
      for (int y = 0; y < 8; ++y)
        if (x < 3 || x > 4 || y < 3 || y > 4) sheet += std::to_string(x) + " " + std::to_string(y) + " 0 0 0 1\n";
    folder.file("p.xyz", sheet);
    const json report = json::parse(folder.rbpa("surface p.xyz --radius 0.8 --suggest-repairs --json -o m.off").out);
    REQUIRE(report["holes"].size() == 2);
    for (const json& hole : report["holes"]) {
      CHECK(hole["suggested_repair"].is_null() == (hole["kind"] == "rim"));
      if (hole["kind"] == "hole") CHECK(hole["suggested_repair"]["kind"] == "larger_ball");
    }
    const Outcome many = folder.rbpa("surface p.xyz --radius 0.8 --suggest-repairs --fill-holes all -o m.off", 2);
    CHECK(
        many.err ==
        "rbpa: --suggest-repairs cannot be combined with --fill-holes or --watertight, which close holes themselves\n");
    CHECK(folder.rbpa("surface p.xyz --radius 0.8 --suggest-repairs --watertight -o m.off").code == 2);
    CHECK(folder.rbpa("surface p.xyz --radius 0.8 --suggest-repairs --normals none -o m.off").err ==
          "rbpa: --suggest-repairs cannot be combined with --normals none, whose triangles have no boundary\n");
  }
}
