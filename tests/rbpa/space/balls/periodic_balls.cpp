#include "rbpa/space/balls/periodic_balls.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "rbpa/base/error.h"
#include "support/random.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::measure_periodic_balls;
using rbpa::PeriodicBallMeasures;
using rbpa::Point3;
using rbpa::RepeatingCell;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;
using Radii = std::vector<double>;

constexpr RepeatingCell unit_cube = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
constexpr RepeatingCell leaning = {{{{1.2, 0, 0}, {0.4, 1, 0}, {-0.3, 0.2, 0.9}}}};

Point3 at(const RepeatingCell& cell, double x, double y, double z) {
  const auto& [a, b, c] = cell.edges;
  return {x * a.x + y * b.x + z * c.x, x * a.y + y * b.y + z * c.y, x * a.z + y * b.z + z * c.z};
}

struct Balls {
  Points3 centers;
  Radii radii;
};

Balls random_balls(const RepeatingCell& cell, std::size_t count, double greatest, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    balls.centers.push_back(at(cell, x, y, z));
    balls.radii.push_back(random.between(0, greatest));
  }
  return balls;
}

}  // namespace

TEST_CASE("one ball in a cube that repeats has the sizes of the formulas") {
  for (const double r : {0.3, 0.5, 0.6, 0.7}) {
    CAPTURE(r);
    const double h = std::max(r - 0.5, 0.0);
    const PeriodicBallMeasures found = measure_periodic_balls(Points3{{0.2, 7.3, -0.1}}, Radii{r - 0.25}, unit_cube,
                                                              {.probe = 0.25, .contacts = true});
    CHECK(found.volume == Approx(4 * pi / 3 * r * r * r - 6 * pi * h * h * (3 * r - h) / 3).epsilon(1e-13));
    CHECK(found.area == Approx(4 * pi * r * r - 12 * pi * r * h).epsilon(1e-13));
    if (r < 0.5) CHECK(found.contacts.empty());
    if (r <= 0.5) continue;
    REQUIRE(found.contacts.size() == 3);
    CHECK(found.contact_offsets == std::vector<std::array<std::int32_t, 3>>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
    for (const rbpa::BallContact& contact : found.contacts) {
      CHECK(contact.balls == std::array<std::uint32_t, 2>{0, 0});
      CHECK(contact.area == Approx(pi * (r * r - 0.25)).epsilon(1e-13));
      CHECK(contact.distance == Approx(1).epsilon(1e-15));
    }
  }
  for (const double r : {0.9, 3.0}) {  // the balls cover the space
    const PeriodicBallMeasures found = measure_periodic_balls(Points3{{0, 0, 0}}, Radii{r}, unit_cube);
    CHECK(found.volume == Approx(1).epsilon(1e-13));
    CHECK(found.area == 0);
  }
}

TEST_CASE("a cell of eight cells has eight times the sizes, and each ball its own again") {
  for (const RepeatingCell& cell : {unit_cube, leaning}) {
    const Balls balls = random_balls(cell, 30, 0.3, 1);
    const PeriodicBallMeasures one = measure_periodic_balls(balls.centers, balls.radii, cell, {.contacts = true});
    RepeatingCell large = cell;
    for (Point3& edge : large.edges) edge = {2 * edge.x, 2 * edge.y, 2 * edge.z};
    Balls all;
    for (int k = 0; k < 8; ++k) {
      const Point3 move = at(cell, k & 1, k >> 1 & 1, k >> 2);
      for (std::size_t i = 0; i < balls.radii.size(); ++i) {
        const Point3& p = balls.centers[i];
        all.centers.push_back({p.x + move.x, p.y + move.y, p.z + move.z});
        all.radii.push_back(balls.radii[i]);
      }
    }
    const PeriodicBallMeasures eight = measure_periodic_balls(all.centers, all.radii, large, {.contacts = true});
    CHECK(eight.volume == Approx(8 * one.volume).epsilon(1e-12));
    CHECK(eight.area == Approx(8 * one.area).epsilon(1e-12));
    CHECK(eight.contacts.size() == 8 * one.contacts.size());
    for (std::size_t i = 0; i < all.radii.size(); ++i) {
      CHECK(eight.volumes[i] == Approx(one.volumes[i % 30]).epsilon(1e-9));
      CHECK(std::abs(eight.areas[i] - one.areas[i % 30]) <= 1e-12);
    }
  }
}

TEST_CASE("measures are those of the balls in the middle of many images") {
  const Balls balls = random_balls(leaning, 12, 0.25, 2);
  const PeriodicBallMeasures found = measure_periodic_balls(balls.centers, balls.radii, leaning, {.derivatives = true});
  Balls all = balls;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (x != 0 || y != 0 || z != 0)
          for (std::size_t i = 0; i < balls.radii.size(); ++i) {
            const Point3 move = at(leaning, x, y, z), &p = balls.centers[i];
            all.centers.push_back({p.x + move.x, p.y + move.y, p.z + move.z});
            all.radii.push_back(balls.radii[i]);
          }
  const rbpa::BallMeasures expected = rbpa::measure_balls(all.centers, all.radii, {.derivatives = true});
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    CHECK(found.volumes[i] == Approx(expected.volumes[i]).epsilon(1e-12));
    CHECK(found.areas[i] == Approx(expected.areas[i]).epsilon(1e-11));
    CHECK(std::abs(found.volume_gradient[i].x - expected.volume_gradient[i].x) <= 1e-12);
    CHECK(std::abs(found.area_gradient[i].z - expected.area_gradient[i].z) <= 1e-10);
  }
}

TEST_CASE("neither other edges of the same lattice nor moves by edges change a measure") {
  const Balls balls = random_balls(leaning, 40, 0.3, 3);
  const PeriodicBallMeasures found = measure_periodic_balls(balls.centers, balls.radii, leaning, {.contacts = true});
  RepeatingCell other = leaning;
  other.edges[1] = at(leaning, 1, 1, 0);
  other.edges[2] = at(leaning, -2, 1, 1);
  Points3 moved;
  for (std::size_t i = 0; i < balls.centers.size(); ++i) {
    const Point3 move = at(leaning, static_cast<double>(i % 7) - 3, static_cast<double>(i % 5) - 9, 4);
    moved.push_back({balls.centers[i].x + move.x, balls.centers[i].y + move.y, balls.centers[i].z + move.z});
  }
  for (const PeriodicBallMeasures& same :
       {measure_periodic_balls(balls.centers, balls.radii, other, {.contacts = true}),
        measure_periodic_balls(moved, balls.radii, leaning, {.contacts = true})}) {
    CHECK(same.volume == Approx(found.volume).epsilon(1e-12));
    CHECK(same.area == Approx(found.area).epsilon(1e-12));
    CHECK(same.contacts.size() == found.contacts.size());
  }
  // The second ball of a contact, moved by its offset, is as far away as the contact says.
  const PeriodicBallMeasures same = measure_periodic_balls(moved, balls.radii, leaning, {.contacts = true});
  for (std::size_t k = 0; k < same.contacts.size(); ++k) {
    const auto& [i, j] = same.contacts[k].balls;
    const auto& [x, y, z] = same.contact_offsets[k];
    const Point3 move = at(leaning, x, y, z);
    const double distance = std::hypot(moved[j].x + move.x - moved[i].x, moved[j].y + move.y - moved[i].y,
                                       moved[j].z + move.z - moved[i].z);
    CHECK(distance == Approx(same.contacts[k].distance).epsilon(1e-12));
  }
}

TEST_CASE("a cell that repeats along some edges only is a chain or a sheet") {
  RepeatingCell chain = unit_cube;
  chain.repeats = {false, true, false};
  const PeriodicBallMeasures found = measure_periodic_balls(Points3{{5, 5, 5}}, Radii{0.6}, chain);
  CHECK(found.area == Approx(4 * pi * 0.36 - 4 * pi * 0.6 * 0.1).epsilon(1e-13));
}

TEST_CASE("balls that are equal modulo the cell, up to rounding, count once") {
  for (int i = 0; i < 600; ++i) {
    const double side = 3 + i / 100.0;
    CAPTURE(side);
    const RepeatingCell cell = {{{{side, 0, 0}, {0, side, 0}, {0, 0, side}}}};
    const PeriodicBallMeasures found = measure_periodic_balls(
        Points3{{0, 0, 0}, {side, 0, 0}, {0, -side, 3 * side}, {-1e-17, 0, 0}}, Radii{1, 1, 1, 1}, cell);
    CHECK(found.volume == Approx(4 * pi / 3).epsilon(1e-10));
    CHECK(found.area == Approx(4 * pi).epsilon(1e-10));
  }
}

TEST_CASE("cells without a volume and balls that are too large for them are refused") {
  const Points3 one = {{0, 0, 0}};
  const auto refused = [&](const RepeatingCell& cell, double radius, const char* message) {
    CHECK_THROWS_WITH_AS(measure_periodic_balls(one, Radii{radius}, cell), doctest::Contains(message),
                         rbpa::InvalidInput);
  };
  refused({}, 1, "without a volume");
  refused({{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}, 1, "without a volume");
  refused({{{{.1, .2, .3}, {.4, .5, .6}, {.7, .8, .9}}}}, 1, "without a volume");
  refused({{{{1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}, {0, 0, 1}}}}, 1, "not finite");
  refused(unit_cube, 60, "at most 50 times");
  refused(unit_cube, -1, "radius 0");
  CHECK_THROWS_WITH_AS(measure_periodic_balls(Points3{{1e20, 0, 0}}, Radii{1}, unit_cube),
                       doctest::Contains("too many cells away"), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_periodic_balls(one, Radii{}, unit_cube), rbpa::InvalidInput);
  CHECK(measure_periodic_balls({}, {}, unit_cube).volume == 0);
}

TEST_SUITE_END();
