// A proposal of several triangles.
#include <doctest/doctest.h>

#include <vector>

#include "meshops/front/engine.h"
#include "support/check_sound.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Triangle = Proposal::Triangle;

/// Policy that proposes one list, for the first edge, 1→0.
struct Listing {
  std::vector<Triangle> list;
  std::size_t asked = 0;
  std::optional<Triangle> seed(const Front& front) {
    return front.faces() == 0 ? std::optional(Triangle{0, 1, 2}) : std::nullopt;
  }
  Proposal propose(const Front&, Halfedge) { return asked++ == 0 ? Proposal::triangles(list) : Proposal(std::nullopt); }
};

struct Events : FrontVisitor {
  std::size_t attachments = 0;
  std::vector<RefusalKind> refusals;
  std::vector<Halfedge> frozen_at;
  Halfedge at;
  void attached(const Front&, Halfedge h, const InsertedTriangle&) {
    ++attachments;
    CHECK((!at.is_valid() || at == h));
    at = h;
  }
  void refused(const Front&, Halfedge h, const Refusal& refusal) {
    CHECK((!at.is_valid() || at == h));
    refusals.push_back(refusal.kind);
  }
  void frozen(const Front& front, Halfedge h) {
    CHECK(front.is_boundary(h));
    frozen_at.push_back(h);
  }
};

struct Outcome {
  Events events;
  std::size_t faces, sites, boundary = 0, frozen;
};
Outcome propose(const std::vector<Triangle>& list) {
  TestMesh mesh;
  Front front(mesh, 8);
  Listing policy{list};
  Outcome outcome;
  advance(front, policy, outcome.events);
  check_sound(mesh);
  outcome.faces = front.faces();
  outcome.sites = front.sites();
  for (const BoundaryCurve& curve : front.curves())
    for (const Halfedge h : curve) {
      ++outcome.boundary;
      CHECK(front.is_frozen(h));
    }
  outcome.frozen = outcome.events.frozen_at.size();
  return outcome;
}

}  // namespace

TEST_SUITE("several triangles") {
  TEST_CASE("all triangles of a list are inserted, in order, before any edge is proposed for") {
    const Outcome outcome = propose({{1, 0, 3}, {3, 0, 4}, {1, 3, 5}});
    CHECK(outcome.events.attachments == 3);
    CHECK(outcome.events.refusals.empty());
    CHECK(outcome.faces == 4);
    CHECK(outcome.boundary == 6);
    CHECK(outcome.frozen == 6);
  }

  TEST_CASE("numbers that follow the last site are new sites, one triangle after the other") {
    const Outcome outcome = propose({{1, 0, 8}, {8, 0, 9}, {9, 10, 11}});
    CHECK(outcome.events.refusals.empty());
    CHECK(outcome.sites == 12);
    CHECK(outcome.faces == 4);
    // They cannot be new for all triangles at once.
    const Outcome refused = propose({{1, 0, 9}, {1, 0, 8}});
    CHECK(refused.events.refusals == std::vector{RefusalKind::no_such_site});
    CHECK(refused.sites == 8);
    CHECK(refused.faces == 1);
  }

  TEST_CASE("the first refused triangle ends a list, those before it stay, and the edge is frozen if it still exists") {
    const Outcome glued = propose({{1, 0, 3}, {1, 0, 4}, {3, 0, 5}});
    CHECK(glued.events.attachments == 1);
    CHECK(glued.events.refusals == std::vector{RefusalKind::side_taken});
    CHECK(glued.faces == 2);
    CHECK(glued.frozen == 4);

    const Outcome apart = propose({{3, 4, 5}, {3, 4, 6}, {1, 0, 3}});
    CHECK(apart.events.attachments == 1);
    CHECK(apart.events.refusals == std::vector{RefusalKind::side_taken});
    CHECK(apart.boundary == 6);
    CHECK(apart.frozen == 6);
  }

  TEST_CASE("a list that leaves the edge alone freezes it, and so does an empty list") {
    CHECK(propose({{3, 4, 5}}).frozen == 6);
    CHECK(propose({}).frozen == 3);
    CHECK(propose({}).faces == 1);
  }

  TEST_CASE("an edge that a visitor activates meanwhile is proposed for again") {
    struct Waking : FrontVisitor {
      void attached(const Front& front, Halfedge h, const InsertedTriangle&) {
        if (front.is_boundary(h)) const_cast<Front&>(front).activate(h);
      }
    } visitor;
    TestMesh mesh;
    Front front(mesh, 8);
    Listing policy{{{3, 4, 5}}};
    advance(front, policy, visitor);
    CHECK(policy.asked == 7);
  }
}
