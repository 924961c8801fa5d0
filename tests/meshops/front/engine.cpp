#include "meshops/front/engine.h"

#include <doctest/doctest.h>

#include <deque>
#include <map>

#include "meshops/topology/count.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// A policy without geometry: gives back a triangulation that is already known, from the seeds it is told.
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

/// Checks the whole mesh after every event.
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

/// Squares of a grid of `side`² sites, each cut in two; squares in `holes` are left out.
std::vector<Replay::Triangle> cut_squares(int side, const std::vector<int>& holes) {
  std::vector<Replay::Triangle> triangles;
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      if (std::find(holes.begin(), holes.end(), y * (side - 1) + x) != holes.end()) continue;
      const int s = y * side + x;
      triangles.push_back({s, s + 1, s + side + 1});
      triangles.push_back({s, s + side + 1, s + side});
    }
  return triangles;
}

}  // namespace

TEST_SUITE("engine") {
  TEST_CASE("builds what the policy knows, and is sound after every event") {
    const auto triangles = cut_squares(8, {24});
    for (std::size_t seed = 0; seed < triangles.size(); seed += 5) {
      TestMesh mesh;
      Front front(mesh, 64);
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
    std::vector<int> holes;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x)
        if ((x + y) % 2) holes.push_back(y * 7 + x);
    const auto triangles = cut_squares(8, holes);
    std::deque<Replay::Triangle> seeds;
    for (std::size_t i = 0; i < triangles.size(); i += 2) seeds.push_back(triangles[i]);
    TestMesh mesh;
    Front front(mesh, 64);
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
}
