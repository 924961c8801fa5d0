#include "rbpa/plane/hierarchy/ladder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/arguments.h"
#include "support/random.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Ladder;
using rbpa::Radius;

TEST_SUITE_BEGIN("hierarchy");

namespace {

const double most = std::numeric_limits<double>::max();

using Real = Ladder::Real;

void check_ladder(double least, Radius last, Real largest) {
  CAPTURE(least);
  const Ladder ladder(least, last, largest);
  const Real end = last.is_infinite() ? largest : Real(last.value());
  // The last level is the first whose power of two reaches the end.
  CHECK(ladder.is_last(ladder.end()));
  CHECK_FALSE(ladder.is_last(ladder.end() - 1));
  CHECK(ladder.radius(ladder.end()).is_infinite() == last.is_infinite());
  if (!last.is_infinite()) CHECK(ladder.radius(ladder.end()).value() == last.value());
  for (int level = 0; level < ladder.end(); ++level) {
    const double radius = ladder.radius(level).value();
    REQUIRE(std::isfinite(radius));
    REQUIRE(radius == std::ldexp(least, level));
    REQUIRE(Real(radius) < end);
  }
}

void check_first_reaching(const Ladder& ladder, Real radius, double least) {
  CAPTURE(radius);
  const int first = ladder.first_reaching(radius);
  REQUIRE(first >= 0);
  // Powers before it are too small; the radius may be rounded by a millionth.
  if (first > 0) REQUIRE(std::ldexp(Real(least), first - 1) < radius * (1 - Real(1e-6)));
  // It is the first necessary one, within a hundred-thousandth of the power of two.
  if (first < ladder.end()) REQUIRE(std::ldexp(Real(least), first) >= radius * (1 - Real(2e-5)));
}

}  // namespace

TEST_CASE("the radii double until the last, which is the given one") {
  Random random(51);
  for (int trial = 0; trial < trials(200); ++trial) {
    const double least = std::ldexp(1 + random.unit(), random.integer(-150, 100));
    const double last = std::ldexp(1 + random.unit(), random.integer(-150, 150));
    if (least >= last) continue;
    check_ladder(least, Radius(last), 1);
    check_ladder(least, Radius(), last);
  }
  check_ladder(1, Radius(1024), 1);
  check_ladder(1, Radius(std::nextafter(1024, 0)), 1);
  check_ladder(1, Radius(std::nextafter(1024, 2000)), 1);
  check_ladder(5e-324, Radius(most), 1);
  check_ladder(5e-324, Radius(), std::ldexp(1.0L, 1030));
  check_ladder(1e300, Radius(), std::ldexp(1.0L, 1030));
}

TEST_CASE("a least radius that is not below the last gives one level") {
  for (const double last : {1.0, 0.5, 5e-324}) {
    const Ladder ladder(1, Radius(last), 1);
    CHECK(ladder.end() == 0);
    CHECK(ladder.radius(0).value() == last);
  }
  CHECK(Ladder(1, Radius(), 0.5).radius(0).is_infinite());
  CHECK(Ladder(most, Radius(), std::ldexp(1.0L, 1030)).end() == 0);
}

TEST_CASE("the first level that reaches a radius is found") {
  Random random(52);
  for (int trial = 0; trial < trials(20000); ++trial) {
    const double least = std::ldexp(1 + random.unit(), random.integer(-100, 10));
    const Radius last = random.chance(0.5) ? Radius() : Radius(std::ldexp(least, random.integer(1, 200)));
    const double some = random.chance(0.3) ? std::ldexp(least, random.integer(-3, 150))
                                           : std::ldexp(1 + random.unit(), random.integer(-110, 150));
    CAPTURE(least);
    check_first_reaching(Ladder(least, last, 1e9), some, least);
    check_first_reaching(Ladder(least, last, 1e9), jiggled(some, 5, random), least);
  }
  const Ladder longest(5e-324, Radius(most), 1);
  for (const double radius : {5e-324, 1e-310, 1e-300, 1.0, 1e300, most})
    check_first_reaching(longest, static_cast<long double>(radius), 5e-324);
  CHECK(longest.first_reaching(0) == 0);
}

TEST_CASE("no finite ladder reaches infinity, and an infinite one reaches every other radius by its last level") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(Ladder(1, Radius(8), 1).first_reaching(infinity) == Ladder::never);
  CHECK(Ladder(1, Radius(), 8).first_reaching(infinity) == Ladder::never);
  for (const double radius : {7.0, 8.0, 9.0, 1e10, 1e300}) CHECK(Ladder(1, Radius(), 8).first_reaching(radius) == 3);
  CHECK(Ladder(1, Radius(8), 1).first_reaching(1e10) > 3);
}

TEST_SUITE_END();
