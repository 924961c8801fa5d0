// `rbpa solid --box`: points of a periodic box.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Uniform points of a box of 10 with a rod along x left out.
std::string with_a_channel() {
  std::mt19937 random(5);
  const auto unit = [&] { return 10 * double(random()) / 4294967296.0; };
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < 6000; ++i) {
    const double x = unit(), y = unit(), z = unit();
    if (std::hypot(y - 5, z - 5) > 2.5) text << x << ' ' << y << ' ' << z << '\n';
  }
  return text.str();
}

std::string cube_of(int side) {
  std::ostringstream text;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) text << x << ' ' << y << ' ' << z << '\n';
  return text.str();
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_SUITE("solid box") {
  TEST_CASE("a channel is a void of dimension 1, in every report") {
    const Folder folder("c.xyz", with_a_channel());
    const Outcome outcome = folder.rbpa(
        "solid c.xyz --alpha 1.2 --box 10,10,10 --voids v.csv -o t.vtu -o t.npy -o t.png --boundary b.ply --json "
        "--stats s.json",
        0);
    CHECK(contains(outcome.err, "1 solid component, 0 closed voids, 1 void that percolates in 1 direction, volume "));
    CHECK(contains(outcome.err, "(voids of the full complex) -> t.vtu, t.npy, t.png, b.ply, v.csv\n"));
    const json report = json::parse(outcome.out), stats = json::parse(folder.content("s.json"));
    CHECK(report["box"] == json({10.0, 10.0, 10.0}));
    CHECK(report["betti"] == json({1, 3, 2, 0}));
    REQUIRE(report["void_list"].size() == 1);
    CHECK(report["complex"] == "full");
    CHECK(report["void_list"][0]["dimension"] == 1);
    const double between = report["void_list"][0]["volume_between_points"], volume = report["volume"];
    CHECK(between + volume == doctest::Approx(1000));
    CHECK(report["void_list"][0]["volume_outside_balls"] < between);
    CHECK(report["solid_component_list"][0]["dimension"] == 3);
    CHECK(stats["betti"] == report["betti"]);
    CHECK(stats["seconds"]["build"].get<double>() > 0);
    const std::string csv = folder.content("v.csv");
    CHECK(csv.starts_with("number,volume_between_points,volume_outside_balls,area,dimension,tetrahedra,points\n1,"));
    CHECK(lines(csv) == 2);
    REQUIRE(folder.rbpa("solid c.xyz --alpha 1.2 --box 10 -q --voids v.json").code == 0);
    CHECK(json::parse(folder.content("v.json")) == report["void_list"]);
    CHECK(folder.content("b.ply").starts_with("ply\n"));
    CHECK(folder.content("t.png").size() > 1000);
  }

  TEST_CASE("points moved by the sides of the box give the same tetrahedra, and inf gives all") {
    const Folder folder("near.xyz", cube_of(4));
    std::string far;
    std::istringstream in(cube_of(4));
    for (double x, y, z; in >> x >> y >> z;) {
      std::ostringstream line;
      line << x - 40 << ' ' << y + 4 << ' ' << z << '\n';
      far += line.str();
    }
    folder.file("far.xyz", far);
    for (const char* alpha : {"inf", "min", "auto", "1.5"}) {
      CAPTURE(alpha);
      for (const char* name : {"near", "far"}) {
        says(folder, std::string("solid ") + name + ".xyz --box 4 --alpha " + alpha + " -o " + name + ".npy", 0,
             "384 tetrahedra, 1 solid component, 0 closed voids, 0 voids that percolate, volume 64, area 0");
      }
      CHECK(folder.content("near.npy") == folder.content("far.npy"));
    }
  }

  TEST_CASE("a zeolite lets a sphere of 4.15 pass, and has a closed void in each cage above") {
    // LTA, 2 × 2 × 2 cells: a window of 8 oxygens, at alpha = 1.35 + 4.15 / 2, is the way from cage to cage; next
    // to each cage there is a small one.
    const Folder folder;
    const std::string oxygens = "'" RBPA_TEST_DATA "/findings/mol_03_zeolite_window/lta_O_2x2x2.xyz' --box 23.838 ";
    const auto voids = [&](const std::string& options) {
      REQUIRE(folder.rbpa("solid " + oxygens + "-q --voids v.json --alpha " + options).code == 0);
      std::vector<int> dimensions;
      for (const json& hollow : json::parse(folder.content("v.json"))) dimensions.push_back(hollow["dimension"]);
      return dimensions;
    };
    CHECK(voids("3.42") == std::vector<int>{3, 0, 0, 0, 0, 0, 0, 0, 0});
    CHECK(voids("3.43") == std::vector<int>(16, 0));
    CHECK(voids("5") == std::vector<int>(8, 0));
    CHECK(voids("6.1") == std::vector<int>(8, 0));
    CHECK(voids("6.1 --complex solid") == std::vector<int>{3});
    CHECK(contains(folder.rbpa("solid " + oxygens + "--alpha 5 --json").err, "8 closed voids, 0 voids that percolate"));
    CHECK(contains(
        folder.rbpa("solid " + oxygens + "--alpha 5 --json --complex solid").err,
        "0 closed voids, 1 void that percolates in 3 directions, volume 4070.27, area 2872.6 (voids of the solid)\n"));
  }

  TEST_CASE("a glass percolates up to the radius that a grid of distances shows, not up to that of its tetrahedra") {
    const Folder folder;
    const std::string glass = "'" RBPA_TEST_DATA "/findings/mol_03_zeolite_window/silica.npy' --box 35.8 ";
    const auto percolates = [&](const std::string& options) {
      REQUIRE(folder.rbpa("solid " + glass + "-q --voids v.json --alpha " + options).code == 0);
      for (const json& hollow : json::parse(folder.content("v.json")))
        if (hollow["dimension"] > 0) return true;
      return false;
    };
    CHECK(percolates("2.51"));
    CHECK(!percolates("2.511"));
    CHECK(percolates("2.511 --complex solid"));
  }

  TEST_CASE("a wrong box is refused, or warned of") {
    const Folder folder({{"c.xyz", cube_of(4)}, {"large.xyz", cube_of(6)}});
    const auto atom = [](int number, double x, const char* name) {
      char line[81];
      std::snprintf(line, sizeof line, "ATOM  %5d  CA  %s A %3d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", number,
                    name, number, x, 2.0, 3.5);
      return std::string(line);
    };
    folder.file("a.pdb", atom(1, 0, "ALA") + atom(2, 22.25, "GLY"));
    Outcome outcome = folder.rbpa("solid large.xyz --alpha 1 --box 2,6,6 --json", 0);
    CHECK(contains(outcome.err,
                   "large.xyz: points reach over 5 x 5 x 5, more than twice the box, which reaches over 2 x 6 x 6"));
    for (const std::string box : {"5", "2.5,6,6"})
      CHECK(!contains(folder.rbpa("solid large.xyz --alpha 1 --json --box " + box).err, "reach"));
    CHECK(folder.rbpa("solid large.xyz --alpha 1 --box 2,6,6 --json -q").err.empty());
    outcome = folder.rbpa("solid a.pdb --alpha 1.5 --box 10 -o t.npy", 3);
    CHECK(contains(outcome.err,
                   "a.pdb: atoms reach over 22.2 x 0 x 0, more than twice the box, which reaches over 10 x 10 x 10"));
    CHECK(!contains(outcome.err, "alpha is inf"));
    CHECK(contains(outcome.err,
                   "a ball with a radius of half of the box's least side, 10, has no point inside: expected more "
                   "points in the box; voids and counts at --alpha 1.5 need all tetrahedra"));
    outcome = folder.rbpa("solid a.pdb --alpha 3 --box 10 --where \"resname == 'DPP'\" --voids v.json", 3);
    CHECK(outcome.err.ends_with(
        "rbpa: a.pdb: found 0 atoms, expected at least one for --box (see --where and --waters)\n"));
    outcome = folder.rbpa("solid c.xyz --alpha 9 --box 4 --voids v.json", 0);
  }

  TEST_CASE("a sparse box has tetrahedra, but no counts") {
    const Folder folder("c.xyz", cube_of(4));
    const Outcome counted = folder.rbpa("solid c.xyz --box 40 --alpha 1 -o t.mesh", 3);
    CHECK(contains(
        counted.err,
        "voids and counts at --alpha 1 need all tetrahedra (--quiet writes those within --alpha without them)"));
    CHECK(!folder.has("t.mesh"));
    CHECK(folder.rbpa("solid c.xyz --box 40 --alpha 1 -o t.mesh -q").code == 0);
    CHECK(folder.has("t.mesh"));
  }

  TEST_CASE("--box auto is the cell of a molecule's file, and another box gives a warning") {
    const Folder folder;
    std::string atoms;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) {
          char line[64];
          std::snprintf(line, sizeof line, "ATOM      1  C   GLY A   1    %8.3f%8.3f%8.3f\n", 1.0 * x, 1.0 * y,
                        1.0 * z);
          atoms += line;
        }
    const auto cell = [](const char* angle) {
      return std::string("CRYST1    4.000    4.000    4.000  90.00  90.00  ") + angle + " P 1           1\n";
    };
    folder.file("m.pdb", cell("90.00") + atoms);
    folder.file("oblique.pdb", cell("60.00") + atoms);
    folder.file("none.pdb", atoms);
    const auto run = [&](const std::string& arguments) { return folder.rbpa("solid " + arguments + " --alpha 0.9"); };
    const Outcome of_file = run("m.pdb --box auto --json"), given = run("m.pdb --box 4 --json");
    CHECK(of_file.code == 0);
    CHECK(of_file.out == given.out);
    CHECK(of_file.err == given.err);
    CHECK(json::parse(of_file.out)["box"] == json{4.0, 4.0, 4.0});
    CHECK(run("m.pdb --box 5 -o t.npy")
              .err.find(
                  "rbpa: m.pdb: --box is not the cell of the file, which is 4 x 4 x 4 (--box auto uses that)\n") == 0);
    const Outcome oblique = run("oblique.pdb --box auto -o t.npy");
    CHECK(oblique.code == 3);
    CHECK(oblique.err ==
          "rbpa: oblique.pdb: found CRYST1 with angles of 90, 90 and 60 degrees, expected CRYST1 or _cell with right "
          "angles for --box auto (--box LX,LY,LZ gives the sides)\n");
    CHECK(contains(run("none.pdb --box auto -o t.npy").err, "none.pdb: found no cell, expected CRYST1"));
    folder.file("t.xyz", "0 0 0\n");
    CHECK(run("t.xyz --box auto -o t.npy").err ==
          "rbpa: --box auto: found a format without a cell, expected cif, dump, gro, pdb or pqr\n");
  }

  TEST_CASE("options that cannot be combined with --box are refused") {
    const Folder folder("c.xyz", cube_of(4));
    const auto refuses = [&](const std::string& options, const std::string& message) {
      says(folder, "solid c.xyz --alpha 1 " + options, 2, message);
    };
    for (const char* box : {"4,4", "4,4,4,4", "0", "-1,4,4", "4,,4", "inf", "4,4,x", ","})
      refuses(std::string("--json --box=") + box,
              std::string("--box: found '") + box + "', expected the sides of the box");
    refuses("--json --box 4,4,4,90,90,60",
            "--box: found a cell with angles of 90, 90 and 60 degrees, expected right angles");
    refuses("--json --box 4 --balls", "--balls cannot be combined with --box");
    refuses("--box 4 --voids v.obj", "--voids: found the ending 'obj', expected one of json, csv with --box");
    CHECK(folder.rbpa("solid c.xyz --alpha 1 --json --box 1e-300").code == 3);
  }
}
