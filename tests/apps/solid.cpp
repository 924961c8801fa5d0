// `rbpa solid`: files, messages, wrong usage, bad input, a signal.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// A grid of 5 × 5 × 5 points without the one in the middle.
std::string hollow_cube() {
  std::string text;
  for (int i = 0; i < 125; ++i)
    if (i != 62) text += std::to_string(i % 5) + " " + std::to_string(i / 5 % 5) + " " + std::to_string(i / 25) + "\n";
  return text;
}

using Row = std::array<std::uint32_t, 4>;

/// Reads rows of numbers after a line; takes four of each from `at`, less 1.
std::vector<Row> rows_behind(const std::string& text, const std::string& line, std::size_t numbers, std::size_t at) {
  std::istringstream in(text.substr(text.find(line) + line.size()));
  std::size_t count = 0;
  in >> count;
  std::vector<Row> rows(count);
  for (Row& row : rows) {
    std::vector<std::uint32_t> all(numbers);
    for (std::uint32_t& number : all) in >> number;
    for (std::size_t k = 0; k < 4; ++k) row[k] = all[at + k] - 1;
  }
  CHECK(in.good());
  return rows;
}

}  // namespace

TEST_SUITE("solid") {
  TEST_CASE("every format has the same tetrahedra, and statistics are those of the cube and its void") {
    const Folder folder("c.xyz", hollow_cube());
    const Outcome outcome = folder.rbpa(
        "solid c.xyz --alpha 0.9 -o t.npy -o t.vtu -o t.mesh -o t.msh -o t.png --width 200 --boundary b.ply --stats "
        "s.json",
        0);
    CHECK(outcome.out.empty());
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["points"] == 124);
    CHECK(stats["isolated"] == 0);
    CHECK(stats["alpha"] == 0.9);
    CHECK(stats["solid_components"] == 1);
    CHECK(stats["betti"] == json({1, 0, 1}));
    // The eight cubes around the middle lack a corner, and the tetrahedra at it.
    const double volume = stats["volume"];
    CHECK(volume > 56);
    CHECK(volume < 64);
    for (const char* part : {"read", "build", "count", "write"}) CHECK(stats["seconds"][part] >= 0);
    const std::vector<Row> rows = npy_rows<Row>(folder.content("t.npy"));
    CHECK(rows.size() == stats["tetrahedra"]);
    CHECK(std::is_sorted(rows.begin(), rows.end()));
    CHECK(rows_behind(folder.content("t.mesh"), "\nTetrahedra\n", 5, 0) == rows);
    CHECK(rows_behind(folder.content("t.msh"), "$Elements\n", 9, 5) == rows);
    CHECK(contains(folder.content("t.mesh"), "\nVertices\n124\n0 0 0 0\n1 0 0 0\n"));
    CHECK(contains(folder.content("t.msh"), "$Nodes\n124\n1 0 0 0\n2 1 0 0\n"));
    const std::string vtu = folder.content("t.vtu");
    CHECK(contains(vtu, "NumberOfCells=\"" + std::to_string(rows.size()) + "\""));
    CHECK(contains(vtu, std::string(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row))));
    CHECK(folder.content("t.png").starts_with("\x89PNG"));
    CHECK(contains(outcome.err, "1 solid component, 0 tunnels, 1 void, volume "));
    CHECK(outcome.err.ends_with(" -> t.npy, t.vtu, t.mesh, t.msh, t.png, b.ply\n"));
  }

  TEST_CASE("the boundary is closed and without defects, also if the solid touches itself") {
    const Folder folder;
    // Two tetrahedra with a common edge, given twice, and one that has a point in common with the second.
    folder.file("c.xyz",
                "0 0 -1\n0 0 1\n2 1 0\n2 -1 0\n-2 1 0\n-2 -1 0\n0 0 -1\n0 0 1\n"
                "3 3 1\n3 3 -1\n4 2 0\n");
    REQUIRE(folder.rbpa("solid c.xyz --alpha 1.5 -o t.npy --boundary b.ply --stats s.json").code == 0);
    CHECK(npy_rows<Row>(folder.content("t.npy")) == std::vector<Row>{{0, 1, 3, 2}, {0, 1, 4, 5}, {2, 8, 10, 9}});
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["points"] == 11);
    CHECK(stats["distinct"] == 9);
    CHECK(stats["solid_components"] == 3);
    CHECK(stats["betti"] == json({1, 0, 0}));
    CHECK(stats["edges"] == 17);
    CHECK(folder.meshtopo("b.ply --check closed,manifold,components=3,genus=0").code == 0);
    REQUIRE(folder.rbpa("solid c.xyz --alpha 1.5 --boundary b.npy -q").code == 0);
    CHECK(contains(folder.content("b.npy"), "'shape': (12, 3)"));
  }

  TEST_CASE("JSON has each component and each void") {
    const Folder folder("c.xyz", hollow_cube());
    const Outcome outcome = folder.rbpa("solid c.xyz --alpha 0.9 --json -q", 0);
    CHECK(outcome.err.empty());
    const json report = json::parse(outcome.out);
    REQUIRE(report["void_list"].size() == 1);
    REQUIRE(report["solid_component_list"].size() == 1);
    CHECK(report["solid_component_list"][0]["volume"] == report["volume"]);
    CHECK(double(report["void_list"][0]["volume_between_points"]) + double(report["volume"]) == 64);
    CHECK(report["void_list"][0]["points"].size() >= 6);
    CHECK(report["void_list"][0]["islands"] == 0);
    CHECK(report["solid_component_list"][0]["box"] == json({{0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}}));
    CHECK(json::parse(folder.rbpa("solid c.xyz --alpha inf --json -q").out)["alpha"] == "inf");
  }

  TEST_CASE("order and threads change no tetrahedron, and columns and conditions choose the points") {
    const Folder folder;
    folder.file(
        "c.csv", "x,y,z,class\n" + [] {
          std::string text = hollow_cube();
          std::replace(text.begin(), text.end(), ' ', ',');
          std::string lines;
          for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
            lines += text.substr(at, end - at) + ",1\n";
          return lines + "2,2,2,7\n";
        }());
    folder.file("c.xyz", hollow_cube());
    REQUIRE(folder.rbpa("solid c.csv --where 'class == 1' --alpha 0.9 -o a.npy --threads 1").code == 0);
    REQUIRE(folder.rbpa("solid c.xyz --alpha 0.9 -o b.npy --threads 2").code == 0);
    CHECK(folder.content("a.npy") == folder.content("b.npy"));
  }

  TEST_CASE("rules choose alpha: the least that covers every point, and the least that connects them") {
    const Folder folder;
    std::string points = hollow_cube();
    for (const int x : {50, 51})
      for (const int y : {0, 1})
        for (const int z : {0, 1})
          points += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    folder.file("c.xyz", points);
    std::vector<double> chosen;
    for (const std::string rule : {"min", "auto"}) {
      const Outcome outcome = folder.rbpa("solid c.xyz --alpha " + rule + " -o a.npy --stats s.json", 0);
      const json stats = json::parse(folder.content("s.json"));
      CHECK(stats["alpha_rule"] == rule);
      CHECK(stats["isolated"] == 0);
      CHECK(stats["seconds"]["choose"] >= 0);
      chosen.push_back(stats["alpha"]);
      CHECK(outcome.err.starts_with("rbpa: 132 points, alpha " + rule + " = "));
      CHECK((stats["betti"][0] == 1) == (rule == "auto"));
      REQUIRE(folder.rbpa("solid c.xyz --alpha " + stats["alpha"].dump() + " -o b.npy -q").code == 0);
      CHECK(folder.content("a.npy") == folder.content("b.npy"));
    }
    CHECK(chosen[0] == 0.8660254037844387);  // half the diagonal of a cube
    CHECK(chosen[1] > 20);
    CHECK(json::parse(folder.rbpa("solid c.xyz --alpha 1 --json -q").out)["alpha_rule"] == "given");
  }

  TEST_CASE("balls around the points have a volume and an area, in a plane as well") {
    const Folder folder("two.xyz", "0 0 0\n1 0 0\n");
    const Outcome outcome = folder.rbpa("solid two.xyz --alpha 1 --balls --json", 0);
    const json report = json::parse(outcome.out);
    CHECK(report["balls"]["volume"] == doctest::Approx(7.0685834705770345));
    CHECK(report["balls"]["area"] == doctest::Approx(18.849555921538759));
    CHECK(contains(outcome.err, "; union of balls: volume 7.06858, area 18.8496"));
    CHECK_FALSE(json::parse(folder.rbpa("solid two.xyz --alpha 1 --json -q").out).contains("balls"));
    refuses(folder, "solid two.xyz --alpha inf --balls --json", 2, "--balls requires a finite --alpha");
  }

  TEST_CASE("the reason for an empty solid is printed") {
    const Folder folder;
    const auto says = [&](const std::string& points, const std::string& alpha, const std::string& why) {
      folder.file("p.xyz", points);
      const Outcome outcome = folder.rbpa("solid p.xyz --alpha " + alpha + " -o t.npy --boundary b.stl", 0);
      CHECK(outcome.err.starts_with("rbpa: there is no tetrahedron: " + why + "\n"));
      CHECK(npy_rows<Row>(folder.content("t.npy")).empty());
    };
    says("1 2 3\n", "inf", "fewer than four distinct points");
    says("0 0 0\n0 0 0\n1 0 0\n0 1 0\n", "inf", "fewer than four distinct points");
    says("0 0 0\n1 1 0\n1 0 0\n0 1 0\n", "inf", "all points are in a plane");
    says("0 0 0\n1 1 0\n1 0 0\n0 1 0\n", "auto", "all points are in a plane");
    says("0 0 0\n1 1 0\n1 0 0\n0 1 0\n", "1 --pockets p.csv", "all points are in a plane");
    says("0 0 0\n1 1 1\n1 0 0\n0 1 0\n", "0.1", "none has circumradius <= 0.1 (a larger --alpha may have some)");
  }

  TEST_CASE("wrong usage and bad input are refused in a line, and nothing is written") {
    const Folder folder({{"c.xyz", hollow_cube()}, {"bad.xyz", "0 0 0\n1 0 zero\n"}});
    const std::string radius = "expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K";
    refuses(folder, "solid c.xyz --alpha 0 -o t.npy", 2, "--alpha: found '0', " + radius);
    refuses(folder, "solid c.xyz --alpha=-1 -o t.npy", 2, "--alpha: found '-1', " + radius);
    refuses(folder, "solid c.xyz --alpha=-inf -o t.npy", 2, "--alpha: found '-inf', " + radius);
    refuses(folder, "solid c.xyz --alpha nan -o t.npy", 2, "--alpha: found 'nan', " + radius);
    refuses(folder, "solid c.xyz --alpha convex -o t.npy", 2, "--alpha: found 'convex', " + radius);
    refuses(folder, "solid c.xyz --alpha plateau:0 -o t.npy", 2, "--alpha: found 'plateau:0', " + radius);
    refuses(folder, "solid c.xyz --alpha plateau:99 -o t.npy", 2,
            "--alpha plateau:99: there is only 1 plateau (rbpa alpha POINTS --dimension 3 lists them)");
    refuses(folder, "solid c.xyz --alpha plateau --box 9 -o t.npy", 2,
            "--alpha plateau cannot be combined with --box (give a radius, auto or min)");
    refuses(folder, "solid c.xyz --alpha 1 -o t.ply", 2,
            "t.ply: found the ending 'ply', expected one of npy, vtu, msh, mesh, png, or --output-format");
    refuses(folder, "solid c.xyz --alpha 1 --boundary t.png", 2,
            "--boundary: found the ending 'png', expected one of off, ply, obj, stl, npy, glb, vtu");
    refuses(folder, "solid c.xyz --alpha 1", 2, "-o: found no OUT, expected at least one (or --stats FILE)");
    refuses(folder, "solid bad.xyz --alpha 1 -o t.npy", 3,
            "bad.xyz:2: found 'zero', expected a number" + skipping_hint);
  }
}
