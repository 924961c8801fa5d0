// meshtopo --weld, --keep-largest, --drop-small and --orient.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshtopo/exact.h"
#include "meshtopo/weld.h"
#include "support/changed_mesh.h"
#include "support/data_folder.h"
#include "support/mesh_files.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Finds chains of steps by a search over all pairs, in whole numbers, so that squares are exact.
std::vector<std::uint32_t> near_by_brute_force(const Positions& positions, double distance) {
  std::vector<std::uint32_t> least(positions.size());
  std::iota(least.begin(), least.end(), 0U);
  for (bool any = true; any;) {
    any = false;
    for (std::size_t a = 0; a < positions.size(); ++a)
      for (std::size_t b = 0; b < positions.size(); ++b) {
        double squares = 0;
        for (std::size_t k = 0; k < 3; ++k) squares += std::pow(positions[a][k] - positions[b][k], 2);
        if (squares > distance * distance || least[a] <= least[b]) continue;
        least[a] = least[b];
        any = true;
      }
  }
  return least;
}

}  // namespace

TEST_SUITE("meshtopo --weld") {
  TEST_CASE("chains of near vertices are those of a search over all pairs") {
    std::mt19937 random(41);
    for (int i = 0; i < 400; ++i) {
      const int size = 1 + static_cast<int>(random() % 30), flat = static_cast<int>(random() % 4);
      Positions positions(1 + random() % 60);
      for (auto& p : positions)
        for (int k = 0; k < 3; ++k)
          p[static_cast<std::size_t>(k)] =
              k < flat ? 7 : static_cast<double>(random() % static_cast<unsigned>(size)) - 3;
      for (const double distance : {0.0, 1.0, 1.4142135623730951, 1.5, 2.0, 3.0, 5.0, 100.0}) {
        CAPTURE(distance);
        const auto expected = near_by_brute_force(positions, distance);
        CHECK(rbpa::app::near_vertices(positions, distance) == expected);
        // Scaling by a power of two, however large or small, changes nothing.
        for (const int exponent : {-1040, 960}) {
          Positions scaled = positions;
          for (auto& p : scaled)
            for (double& x : p) x = std::scalbn(x, exponent);
          const bool is_exact = std::scalbn(std::scalbn(distance, exponent), -exponent) == distance;
          if (is_exact) CHECK(rbpa::app::near_vertices(scaled, std::scalbn(distance, exponent)) == expected);
        }
      }
    }
  }

  TEST_CASE("clusters far from each other are welded, also by a distance that is tiny compared to the box") {
    Positions positions;
    for (const double far : {0.0, 1e300, -1e300})
      for (int i = 0; i < 5; ++i) positions.push_back({far, static_cast<double>(i), 0});
    CHECK(rbpa::app::near_vertices(positions, 1) ==
          std::vector<std::uint32_t>{0, 0, 0, 0, 0, 5, 5, 5, 5, 5, 10, 10, 10, 10, 10});
    CHECK(rbpa::app::near_vertices(positions, 0.5)[4] == 4);
    CHECK(rbpa::app::near_vertices({{0, 0, 0}, {5e-324, 0, 0}, {1e308, 1e308, 1e308}}, 5e-324) ==
          std::vector<std::uint32_t>{0, 0, 2});
    CHECK(rbpa::app::near_vertices({{-1.7e308, 0, 0}, {1.7e308, 0, 0}}, 1.7e308) == std::vector<std::uint32_t>{0, 1});
    CHECK(rbpa::app::near_vertices({}, 1).empty());
  }

  TEST_CASE("nearness is exact to the last bit of the distance") {
    CHECK(rbpa::app::are_within({0, 0, 0}, {3, 4, 12}, 13));
    CHECK_FALSE(rbpa::app::are_within({0, 0, 0}, {3, 4, 12}, std::nextafter(13.0, 0.0)));
    CHECK_FALSE(rbpa::app::are_within({0, 0, 0}, {3, 4, std::nextafter(12.0, 13.0)}, 13));
    CHECK(rbpa::app::are_within({0, 0, 0}, {3e-320, 4e-320, 0}, 5.0001e-320));
    CHECK_FALSE(rbpa::app::are_within({0, 0, 0}, {3e-320, 4e-320, 0}, 4.999e-320));
    // 0.1 + 0.2 is off by a bit that a sum in doubles does not show.
    CHECK_FALSE(rbpa::app::are_within({1, 0, 0}, {1.1, 0, 0}, 0.1));
    CHECK(rbpa::app::are_within({1, 0, 0}, {1.1, 0, 0}, std::nextafter(0.1, 1.0) + 1e-16));
    CHECK_FALSE(rbpa::app::are_within({-1e308, 0, 0}, {1e308, 0, 0}, 1.7e308));
    CHECK(rbpa::app::are_within({-8e307, 0, 0}, {8e307, 0, 0}, 1.7e308));
  }

  TEST_CASE("a box whose faces came apart is closed again, whatever the order") {
    std::mt19937 random(43);
    Mesh box;
    box.add_box({0, 0, 0}, {1, 2, 3});
    Mesh apart;
    for (const auto& face : box.faces) {
      apart.faces.emplace_back();
      for (const std::uint32_t corner : face) {
        apart.faces.back().push_back(static_cast<std::uint32_t>(apart.positions.size()));
        apart.positions.push_back(box.positions[corner]);
        for (double& x : apart.positions.back()) x += static_cast<double>(random() % 3) / 1024;
      }
    }
    const Folder folder;
    std::multiset<Positions> expected;
    for (int i = 0; i < 6; ++i) {
      folder.file("m.off", apart.off());
      CHECK(folder.meshtopo("m.off -q --check closed").code == 4);
      const json r = changed(folder, "m.off --weld 0.01 -o w.off");
      CHECK(r["vertices"] == 24);
      CHECK(r["changes"]["weld"] == json::parse(R"({"distance": 0.01, "vertices_merged": 16, "corners_dropped": 0,
            "degenerate_faces_dropped": 0, "duplicate_faces_dropped": 0})"));
      CHECK(r["result"]["vertices"] == 8);
      CHECK(folder.meshtopo("w.off -q --check closed,manifold,oriented,genus=0,components=1,vertices=8").code == 0);
      if (expected.empty()) expected = places_of(folder, "w.off");
      CHECK(places_of(folder, "w.off") == expected);
      apart.shuffle(random);
    }
    CHECK(changed(folder, "m.off --weld 0 -o w.off")["result"]["vertices"] > 8);
  }

  TEST_CASE("faces and corners that coincide are dropped and counted") {
    const Folder folder("m.off",
                        "OFF\n8 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 -0\n0 0.001 0\n5 5 5\n1 0 0\n"
                        "3 0 1 2\n3 4 2 7\n3 0 5 2\n4 0 1 2 5\n3 0 4 6\n");
    const json r = changed(folder, "m.off --weld 0.001 -o w.off");
    CHECK(r["changes"]["weld"] == json::parse(R"({"distance": 0.001, "vertices_merged": 3, "corners_dropped": 0,
          "degenerate_faces_dropped": 2, "duplicate_faces_dropped": 2})"));
    CHECK(folder.content("w.off") == "OFF\n5 1 0\n0 0 -0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n3 0 1 2\n");
    const std::string text = folder.meshtopo("m.off --weld 0.001 -o w.off").out;
    CHECK(contains(text,
                   "\nchanges\n  weld 0.001: 3 vertices merged, 2 degenerate faces and 2 duplicate faces dropped\n"
                   "\nresult\n  vertices               5\n"));
    const json exact = changed(folder, "m.off --weld 0 -o e.off");
    CHECK(exact["changes"]["weld"]["vertices_merged"] == 2);
    folder.file("q.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 1 0\n5 0 1 2 3 4\n");
    CHECK(changed(folder, "q.off --weld 0 -o w.off")["changes"]["weld"]["corners_dropped"] == 1);
    CHECK(folder.content("w.off").ends_with("\n4 0 1 2 3\n"));
  }
}

TEST_SUITE("meshtopo --keep-largest and --drop-small") {
  TEST_CASE("components are dropped by area and by triangles, with their vertices") {
    std::mt19937 random(47);
    Mesh mesh;
    mesh.add_box({0, 0, 0}, {1, 1, 1});                    // area 6, of 12 triangles
    mesh.add_box({5, 0, 0}, {8, 3, 3});                    // area 54
    mesh.add_triangle({0, 9, 0}, {20, 9, 0}, {0, 9, 20});  // area 200
    mesh.positions.push_back({7, 7, 7});
    const Folder folder;
    for (int i = 0; i < 4; ++i) {
      folder.file("m.off", mesh.off());
      const auto kept = [&](const std::string& options) {
        const json r = changed(folder, "m.off " + options + " -o k.off");
        CHECK(r["changes"]["drop"]["components"].get<std::size_t>() + r["result"]["components"].get<std::size_t>() ==
              3);
        CHECK(r["result"]["isolated"] == 0);
        CHECK(r["changes"]["drop"]["faces"].get<std::size_t>() + places_of(folder, "k.off").size() == 13);
        return std::pair(r["result"]["faces"].get<int>(), r["result"]["vertices"].get<int>());
      };
      CHECK(kept("--keep-largest 1") == std::pair(1, 3));
      CHECK(kept("--keep-largest 2") == std::pair(7, 11));
      CHECK(kept("--keep-largest 9") == std::pair(13, 19));
      CHECK(kept("--drop-small 2") == std::pair(12, 16));
      CHECK(kept("--drop-small 12") == std::pair(12, 16));
      CHECK(kept("--drop-small 13") == std::pair(0, 0));
      CHECK(kept("--drop-small area=54") == std::pair(7, 11));
      CHECK(kept("--drop-small area=54.001") == std::pair(1, 3));
      CHECK(kept("--drop-small 2 --keep-largest 1") == std::pair(6, 8));
      mesh.shuffle(random);
    }
    CHECK(contains(folder.meshtopo("m.off --keep-largest 1 -o k.off").out,
                   "\nchanges\n  drop: 2 components, 12 faces, 17 vertices\n\nresult\n"));
  }

  TEST_CASE(
      "pieces that meet at a non-manifold edge or in a point are separate components; invalid faces are dropped") {
    const Folder folder;
    // A tetrahedron, a fin on one of its edges, a triangle in one of its corners, a repeated face and one without area.
    folder.file(
        "m.off",
        "OFF\n8 8 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n5 5 5\n-1 0 0\n0 -1 0\n9 9 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
        "3 1 2 4\n3 0 5 6\n3 0 1 2\n3 7 7 4\n");
    const json r = changed(folder, "m.off --keep-largest 1 -o k.off --check closed,manifold,oriented,components=1");
    CHECK(r["result"]["faces"] == 4);  // the tetrahedron: its faces next to the fin are connected through the others
  }

  TEST_CASE("the options take the same words as those of rbpa surface") {
    const Folder folder("m.off", pyramid_off);
    const auto refused = [&](const std::string& arguments) {
      const Outcome outcome = folder.meshtopo("m.off -o k.off " + arguments, 2);
      CHECK_FALSE(folder.has("k.off"));
      return outcome.err;
    };
    CHECK(refused("--keep-largest 0") ==
          "meshtopo: --keep-largest: found '0', expected a whole number of components from 1\n");
    for (const std::string text : {"0", "area=0", "area=", "area=x", "-3", "2.5", "area=inf"})
      CHECK(refused("'--drop-small=" + text + "'") ==
            "meshtopo: --drop-small: found '" + text +
                "', expected a number of triangles, such as 50, or an area, such as area=2.5\n");
    for (const std::string text : {"-1", "x", "0.1m", "inf", "nan", "1e999"})
      CHECK(refused("'--weld=" + text + "'") ==
            "meshtopo: --weld: found '" + text + "', expected a distance, at least 0\n");
  }
}

TEST_SUITE("meshtopo --orient") {
  TEST_CASE(
      "closed components face outward, walls of cavities inward, whatever the order and the faces that are turned") {
    std::mt19937 random(53);
    Mesh mesh;
    mesh.add_box({0, 0, 0}, {8, 8, 8});
    mesh.add_box({2, 2, 2}, {4, 4, 4});
    mesh.add_box({-9, 0, 0}, {-8, 1, 1});
    for (std::size_t f = 6; f < 12; ++f) std::reverse(mesh.faces[f].begin(), mesh.faces[f].end());
    const Folder folder("whole.off", mesh.off());
    const auto expected = places_of(folder, "whole.off");
    CHECK(six_volumes(folder, "whole.off") == 6 * (512 - 8 + 1));
    for (int i = 0; i < 8; ++i) {
      Mesh turned = mesh;
      turned.shuffle(random);
      std::size_t count = 0;
      for (auto& face : turned.faces)
        if (i == 7 || random() % 2 == 0) {
          std::reverse(face.begin(), face.end());
          ++count;
        }
      folder.file("m.off", turned.off());
      const json r = changed(folder, "m.off --orient -o o.off --check oriented,closed");
      CHECK(r["changes"]["orient"] == json{{"faces_reversed", count},
                                           {"facing_outward", 2},
                                           {"facing_inward", 1},
                                           {"nested", 1},
                                           {"not_orientable", json::array()}});
      CHECK(places_of(folder, "o.off") == expected);
    }
    CHECK(contains(folder.meshtopo("whole.off --orient -o o.off").out,
                   "  orient: 0 faces reversed, 2 closed components face outward\n"
                   "  orient: 1 closed component lies inside others; 1 of them inside an odd number of others, the "
                   "wall of a cavity, faces inward\n"));
  }

  TEST_CASE("the depth of closed surfaces in others is right for boxes, also for those that touch") {
    std::mt19937 random(57);
    for (int trial = 0; trial < 40; ++trial) {
      // Boxes inside or outside of each other: the position of each in its parent is known, and its corners and sides
      // may touch those of the parent.
      struct Box {
        std::array<double, 3> low, high;
        std::size_t depth;
      };
      std::vector<Box> boxes = {{{0, 0, 0}, {64, 64, 64}, 0}};
      const auto grow = [&](const auto& self, const Box& parent) -> void {
        const double x = parent.low[0], half = (parent.high[0] - x) / 2;
        if (half < 4) return;
        for (int side = 0; side < 2; ++side) {
          if (random() % 4 == 0) continue;
          Box child{parent.low, parent.high, parent.depth + 1};
          const double gap = random() % 3 == 0 ? 0 : 1;  // on the walls of the parent, or not
          for (std::size_t k = 0; k < 3; ++k) {
            child.low[k] += gap;
            child.high[k] -= gap + 1;
          }
          child.low[0] = x + side * half + gap;
          child.high[0] = x + side * half + half - 1;
          boxes.push_back(child);
          self(self, child);
        }
      };
      grow(grow, Box(boxes.front()));
      Mesh mesh;
      double volume = 0;
      for (const Box& box : boxes) {
        mesh.add_box(box.low, box.high);
        double own = 1;
        for (std::size_t k = 0; k < 3; ++k) own *= box.high[k] - box.low[k];
        volume += box.depth % 2 == 0 ? own : -own;
      }
      mesh.shuffle(random);
      const Folder folder("m.off", mesh.off());
      const json r = changed(folder, "m.off --orient -o o.off");
      CHECK(six_volumes(folder, "o.off") == 6 * volume);
      CHECK(r["result"]["volume"] == doctest::Approx(volume).epsilon(1e-14));
      CHECK(r["changes"]["orient"]["nested"] == boxes.size() - 1);
      const json again = changed(folder, "o.off --orient -o p.off");
      CHECK(again["changes"]["orient"]["faces_reversed"] == 0);
    }
  }

  TEST_CASE("surfaces that touch from outside lie in none; a hollow solid of rbpa solid is one body") {
    Mesh mesh;
    mesh.add_box({0, 0, 0}, {1, 1, 1});
    mesh.add_box({1, 0, 0}, {2, 1, 1});
    mesh.add_box({2, 1, 0}, {3, 2, 1});
    mesh.add_box({3, 2, 1}, {4, 3, 2});
    const Folder folder("m.off", mesh.off());
    const json r = changed(folder, "m.off --orient -o o.off");
    CHECK(r["changes"]["orient"]["nested"] == 0);
    CHECK(r["changes"]["orient"]["faces_reversed"] == 0);
    const std::string hollow = (rbpa_test::bundled_data() / "findings/case_orient_cavity/hollow_right.off").string();
    const json of_other = changed(folder, hollow + " --orient -o o.off");
    CHECK(of_other["changes"]["orient"]["faces_reversed"] == 0);
    CHECK(of_other["volume"] == 7);
    CHECK(of_other["result"]["volume"] == 7);
    // The shell of a sphere's points has a void. The program writes the wall of the void unchanged.
    std::string points;
    for (const rbpa::Point3& p : rbpa_test::spiral(400))
      for (const double size : {1.0, 1.2}) points += rbpa_test::text_of({size * p.x, size * p.y, size * p.z}) + "\n";
    folder.file("p.xyz", points);
    REQUIRE(folder.rbpa("solid p.xyz --alpha 0.3 --boundary b.off -q").code == 0);
    const json solid = changed(folder, "b.off --orient -o o.off");
    CHECK(solid["changes"]["orient"]["faces_reversed"] == 0);
    CHECK(solid["changes"]["orient"]["facing_inward"] == 1);
    CHECK(solid["volume"] == solid["result"]["volume"]);
  }

  TEST_CASE("a non-orientable component is reported by its first face and stays unchanged; open ones are oriented") {
    const Folder folder(
        "m.off",
        "OFF\n9 8 0\n0 0 0\n1 0 0\n2 0 1\n3 1 0\n4 0 0\n8 0 0\n9 0 0\n9 1 0\n8 1 0\n3 5 6 7\n3 5 7 8\n3 6 5 5\n"
        "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n");
    const json r = changed(folder, "m.off --orient -o o.off");
    CHECK(r["changes"]["orient"] ==
          json::parse(
              R"({"faces_reversed": 0, "facing_outward": 0, "facing_inward": 0, "nested": 0, "not_orientable": [3]})"));
    CHECK(folder.content("o.off") == folder.content("m.off"));
    CHECK(contains(folder.meshtopo("m.off --orient -o o.off").out,
                   "  orient: 0 faces reversed, 0 closed components face outward\n"
                   "  orient: the component of face 3 is not orientable: its faces stay unchanged\n"));
    // The number of the first face is that of the file, also if faces before it are dropped.
    CHECK(changed(folder, "m.off --weld 0 --orient -o o.off")["changes"]["orient"]["not_orientable"] ==
          json::array({3}));
  }

  TEST_CASE("the sign of a volume is exact") {
    using rbpa::app::Triangle;
    using rbpa::app::volume_sign;
    const std::vector<Triangle> out = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const std::vector<Triangle> in = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    for (const double size : {1.0, 1e-320, 1e307})
      for (const double height : {1.0, 5e-324, 1e-300, 1e300}) {
        CAPTURE(size);
        CAPTURE(height);
        const Positions p = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, height}};
        CHECK(volume_sign(p, out) == 1);
        CHECK(volume_sign(p, in) == -1);
      }
    // Far from the origin: one bit above a plane, in it, and one bit below.
    for (const int bits : {-1, 0, 1}) {
      double z = 1e8 + 3;
      if (bits != 0) z = std::nextafter(z, bits * 1e9);
      const Positions p = {{1e8, 1e8, 1e8}, {1e8 + 1, 1e8, 1e8 + 1}, {1e8, 1e8 + 1, 1e8 + 1}, {1e8 + 1, 1e8 + 2, z}};
      CHECK(volume_sign(p, out) == bits);
      CHECK(volume_sign(p, in) == -bits);
    }
    // Two corners with Fibonacci numbers, whose determinant is 1 or -1, and a third that is off their plane by so much
    // only: the products have more than a hundred bits, and their rounded sum has any sign.
    long before = 1, number = 1;
    for (int n = 2; n < 30; ++n) {
      const long next = before + number;  // the square of `number` is before · next plus or minus 1
      const std::array<long, 3> b = {before, number, 71 * n}, c = {number, next, 1000003 - n};
      for (const int off : {-1, 0, 1}) {
        Positions p = {{0, 0, 0}, {}, {}, {}};
        for (std::size_t k = 0; k < 3; ++k) {
          p[1][k] = static_cast<double>(b[k]);
          p[2][k] = static_cast<double>(c[k]);
          p[3][k] = static_cast<double>(1000033 * b[k] - 900007 * c[k] + (k == 2 ? off : 0));
        }
        const int expected = off * static_cast<int>(before * next - number * number);
        CAPTURE(n);
        CHECK(volume_sign(p, out) == expected);
        CHECK(volume_sign(p, in) == -expected);
      }
      before = number;
      number = next;
    }
    CHECK(volume_sign({}, {}) == 0);
  }
}

TEST_SUITE("meshtopo: changes together") {
  TEST_CASE("changes are weld, drop, orient and repair, in this order; steps have the numbers of the file") {
    const Folder folder;
    // A tetrahedron of loose triangles, one of them turned, with a doubled one, and a stray triangle.
    folder.file("m.off",
                "OFF\n18 6 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n0 0 0\n0 1 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n"
                "1 0 0\n0 1 0\n0 0 1\n7 7 7\n8 7 7\n7 8 7\n"
                "3 15 16 17\n3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n3 12 13 14\n");
    const json r = changed(folder,
                           "m.off --weld 0 --drop-small 2 --orient --repair r.off --generators l.json --check "
                           "closed,manifold,oriented,components=1,genus=0");
    CHECK(r["changes"]["weld"]["duplicate_faces_dropped"] == 1);
    CHECK(r["changes"]["drop"]["components"] == 1);
    CHECK(r["changes"]["orient"]["faces_reversed"] == 1);
    CHECK(r["repair"].empty());
    CHECK(json::parse(folder.content("l.json")).empty());
    CHECK(six_volumes(folder, "r.off") == 1);
    // The repair splits the pinch that a weld makes, and names it as in the file.
    folder.file("p.off", "OFF\n7 3 0\n5 5 5\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n-1 0 0\n0 -1 0\n3 0 0 1\n3 1 2 3\n3 4 5 6\n");
    const json p = changed(folder, "p.off --weld 0 --repair r.off");
    REQUIRE(p["repair"].size() == 1);
    CHECK(p["repair"][0] == json::parse(R"({"kind": "point_split", "where": {"vertices": [1], "faces": [],
          "vertex_lines": [4], "face_lines": []}})"));
    // A defect that prevents loops is named as in the file, too.
    folder.file("t.off",
                "OFF\n9 4 0\n5 5 5\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n1 0 0\n0 0 1\n0 -1 0\n8 8 8\n3 0 0 1\n3 1 2 3\n3 5 4 "
                "6\n3 1 2 7\n");
    const Outcome refused = folder.meshtopo("t.off --weld 0 --generators g.json -q", 3);
    CHECK(refused.err ==
          "meshtopo: t.off: found non-manifold edge (vertices 1 2, faces 1 2 3, lines 13 14 15), expected a surface, "
          "as --generators requires (--repair makes one, or rbpa surface --manifold)\n");
    CHECK_FALSE(folder.has("g.json"));
  }

  TEST_CASE("data that a mesh is written without are named, in every format that may have them") {
    const Folder folder;
    const std::string off = "3 1 0\n0 0 0 0 0 1 9 9 9\n1 0 0 0 0 1 9 9 9\n0 1 0 0 0 1 9 9 9\n3 0 1 2\n";
    const auto ply = [](const std::string& more, const std::string& of_faces, const std::string& values) {
      std::string text =
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + more +
          "element face 1\nproperty list uchar int vertex_indices\n" + of_faces + "end_header\n";
      for (const char* const position : {"0 0 0", "1 0 0", "0 1 0"}) text += position + values + "\n";
      return text + "3 0 1 2" + (of_faces.empty() ? "" : " 7") + "\n";
    };
    const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                      label = "property int label\n", v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const auto& row : std::initializer_list<std::array<std::string, 3>>{
             {"m.ply", ply("", "", ""), ""},
             {"m.ply", ply(colors + label, "", " 1 2 3 4"), "vertex colors and 1 vertex field"},
             {"m.ply", ply("property float nx\n" + label, label, " 1 2"),
              "vertex normals, 1 vertex field and 1 face field"},
             {"m.off", "OFF\n" + off, ""},
             {"m.off", "CNOFF\n" + off, "vertex normals and vertex colors"},
             {"m.obj", v + "f 1 2 3\n", ""},
             {"m.obj", "v 0 0 0 1\n" + v + "f 1 2 3\n", ""},
             {"m.obj", v + "v 5 5 5 1 0 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl gold\nf 1//1 2//1 3//1\n",
              "vertex colors, texture coordinates, vertex normals and materials"}}) {
      const std::string name = row[0], content = row[1], lost = row[2];
      CAPTURE(content);
      folder.file(name, content);
      const Outcome written = folder.meshtopo(name + " --weld 0 -o x.stl -q", 0);
      CHECK(written.err ==
            (lost.empty()
                 ? ""
                 : "meshtopo: " + name + ": the mesh is written without " + lost +
                       " (rbpa surface, which makes new triangles of the vertices, keeps those of vertices)\n"));
      CHECK(folder.meshtopo(name + " -q").err.empty());
    }
  }

  TEST_CASE("-o names the mesh if it ends like one, in every format, and nothing else is written") {
    const Folder folder("m.off", pyramid_off);
    for (const std::string name : {"w.off", "w.ply", "w.obj", "w.stl"}) {
      CHECK(contains(folder.meshtopo("m.off --orient -o " + name, 0).out, "\nresult\n"));
      const std::string faces = name == "w.stl" ? "6" : "5";  // STL has triangles
      CHECK(folder.meshtopo(name + " -q --check closed,oriented,genus=0,vertices=5,faces=" + faces).code == 0);
    }
    CHECK(folder.content("w.off") == pyramid_off);
    CHECK(folder.meshtopo("m.off --orient -o - --output-format off -q").out == pyramid_off);
    CHECK(folder.meshtopo("m.off --orient --check closed -o r.json").code == 0);
    CHECK(json::parse(folder.content("r.json"))["result"]["faces"] == 5);
    CHECK(folder.meshtopo("m.off --orient --repair r.off -o s.json").code == 0);
    CHECK(folder.content("r.off") == pyramid_off);
    for (const std::string option :
         {"--weld 0", "--keep-largest 1", "--drop-small 1", "--orient", "--fill-holes all"}) {
      meshtopo_refuses(folder, "m.off " + option, 2,
                       option.substr(0, option.find(' ')) +
                           " changes the mesh, and requires a file for it (-o OUT or --repair OUT), or --check");
    }
    folder.file("far.off", "OFF\n3 1 0\n0 0 0\n1e39 0 0\n0 1 0\n3 0 1 2\n");
    CHECK(folder.meshtopo("far.off --orient -o far.stl").err ==
          "meshtopo: far.stl: found the coordinate 1e+39, expected at most 3.4e38 in size, as STL is in single "
          "precision (.ply keeps doubles)\n");
    CHECK_FALSE(folder.has("far.stl"));
    CHECK(folder.meshtopo("m.off --orient -o m.off").err ==
          "meshtopo: m.off: found the file of the mesh, expected another file to write to\n");
    CHECK(folder.content("m.off") == pyramid_off);
  }

  TEST_CASE("each of several meshes is changed for its check") {
    const Folder folder({{"a.off", pyramid_off}, {"a.stl", stl_text(pyramid_triangles)}});
    CHECK(folder.meshtopo("a.off a.stl -q --weld 0 --keep-largest 1 --check closed,components=1").code == 0);
    CHECK(folder.meshtopo("a.off a.stl -q --drop-small 5 --check closed,components=1").code == 0);
    CHECK(folder.meshtopo("a.off a.stl -q --drop-small 7 --check closed").code == 4);
  }
}
