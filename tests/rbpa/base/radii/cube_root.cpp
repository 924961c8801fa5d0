#include "rbpa/base/radii/cube_root.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::cube_root;

TEST_SUITE_BEGIN("predicates");

namespace {

Rational exactly(long double value) {
  const auto high = static_cast<double>(value);
  return rational(high) + rational(static_cast<double>(value - high));
}

Rational cube(const Rational& r) { return r * r * r; }

/// Returns whether the root is within 1.2 units in the last place. Requires: numbers from 2⁻⁹⁰⁰ to 2⁹⁰⁰.
template <typename Real>
bool is_near(Real x) {
  const Real root = cube_root(x);
  const Rational unit = exactly(std::ldexp(std::numeric_limits<Real>::epsilon(), std::ilogb(root))) * 6 / 5;
  return cube(exactly(root) - unit) <= exactly(x) && exactly(x) <= cube(exactly(root) + unit);
}

template <typename Real>
void check_roots() {
  using Limits = std::numeric_limits<Real>;
  Random random(8);
  for (int trial = 0; trial < trials(4000); ++trial) {
    const Real x = (1 + Real(random.unit()) + Real(random.unit()) * Limits::epsilon()) / 2;
    for (const int exponent : {0, -1, -2, random.integer(-800, 800)}) CHECK(is_near(std::ldexp(x, exponent)));
    CHECK(cube_root(std::ldexp(x, -900)) == std::ldexp(cube_root(x), -300));
  }
  for (int i = 0; i < 1000; ++i) CHECK(cube_root(Real(i) * i * i) == i);
  for (const Real x : {Limits::denorm_min(), Limits::min(), Limits::max(), Real(1) / 8, 1 - Limits::epsilon()}) {
    const Real expected = std::cbrt(x);
    CHECK(std::abs(cube_root(x) - expected) <= 2 * Limits::epsilon() * expected);
  }
}

}  // namespace

TEST_CASE("cube roots are near in double and long double, exact of cubes, and scale with powers of eight") {
  check_roots<double>();
  check_roots<long double>();
}

TEST_SUITE_END();
