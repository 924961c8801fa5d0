#include "meshops/front/front.h"

#include <doctest/doctest.h>

#include "meshops/core/contract.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/front_on_mesh.h"
#include "support/meshes.h"
#include "support/refusal.h"

using namespace meshops;
using namespace meshops::test;

namespace {
Halfedge boundary(const Front& front, Site from, Site to) { return front.boundary_between(from, to); }
}  // namespace

TEST_SUITE("front") {
  TEST_CASE("a front begins with one isolated vertex per site") {
    auto [mesh, front] = FrontOnMesh(4);
    CHECK(mesh.n_vertices() == 4);
    for (Site s = 0; s < 4; ++s) {
      CHECK(front.is_free(s));
      CHECK(front.site(Vertex(static_cast<int>(s))) == s);
    }
    CHECK_FALSE(front.pop().is_valid());
    CHECK_THROWS_AS(Front(mesh, 4), ContractViolation);
  }

  TEST_CASE("a triangle that touches the mesh in a point gets a vertex of its own there") {
    TestMesh mesh;
    Front front(mesh, 5);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    CHECK(mesh.n_vertices() == 6);
    CHECK(front.site(Vertex(5)) == 0);
    int fans = 0;
    front.for_each_fan(0, [&](Vertex v) {
      ++fans;
      CHECK(front.site(v) == 0);
    });
    CHECK(fans == 2);
    check_sound(mesh);
  }

  TEST_CASE("fans merge when an edge between them is glued, and their vertices become one") {
    TestMesh mesh;
    Front front(mesh, 5);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    // The triangle 0 2 3 has its sides 0→2 and 3→0 on different boundary curves.
    const Halfedge h = boundary(front, 0, 2);
    REQUIRE(h.is_valid());
    const InsertedTriangle t = front.attach(h, 3);
    CHECK(t.merged == 1);
    CHECK(t.left_over[0] == Vertex(5));
    check_sound(mesh);
    // The left-over vertex serves the next pinch.
    int fans = 0;
    front.for_each_fan(0, [&](Vertex) { ++fans; });
    CHECK(fans == 1);
    const std::vector<Site> sites = front.finish();
    CHECK(sites == std::vector<Site>{0, 1, 2, 3, 4});
    CHECK(mesh.n_vertices() == 5);
    check_sound(mesh);
  }

  TEST_CASE("a left-over vertex serves the next pinch") {
    auto [mesh, front] = FrontOnMesh(7);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    front.attach(boundary(front, 0, 2), 3);
    front.create(4, 5, 6);
    CHECK(mesh.n_vertices() == 8);
    CHECK(front.site(Vertex(7)) == 4);
    check_sound(mesh);
  }

  TEST_CASE("a boundary halfedge is found from either end, whatever fans there are") {
    auto [mesh, front] = FrontOnMesh(6);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    front.create(2, 5, 4);
    for (Site a = 0; a < 6; ++a)
      for (Site b = 0; b < 6; ++b) {
        Halfedge between;
        for (const Halfedge h : mesh.halfedges())
          if (front.is_boundary(h) && front.from_site(h) == a && front.to_site(h) == b) between = h;
        CHECK(front.boundary_between(a, b) == between);
      }
    CHECK(boundary(front, 1, 0).is_valid());
    CHECK_FALSE(boundary(front, 0, 1).is_valid());
  }

  TEST_CASE("on a mesh with deleted elements no fan stands on the site of a deleted vertex") {
    TestMesh mesh;
    {
      Front fan(mesh, 5);
      for (Site s = 1; s < 5; ++s) fan.create(0, s, s % 4 + 1);
    }
    remove_vertex(mesh, Vertex(0));
    REQUIRE(mesh.status(Vertex(0)).deleted());
    Front front(mesh);
    CHECK(front.is_free(0));
    for (Site s = 1; s < 5; ++s) {
      CHECK_FALSE(front.is_free(s));
      CHECK_FALSE(front.edge_between(0, s).is_valid());
      CHECK(front.edges_between(0, s).empty());
      CHECK(front.edges_between(s, 0).empty());
      CHECK_FALSE(front.boundary_between(0, s).is_valid());
      CHECK_FALSE(front.triangle_on(0, s, s % 4 + 1).is_valid());
    }
  }

  TEST_CASE("a seed whose sides are on the boundary is glued there") {
    auto [mesh, front] = FrontOnMesh(4);
    front.create(0, 1, 2);
    front.create(1, 0, 3);
    check_sound(mesh);
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.components == 1);
    CHECK(counts.edges == 5);
  }

  TEST_CASE("finish removes free sites and keeps the order of the others") {
    auto [mesh, front] = FrontOnMesh(9);
    front.create(1, 4, 6);
    front.create(6, 7, 8);
    CHECK(front.finish() == std::vector<Site>{1, 4, 6, 7, 8, 6});
    CHECK(count_topology(mesh).isolated == 0);
    CHECK(mesh.n_vertices() == 6);
    check_sound(mesh);
  }

  TEST_CASE("the queue returns active halfedges that are still on the boundary, oldest first") {
    TestMesh mesh;
    Front front(mesh, 4);
    front.create(0, 1, 2);
    const Halfedge first = front.pop();
    CHECK(front.to_site(first) == 0);
    CHECK(front.from_site(first) == 1);
    const Halfedge second = front.pop();
    front.attach(second, 3);
    CHECK(front.from_site(front.pop()) == 0);  // the third side of the seed
  }

  TEST_CASE("sites can be added during a run, and have a vertex when they are used") {
    auto [mesh, front] = FrontOnMesh(3);
    front.create(0, 1, 2);
    CHECK(front.add_site() == 3);
    CHECK(front.add_site() == 4);
    CHECK(front.sites() == 5);
    CHECK(mesh.n_vertices() == 3);
    CHECK(front.is_free(4));
    front.attach(boundary(front, 1, 0), 4);
    CHECK_FALSE(front.is_free(4));
    CHECK(front.is_free(3));
    CHECK(mesh.n_vertices() == 4);
    CHECK(front.site(Vertex(3)) == 4);
    CHECK(front.boundary_between(4, 0).is_valid());
    check_sound(mesh);
    CHECK(front.finish() == std::vector<Site>{0, 1, 2, 4});
  }

  TEST_CASE("fans on an added site merge, whichever of their vertices survives") {
    TestMesh mesh;
    Front front(mesh, 5);
    front.create(0, 1, 2);
    front.create(0, 3, 4);  // a second fan on 0: vertex 5
    const Site added = front.add_site();
    front.attach(boundary(front, 2, 1), added);  // vertex 6 on the added site
    front.attach(boundary(front, 0, 2), 3);      // the fans on 0 are merged: vertex 5 is left over
    front.attach(boundary(front, 4, 3), added);  // a second fan on the added site gets vertex 5
    int fans = 0;
    front.for_each_fan(added, [&](Vertex v) {
      ++fans;
      CHECK(front.site(v) == added);
    });
    REQUIRE(fans == 2);
    REQUIRE(front.site(Vertex(5)) == added);
    check_sound(mesh);
    // Between the fans: vertex 6 is merged into the other.
    const InsertedTriangle t = front.attach(boundary(front, 2, added), 3);
    CHECK(t.merged == 1);
    CHECK(t.left_over[0] == Vertex(6));
    fans = 0;
    front.for_each_fan(added, [&](Vertex v) {
      ++fans;
      CHECK(v == Vertex(5));
    });
    CHECK(fans == 1);
    check_sound(mesh);
  }

  TEST_CASE("the curves of a front are the boundary curves, whatever elements it has in supply") {
    for (const std::size_t supply : {std::size_t{1}, std::size_t{64}}) {
      TestMesh mesh;
      Front front(mesh, 7, supply);
      CHECK(front.curves().empty());
      front.create(0, 1, 2);
      front.create(0, 3, 4);
      front.attach(boundary(front, 1, 0), 5);
      const auto curves = front.curves();
      REQUIRE(curves.size() == 2);
      CHECK(curves[0].length() == 4);
      CHECK(curves[1].length() == 3);
    }
  }

  TEST_CASE("the curves at a site are those of its fans, and an inner or free site has none") {
    TestMesh mesh;
    Front front(mesh, 8);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    const auto curves = front.curves_at(0);
    REQUIRE(curves.size() == 2);
    for (const BoundaryCurve& curve : curves) CHECK(front.from_site(curve.front()) == 0);
    CHECK_FALSE(curves[0].contains(curves[1].front()));
    CHECK(front.curves_at(1).size() == 1);
    CHECK(front.curves_at(7).empty());
    // Site 0 becomes inner.
    front.attach(boundary(front, 0, 2), 3);
    front.attach(boundary(front, 0, 4), 1);
    CHECK(front.curves_at(0).empty());
    CHECK_FALSE(front.is_on_boundary(0));
  }

  TEST_CASE("the next level carries free and boundary sites, and activates frozen halfedges") {
    auto [mesh, front] = FrontOnMesh(8);
    front.create(0, 1, 2);
    for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) front.freeze(h);
    const LevelTransfer first = front.next_level();
    CHECK(first.carried == std::vector<Site>{0, 1, 2, 3, 4, 5, 6, 7});
    CHECK(first.left_behind == 0);
    CHECK(first.reactivated == 3);
    // A ring of triangles around site 0.
    front.attach(boundary(front, 0, 2), 3);
    front.attach(boundary(front, 0, 3), 4);
    front.attach(boundary(front, 0, 4), 1);
    int frozen = 0;
    for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) {
      front.freeze(h);
      ++frozen;
    }
    CHECK(frozen == 4);
    const LevelTransfer second = front.next_level();
    CHECK(second.carried == std::vector<Site>{1, 2, 3, 4, 5, 6, 7});
    CHECK(second.left_behind == 1);
    CHECK(second.reactivated == 4);
    check_sound(mesh);
    // Each face keeps the level at which it was inserted, however many transfers follow.
    front.next_level();
    const Face last = front.create(5, 6, 7).face;
    CHECK(front.level() == 3);
    for (const Face f : mesh.faces()) CHECK(front.level(f) == (f == last ? 3u : f.idx() == 0 ? 0u : 1u));
    CHECK_THROWS_AS(front.level(Face(5)), ContractViolation);
    front.finish();
    CHECK(front.level(last) == 3);
  }

  TEST_CASE("a next level is refused while a popped halfedge is neither activated, frozen nor glued") {
    TestMesh mesh;
    Front front(mesh, 4);
    front.create(0, 1, 2);
    std::vector<Halfedge> popped;
    for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) popped.push_back(h);
    REQUIRE(popped.size() == 3);
    CHECK(refusal([&] { front.next_level(); }) ==
          "next_level: the number of boundary halfedges that were popped and not queued again is 3, expected 0 "
          "(freeze() or activate() them)");
    CHECK(front.level() == 0);
    front.freeze(popped[0]);
    front.activate(popped[1]);
    CHECK_THROWS_AS(front.next_level(), ContractViolation);
    CHECK(front.is_frozen(popped[0]));
    front.attach(popped[2], 3);
    const LevelTransfer transfer = front.next_level();
    CHECK(transfer.carried == std::vector<Site>{0, 1, 2, 3});
    CHECK(transfer.left_behind == 0);
    CHECK(transfer.reactivated == 1);
    // Faces of the mesh with which a front begins have any number of sides.
    TestMesh polygon;
    for (int i = 0; i < 5; ++i) polygon.new_vertex();
    polygon.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3), Vertex(4)});
    Front around(polygon);
    CHECK(around.next_level().carried.size() == 5);
    const Halfedge h = around.pop();
    CHECK_THROWS_AS(around.next_level(), ContractViolation);
    around.detach(around.attach(h, around.add_site()).face);
    CHECK(around.next_level().carried.size() == 6);
  }

  TEST_CASE("a site with several fans is carried as long as one of them is on the boundary") {
    TestMesh mesh;
    Front front(mesh, 6);
    // A closed ring of three triangles around site 0, and site 5 apart.
    front.create(0, 1, 2);
    front.attach(boundary(front, 0, 2), 3);
    front.attach(boundary(front, 0, 3), 1);
    CHECK(front.next_level().carried == std::vector<Site>{1, 2, 3, 4, 5});
    // A triangle that touches the ring only in site 1.
    front.create(1, 4, 5);
    CHECK(front.is_on_boundary(1));
    const Site added = front.add_site();
    CHECK(front.next_level().carried == std::vector<Site>{1, 2, 3, 4, 5, added});
  }
}
