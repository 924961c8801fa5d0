#include "rbpa/space/surface/holes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/surface/surface_levels.h"
#include "rbpa/space/surface/unused_points.h"
#include "space/surface/model.h"
#include "support/arguments.h"
#include "support/order.h"

using namespace rbpa_test;
using rbpa::Hole;
using rbpa::Point3;
using rbpa::RimCause;
using rbpa::RimEdge;
using rbpa::Surface;
using rbpa::UnusedCause;

TEST_SUITE_BEGIN("space");

namespace {

using Radii = std::vector<double>;

/// Returns one to three ascending radii that decide something.
Radii some_radii(const Points3& points, Random& random) {
  std::set<double> radii;
  for (std::size_t i = 0, count = 1 + random.below(3); i < count; ++i) radii.insert(space_radius(points, random));
  return {radii.begin(), radii.end()};
}

/// Returns normals that mostly agree with each other, so that there is a surface and a rim.
Points3 some_normals(const Points3& points, Random& random) {
  Points3 normals = random_normals(points.size(), random);
  const bool is_flat = random.chance(0.5);
  if (random.chance(0.2)) return normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 main = is_flat || points[i] == Point3{} ? Point3{0, 0, 1} : points[i];
    if (random.chance(0.9)) normals[i] = main;
  }
  return normals;
}

/// Checks that the curves pass each boundary side once, are continuous, and stay at a fan.
std::size_t check_curves(const std::vector<Hole>& curves, const Surface& surface, const Points3& points) {
  const auto place = [](const RimEdge& e) { return Triangle{e.from, e.to, e.triangle}; };
  std::set<Triangle> sides, expected;
  Triangle last = {};
  for (const Hole& curve : curves) {
    REQUIRE(!curve.edges.empty());
    CHECK(last <= place(curve.edges.front()));
    last = place(curve.edges.front());
    double length = 0;
    for (std::size_t i = 0; i < curve.edges.size(); ++i) {
      const RimEdge& edge = curve.edges[i];
      CHECK(edge.to == curve.edges[(i + 1) % curve.edges.size()].from);
      CHECK(last <= place(edge));
      CHECK(sides.insert(place(edge)).second);
      const Point3 &p = points[edge.from], &q = points[edge.to];
      length += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    }
    CHECK(curve.length == doctest::Approx(length));
  }
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.neighbors[t][k] == Surface::none)
        expected.insert({surface.triangles[t][(k + 2) % 3], surface.triangles[t][(k + 1) % 3], t});
  CHECK(sides == expected);
  return expected.size();
}

struct Causes {
  std::array<std::size_t, 3> rim = {};
  std::array<std::size_t, 4> unused = {};
};

/// Checks the causes by trying every triple against every point, at every radius.
void check_causes(const Points3& points, const Points3& normals, const Radii& radii, const Surface& surface,
                  const std::vector<Hole>& curves, Causes& seen) {
  std::vector<std::set<Triangle>> exposed;
  for (const double radius : radii) exposed.push_back(exposed_by_definition(points, radius));
  for (const Hole& curve : curves)
    for (const RimEdge& edge : curve.edges) {
      const Triangle& t = surface.triangles[edge.triangle];
      std::size_t level = radii.size() - 1;
      while (exposed[level].count(t) == 0) --level;
      REQUIRE(edge.level == level);
      const auto k = static_cast<std::size_t>(
          std::find_if(t.begin(), t.end(), [&](std::uint32_t i) { return i != edge.from && i != edge.to; }) -
          t.begin());
      const Triangle next = next_by_definition(points, exposed[level], t, k);
      REQUIRE(edge.next == next);
      CHECK(std::find(surface.triangles.begin(), surface.triangles.end(), next) == surface.triangles.end());
      std::array<bool, 3> corners = {}, sides = {};
      for (std::size_t j = 0; j < 3; ++j) corners[j] = disagrees(points, normals, next, j);
      const auto disagreeing = std::count(corners.begin(), corners.end(), true);
      const bool is_back =
          std::set<std::uint32_t>(t.begin(), t.end()) == std::set<std::uint32_t>(next.begin(), next.end());
      RimCause cause = disagreeing == 3 || is_back ? RimCause::nothing_within_reach
                       : disagreeing > 0           ? RimCause::normals_disagree
                                                   : RimCause::blocked;
      CHECK(edge.cause == cause);
      if (cause == RimCause::blocked) {
        REQUIRE(level > 0);
        ModelSurface smaller(points, normals);
        for (std::size_t i = 0; i < level; ++i) smaller.add(radii[i]);
        for (std::size_t j = 0; j < 3; ++j) {
          const std::uint32_t u = next[(j + 1) % 3], v = next[(j + 2) % 3];
          corners[j] = smaller.is_interior_point(next[j]);
          sides[j] = !smaller.is_interior_point(u) && !smaller.is_interior_point(v) && smaller.is_interior_edge(u, v);
        }
        CHECK(std::count(corners.begin(), corners.end(), true) + std::count(sides.begin(), sides.end(), true) > 0);
      }
      CHECK(edge.corners == corners);
      CHECK(edge.sides == sides);
      ++seen.rim[static_cast<std::size_t>(edge.cause)];
    }
}

/// Returns whether none of thousands of balls of the radius that touch the point is empty.
bool is_held_all_around(const Points3& points, std::uint32_t v, double radius, Random& random) {
  for (int trial = 0; trial < trials(3000); ++trial) {
    const double z = random.between(-1, 1), angle = random.between(0, 2 * M_PI), s = std::sqrt(1 - z * z);
    const Point3 c = {points[v].x + radius * s * std::cos(angle), points[v].y + radius * s * std::sin(angle),
                      points[v].z + radius * z};
    if (std::none_of(points.begin(), points.end(), [&](const Point3& p) {
          return p != points[v] && std::hypot(p.x - c.x, p.y - c.y, p.z - c.z) < radius;
        }))
      return false;
  }
  return true;
}

void check_unused(const Points3& points, const Points3& normals, const Radii& radii, const Surface& surface,
                  Causes& seen) {
  std::set<std::uint32_t> used;
  for (const Triangle& t : surface.triangles) used.insert(t.begin(), t.end());
  std::vector<std::uint32_t> expected;
  for (const std::uint32_t i : distinct_of(points))
    if (used.count(i) == 0) expected.push_back(i);
  const auto actual = rbpa::unused_points(points, normals, radii, surface);
  REQUIRE(actual.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::uint32_t v = actual[i].index;
    REQUIRE(v == expected[i]);
    bool is_exposed = false, is_agreeing = false;
    for (const double radius : radii)
      for (const Triangle& t : exposed_by_definition(points, radius))
        if (std::count(t.begin(), t.end(), v) > 0) {
          is_exposed = true;
          is_agreeing = is_agreeing || agrees(points, normals, t);
        }
    const UnusedCause cause = actual[i].cause;
    CHECK((cause == UnusedCause::blocked) == is_agreeing);
    CHECK((cause == UnusedCause::normals_disagree) == (is_exposed && !is_agreeing));
    ++seen.unused[static_cast<std::size_t>(cause)];
  }
}

}  // namespace

TEST_CASE("each boundary side is on one curve, and its cause follows from trying every triple against every point") {
  Random random(201);
  Causes seen;
  std::size_t sides = 0;
  for_space_sets(30, 4, 13, random, [&](const Points3& points) {
    const Points3 normals = some_normals(points, random);
    const Radii radii = some_radii(points, random);
    const Surface surface = rbpa::surface(points, normals, radii);
    const std::vector<Hole> curves = rbpa::holes(points, normals, radii, surface);
    sides += check_curves(curves, surface, points);
    check_causes(points, normals, radii, surface, curves, seen);
    check_unused(points, normals, radii, surface, seen);
    if (radii.size() > 1) return;
    CHECK(rbpa::holes(points, normals, radii[0], rbpa::surface(points, normals, radii[0])) == curves);
  });
  CHECK(sides > 500);
  for (const std::size_t count : seen.rim) CHECK(count > 20);
  for (const std::size_t count : seen.unused) CHECK(count > 0);
}

TEST_CASE(
    "an unused point with an agreeing triangle, at any radius, is blocked; with other triangles only, normals "
    "disagree") {
  Random random(203);
  std::size_t blocked = 0, others = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Points3 points = space_set(SpaceKind::noisy_sphere, 80, random);
    Points3 normals = points;
    for (Point3& n : normals)
      if (random.chance(0.1)) n = {-n.y, n.z, n.x};
    const Radii radii = {random.between(0.2, 0.3), random.between(0.3, 0.5), random.between(0.5, 2)};
    const Surface surface = rbpa::surface(points, normals, radii);
    std::vector<int> best(points.size(), 0);  // 2: on a triangle that agrees; 1: on other triangles only
    for (const double radius : radii)
      for (const Triangle& t : rbpa::exposed_triangles(points, radius).triangles)
        for (const std::uint32_t i : t) best[i] = std::max(best[i], agrees(points, normals, t) ? 2 : 1);
    for (const auto& [index, cause] : rbpa::unused_points(points, normals, radii, surface)) {
      CHECK((cause == UnusedCause::blocked) == (best[index] == 2));
      CHECK((cause == UnusedCause::normals_disagree) == (best[index] == 1));
      blocked += best[index] == 2;
      others += best[index] == 1;
    }
  }
  CHECK(blocked > 2);
  CHECK(others > 10);
}

TEST_CASE("shuffled points have the same holes, with lengths equal to the last bit") {
  Random random(204);
  std::size_t sides = 0;
  for (int trial = 0; trial < 10; ++trial) {
    Points3 points = space_set(SpaceKind::noisy_sphere, 150, random);
    sort_distinct(points);  // each point is unique
    const Radii radii = {0.25, 0.5};
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    const Points3 shuffled = in_order(points, order);
    // Lengths, and the data of each side.
    using EdgeFacts = std::tuple<Triangle, std::uint32_t, RimCause, Triangle>;
    const auto holes_of = [&](const Points3& of, const auto& name) {
      std::multiset<std::pair<double, std::set<EdgeFacts>>> all;
      const Surface surface = rbpa::surface(of, of, radii);
      for (const Hole& hole : rbpa::holes(of, of, radii, surface, {.threads = 2})) {
        std::set<EdgeFacts> facts;
        for (const RimEdge& e : hole.edges) {
          const Triangle next = {name(e.next[0]), name(e.next[1]), name(e.next[2])};
          facts.insert({{name(e.from), name(e.to), 0}, e.level, e.cause, canonical({next})[0]});
        }
        sides += facts.size();
        all.emplace(hole.length, facts);
      }
      return all;
    };
    CHECK((holes_of(shuffled, [&](std::uint32_t i) { return order[i]; }) ==
           holes_of(points, [](std::uint32_t i) { return i; })));
  }
  CHECK(sides > 500);
}

TEST_CASE("holes() refuses what is visibly not a surface of the points") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, up(4, {0, 0, 1});
  const Surface right = rbpa::surface(points, up, 1.0);
  const std::vector<Hole> rim = rbpa::holes(points, up, 1.0, right);
  REQUIRE(rim.size() == 1);
  CHECK(rim[0].length == 4);
  for (const RimEdge& e : rim[0].edges) CHECK(e.cause == RimCause::nothing_within_reach);
  using meshops::ContractViolation;
  CHECK_THROWS_AS(rbpa::holes(points, up, 0.1, right), ContractViolation);          // nothing rests at that radius
  CHECK_THROWS_AS(rbpa::holes(points, up, Radii{1, 2}, right), ContractViolation);  // no levels
  CHECK_THROWS_AS(rbpa::holes(Points3{{0, 0, 0}}, Points3{{0, 0, 1}}, 1.0, right), ContractViolation);
  CHECK_THROWS_AS(rbpa::holes(points, Points3(3, {0, 0, 1}), 1.0, right), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::holes(points, up, -1.0, right), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::unused_points(points, up, -1.0, right), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::unused_points(Points3{{0, 0, 0}}, {}, 1.0, right), ContractViolation);
  Surface cut = right;  // a boundary side where the surface continues
  cut.neighbors.assign(2, {Surface::none, Surface::none, Surface::none});
  CHECK_THROWS_AS(rbpa::holes(points, up, 1.0, cut), ContractViolation);
  CHECK(rbpa::holes({}, {}, 1.0, Surface{}).empty());
  const auto alone = rbpa::unused_points(Points3{{5, 5, 5}}, {}, 1.0, Surface{});
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].cause == UnusedCause::no_ball_rests);
}

TEST_CASE("a hidden point is in every ball that touches it, and where merely no ball rests some are empty") {
  Random random(202);
  std::size_t hidden = 0, alone = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const SpaceKind kind = std::array{SpaceKind::cube, SpaceKind::noisy_sphere, SpaceKind::grid}[random.below(3)];
    const Points3 points = space_set(kind, 3 + random.below(20), random);
    for (const double radius : {space_radius(points, random), 0.2, 1.0}) {
      const Surface surface = rbpa::exposed_triangles(points, radius);
      for (const auto& [index, cause] : rbpa::unused_points(points, {}, radius, surface)) {
        const bool is_hidden = cause == UnusedCause::hidden;
        REQUIRE((is_hidden || cause == UnusedCause::no_ball_rests));
        CHECK(is_hidden == is_held_all_around(points, index, radius, random));
        hidden += is_hidden;
        alone += !is_hidden;
      }
    }
  }
  CHECK(hidden > 50);
  CHECK(alone > 50);
}

TEST_SUITE_END();
