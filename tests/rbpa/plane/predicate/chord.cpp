#include "rbpa/plane/predicate/chord.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/arguments.h"
#include "support/exact.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Chord;
using rbpa::Point;

TEST_SUITE_BEGIN("predicates");

namespace {

template <typename Real>
void check_contests(Kind kind, Random& random) {
  CAPTURE(name(kind));
  int compared = 0, wrong = 0;
  for (int trial = 0; trial < trials(2000); ++trial) {
    std::array<Point, 4> s;
    fill(s, kind, random);
    auto& [a, b, p, q] = s;
    if (a == b) continue;
    int side = exact::orientation(a, b, p);
    wrong += Chord<Real>(a, b).is_left(Chord<Real>(a, b).candidate(p)) != (side > 0);
    if (side < 0) std::swap(a, b);
    if (side == 0 || std::find(s.begin(), s.begin() + 3, q) != s.begin() + 3) continue;
    const Chord<Real> chord(a, b);
    wrong += chord.is_inside(chord.candidate(q), chord.candidate(p)) != (exact::in_perturbed_circle(a, b, p, q) > 0);
    ++compared;
  }
  CHECK(wrong == 0);
  CHECK((kind == Kind::on_line || compared > 100));
}

}  // namespace

TEST_CASE("points compete for a chord as rational numbers show, in either arithmetic") {
  Random random(41);
  for (const Kind kind : kinds_that_fit_double) {
    check_contests<double>(kind, random);
    check_contests<long double>(kind, random);
  }
  check_contests<long double>(Kind::extreme, random);
}

TEST_SUITE_END();
