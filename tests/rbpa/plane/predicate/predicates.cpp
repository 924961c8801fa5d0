#include "rbpa/plane/predicate/predicates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rbpa/base/exact/magnitude.h"
#include "support/arguments.h"
#include "support/exact.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Predicates;

TEST_SUITE_BEGIN("predicates");

namespace {

template <typename Real>
std::vector<Kind> kinds() {
  std::vector<Kind> all(kinds_that_fit_double.begin(), kinds_that_fit_double.end());
  if (!std::is_same_v<Real, double>) all.push_back(Kind::extreme);
  return all;
}

/// Returns a radius near the circumradius of (a, b, c), near half of |ab|, or arbitrary, within the domain of the
/// predicates.
double radius_near(const Point& a, const Point& b, const Point& c, Random& random) {
  using Long = Predicates<long double>;
  const auto ab = Long::from(a, b), bc = Long::from(b, c), ca = Long::from(c, a);
  const auto length = [](const Long::Vector& v) { return std::sqrt(Long::dot(v, v)); };
  long double radius = length(ab) / 2;
  if (random.chance(0.7)) {
    const long double area = std::abs(Long::cross(ab, ca));
    if (area > 0) radius = length(ab) * length(bc) * length(ca) / (2 * area);
  }
  if (random.chance(0.2)) radius = std::ldexp(1.0L + random.unit(), random.integer(-152, 759));
  const double clamped = static_cast<double>(std::clamp<long double>(radius, 0x1p-152, 0x1p+754));
  return std::clamp(jiggled(clamped, 1, random), 0x1p-152, 0x1p+754);
}

/// Makes (a, b, p) turn left. Returns false when they are on a line or two of the four coincide.
template <typename Real>
bool make_left_turn(std::array<Point, 4>& s) {
  const int side = rbpa::exact_integer::orientation(s[0], s[1], s[2]);
  if (side < 0) std::swap(s[0], s[1]);
  return side != 0 && std::find(s.begin(), s.begin() + 3, s[3]) == s.begin() + 3;
}

}  // namespace

TEST_CASE_TEMPLATE("every predicate agrees with rational numbers", Real, double, long double) {
  using P = Predicates<Real>;
  Random random(31);
  for (const Kind kind : kinds<Real>()) {
    CAPTURE(name(kind));
    int compared = 0;
    for (int trial = 0; trial < trials(600); ++trial) {
      std::array<Point, 4> s;
      fill(s, kind, random);
      const auto& [a, b, c, d] = s;
      CHECK(P::orientation(a, b, c) == exact::orientation(a, b, c));
      CHECK(P::compare_distances(a, b, c) == exact::compare_distances(a, b, c));
      CHECK(P::dot_sign(a, b, c) == exact::dot_sign(a, b, c));
      const double alpha = radius_near(a, b, c, random);
      CHECK(P::compare_to_diameter(a, b, alpha) == exact::compare_to_diameter(a, b, alpha));
      if (exact::orientation(a, b, c) != 0)
        CHECK(P::compare_circumradius(a, b, c, alpha) == exact::compare_circumradius(a, b, c, alpha));
      if (!make_left_turn<Real>(s)) continue;
      ++compared;
      CHECK(P::in_circle(a, b, c, d) == exact::in_circle(a, b, c, d));
      CHECK(P::in_perturbed_circle(a, b, c, d) == exact::in_perturbed_circle(a, b, c, d));
    }
    CHECK((kind == Kind::on_line || compared > 30));
  }
}

TEST_CASE_TEMPLATE("no filter decides wrongly: many near ties against integers", Real, double, long double) {
  using P = Predicates<Real>;
  namespace integer = rbpa::exact_integer;
  Random random(32);
  for (const Kind kind : kinds<Real>()) {
    CAPTURE(name(kind));
    const int trials = kind == Kind::extreme ? 2000 : 12000;
    int wrong = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::array<Point, 4> s;
      fill(s, kind, random);
      const auto& [a, b, c, d] = s;
      wrong += P::orientation(a, b, c) != integer::orientation(a, b, c);
      wrong += P::compare_distances(a, b, c) != integer::compare_distances(a, b, c);
      wrong += P::dot_sign(a, b, c) != integer::dot(a, b, c);
      const double alpha = radius_near(a, b, c, random);
      wrong += P::compare_to_diameter(a, b, alpha) != integer::compare_to_diameter(a, b, alpha);
      if (integer::orientation(a, b, c) != 0)
        wrong += P::compare_circumradius(a, b, c, alpha) != integer::compare_circumradius(a, b, c, alpha);
      if (make_left_turn<Real>(s)) wrong += P::in_circle(a, b, c, d) != integer::in_circle(a, b, c, d);
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE_TEMPLATE("exchanging arguments changes the sign as for real numbers", Real, double, long double) {
  using P = Predicates<Real>;
  Random random(33);
  for (const Kind kind : kinds<Real>()) {
    CAPTURE(name(kind));
    for (int trial = 0; trial < trials(400); ++trial) {
      std::array<Point, 4> s;
      fill(s, kind, random);
      const auto& [a, b, c, d] = s;
      const int side = P::orientation(a, b, c);
      CHECK(side == P::orientation(b, c, a));
      CHECK(side == -P::orientation(b, a, c));
      CHECK(side == -P::orientation(a, c, b));
      CHECK(P::compare_distances(a, b, c) == -P::compare_distances(a, c, b));
      CHECK(P::dot_sign(a, b, c) == P::dot_sign(a, c, b));
      if (!make_left_turn<Real>(s)) continue;
      const int in = P::in_perturbed_circle(a, b, c, d);
      CHECK(in != 0);
      CHECK(in == P::in_perturbed_circle(b, c, a, d));
      // With d left of a→b too, exactly one of the two circles through a and b contains the other's point.
      if (P::orientation(a, b, d) > 0) CHECK(in == -P::in_perturbed_circle(a, b, d, c));
    }
  }
}

TEST_CASE_TEMPLATE("candidates of an edge are totally ordered by their perturbed circles", Real, double, long double) {
  using P = Predicates<Real>;
  Random random(34);
  for (const Kind kind : {Kind::small_grid, Kind::on_circle, Kind::near_circle, Kind::offset_grid}) {
    CAPTURE(name(kind));
    for (int trial = 0; trial < 60; ++trial) {
      std::array<Point, 14> s;
      fill(s, kind, random);
      const Point a = s[0], b = s[1];
      std::vector<Point> left;
      for (const Point& p : s)
        if (P::orientation(a, b, p) > 0 && std::find(left.begin(), left.end(), p) == left.end()) left.push_back(p);
      const auto beats = [&](const Point& q, const Point& p) { return P::in_perturbed_circle(a, b, p, q) > 0; };
      int broken = 0;
      for (const Point& p : left)
        for (const Point& q : left) {
          if (p == q) continue;
          broken += beats(p, q) == beats(q, p);
          for (const Point& r : left)
            if (r != p && r != q) broken += beats(p, q) && beats(q, r) && !beats(p, r);
        }
      CHECK(broken == 0);
    }
  }
}

TEST_CASE_TEMPLATE("a circumradius equal to alpha compares equal, and one a step apart does not", Real, double,
                   long double) {
  using P = Predicates<Real>;
  for (const int exponent : {-90, -1, 0, 1, 90}) {
    const auto scaled = [&](double x, double y) { return Point{std::ldexp(x, exponent), std::ldexp(y, exponent)}; };
    const double radius = std::ldexp(65.0, exponent);
    const Point a = scaled(63, 16), b = scaled(-33, 56), c = scaled(25, -60);
    CHECK(P::compare_circumradius(a, b, c, radius) == 0);
    CHECK(P::compare_circumradius(a, b, c, std::nextafter(radius, 0.0)) == 1);
    CHECK(P::compare_circumradius(a, b, c, std::nextafter(radius, INFINITY)) == -1);
    const Point opposite = scaled(-63, -16);
    CHECK(P::compare_to_diameter(a, opposite, radius) == 0);
    CHECK(P::compare_to_diameter(a, opposite, std::nextafter(radius, 0.0)) == 1);
    CHECK(P::compare_to_diameter(a, opposite, std::nextafter(radius, INFINITY)) == -1);
  }
}

TEST_CASE("radii beyond the limits of double represent every circumradius of coordinates that fit") {
  Random random(35);
  for (int trial = 0; trial < trials(3000); ++trial) {
    std::array<Point, 3> s;
    fill(s, Kind::limits_of_double, random);
    if (rbpa::exact_integer::orientation(s[0], s[1], s[2]) == 0) continue;
    CHECK(rbpa::exact_integer::compare_circumradius(s[0], s[1], s[2], 0x1p+754) < 0);
    CHECK(rbpa::exact_integer::compare_circumradius(s[0], s[1], s[2], 0x1p-152) > 0);
  }
}

TEST_SUITE_END();
