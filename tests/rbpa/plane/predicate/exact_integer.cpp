#include "rbpa/plane/predicate/exact_integer.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "support/arguments.h"
#include "support/exact.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Point;

TEST_SUITE_BEGIN("predicates");

TEST_CASE("integers of any length agree with rational numbers") {
  Random random(21);
  std::vector<Kind> kinds(kinds_that_fit_double.begin(), kinds_that_fit_double.end());
  kinds.push_back(Kind::extreme);
  for (const Kind kind : kinds) {
    CAPTURE(name(kind));
    for (int trial = 0; trial < trials(300); ++trial) {
      std::array<Point, 4> s;
      fill(s, kind, random);
      const auto& [a, b, c, d] = s;
      CHECK(rbpa::exact_integer::orientation(a, b, c) == exact::orientation(a, b, c));
      CHECK(rbpa::exact_integer::compare_distances(a, b, c) == exact::compare_distances(a, b, c));
      CHECK(rbpa::exact_integer::dot(a, b, c) == exact::dot_sign(a, b, c));
      CHECK(rbpa::exact_integer::in_circle(a, b, c, d) == exact::in_circle(a, b, c, d));
      const double alpha = std::ldexp(1 + random.unit(), random.integer(-1074, 1022));
      CHECK(rbpa::exact_integer::compare_to_diameter(a, b, alpha) == exact::compare_to_diameter(a, b, alpha));
      if (exact::orientation(a, b, c) != 0)
        CHECK(rbpa::exact_integer::compare_circumradius(a, b, c, alpha) == exact::compare_circumradius(a, b, c, alpha));
    }
  }
}

TEST_SUITE_END();
