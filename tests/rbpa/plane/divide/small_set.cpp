#include "rbpa/plane/divide/small_set.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;

TEST_SUITE_BEGIN("divide");

namespace {

/// Returns points of a grid of the given width, some repeated, scaled by a power of two.
Points on_grid(std::size_t count, int width, int exponent, Random& random) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({std::ldexp(random.integer(0, width), exponent), std::ldexp(random.integer(0, width), exponent)});
  return points;
}

}  // namespace

// rbpa() finds the triangles by tiles, whatever the size.
TEST_CASE("small sets full of ties and duplicates have the triangles of tiles") {
  Random random(77);
  std::size_t triangles = 0, repeated = 0, isolated = 0;
  for (int trial = 0; trial < trials(3000); ++trial) {
    const int width = random.integer(1, 12), exponent = random.integer(-60, 60);
    const Points points = on_grid(static_cast<std::size_t>(random.integer(0, 60)), width, exponent, random);
    const double alpha = random.chance(0.3) ? infinity : std::ldexp(0.4 + 2 * random.unit(), exponent);
    CAPTURE(trial);
    AlphaComplex found;
    REQUIRE(rbpa::triangulate_small_set(points, alpha, {.neighbors = true}, found));
    const rbpa::SolidAlphaComplex tiles = rbpa::rbpa(points, alpha);
    CHECK(found.triangles == rbpa::triangles(tiles));
    CHECK(found.isolated == tiles.isolated);
    CHECK(found.duplicates == tiles.duplicates);
    CHECK(found.distinct == tiles.distinct);
    triangles += found.triangles.size();
    repeated += found.duplicates.size();
    isolated += found.isolated.size();
  }
  CHECK(triangles > trials(30000));
  CHECK(repeated > trials(10000));
  CHECK(isolated > 1000);
}

TEST_CASE("zeros of both signs are one point") {
  AlphaComplex found;
  REQUIRE(rbpa::triangulate_small_set(Points{{0.0, 1}, {-0.0, 1}, {1, -0.0}, {1, 0.0}, {3, 3}}, infinity, {}, found));
  CHECK(found.duplicates == std::vector<rbpa::Duplicate>{{1, 0}, {3, 2}});
  CHECK(found.triangles == std::vector<rbpa::Triangle>{{0, 2, 4}});
}

TEST_CASE("coordinates that do not fit double are left to other methods") {
  AlphaComplex found;
  CHECK_FALSE(rbpa::triangulate_small_set(Points{{0, 0}, {1e200, 0}, {0, 1e-200}}, infinity, {}, found));
  CHECK(found.distinct == 0);
}

TEST_CASE("the result does not change at the limit of small sets") {
  for (const std::size_t count : {rbpa::small_set_limit - 1, rbpa::small_set_limit}) {
    const Points points = uniform(count, 5);
    CHECK(rbpa::alpha_complex(points, 0.9).triangles == rbpa::triangles(rbpa::rbpa(points, 0.9)));
  }
}

TEST_CASE("progress is called, and can cancel") {
  AlphaComplex found;
  const Points points = uniform(50, 3);
  rbpa::Progress last{};
  REQUIRE(rbpa::triangulate_small_set(points, infinity,
                                      {.progress =
                                           [&](const rbpa::Progress& progress) {
                                             last = progress;
                                             return true;
                                           }},
                                      found));
  CHECK(last.triangles == found.triangles.size());
  CHECK(last.points == 50);
  AlphaComplex other;
  CHECK_THROWS_AS(
      rbpa::triangulate_small_set(points, infinity, {.progress = [](const rbpa::Progress&) { return false; }}, other),
      rbpa::Cancelled);
}

TEST_SUITE_END();
