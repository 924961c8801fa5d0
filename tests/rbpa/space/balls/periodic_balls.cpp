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

TEST_CASE("voids in a cell that repeats are those of one cell, wherever it is cut") {
  // Balls on the corners, edges and faces of a cube leave a void in its middle; between four balls there is none.
  Points3 shell;
  Radii radii;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) {
          shell.push_back({0.25 * x, 0.25 * y, 0.25 * z});
          radii.push_back(0.19);
        }
  std::vector<rbpa::BallVoid> expected =
      rbpa::ball_voids(shell, radii, rbpa::regular_triangulation(shell, radii)).voids;
  REQUIRE(expected.size() == 1);
  for (const Point3& move : {Point3{0.5, 0.5, 0.5}, Point3{0, 0, 0}, Point3{7.9, -3.4, 0.5}}) {
    Points3 moved;
    for (const Point3& p : shell) moved.push_back({p.x + move.x, p.y + move.y, p.z + move.z});
    RepeatingCell cell = unit_cube;
    cell.edges[1] = {0.125, 1, 0};
    const rbpa::PeriodicBallVoids found = rbpa::periodic_ball_voids(moved, radii, cell);
    REQUIRE(found.voids.size() == 1);
    CHECK(found.volume == Approx(expected[0].volume).epsilon(1e-10));
    CHECK(found.area == Approx(expected[0].area).epsilon(1e-10));
    CHECK(found.voids[0].radius == Approx(expected[0].radius).epsilon(1e-12));
    CHECK(found.voids[0].balls.size() == expected[0].balls.size());
    for (const rbpa::LiningBall& lining : found.voids[0].balls) CHECK(found.of[lining.ball] < shell.size());
  }
  // A simple cubic lattice whose balls touch has channels along all edges, and voids once these are closed.
  CHECK(rbpa::periodic_ball_voids(Points3{{0, 0, 0}}, Radii{0.6}, unit_cube).voids.empty());
  const rbpa::PeriodicBallVoids closed = rbpa::periodic_ball_voids(Points3{{0, 0, 0}}, Radii{0.75}, unit_cube);
  REQUIRE(closed.voids.size() == 1);
  CHECK(closed.voids[0].radius == Approx(std::sqrt(0.75) - 0.75).epsilon(1e-12));
  CHECK(closed.volume + measure_periodic_balls(Points3{{0, 0, 0}}, Radii{0.75}, unit_cube).volume ==
        Approx(1).epsilon(1e-12));
}

TEST_CASE("cells without a volume and balls that are too large for them are refused") {
  const Points3 one = {{0, 0, 0}};
  const auto refused = [&](const RepeatingCell& cell, double radius, const char* message) {
    CHECK_THROWS_WITH_AS(measure_periodic_balls(one, Radii{radius}, cell), doctest::Contains(message),
                         rbpa::InvalidInput);
  };
  refused({}, 1, "without a volume");
  refused({{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}, 1, "without a volume");
  refused({{{{1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}, {0, 0, 1}}}}, 1, "infinite edges");
  refused(unit_cube, 60, "at most 50 times");
  refused(unit_cube, -1, "radius 0");
  CHECK_THROWS_WITH_AS(measure_periodic_balls(Points3{{1e20, 0, 0}}, Radii{1}, unit_cube),
                       doctest::Contains("too many cells away"), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_periodic_balls(one, Radii{}, unit_cube), rbpa::InvalidInput);
  CHECK(measure_periodic_balls({}, {}, unit_cube).volume == 0);
}

TEST_SUITE_END();
