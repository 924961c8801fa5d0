#include "rbpa/space/surface/rolling_ball.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/surface/surface.h"
#include "support/for_space_sets.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::RollingBall;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

TEST_CASE("a rolling ball rests exactly on the exposed triangles, and rolls to their neighbors") {
  Random random(95);
  std::size_t triangles = 0, elsewhere = 0, several = 0;
  for_space_sets(20, 3, 13, random, [&](const Points3& points) {
    const double radius = space_radius(points, random);
    const Surface exposed = rbpa::exposed_triangles(points, radius);
    const RollingBall ball(points, radius);
    REQUIRE(std::equal(ball.points().begin(), ball.points().end(), points.begin(), points.end()));
    std::vector<Triangle> found;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      for (const Triangle& t : ball.triangles_from(i)) found.push_back(t);
    CHECK(found == exposed.triangles);
    int wrong = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<RollingBall::Roll>> about;
    for (std::size_t t = 0; t < exposed.triangles.size(); ++t)
      for (std::size_t side = 0; side < 3; ++side) {
        const Triangle& from = exposed.triangles[t];
        const std::uint32_t a = from[(side + 1) % 3], b = from[(side + 2) % 3], c = from[side];
        const auto p = ball.roll(a, b, c);
        REQUIRE(p);
        wrong += canonical({{b, a, *p}}) != std::vector{exposed.triangles[exposed.neighbors[t][side]]};
        wrong += ball.roll(b, a, *p) != c;
        wrong += !ball.agrees(from);
        if (p) about[{a, b}].push_back({c, *p});
      }
    for (std::uint32_t a = 0; a <= points.size(); ++a)
      for (std::uint32_t b = 0; b <= points.size(); ++b) {
        auto expected = about[{a, b}];
        std::sort(expected.begin(), expected.end(), [](const auto& r, const auto& s) { return r.from < s.from; });
        wrong += ball.rolls(a, b) != expected;
        several += expected.size() > 1;
      }
    CHECK(wrong == 0);
    triangles += found.size();
    for (int any = 0; any < 30; ++any) {
      const auto one = [&] { return static_cast<std::uint32_t>(random.below(points.size() + 1)); };
      const std::uint32_t a = one(), b = one(), c = one();
      const auto triangle = canonical({{a, b, c}});
      if (std::binary_search(found.begin(), found.end(), triangle.front())) continue;
      CHECK_FALSE(ball.roll(a, b, c));
      ++elsewhere;
    }
  });
  CHECK(triangles > 1500);
  CHECK(elsewhere > 1500);
  CHECK(several > 100);
}

TEST_CASE("a triangle agrees when its normal has a positive product with those of all points at its corners") {
  Random random(96);
  std::size_t agreeing = 0, others = 0;
  for (int k = 0; k < space_kinds; ++k) {
    const Points3 points = space_set(static_cast<SpaceKind>(k), 12, random);
    const Points3 normals = random_normals(points.size(), random);
    const RollingBall ball(points, normals, 1);
    for (int trial = 0; trial < 40; ++trial) {
      const auto one = [&] { return static_cast<std::uint32_t>(random.below(points.size())); };
      const Triangle t = {one(), one(), one()};
      bool expected = true;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i] == points[t[0]] || points[i] == points[t[1]] || points[i] == points[t[2]])
          expected =
              expected && rbpa::space::exact::normal_sign(points[t[0]], points[t[1]], points[t[2]], normals[i]) > 0;
      // Duplicates are queried by the lowest index.
      const auto is_lowest = [&](std::uint32_t i) {
        return std::find(points.begin(), points.end(), points[i]) == points.begin() + i;
      };
      if (!std::all_of(t.begin(), t.end(), is_lowest)) continue;
      CHECK(ball.agrees(t) == expected);
      ++(expected ? agreeing : others);
    }
  }
  CHECK(agreeing > 10);
  CHECK(others > 100);
}

TEST_CASE("a rolling ball refuses what surface() refuses, and indices without a point") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, up(4, {0, 0, 1});
  for (const double radius : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(RollingBall(points, radius), rbpa::InvalidInput);
  CHECK_THROWS_AS(RollingBall(points, Points3(3, {0, 0, 1}), 1), rbpa::InvalidInput);
  CHECK_THROWS_AS(RollingBall(points, Points3(4), 1), rbpa::InvalidInput);
  CHECK_THROWS_AS(RollingBall(Points3{{0, 0, std::numeric_limits<double>::quiet_NaN()}}, 1), rbpa::InvalidInput);
  RollingBall moved(points, up, 1);
  const RollingBall ball = std::move(moved);
  CHECK(ball.triangles_from(0) == std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}});
  CHECK(ball.roll(0, 1, 2) == 2);
  CHECK_FALSE(ball.roll(0, 3, 2));  // 1 stands for it
  CHECK(ball.triangles_from(3).empty());
  CHECK(ball.agrees({0, 1, 2}));
  CHECK_FALSE(ball.agrees({0, 2, 1}));
  CHECK_FALSE(ball.agrees({0, 1, 3}));
  CHECK_THROWS_AS(ball.triangles_from(4), meshops::ContractViolation);
  CHECK_THROWS_AS(ball.agrees({0, 1, 4}), meshops::ContractViolation);
  CHECK(RollingBall(Points3{}, 1).points().empty());
}

TEST_SUITE_END();
