#include "meshops/front/engine.h"

#include <doctest/doctest.h>

#include <deque>
#include <map>
#include <random>

#include "meshops/core/reach.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/front_on_mesh.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Policy without geometry that reproduces a given triangulation, from given seeds.
class Replay {
 public:
  using Triangle = std::array<Site, 3>;
  Replay(const std::vector<Triangle>& triangles, std::deque<Triangle> seeds) : seeds_(std::move(seeds)) {
    for (const Triangle& t : triangles)
      for (unsigned i = 0; i < 3; ++i) apex_[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
  }
  std::optional<Triangle> seed(const Front&) {
    if (seeds_.empty()) return std::nullopt;
    const Triangle t = seeds_.front();
    seeds_.pop_front();
    return t;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) const {
    const auto found = apex_.find({front.from_site(h), front.to_site(h)});
    return found == apex_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::pair<Site, Site>, Site> apex_;
  std::deque<Triangle> seeds_;
};
static_assert(FrontPolicy<Replay>);

/// Visitor that checks the whole mesh after every event.
struct Validating : FrontVisitor {
  int seeds = 0, attachments = 0, freezes = 0;
  void seeded(const Front& front, const InsertedTriangle&) {
    ++seeds;
    check_sound(front.mesh());
  }
  void attached(const Front& front, Halfedge h, const InsertedTriangle& t) {
    ++attachments;
    CHECK(t.side[0] == h);
    check_sound(front.mesh());
  }
  void frozen(const Front& front, Halfedge h) {
    ++freezes;
    CHECK(front.mesh().is_boundary(h));
  }
};

/// Policy that returns all seeds that are not in the mesh yet, before any front advances.
class EagerSeeds : public Replay {
 public:
  EagerSeeds(const std::vector<Triangle>& triangles, std::deque<Triangle> seeds)
      : Replay(triangles, {}), seeds_(std::move(seeds)) {}
  std::optional<Triangle> seed(const Front& front) {
    while (!seeds_.empty()) {
      const Triangle t = seeds_.front();
      seeds_.pop_front();
      if (!in_mesh(front, t)) return t;
    }
    return std::nullopt;
  }

 private:
  static bool in_mesh(const Front& front, const Triangle& t) {
    bool found = false;
    front.for_each_fan(t[0], [&](Vertex v) {
      for (const auto h : front.mesh().voh_range(v))
        found = found || (!front.mesh().is_boundary(h) && front.to_site(h) == t[1] &&
                          front.to_site(front.mesh().next_halfedge_handle(h)) == t[2]);
    });
    return found;
  }
  std::deque<Triangle> seeds_;
};

/// Visitor that counts curves by the events alone.
struct CurveCounter : CurveVisitor {
  int curves = 0, joins = 0, splits = 0, closings = 0;
  void curve_begun(const Front& front, Halfedge h) {
    ++curves;
    CHECK(front.mesh().is_boundary(h));
  }
  void curves_joined(const Front&, Halfedge) {
    --curves;
    ++joins;
  }
  void curve_split(const Front& front, Halfedge a, Halfedge b) {
    ++curves;
    ++splits;
    CHECK_FALSE(on_same_curve(front.mesh(), a, b));
  }
  void curve_closed(const Front&) {
    --curves;
    ++closings;
  }
  // This is called before the events of the next triangle, and so after all events of the one before.
  void frozen(const Front& front, Halfedge) { CHECK(curves == static_cast<int>(front.curves().size())); }
};

/// Policy that attaches a new point to every edge until there are forty.
struct Placing {
  std::optional<std::array<Site, 3>> seed(const Front& front) const {
    if (front.faces() > 0) return std::nullopt;
    return std::array<Site, 3>{0, 1, 2};
  }
  std::optional<Site> propose(const Front& front, Halfedge) const {
    if (front.sites() == 40) return std::nullopt;
    return static_cast<Site>(front.sites());
  }
};

/// Returns the squares of a grid of `side`² sites, each cut in two, without the squares in `holes`.
std::vector<Replay::Triangle> cut_squares(Site side, const std::vector<Site>& holes) {
  std::vector<Replay::Triangle> triangles;
  for (Site y = 0; y + 1 < side; ++y)
    for (Site x = 0; x + 1 < side; ++x) {
      if (std::find(holes.begin(), holes.end(), y * (side - 1) + x) != holes.end()) continue;
      const Site s = y * side + x;
      triangles.push_back({s, s + 1, s + side + 1});
      triangles.push_back({s, s + side + 1, s + side});
    }
  return triangles;
}

}  // namespace

TEST_SUITE("engine") {
  TEST_CASE("the engine builds the policy's triangulation, and the mesh is sound after every event") {
    const auto triangles = cut_squares(8, {24});
    for (std::size_t seed = 0; seed < triangles.size(); seed += 5) {
      auto [mesh, front] = FrontOnMesh(64);
      Replay policy(triangles, {triangles[seed]});
      Validating visitor;
      advance(front, policy, visitor);
      CHECK(visitor.seeds == 1);
      CHECK(visitor.attachments + 1 == static_cast<int>(triangles.size()));
      CHECK(visitor.freezes == 28 + 4);
      front.finish();
      check_sound(mesh);
      const TopologyCounts counts = count_topology(mesh);
      CHECK(counts.vertices == 64);
      CHECK(counts.faces == triangles.size());
      CHECK(counts.boundary_curves == 2);
      CHECK(counts.components == 1);
    }
  }

  TEST_CASE("squares that meet in corners are separate components with pinches between them") {
    // A chessboard: every other square is a hole.
    std::vector<Site> holes;
    for (Site y = 0; y < 7; ++y)
      for (Site x = 0; x < 7; ++x)
        if ((x + y) % 2) holes.push_back(y * 7 + x);
    const auto triangles = cut_squares(8, holes);
    std::deque<Replay::Triangle> seeds;
    for (std::size_t i = 0; i < triangles.size(); i += 2) seeds.push_back(triangles[i]);
    auto [mesh, front] = FrontOnMesh(64);
    Replay policy(triangles, seeds);
    Validating visitor;
    advance(front, policy, visitor);
    CHECK(visitor.seeds == 25);
    const auto sites = front.finish();
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.components == 25);
    CHECK(counts.vertices == 100);
    CHECK(counts.boundary_curves == 25);
    check_sound(mesh);
  }

  TEST_CASE("the events of curves add up to their number at each moment") {
    std::mt19937 random(5);
    int joins = 0, splits = 0, closings = 0;
    for (int round = 0; round < 60; ++round) {
      std::vector<Site> holes;
      for (Site square = 0; square < 49; ++square)
        if (random() % 4 == 0) holes.push_back(square);
      const auto triangles = cut_squares(8, holes);
      std::deque<Replay::Triangle> seeds;
      // Several seeds of one component grow toward each other.
      for (const auto& t : triangles)
        if (random() % 5 == 0) seeds.push_back(t);
      auto [mesh, front] = FrontOnMesh(64);
      CurveCounter visitor;
      EagerSeeds only_seeds({}, seeds);
      advance(front, only_seeds, visitor);
      front.next_level();
      EagerSeeds policy(triangles, {});
      advance(front, policy, visitor);
      CHECK(visitor.curves == static_cast<int>(count_topology(mesh).boundary_curves));
      joins += visitor.joins;
      splits += visitor.splits;
      closings += visitor.closings;
    }
    CHECK(joins > 20);
    CHECK(splits > 20);
    CHECK(closings > 5);
  }

  TEST_CASE("a run level by level gives the mesh of one run, and carries exactly the sites that are not inner") {
    std::mt19937 random(9);
    for (int round = 0; round < 30; ++round) {
      std::vector<Site> holes;
      for (Site square = 0; square < 49; ++square)
        if (random() % 6 == 0) holes.push_back(square);
      const auto triangles = cut_squares(8, holes);
      std::vector<int> level(triangles.size());
      for (int& l : level) l = static_cast<int>(random() % 5);

      auto [mesh, front] = FrontOnMesh(64);
      std::size_t behind = 0;
      for (int now = 0; now < 5; ++now) {
        std::vector<Replay::Triangle> allowed;
        for (std::size_t i = 0; i < triangles.size(); ++i)
          if (level[i] <= now) allowed.push_back(triangles[i]);
        EagerSeeds policy(allowed, {allowed.begin(), allowed.end()});
        FrontVisitor silent;
        advance(front, policy, silent);
        check_sound(mesh);
        CHECK(front.faces() == allowed.size());
        const LevelTransfer transfer = front.next_level();
        std::vector<Site> expected;
        for (Site s = 0; s < 64; ++s)
          if (front.is_free(s) || front.is_on_boundary(s)) expected.push_back(s);
        CHECK(transfer.carried == expected);
        behind += transfer.left_behind;
        CHECK(behind == 64 - expected.size());
        std::size_t on_curves = 0;
        for (const auto& curve : front.curves()) on_curves += curve.length();
        CHECK(transfer.reactivated == on_curves);
      }
      TestMesh at_once;
      Front other(at_once, 64);
      EagerSeeds policy(triangles, {triangles.begin(), triangles.end()});
      FrontVisitor silent;
      advance(other, policy, silent);
      front.finish();
      other.finish();
      CHECK(count_topology(mesh) == count_topology(at_once));
      CHECK(isomorphism_class(mesh) == isomorphism_class(at_once));
    }
  }

  TEST_CASE("a policy that proposes the site after the last places points") {
    auto [mesh, front] = FrontOnMesh(3);
    Placing policy;
    Validating visitor;
    advance(front, policy, visitor);
    CHECK(front.sites() == 40);
    CHECK(visitor.attachments == 37);
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.vertices == 40);
    CHECK(counts.faces == 38);
    CHECK(counts.boundary_curves == 1);
  }
}
