// Deferred edges: their turn comes when the front has changed, and not before; and a run always ends.
#include <doctest/doctest.h>

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/front_on_mesh.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Seed = std::array<Site, 3>;
using Sides = std::vector<std::pair<Site, Site>>;

std::pair<Site, Site> side(const Front& front, Halfedge h) { return {front.from_site(h), front.to_site(h)}; }

/// Two triangles with a gap of two between them, and one seed after the other. Edges are deferred until there are
/// `faces` faces.
struct Waiting {
  std::size_t faces = 0;
  std::vector<Seed> seeds = {{3, 4, 5}, {0, 1, 2}};
  Sides proposed_for;
  std::optional<Seed> seed(const Front&) {
    if (seeds.empty()) return std::nullopt;
    const Seed next = seeds.back();
    seeds.pop_back();
    return next;
  }
  Proposal propose(const Front& front, Halfedge h) {
    proposed_for.push_back(side(front, h));
    if (front.faces() < faces) return Proposal::defer();
    if (proposed_for.back() == std::pair<Site, Site>{1, 0}) return Site{4};
    return std::nullopt;
  }
};

struct Events : FrontVisitor {
  Sides deferred_at, frozen_at;
  void deferred(const Front& front, Halfedge h) {
    CHECK(front.is_active(h));
    CHECK_FALSE(front.is_frozen(h));
    deferred_at.push_back(side(front, h));
  }
  void frozen(const Front& front, Halfedge h) { frozen_at.push_back(side(front, h)); }
};

const Sides of_first = {{1, 0}, {2, 1}, {0, 2}}, of_second = {{4, 3}, {5, 4}, {3, 5}};
Sides operator+(Sides a, const Sides& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_SUITE("defer") {
  TEST_CASE("edges deferred forever are proposed for once after each change, and then frozen in their order") {
    Waiting policy;
    policy.faces = 100;
    Events events;
    auto [mesh, front] = FrontOnMesh(6);
    advance(front, policy, events);
    // The second seed is a change for the edges of the first.
    CHECK(policy.proposed_for == of_first + of_second + of_first);
    CHECK(events.deferred_at == policy.proposed_for);
    CHECK(events.frozen_at == of_second + of_first);
    CHECK(front.faces() == 2);
    check_sound(mesh);
    // They are proposed for again on the next level.
    CHECK(front.next_level().reactivated == 6);
    policy.faces = 0;
    advance(front, policy, events);
    CHECK(front.faces() == 3);
  }

  TEST_CASE("an edge that was deferred gets the apex that was refused before") {
    Waiting policy;
    policy.faces = 2;
    Events events;
    auto [mesh, front] = FrontOnMesh(6);
    advance(front, policy, events);
    CHECK(events.deferred_at == of_first);
    CHECK(policy.proposed_for == of_first + of_second + of_first + Sides{{4, 0}, {1, 4}});
    CHECK(front.faces() == 3);
    CHECK(front.frozen().size() == 7);
    check_sound(mesh);
  }

  TEST_CASE("an edge to which a neighbor's triangle is attached is not proposed for again") {
    // The edge 0→2 waits; 2→1 gets the site 0 by way of a new triangle around it.
    struct Around {
      std::map<std::pair<Site, Site>, Site> apex = {{{1, 0}, 3}, {{3, 0}, 2}};
      Sides proposed_for;
      std::optional<Seed> seed(const Front& front) {
        return front.faces() == 0 ? std::optional(Seed{0, 1, 2}) : std::nullopt;
      }
      Proposal propose(const Front& front, Halfedge h) {
        proposed_for.push_back(side(front, h));
        if (proposed_for.back() == std::pair<Site, Site>{0, 2}) return Proposal::defer();
        const auto found = apex.find(proposed_for.back());
        return found == apex.end() ? Proposal(std::nullopt) : Proposal(found->second);
      }
    } policy;
    auto [mesh, front] = FrontOnMesh(4);
    advance(front, policy);
    CHECK(front.faces() == 3);
    CHECK(std::count(policy.proposed_for.begin(), policy.proposed_for.end(), std::pair<Site, Site>{0, 2}) == 1);
    CHECK_FALSE(front.is_active(front.edge_between(0, 2)));
    check_sound(mesh);
  }

  TEST_CASE("a visitor wakes a deferred edge at once, or freezes it") {
    struct Meddling : FrontVisitor {
      std::size_t wakes = 2;
      void deferred(const Front& front, Halfedge h) {
        auto& changeable = const_cast<Front&>(front);  // as the owner of the front has it
        if (side(front, h) == std::pair<Site, Site>{2, 1} && wakes > 0) {
          --wakes;
          changeable.activate(h);
        }
        if (side(front, h) == std::pair<Site, Site>{0, 2}) changeable.freeze(h);
      }
    } visitor;
    Waiting policy;
    policy.faces = 100;
    policy.seeds = {{0, 1, 2}};
    TestMesh mesh;
    Front front(mesh, 6);
    advance(front, policy, visitor);
    CHECK(policy.proposed_for == of_first + Sides{{2, 1}, {2, 1}});
    CHECK(front.frozen().size() == 3);
  }

  TEST_CASE("an edge that is twice in the queue is proposed for once before a change") {
    struct Twice : FrontVisitor {
      bool done = false;
      void deferred(const Front& front, Halfedge h) {
        if (std::exchange(done, true)) return;
        auto& changeable = const_cast<Front&>(front);  // as the owner of the front has it
        changeable.activate(h);
        changeable.freeze(h);
        changeable.activate(h);
      }
    } visitor;
    Waiting policy;
    policy.faces = 100;
    policy.seeds = {{0, 1, 2}};
    TestMesh mesh;
    Front front(mesh, 6);
    advance(front, policy, visitor);
    CHECK(policy.proposed_for == of_first + Sides{{1, 0}});
  }

  TEST_CASE("an edge that a visitor wakes when the last are frozen is proposed for, and frozen in the end") {
    struct Waking : FrontVisitor {
      std::size_t wakes = 3;
      void frozen(const Front& front, Halfedge h) {
        if (wakes == 0) return;
        --wakes;
        const_cast<Front&>(front).activate(h);
      }
    } visitor;
    Waiting policy;
    policy.faces = 100;
    policy.seeds = {{0, 1, 2}};
    TestMesh mesh;
    Front front(mesh, 6);
    advance(front, policy, visitor);
    CHECK(policy.proposed_for == of_first + of_first);
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve) CHECK(front.is_frozen(h));
  }

  TEST_CASE("a throw leaves deferred edges as they are: popped last, or proposed for at the same time") {
    const auto thrown_at = [](std::size_t question, auto then) {
      struct Throwing : Waiting {
        std::size_t left = 0;
        Proposal propose(const Front& front, Halfedge h) {
          if (left-- == 0) throw std::runtime_error("enough");
          return Waiting::propose(front, h);
        }
      } policy;
      policy.faces = 2;
      policy.left = question;
      auto [mesh, front] = FrontOnMesh(6);
      CHECK_THROWS_AS(advance(front, policy), std::runtime_error);
      then(front, policy);
      check_sound(mesh);
    };
    for (std::size_t question = 0; question < 11; ++question) {
      CAPTURE(question);
      thrown_at(question, [](Front& front, Waiting& policy) {
        for (const BoundaryCurve& curve : front.curves())
          for (const Halfedge h : curve) CHECK((front.is_active(h) || front.is_frozen(h)));
        advance(front, policy);
        CHECK(policy.proposed_for == of_first + of_second + of_first + Sides{{4, 0}, {1, 4}});
        CHECK(front.frozen().size() == 7);
      });
    }
    thrown_at(2, [](Front& front, Waiting&) {
      Sides popped;
      for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) {
        popped.push_back(side(front, h));
        front.freeze(h);
      }
      CHECK(popped == Sides{{0, 2}, {1, 0}, {2, 1}});
      CHECK(front.next_level().reactivated == 3);
    });
    thrown_at(2, [](Front& front, Waiting&) {
      CHECK(front.next_level().carried == std::vector<Site>{0, 1, 2, 3, 4, 5});
      CHECK_FALSE(front.frozen().size() > 0);
    });
  }

  TEST_CASE("the least key comes first again when deferred edges are woken") {
    struct Keyed : Waiting {
      int key(const Front& front, Halfedge h) const { return -static_cast<int>(front.from_site(h)); }
    } policy;
    policy.faces = 100;
    TestMesh mesh;
    Front front(mesh, 6);
    advance(front, policy);
    const Sides first = {{2, 1}, {1, 0}, {0, 2}}, second = {{5, 4}, {4, 3}, {3, 5}};
    CHECK(policy.proposed_for == first + second + first);
  }

  TEST_CASE("a polygon is cut into ears from any edge: an edge that is not an ear yet waits until it is") {
    // A comb of unit squares on integer sites: most corners are not ears at first.
    std::vector<std::array<int, 2>> at;
    const int teeth = 12;
    for (int i = 0; i < teeth; ++i) at.insert(at.end(), {{4 * i, 0}, {4 * i + 2, 0}});
    for (int i = teeth; i-- > 0;) at.insert(at.end(), {{4 * i + 2, 9}, {4 * i + 1, 1}, {4 * i, 9}});
    const auto turn = [&](Site a, Site b, Site c) {
      return (at[b][0] - at[a][0]) * (at[c][1] - at[a][1]) - (at[b][1] - at[a][1]) * (at[c][0] - at[a][0]);
    };
    struct Ears {
      decltype(turn)& left;
      std::size_t count, deferred = 0;
      std::optional<Seed> seed(const Front&) { return std::nullopt; }
      Proposal propose(const Front& front, Halfedge h) {
        const Site a = front.from_site(h), b = front.to_site(h),
                   c = front.to_site(front.mesh().next_halfedge_handle(h));
        bool is_ear = left(a, b, c) > 0;
        for (Site s = 0; s < count; ++s)
          is_ear =
              is_ear && (s == a || s == b || s == c || left(a, b, s) < 0 || left(b, c, s) < 0 || left(c, a, s) < 0);
        if (is_ear) return c;
        ++deferred;
        return Proposal::defer();
      }
    };
    // The polygon is the hole of a cone over it, whose apex has no place.
    TestMesh mesh;
    const auto count = static_cast<Site>(at.size());
    Front front(mesh, count + 1);
    for (Site s = 0; s < count; ++s) front.create(count, (s + 1) % count, s);
    Ears ears{turn, count};
    advance(front, ears);
    CHECK(front.curves().empty());
    CHECK(front.faces() == count + count - 2);
    CHECK(ears.deferred > count / 2);
    CHECK(ears.deferred < count * count);
    check_sound(mesh);
  }
}
