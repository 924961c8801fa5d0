// meshtopo --fill-holes: holes that are closed, and that stay and why, for meshes of any faces in any order.
#include <doctest/doctest.h>

#include "support/changed_mesh.h"
#include "support/data_folder.h"
#include "support/mesh_files.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// A box of unit squares without some of its faces.
Mesh open_box(const std::vector<std::size_t>& without) {
  Mesh mesh;
  mesh.add_box({0, 0, 0}, {1, 2, 3});
  Mesh open{.positions = mesh.positions, .faces = {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (std::find(without.begin(), without.end(), f) == without.end()) open.faces.push_back(mesh.faces[f]);
  return open;
}

/// A flat grid of n × n squares, without one in its middle.
Mesh sheet(std::uint32_t n) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.push_back({static_cast<double>(x), static_cast<double>(y), 0});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x)
      if (x != n / 2 || y != n / 2) {
        const std::uint32_t at = y * (n + 1) + x;
        mesh.faces.push_back({at, at + 1, at + n + 2, at + n + 1});
      }
  return mesh;
}

}  // namespace

TEST_SUITE("meshtopo --fill-holes") {
  TEST_CASE("a box without faces is whole again; the given faces are unchanged, in any order") {
    std::mt19937 random(61);
    const Folder folder;
    for (const std::vector<std::size_t>& without : {std::vector<std::size_t>{5}, {0, 1}, {0, 2}, {0, 2, 4}}) {
      Mesh open = open_box(without);
      std::multiset<Positions> expected;
      for (int i = 0; i < 6; ++i) {
        folder.file("m.off", open.off());
        const auto given = places_of(folder, "m.off");
        const json r = changed(folder, "m.off --fill-holes rims -o w.off --check closed,manifold,oriented,genus=0");
        const std::size_t curves = r["boundary_curves"];
        CHECK(r["changes"]["fill"]["holes"] == curves);
        CHECK(r["changes"]["fill"]["vertices_merged"] == 0);
        CHECK(r["result"]["vertices"] == 8);
        CHECK(r["result"]["faces"].get<std::size_t>() ==
              6 - without.size() + r["changes"]["fill"]["triangles"].get<std::size_t>());
        const auto filled = places_of(folder, "w.off");
        CHECK(std::includes(filled.begin(), filled.end(), given.begin(), given.end()));
        // With one face of a box missing, or two across from each other, there is one filling of least area: the face
        // itself.
        if (without.size() == 1 || without == std::vector<std::size_t>{0, 1}) CHECK(six_volumes(folder, "w.off") == 36);
        if (expected.empty()) expected = filled;
        CHECK(filled == expected);
        const std::string text = folder.content("m.off"), whole = folder.content("w.off");
        CHECK(whole.substr(whole.find('\n', 4), text.size() - text.find('\n', 4)) == text.substr(text.find('\n', 4)));
        open.shuffle(random);
      }
    }
  }

  TEST_CASE(
      "a hole of a sheet is filled and its rim is not, unless rims are chosen; holes are chosen as in rbpa surface") {
    const Folder folder("m.off", sheet(5).off());
    const auto fill = [&](const std::string& choice) {
      const json r = changed(folder, "m.off -o w.off --fill-holes " + choice);
      const json& f = r["changes"]["fill"];
      CHECK(f["holes"].get<int>() + f["left"]["crosses"].get<int>() + f["not_chosen"]["rim"].get<int>() +
                f["not_chosen"]["hole"].get<int>() ==
            2);
      return f;
    };
    CHECK(fill("all") ==
          json::parse(R"({"holes": 1, "triangles": 2, "area": 1.0, "left": {"crosses": 0, "edge_taken": 0,
          "no_area": 0, "too_much_work": 0}, "not_chosen": {"rim": 1, "hole": 0, "island": 0},
          "vertices_merged": 0})"));
    CHECK(fill("4")["holes"] == 1);
    CHECK(fill("3")["not_chosen"]["hole"] == 1);
    CHECK(fill("length=4")["holes"] == 1);
    CHECK(fill("length=3.99")["not_chosen"]["hole"] == 1);
    CHECK(fill("rims")["left"]["crosses"] == 1);  // whatever spans the rim of a plane lies in the plane
    CHECK(contains(folder.meshtopo("m.off --fill-holes rims --check closed").out,
                   "\nchanges\n  fill: 1 hole filled by 2 triangles of area 1\n"
                   "  fill: 1 hole not filled: 1 where any filling crosses the surface\n\nresult\n"));
    CHECK(contains(folder.meshtopo("m.off --fill-holes 3 -o w.off").out,
                   "\nchanges\n  fill: 0 holes filled by 0 triangles of area 0\n  fill: 1 hole left open, larger than "
                   "--fill-holes allows\n"
                   "  fill: 1 rim of a sheet left open (--fill-holes rims fills them)\n\nresult\n"));
    for (const std::string wrong : {"2", "0", "-1", "x", "length=0", "length="})
      CHECK(folder.meshtopo("m.off -o w.off '--fill-holes=" + wrong + "'").err ==
            "meshtopo: --fill-holes: found '" + wrong +
                "', expected all, rims, a number of edges from 3, such as 30, or a length, such as length=2.5\n");
  }

  TEST_CASE("a bowl is a rim, and is closed when rims are chosen") {
    const Folder folder("m.off", "OFF\n4 3 0\n0 0 0\n3 0 1\n0 3 1\n-3 -3 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n");
    CHECK(changed(folder, "m.off -o w.off --fill-holes all")["result"]["boundary_curves"] == 1);
    CHECK(changed(folder, "m.off -o w.off --fill-holes rims --check closed,genus=0")["result"]["faces"] == 4);
  }

  TEST_CASE("an obstacle in a hole keeps it open, also a face of many corners") {
    Mesh mesh = open_box({1});
    mesh.add_box({0.25, 0.25, 2}, {0.75, 0.75, 4});  // through the middle of the open top
    const Folder folder("m.off", mesh.off());
    const json r = changed(folder, "m.off -o w.off --fill-holes all");
    CHECK(r["changes"]["fill"]["left"]["crosses"] == 1);
    CHECK(folder.content("w.off") == folder.content("m.off"));
    // Without the obstacle the hole is filled.
    Mesh beside = open_box({1});
    beside.add_box({1.25, 0.25, 2}, {1.75, 0.75, 4});
    folder.file("m.off", beside.off());
    CHECK(changed(folder, "m.off -o w.off --fill-holes all --check closed")["result"]["components"] == 2);
  }

  TEST_CASE("vertices at which fans of faces meet are not split, and those at one place along a hole are merged") {
    const Folder folder;
    // Two tetrahedra with an open face each, and a common vertex.
    folder.file("p.off",
                "OFF\n7 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 0 4 5\n"
                "3 0 6 4\n3 0 5 6\n");
    const json p = changed(folder, "p.off -o w.off --fill-holes rims");
    CHECK(p["changes"]["fill"]["holes"] == 2);
    CHECK(p["result"]["vertices"] == 7);
    CHECK(p["result"]["boundary_curves"] == 0);
    CHECK(p["result"]["pinches"] == 1);
    // A slit, with two vertices in its middle.
    folder.file(
        "c.off",
        "OFF\n9 8 0\n9 9 9\n0 0 0\n2 0 0\n1 0 0\n1 0 -0\n1 1 0\n1 -1 0\n-1 0 0\n3 0 0\n3 1 3 5\n3 3 2 5\n3 2 4 6\n"
        "3 4 1 6\n3 1 5 7\n3 1 7 6\n3 2 8 5\n3 2 6 8\n");
    const json c = changed(folder, "c.off -o w.off --fill-holes all --check boundary_curves=1,manifold");
    CHECK(c["boundary_curves"] == 2);
    CHECK(c["changes"]["fill"]["holes"] == 1);
    CHECK(c["changes"]["fill"]["triangles"] == 0);
    CHECK(c["changes"]["fill"]["vertices_merged"] == 1);
    CHECK(c["result"]["isolated"] == 1);
    CHECK(folder.content("w.off") ==
          "OFF\n8 8 0\n9 9 9\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n-1 0 0\n3 0 0\n3 1 3 4\n3 3 2 4\n3 2 3 5\n3 3 1 5\n3 "
          "1 4 6\n"
          "3 1 6 5\n3 2 7 4\n3 2 5 7\n");
  }

  TEST_CASE("a filled mesh is a surface: where vertices are merged, edges of more than two faces are cut") {
    for (const std::string name : {"plate.off", "box.off"}) {
      const Folder folder;
      CAPTURE(name);
      const std::string mesh = (rbpa_test::bundled_data() / "findings" / "case_fill_joins_fans" / name).string();
      const Outcome outcome = folder.meshtopo(
          mesh + " --repair o.ply --fill-holes rims --generators g.obj --shortest --check oriented,manifold -q");
      CHECK(outcome.err == "");
      CHECK(outcome.code == 0);
      CHECK(folder.meshtopo("o.ply --check oriented,manifold -q").code == 0);
    }
  }

  TEST_CASE(
      "filling requires a surface, which a repair makes, and works with several meshes, loops and other changes") {
    const Folder folder("t.off",
                        "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 0 1 4\n");
    meshtopo_refuses(folder, "t.off -q --fill-holes rims -o w.off", 3,
                     "t.off: found non-manifold edge (vertices 0 1, faces 0 1 3, lines 8 9 11), expected a surface, as "
                     "--fill-holes requires (--repair makes one, or rbpa surface --manifold)");
    CHECK_FALSE(folder.has("w.off"));
    const json r = changed(folder, "t.off --drop-small 2 --repair w.off --fill-holes rims --check closed,genus=0");
    CHECK(r["changes"]["drop"]["components"] == 1);
    CHECK(r["changes"]["fill"]["holes"] == 1);
    CHECK(r["result"]["faces"] == 4);
    folder.file("a.off", open_box({0}).off());
    folder.file("b.off", pyramid_off);
    CHECK(folder.meshtopo("a.off b.off -q --check closed").code == 4);
    CHECK(folder.meshtopo("a.off b.off -q --fill-holes all --check closed").code == 0);
    CHECK(changed(folder, "a.off --fill-holes all --generators g.json")["result"]["boundary_curves"] == 0);
    CHECK(json::parse(folder.content("g.json")).empty());
    CHECK(folder.meshtopo("b.off --fill-holes all -o w.off -q").code == 0);
    CHECK(folder.content("w.off") == pyramid_off);
  }
}
