#include "rbpa/base/exact/double_double.h"

#include <doctest/doctest.h>

#include <cmath>

#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::DoubleDouble;

TEST_SUITE_BEGIN("predicates");

namespace {

Rational value(const DoubleDouble& t) { return rational(t.high) + rational(t.low); }
Rational size(const Rational& r) { return r < 0 ? Rational(-r) : r; }

/// Returns a difference of two numbers, near each other or far apart: with low parts, and sums that cancel.
DoubleDouble some(Random& random) {
  const double a = std::ldexp(random.between(-1, 1), random.integer(-40, 40));
  return DoubleDouble::difference(a, random.chance(0.5) ? a * random.between(0.9, 1.1)
                                                        : std::ldexp(random.between(-1, 1), random.integer(-40, 40)));
}

bool is_normal(const DoubleDouble& t) { return std::abs(t.low) <= 0x1p-53 * std::abs(t.high); }

}  // namespace

TEST_CASE("differences of doubles are exact; products and sums are as near as derived") {
  Random random(12);
  const Rational unit = rational(0x1p-53), unit_squared = unit * unit;
  int rounded = 0;
  for (int trial = 0; trial < trials(20000); ++trial) {
    const double a = random.between(-1, 1), b = std::ldexp(random.between(-1, 1), random.integer(-60, 60));
    CHECK(value(DoubleDouble::difference(a, b)) == rational(a) - rational(b));
    const DoubleDouble e = some(random), f = some(random), g = random.chance(0.5) ? e * f : some(random);
    const DoubleDouble h = random.chance(0.5) ? g : some(random) * e;
    for (const DoubleDouble& t : {e * f, g * h, e + f, g + h, g - h, e * f - g, g - e * f}) CHECK(is_normal(t));
    const Rational product = value(g) * value(h);
    CHECK(size(value(g * h) - product) <= 9 * unit_squared * size(product));
    rounded += value(g * h) != product;
    const Rational most = 4 * unit_squared * (size(value(g)) + size(value(h)));
    CHECK(size(value(g + h) - (value(g) + value(h))) <= most);
    CHECK(size(value(g - h) - (value(g) - value(h))) <= most);
  }
  CHECK(rounded > 1000);
}

TEST_SUITE_END();
