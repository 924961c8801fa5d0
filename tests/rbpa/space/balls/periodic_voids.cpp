#include "rbpa/space/balls/periodic_voids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/balls/periodic_topology.h"
#include "rbpa/space/solid/solid_radii.h"
#include "space/balls/hollow_balls.h"
#include "support/periodic_sets.h"

using namespace rbpa_test;
using rbpa::periodic_ball_voids;
using rbpa::RepeatingCell;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;

constexpr RepeatingCell unit_cube = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
constexpr RepeatingCell leaning = {{{{1.2, 0, 0}, {0.4, 1, 0}, {-0.3, 0.2, 0.9}}}};
constexpr RepeatingCell body_centered = {{{{-0.5, 0.5, 0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, -0.5}}}};
constexpr RepeatingCell face_centered = {{{{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}}};

Point3 at(const RepeatingCell& cell, double x, double y, double z) {
  return plus(plus(plus({}, x, cell.edges[0]), y, cell.edges[1]), z, cell.edges[2]);
}

Balls random_balls(const RepeatingCell& cell, std::size_t count, double least, double greatest, Random& random) {
  Balls balls;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    balls.centers.push_back(at(cell, x, y, z));
    balls.radii.push_back(random.between(least, greatest) * std::cbrt(cell.volume() / static_cast<double>(count)));
  }
  return balls;
}

BallVoids voids_of(const Balls& balls, const RepeatingCell& cell) {
  return periodic_ball_voids(balls.centers, balls.radii, cell);
}

/// Returns the balls of count × count × count cells.
Balls repeated(const Balls& balls, const RepeatingCell& cell, int count) {
  Balls all;
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y)
      for (int z = 0; z < count; ++z)
        for (std::size_t i = 0; i < balls.radii.size(); ++i) {
          all.centers.push_back(plus(balls.centers[i], 1, at(cell, x, y, z)));
          all.radii.push_back(balls.radii[i]);
        }
  return all;
}
RepeatingCell times(RepeatingCell cell, double factor) {
  for (Point3& edge : cell.edges) edge = plus({}, factor, edge);
  return cell;
}

/// Returns the least distance of x from a ball or an image. Requires: a cell that does not lean much.
double least_distance(const Balls& balls, const RepeatingCell& cell, const Point3& x) {
  const auto& [a, b, c] = cell.edges;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    Point3 d = minus(x, balls.centers[i]);
    const double volume = det(a, b, c);
    d = minus(d, at(cell, std::round(det(d, b, c) / volume), std::round(det(a, d, c) / volume),
                    std::round(det(a, b, d) / volume)));
    for (int k = 0; k < 125; ++k)
      least = std::min(least, distance(d, at(cell, k % 5 - 2, k / 5 % 5 - 2, k / 25 - 2)) - balls.radii[i]);
  }
  return least;
}

void check_equal(const BallVoid& a, const BallVoid& b) {
  CHECK(a.dimension == b.dimension);
  CHECK(a.volume_of_tetrahedra == Approx(b.volume_of_tetrahedra).epsilon(1e-11));
  CHECK(a.volume == Approx(b.volume).epsilon(1e-10));
  CHECK(a.area == Approx(b.area).epsilon(1e-10));
  CHECK(a.radius == Approx(b.radius).epsilon(1e-10));
  CHECK(a.power == Approx(b.power).epsilon(1e-10));
}

}  // namespace

TEST_CASE("voids of one ball in a lattice have the numbers, sizes and places of the formulas") {
  struct Row {
    RepeatingCell cell;
    double radius;
    unsigned dimension;
    std::vector<double> largest;  // distances of the deepest holes from centers
  };
  const double tetrahedral = std::sqrt(3) / 4, octahedral = 0.5, of_body = std::sqrt(5) / 4, of_cube = std::sqrt(3) / 2;
  for (const Row& row :
       {Row{body_centered, 0.54, 0, std::vector<double>(6, of_body)}, Row{body_centered, 0.5, 3, {of_body}},
        Row{face_centered, 0.42, 0, {octahedral, tetrahedral, tetrahedral}}, Row{face_centered, 0.4, 3, {octahedral}},
        Row{face_centered, 0.45, 0, {octahedral}}, Row{unit_cube, 0.4, 3, {of_cube}},
        Row{unit_cube, 0.75, 0, {of_cube}}, Row{unit_cube, 0.87, 0, {}}}) {
    CAPTURE(row.radius);
    for (const RepeatingCell& cell :
         {row.cell, RepeatingCell{{{row.cell.edges[0], plus(row.cell.edges[1], 7, row.cell.edges[0]),
                                    plus(row.cell.edges[2], -3, plus(row.cell.edges[1], 7, row.cell.edges[0]))}}}}) {
      const Balls one = {{{0.1, 7.3, -0.2}}, {row.radius}};
      const BallVoids found = voids_of(one, cell);
      const auto sizes = rbpa::measure_periodic_balls(one.centers, one.radii, row.cell);
      CHECK(found.volume == Approx(cell.volume() - sizes.volume).epsilon(1e-12));
      CHECK(found.area == Approx(sizes.area).epsilon(1e-12));
      REQUIRE(found.voids.size() == row.largest.size());
      for (std::size_t i = 0; i < found.voids.size(); ++i) {
        CHECK(found.voids[i].dimension == row.dimension);
        CHECK(found.voids[i].radius == Approx(row.largest[i] - row.radius).epsilon(1e-12));
        CHECK(found.voids[i].power == Approx(row.largest[i] * row.largest[i] - row.radius * row.radius).epsilon(1e-12));
        CHECK(least_distance(one, row.cell, found.voids[i].center) == Approx(found.voids[i].radius).epsilon(1e-12));
        REQUIRE(found.voids[i].balls.size() == 1);
        CHECK(found.voids[i].balls[0].area == Approx(found.voids[i].area).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("with equal radii, voids of a box are those of the full complex of the points") {
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const Point3 box = {random.between(0.8, 1.2), random.between(0.8, 1.2), random.between(0.8, 1.2)};
    const RepeatingCell cell = {{{{box.x, 0, 0}, {0, box.y, 0}, {0, 0, box.z}}}};
    const Balls balls = random_balls(cell, 60 + random.below(200), 1, 1, random);
    const auto delaunay =
        rbpa::periodic_solid(balls.centers, box, std::numeric_limits<double>::infinity(), {.neighbors = true});
    const double alpha = random.between(0.35, 0.8) * balls.radii[0];
    const auto expected = rbpa::periodic_topology(delaunay, rbpa::circumradii(delaunay.positions, delaunay.simplices),
                                                  alpha, rbpa::ComplexKind::full);
    const BallVoids found = voids_of({balls.centers, std::vector<double>(balls.radii.size(), alpha)}, cell);
    REQUIRE(found.voids.size() == expected.voids.size());
    for (std::size_t k = 0; k < found.voids.size(); ++k) {
      CHECK(found.voids[k].dimension == expected.voids[k].dimension);
      CHECK(found.voids[k].volume_of_tetrahedra == Approx(expected.voids[k].volume).epsilon(1e-11));
      CHECK(found.voids[k].volume == Approx(*expected.voids[k].outside_balls).epsilon(1e-10));
    }
  }
}

TEST_CASE("closed voids of a cell are voids of many cells without repetition, and percolating ones are not") {
  Random random(6);
  std::size_t closed = 0, open = 0;
  for (int i = 0; i < 16; ++i) {
    CAPTURE(i);
    const bool is_lattice = i % 2 == 0;
    const RepeatingCell cell = is_lattice ? times(face_centered, 2) : i % 4 == 1 ? unit_cube : leaning;
    Balls balls = is_lattice ? repeated({{{0, 0, 0}}, {0}}, face_centered, 2)
                             : random_balls(cell, 1 + random.below(9), 0.45, 0.8, random);
    if (is_lattice)
      for (std::size_t k = 0; k < balls.radii.size(); ++k) {
        const Point3 direction = on_sphere(random);
        balls.centers[k] = plus(balls.centers[k], random.between(0, 0.03), direction);
        balls.radii[k] = random.between(0.39, 0.44);
      }
    const BallVoids found = voids_of(balls, cell);
    constexpr int count = 7, middle = 3;
    const Balls many = repeated(balls, cell, count);
    const RegularTriangulation regular = rbpa::regular_triangulation(many.centers, many.radii);
    const std::vector<BallVoid> voids = ball_voids(many.centers, many.radii, regular).voids;
    for (const BallVoid& of : found.voids) {
      CHECK(least_distance(balls, cell, of.center) == Approx(of.radius).epsilon(1e-9));
      if (of.radius < 1e-6) continue;
      const Point3 center = plus(of.center, 1, at(cell, middle, middle, middle));
      const auto same =
          std::find_if(voids.begin(), voids.end(), [&](const BallVoid& v) { return is_in(center, many, v, regular); });
      (of.dimension == 0 ? closed : open) += 1;
      if (of.dimension > 0) {
        CHECK(same == voids.end());
        continue;
      }
      REQUIRE(same != voids.end());
      check_equal(of, *same);
    }
  }
  CHECK(closed >= 30);
  CHECK(open >= 10);
}

TEST_CASE("voids in a cell depend on the set of balls alone, and eight cells have eight times the closed ones") {
  Random random(7);
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const Balls balls = random_balls(leaning, 3 + random.below(20), 0.3, 0.8, random);
    const BallVoids found = voids_of(balls, leaning);
    const auto sizes = rbpa::measure_periodic_balls(balls.centers, balls.radii, leaning);
    CHECK(found.volume + sizes.volume == Approx(leaning.volume()).epsilon(1e-12));
    CHECK(found.area == Approx(sizes.area).epsilon(1e-11));
    std::vector<double> areas(balls.radii.size());
    for (const BallVoid& of : found.voids)
      for (const rbpa::LiningBall& ball : of.balls) areas[ball.ball] += ball.area;
    for (std::size_t k = 0; k < areas.size(); ++k) CHECK(areas[k] == Approx(sizes.areas[k]).epsilon(1e-9).scale(1));

    Balls moved;  // in another order, each ball in another cell
    for (std::size_t k = balls.radii.size(); k-- > 0;) {
      const auto far = [&] { return static_cast<double>(random.below(5)) - 2; };
      const double x = far(), y = far(), z = far();
      moved.centers.push_back(plus(balls.centers[k], 1, at(leaning, x, y, z)));
      moved.radii.push_back(balls.radii[k]);
    }
    const BallVoids again = voids_of(moved, leaning);
    REQUIRE(again.voids.size() == found.voids.size());
    for (std::size_t k = 0; k < found.voids.size(); ++k) check_equal(again.voids[k], found.voids[k]);

    std::size_t closed = 0, closed_of_eight = 0;
    const BallVoids eight = voids_of(repeated(balls, leaning, 2), times(leaning, 2));
    for (const BallVoid& of : found.voids) closed += of.dimension == 0 ? 1U : 0U;
    for (const BallVoid& of : eight.voids) closed_of_eight += of.dimension == 0 ? 1U : 0U;
    CHECK(closed_of_eight == 8 * closed);
    CHECK(eight.volume == Approx(8 * found.volume).epsilon(1e-11));
  }
}

TEST_CASE("a void percolates in as many directions as its walls leave open") {
  // Balls on a grid of 8 × 8 × 8 make walls across one, two or three axes, with the rest of the cell empty.
  for (unsigned walls = 0; walls <= 3; ++walls) {
    CAPTURE(walls);
    Balls balls;
    for (int x = 0; x < 8; ++x)
      for (int y = 0; y < 8; ++y)
        for (int z = 0; z < 8; ++z) {
          if (!(walls > 0 && x == 0) && !(walls > 1 && y == 0) && !(walls > 2 && z == 0) && x + y + z > 0) continue;
          balls.centers.push_back({x / 8.0, y / 8.0, z / 8.0});
          balls.radii.push_back((x + y + z) % 2 == 0 ? 0.1 : 0.09);
        }
    const BallVoids found = voids_of(balls, unit_cube);
    REQUIRE(found.voids.size() == 1);
    CHECK(found.voids[0].dimension == 3 - walls);
  }
}

TEST_CASE("equal balls, balls within others and touching balls have the voids that they leave") {
  const Balls nested = {{{0, 0, 0}, {1, 0, 0}, {0, 0, -3}, {0.05, 1, 0}}, {0.75, 0.75, 0.5, 0.1}};
  const BallVoids found = voids_of(nested, unit_cube);
  REQUIRE(found.voids.size() == 1);
  CHECK(found.voids[0].dimension == 0);
  REQUIRE(found.voids[0].balls.size() == 1);
  CHECK(found.voids[0].balls[0].ball == 0);
  CHECK(found.volume == Approx(voids_of({{{0, 0, 0}}, {0.75}}, unit_cube).volume).epsilon(1e-13));

  const BallVoids touching = voids_of({{{0.5, 0.5, 0.5}}, {0.5}}, unit_cube);
  REQUIRE(touching.voids.size() == 1);
  CHECK(touching.voids[0].dimension == 3);
  CHECK(touching.volume == Approx(1 - pi / 6).epsilon(1e-13));
  const BallVoids points = voids_of({{{0.5, 0.5, 0.5}}, {0}}, leaning);
  REQUIRE(points.voids.size() == 1);
  CHECK(points.volume == Approx(leaning.volume()).epsilon(1e-13));
  CHECK(periodic_ball_voids({}, {}, unit_cube).voids.empty());

  const Balls two = {{{0.4, 0.1, 0.9}, {0.2, 0.9, 0}}, {0.73, 0.71}};
  CHECK(voids_of(two, {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1.1}}}}).volume == Approx(0.0013301).epsilon(1e-4));
}

TEST_CASE("cells without voids to find are refused") {
  const Balls one = {{{0, 0, 0}}, {0.4}};
  CHECK_THROWS_AS(voids_of(one, {unit_cube.edges, {true, true, false}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(voids_of(one, {{{{1, 0, 0}, {2, 0, 0}, {0, 0, 1}}}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(voids_of(one, {{{{1, 0, 0}, {0, 3000, 0}, {0, 0, 1}}}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(voids_of(one, times(unit_cube, 1e290)), rbpa::InvalidInput);
  CHECK_THROWS_AS(voids_of({{{1e300, 0, 0}}, {0.4}}, unit_cube), rbpa::InvalidInput);
  CHECK_THROWS_AS(voids_of({{{0, 0, 0}}, {-1}}, unit_cube), rbpa::InvalidInput);
  CHECK_THROWS_AS(
      periodic_ball_voids(one.centers, one.radii, unit_cube, {.progress = [](const rbpa::Progress&) { return false; }}),
      rbpa::Cancelled);
}

TEST_SUITE_END();
