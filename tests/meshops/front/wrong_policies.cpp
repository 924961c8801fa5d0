// Policies that return impossible proposals: the front stays sound, the run ends, and the visitor is notified.
#include <doctest/doctest.h>

#include <functional>
#include <random>
#include <stdexcept>

#include "meshops/front/engine.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/front_on_mesh.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Seed = std::array<Site, 3>;
constexpr auto minus_one = static_cast<Site>(-1);

/// Policy that returns the answers given at construction: one seed, and the same kind of proposal for every edge.
struct Saying {
  std::optional<Seed> first;
  std::function<Proposal(const Front&, Halfedge)> answer;
  std::optional<Seed> seed(const Front& front) const { return front.faces() == 0 ? first : std::nullopt; }
  Proposal propose(const Front& front, Halfedge h) const { return answer(front, h); }
};

/// Visitor that records the events.
struct Received : FrontVisitor {
  std::vector<RefusalKind> refused_for;
  std::vector<RefusalKind> seeds_refused_for;
  std::size_t frozen_edges = 0;
  void refused(const Front& front, Halfedge h, const Refusal& refusal) {
    CHECK(front.is_boundary(h));
    CHECK_FALSE(front.is_frozen(h));
    refused_for.push_back(refusal.kind);
  }
  void seed_refused(const Front& front, const Seed& seed, const Refusal& refusal) {
    CHECK(front.create_blocker(seed[0], seed[1], seed[2]) == refusal);
    seeds_refused_for.push_back(refusal.kind);
  }
  void frozen(const Front&, Halfedge) { ++frozen_edges; }
};

void check_answer(const std::function<Proposal(const Front&, Halfedge)>& answer, RefusalKind expected) {
  auto [mesh, front] = FrontOnMesh(8);
  Received received;
  Saying policy{Seed{0, 1, 2}, answer};
  advance(front, policy, received);
  CHECK(received.refused_for == std::vector(3, expected));
  CHECK(received.frozen_edges == 3);
  CHECK(front.faces() == 1);
  check_sound(mesh);
}

void check_seed(const Seed& seed, RefusalKind expected) {
  auto [mesh, front] = FrontOnMesh(8);
  Received received;
  Saying policy{seed, [](const Front&, Halfedge) { return std::nullopt; }};
  advance(front, policy, received);
  CHECK(received.seeds_refused_for == std::vector{expected});
  CHECK(front.faces() == 0);
  CHECK(front.sites() == 8);
  check_sound(mesh);
}

}  // namespace

TEST_SUITE("wrong policies") {
  TEST_CASE("an apex that is not a site is refused at every edge, and the edges are frozen") {
    check_answer([](const Front&, Halfedge) { return Site{77}; }, RefusalKind::no_such_site);
    check_answer([](const Front&, Halfedge) { return minus_one; }, RefusalKind::no_such_site);
    check_answer([](const Front& front, Halfedge) { return static_cast<Site>(front.sites() + 1); },
                 RefusalKind::no_such_site);
  }

  TEST_CASE("an apex at an end of the edge is refused") {
    check_answer([](const Front& front, Halfedge h) { return front.from_site(h); }, RefusalKind::corner_repeated);
    check_answer([](const Front& front, Halfedge h) { return front.to_site(h); }, RefusalKind::corner_repeated);
  }

  TEST_CASE("the triangle behind the edge cannot be detached if it does not exist or is not at the front") {
    check_answer([](const Front&, Halfedge) { return Proposal::detach(Face(-1)); }, RefusalKind::no_such_face);
    check_answer([](const Front&, Halfedge) { return Proposal::detach(Face(1)); }, RefusalKind::no_such_face);
  }

  TEST_CASE("a halfedge that the visitor activates when a seed is refused gets its turn, and the run ends") {
    struct Always {
      int proposals = 0;
      std::optional<Site> apex;
      std::optional<Seed> seed(const Front&) const { return Seed{0, 1, 2}; }
      std::optional<Site> propose(const Front&, Halfedge) { return ++proposals > 3 ? apex : std::nullopt; }
    };
    struct Activating : Received {
      Front* front = nullptr;
      void seed_refused(const Front&, const Seed&, const Refusal&) {
        for (const Halfedge h : std::vector<Halfedge>(front->frozen()))
          if (front->is_frozen(h)) front->activate(h);
        ++refusals;
      }
      int refusals = 0;
    };
    for (const std::optional<Site> apex : {std::optional<Site>(), std::optional<Site>(3)}) {
      auto [mesh, front] = FrontOnMesh(4);
      Always policy{0, apex};
      Activating visitor;
      visitor.front = &front;
      advance(front, policy, visitor);
      for (const BoundaryCurve& curve : front.curves())
        for (const Halfedge h : curve) CHECK(front.is_frozen(h));
      CHECK(policy.proposals >= 6);
      CHECK(front.faces() == (apex ? 4 : 1));
      CHECK(visitor.refusals == (apex ? 2 : 1));
      check_sound(mesh);
    }
  }

  TEST_CASE("a seed of sites that do not exist, or with one site twice, is refused, and the run ends") {
    check_seed({0, 1, 9}, RefusalKind::no_such_site);
    check_seed({0, 1, minus_one}, RefusalKind::no_such_site);
    check_seed({0, 1, 1}, RefusalKind::corner_repeated);
    check_seed({3, 3, 3}, RefusalKind::corner_repeated);
  }

  TEST_CASE("after a refused seed the policy is called for another, until it returns the same again") {
    struct Trying {
      std::vector<Seed> seeds = {{0, 1, 1}, {0, 1, 99}, {0, 1, 2}, {2, 0, 1}, {0, 1, 2}, {0, 1, 2}, {3, 4, 5}};
      std::size_t next = 0;
      std::optional<Seed> seed(const Front&) { return seeds.at(next++); }
      std::optional<Site> propose(const Front&, Halfedge) { return std::nullopt; }
    } policy;
    TestMesh mesh;
    Front front(mesh, 8);
    Received received;
    advance(front, policy, received);
    CHECK(received.seeds_refused_for == std::vector{RefusalKind::corner_repeated, RefusalKind::no_such_site,
                                                    RefusalKind::side_taken, RefusalKind::side_taken});
    CHECK(policy.next == 6);
    CHECK(front.faces() == 1);
  }

  TEST_CASE("a policy without geometry in space makes no edge with three faces, and ends") {
    // Each edge gets any point, over and over, and each point triple is a seed.
    struct Careless {
      std::mt19937 random{7};
      std::size_t seeds = 0, points;
      Site any() { return static_cast<Site>(random() % points); }
      std::optional<Seed> seed(const Front&) {
        if (++seeds > 50 * points) return std::nullopt;
        return Seed{any(), any(), any()};
      }
      std::optional<Site> propose(const Front&, Halfedge) { return any(); }
    };
    for (const std::size_t points : {std::size_t{6}, std::size_t{40}, std::size_t{300}}) {
      Careless policy;
      policy.points = points;
      auto [mesh, front] = FrontOnMesh(points);
      Received received;
      for (int level = 0; level < 5; ++level) {
        advance(front, policy, received);
        check_sound(mesh);
        front.next_level();
      }
      CHECK(!received.refused_for.empty());
      std::set<std::pair<Site, Site>> sides;
      std::size_t faces = 0;
      for (const auto f : mesh.faces()) {
        ++faces;
        for (const auto h : mesh.fh_range(f)) CHECK(sides.insert({front.from_site(h), front.to_site(h)}).second);
      }
      CHECK(sides.size() == 3 * faces);
    }
  }

  TEST_CASE("seeds and proposals place new points") {
    struct Growing {
      std::optional<Seed> seed(const Front& front) {
        const auto n = static_cast<Site>(front.sites());
        if (n >= 30) return std::nullopt;
        return n == 0 ? Seed{1, 0, 2} : Seed{n, static_cast<Site>(n - 1), static_cast<Site>(n + 1)};
      }
      std::optional<Site> propose(const Front& front, Halfedge) {
        if (front.sites() % 10 == 0) return std::nullopt;
        return static_cast<Site>(front.sites());
      }
    } policy;
    auto [mesh, front] = FrontOnMesh(0);
    advance(front, policy);
    CHECK(front.sites() == 30);
    check_sound(mesh);
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.components == 3);
    CHECK(counts.isolated == 0);
    // A seed that touched existing triangles made a pinch: its site has a vertex for each fan.
    CHECK(counts.vertices == 32);
  }

  TEST_CASE("a visitor can be a local class, with the events of curves or without") {
    struct Local : CurveVisitor {
      int begun = 0, refusals = 0;
      void curve_begun(const Front&, Halfedge) { ++begun; }
      void refused(const Front&, Halfedge, const Refusal&) { ++refusals; }
    } visitor;
    TestMesh mesh;
    Front front(mesh, 3);
    Saying policy{Seed{0, 1, 2}, [](const Front&, Halfedge) { return Site{77}; }};
    advance(front, policy, visitor);
    CHECK(visitor.begun == 1);
    CHECK(visitor.refusals == 3);
  }

  TEST_CASE("when the policy throws, active edges stay active, and the run can be continued") {
    for (const bool ordered : {false, true}) {
      CAPTURE(ordered);
      struct Tired {
        std::size_t calls = 0, until;
        std::optional<Seed> seed(const Front& front) {
          return front.faces() == 0 ? std::optional(Seed{0, 1, 2}) : std::nullopt;
        }
        std::optional<Site> propose(const Front& front, Halfedge) {
          if (calls++ == until) throw std::runtime_error("tired");
          return front.sites() < 30 ? std::optional(static_cast<Site>(front.sites())) : std::nullopt;
        }
      };
      struct TiredInOrder : Tired {
        std::size_t key(const Front& front, Halfedge h) const { return front.from_site(h) % 5; }
      };
      const auto run = [](auto policy) {
        for (policy.until = 0; policy.until < 20; ++policy.until) {
          auto [mesh, front] = FrontOnMesh(3);
          policy.calls = 0;
          CHECK_THROWS_AS(advance(front, policy), std::runtime_error);
          check_sound(mesh);
          std::size_t active = 0, boundary = 0;
          for (const BoundaryCurve& curve : front.curves())
            for (const Halfedge h : curve) {
              ++boundary;
              active += front.is_active(h);
            }
          CHECK(active == boundary);
          advance(front, policy);
          CHECK(front.faces() == 28);
          for (const BoundaryCurve& curve : front.curves())
            for (const Halfedge h : curve) CHECK(front.is_frozen(h));
        }
      };
      ordered ? run(TiredInOrder{}) : run(Tired{});
    }
  }

  TEST_CASE("a triangle is detached when the policy returns that, and the edge is proposed for once more") {
    // Backtracking as in Lo's method: the edge 1→0 gets the apex 3, then detaches its own triangle, and gets 4.
    struct Backtracking {
      std::optional<Face> to_go;
      bool gone = false;
      std::optional<Seed> seed(const Front& front) {
        return front.faces() == 0 ? std::optional(Seed{0, 1, 2}) : std::nullopt;
      }
      Proposal propose(const Front& front, Halfedge h) {
        if (front.from_site(h) == 1 && front.to_site(h) == 0) return Site{gone ? 4U : 3U};
        if (front.from_site(h) == 3 && front.to_site(h) == 0 && !gone) {
          gone = true;
          return Proposal::detach(front.mesh().face_handle(front.mesh().opposite_halfedge_handle(h)));
        }
        return std::nullopt;
      }
    } policy;
    struct Account : CurveVisitor {
      int detachments = 0, curves = 0;
      void detached(const Front& front, const DetachedTriangle& t) {
        ++detachments;
        CHECK(front.faces() == 1);
        CHECK(std::set<Site>(t.corners.begin(), t.corners.end()) == std::set<Site>{0, 1, 3});
      }
      void curve_begun(const Front&, Halfedge) { ++curves; }
      void curves_joined(const Front&, Halfedge) { --curves; }
      void curve_split(const Front&, Halfedge, Halfedge) { ++curves; }
      void curve_closed(const Front&) { --curves; }
    } account;
    auto [mesh, front] = FrontOnMesh(5);
    advance(front, policy, account);
    CHECK(account.detachments == 1);
    CHECK(account.curves == 1);
    CHECK(front.is_free(3));
    CHECK_FALSE(front.is_free(4));
    CHECK(front.faces() == 2);
    check_sound(mesh);
  }
}
