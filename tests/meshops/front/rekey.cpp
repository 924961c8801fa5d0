// Keys that depend on the neighbors on the curve.
#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "meshops/front/engine.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

unsigned mixed(unsigned a, unsigned b) { return (a * 7919U + b * 104'729U + 17U) % 1009U; }

/// Policy that is as irregular as a function of an edge and its neighbors can be: attaches, places, closes, detaches,
/// defers.
struct Wild {
  unsigned salt = 0;
  std::size_t asked = 0, detached = 0, deferred = 0;
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    for (Site s = 0; s + 2 < 12; s += 3)
      if (front.is_free(s) && front.is_free(s + 1) && front.is_free(s + 2)) return std::array{s, s + 1, s + 2};
    return std::nullopt;
  }
  Proposal answer(const Front& front, Halfedge h) {
    ++asked;
    const unsigned m = mixed(front.from_site(h) + salt, front.to_site(h) * 31U + static_cast<unsigned>(asked));
    const Connectivity& mesh = front.mesh();
    if (m % 11 == 0 && detached < 60) {
      ++detached;
      return Proposal::detach(mesh.face_handle(mesh.opposite_halfedge_handle(h)));
    }
    if (m % 13 == 0) {
      ++deferred;
      return Proposal::defer();
    }
    if (m % 3 == 0) return front.to_site(mesh.next_halfedge_handle(h));
    if (m % 3 == 1 && front.sites() < 80) return static_cast<Site>(front.sites());
    if (m % 5 < 4) return m % static_cast<Site>(front.sites());
    return std::nullopt;
  }
};

unsigned angle(const Front& front, Halfedge h) {
  const Connectivity& mesh = front.mesh();
  return mixed(mixed(front.from_site(mesh.prev_halfedge_handle(h)), front.from_site(h)),
               mixed(front.to_site(h), front.to_site(mesh.next_halfedge_handle(h)))) %
         101U;
}

/// Policy that checks by brute force that each edge proposed for has the least key of all that wait.
struct ByAngle : Wild {
  static constexpr bool rekeys_neighbors = true;
  std::set<Halfedge> waiting_for_change;
  std::size_t revision = 0, at_first = 0, keys = 0;
  unsigned key(const Front& front, Halfedge h) {
    ++keys;
    return angle(front, h);
  }
  Proposal propose(const Front& front, Halfedge h) {
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge other : curve)
        if (front.is_active(other) && !waiting_for_change.contains(other)) {
          CHECK(angle(front, other) >= angle(front, h));
          ++at_first;
        }
    const Proposal proposal = answer(front, h);
    if (proposal.is_deferred()) waiting_for_change.insert(h);
    return proposal;
  }
};

/// Policy whose deferred halfedges no longer wait when their key is computed again.
struct Forgetting : ByAngle {
  unsigned key(const Front& front, Halfedge h) {
    waiting_for_change.erase(h);
    return ByAngle::key(front, h);
  }
};

struct OfTheEdge : Wild {
  OfTheEdge() { detached = 60; }  // from now on none is detached
  unsigned key(const Front& front, Halfedge h) { return mixed(front.from_site(h), front.to_site(h)) % 7; }
  Proposal propose(const Front& front, Halfedge h) { return answer(front, h); }
};
struct OfTheEdgeAgain : OfTheEdge {
  static constexpr bool rekeys_neighbors = true;
};
struct OfTheEdgeOnce : OfTheEdge {
  static constexpr bool rekeys_neighbors = false;
};

struct Once : ByAngle {
  static constexpr bool rekeys_neighbors = false;
  std::size_t late = 0;
  Proposal propose(const Front& front, Halfedge h) {
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge other : curve) late += front.is_active(other) && angle(front, other) < angle(front, h);
    return answer(front, h);
  }
};
struct Growing : Wild {
  static constexpr bool rekeys_neighbors = true;
  std::size_t keys = 0, proposals = 0;
  unsigned key(const Front& front, Halfedge h) {
    ++keys;
    return angle(front, h);
  }
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    return front.faces() == 0 ? Wild::seed(front) : std::nullopt;
  }
  Proposal propose(const Front& front, Halfedge) {
    ++proposals;
    return front.sites() < 3000 ? Proposal(static_cast<Site>(front.sites())) : Proposal(std::nullopt);
  }
};

template <typename Policy>
std::vector<int> run(unsigned salt) {
  TestMesh mesh;
  Front front(mesh, 12);
  Policy policy;
  policy.salt = salt;
  advance(front, policy);
  check_sound(mesh);
  front.finish();
  return snapshot(mesh);
}

}  // namespace

static_assert(RekeyingFrontPolicy<ByAngle> && !RekeyingFrontPolicy<OfTheEdge> && !RekeyingFrontPolicy<OfTheEdgeOnce>);

TEST_SUITE("rekey") {
  TEST_CASE("each edge has the least present key of those that wait, by brute force") {
    std::size_t compared = 0, detached = 0, deferred = 0;
    for (unsigned salt = 0; salt < 120; ++salt) {
      CAPTURE(salt);
      TestMesh mesh;
      Front front(mesh, 12);
      Forgetting policy;
      policy.salt = salt;
      advance(front, policy);
      check_sound(mesh);
      compared += policy.at_first;
      detached += policy.detached;
      deferred += policy.deferred;
    }
    CHECK(compared > 10'000);
    CHECK(detached > 100);
    CHECK(deferred > 100);
  }

  TEST_CASE("without rekeying, keys of neighbors are out of date") {
    std::size_t late = 0;
    for (unsigned salt = 0; salt < 40; ++salt) {
      TestMesh mesh;
      Front front(mesh, 12);
      Once policy;
      policy.salt = salt;
      advance(front, policy);
      late += policy.late;
    }
    CHECK(late > 100);
  }

  TEST_CASE("keys that do not change lead to the same run") {
    for (unsigned salt = 0; salt < 60; ++salt) {
      CAPTURE(salt);
      const auto once = run<OfTheEdge>(salt);
      CHECK(once == run<OfTheEdgeAgain>(salt));
      CHECK(once == run<OfTheEdgeOnce>(salt));
    }
  }

  TEST_CASE("two keys are computed again at a corner, whatever the length of the front") {
    Growing policy;
    TestMesh mesh;
    Front front(mesh, 12);
    advance(front, policy);
    CHECK(front.faces() > 2900);
    CHECK(policy.keys > 4 * front.faces() - 20);
    CHECK(policy.keys <= 4 * front.faces() + 6);
  }
}
