#include "rbpa/space/predicate/sphere.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracle/rational_vector.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/predicate/spread.h"
#include "support/arguments.h"
#include "support/for_space_sets.h"
#include "support/order.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
namespace space = rbpa::space;

TEST_SUITE_BEGIN("space");

namespace {

using Vector = Vector3<Rational>;

/// Returns the circumcenter relative to a, by Cramer's rule. Requires: a positive volume.
Vector center(const Vector& u, const Vector& v, const Vector& w) {
  const Vector vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Rational uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), twice = 2 * dot(uv, w);
  return (uu * vw + vv * wu + ww * uv) / twice;
}

}  // namespace

TEST_CASE("side of sphere and circumradius agree with rational numbers") {
  Random random(111);
  int ties = 0, inside = 0, decided = 0;
  for_space_sets(trials(200), 5, 0, random, [&](Points3 p) {
    if (p.size() < 5) return;
    const double radius = space_radius(p, random);
    const Vector u = rational_from(p[0], p[1]), v = rational_from(p[0], p[2]), w = rational_from(p[0], p[3]),
                 q = rational_from(p[0], p[4]);
    const Rational volume = dot(cross(u, v), w);
    if (volume == 0) {
      CHECK(space::exact::compare_circumradius(p[0], p[1], p[2], p[3], radius) == 1);
      return;
    }
    if (volume < 0) {
      std::swap(p[2], p[3]);
    }
    const Vector c = center(u, v, w), to = q - c;
    const int expected = Rational(dot(c, c) - dot(to, to)).sign();
    ties += expected == 0;
    inside += expected > 0;
    CHECK(space::exact::side_of_sphere(p[0], p[1], p[2], p[3], p[4]) == expected);
    const int compared = Rational(dot(c, c) - rational(radius) * rational(radius)).sign();
    CHECK(space::exact::compare_circumradius(p[0], p[1], p[2], p[3], radius) == compared);
    const space::Spread spread = space::spread(p);
    if (!spread.is_exact || spread.exponent != 0) return;
    // Except for the last rounding to double, the error is some 2^-98 of the product of the greatest lengths.
    const double value = space::in_sphere_by_double_double(p[0], p[1], p[2], p[3], p[4]);
    const Rational exact = (dot(c, c) - dot(to, to)) * abs(volume);
    Rational size = 0;
    for (const Point3& r : p) size = std::max(size, Rational(dot(rational_from(p[3], r), rational_from(p[3], r))));
    const Rational error = abs(Rational(rational(value) - exact)) - rational(0x1p-52) * abs(exact);
    CHECK((error <= 0 || error * error <= rational(0x1p-190) * size * size * size * size * size));
    decided += value != 0;
  });
  CHECK(ties > trials(100));
  CHECK(inside > trials(100));
  CHECK(decided > trials(500));
}

TEST_CASE("ties are perturbed consistently: any four corners and the fifth point give one set of tetrahedra") {
  // Radon: five points in general position have two triangulations of their hull, and the perturbation selects one.
  Random random(112);
  int seen = 0, without_error = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    Points3 p = space_set(SpaceKind::cospherical, 5, random);
    sort_distinct(p);
    if (p.size() < 5) continue;
    p.resize(5);
    const double unit = random.integer(1, 1000);  // determinants of small multiples have no error
    for (Point3& r : p) r = unit * r;
    const space::Spread spread = space::spread(p);
    Rational volume = 0;
    std::array<int, 5> side{};
    for (std::size_t out = 0; out < 5; ++out) {
      std::array<Point3, 4> t;
      for (std::size_t i = 0, k = 0; i < 5; ++i)
        if (i != out) t[k++] = p[i];
      side[out] = space::exact::orientation(t[0], t[1], t[2], t[3]);
      if (side[out] == 0) continue;
      if (side[out] < 0) std::swap(t[0], t[1]);
      if (space::exact::side_of_sphere(t[0], t[1], t[2], t[3], p[out]) != 0) continue;
      ++seen;
      const bool in = space::pulled_into_sphere(t[0], t[1], t[2], t[3], p[out]);
      CHECK(space::in_sphere_exactly(t[0], t[1], t[2], t[3], p[out]) == in);
      const auto spoke = [&](const Point3& r) { return space::Spoke::to(r.x - t[3].x, r.y - t[3].y, r.z - t[3].z); };
      const double error = space::sphere_error(spoke(t[0]), spoke(t[1]), spoke(t[2]), 0).at(spoke(p[out]).square);
      CHECK(space::BeyondFilter(spread).is_inside(t[0], t[1], t[2], t[3], p[out], 0, error) == in);
      without_error += error < spread.exact_below(5);
      // Even permutations of the corners change nothing.
      CHECK(space::pulled_into_sphere(t[1], t[2], t[0], t[3], p[out]) == in);
      CHECK(space::pulled_into_sphere(t[3], t[2], t[1], t[0], p[out]) == in);
      const Rational six = dot(cross(rational_from(t[0], t[1]), rational_from(t[0], t[2])), rational_from(t[0], t[3]));
      volume += in ? Rational(-six) : six;
    }
    // Tetrahedra of the selected triangulation are empty, those of the other contain the fifth point; each set fills
    // the hull.
    CHECK(volume == 0);
  }
  CHECK(seen > trials(800));
  CHECK(without_error > trials(200));
  CHECK(without_error < seen - trials(200));
}

TEST_CASE("the spread of exponents is exact where 300 bits hold all coordinates") {
  using space::spread;
  CHECK(spread(Points3{}).is_exact);
  CHECK(spread(Points3{{0, -0.0, 0}}).is_exact);
  const auto plain = spread(Points3{{1, -2.5, 3}, {0.75, 0, 0}});
  CHECK((plain.is_exact && plain.exponent == 0 && plain.unit == -2));
  for (const int exponent : {-1070, -400, 400, 1000}) {
    CAPTURE(exponent);
    const Points3 points = {{std::ldexp(3.0, exponent), 0, 0},
                            {0, -std::ldexp(5.0, exponent - 4), std::ldexp(1.0, exponent + 10)}};
    const auto s = spread(points);
    CHECK(s.is_exact);
    CHECK(s.unit >= -150);
    std::vector<Point3> copy;
    const auto moved = space::scaled(points, s, copy);
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(std::ldexp(moved[i].x, -s.exponent) == points[i].x);
      CHECK(std::ldexp(moved[i].y, -s.exponent) == points[i].y);
      CHECK(std::max(moved[i].x, moved[i].z) <= 0x1p150);
      CHECK(std::fmod(moved[i].y, std::ldexp(1.0, s.unit)) == 0);
    }
  }
  const auto wide = spread(Points3{{0x1p-1074, 0, 0}, {0x1p1023, 0, 0}});
  CHECK(!wide.is_exact);
  CHECK(wide.underflow() > 0);
  CHECK(wide.exact_below(5) == 0);
  CHECK(std::ldexp(0x1p1023, wide.exponent) < 0x1p150);
  CHECK(!spread(Points3{{0x1p-150, 0, 0}, {0x1p151, 0, 0}}).is_exact);
  CHECK(spread(Points3{{0x1p-150, 0, 0}, {0x1p149, 0, 0}}).is_exact);
}

TEST_SUITE_END();
