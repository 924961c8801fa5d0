// `rbpa solid --voids`: the voids as surfaces, JSON and a table.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// A grid of 7 × 7 × 7 points without some: one alone, two that are neighbors, and two across a diagonal.
std::string hollow_cube() {
  const std::vector<std::array<int, 3>> missing = {{1, 1, 1}, {3, 5, 1}, {4, 5, 1}, {3, 3, 4}, {4, 4, 5}};
  std::string text;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y)
      for (int z = 0; z < 7; ++z)
        if (std::count(missing.begin(), missing.end(), std::array{x, y, z}) == 0)
          text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  return text;
}

using Position = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

double volume(const std::vector<Position>& at, const std::vector<Triangle>& triangles) {
  double six = 0;
  for (const auto& [i, j, k] : triangles) {
    const Position &a = at[i], &b = at[j], &c = at[k];
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6;
}

/// Returns whether each side of a triangle belongs to one other triangle, in the opposite direction.
bool is_closed(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  for (const auto& [side, count] : sides)
    if (count != 1 || !sides.contains({side.second, side.first})) return false;
  return true;
}

struct Obj {
  std::vector<Position> vertices;
  std::vector<std::string> names;
  std::vector<std::vector<Triangle>> groups;
};

Obj read_obj(const std::string& text) {
  Obj obj;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("g ")) {
      obj.names.push_back(line.substr(2));
      obj.groups.emplace_back();
    } else if (line.starts_with("v ")) {
      Position& p = obj.vertices.emplace_back();
      REQUIRE(std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3);
    } else {
      Triangle& t = obj.groups.back().emplace_back();
      REQUIRE(std::sscanf(line.c_str(), "f %u %u %u", &t[0], &t[1], &t[2]) == 3);
      for (std::uint32_t& vertex : t) REQUIRE(--vertex < obj.vertices.size());
    }
  }
  return obj;
}

}  // namespace

TEST_SUITE("solid voids") {
  TEST_CASE("each void is a closed surface with its volume, in every format, the largest first") {
    const Folder folder("c.xyz", hollow_cube());
    std::vector<Position> points;
    std::istringstream in(hollow_cube());
    for (Position p{}; in >> p[0] >> p[1] >> p[2];) points.push_back(p);
    const Outcome outcome =
        folder.rbpa("solid c.xyz --alpha 0.9 --voids v.obj --json --boundary b.ply -o t.npy --stats s.json", 0);
    CHECK(contains(outcome.err, "-> t.npy, b.ply, v.obj\n"));
    for (const char* name : {"v.json", "v.csv"})
      REQUIRE(folder.rbpa(std::string("solid c.xyz --alpha 0.9 -q --voids ") + name).code == 0);
    const json expected = json::parse(outcome.out)["void_list"], found = json::parse(folder.content("v.json"));
    REQUIRE(expected.size() >= 3);
    REQUIRE(found.size() == expected.size());
    const Obj obj = read_obj(folder.content("v.obj"));
    REQUIRE(obj.groups.size() == expected.size());
    std::istringstream csv(folder.content("v.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(
        line ==
        "number,volume_between_points,volume_outside_balls,area,islands,points,low_x,low_y,low_z,high_x,high_y,high_z");
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(i);
      const double inside = expected[i]["volume_between_points"].get<double>();
      for (const char* key : {"volume_between_points", "volume_outside_balls", "area", "islands", "box", "points"})
        CHECK(found[i][key] == expected[i][key]);
      CHECK(obj.names[i] == "void_" + std::to_string(i + 1));
      CHECK(is_closed(obj.groups[i]));
      CHECK(volume(obj.vertices, obj.groups[i]) == doctest::Approx(inside));
      const auto triangles = found[i]["triangles"].get<std::vector<Triangle>>();
      CHECK(triangles.size() == obj.groups[i].size());
      CHECK(volume(points, triangles) == doctest::Approx(inside));
      REQUIRE(std::getline(csv, line));
      std::ostringstream row;
      row << i + 1 << ',' << expected[i]["volume_between_points"].dump();
      CHECK(line.starts_with(row.str().substr(0, row.str().find(".0"))));
      CHECK(std::count(line.begin(), line.end(), ',') == 11);
      if (i > 0) CHECK(inside <= expected[i - 1]["volume_between_points"].get<double>());
    }
    CHECK(!std::getline(csv, line));
  }

  TEST_CASE(
      "the full complex has the voids that its triangles separate, as closed surfaces, and Betti numbers of its own") {
    const Folder folder;
    // A tetrahedron with edges of √8: its triangles come at 1.633, and itself at 1.732. Around it a larger one, and a
    // point.
    folder.file("c.xyz", "1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n40 40 40\n40 42 40\n");
    Outcome outcome = folder.rbpa("solid c.xyz --alpha 1.7 --complex full --json --voids v.obj --stats s.json", 0);
    CHECK(contains(outcome.err, "0 tetrahedra, "));
    CHECK(!contains(outcome.err, "there is no tetrahedron"));
    CHECK(contains(outcome.err, "; full complex: 2 components, 0 tunnels, 1 void -> v.obj\n"));
    const json report = json::parse(outcome.out);
    CHECK(report["betti"] == json{0, 0, 0});
    CHECK(report["full"] == json{{"points", 6}, {"edges", 7}, {"triangles", 4}, {"betti", {2, 0, 1}}});
    REQUIRE(report["void_list"].size() == 1);
    CHECK(report["void_list"][0]["volume_between_points"].get<double>() == doctest::Approx(8.0 / 3));
    CHECK(report["void_list"][0]["islands"] == 0);
    CHECK(report["void_list"][0]["points"] == json{0, 1, 2, 3});
    const Obj obj = read_obj(folder.content("v.obj"));
    REQUIRE(obj.groups.size() == 1);
    CHECK(is_closed(obj.groups[0]));
    CHECK(volume(obj.vertices, obj.groups[0]) == doctest::Approx(8.0 / 3));
    CHECK(json::parse(folder.content("s.json"))["full"]["betti"] == json{2, 0, 1});
    // The solid has no void; with a rule for alpha the triangulation is the same.
    CHECK(json::parse(folder.rbpa("solid c.xyz --alpha 1.7 --json -q").out)["void_list"].empty());
    CHECK(folder.rbpa("solid c.xyz --alpha auto --complex full -q --json").code == 0);

    // An island: a point's neighborhood within a hollow cube of two walls.
    folder.file("cube.xyz", hollow_cube());
    outcome = folder.rbpa("solid cube.xyz --alpha 0.9 --complex full --json -q --voids v.json", 0);
    const json full = json::parse(outcome.out),
               solid = json::parse(folder.rbpa("solid cube.xyz --alpha 0.9 --json -q").out);
    CHECK(full["void_list"].size() >= solid["void_list"].size());
    CHECK(full["full"]["betti"][2] == full["void_list"].size());
    const json file = json::parse(folder.content("v.json"));
    for (std::size_t i = 0; i < file.size(); ++i)
      CHECK(file[i]["volume_between_points"] == full["void_list"][i]["volume_between_points"]);

    folder.file("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    outcome = folder.rbpa("solid flat.xyz --alpha 1 --complex full --json", 0);
    CHECK(json::parse(outcome.out)["full"]["betti"] == json({1, 0, 0}));
    CHECK(json::parse(folder.rbpa("solid flat.xyz --alpha 0.6 --complex full --json -q").out)["full"]["betti"] ==
          json({1, 1, 0}));
    outcome = folder.rbpa("solid c.xyz --alpha 1 --complex most", 2);
    CHECK(outcome.err == "rbpa: --complex: found 'most', expected solid or full\n");
  }

  TEST_CASE("requested voids are those of the full complex, which a ball cannot leave") {
    const Folder folder;
    // A ball at the center of C60 is 3.55 from all atoms, and passes no hexagon, which has no tetrahedron within 3.1.
    const std::string data = "'" RBPA_TEST_DATA "/findings/mol_04_c60/";
    for (const char* name : {"c60", "c60_rattled"}) {
      const std::string options = "solid " + data + name + ".xyz' --alpha 3.1 -q ";
      REQUIRE(folder.rbpa(options + "--voids v.json --pockets p.json").code == 0);
      const json voids = json::parse(folder.content("v.json"));
      REQUIRE(voids.size() == 1);
      CHECK(voids[0]["volume_between_points"] > 140);
      CHECK(voids[0]["volume_outside_balls"] > 0.3);  // a ball of radius 0.45, and little more
      CHECK(voids[0]["volume_outside_balls"] < 0.5);
      CHECK(json::parse(folder.content("p.json")).empty());
      REQUIRE(folder.rbpa(options + "--voids v.json --complex solid").code == 0);
      CHECK(json::parse(folder.content("v.json")).empty());
    }
    // Values tracked along a trajectory do not jump when a tetrahedron appears or disappears.
    std::istringstream in(read_file(RBPA_TEST_DATA "/findings/mol_04_c60/c60.xyz"));
    std::vector<Position> atoms;
    for (Position p{}; in >> p[0] >> p[1] >> p[2];) atoms.push_back(p);
    REQUIRE(atoms.size() == 60);
    std::mt19937 random(60);
    std::array<double, 2> before{};
    for (int frame = 0; frame < 40; ++frame) {
      std::ostringstream text;
      for (Position& p : atoms) {
        for (double& x : p) x += 0.02 * (double(random()) / 4294967296.0 - 0.5);
        text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
      }
      folder.file("frame.xyz", text.str());
      REQUIRE(folder.rbpa("solid frame.xyz --alpha 3 -q --voids v.json").code == 0);
      const json voids = json::parse(folder.content("v.json"));
      REQUIRE(voids.size() >= 1);
      const std::array<double, 2> now = {voids[0]["volume_between_points"], voids[0]["volume_outside_balls"]};
      if (frame > 0) {
        CHECK(now[0] == doctest::Approx(before[0]).epsilon(0.03));
        CHECK(now[1] == doctest::Approx(before[1]).epsilon(0.2));
      }
      before = now;
    }

    const std::string lysozyme = "solid '" RBPA_TEST_DATA "/mol3_2lyz.pdb' --where \"resname != 'HOH'\" --alpha 3.1 ";
    const Outcome outcome = folder.rbpa(lysozyme + "--voids v.csv");
    CHECK(contains(outcome.err, "; full complex: 1 component, 0 tunnels, 9 voids -> v.csv\n"));
    const std::string csv = folder.content("v.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 10);
    CHECK(contains(csv, "\n3,65.8055"));
    CHECK(contains(csv, "\n4,36.1008"));
    CHECK(contains(folder.rbpa(lysozyme + "--voids v.csv --complex solid").err, "5 voids, "));
    CHECK(folder.content("v.csv").starts_with("number,volume_between_points,area,"));

    // Points in a plane have no voids.
    folder.file("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    for (const char* files : {"--voids v.csv", "--voids v.json --void-radii --pockets p.csv", "--pockets p.json"}) {
      CAPTURE(files);
      CHECK(folder.rbpa(std::string("solid flat.xyz --alpha 1 ") + files).code == 0);
    }
  }

  TEST_CASE("without voids there is an empty list, a table without lines, and no group") {
    const Folder folder("c.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    for (const char* name : {"v.json", "v.csv", "v.obj"})
      REQUIRE(folder.rbpa(std::string("solid c.xyz --alpha inf -q --voids ") + name).code == 0);
    CHECK(folder.content("v.json") == "[]\n");
    CHECK(folder.content("v.csv") ==
          "number,volume_between_points,volume_outside_balls,area,islands,points,low_x,low_y,low_z,high_x,high_y,high_"
          "z\n");
    CHECK(folder.content("v.obj").empty());
  }

  TEST_CASE("voids have the radii at which they close and are filled, and pockets have mouths") {
    const Folder folder("c.xyz", hollow_cube());
    for (const char* complex : {"solid", "full"}) {
      CAPTURE(complex);
      const std::string options = std::string("solid c.xyz --alpha 0.9 -q --complex ") + complex;
      REQUIRE(folder.rbpa(options + " --voids v.json --void-radii --pockets p.json").code == 0);
      REQUIRE(folder.rbpa(options + " --voids v.csv --void-radii --pockets p.csv").code == 0);
      const json voids = json::parse(folder.content("v.json")), pockets = json::parse(folder.content("p.json"));
      REQUIRE(voids.size() >= 3);
      for (const json& hollow : voids) {
        CHECK(hollow["closes"] <= 0.9);
        CHECK(hollow["filled"] > 0.9);
      }
      for (const json& pocket : pockets) {
        CHECK(pocket["closes"] > 0.9);
        CHECK(pocket["closes"] < pocket["filled"]);
        CHECK(pocket["mouth"].size() == 3);
      }
      CHECK(contains(folder.content("v.csv"), ",high_z,closes,filled,depth\n"));
      const std::string table = folder.content("p.csv");
      CHECK(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')) == pockets.size() + 1);
      // The largest, and those above a volume.
      REQUIRE(folder.rbpa(options + " --voids v1.json --void-radii --top 1").code == 0);
      CHECK(json::parse(folder.content("v1.json")) == json::array({voids[0]}));
      const double second = voids[1]["volume_between_points"];
      REQUIRE(folder.rbpa(options + " --voids v2.json --void-radii --voids-above " + json(second).dump()).code == 0);
      for (const json& hollow : json::parse(folder.content("v2.json"))) CHECK(hollow["volume_between_points"] > second);
    }
    REQUIRE(folder.rbpa("solid c.xyz --alpha inf -q --voids none.csv --void-radii").code == 0);
    CHECK(folder.content("none.csv").ends_with(",filled,depth\n"));
    const auto refuses = [&](const std::string& options, const std::string& message) {
      says(folder, "solid c.xyz --alpha 0.9 " + options, 2, message);
    };
    refuses("--pockets p.obj", "--pockets: found the ending 'obj', expected one of json, csv");
    refuses("--void-radii", "--void-radii requires --voids FILE with one of the endings json, csv");
    refuses("--void-radii --voids v.obj", "--void-radii requires --voids FILE with one of the endings json, csv");
    refuses("--top 3", "--top requires --voids or --pockets");
    refuses("--voids v.csv --voids-above -1", "--voids-above: found '-1'");
    refuses("--box 4 --pockets p.csv", "--pockets cannot be combined with --box");
    refuses("--pockets p.csv --voids p.csv", "p.csv");
  }

  TEST_CASE("unknown endings and the names of other outputs are refused") {
    const Folder folder("c.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    Outcome outcome = folder.rbpa("solid c.xyz --alpha inf --voids v.ply", 2);
    CHECK(outcome.err == "rbpa: --voids: found the ending 'ply', expected one of obj, json, csv\n");
    outcome = folder.rbpa("solid c.xyz --alpha inf --voids v.obj --boundary v.obj", 2);
    CHECK(folder.names() == std::vector<std::string>{"c.xyz"});
  }
}
