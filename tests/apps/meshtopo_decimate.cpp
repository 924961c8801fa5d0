// meshtopo --decimate, and --faces of `rbpa surface`.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "support/changed_mesh.h"
#include "support/mesh_files.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

const std::string data = RBPA_TEST_DATA;

void check_same_topology(const json& report) {
  for (const char* key : {"genus", "betti", "boundary_curves", "components", "euler", "pinches", "defects"}) {
    CAPTURE(key);
    const json& before = report[key];
    CHECK(report["result"][key] == (before.is_array() && std::string(key) == "defects" ? json(before.size()) : before));
  }
}

/// Lines of points of a sphere, each with its normal, which points outward or inward.
std::string ball(int count, double radius = 1, double outward = 1) {
  std::string text;
  for (const rbpa::Point3& p : rbpa_test::spiral(count))
    text += rbpa_test::text_of({radius * p.x, radius * p.y, radius * p.z}) + " " +
            rbpa_test::text_of({outward * p.x, outward * p.y, outward * p.z}) + "\n";
  return text;
}

}  // namespace

TEST_SUITE("meshtopo --decimate") {
  TEST_CASE("a mesh is decimated to a number or a share of its faces, with its topology") {
    const Folder folder;
    for (const std::string name : {"m3_spot.off", "m3_torus.off", "m3_plate_holes.off", "m3_cube_no_bottom.off"}) {
      CAPTURE(name);
      const json whole = changed(folder, data + "/" + name + " --decimate 10% -o part.ply");
      const auto faces = whole["faces"].get<std::size_t>();
      CHECK(whole["result"]["faces"].get<std::size_t>() <= faces / 10);
      CHECK(whole["result"]["faces"].get<std::size_t>() + 2 > faces / 10);
      check_same_topology(whole);
      const json& counts = whole["changes"]["decimate"];
      CHECK(counts["triangles_before"] == faces);
      CHECK(counts["triangles"] == whole["result"]["faces"]);
      CHECK(counts["collapses"].get<std::size_t>() > faces / 3);
      CHECK(changed(folder, "part.ply")["faces"] == counts["triangles"]);

      const json exact = changed(folder, data + "/" + name + " --decimate " + std::to_string(faces / 10) + " -o n.ply");
      CHECK(folder.content("n.ply") == folder.content("part.ply"));
      CHECK(exact["result"] == whole["result"]);
    }
  }

  TEST_CASE("the result does not depend on the order of vertices and faces") {
    const Folder folder;
    std::mt19937 random(3);
    Mesh mesh;
    // A grid of squares over a wave, each cut in two.
    const auto at = [](int i, int j) { return std::array{i * 1.0, j * 1.0, std::sin(0.3 * i) * std::cos(0.2 * j)}; };
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j) mesh.positions.push_back(at(i, j));
    for (std::uint32_t i = 0; i < 20; ++i)
      for (std::uint32_t j = 0; j < 20; ++j) {
        const std::uint32_t a = 21 * i + j;
        mesh.faces.push_back({a, a + 21, a + 22});
        mesh.faces.push_back({a, a + 22, a + 1});
      }
    folder.file("m.off", mesh.off());
    changed(folder, "m.off --decimate 90 -o one.off");
    mesh.shuffle(random);
    folder.file("m.off", mesh.off());
    changed(folder, "m.off --decimate 90 -o other.off");
    CHECK(places_of(folder, "one.off").size() <= 90);
    CHECK(places_of(folder, "one.off") == places_of(folder, "other.off"));
  }

  TEST_CASE("a mesh with fewer faces stays as it is, and one that can lose none is reported so") {
    const Folder folder;
    Mesh mesh;
    folder.file("empty.off", mesh.off());
    CHECK(changed(folder, "empty.off --decimate 1 -o o.off")["changes"]["decimate"]["triangles"] == 0);
    mesh.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    folder.file("one.off", mesh.off());
    CHECK(changed(folder, "one.off --decimate 1000000 -o o.off")["changes"]["decimate"]["collapses"] == 0);
    CHECK(folder.content("o.off") == folder.content("one.off"));
    const Outcome least = folder.meshtopo(data + "/m3_spot.off --decimate 1 -o o.off", 0);
    CHECK(contains(least.out, "\n  decimated from 1654 to 4 triangles, at most "));
    CHECK(contains(
        least.out,
        " from those before, no further: every collapse left would change the topology or turn a triangle over\n"));
    CHECK(changed(folder, data + "/m3_spot.off --decimate 0.01% -o o.off")["result"]["faces"] == 4);
  }

  TEST_CASE("fans that meet in a point get vertices of their own, and isolated points stay") {
    const Folder folder("m.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n7 7 7\n3 0 1 2\n3 0 3 4\n");
    const json report = changed(folder, "m.off --decimate 1 -o o.off");
    CHECK(report["pinches"] == 1);
    CHECK(report["result"]["pinches"] == 0);
    CHECK(report["result"]["isolated"] == 1);
    CHECK(report["result"]["vertices"] == 7);
    CHECK(report["changes"]["decimate"]["triangles"] == 2);
  }

  TEST_CASE("an error is kept, and certified in the report; a larger one leaves fewer faces") {
    const Folder folder;
    std::size_t before = 4609;
    for (const double error : {0.0, 1e-3, 1e-2, 0.1}) {
      const json report =
          changed(folder, data + "/m3_torus.off --decimate error=" + std::to_string(error) + " -o part.ply");
      const json& counts = report["changes"]["decimate"];
      CHECK(counts["distance"].get<double>() <= error);
      CHECK(counts["triangles"].get<std::size_t>() < before);
      if (error > 0) CHECK(counts["distance"].get<double>() > error / 4);
      if (error < 0.1) CHECK(counts["refused"].contains("too_far"));
      before = counts["triangles"].get<std::size_t>();
      check_same_topology(report);
    }
    CHECK(before < 300);
    const Outcome outcome = folder.meshtopo(data + "/m3_torus.off --decimate error=0.01 -o part.ply");
    CHECK(contains(outcome.out,
                   " from those before, no further: every collapse left would change the topology, turn a triangle "
                   "over or be too far\n"));
  }

  TEST_CASE("--no-crossings lets no faces cross, and is refused without --decimate") {
    const Folder folder;
    Outcome outcome = folder.meshtopo(data + "/m3_spot.off --decimate 4 --no-crossings -o o.off --json");
    CHECK(json::parse(outcome.out)["changes"]["decimate"]["refused"].contains("crossing_triangles"));
    CHECK(folder.meshtopo("o.off -q --check closed,genus=0").code == 0);
    outcome = folder.meshtopo(data + "/m3_spot.off --no-crossings -o o.txt", 2);
    CHECK(outcome.err == "meshtopo: --no-crossings requires --decimate\n");
  }

  TEST_CASE("--at-faces reads of what --progressive wrote the mesh of each number of faces, up to the given one") {
    const Folder folder;
    for (const std::string name : {"m3_spot.off", "m3_plate_holes.off"}) {
      CAPTURE(name);
      const std::string given = data + "/" + name;
      CHECK(json::parse(folder.meshtopo(given + " --decimate 130 --progressive m.pm -o coarse.off --json", 0).out) ==
            changed(folder, given + " --decimate 130 -o alone.off"));
      CHECK(folder.content("coarse.off") == folder.content("alone.off"));
      const auto at = [&](const std::string& faces) {
        return folder.meshtopo("m.pm --at-faces " + faces + " -q -o at.off").code == 0 ? folder.content("at.off") : "";
      };
      CHECK(at("130") == folder.content("coarse.off"));
      CHECK(at("0") == folder.content("coarse.off"));
      CHECK(folder.meshtopo("m.pm --at-faces 130 -q --check defects=0", 0).err.empty());
      CHECK(folder.meshtopo("m.pm --at-faces 9 -q --check defects=0", 0).err ==
            "meshtopo: m.pm: the least number of faces is 130, more than --at-faces 9\n");
      for (const std::string faces : {"131", "200", "777"}) {
        CHECK(folder.meshtopo(given + " -q --decimate " + faces + " -o n.off").code == 0);
        CHECK(at(faces) == folder.content("n.off"));
      }
      CHECK(folder.meshtopo(given + " -q --decimate 100% -o n.off").code == 0);
      CHECK(at("1000000") == folder.content("n.off"));
      CHECK(folder.meshtopo("- --at-faces 200 -q --check defects=0,faces=200 < m.pm").code == 0);
    }
    // With a pinch, whose fans have vertices of their own, and an isolated vertex.
    folder.file("m.off", "OFF\n7 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n-1 0 0\n0 -1 0\n7 7 7\n3 0 1 2\n3 0 2 3\n3 0 4 5\n");
    CHECK(folder.meshtopo("m.off -q --decimate 2 --progressive m.pm").code == 0);
    CHECK(json::parse(folder.meshtopo("m.pm --at-faces 3 --json").out)["vertices"] == 8);
    CHECK(json::parse(folder.meshtopo("m.pm --at-faces 2 --json").out)["vertices"] == 7);
    CHECK(json::parse(folder.meshtopo("m.pm --at-faces 2 --json").out)["isolated"] == 1);
  }

  TEST_CASE("--progressive and --at-faces are refused where they do not apply, and other bytes with the reason") {
    const Folder folder;
    const std::string spot = data + "/m3_spot.off";
    const auto refused = [&](const std::string& arguments, int code, const std::string& why) {
      const Outcome outcome = folder.meshtopo(arguments, code);
      CHECK(outcome.err == "meshtopo: " + why + "\n");
      CHECK(outcome.out == "");
    };
    refused(spot + " --progressive m.pm", 2, "--progressive requires --decimate");
    refused(spot + " --decimate 9 --progressive -", 2,
            "--progressive: found -, expected a file (standard output is that of the report)");
    refused(spot + " " + spot + " --decimate 9 --progressive m.pm", 2, "--progressive: found 2 meshes, expected one");
    for (const std::string name : {"m.off", "m.PLY", "m.off.gz"})
      refused(
          spot + " --decimate 9 --progressive " + name, 2,
          "--progressive: found '" + name +
              "', with the ending of a mesh, expected another ending, such as .pm (only --at-faces reads the file)");
    refused(spot + " --decimate 9 --progressive m.pm -o m.pm --output-format off", 2,
            "m.pm: found twice among the files to write, expected once");
    refused(spot + " --at-faces 9 --format off", 2,
            "--format does not apply to progressive meshes, which --at-faces reads");
    refused(spot + " --at-faces x", 2, "--at-faces: found 'x', expected a whole number from 0");
    refused(
        spot + " --at-faces 9 -o o.off", 3,
        spot + ": progressive mesh: found another beginning, expected rbpaprog, with which a progressive mesh begins");
    CHECK(folder.meshtopo(spot + " --decimate 9 --progressive m.pm -q").code == 0);
    const std::string whole = folder.content("m.pm");
    folder.file("cut.pm", whole.substr(0, whole.size() - 1));
    refused("cut.pm --at-faces 9 -o o.off", 3,
            "cut.pm: progressive mesh: found " + std::to_string(whole.size() - 1) + " bytes, expected " +
                std::to_string(whole.size()) + " by the numbers in the head");
    std::string wrong = whole;
    const std::size_t corners = 32U + 28U * static_cast<unsigned char>(whole[16]) + 4U;  // of the first coarse triangle
    wrong.replace(corners, 4, wrong, corners + 4, 4);
    folder.file("wrong.pm", wrong);
    const Outcome twice = folder.meshtopo("wrong.pm --at-faces 9", 3);
    CHECK(twice.err.starts_with(
        "meshtopo: wrong.pm: progressive mesh: the coarse mesh has a defect, expected none: degenerate face"));
    refused("m.pm --at-faces 9 --decimate 4 --progressive m.pm", 2,
            "m.pm: found the file of the mesh, expected another file to write to");
    CHECK(folder.content("m.pm") == whole);
    CHECK_FALSE(folder.has("o.off"));
    CHECK_FALSE(folder.has("m.off"));
  }

  TEST_CASE("holes are filled before, and checks are those of the result") {
    const Folder folder;
    const Outcome outcome = folder.meshtopo(data + "/m3_cube_no_bottom.off --fill-holes rims --decimate 12 -o o.off " +
                                            "--check closed,genus=0,faces=12 -q");
    CHECK(outcome.err == "");
    CHECK(outcome.code == 0);
    CHECK(folder.meshtopo("o.off -q --check closed,faces=12").code == 0);
  }

  TEST_CASE("wrong numbers, polygons, meshes with defects and a missing file to write are refused, nothing written") {
    const Folder folder("p.off", pyramid_off);
    for (const std::string wrong : {"0", "-5", "x", "10 %", "0%", "101%", "%", "nan%", "1e3", "5.5",
                                    "error=", "error=-1", "error=nan", "error=inf", "error=1%"})
      meshtopo_refuses(folder, "p.off --decimate='" + wrong + "' -o o.off", 2,
                       "--decimate: found '" + wrong +
                           "', expected a number of triangles, such as 10000, a share, such as 10%, or a distance, "
                           "such as error=0.5");
    Outcome outcome = folder.meshtopo("p.off --decimate 4 -o o.off", 3);
    CHECK(outcome.err ==
          "meshtopo: p.off: found 1 face that is no triangle, expected triangles, as --decimate requires (--repair "
          "OUT.stl writes triangles)\n");
    CHECK(folder.meshtopo("p.off --repair t.stl -q").code == 0);
    CHECK(changed(folder, "t.stl --decimate 4 -o t.off")["result"]["faces"] == 4);
    folder.file("d.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
    outcome = folder.meshtopo("d.off --decimate 1 -o o.off", 3);
    CHECK(contains(outcome.err,
                   "expected a surface, as --decimate requires (--repair makes one, or rbpa surface --manifold)"));
    CHECK(folder.meshtopo("d.off --repair --decimate 1 -o o2.off -q").code == 0);
    CHECK(folder.meshtopo("p.off --decimate 4").err ==
          "meshtopo: --decimate changes the mesh, and requires a file for it (-o OUT or --repair OUT), or --check\n");
    CHECK_FALSE(folder.has("o.off"));
  }
}

TEST_SUITE("surface") {
  TEST_CASE("--faces decimates a surface between its points, closed stays closed, and the summary has the counts") {
    const Folder folder("s.xyz", ball(900));
    const Outcome outcome = folder.rbpa("surface s.xyz --radius 0.2 --watertight --faces 300 -o m.ply --json", 0);
    const json report = json::parse(outcome.out);
    CHECK(report["triangles"] == 300);
    CHECK(report["decimated"]["triangles_before"] == 1796);
    CHECK(report["decimated"]["triangles"] == 300);
    CHECK(report["watertight"] == true);
    CHECK(report["component_list"][0]["triangles"] == 300);
    CHECK(contains(outcome.err, "\nrbpa: decimated from 1796 to 300 triangles, at most "));
    CHECK(contains(outcome.err, ": 300 triangles, 1 component, 0 boundary curves, genus 0 -> m.ply\n"));
    CHECK(folder.meshtopo("m.ply -q --check closed,oriented,faces=300,vertices=152").code == 0);

    // Without --manifold, too, vertices that no triangle uses are left out; .npy keeps input indices.
    CHECK(folder.rbpa("surface s.xyz --radius 0.2 --faces 300 -o n.off -o n.npy -q").code == 0);
    CHECK(folder.content("n.off").substr(0, 11) == "OFF\n152 300");
    CHECK(json::parse(folder.rbpa("surface s.xyz --radius 0.2 --json -q").out)["decimated"].is_null());
  }

  TEST_CASE("--faces takes a share or an error, and with --watertight no triangles cross") {
    const Folder folder("s.xyz", ball(900) + ball(900, 0.98, -1));
    const std::string surface = "surface s.xyz --radius 0.2 --watertight -o m.ply --json -q ";
    json report = json::parse(folder.rbpa(surface + "--faces 10%").out);
    CHECK(report["watertight"] == true);
    CHECK(report["decimated"]["triangles_before"] == 3592);
    CHECK(report["decimated"]["refused"]["crossing_triangles"].get<std::size_t>() > 0);
    CHECK(folder.meshtopo("m.ply -q --check closed,oriented,components=2,genus=0").code == 0);
    folder.file("b.xyz", ball(300));
    report = json::parse(folder.rbpa("surface b.xyz --radius 0.4 -o b.ply --json -q --faces error=0.05").out);
    CHECK(report["decimated"]["distance"].get<double>() <= 0.05);
    CHECK(report["decimated"]["distance"].get<double>() > 0.01);
    CHECK(report["triangles"].get<std::size_t>() < 300);
    // Without --watertight, crossings are refused on request.
    const std::string open = "surface s.xyz --radius 0.2 -o n.ply --json -q --faces 300 ";
    CHECK_FALSE(json::parse(folder.rbpa(open).out)["decimated"]["refused"].contains("crossing_triangles"));
    CHECK(json::parse(folder.rbpa(open + "--no-crossings").out)["decimated"]["refused"].contains("crossing_triangles"));
  }

  TEST_CASE("a wrong number of --faces is refused") {
    const Folder folder("s.xyz", ball(50));
    for (const std::string wrong : {"0", "-5", "x", "101%", "nan", "error=-1"}) {
      refuses(folder, "surface s.xyz --radius 0.9 --faces='" + wrong + "' -o o.off", 2,
              "--faces: found '" + wrong +
                  "', expected a number of triangles, such as 10000, a share, such as 10%, or a distance, such as "
                  "error=0.5");
    }
    CHECK(folder.rbpa("surface s.xyz --radius 0.9 --no-crossings -o o.off").err ==
          "rbpa: --no-crossings requires --faces\n");
    CHECK_FALSE(folder.has("o.off"));
  }
}
