#include "rbpa/space/balls/ball_interfaces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "rbpa/base/error.h"
#include "support/ball_sets.h"

using namespace rbpa_test;
using doctest::Approx;
using rbpa::BallInterface;
using rbpa::BallInterfaces;
using rbpa::Point3;
using rbpa::RepeatingCell;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using Groups = std::vector<std::uint32_t>;

Point3 moved(const Point3& p, const RepeatingCell& cell, double x, double y, double z) {
  const auto& [a, b, c] = cell.edges;
  return {p.x + x * a.x + y * b.x + z * c.x, p.y + x * a.y + y * b.y + z * c.y, p.z + x * a.z + y * b.z + z * c.z};
}

/// Returns the area of the spheres of group `own`, of the first `count` balls, that is outside of the other balls of
/// `own` and inside of those of `other`, by points at random.
double sampled(const Balls& balls, const Groups& groups, std::size_t count, std::uint32_t own, std::uint32_t other,
               int points, Random& random) {
  const auto is_in = [&](const Point3& x, std::uint32_t group, std::size_t but) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (i != but && groups[i] == group) {
        const Point3& c = balls.centers[i];
        if (std::hypot(x.x - c.x, x.y - c.y, x.z - c.z) < balls.radii[i]) return true;
      }
    return false;
  };
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
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

constexpr RepeatingCell leaning = {{{{4, 0, 0}, {1, 5, 0}, {-1.5, 0.5, 6}}}};

/// Returns `count` balls in a cell, in three groups.
std::pair<Balls, Groups> grouped_balls(const RepeatingCell& cell, int count, double greatest, Random& random) {
  Balls balls;
  Groups groups;
  for (int i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    balls.centers.push_back(moved({0, 0, 0}, cell, x, y, z));
    balls.radii.push_back(random.between(0.2, greatest));
    groups.push_back(static_cast<std::uint32_t>(3 * x));
  }
  return {balls, groups};
}

/// Adds the images of the balls that are moved by `low` to `high` edges.
void add_images(Balls& balls, Groups& groups, const RepeatingCell& cell, int low, int high) {
  const std::size_t count = groups.size();
  for (int x = low; x <= high; ++x)
    for (int y = low; y <= high; ++y)
      for (int z = low; z <= high; ++z)
        for (std::size_t i = 0; i < count && (x != 0 || y != 0 || z != 0); ++i) {
          balls.centers.push_back(moved(balls.centers[i], cell, x, y, z));
          balls.radii.push_back(balls.radii[i]);
          groups.push_back(groups[i]);
        }
}

}  // namespace

TEST_CASE("two balls cover caps of each other, and share a disc") {
  // The circle is at x = (9 + 16 − 4) / 6 = 3.5, beyond the center of the second ball.
  const Points3 centers = {{0, 0, 0}, {3, 0, 0}};
  const BallInterfaces found = rbpa::ball_interfaces({centers, std::vector<double>{4, 2}}, Groups{7, 3});
  REQUIRE(found.all.size() == 1);
  const BallInterface& one = found.all[0];
  CHECK(one.groups == std::array<std::uint32_t, 2>{3, 7});
  CHECK(one.areas[0] == Approx(2 * pi * 2 * 2.5));  // a cap of height 2 + 0.5
  CHECK(one.areas[1] == Approx(2 * pi * 4 * 0.5));
  CHECK(one.contact_area == Approx(pi * (16 - 3.5 * 3.5)));
  CHECK(found.areas_alone[0] == Approx(64 * pi));
  const BallInterfaces grown = rbpa::ball_interfaces({centers, std::vector<double>{3, 1}}, Groups{7, 3}, {.probe = 1});
  CHECK(grown.all[0].areas == one.areas);
}

TEST_CASE("a ball in another is covered whole, one that touches not at all, and one far away is in no interface") {
  const Points3 centers = {{0, 0, 0}, {0.5, 0, 0}, {5, 0, 0}, {100, 0, 0}, {0, 2, 0}};
  const BallInterfaces found =
      rbpa::ball_interfaces({centers, std::vector<double>{3, 1, 2, 1, 1}}, Groups{0, 1, 2, 3, rbpa::no_group});
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
  const BallInterfaces all = rbpa::ball_interfaces({balls.centers, balls.radii}, groups);
  REQUIRE(all.all.size() >= 2);
  for (const BallInterface& one : all.all) {
    Groups only = groups;
    for (std::uint32_t& group : only)
      if (group != one.groups[0] && group != one.groups[1]) group = rbpa::no_group;
    const BallInterfaces alone = rbpa::ball_interfaces({balls.centers, balls.radii}, only);
    REQUIRE(alone.all.size() == 1);
    CHECK(alone.all[0].areas == one.areas);
    CHECK(alone.all[0].contact_area == one.contact_area);
    for (std::size_t k = 0; k < 2; ++k) {
      const double expected = sampled(balls, groups, groups.size(), one.groups[k], one.groups[1 - k], 4000, random);
      CHECK(one.areas[k] == Approx(expected).epsilon(0.05));
      CHECK(one.areas[k] > 1);
    }
  }
}

TEST_CASE("equal balls of two groups count for the lower index, at any scale") {
  for (const double unit : {1.0, 1e-100, 1e100}) {
    const Points3 centers = {{0, 0, 0}, {0, 0, 0}};
    const BallInterfaces found = rbpa::ball_interfaces({centers, std::vector<double>{unit, unit}}, Groups{1, 0});
    REQUIRE(found.all.size() == 1);
    CHECK(found.all[0].areas[0] == Approx(4 * pi * unit * unit));
    CHECK(found.all[0].areas[1] == 0);
  }
}

TEST_CASE("across the sides of a cell that repeats, groups meet with the areas of the formulas") {
  const Points3 centers = {{0.25, 5, 5}, {9.75, 5, 5}};  // half a unit apart
  const RepeatingCell cell = {{{{10, 0, 0}, {0, 10, 0}, {0, 0, 10}}}};
  const std::vector<double> radii = {1, 1};
  CHECK(rbpa::ball_interfaces({centers, radii}, Groups{0, 1}).all.empty());
  const BallInterfaces found = rbpa::ball_interfaces({centers, radii, cell}, Groups{0, 1});
  REQUIRE(found.all.size() == 1);
  for (const double area : found.all[0].areas) CHECK(area == Approx(2 * pi * 0.75));
  CHECK(found.all[0].contact_area == Approx(pi * (1 - 0.0625)));
  CHECK(found.areas_alone[0] == Approx(4 * pi));
  // A contact with an image of its own group is no interface, and takes area from the group alone.
  const RepeatingCell narrow = {{{{9.5, 0, 0}, {0, 1.5, 0}, {0, 0, 10}}}, {false, true, true}};
  const BallInterfaces rows = rbpa::ball_interfaces({centers, radii, narrow}, Groups{0, 1});
  CHECK(rows.all.empty());
  CHECK(rows.areas_alone[0] == Approx(4 * pi - 2 * 2 * pi * 0.25));
  // A ball in an image of a ball of the other group is covered whole.
  const BallInterfaces hidden = rbpa::ball_interfaces({centers, std::vector<double>{0.25, 1}, cell}, Groups{0, 1});
  REQUIRE(hidden.all.size() == 1);
  CHECK(hidden.all[0].areas[0] == Approx(pi / 4));
  CHECK(hidden.all[0].contact_area == 0);
}

TEST_CASE("in a cell, areas are those of points at random on the balls among all images") {
  Random random(5201);
  const auto [balls, groups] = grouped_balls(leaning, 40, 1.2, random);
  const BallInterfaces found = rbpa::ball_interfaces({balls.centers, balls.radii, leaning}, groups);
  Balls all = balls;
  Groups all_groups = groups;
  add_images(all, all_groups, leaning, -1, 1);
  REQUIRE(found.all.size() == 3);
  for (const BallInterface& one : found.all)
    for (std::size_t k = 0; k < 2; ++k) {
      const double expected = sampled(all, all_groups, groups.size(), one.groups[k], one.groups[1 - k], 3000, random);
      CHECK(one.areas[k] == Approx(expected).epsilon(0.03));
      CHECK(one.areas[k] > 2);
    }
}

TEST_CASE("a cell of eight cells has eight times the interfaces, and a wide one those without a cell") {
  Random random(5202);
  for (int round = 0; round < 20; ++round) {
    const auto [balls, groups] = grouped_balls(leaning, 40, round % 2 ? 0.9 : 2.5, random);
    const BallInterfaces one = rbpa::ball_interfaces({balls.centers, balls.radii, leaning}, groups, {.probe = 0.1});
    RepeatingCell large = leaning, wide = leaning;
    for (Point3& edge : large.edges) edge = {2 * edge.x, 2 * edge.y, 2 * edge.z};
    for (Point3& edge : wide.edges) edge = {8 * edge.x, 8 * edge.y, 8 * edge.z};
    Balls all = balls;
    Groups all_groups = groups;
    add_images(all, all_groups, leaning, 0, 1);
    const BallInterfaces eight = rbpa::ball_interfaces({all.centers, all.radii, large}, all_groups, {.probe = 0.1});
    const BallInterfaces far = rbpa::ball_interfaces({balls.centers, balls.radii, wide}, groups, {.probe = 0.1});
    const BallInterfaces bare = rbpa::ball_interfaces({balls.centers, balls.radii}, groups, {.probe = 0.1});
    REQUIRE(eight.all.size() == one.all.size());
    REQUIRE(far.all.size() == bare.all.size());
    for (std::size_t i = 0; i < one.all.size(); ++i) {
      CHECK(eight.all[i].groups == one.all[i].groups);
      CHECK(std::abs(eight.all[i].contact_area - 8 * one.all[i].contact_area) <= 1e-9);
      for (std::size_t k = 0; k < 2; ++k) CHECK(std::abs(eight.all[i].areas[k] - 8 * one.all[i].areas[k]) <= 1e-9);
    }
    for (std::size_t i = 0; i < bare.all.size(); ++i) {
      CHECK(far.all[i].groups == bare.all[i].groups);
      CHECK(std::abs(far.all[i].contact_area - bare.all[i].contact_area) <= 1e-10);
      for (std::size_t k = 0; k < 2; ++k) CHECK(std::abs(far.all[i].areas[k] - bare.all[i].areas[k]) <= 1e-10);
    }
  }
}

TEST_CASE("groups of another number than balls are refused, and no balls have no interfaces") {
  CHECK_THROWS_WITH_AS(rbpa::ball_interfaces({Points3{{0, 0, 0}}, std::vector<double>{1}}, Groups{}),
                       "0 groups, expected one for each of 1 centers", rbpa::InvalidInput);
  CHECK(rbpa::ball_interfaces({}, {}).all.empty());
}

TEST_SUITE_END();
