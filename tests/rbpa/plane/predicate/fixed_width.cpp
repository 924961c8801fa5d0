#include "rbpa/plane/predicate/fixed_width.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <utility>

#include "rbpa/plane/predicate/exact_integer.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::FixedVectors;
using rbpa::Point;
using P = rbpa::Predicates<double>;

TEST_SUITE_BEGIN("predicates");

TEST_CASE("differences are exact integers times one power of two, or there are none") {
  const Point a = {500000.25, 0x1p-3}, b = {500001, 0.25}, c = {499999.5, 4};
  const FixedVectors<2> fixed(29, a, {&b, &c});
  REQUIRE(fixed.are_exact());
  const double unit = static_cast<double>(fixed[0].x) / 0.75;
  CHECK(static_cast<double>(fixed[0].y) == 0.125 * unit);
  CHECK(static_cast<double>(fixed[1].x) == -0.75 * unit);
  CHECK(static_cast<double>(fixed[1].y) == 3.875 * unit);
  CHECK(std::abs(static_cast<double>(fixed[1].y)) < 0x1p29);
  const Point fine = {500001, 0.1}, rounded = {1e-20, 3};
  CHECK_FALSE(FixedVectors<2>(29, a, {&b, &fine}).are_exact());
  CHECK_FALSE(FixedVectors<2>(29, a, {&rounded, &c}).are_exact());
  CHECK(FixedVectors<2>(29, a, {&a, &a}).are_exact());
}

TEST_CASE("the greatest integers that fit do not overflow") {
  // Differences of 2^29 − 1 units in every direction; one more unit does not fit.
  const double most = 0x1p29 - 1;
  int fitted = 0, ties = 0;
  Random random(5);
  for (int trial = 0; trial < trials(20000); ++trial) {
    const double scale = std::ldexp(1.0, random.integer(-100, 100));
    std::array<Point, 4> s;
    for (Point& p : s)
      p = {scale * random.integer(-1, 1) * (most / 2 + 0.5), scale * random.integer(-1, 1) * (most / 2 + 0.5)};
    s[0] = {};
    if (random.chance(0.5)) s[3].x += scale * random.integer(-1, 1);
    if (rbpa::exact_integer::orientation(s[0], s[1], s[2]) <= 0) continue;
    const FixedVectors<3> fixed(29, s[0], {&s[1], &s[2], &s[3]});
    fitted += fixed.are_exact();
    const int expected = rbpa::exact_integer::in_circle(s[0], s[1], s[2], s[3]);
    ties += expected == 0;
    CHECK(P::in_circle(s[0], s[1], s[2], s[3]) == expected);
    CHECK(P::orientation(s[1], s[2], s[3]) == rbpa::exact_integer::orientation(s[1], s[2], s[3]));
  }
  CHECK(fitted > 1000);
  CHECK(ties > trials(1000));
}

TEST_CASE("circles through four points of a grid, and nearly so, are decided as by integers of any length") {
  Random random(6);
  int ties = 0;
  for (int trial = 0; trial < trials(30000); ++trial) {
    const int exponent = random.integer(-100, 60), width = 1 << random.integer(1, 29);
    const Point offset = {std::ldexp(random.integer(0, 9), exponent), 0};
    std::array<Point, 4> s;
    for (Point& p : s)
      p = {offset.x + std::ldexp(random.integer(0, width), exponent), std::ldexp(random.integer(0, width), exponent)};
    // The corners of a rectangle are on a circle.
    if (random.chance(0.6)) s = {s[0], {s[1].x, s[0].y}, s[1], {s[0].x, s[1].y}};
    if (rbpa::exact_integer::orientation(s[0], s[1], s[2]) < 0) std::swap(s[0], s[2]);
    if (rbpa::exact_integer::orientation(s[0], s[1], s[2]) <= 0) continue;
    const int expected = rbpa::exact_integer::in_circle(s[0], s[1], s[2], s[3]);
    ties += expected == 0;
    CHECK(P::in_circle(s[0], s[1], s[2], s[3]) == expected);
  }
  CHECK(ties > trials(10000));
}

TEST_SUITE_END();
