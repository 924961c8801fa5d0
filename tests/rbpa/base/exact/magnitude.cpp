#include "rbpa/base/exact/magnitude.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/arguments.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Point;

TEST_SUITE_BEGIN("predicates");

namespace {

/// Returns whether value is a multiple of 2^exponent. The exponents of long double hold every quotient.
bool is_multiple(double value, int exponent) {
  const long double quotient = std::ldexp(static_cast<long double>(value), -exponent);
  return quotient == std::floor(quotient);
}

}  // namespace

TEST_CASE("magnitude() is the tightest pair of exponents") {
  Random random(1);
  std::vector<Kind> kinds(kinds_that_fit_double.begin(), kinds_that_fit_double.end());
  kinds.push_back(Kind::extreme);
  for (int trial = 0; trial < trials(20000); ++trial) {
    std::array<Point, 3> points;
    fill(points, kinds[random.below(kinds.size())], random);
    const auto m = rbpa::magnitude(points);
    bool all_multiples = true, all_below = true, one_not_coarser = false, one_not_smaller = false, all_zero = true;
    for (const Point& p : points)
      for (const double c : {p.x, p.y}) {
        if (c == 0) continue;
        all_zero = false;
        all_multiples &= is_multiple(c, m.lowest);
        all_below &= std::abs(static_cast<long double>(c)) < std::ldexp(1.0L, m.highest);
        one_not_coarser |= !is_multiple(c, m.lowest + 1);
        one_not_smaller |= std::abs(static_cast<long double>(c)) >= std::ldexp(1.0L, m.highest - 1);
      }
    CHECK(all_multiples);
    CHECK(all_below);
    CHECK((all_zero || one_not_coarser));
    CHECK((all_zero || one_not_smaller));
  }
}

TEST_CASE("magnitude_bound() assumes that every coordinate uses all its bits") {
  Random random(3);
  std::vector<Kind> kinds(kinds_that_fit_double.begin(), kinds_that_fit_double.end());
  kinds.push_back(Kind::extreme);
  for (int trial = 0; trial < trials(20000); ++trial) {
    std::array<Point, 3> points;
    fill(points, kinds[random.below(kinds.size())], random);
    if (trial % 4 == 0) points[random.below(3)] = {0, random.below(2) == 0 ? -0.0 : random.unit()};
    int lowest = std::numeric_limits<int>::max();
    for (const Point& p : points)
      for (const double c : {p.x, p.y})
        if (c != 0) lowest = std::min(lowest, std::max(std::ilogb(c) - 52, -1074));
    const auto exact = rbpa::magnitude(points), bound = rbpa::magnitude_bound(points);
    CHECK(bound.highest == exact.highest);
    CHECK(bound.lowest == (lowest == std::numeric_limits<int>::max() ? exact.lowest : lowest));
    CHECK(bound.lowest <= exact.lowest);
  }
  CHECK(rbpa::magnitude_bound({}).highest == rbpa::magnitude({}).highest);
}

TEST_CASE("zeros have no magnitude, and the limits of double are those of fits_double()") {
  const auto fits = [](double value) { return rbpa::fits_double(rbpa::magnitude(std::array{Point{value, 0}})); };
  CHECK(fits(0.0));
  CHECK(fits(-0.0));
  CHECK(rbpa::fits_double(rbpa::magnitude({})));
  CHECK(fits(0x1p-150));
  CHECK_FALSE(fits(0x1p-151));
  CHECK(fits(0x1.fffffffffffffp+149));
  CHECK_FALSE(fits(0x1p+150));
  CHECK(fits(0x1.0000000000001p-98));
  CHECK_FALSE(fits(0x1.0000000000001p-99));
  CHECK_FALSE(fits(std::numeric_limits<double>::denorm_min()));
  CHECK_FALSE(fits(std::numeric_limits<double>::max()));
}

TEST_CASE("samples that claim to fit double do") {
  Random random(2);
  for (const Kind kind : kinds_that_fit_double)
    for (int trial = 0; trial < trials(2000); ++trial) {
      std::array<Point, 4> points;
      fill(points, kind, random);
      CHECK_MESSAGE(rbpa::fits_double(rbpa::magnitude(points)), name(kind));
    }
}

TEST_SUITE_END();
