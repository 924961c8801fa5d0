// The order in which edges are processed.
#include "meshops/front/order.h"

#include <doctest/doctest.h>

#include <map>

#include "meshops/front/engine.h"
#include "support/check_sound.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Policy that attaches new sites until there are forty, and records the key of each edge for which it is called.
struct Noting {
  std::vector<Site> processed_from;
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    return front.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    processed_from.push_back(front.from_site(h));
    return front.sites() < 40 ? std::optional(static_cast<Site>(front.sites())) : std::nullopt;
  }
};

struct LastFirst : Noting {
  int key(const Front& front, Halfedge h) const { return -static_cast<int>(front.from_site(h)); }
};

struct AllEqual : Noting {
  int key(const Front&, Halfedge) const { return 0; }
};

template <typename Policy>
Policy run() {
  TestMesh mesh;
  Front front(mesh, 3);
  Policy policy;
  advance(front, policy);
  check_sound(mesh);
  return policy;
}

}  // namespace

TEST_SUITE("order") {
  TEST_CASE("the least key among those that wait comes first") {
    const auto processed = run<LastFirst>().processed_from;
    // While there are new sites, the edge from the newest is next: 3, 4, 5, and so on.
    for (std::size_t i = 1; i + 3 < 38; ++i) CHECK(processed[i] == i + 2);
    // Then the remaining edges follow, from the greatest site down.
    CHECK(std::is_sorted(processed.begin() + 40, processed.end(), std::greater<>()));
  }

  TEST_CASE("seeds inserted before the run grow side by side, by a ring each in turn") {
    struct Component : Noting {
      std::vector<bool> second = {false, false, false, true, true, true};  // for each site
      std::vector<bool> processed;
      std::optional<Site> propose(const Front& front, Halfedge h) {
        const bool is_of_second = second[front.from_site(h)];
        processed.push_back(is_of_second);
        if (front.sites() == 40) return std::nullopt;
        second.push_back(is_of_second);
        return static_cast<Site>(front.sites());
      }
    } policy;
    TestMesh mesh;
    Front front(mesh, 6);
    front.create(0, 1, 2);
    front.create(3, 4, 5);
    advance(front, policy);
    // Rings of 3 edges, 6 edges, and a part of one of 12.
    for (std::size_t i = 0; i < 34; ++i) CHECK(policy.processed[i] == (i < 6 ? i > 2 : i < 18 ? i > 11 : i > 29));
  }

  TEST_CASE("the oldest of equal keys comes first, as without an order") {
    CHECK(run<AllEqual>().processed_from == run<Noting>().processed_from);
  }

  TEST_CASE("with lengths as keys each edge is the shortest of those that wait") {
    struct ShortestFirst {
      std::multimap<unsigned, Halfedge> waiting;
      unsigned length(const Front& front, Halfedge h) const {
        return (front.from_site(h) * 7919U + front.to_site(h) * 104729U) % 1009U;
      }
      unsigned key(const Front& front, Halfedge h) {
        const unsigned l = length(front, h);
        waiting.insert({l, h});
        return l;
      }
      std::optional<std::array<Site, 3>> seed(const Front& front) {
        return front.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
      }
      std::optional<Site> propose(const Front& front, Halfedge h) {
        while (!waiting.empty() && !front.is_boundary(waiting.begin()->second)) waiting.erase(waiting.begin());
        REQUIRE(!waiting.empty());
        CHECK(waiting.begin()->first == length(front, h));
        for (auto at = waiting.begin(); at != waiting.end(); ++at)
          if (at->second == h) {
            waiting.erase(at);
            break;
          }
        return front.sites() < 60 ? std::optional(static_cast<Site>(front.sites())) : std::nullopt;
      }
    } policy;
    TestMesh mesh;
    Front front(mesh, 3);
    advance(front, policy);
    CHECK(front.sites() == 60);
    CHECK(policy.waiting.empty());
  }

  TEST_CASE("a frozen edge that is activated comes again") {
    TestMesh mesh;
    Front front(mesh, 3);
    Noting policy;
    advance(front, policy);
    policy.processed_from.clear();
    REQUIRE(front.frozen().size() > 5);
    const Halfedge woken = front.frozen()[4];
    front.activate(woken);
    CHECK(front.is_active(woken));
    const std::size_t frozen = front.frozen().size();
    front.freeze(front.frozen()[2]);
    CHECK(front.frozen().size() == frozen);
    advance(front, policy);
    CHECK(policy.processed_from == std::vector<Site>{front.from_site(woken)});
    CHECK(front.is_frozen(woken));
    // It is frozen once, however often that was requested.
    std::size_t boundary = 0;
    for (const BoundaryCurve& curve : front.curves()) boundary += curve.length();
    CHECK(front.next_level().reactivated == boundary);
  }
}
