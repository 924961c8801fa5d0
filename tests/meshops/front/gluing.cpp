// A policy that decides which sides are glued: its decisions hold, not those that sites alone would give.
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <set>
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

using Corners = std::array<Site, 3>;

/// Given triangles, with the triangle across from each of their corners, −1 for none.
struct Given {
  std::vector<Corners> triangles;
  std::vector<std::array<int, 3>> across;
  std::size_t next = 0;

  /// Returns all triangles as seeds, in order; the front refuses those that exist.
  std::optional<Corners> seed(const Front& front) {
    for (; next < triangles.size(); ++next) {
      const auto& [a, b, c] = triangles[next];
      if (!front.triangle_on(a, b, c).is_valid()) return triangles[next];
    }
    return std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) const {
    const int other = beyond(front, h);
    if (other < 0) return std::nullopt;
    for (const Site s : triangles[static_cast<std::size_t>(other)])
      if (s != front.from_site(h) && s != front.to_site(h)) return s;
    return std::nullopt;
  }
  bool glues(const Front& front, Halfedge h, Site apex) const { return propose(front, h) == apex; }

  /// Returns the triangle across the boundary halfedge.
  int beyond(const Front& front, Halfedge h) const {
    const Halfedge behind = front.mesh().opposite_halfedge_handle(h);
    const Site c = front.to_site(front.mesh().next_halfedge_handle(behind));
    const Corners wanted = {front.to_site(h), front.from_site(h), c};
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        if (Corners{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3], triangles[t][i]} == wanted)
          return across[t][i];
    return -1;
  }
};

TopologyCounts advanced(Given policy, std::size_t sites, std::size_t expected_faces) {
  auto [mesh, front] = FrontOnMesh(sites);
  advance(front, policy);
  CHECK(front.faces() == expected_faces);
  front.finish();
  check_sound(mesh);
  return count_topology(mesh);
}

}  // namespace

TEST_SUITE("gluing") {
  TEST_CASE("a site that was left behind is carried again when another fan begins there") {
    auto [mesh, front] = FrontOnMesh(6);
    front.create(0, 1, 2);
    front.create(0, 2, 3);
    front.create(0, 3, 1);
    const LevelTransfer first = front.next_level();
    CHECK(first.carried == std::vector<Site>{1, 2, 3, 4, 5});
    CHECK(first.left_behind == 1);
    front.insert(front.fit(0, 4, 5, [](Halfedge, Site) { return false; }));
    const LevelTransfer second = front.next_level();
    CHECK(second.carried == std::vector<Site>{0, 1, 2, 3, 4, 5});
    CHECK(second.left_behind == 0);
    check_sound(mesh);
  }

  TEST_CASE("a slit of two edges between the same vertices stays open, although sites alone would glue it") {
    // A strip around 0 and 1, whose two triangles at the edge 0–1 are not linked to each other.
    const Given slit{{{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {0, 4, 3}, {1, 3, 5}, {1, 5, 2}},
                     {{5, 2, -1}, {3, 4, -1}, {-1, 3, 0}, {-1, 1, 2}, {-1, 5, 1}, {-1, 0, 4}}};
    const TopologyCounts counts = advanced(slit, 6, 6);
    CHECK(counts.vertices == 6);
    CHECK(counts.edges == 12);
    CHECK(counts.boundary_curves == 2);  // the rim, and the slit of two edges
    CHECK(counts.components == 1);

    Given closed = slit;
    closed.across[0][2] = 1;
    closed.across[1][2] = 0;
    CHECK(advanced(closed, 6, 6).boundary_curves == 1);

    // A policy without glues() glues by sites, whatever `across` holds, and closes the slit.
    struct BySites {
      Given given;
      std::optional<Corners> seed(const Front& front) { return given.seed(front); }
      std::optional<Site> propose(const Front& front, Halfedge h) const { return given.propose(front, h); }
    } by_sites{slit};
    auto [mesh, front] = FrontOnMesh(6);
    advance(front, by_sites);
    CHECK(count_topology(mesh).boundary_curves == 1);
  }

  TEST_CASE("four triangles at one edge are glued in two pairs") {
    const Given book{{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}},
                     {{-1, -1, 1}, {-1, -1, 0}, {-1, -1, 3}, {-1, -1, 2}}};
    const TopologyCounts counts = advanced(book, 6, 4);
    CHECK(counts.components == 2);
    CHECK(counts.vertices == 8);  // two fans at 0 and at 1
    CHECK(counts.boundary_curves == 2);

    auto [mesh, front] = FrontOnMesh(6);
    Given policy = book;
    advance(front, policy);
    std::set<Site> left, right;
    for (const auto& [from, to] : {std::pair<Site, Site>{0, 1}, {1, 0}}) {
      const std::vector<Halfedge> edges = front.edges_between(from, to);
      REQUIRE(edges.size() == 2);
      CHECK(edges[0] != edges[1]);
      for (const Halfedge h : edges) {
        CHECK(front.from_site(h) == from);
        CHECK(front.to_site(h) == to);
        (from == 0 ? left : right).insert(front.to_site(mesh.next_halfedge_handle(h)));
      }
    }
    CHECK(left == std::set<Site>{2, 4});
    CHECK(right == std::set<Site>{3, 5});
    CHECK(front.edges_between(2, 3).empty());
  }

  TEST_CASE("a site around which all faces close can have a further fan") {
    const Given cone{{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}, {{-1, 1, 2}, {-1, 2, 0}, {-1, 0, 1}, {-1, -1, -1}}};
    const TopologyCounts counts = advanced(cone, 6, 4);
    CHECK(counts.components == 2);
    CHECK(counts.vertices == 7);
    CHECK(counts.boundary_curves == 2);
  }

  TEST_CASE("an existing triangle is refused, and a run on a fixed number of sites ends whatever the policy returns") {
    TestMesh mesh;
    Front front(mesh, 3);
    const auto never = [](Halfedge, Site) { return false; };
    front.insert(front.fit(0, 1, 2, never));
    CHECK(front.fit(1, 2, 0, never).refusal == Refusal{RefusalKind::triangle_there, 1, 2, 0});
    CHECK(describe(*front.fit(1, 2, 0, never).refusal) == "face 0 on site 1 and site 2 is that triangle already");
    CHECK_FALSE(front.fit(2, 1, 0, never).refusal);
    CHECK(front.triangle_on(2, 0, 1) == Face(0));
    CHECK_FALSE(front.triangle_on(0, 2, 1).is_valid());
    CHECK(front.fit(0, 0, 1, never).refusal->kind == RefusalKind::corner_repeated);
    CHECK(front.fit(0, 1, 9, never).refusal->kind == RefusalKind::no_such_site);
    CHECK(front.fit(Halfedge(0), 1, never).refusal->kind == RefusalKind::no_boundary_halfedge);

    struct Never {
      Site next = 0;
      std::optional<Corners> seed(const Front& front) const {
        return front.faces() == 0 ? std::optional(Corners{0, 1, 2}) : std::nullopt;
      }
      std::optional<Site> propose(const Front& front, Halfedge) {
        return next = static_cast<Site>((next + 1) % front.sites());
      }
      bool glues(const Front&, Halfedge, Site) const { return false; }
    } policy;
    TestMesh sheets;
    Front many(sheets, 7);
    advance(many, policy);
    CHECK(many.faces() <= 7 * 6 * 5 / 3);
    CHECK(many.faces() > 7);
    many.finish();
    check_sound(sheets);
  }

  TEST_CASE("seeds are glued as the policy decides, too") {
    // Two triangles with a common side. The second is a seed, because nothing is proposed.
    struct Seeds {
      bool glued;
      std::size_t next = 0;
      std::optional<Corners> seed(const Front&) {
        return next < 2 ? std::optional(next++ == 0 ? Corners{0, 1, 2} : Corners{1, 0, 3}) : std::nullopt;
      }
      std::optional<Site> propose(const Front&, Halfedge) const { return std::nullopt; }
      bool glues(const Front& front, Halfedge h, Site apex) const {
        CHECK(front.from_site(h) == 1);
        CHECK(front.to_site(h) == 0);
        CHECK(apex == 3);
        return glued;
      }
    };
    for (const bool glued : {false, true}) {
      Seeds policy{glued};
      auto [mesh, front] = FrontOnMesh(4);
      advance(front, policy);
      CHECK(count_topology(mesh).components == (glued ? 1 : 2));
      check_sound(mesh);
    }
  }
}
