#include "rbpa/space/predicate/resting_ball.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/rational_vector.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/space/cells/scale.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "support/arguments.h"
#include "support/for_space_sets.h"
#include "support/order.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::RestingBall;

TEST_SUITE_BEGIN("space");

namespace {

using Vector = Vector3<Rational>;

/// Returns the determinant with the three vectors as rows.
Rational det(const Vector& u, const Vector& v, const Vector& w) { return dot(u, cross(v, w)); }
int sign(const Rational& r) { return r.sign(); }

/// The ball by the textbook: the circumcenter solves 2u·x = u², 2v·x = v², n·x = 0, and the center is h normals above
/// it.
struct RationalBall {
  RationalBall(const Point3& a, const Point3& b, const Point3& c, double radius)
      : u(rational_from(a, b)), v(rational_from(a, c)), n(cross(u, v)) {
    const Rational all = 2 * dot(n, n);
    if (all == 0) return;
    // Cramer's rule: the right sides replace a column.
    const Rational p = dot(u, u), q = dot(v, v);
    center.x = det({p, u.y, u.z}, {q, v.y, v.z}, {0, n.y, n.z}) / all;
    center.y = det({u.x, p, u.z}, {v.x, q, v.z}, {n.x, 0, n.z}) / all;
    center.z = det({u.x, u.y, p}, {v.x, v.y, q}, {n.x, n.y, 0}) / all;
    height = (rational(radius) * rational(radius) - dot(center, center)) / dot(n, n);
    rests = height >= 0;
  }
  /// Returns 1 inside, −1 outside, 0 where the ball touches d, which is relative to a.
  int side(const Vector& d) const {
    // |d|² − 2 center · d − 2 √height (n · d)
    const Rational plain = dot(d, d) - 2 * dot(center, d), factor = 2 * dot(n, d);
    const Rational squares = plain * plain - factor * factor * height;
    if (sign(plain) != sign(factor)) return sign(plain) != 0 ? -sign(plain) : height == 0 ? 0 : sign(factor);
    return -sign(plain) * sign(squares);
  }

  Vector u, v, n, center{};
  Rational height;  // in normals, squared
  bool rests = false;
};

template <typename Real>
bool fits(const Points3& points, double radius) {
  return !std::is_same_v<Real, double> || rbpa::space::scale_to_double(points, radius) == 0;
}

bool on_integers(SpaceKind kind) {
  return kind == SpaceKind::grid || kind == SpaceKind::cospherical || kind == SpaceKind::plane_grid;
}

/// Draws four different points, and a radius that the first three decide, or that is a tie with the fourth.
bool draw(SpaceKind kind, Random& random, Points3& s, double& radius) {
  s = space_set(kind, 4 + random.below(3), random);
  radius = space_radius(s, random);
  static constexpr std::array ties = {0.5, 1.0, 1.5, 2.5, 3.0, 5.0, 9.0};
  if (on_integers(kind) && random.chance(0.7)) radius = ties[random.below(ties.size())];
  sort_distinct(s);
  random.shuffle(s);
  return s.size() >= 4;
}

}  // namespace

TEST_CASE_TEMPLATE("a ball agrees with rational numbers", Real, double, long double) {
  Random random(61);
  int touching = 0, level = 0, just = 0;
  for (int k = 0; k < space_kinds; ++k) {
    const auto kind = static_cast<SpaceKind>(k);
    CAPTURE(name(kind));
    for (int trial = 0; trial < (on_integers(kind) ? 6000 : 600); ++trial) {
      Points3 s;
      double radius;
      if (!draw(kind, random, s, radius) || !fits<Real>(s, radius)) continue;
      const RationalBall expected(s[0], s[1], s[2], radius);
      const RestingBall<Real> ball(s[0], s[1], s[2], radius);
      REQUIRE(ball.rests() == expected.rests);
      const Vector d = rational_from(s[0], s[3]);
      const int above = sign(dot(expected.n, d));
      CHECK(ball.side_of_plane(s[3]) == above);
      if (!expected.rests) continue;
      just += expected.height == 0;
      const int side = expected.side(d);
      CHECK(rbpa::space::exact::side_of_ball(s[0], s[1], s[2], radius, s[3]) == side);
      if (side != 0)
        CHECK(ball.contains(s[3]) == (side > 0));
      else if (above != 0)
        CHECK(ball.contains(s[3]) == (above > 0));  // a growing ball contains points above
      touching += side == 0 && above != 0;
      level += side == 0 && above == 0;
    }
  }
  CHECK(touching > 20);
  CHECK(level > 100);
  CHECK(just > 20);
}

TEST_CASE("a ball is the same from each of its corners, and on the other side of the plane for reversed corners") {
  Random random(62);
  int balls = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < trials(400); ++trial) {
      Points3 s;
      double radius;
      if (!draw(static_cast<SpaceKind>(k), random, s, radius)) continue;
      using Wide = RestingBall<long double>;
      const Wide ball(s[0], s[1], s[2], radius), turned(s[1], s[2], s[0], radius);
      REQUIRE(ball.rests() == turned.rests());
      if (!ball.rests()) continue;
      ++balls;
      CHECK(ball.contains(s[3]) == turned.contains(s[3]));
      const Wide back(s[1], s[0], s[2], radius);
      CHECK(ball.side_of_plane(s[3]) == -back.side_of_plane(s[3]));
    }
  CHECK(balls > trials(1000));
}

TEST_CASE("no filter decides wrongly for points that are on the sphere except for rounding") {
  // Shapes of triangles: arbitrary; much smaller than the ball; slivers; and as large as the ball allows, except for a
  // few doubles.
  enum { any, small, sliver, just, shapes };
  using Long = rbpa::space::Vector3<long double>;
  Random random(64);
  int inside = 0, outside = 0;
  for (int shape = 0; shape < shapes; ++shape)
    for (int trial = 0; trial < trials(4000); ++trial) {
      const auto near = [&](const Point3& p, double size) {
        return Point3{p.x + size * random.between(-1, 1), p.y + size * random.between(-1, 1),
                      p.z + size * random.between(-1, 1)};
      };
      const double size = shape == small ? 0x1p-9 : 1;
      const Point3 a = near({}, 1), b = near(a, size);
      const Point3 c =
          shape == sliver ? near({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, 0x1p-20) : near(a, size);
      const Long u = rbpa::space::from<long double>(a, b), v = rbpa::space::from<long double>(a, c), n = cross(u, v);
      const Long vn = cross(v, n), nu = cross(n, u);
      const long double uu = dot(u, u), vv = dot(v, v), nn = dot(n, n);
      Long o = {(uu * vn.x + vv * nu.x) / (2 * nn), (uu * vn.y + vv * nu.y) / (2 * nn),
                (uu * vn.z + vv * nu.z) / (2 * nn)};
      double radius = static_cast<double>(std::sqrt(dot(o, o)));
      radius *= shape == just ? 1 + std::ldexp(random.integer(0, 64), random.integer(-52, -48)) : random.between(1, 3);
      const long double height = std::sqrt(std::max(static_cast<long double>(radius) * radius - dot(o, o), 0.0L) / nn);
      o = {o.x + height * n.x, o.y + height * n.y, o.z + height * n.z};
      const Long d = rbpa::space::from<long double>({}, near({}, 1));
      const long double out = radius / std::sqrt(dot(d, d));
      const Point3 q = {double(a.x + o.x + out * d.x), double(a.y + o.y + out * d.y), double(a.z + o.z + out * d.z)};
      const RestingBall<double> ball(a, b, c, radius);
      CHECK(ball.rests() == (rbpa::space::exact::compare_circumradius(a, b, c, radius) <= 0));
      if (!ball.rests()) continue;
      const bool expected = rbpa::space::in_ball_exactly(a, b, c, radius, q);
      if (ball.contains(q) != expected) FAIL_CHECK(shape);
      ++(expected ? inside : outside);
      // A fourth point that is in the plane except for rounding.
      const double s = random.between(-2, 2), t = random.between(-2, 2);
      const Point3 level = {double(a.x + s * u.x + t * v.x), double(a.y + s * u.y + t * v.y),
                            double(a.z + s * u.z + t * v.z)};
      CHECK(ball.side_of_plane(level) == rbpa::space::exact::orientation(a, b, c, level));
    }
  CHECK(inside > trials(4000));
  CHECK(outside > trials(4000));
}

TEST_CASE("on a circle the perturbation is that of the plane, whatever the direction of the plane") {
  const Points3 circle = {{5, 0, 0},  {4, 3, 0},  {3, 4, 0},  {0, 5, 0}, {-3, 4, 0},
                          {-4, 3, 0}, {-5, 0, 0}, {0, -5, 0}, {3, -4, 0}};
  const auto flat = [](const Point3& p) { return rbpa::Point{p.x, p.y}; };
  const auto standing = [](const Point3& p) { return Point3{p.x, 7, p.y}; };  // keeps the lexicographic order
  int inside = 0;
  for (const Point3& a : circle)
    for (const Point3& b : circle)
      for (const Point3& c : circle)
        for (const Point3& q : circle) {
          if (a == b || a == c || b == c || q == a || q == b || q == c) continue;
          using Plane = rbpa::Predicates<double>;
          const bool left = Plane::orientation(flat(a), flat(b), flat(c)) > 0;
          const bool expected =
              Plane::in_perturbed_circle(flat(left ? a : b), flat(left ? b : a), flat(c), flat(q)) > 0;
          inside += expected;
          for (const double radius : {5.0, 6.0}) {
            CHECK(RestingBall<double>(a, b, c, radius).contains(q) == expected);
            CHECK(RestingBall<long double>(standing(a), standing(b), standing(c), radius).contains(standing(q)) ==
                  expected);
          }
        }
  CHECK(inside > 500);
}

TEST_CASE("a ball of exactly the circumradius rests; one a double smaller does not") {
  const Point3 a{3, 4, 0}, b{-4, 3, 0}, c{0, -5, 0};
  CHECK(RestingBall<double>(a, b, c, 5).rests());
  CHECK(!RestingBall<double>(a, b, c, std::nextafter(5, 0)).rests());
  CHECK(!RestingBall<double>({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, 1e9).rests());  // on a line
}

TEST_CASE("points and a radius that a power of two brings into the range of double are decided in double") {
  using rbpa::space::scale_to_double;
  CHECK(scale_to_double(Points3{}, 1) == 0);
  CHECK(scale_to_double(Points3{{0, 0, 0}, {1, -2, 3}}, 0.1) == 0);
  const Points3 far = {{0x1p900, 0, 0}, {0, -0x1.8p901, 1 * 0x1p880}};
  const auto down = scale_to_double(far, 0x1p890);
  REQUIRE(down);
  CHECK(std::ldexp(0x1p880, *down) >= 0x1p-98);
  CHECK(std::ldexp(0x1.8p901, *down) < 0x1p150);
  CHECK(scale_to_double(Points3{{0x1p-900, 0, 0}}, 0x1p-890) > 700);
  CHECK(!scale_to_double(Points3{{0x1p-200, 0, 0}, {0x1p200, 0, 0}}, 1));
  CHECK(!scale_to_double(Points3{{1, 0, 0}}, 0x1p300));
  CHECK(scale_to_double(Points3{{0x1p-1074, 0, 0}}, 0x1p-1070) == 1074 - 150);
}

TEST_CASE("the test of a triangle's normal agrees with rational numbers") {
  Random random(63);
  int none = 0;
  for_space_sets(trials(400), 4, 0, random, [&](const Points3& s) {
    if (s.size() < 4) return;
    Point3 m = random.chance(0.5) ? s[3] : random_normals(1, random).front();
    if (random.chance(0.2)) m = {m.x * 0x1p-1000, m.y * 0x1p-1060, m.z * 0x1p-1020};
    const Vector u = rational_from(s[0], s[1]), v = rational_from(s[0], s[2]),
                 w{rational(m.x), rational(m.y), rational(m.z)};
    const int expected = sign(det(u, v, w));
    none += expected == 0;
    CHECK(rbpa::space::TriangleNormal(s[0], s[1], s[2]).sign_along(m) == expected);
  });
  CHECK(none > trials(300));
}

TEST_SUITE_END();
