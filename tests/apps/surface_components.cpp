// Components of `rbpa surface`: islands, shells, dropped components; and files that are manifold for readers.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/spiral.h"
#include "triangulation/surface_counts.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns a sphere of radius 1 around the origin with a hole above 0.7, and far from it a triangle; each point with
/// its normal.
std::string sphere_and_island() {
  std::string text = "3 0 0 0 0 1\n3.1 0 0 0 0 1\n3 0.1 0 0 0 1\n";
  for (const rbpa::Point3& at : rbpa_test::spiral(600)) {
    const std::string p = rbpa_test::text_of(at);
    if (at.z <= 0.7) text += p + " " + p + "\n";
  }
  return text;
}

/// Two tetrahedra that touch along an edge.
const std::string touching = "0 0 0\n0 0 1\n1 0.4 0.5\n1 -0.4 0.5\n-1 0.4 0.5\n-1 -0.4 0.5\n";

void refuses(const Folder& folder, const std::string& options, const std::string& message) {
  refuses(folder, "surface p.xyz --radius 1 -o m.off " + options, 2, message);
  CHECK(!folder.has("m.off"));
}

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("the rim of a stray triangle is that of an island, not a hole, in text, JSON and the file of curves") {
    const Folder folder("s.xyz", sphere_and_island());
    const Outcome outcome = folder.rbpa("surface s.xyz --radius 0.3 --holes h.obj --json -o m.npy", 0);
    CHECK(!contains(outcome.err, "997 triangles"));
    CHECK(contains(outcome.err, "\nrbpa: hole of length "));
    CHECK(
        contains(outcome.err, "\nrbpa: 1 rim of an island of length 0.341421: 3 edges, 3 with nothing within reach\n"));
    const json report = json::parse(outcome.out);
    CHECK(report["curves"] == json::parse(R"({"rim": 0, "hole": 1, "island": 1})"));
    REQUIRE(report["component_list"].size() == 2);
    const json& island = report["component_list"][1];
    CHECK(island["triangles"] == 1);
    CHECK(island["boundary_curves"] == 1);
    CHECK(island["area"].get<double>() == doctest::Approx(0.005));
    CHECK(island["volume"].is_null());
    CHECK(island["box"] == json::parse("[[3, 0, 0], [3.1, 0.1, 0]]"));
    const std::string curves = folder.content("h.obj");
    CHECK(contains(curves, "\ng hole\nl "));
    CHECK(curves.ends_with("\ng island\nl 1 3 2 1\n"));
  }

  TEST_CASE("components that are small or not among the largest are dropped everywhere, and their points are counted") {
    const Folder folder("s.xyz", sphere_and_island());
    const std::string run = "surface s.xyz --radius 0.3 --holes h.obj --json ";
    const json whole = json::parse(folder.rbpa(run + "-o whole.npy").out);
    for (const std::string option : {"--keep-largest 1", "--drop-small 2", "--drop-small area=0.006"}) {
      CAPTURE(option);
      const Outcome outcome = folder.rbpa(run + option + " -o m.npy -o m.off --compact", 0);
      CHECK(contains(outcome.err, "\nrbpa: 1 of 2 components dropped: 1 of "));
      CHECK(contains(outcome.err, " %) of area 0.005 ("));
      CHECK(contains(outcome.err, " %), of genus 0, and 3 points left without a triangle\n"));
      CHECK(contains(outcome.err, ", genus 0, after 1 component was dropped ("));
      CHECK(!contains(outcome.err, "island"));
      const json report = json::parse(outcome.out);
      CHECK(report["components"] == 1);
      CHECK(report["curves"] == json::parse(R"({"rim": 0, "hole": 1, "island": 0})"));
      CHECK(report["dropped"]["points"] == 3);
      CHECK(report["dropped"]["genus"] == 0);
      CHECK(report["dropped"]["triangle_share"] == 1.0 / whole["triangles"].get<double>());
      CHECK(report["dropped"]["area_share"].get<double>() == doctest::Approx(0.005 / whole["area"].get<double>()));
      CHECK(report["triangles"].get<int>() == whole["triangles"].get<int>() - 1);
      REQUIRE(report["holes"].size() == 1);
      CHECK(report["holes"][0] == whole["holes"][1]);
      CHECK(!contains(folder.content("h.obj"), "g island"));
      CHECK(folder.content("m.npy").size() + 12 == folder.content("whole.npy").size());
      const json topology = json::parse(folder.meshtopo("m.off --json").out);
      CHECK(topology["vertices"] == report["vertices"]);
      CHECK(topology["components"] == 1);
    }
    const Outcome kept = folder.rbpa(run + "--keep-largest 2 --drop-small 1 -o m.npy");
    CHECK(json::parse(kept.out) == whole);
    CHECK(folder.content("m.npy") == folder.content("whole.npy"));
    const Outcome none = folder.rbpa("surface s.xyz --radius 0.3 --drop-small 5000 -o n.npy -q", 0);
    CHECK(none.err == "rbpa: there is no triangle: 2 components dropped, and none kept\n");
  }

  TEST_CASE("the outer shell of a closed body is kept, without the inside and bodies in it") {
    const Folder folder;
    std::string points;
    for (const auto& [radius, count] : {std::pair{1.0, 800}, std::pair{0.3, 100}})
      for (const rbpa::Point3& p : rbpa_test::spiral(count))
        points += rbpa_test::text_of({radius * p.x, radius * p.y, radius * p.z}) + "\n";
    folder.file("b.xyz", points);
    const std::string run = "surface b.xyz --radius 0.2 --normals none --json ";
    const json all = json::parse(folder.rbpa(run + "-o all.ply").out);
    CHECK(all["components"].get<int>() > 2);
    CHECK(folder.rbpa(run + "--shell all -o same.ply").code == 0);
    CHECK(folder.content("all.ply") == folder.content("same.ply"));
    for (const std::string choice : {"outer", "largest"}) {
      CAPTURE(choice);
      const json report = json::parse(folder.rbpa(run + "--shell " + choice + " --compact -o outer.ply").out);
      CHECK(report["components"] == 1);
      CHECK(report["closed_components"] == 1);
      CHECK(report["boundary_curves"] == 0);
      CHECK(report["component_list"][0]["volume"].get<double>() == doctest::Approx(4.19).epsilon(0.03));
      const json topology = json::parse(folder.meshtopo("outer.ply --json").out);
      CHECK(topology["betti"] == json::parse("[1, 0, 1]"));
      CHECK(topology["defects"].empty());
    }
  }

  TEST_CASE("bodies that touch are a manifold file with --manifold, and without it the summary gives a warning") {
    const Folder folder("t.xyz", touching);
    const std::string run = "surface t.xyz --radius 0.7 --normals none --json ";
    const Outcome plain = folder.rbpa(run + "-o plain.ply");
    CHECK(contains(plain.err,
                   "\nrbpa: 1 non-manifold edge, with more than two triangles (--manifold splits their vertices)\n"));
    CHECK(json::parse(plain.out)["non_manifold_edges"] == 1);
    CHECK(!json::parse(folder.meshtopo("plain.ply --json").out)["defects"].empty());

    const Outcome split = folder.rbpa(run + "--manifold -o m.ply -o m.off -o m.obj -o m.npy", 0);
    CHECK(!contains(split.err, "more than two"));
    const json report = json::parse(split.out);
    CHECK(report["non_manifold_edges"] == 0);
    CHECK(report["components"] == 2);
    CHECK(report["closed_components"] == 2);
    for (const std::string name : {"m.ply", "m.off", "m.obj"}) {
      CAPTURE(name);
      const json topology = json::parse(folder.meshtopo(name + " --json").out);
      CHECK(topology["defects"].empty());
      for (const std::string key : {"vertices", "edges", "components", "boundary_curves", "genus"}) {
        CAPTURE(key);
        CHECK(topology[key] == report[key]);
      }
      CHECK(topology["faces"] == report["triangles"]);
    }
    // Each vertex has the index of its point.
    const std::string ply = folder.content("m.ply");
    CHECK(contains(ply, "element vertex 8\n"));
    CHECK(contains(ply, "property uint point\n"));
    const std::size_t data = ply.find("end_header\n") + 11, row = 3 * 8 + 4;
    std::vector<std::uint32_t> point(8);
    for (std::size_t v = 0; v < point.size(); ++v) std::memcpy(&point[v], &ply[data + v * row + 24], 4);
    CHECK(point == std::vector<std::uint32_t>{0, 0, 1, 1, 2, 3, 4, 5});
    CHECK(folder.rbpa(run + "-o plain.npy").code == 0);
    CHECK(folder.content("m.npy") == folder.content("plain.npy"));
    // A surface that needs no splitting has the file of --compact, except for that property.
    folder.file("s.xyz", sphere_and_island());
    CHECK(folder.rbpa("surface s.xyz --radius 0.3 --compact -o c.off -q").code == 0);
    CHECK(folder.rbpa("surface s.xyz --radius 0.3 --manifold -o c2.off -q").code == 0);
    CHECK(folder.content("c.off") == folder.content("c2.off"));
  }

  TEST_CASE("the component with the longest diagonal comes first, also where the diagonals overflow") {
    const double most = std::numeric_limits<double>::max();
    rbpa::SurfaceComponents components;
    components.all.push_back({.triangles = 2, .volume = 1, .low = {-most, -most, 0}, .high = {most, most, 0}});
    components.all.push_back({.triangles = 1, .low = {-most, -most, -most}, .high = {most, most, most}});
    components.number = {0, 1, 0};
    CHECK(rbpa::app::by_shells(components) == std::vector<std::uint32_t>{1, 0, 2});
  }

  TEST_CASE("wrong choices of components are refused before anything is read") {
    const Folder folder;
    const std::string small = ", expected a number of triangles, such as 50, or an area, such as area=2.5";
    refuses(folder, "--keep-largest 0", "--keep-largest: found '0', expected a whole number of components from 1");
    refuses(folder, "--keep-largest 1.5", "--keep-largest: found '1.5', expected a whole number of components from 1");
    refuses(folder, "--keep-largest=-1", "--keep-largest: found '-1', expected a whole number of components from 1");
    for (const std::string text : {"0", "2.5", "area=0", "area=", "area=nan", "x"})
      refuses(folder, "--drop-small " + text, "--drop-small: found '" + text + "'" + small);
    refuses(folder, "--shell outer", "--shell requires --normals none");
    refuses(folder, "--normals none --shell inner", "--shell: found 'inner', expected outer, largest or all");
  }
}
