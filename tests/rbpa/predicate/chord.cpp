#include "rbpa/predicate/chord.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/exact.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Chord;
using rbpa::Point;

TEST_SUITE_BEGIN("predicates");

TEST_CASE("points compete for a chord as rational numbers say") {
  Random random(41);
  for (const Kind kind : kinds_that_fit_double) {
    CAPTURE(name(kind));
    int compared = 0, wrong = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      std::array<Point, 4> s;
      fill(s, kind, random);
      auto& [a, b, p, q] = s;
      if (a == b) continue;
      int side = exact::orientation(a, b, p);
      wrong += Chord(a, b).is_left(Chord(a, b).candidate(p)) != (side > 0);
      if (side < 0) std::swap(a, b);
      if (side == 0 || std::find(s.begin(), s.begin() + 3, q) != s.begin() + 3) continue;
      const Chord chord(a, b);
      wrong += chord.is_inside(chord.candidate(q), chord.candidate(p)) != (exact::in_perturbed_circle(a, b, p, q) > 0);
      ++compared;
    }
    CHECK(wrong == 0);
    CHECK((kind == Kind::on_line || compared > 100));
  }
}

TEST_SUITE_END();
