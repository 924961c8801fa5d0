#include "rbpa/plane/filtration/least_alpha.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/arguments.h"
#include "support/exact.h"
#include "support/infinity.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::least_alpha;
using rbpa::Point;

TEST_SUITE_BEGIN("filtration");

namespace {

std::vector<Kind> all_kinds() {
  std::vector<Kind> all(kinds_that_fit_double.begin(), kinds_that_fit_double.end());
  all.push_back(Kind::extreme);
  return all;
}

}  // namespace

TEST_CASE("the least alpha of a triangle admits it, and the next lower double does not") {
  Random random(41);
  int infinite = 0, equal = 0;
  for (const Kind kind : all_kinds()) {
    CAPTURE(name(kind));
    int checked = 0;
    for (int i = 0; i < trials(1000); ++i) {
      std::array<Point, 3> s;
      fill(s, kind, random);
      if (exact::orientation(s[0], s[1], s[2]) == 0) continue;
      ++checked;
      const double alpha = least_alpha(s[0], s[1], s[2]);
      REQUIRE(alpha > 0);
      if (std::isinf(alpha))
        ++infinite;
      else {
        const int side = exact::compare_circumradius(s[0], s[1], s[2], alpha);
        REQUIRE(side <= 0);
        equal += side == 0;
      }
      const double below = std::nextafter(alpha, 0.0);
      if (below > 0) REQUIRE(exact::compare_circumradius(s[0], s[1], s[2], below) > 0);
      REQUIRE(least_alpha(s[2], s[0], s[1]) == alpha);
      REQUIRE(least_alpha(s[1], s[0], s[2]) == alpha);
    }
    if (kind != Kind::on_line) CHECK(checked > 100);
  }
  CHECK(infinite > 3);
  CHECK(equal > 30);
}

TEST_CASE("the least alpha of an edge spans it, and the next lower double does not") {
  Random random(42);
  int equal = 0;
  for (const Kind kind : all_kinds()) {
    CAPTURE(name(kind));
    for (int i = 0; i < trials(3000); ++i) {
      std::array<Point, 2> s;
      fill(s, kind, random);
      if (s[0] == s[1]) continue;
      const double alpha = least_alpha(s[0], s[1]);
      REQUIRE(alpha > 0);
      REQUIRE(least_alpha(s[1], s[0]) == alpha);
      if (std::isfinite(alpha)) {
        const int side = exact::compare_to_diameter(s[0], s[1], alpha);
        REQUIRE(side <= 0);
        equal += side == 0;
      }
      const double below = std::nextafter(alpha, 0.0);
      if (below > 0) REQUIRE(exact::compare_to_diameter(s[0], s[1], below) > 0);
    }
  }
  CHECK(equal > 100);
}

TEST_CASE("a radius that is a double is its own least alpha") {
  CHECK(least_alpha({0, 0}, {6, 0}, {0, 8}) == 5);
  CHECK(least_alpha({0, 0}, {6, 8}) == 5);
  CHECK(least_alpha({1e300, 0}, {1e300, 2e300}) == 1e300);
  CHECK(least_alpha({0, 0}, {0, 1}) == 0.5);
}

TEST_CASE("a radius outside the range of double is rounded up to a limit of the range") {
  const double smallest = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();
  CHECK(least_alpha({0, 0}, {0, smallest}) == smallest);
  CHECK(least_alpha({0, 0}, {smallest, 0}, {0, smallest}) == smallest);
  CHECK(least_alpha({-1e308, 0}, {0, smallest}, {1e308, 0}) == infinity);
  CHECK(least_alpha({-largest, 0}, {largest, 0}) == largest);
  CHECK(least_alpha({-largest, -largest}, {largest, largest}) == infinity);
}

TEST_SUITE_END();
