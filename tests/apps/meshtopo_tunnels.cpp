// meshtopo --close-tunnels-below, and --generators --shortest.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "support/changed_mesh.h"
#include "support/data_folder.h"
#include "support/mesh_files.h"

using namespace apps_test;
using nlohmann::json;

namespace {

using Cell = std::array<int, 3>;

/// The surface of unit cubes, as squares.
Mesh surface_of(const std::set<Cell>& cells) {
  Mesh mesh;
  std::map<Cell, std::uint32_t> number;
  const auto vertex = [&](Cell at) {
    const auto [found, is_new] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new)
      mesh.positions.push_back({static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
    return found->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell across = cell;
        across[axis] += 2 * side - 1;
        if (cells.contains(across)) continue;
        std::vector<std::uint32_t> face;
        for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          Cell corner = cell;
          corner[axis] += side;
          corner[(axis + 1) % 3] += side == 1 ? u : v;
          corner[(axis + 2) % 3] += side == 1 ? v : u;
          face.push_back(vertex(corner));
        }
        mesh.faces.push_back(face);
      }
  return mesh;
}

/// A plate of (2n + 1)² cubes, of which n² are missing: of genus n².
Mesh grating(int n) {
  std::set<Cell> cells;
  for (int x = 0; x < 2 * n + 1; ++x)
    for (int y = 0; y < 2 * n + 1; ++y)
      if (x % 2 == 0 || y % 2 == 0) cells.insert({x, y, 0});
  return surface_of(cells);
}

double length_of(const json& loops) {
  double sum = 0;
  for (const json& loop : loops) {
    const auto places = loop["positions"].get<Positions>();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto &a = places[i], &b = places[(i + 1) % places.size()];
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  }
  return sum;
}

}  // namespace

TEST_SUITE("meshtopo --close-tunnels-below") {
  TEST_CASE("tunnels with a loop below the length are closed, and nothing else changes its topology") {
    const Folder folder;
    for (const int n : {1, 2, 4}) {
      folder.file("m.off", grating(n).off());
      const json none =
          changed(folder, "m.off --close-tunnels-below 4 -o w.off --check genus=" + std::to_string(n * n));
      CHECK(none["changes"]["tunnels"] == json{{"closed", 0}, {"left", 0}, {"faces_removed", 0}, {"faces_added", 0}});
      CHECK(folder.content("w.off") == folder.content("m.off"));
      const json r = changed(folder,
                             "m.off --close-tunnels-below 4.001 -o w.off --check "
                             "closed,manifold,oriented,genus=0,components=1,isolated=0");
      const json& t = r["changes"]["tunnels"];
      CHECK(t["closed"] == n * n);
      CHECK(t["left"] == 0);
      CHECK(r["result"]["faces"].get<int>() ==
            r["faces"].get<int>() - t["faces_removed"].get<int>() + t["faces_added"].get<int>());
    }
    CHECK(contains(folder.meshtopo("m.off --close-tunnels-below 4.001 -o w.off").out,
                   "\nchanges\n  tunnels: 16 closed, "));
  }

  TEST_CASE("a thin handle is cut, one that is thicker stays") {
    // A ring of cubes, 4 around its bar and 8 through its hole, on a block whose slices are 12 around.
    std::set<Cell> cells;
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z) cells.insert({x, y, z});
    for (const Cell& cell :
         {Cell{0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {1, 1, 5}, {2, 1, 5}, {3, 1, 5}, {4, 1, 5}, {4, 1, 4}, {4, 1, 3}})
      cells.insert(cell);
    const Folder folder("m.off", surface_of(cells).off());
    CHECK(changed(folder, "m.off --close-tunnels-below 3.9 -o w.off")["result"]["genus"] == 1);
    CHECK(changed(folder,
                  "m.off --close-tunnels-below 4.1 -o w.off --check closed,manifold,components=1")["result"]["genus"] ==
          0);
  }

  TEST_CASE("the holes of a machined plate are closed by length") {
    const Folder folder;
    const std::string plate = "'" + (rbpa_test::bundled_data() / "m3_plate_holes.off").string() + "'";
    CHECK(changed(folder, plate + " --close-tunnels-below 20 -o w.off")["result"]["genus"] == 5);
    CHECK(changed(folder, plate + " --close-tunnels-below 25 -o w.off --check closed,manifold")["result"]["genus"] ==
          0);
  }

  TEST_CASE("a tunnel with another part in it stays, as do the holes of an open surface") {
    const Folder folder;
    std::set<Cell> cells;
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 5; ++y)
        if (x != 2 || y != 2) cells.insert({x, y, 0});
    Mesh through = surface_of(cells);
    folder.file("m.off", through.off());
    CHECK(changed(folder, "m.off --close-tunnels-below 4.001 -o w.off")["result"]["genus"] == 0);
    through.add_box({2.25, 2.25, -1}, {2.75, 2.75, 2});
    folder.file("m.off", through.off());
    const json r = changed(folder, "m.off --close-tunnels-below 4.001 -o w.off");
    CHECK(r["changes"]["tunnels"]["closed"] == 0);
    CHECK(r["changes"]["tunnels"]["left"].get<int>() >= 1);
    CHECK(folder.content("w.off") == folder.content("m.off"));
    // A square with a hole: a loop generates its homology, and is not a tunnel.
    folder.file("s.off",
                "OFF\n8 4 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n"
                "4 3 0 4 7\n");
    CHECK(changed(folder, "s.off --close-tunnels-below 99 -o w.off")["result"]["boundary_curves"] == 2);
    CHECK(folder.content("w.off") == folder.content("s.off"));
    // With the hole filled no loop is left.
    CHECK(changed(folder, "s.off --fill-holes all --close-tunnels-below 99 -o w.off")["changes"]["tunnels"]["left"] ==
          0);
  }

  TEST_CASE("closing tunnels requires a length and a surface") {
    const Folder folder("m.off", pyramid_off);
    for (const std::string wrong : {"0", "-1", "x", "nan", "inf", "1e999"}) {
      meshtopo_refuses(folder, "m.off -o w.off --close-tunnels-below=" + wrong, 2,
                       "--close-tunnels-below: found '" + wrong + "', expected a length, such as 2.5");
    }
    CHECK(folder.meshtopo("m.off --close-tunnels-below 1").err ==
          "meshtopo: --close-tunnels-below changes the mesh, and requires a file for it (-o OUT or --repair OUT), or "
          "--check\n");
    folder.file("t.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 2 1\n3 0 1 3\n3 0 1 4\n");
    CHECK(folder.meshtopo("t.off -q -o w.off --close-tunnels-below 1")
              .err.ends_with("expected a surface, as --close-tunnels-below requires (--repair makes one, or rbpa "
                             "surface --manifold)\n"));
    CHECK(folder.meshtopo("t.off -q --repair w.off --close-tunnels-below 1").code == 0);
  }
}

TEST_SUITE("meshtopo --generators --shortest") {
  TEST_CASE("shortest loops are as many, of no greater total length, the shortest first") {
    const Folder folder("m.off", grating(3).off());
    REQUIRE(folder.meshtopo("m.off -q --generators l.json").code == 0);
    REQUIRE(folder.meshtopo("m.off -q --generators s.json --shortest").code == 0);
    const json some = json::parse(folder.content("l.json")), shortest = json::parse(folder.content("s.json"));
    CHECK(some.size() == 18);
    REQUIRE(shortest.size() == 18);
    CHECK(length_of(shortest) < length_of(some));
    double before = 0;
    for (const json& loop : shortest) {
      const double length = length_of(json::array({loop}));
      CHECK(length >= before);
      before = length;
    }
    // Around each bar of the grating, or each hole, go four edges.
    CHECK(length_of(shortest) == 18 * 4);
    CHECK(folder.meshtopo("m.off --shortest").err == "meshtopo: --shortest requires --generators\n");
  }
}
