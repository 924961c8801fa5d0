#include "rbpa/space/balls/ball_interfaces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "rbpa/base/error.h"
#include "support/ball_sets.h"

using namespace rbpa_test;
using doctest::Approx;
using rbpa::BallInterface;
using rbpa::BallInterfaces;
using rbpa::Point3;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using Groups = std::vector<std::uint32_t>;

/// Returns the area of the spheres of group `own` that is outside of the other balls of `own` and inside of those of
/// `other`, by points at random.
double sampled(const Balls& balls, const Groups& groups, std::uint32_t own, std::uint32_t other, int points,
               Random& random) {
  const auto is_in = [&](const Point3& x, std::uint32_t group, std::size_t but) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (i != but && groups[i] == group) {
        const Point3& c = balls.centers[i];
        if (std::hypot(x.x - c.x, x.y - c.y, x.z - c.z) < balls.radii[i]) return true;
      }
    return false;
  };
  double area = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i] != own) continue;
    int covered = 0;
    for (int k = 0; k < points; ++k) {
      const double z = random.between(-1, 1), angle = random.between(-pi, pi), r = std::sqrt(1 - z * z);
      const Point3& c = balls.centers[i];
      const double size = balls.radii[i];
      const Point3 x = {c.x + size * r * std::cos(angle), c.y + size * r * std::sin(angle), c.z + size * z};
      covered += !is_in(x, own, i) && is_in(x, other, groups.size());
    }
    area += 4 * pi * balls.radii[i] * balls.radii[i] * covered / points;
  }
  return area;
}

}  // namespace

TEST_CASE("two balls cover caps of each other, and share a disc") {
  // The circle is at x = (9 + 16 − 4) / 6 = 3.5, beyond the center of the second ball.
  const Points3 centers = {{0, 0, 0}, {3, 0, 0}};
  const BallInterfaces found = rbpa::ball_interfaces(centers, std::vector<double>{4, 2}, Groups{7, 3});
  REQUIRE(found.all.size() == 1);
  const BallInterface& one = found.all[0];
  CHECK(one.groups == std::array<std::uint32_t, 2>{3, 7});
  CHECK(one.areas[0] == Approx(2 * pi * 2 * 2.5));  // a cap of height 2 + 0.5
  CHECK(one.areas[1] == Approx(2 * pi * 4 * 0.5));
  CHECK(one.contact_area == Approx(pi * (16 - 3.5 * 3.5)));
  CHECK(found.areas_alone[0] == Approx(64 * pi));
  const BallInterfaces grown = rbpa::ball_interfaces(centers, std::vector<double>{3, 1}, Groups{7, 3}, {.probe = 1});
  CHECK(grown.all[0].areas == one.areas);
}

TEST_CASE("a ball in another is covered whole, one that touches not at all, and one far away is in no interface") {
  const Points3 centers = {{0, 0, 0}, {0.5, 0, 0}, {5, 0, 0}, {100, 0, 0}, {0, 2, 0}};
  const BallInterfaces found =
      rbpa::ball_interfaces(centers, std::vector<double>{3, 1, 2, 1, 1}, Groups{0, 1, 2, 3, rbpa::no_group});
  REQUIRE(found.all.size() == 2);
  CHECK(found.all[0].groups == std::array<std::uint32_t, 2>{0, 1});
  CHECK(found.all[0].areas[0] == Approx(0));
  CHECK(found.all[0].areas[1] == Approx(4 * pi));
  CHECK(found.all[0].contact_area == 0);
  CHECK(found.all[1].groups == std::array<std::uint32_t, 2>{0, 2});
  CHECK(found.all[1].areas[0] == Approx(0));
  CHECK(found.all[1].areas[1] == Approx(0));
  CHECK(found.areas_alone[4] == 0);
}

TEST_CASE("other groups make no difference to a pair, and areas are those of points at random") {
  Random random(5200);
  Balls balls;
  Groups groups;
  for (int i = 0; i < 90; ++i) {
    balls.centers.push_back({random.between(0, 4), random.between(0, 4), random.between(0, 4)});
    balls.radii.push_back(random.between(0.2, 0.8));
    groups.push_back(static_cast<std::uint32_t>(balls.centers.back().x * 3 / 4));
  }
  const BallInterfaces all = rbpa::ball_interfaces(balls.centers, balls.radii, groups);
  REQUIRE(all.all.size() >= 2);
  for (const BallInterface& one : all.all) {
    Groups only = groups;
    for (std::uint32_t& group : only)
      if (group != one.groups[0] && group != one.groups[1]) group = rbpa::no_group;
    const BallInterfaces alone = rbpa::ball_interfaces(balls.centers, balls.radii, only);
    REQUIRE(alone.all.size() == 1);
    CHECK(alone.all[0].areas == one.areas);
    CHECK(alone.all[0].contact_area == one.contact_area);
    for (std::size_t k = 0; k < 2; ++k) {
      const double expected = sampled(balls, groups, one.groups[k], one.groups[1 - k], 4000, random);
      CHECK(one.areas[k] == Approx(expected).epsilon(0.05));
      CHECK(one.areas[k] > 1);
    }
  }
}

TEST_CASE("equal balls of two groups count for the lower index, at any scale") {
  for (const double unit : {1.0, 1e-100, 1e100}) {
    const Points3 centers = {{0, 0, 0}, {0, 0, 0}};
    const BallInterfaces found = rbpa::ball_interfaces(centers, std::vector<double>{unit, unit}, Groups{1, 0});
    REQUIRE(found.all.size() == 1);
    CHECK(found.all[0].areas[0] == Approx(4 * pi * unit * unit));
    CHECK(found.all[0].areas[1] == 0);
  }
}

TEST_CASE("groups of another number than balls are refused, and no balls have no interfaces") {
  CHECK_THROWS_WITH_AS(rbpa::ball_interfaces(Points3{{0, 0, 0}}, std::vector<double>{1}, Groups{}),
                       "0 groups, expected one for each of 1 centers", rbpa::InvalidInput);
  CHECK(rbpa::ball_interfaces({}, {}, {}).all.empty());
}

TEST_SUITE_END();
