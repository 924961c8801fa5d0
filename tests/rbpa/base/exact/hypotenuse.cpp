#include "rbpa/base/exact/hypotenuse.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::hypotenuse;

TEST_SUITE_BEGIN("predicates");

TEST_CASE("a hypotenuse is nearly as near as a double can be, at every scale") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max(),
                   least = std::numeric_limits<double>::denorm_min();
  Random random(9);
  for (int trial = 0; trial < trials(4000); ++trial) {
    const int exponent = random.integer(-960, 1000);
    const double x = std::ldexp(random.between(-1, 1), exponent),
                 y = std::ldexp(random.between(-1, 1), exponent - random.integer(0, 60));
    const double found = hypotenuse(x, y);
    CHECK(found == hypotenuse(-y, x));
    const Rational unit = rational(std::ldexp(1.0, std::ilogb(found) - 52)) * 51 / 100,
                   square = rational(x) * rational(x) + rational(y) * rational(y);
    const Rational below = rational(found) - unit, above = rational(found) + unit;
    CHECK((below * below <= square && square <= above * above));
  }
  CHECK(hypotenuse(0, -0.0) == 0);
  CHECK(hypotenuse(3 * least, 4 * least) == 5 * least);
  CHECK(hypotenuse(most, least) == most);
  CHECK(hypotenuse(most, most) == infinity);
  CHECK(hypotenuse(1, -infinity) == infinity);
}

TEST_SUITE_END();
