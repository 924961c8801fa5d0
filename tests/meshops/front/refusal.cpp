// Calls that a front refuses, with the reason in words and the mesh untouched.
#include "meshops/front/refusal.h"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include "meshops/core/contract.h"
#include "meshops/front/front.h"

#include "support/check_sound.h"
#include "support/laws.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

constexpr auto minus_one = static_cast<Site>(-1);

/// Three triangles around site 0, which is inner; sites 4 and 5 are free.
struct Closed {
  TestMesh mesh;
  Front front{mesh, 6};
  Closed() {
    front.create(0, 1, 2);
    front.create(0, 2, 3);
    front.create(0, 3, 1);
  }
  Halfedge at(Site from, Site to) const { return front.boundary_between(from, to); }
};

void check_attach(Closed& on, Halfedge h, Site apex, const Refusal& expected) {
  REQUIRE(on.front.attach_blocker(h, apex) == expected);
  check_refused(on.mesh, describe(expected), [&] { on.front.attach(h, apex); });
}

void check_create(Closed& on, const std::array<Site, 3>& c, const Refusal& expected) {
  REQUIRE(on.front.create_blocker(c[0], c[1], c[2]) == expected);
  check_refused(on.mesh, describe(expected), [&] { on.front.create(c[0], c[1], c[2]); });
}

}  // namespace

TEST_SUITE("front") {
  TEST_CASE("an apex that is not a site is refused, and the next new number is a site") {
    Closed on;
    const Halfedge h = on.at(2, 1);
    check_attach(on, h, 77, {RefusalKind::no_such_site, 77});
    check_attach(on, h, minus_one, {RefusalKind::no_such_site, minus_one});
    check_attach(on, h, 7, {RefusalKind::no_such_site, 7});
    CHECK_FALSE(on.front.attach_blocker(h, 6));
    on.front.attach(h, 6);
    CHECK(on.front.sites() == 7);
    check_sound(on.mesh);
  }

  TEST_CASE("a seed of sites that do not exist is refused, unless new ones follow the last, in any order") {
    Closed on;
    check_create(on, {4, 5, 9}, {RefusalKind::no_such_site, 9});
    check_create(on, {4, 5, minus_one}, {RefusalKind::no_such_site, minus_one});
    check_create(on, {6, 8, 5}, {RefusalKind::no_such_site, 8});
    CHECK(on.front.sites() == 6);
    on.front.create(8, 6, 7);
    CHECK(on.front.sites() == 9);
    on.front.create(9, 4, 5);
    CHECK(on.front.sites() == 10);
    check_sound(on.mesh);
  }

  TEST_CASE("an apex at an end of the edge and a seed with a site twice are refused") {
    Closed on;
    const Halfedge h = on.at(2, 1);
    check_attach(on, h, 1, {RefusalKind::corner_repeated, 1});
    check_attach(on, h, 2, {RefusalKind::corner_repeated, 2});
    check_create(on, {4, 5, 5}, {RefusalKind::corner_repeated, 5});
    check_create(on, {4, 5, 4}, {RefusalKind::corner_repeated, 4});
    check_create(on, {6, 6, 6}, {RefusalKind::corner_repeated, 6});
  }

  TEST_CASE("attaching to an inner halfedge, an invalid one or one that has a triangle is refused") {
    Closed on;
    const Halfedge h = on.at(2, 1), inner = on.mesh.opposite_halfedge_handle(h);
    check_attach(on, inner, 4, {RefusalKind::no_boundary_halfedge, 0, 0, inner.idx()});
    check_attach(on, Halfedge(-1), 4, {RefusalKind::no_boundary_halfedge, 0, 0, -1});
    check_attach(on, Halfedge(1000), 4, {RefusalKind::no_boundary_halfedge, 0, 0, 1000});
    on.front.attach(h, 4);
    check_attach(on, h, 5, {RefusalKind::no_boundary_halfedge, 0, 0, h.idx()});
    check_attach(on, h, 4, {RefusalKind::no_boundary_halfedge, 0, 0, h.idx()});
  }

  TEST_CASE("a halfedge in supply is not on the boundary") {
    TestMesh mesh;
    Front front(mesh, 4, 64);
    front.create(0, 1, 2);
    CHECK(front.attach_blocker(Halfedge(8), 3) == Refusal{RefusalKind::no_boundary_halfedge, 0, 0, 8});
    CHECK_THROWS_AS((void)front.from_site(Halfedge(8)), ContractViolation);
    CHECK_THROWS_AS(front.freeze(Halfedge(8)), ContractViolation);
  }

  TEST_CASE("a site around which all faces close accepts no other triangle") {
    Closed on;
    on.front.create(4, 5, 6);
    check_attach(on, on.at(5, 4), 0, {RefusalKind::site_closed, 0});
    check_create(on, {0, 4, 7}, {RefusalKind::site_closed, 0});
  }

  TEST_CASE("a second face on one side of an edge is refused, whether the edge is inner or on the boundary") {
    Closed on;
    check_create(on, {1, 2, 4}, {RefusalKind::side_taken, 1, 2});
    check_create(on, {4, 2, 3}, {RefusalKind::side_taken, 2, 3});
    check_create(on, {0, 1, 2}, {RefusalKind::side_taken, 0, 1});
    on.front.attach(on.at(2, 1), 4);
    check_create(on, {5, 1, 4}, {RefusalKind::side_taken, 1, 4});
    on.front.create(4, 5, 6);
    check_attach(on, on.at(5, 4), 2, {RefusalKind::side_taken, 4, 2});
  }

  TEST_CASE("a careless policy's triangles make no edge with three faces, and no face twice") {
    TestMesh mesh;
    Front front(mesh, 5);
    front.create(0, 1, 2);
    front.attach(front.boundary_between(1, 0), 3);
    front.attach(front.boundary_between(0, 2), 3);
    CHECK(front.create_blocker(1, 0, 4)->kind == RefusalKind::side_taken);
    CHECK(front.create_blocker(0, 1, 2)->kind == RefusalKind::side_taken);
    CHECK_FALSE(front.create_blocker(2, 1, 4));
    check_sound(mesh);
  }

  TEST_CASE("edge_between finds inner and boundary edges in either direction, whichever end has many edges") {
    TestMesh mesh;
    Front front(mesh, 50);
    for (Site s = 1; s + 1 < 40; ++s) front.create(0, s, s + 1);
    for (Site s = 1; s < 40; ++s) {
      const Halfedge h = front.edge_between(0, s);
      REQUIRE(h.is_valid());
      CHECK(front.from_site(h) == 0);
      CHECK(front.to_site(h) == s);
      CHECK(front.edge_between(s, 0) == mesh.opposite_halfedge_handle(h));
    }
    CHECK_FALSE(front.edge_between(1, 3).is_valid());
    CHECK_FALSE(front.edge_between(0, 45).is_valid());
    CHECK_FALSE(front.edge_between(45, 46).is_valid());
    CHECK_THROWS_AS((void)front.edge_between(0, 50), ContractViolation);
  }

  TEST_CASE("every refusal has a name and a text of its own") {
    std::set<std::string> names, words;
    for (int kind = 0; kind < 8; ++kind) {
      names.insert(std::string(name(RefusalKind(kind))));
      words.insert(describe({RefusalKind(kind), 3, 7, 5}));
    }
    CHECK(names.size() == 8);
    CHECK(words.size() == 8);
    CHECK(describe({RefusalKind::side_taken, 3, 7}) ==
          "a face already lies on the left of the edge from site 3 to site 7");
  }
}
