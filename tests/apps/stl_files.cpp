// STL: attributes of facets, and that promises about a mesh hold for the file in single precision.
#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/mesh/single_precision.h"
#include "support/data_folder.h"
#include "support/mesh_files.h"
#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

std::string finding(const std::string& name) { return (rbpa_test::bundled_data() / "findings" / name).string(); }

/// Points of a sphere of radius 1 around a place, with their normals.
std::string sphere(int points, double x, double y, double z) {
  std::string text;
  for (const rbpa::Point3& n : rbpa_test::spiral(points)) {
    char line[200];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g %.17g %.17g %.17g\n", x + n.x, y + n.y, z + n.z, n.x, n.y, n.z);
    text += line;
  }
  return text;
}

void holds(const Folder& folder, const std::string& name, const std::string& checks) {
  folder.meshtopo(name + " -q --check " + checks, 0);
}

/// Writes two cubes with a common edge, cut apart.
const std::string two_cubes = "case_stl_undoes_repair/two_cubes_edge.stl";

}  // namespace

TEST_SUITE("STL: after the last facet") {
  TEST_CASE("attributes of any kind are left out, with a warning") {
    const std::string cube = stl_binary(pyramid_triangles);
    for (const auto& [tail, said] : std::vector<std::pair<std::string, std::string>>{
             {"\n", "1 byte after the last facet is"},
             {std::string(92, '\0'), "92 bytes after the last facet are"},
             {"solid\n", "6 bytes after the last facet are"},
             {std::string(50, '\xFF'), "50 bytes after the last facet are"}}) {
      for (const std::string& head : {std::string(), std::string("solid of a program\n")}) {
        const Folder folder;
        const auto& shown_said = said;
        CAPTURE(shown_said);
        std::string content = cube + tail;
        content.replace(0, head.size(), head);
        folder.file("m.stl", content);
        const Outcome outcome = folder.meshtopo("m.stl --check closed,genus=0,vertices=5,faces=6", 0);
        CHECK(outcome.err == "meshtopo: m.stl: " + said + " left out\n");
      }
    }
  }

  TEST_CASE("facets have attributes of one length or several") {
    const std::string plain = stl_binary(pyramid_triangles);
    std::string content = plain.substr(0, 84);
    for (std::size_t f = 0; f < 6; ++f) {
      content += plain.substr(84 + 50 * f, 48);
      content += static_cast<char>(f);
      content += '\0';
      content += std::string(f, 'a');
    }
    const Folder folder("m.stl", content);
    const Outcome outcome = folder.meshtopo("m.stl --check closed,vertices=5,faces=6", 0);
    CHECK(outcome.err == "meshtopo: m.stl: 15 bytes of attributes are left out\n");
    // A color in the attributes is not a length.
    std::string colored = plain;
    colored[84 + 48] = '\x05';
    folder.file("c.stl", colored);
    holds(folder, "c.stl", "closed,vertices=5,faces=6");
    folder.file("c.stl", colored + "\n");
    holds(folder, "c.stl", "closed,vertices=5,faces=6");
    folder.file("short.stl", plain.substr(0, plain.size() - 1));
    CHECK(folder.meshtopo("short.stl -q").code == 3);
  }

  TEST_CASE("ASCII STL may have capital letters, several solids, and zeros or the mark of the end after them") {
    const std::string one = stl_text(pyramid_triangles);
    std::string capitals = one;
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const Folder folder;
    for (const std::string& content :
         {one, capitals, one + std::string(3, '\0'), one + "\x1a", one + "\x1a\r\n" + std::string(500, '\0')}) {
      folder.file("m.stl", content);
      holds(folder, "m.stl", "closed,vertices=5,faces=6");
    }
    folder.file("m.stl", one + capitals);
    CHECK(json::parse(folder.meshtopo("m.stl --json").out)["vertices"] == 5);
    CHECK(folder.meshtopo("m.stl --json").code == 0);
    folder.file("m.stl", one + std::string("\0more", 5));
    CHECK(folder.meshtopo("m.stl -q").code == 3);
  }

  TEST_CASE("files of others are read") {
    for (const std::string name : {"tail92", "payload", "newline"}) {
      const Folder folder;
      holds(folder, finding("case_stl_tails/" + name + ".stl"), "closed,genus=0,vertices=8,faces=12");
    }
  }
}

TEST_SUITE("single precision") {
  TEST_CASE("--shift is auto or three numbers") {
    using rbpa::app::parse_shift;
    CHECK_FALSE(parse_shift("--shift", "auto").by);
    CHECK(*parse_shift("--shift", "1,-2.5,1e3").by == rbpa::app::Position{1, -2.5, 1000});
    const Folder folder("m.off", pyramid_off);
    for (const std::string bad : {"1,2", "1,2,3,4", "", "a,b,c", "1,2,nan", "inf,0,0", "1;2;3", "AUTO"}) {
      CAPTURE(bad);
      CHECK(folder.meshtopo("m.off --repair o.stl --shift '" + bad + "'").code == 2);
    }
    CHECK(folder.meshtopo("m.off --repair o.ply --shift auto").err ==
          "meshtopo: --shift applies only to .stl files, which are in single precision\n");
    CHECK(folder.rbpa("surface m.off --radius 1 -o o.ply --shift auto").code == 2);
    CHECK(folder.rbpa("solid m.off --alpha inf --boundary o.ply --shift auto").code == 2);
  }

  TEST_CASE("meshtopo refuses to lose faces by rounding, and a shift keeps them") {
    const Folder folder;
    const std::string utm = finding("case_stl_single_precision/utm.off");
    const Outcome refused = folder.meshtopo(utm + " --repair o.stl --check closed,manifold -q", 4);
    CHECK(contains(refused.err, "o.stl: single precision leaves "));
    CHECK(contains(refused.err, "(not with --shift auto, nor as .ply, .obj or .off); it is not written"));
    CHECK(contains(refused.err, "meshtopo: " + utm + ": closed: found "));
    CHECK_FALSE(folder.has("o.stl"));
    CHECK(folder.meshtopo(utm + " --orient -o o.stl -q").code == 4);
    CHECK(folder.meshtopo(utm + " --repair o.ply --check closed,manifold -q").code == 0);
    holds(folder, "o.ply", "closed,manifold");
    const Outcome shifted =
        folder.meshtopo(utm + " --repair o.stl --shift auto --check closed,manifold,components=1 -q", 0);
    const std::string by = shifted.err.substr(17, shifted.err.find(" is subtracted") - 17);
    CHECK(shifted.err == "meshtopo: o.stl: " + by + " is subtracted from all coordinates\n");
    CHECK(folder.content("o.stl").substr(0, 6 + by.size()) == "shift " + by);
    holds(folder, "o.stl", "closed,manifold,components=1,geometric_defects=0");
    CHECK(folder.meshtopo(utm + " --repair p.stl --shift " + by + " -q").code == 0);
    CHECK(folder.content("p.stl") == folder.content("o.stl"));
  }

  TEST_CASE("--check examines the file: STL joins vertices that a repair has cut") {
    const Folder folder;
    const std::string cubes = finding(two_cubes);
    const Outcome outcome = folder.meshtopo(cubes + " --repair o.stl --check closed,manifold,components=2 -q", 4);
    CHECK(outcome.err.find("meshtopo: o.stl: STL joins points at equal positions, so 1 edge that was cut is "
                           "non-manifold again (.ply, .obj and .off keep it cut)\n") == 0);
    CHECK(contains(outcome.err, "manifold: found 1 non-manifold edge, expected none"));
    CHECK(folder.meshtopo("o.stl --check closed,manifold,components=2 -q").code == 4);
    CHECK(folder.meshtopo(cubes + " --repair o.stl -q").code == 0);
    for (const std::string ending : {"ply", "obj", "off"}) {
      CHECK(folder.meshtopo(cubes + " --repair o." + ending + " --check closed,manifold,components=2 -q").err.empty());
      holds(folder, "o." + ending, "closed,manifold,components=2");
    }
    // Two tetrahedra with a common vertex.
    folder.file(
        "p.off",
        "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 0 4 5\n"
        "3 0 6 4\n3 0 5 6\n3 4 6 5\n");
    meshtopo_says(folder, "p.off --repair o.stl --check manifold -q", 4,
                  "STL cannot keep apart the vertices of 1 place at which surfaces touch");
    CHECK(json::parse(folder.meshtopo("p.off --repair o.stl --check pinches=1 --json").out)["result"]["pinches"] == 1);
  }

  TEST_CASE("STL of every verb passes the promised check, near and far from the origin") {
    // A shift of whole numbers changes nothing; far from the origin, at a map's coordinates, single precision has
    // some hundred places across the sphere.
    for (const double far : {0.0, 100.0, 500000.0, 3e7}) {
      const Folder folder;
      CAPTURE(far);
      folder.file("p.xyzn", sphere(600, far, 9 * far, 0));
      const std::string in = "p.xyzn --radius 0.4 -q ";
      for (const std::string& command : {"surface " + in + "--watertight", "surface " + in + "--manifold",
                                         "surface " + in, std::string("solid p.xyzn --alpha inf -q --boundary")}) {
        const std::string to = command.ends_with("--boundary") ? " o.stl" : " -o o.stl";
        CAPTURE(command);
        const Outcome plain = folder.rbpa(command + to);
        CHECK(plain.code == (far < 1000 ? 0 : 1));
        CHECK(folder.has("o.stl") == (plain.code == 0));
        if (plain.code == 0)
          holds(folder, "o.stl", "closed,manifold,oriented,genus=0,geometric_defects=0");
        else
          CHECK(contains(plain.err, "nothing is written"));
        folder.rbpa(command + to + " --shift auto", 0);
        holds(folder, "o.stl", "closed,manifold,oriented,genus=0,geometric_defects=0");
        std::filesystem::remove(folder.path("o.stl"));
      }
      CHECK(folder.rbpa("surface " + in + "--watertight -o o.glb").code == 0);
      CHECK(folder.rbpa("surface " + in + "--watertight -o o.ply").code == 0);
    }
  }

  TEST_CASE("points too close to each other are refused if no shift helps") {
    const Folder folder;
    const std::string in =
        "surface " + finding("scan_stl_float/cube_ulp.xyz") + " --radius auto --keep-largest 1 --watertight -q -o ";
    says(folder, in + "o.stl", 1, "--watertight: o.stl: single precision leaves 2 of 304 triangles without area");
    CHECK_FALSE(folder.has("o.stl"));
    CHECK(folder.rbpa(in + "o.stl --shift auto").code == 0);
    holds(folder, "o.stl", "closed,manifold,geometric_defects=0");
    CHECK(folder.rbpa(in + "o.glb").code == 0);
    CHECK(folder.rbpa(in + "o.ply").code == 0);
    holds(folder, "o.ply", "closed,manifold");
    folder.file("t.off", "OFF\n4 4 0\n0 0 0\n1 1 0\n1 1.000000000001 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    const Outcome outcome = folder.meshtopo("t.off --orient -o t.stl -q", 4);
    CHECK(outcome.err ==
          "meshtopo: t.stl: single precision leaves 2 of 4 triangles without area and moves 1 of 4 vertices onto "
          "others (not as .ply, .obj or .off, in double precision); it is not written\n");
    CHECK(folder.meshtopo("t.off --orient -o t.stl -q --shift auto").code == 4);
    CHECK_FALSE(folder.has("t.stl"));
    folder.file("p.xyz", "0 0 0\n2 1 1\n0 1 0\n0 0 1\n.1 .2 .3\n.2 .2 .2\n2.000000001 1 1\n");
    CHECK(
        contains(folder.rbpa("solid p.xyz --alpha inf -q --boundary t.stl").err, "moves 1 of 5 vertices onto others"));
  }
}
