// `rbpa alpha --dimension 3`: births and deaths of components, tunnels and voids.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

std::string sphere(int count) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < count; ++i) {
    const double z = (2.0 * i + 1) / count - 1, r = std::sqrt(1 - z * z);
    text << r * std::cos(2.4 * i) << ' ' << r * std::sin(2.4 * i) << ' ' << z << '\n';
  }
  return text.str();
}

}  // namespace

TEST_SUITE("space alpha") {
  TEST_CASE("a sphere has one lasting void, in text, JSON and CSV") {
    const Folder folder("s.xyz", sphere(500));
    const Outcome text = folder.rbpa("alpha s.xyz --dimension 3 -q", 0);
    CHECK(text.out.starts_with("500 points\nmin "));
    CHECK(contains(text.out, "; those that last longest, death - birth:\n"));
    const json report =
        json::parse(folder.rbpa("alpha s.xyz --dimension 3 --json --persistence --stats t.json -q", 0).out);
    CHECK(report["points"] == 500);
    CHECK(report["components"] == 500);
    double longest = 0;
    for (const json& pair : report["pairs"])
      if (pair["dimension"] == 2)
        longest = std::max(longest, pair["death"].get<double>() / pair["birth"].get<double>());
    CHECK(longest > 5);
    CHECK(report["pairs"].size() == report["components"].get<std::size_t>() + report["tunnels"].get<std::size_t>() +
                                        report["voids"].get<std::size_t>());
    CHECK(json::parse(folder.content("t.json"))["seconds"]["build"].get<double>() > 0);
    const Outcome csv = folder.rbpa("alpha s.xyz --dimension 3 --csv -q");
    CHECK(csv.out.starts_with("dimension,birth,death\n0,0,"));
    CHECK(static_cast<std::size_t>(std::count(csv.out.begin(), csv.out.end(), '\n')) == report["pairs"].size() + 1);
    CHECK(!json::parse(folder.rbpa("alpha s.xyz --dimension 3 --json -q").out).contains("pairs"));
    // `rbpa solid` chooses the same radii.
    const Outcome solid = folder.rbpa("solid s.xyz --alpha auto --json -q");
    CHECK(json::parse(solid.out)["alpha"] == report["auto"]);
    REQUIRE(!report["plateaus"].empty());
    const json plateau = json::parse(folder.rbpa("solid s.xyz --alpha plateau --json -q").out);
    CHECK(plateau["alpha"] == report["plateaus"][0]["alpha"]);
    CHECK(plateau["tetrahedra"] == report["plateaus"][0]["tetrahedra"]);
    CHECK(contains(text.out, "\nplateau "));
    const json share = json::parse(folder.rbpa("alpha s.xyz --dimension 3 --cover 0.9 --json -q").out);
    CHECK(share["auto"] < report["auto"]);
    CHECK(json::parse(folder.rbpa("solid s.xyz --alpha auto --cover 0.9 --json -q").out)["alpha"] == share["auto"]);
    CHECK(json::parse(folder.rbpa("solid s.xyz --alpha min --cover 0.9 --json -q").out)["alpha"] == share["min"]);
    CHECK(
        contains(folder.rbpa("solid s.xyz --alpha 1 --cover 0.9").err, "--cover applies only to --alpha auto or min"));
  }

  TEST_CASE("representatives are files of lines and triangles, and the diagram is a picture") {
    const Folder folder("s.xyz", sphere(300));
    REQUIRE(folder.rbpa("alpha s.xyz --dimension 3 --representatives r.json --top 4 -o plot.svg -q").code == 0);
    const json all = json::parse(folder.content("r.json"));
    REQUIRE(all.size() == 9);  // there is one void
    for (const json& one : all) {
      if (one["dimension"] == 2) {
        CHECK(one["volume"].get<double>() > 0);
        CHECK(one["triangles"].size() >= 4);
        continue;
      }
      CHECK(one["edges"].size() >= (one["dimension"] == 1 ? 3u : one["death"].is_null() ? 0u : 1u));
    }
    // The inside of the ball.
    CHECK(std::any_of(all.begin(), all.end(), [](const json& one) {
      return one["dimension"] == 2 && one["volume"].get<double>() > 3.9 && one["volume"].get<double>() < 4.19;
    }));
    const std::string plot = folder.content("plot.svg");
    for (const char* name : {"components", "tunnels", "voids", "min = ", "auto = "}) CHECK(contains(plot, name));
    REQUIRE(folder.rbpa("alpha s.xyz --dimension 3 --representatives r.obj --top 4 -q").code == 0);
    const std::string obj = folder.content("r.obj");
    for (const char* name : {"g component_3\n", "g tunnel_4\n", "g void_1\n", "\nl 1 2\n", "\nf "})
      CHECK(contains(obj, name));
    REQUIRE(folder.rbpa("alpha s.xyz --dimension 3 --representatives r.vtu --min-persistence 0.1 -q").code == 0);
    CHECK(contains(folder.content("r.vtu"), "Name=\"death\""));
    REQUIRE(folder.rbpa("alpha s.xyz --dimension 3 --representatives none.json --min-persistence 5 -q").code == 0);
    CHECK(json::parse(folder.content("none.json")).size() == 1);  // the component that never ends
  }

  TEST_CASE("points in a plane, on a line and a single one have the answer of the plane") {
    const Folder folder;
    for (const std::string name : {"coplanar.xyz", "two.xyz"})
      folder.file(name, read_file(RBPA_TEST_DATA "/findings/case_coplanar_persistence/" + name));
    folder.file("line.xyz", "0 0 0\n3 3 3\n1 1 1\n0 0 0\n");
    folder.file("one.xyz", "1 2 3\n1 2 3\n");
    std::string level, plane;
    for (int i = 0; i < 63; ++i) {
      plane += std::to_string(i % 9) + " " + std::to_string(i * i % 7) + "\n";
      level += std::to_string(i % 9) + " " + std::to_string(i * i % 7) + " 0\n";
    }
    folder.file("plane.xy", plane);
    folder.file("level.xyz", level);
    const auto pairs_of = [&](const std::string& command) {
      std::vector<std::array<double, 3>> pairs;
      const json report = json::parse(folder.rbpa("alpha " + command + " --json --persistence -q", 0).out);
      for (const json& pair : report["pairs"])
        pairs.push_back({pair["dimension"].get<double>(), pair["birth"].get<double>(),
                         pair["death"].is_null() ? -1 : pair["death"].get<double>()});
      std::sort(pairs.begin(), pairs.end());
      return pairs;
    };
    using Pairs = std::vector<std::array<double, 3>>;
    CHECK(pairs_of("coplanar.xyz --dimension 3") ==
          Pairs{{0, 0, -1}, {0, 0, 0.5}, {0, 0, 0.5}, {0, 0, 0.5}, {1, 0.5, 0.7071067811865476}});
    CHECK(pairs_of("two.xyz --dimension 3") == Pairs{{0, 0, -1}, {0, 0, 0.5}});
    CHECK(pairs_of("line.xyz --dimension 3").size() == 3);
    CHECK(pairs_of("one.xyz --dimension 3") == Pairs{{0, 0, -1}});
    CHECK(pairs_of("level.xyz --dimension 3") == pairs_of("plane.xy --complex full"));
    const Outcome text = folder.rbpa("alpha coplanar.xyz --dimension 3 -q");
    CHECK(contains(text.out, "min inf, auto inf: there is no tetrahedron, as all points are in a plane\n1 tunnel;"));
    CHECK(contains(folder.rbpa("alpha two.xyz --dimension 3 -q").out, "as there are fewer than four distinct points"));
    REQUIRE(folder.rbpa("alpha coplanar.xyz --dimension 3 --representatives r.json -o p.svg -q").code == 0);
    const json all = json::parse(folder.content("r.json"));
    REQUIRE(all.size() == 5);
    CHECK(all[4]["edges"].size() == 4);
  }

  TEST_CASE("balls have births and deaths as powers; with radii 0 these are the squares of the radii of points") {
    const Folder folder;
    folder.file("two.csv", "x,y,z,r\n0,0,0,3\n0,0,5,2\n0,0,0.5,1\n");  // two balls that touch, one within
    const std::string balls = " --dimension 3 --radii column:r -q ";
    CHECK(folder.rbpa("alpha two.csv --csv" + balls).out == "dimension,birth,death\n0,-9,\n0,-4,0\n");
    const json report = json::parse(folder.rbpa("alpha two.csv --json --persistence" + balls).out);
    CHECK(report["balls"] == 3);
    CHECK(report["hidden"] == 1);
    CHECK(report["components"] == 2);
    CHECK(report["pairs"][1] == json{{"dimension", 0}, {"birth", -4.0}, {"death", 0.0}});
    CHECK(report["radii"][0]["greatest"] == 3);
    CHECK(folder.rbpa("alpha two.csv" + balls).out ==
          "3 points, 3 kept; 1 without a cell\nradii: 1 to 3 (3, file)\n0 tunnels\n0 voids\n");
    folder.file("s.xyz", sphere(200));
    // Pairs of nearly equal radii may change places.
    const auto ends = [&](const std::string& options, int dimension, bool squared) {
      std::vector<double> values;
      const json all = json::parse(folder.rbpa("alpha s.xyz --json --persistence -q " + options).out)["pairs"];
      for (const json& pair : all)
        for (const char* end : {"birth", "death"})
          if (pair["dimension"] == dimension && !pair[end].is_null()) values.push_back(pair[end]);
      if (squared)
        for (double& value : values) value *= value;
      std::sort(values.begin(), values.end());
      return values;
    };
    for (int dimension = 0; dimension < 3; ++dimension) {
      const std::vector<double> points = ends("--dimension 3", dimension, true),
                                powers = ends("--dimension 3 --radii bondi --radius-default 0", dimension, false);
      REQUIRE(points.size() > 1);
      REQUIRE(powers.size() == points.size());
      for (std::size_t i = 0; i < points.size(); ++i) CHECK(std::abs(powers[i] - points[i]) <= 1e-15 * points[i]);
    }
  }

  TEST_CASE("options without meaning in space are refused") {
    const Folder folder("s.xyz", sphere(20));
    const auto refuses = [&](const std::string& options, int code, const std::string& message) {
      says(folder, "alpha " + options, code, message);
    };
    refuses("s.xyz --dimension 4", 2, "--dimension: found '4', expected 2 or 3");
    refuses("s.xyz --dimension 3 -o plot.png", 2, "plot.png: found the ending 'png', expected svg");
    refuses("s.xyz --dimension 3 --representatives r.geojson", 2,
            "--representatives: found the ending 'geojson', expected one of obj, json, vtu");
    refuses("s.xyz --dimension 3 --representatives r.obj --levels hrbpa", 2, "--levels applies only to --dimension 2");
    refuses("s.xyz --dimension 3 --top 3", 2, "--top requires --representatives");
    refuses("s.xyz --dimension 3 --representatives r.obj --top 0", 2, "--top: found '0'");
    refuses("s.xyz --dimension 3 --representatives r.obj --min-persistence -1", 2, "--min-persistence: found '-1'");
    refuses("s.xyz --dimension 3 --complex full --persistence", 2, "--complex applies only to --dimension 2");
    refuses("s.xyz --dimension 3 --cover 2", 2, "--cover: found '2'");
    refuses("s.xyz --dimension 3 --components 2", 2, "--components applies only to --dimension 2");
    refuses("missing.xyz --dimension 3", 3, "missing.xyz");
    refuses("s.xyz --radii bondi", 2, "--radii applies only to --dimension 3");
    refuses("s.xyz --dimension 3 --radius-default 1", 2, "--radius-default requires --radii");
    refuses("s.xyz --dimension 3 --radii bondi --radius-default x", 2, "--radius-default: found 'x'");
    refuses("s.xyz --dimension 3 --radii bondi", 3, "s.xyz:");
    for (const char* option :
         {"--representatives r.obj", "-o p.svg", "--cover 0.5", "--columns 1,2,3", "--stats s.json"})
      refuses("s.xyz --dimension 3 --radii bondi " + std::string(option), 2, "cannot be combined with --radii");
  }
}
