#include "rbpa/space/balls/pore_sizes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/balls/periodic_voids.h"
#include "support/ball_sets.h"
#include "support/data_folder.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::pore_sizes;
using rbpa::PoreSizes;
using rbpa::RepeatingCell;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;

constexpr RepeatingCell unit_cube = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

PoreSizes sizes_of(const Balls& balls, const RepeatingCell& cell) {
  return pore_sizes(balls.centers, balls.radii, cell);
}

/// Returns the greatest number of directions in which a void of the grown balls percolates.
unsigned dimension(const Balls& balls, const RepeatingCell& cell, double growth) {
  std::vector<double> grown = balls.radii;
  for (double& radius : grown) radius += growth;
  unsigned most = 0;
  for (const rbpa::BallVoid& of : rbpa::periodic_ball_voids(balls.centers, grown, cell).voids)
    most = std::max(most, of.dimension);
  return most;
}

}  // namespace

TEST_CASE("pores between equal balls in a lattice have the sizes of the formulas") {
  const double r = 0.2;
  struct Row {
    RepeatingCell cell;
    double included;
    std::array<double, 3> along;
  };
  const double square = std::sqrt(0.5), rectangle = std::sqrt(1.49) / 2, triangle = std::sqrt(1.0 / 6);
  for (const Row& row :
       {Row{unit_cube, std::sqrt(0.75), {square, square, square}},
        Row{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.7}}}}, std::sqrt(0.6225), {rectangle, rectangle, square}},
        Row{{{{{1, 0, 0}, {3, 1, 0}, {0, -2, 0.7}}}}, std::sqrt(0.6225), {square, square, square}},
        Row{{{{{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}}}, 0.5, {triangle, triangle, triangle}}}) {
    const PoreSizes found = sizes_of({{{0.3, -4, 0.1}}, {r}}, row.cell);
    CHECK(found.included == Approx(row.included - r).epsilon(1e-12));
    CHECK(found.on_the_way == Approx(row.included - r).epsilon(1e-12));
    for (std::size_t k = 0; k < 3; ++k) CHECK(found.along[k] == Approx(row.along[k] - r).epsilon(1e-12));
    CHECK(found.passing == *std::max_element(found.along.begin(), found.along.end()));
  }
}

TEST_CASE("a ball that is a little smaller than the passing one passes, and a larger one does not") {
  Random random(11);
  for (int i = 0; i < 8; ++i) {
    CAPTURE(i);
    Balls balls;
    for (std::size_t count = 2 + random.below(30); balls.radii.size() < count;) {
      const double x = random.unit(), y = random.unit(), z = random.unit();
      balls.centers.push_back({x, y, z});
      balls.radii.push_back(random.between(0, 0.5) / std::cbrt(static_cast<double>(count)));
    }
    const PoreSizes found = sizes_of(balls, unit_cube);
    CHECK(dimension(balls, unit_cube, found.passing * (1 - 1e-9)) >= 1);
    CHECK(dimension(balls, unit_cube, found.passing * (1 + 1e-9)) == 0);
    CHECK(found.included >= found.on_the_way);
    CHECK(found.on_the_way >= found.passing);
    Balls grown = balls;
    for (double& radius : grown.radii) radius += 0.01;
    const PoreSizes of_grown = sizes_of(grown, unit_cube);
    CHECK(of_grown.included == Approx(found.included - 0.01).epsilon(1e-10));
    for (std::size_t k = 0; k < 3; ++k) CHECK(of_grown.along[k] == Approx(found.along[k] - 0.01).epsilon(1e-10));
  }
}

TEST_CASE("closed pores let no ball pass, and a larger one apart from the way is not on the way") {
  const PoreSizes closed = sizes_of({{{0, 0, 0}}, {0.75}}, unit_cube);
  CHECK(closed.included == Approx(std::sqrt(0.75) - 0.75).epsilon(1e-12));
  CHECK(closed.passing == 0);
  CHECK(closed.on_the_way == 0);
  CHECK(sizes_of({{{0, 0, 0}}, {0.9}}, unit_cube).included == 0);
  CHECK_THROWS_AS(pore_sizes({}, {}, unit_cube), rbpa::InvalidInput);

  // Two chambers of different widths, along z, behind walls of balls; the narrower one is open.
  Balls walls;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 10; ++y)
      for (int z = 0; z < 10; ++z) {
        if (x != 0 && x != 12 && y != 0 && !(x < 12 && z == 0)) continue;
        walls.centers.push_back({x / 10.0, y / 10.0, z / 10.0});
        walls.radii.push_back(0.08);
      }
  const PoreSizes found = sizes_of(walls, {{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  CHECK(found.included > 0.4);
  CHECK(found.on_the_way < 0.35);
  CHECK(found.along[0] == 0);
  CHECK(found.along[1] == 0);
  CHECK(found.along[2] > 0.25);
}

TEST_CASE("the oxygen of zeolite LTA leaves its cage and its windows of eight") {
  Balls oxygen;
  std::ifstream file(bundled_data() / "findings/mol_03_zeolite_window/lta_O_2x2x2.xyz");
  for (Point3 p; file >> p.x >> p.y >> p.z;) {
    oxygen.centers.push_back(p);
    oxygen.radii.push_back(1.35);
  }
  REQUIRE(oxygen.centers.size() == 384);
  const double side = 23.838;
  const PoreSizes found = sizes_of(oxygen, {{{{side, 0, 0}, {0, side, 0}, {0, 0, side}}}});
  // The International Zeolite Association states 11.05 and 4.21 Å as diameters.
  CHECK(2 * found.included == Approx(11.05).epsilon(0.02));
  CHECK(2 * found.passing == Approx(4.21).epsilon(0.02));
  for (const double radius : found.along) CHECK(radius == Approx(found.passing).epsilon(1e-9));
}

TEST_SUITE_END();
