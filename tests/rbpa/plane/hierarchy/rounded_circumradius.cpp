#include "rbpa/plane/hierarchy/site_levels.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "support/arguments.h"
#include "support/exact.h"
#include "support/random.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::circumradius;
using rbpa::Point;

TEST_SUITE_BEGIN("hierarchy");

namespace {

/// The result is reduced by a millionth to be below the true radius; the ladder allows ten times as much.
constexpr double digits = 1e-6;

/// Returns whether the area is clearly larger than its rounding error.
template <typename Real>
bool is_clear(const std::array<Point, 3>& p) {
  using P = rbpa::Predicates<Real>;
  const auto ab = P::from(p[0], p[1]), ca = P::from(p[2], p[0]);
  return std::abs(P::cross(ab, ca)) >= 24 * P::unit_roundoff * P::cross_magnitude(ab, ca);
}

/// Checks and counts the triangles of a kind whose area is clear.
template <typename Real>
std::size_t check(Kind kind, Random& random) {
  CAPTURE(name(kind));
  std::size_t clear = 0;
  for (int trial = 0; trial < trials(500); ++trial) {
    std::array<Point, 3> p;
    fill(p, kind, random);
    if (exact::orientation(p[0], p[1], p[2]) == 0) continue;
    const Real r = circumradius<Real>(p[0], p[1], p[2]);
    REQUIRE(r > 0);
    REQUIRE(std::isfinite(r));
    // The bound in double, without rounding of its own.
    if (r < Real(1e-290) || r > Real(1e290)) continue;
    const auto number = static_cast<double>(r);
    REQUIRE(exact::compare_circumradius(p[0], p[1], p[2], number * (1 - digits)) >= 0);
    if (!is_clear<Real>(p)) continue;
    ++clear;
    REQUIRE(exact::compare_circumradius(p[0], p[1], p[2], 2 * number * (1 + digits)) <= 0);
  }
  return clear;
}

}  // namespace

TEST_CASE("the scheduled circumradius is not above the true one, and at least half of it where the area is clear") {
  Random random(53);
  for (const Kind kind : kinds_that_fit_double) {
    const std::size_t clear = check<double>(kind, random);
    if (kind != Kind::on_line && kind != Kind::near_line) CHECK(clear > trials(200));
    check<long double>(kind, random);
  }
  CHECK(check<long double>(Kind::extreme, random) > 0);
}

TEST_CASE("it is the circumradius where the area is hardly rounded") {
  for (const double scale : {0x1p-100, 1.0, 0x1p100}) {
    CHECK(circumradius<double>({0, 0}, {3 * scale, 0}, {0, 4 * scale}) == doctest::Approx(2.5 * scale));
    CHECK(circumradius<double>({5 * scale, 0}, {-3 * scale, 4 * scale}, {0, -5 * scale}) == doctest::Approx(5 * scale));
  }
  CHECK(circumradius<long double>({0, 0}, {3e300, 0}, {0, 4e300}) / 2.5e300L == doctest::Approx(1));
  CHECK(circumradius<long double>({0, 0}, {3e-300, 0}, {0, 4e-300}) / 2.5e-300L == doctest::Approx(1));
}

TEST_CASE("a triangle so flat that rounding hides its area gets a finite radius, not above the true one") {
  // Points at 0.1, 0.2 and 0.3 of the diagonal x = y; e moves two of them off it.
  for (const double e : {0.0, 0x1p-54, 0x1p-53, 0x1p-50}) {
    const std::array<Point, 3> p{Point{0.1, 0.1}, {0.2, 0.2 + e}, {0.3, 0.3 - e}};
    if (exact::orientation(p[0], p[1], p[2]) == 0) continue;
    const double r = circumradius<double>(p[0], p[1], p[2]);
    CHECK(r > 0.1);
    CHECK(exact::compare_circumradius(p[0], p[1], p[2], r * (1 - digits)) >= 0);
  }
}

TEST_SUITE_END();
