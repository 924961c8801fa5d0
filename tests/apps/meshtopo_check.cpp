// meshtopo --check, and several meshes at once: messages, outputs, and exit codes.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/data_folder.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// A pyramid without its base: four triangles and a boundary of four edges.
const std::string open_off = "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
/// A pyramid with one face reversed, and a third triangle at an edge.
const std::string bad_off =
    "OFF\n6 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n5 5 5\n4 3 2 1 0\n3 1 0 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 4 "
    "5\n";
/// A Möbius band of five triangles.
const std::string moebius_off =
    "OFF\n5 5 0\n0 0 0\n1 0 0\n2 0 1\n3 1 0\n4 0 0\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n";

struct Meshes : Folder {
  Meshes() {
    file("whole.off", pyramid_off);
    file("open.off", open_off);
    file("bad.off", bad_off);
    file("band.off", moebius_off);
    file("pinch.off",
         "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 0 4 5\n"
         "3 0 6 4\n3 0 5 6\n3 4 6 5\n");
    file("points.off", "OFF\n2 0 0\n0 0 0\n1 1 1\n");
    file("cut.off", pyramid_off.substr(0, 60));
  }

  /// Returns the message for a mesh that fails. Checks for exit code 4, and that -q prints nothing else.
  std::string failures(const std::string& mesh, const std::string& list) const {
    const Outcome outcome = meshtopo(mesh + " -q --check " + list);
    CHECK(outcome.code == (outcome.err.empty() ? 0 : 4));
    CHECK(outcome.out.empty());
    return outcome.err;
  }
};

}  // namespace

TEST_SUITE("meshtopo --check") {
  TEST_CASE("nothing is printed for properties that hold") {
    const Meshes folder;
    CHECK(folder
              .failures("whole.off",
                        "closed,manifold,oriented,orientable,vertices=5,edges=8,faces=5,euler=2,components=1,boundary_"
                        "curves=0,genus=0,pinches=0,isolated=0,defects=0,geometric_defects=0")
              .empty());
    CHECK(folder.failures("open.off", "manifold,oriented,boundary_curves=1,genus=0,euler=1").empty());
    CHECK(folder.failures("points.off", "manifold,oriented,components=2,isolated=2").empty());
    const std::string bob = (rbpa_test::bundled_data() / "m3_bob.off").string();
    CHECK(folder.failures("'" + bob + "'", "closed,genus=1 --check euler=0").empty());
  }

  TEST_CASE("a line for each property that fails has the found and the expected value") {
    const Meshes folder;
    CHECK(folder.failures("open.off", "closed,manifold,euler=2,boundary_curves=0,faces=5") ==
          "meshtopo: open.off: closed: found 1 boundary curve, expected none\n"
          "meshtopo: open.off: euler: found 1, expected 2\n"
          "meshtopo: open.off: boundary_curves: found 1, expected 0\n"
          "meshtopo: open.off: faces: found 4, expected 5\n");
    CHECK(folder.failures("bad.off", "closed,manifold,oriented,orientable,genus=0") ==
          "meshtopo: bad.off: closed: found 2 boundary curves, expected none\n"
          "meshtopo: bad.off: manifold: found 1 non-manifold edge, expected none\n"
          "meshtopo: bad.off: oriented: found 2 inconsistent orientations, expected none\n"
          "meshtopo: bad.off: genus: found not a manifold, expected 0\n");
    CHECK(folder.failures("band.off", "oriented,orientable,genus=1") ==
          "meshtopo: band.off: oriented: found 5 inconsistent orientations and 1 component not orientable, expected "
          "none\n"
          "meshtopo: band.off: orientable: found 1 component not orientable, expected none\n"
          "meshtopo: band.off: genus: found not orientable, expected 1\n");
    CHECK(folder.failures("pinch.off", "closed,manifold,pinches=0,components=2") ==
          "meshtopo: pinch.off: manifold: found 1 pinch, expected none\n"
          "meshtopo: pinch.off: pinches: found 1, expected 0\n"
          "meshtopo: pinch.off: components: found 1, expected 2\n");
    CHECK(folder.failures("points.off", "closed") ==
          "meshtopo: points.off: closed: found no face, expected a closed surface\n");
    CHECK(folder.failures("whole.off", "euler=-2") == "meshtopo: whole.off: euler: found 2, expected -2\n");
    CHECK(folder.meshtopo("- --format off -q --check closed <open.off").err ==
          "meshtopo: standard input: closed: found 1 boundary curve, expected none\n");
  }

  TEST_CASE("crossings counts pairs of faces that cross, of all sorts, and of polygons once") {
    const Meshes folder;
    struct Row {
      const char *name, *points, *faces;
      int crossings;
    };
    const std::string square = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n";
    for (const Row& row : {
             Row{"side by side", "", "3 0 1 2\n3 0 2 3\n", 0},
             {"a face twice", "", "3 0 1 2\n3 2 1 0\n", 1},
             {"a square pierced", "1 1 -1\n1 1.5 1\n1.5 1 1\n", "4 0 1 2 3\n3 4 5 6\n", 1},
             {"a T-junction", "0 1 0\n-2 0 0\n-2 2 0\n", "3 0 2 3\n3 0 4 5\n3 4 3 6\n", 2},
             {"equal places", "0 0 0\n2 0 0\n1 -2 0\n", "3 0 1 2\n3 5 4 6\n", 0},
             {"no area", "1 1 0\n", "3 0 1 2\n3 0 2 4\n", 0},
         }) {
      CAPTURE(row.name);
      const std::string points = square + row.points, faces = row.faces;
      const auto lines = [](const std::string& text) {
        return std::to_string(std::count(text.begin(), text.end(), '\n'));
      };
      folder.file("c.off", "OFF\n" + lines(points) + " " + lines(faces) + " 0\n" + points + faces);
      CHECK(folder.failures("c.off", "crossings=" + std::to_string(row.crossings)).empty());
      CHECK(folder.failures("c.off", "crossings=9") ==
            "meshtopo: c.off: crossings: found " + std::to_string(row.crossings) + ", expected 9\n");
    }
    // Two sheets that get coarser than their distance.
    const std::string sheets = (rbpa_test::bundled_data() / "m3_spot.off").string();
    const std::string run = "'" + sheets + "' -q --check crossings=0 -o o.off ";
    const Outcome outcome = folder.meshtopo(run + "--remesh 0.3", 4);
    CHECK(outcome.err.find(
              "faces of the result cross, and none did before (--remesh with a lesser length, or error=E)") !=
          std::string::npos);
    CHECK(outcome.err.find("crossings: found ") != std::string::npos);
    CHECK(folder.meshtopo(run + "--remesh 0.3,error=0.01", 0).err.empty());
  }

  TEST_CASE("the report is written also if a check fails, and has the checks") {
    const Meshes folder;
    const Outcome text = folder.meshtopo("open.off --check closed,genus=0", 4);
    CHECK(text.out == folder.meshtopo("open.off").out +
                          "\nchecks\n  closed: does not hold, found 1 boundary curve\n  genus=0: holds\n");
    folder.meshtopo("band.off --json --check oriented,genus=0,euler=0 -o r.json", 4);
    CHECK(json::parse(folder.content("r.json"))["checks"] ==
          json::parse(R"([{"check": "oriented", "expected": true, "found": false, "holds": false},
                          {"check": "genus", "expected": 0, "found": null, "holds": false},
                          {"check": "euler", "expected": 0, "found": 0, "holds": true}])"));
    CHECK_FALSE(json::parse(folder.meshtopo("open.off --json").out).contains("checks"));
  }

  TEST_CASE("with --repair the written mesh is checked, and it is written") {
    const Meshes folder;
    CHECK(folder.meshtopo("bad.off -q --check manifold,oriented").code == 4);
    const Outcome outcome = folder.meshtopo("bad.off --json --repair good.off --check manifold,oriented,defects=0", 0);
    CHECK(outcome.err.empty());
    const json r = json::parse(outcome.out);
    CHECK(r["defects"].size() == 3);
    CHECK(r["result"]["defects"] == 0);
    CHECK(r["result"]["faces"] == 6);
    CHECK(folder.failures("good.off", "manifold,oriented,defects=0").empty());
    CHECK(folder.meshtopo("bad.off -q --repair left.off --check closed").code == 4);
    CHECK(folder.content("left.off") == folder.content("good.off"));
  }

  TEST_CASE("a repair says that faces without area stay") {
    const Meshes folder;
    folder.file("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n3 0 1 3\n3 0 2 1\n");
    CHECK(folder.meshtopo("flat.off --repair o.off")
              .out.ends_with("\nrepair: nothing to do\n  left as they are: 1 zero-area face\n"));
    CHECK(folder.meshtopo("whole.off --repair o.off").out.ends_with("\nrepair: nothing to do\n"));
  }

  TEST_CASE("unknown properties are wrong usage, and the known ones are listed") {
    const Meshes folder;
    const std::string known =
        "closed, manifold, oriented, orientable, vertices=N, edges=N, faces=N, euler=N, components=N, "
        "boundary_curves=N, genus=N, pinches=N, isolated=N, defects=N, geometric_defects=N, "
        "crossings=N\n";
    for (const std::string name : {"open", "Closed", "genus 0", "boundary-curves=0", "", "=0"}) {
      const Outcome outcome = folder.meshtopo("whole.off --check '" + name + "'", 2);
      CHECK(outcome.err == "meshtopo: --check: found '" + name + "', expected one of " + known);
      CHECK(outcome.out.empty());
    }
    CHECK(
        folder.meshtopo("whole.off --check closed,,genus=0").err.starts_with("meshtopo: --check: found '', expected"));
    CHECK(folder.meshtopo("whole.off --check closed=1").err ==
          "meshtopo: --check: found 'closed=1', expected 'closed' without a value\n");
    for (const std::string number :
         {"genus", "genus=", "genus=0.5", "genus=x", "genus= 0", "genus=99999999999999999999"})
      CHECK(folder.meshtopo("whole.off --check '" + number + "'").err ==
            "meshtopo: --check: found '" + number + "', expected genus=N, N a whole number, such as genus=0\n");
    CHECK(folder.meshtopo("whole.off --check").code == 2);
  }
}

TEST_SUITE("meshtopo, several meshes") {
  TEST_CASE("several meshes have a report each, under its name, in the order given") {
    const Meshes folder;
    const Outcome outcome = folder.meshtopo("whole.off open.off", 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.out ==
          "whole.off:\n" + folder.meshtopo("whole.off").out + "\nopen.off:\n" + folder.meshtopo("open.off").out);
    CHECK(folder.meshtopo("open.off whole.off -o r.txt").code == 0);
    CHECK(folder.content("r.txt") ==
          "open.off:\n" + folder.meshtopo("open.off").out + "\nwhole.off:\n" + folder.meshtopo("whole.off").out);
    CHECK(folder.meshtopo("open.off - --format off <whole.off").out ==
          "open.off:\n" + folder.meshtopo("open.off").out + "\n-:\n" + folder.meshtopo("whole.off").out);
  }

  TEST_CASE("JSON is an array of the reports, each of which names its file first") {
    const Meshes folder;
    REQUIRE(folder.meshtopo("whole.off open.off bad.off --json -o r.json --check euler=2").code == 4);
    const auto all = nlohmann::ordered_json::parse(folder.content("r.json"));
    REQUIRE(all.size() == 3);
    const std::vector<std::string> names = {"whole.off", "open.off", "bad.off"};
    for (std::size_t i = 0; i < 3; ++i) {
      auto report = all[i];
      CHECK(report.begin().key() == "file");
      CHECK(report["file"] == names[i]);
      report.erase("file");
      CHECK(report == nlohmann::ordered_json::parse(folder.meshtopo(names[i] + " --json --check euler=2").out));
    }
  }

  TEST_CASE("the exit code is the worst: bad input, then a check that fails; all meshes are checked") {
    const Meshes folder;
    const auto code = [&](const std::string& arguments) { return folder.meshtopo(arguments + " -q").code; };
    CHECK(code("whole.off whole.off --check closed") == 0);
    CHECK(code("open.off whole.off --check closed") == 4);
    CHECK(code("whole.off open.off --check closed") == 4);
    CHECK(code("cut.off open.off --check closed") == 3);
    CHECK(code("open.off cut.off --check closed") == 3);
    CHECK(code("none.off whole.off") == 3);
    const Outcome outcome = folder.meshtopo("open.off cut.off none.off bad.off --json --check closed", 3);
    const std::string cut = folder.meshtopo("cut.off").err;
    CHECK(outcome.err == "meshtopo: open.off: closed: found 1 boundary curve, expected none\n" + cut +
                             "meshtopo: none.off: found no such file, expected a mesh file\n"
                             "meshtopo: bad.off: closed: found 2 boundary curves, expected none\n");
    const json all = json::parse(outcome.out);
    REQUIRE(all.size() == 4);
    CHECK(all[1] == json{{"file", "cut.off"}, {"error", cut.substr(10, cut.size() - 11)}});
    CHECK(all[3]["faces"] == 6);
    const std::string text = folder.meshtopo("cut.off open.off").out;
    CHECK(text == "cut.off:\nno report: " + cut.substr(10) + "\nopen.off:\n" + folder.meshtopo("open.off").out);
  }

  TEST_CASE("options that write one file are refused for several meshes, before anything is read") {
    const Meshes folder;
    const auto refused = [&](const std::string& arguments) {
      const Outcome outcome = folder.meshtopo(arguments, 2);
      CHECK(outcome.out.empty());
      return outcome.err;
    };
    CHECK(refused("whole.off open.off --repair r.off") == "meshtopo: --repair: found 2 meshes, expected one\n");
    CHECK(refused("whole.off open.off bad.off --generators l.obj") ==
          "meshtopo: --generators: found 3 meshes, expected one\n");
    CHECK(refused("whole.off open.off --weld 0 -o w.off") == "meshtopo: -o: found 2 meshes, expected one\n");
    CHECK(refused("- - --format off") == "meshtopo: MESH: found -, standard input, twice, expected once\n");
    CHECK(refused("whole.off open.foo").starts_with("meshtopo: open.foo: found the ending 'foo', expected one of"));
    CHECK(refused("whole.off open.off -o ./open.off --json") ==
          "meshtopo: ./open.off: found the ending 'off' of a mesh, expected json or txt for a report, or --repair OUT "
          "to write a mesh (to convert: --weld 0 -o ./open.off)\n");
  }
}
