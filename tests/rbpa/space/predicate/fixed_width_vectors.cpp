#include "rbpa/space/predicate/fixed_width_vectors.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "oracle/rational.h"
#include "rbpa/base/exact/integer_scale.h"
#include "rbpa/space/predicate/sphere.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::FixedVector;
using rbpa::space::FixedVectors;
namespace space = rbpa::space;

TEST_SUITE_BEGIN("space");

namespace {

using Whole = space::Vector3<rbpa::Integer>;

Whole whole(const FixedVector& v) { return {v.x, v.y, v.z}; }

/// Returns an integer of about 2^bits, the largest with either sign, or zero.
std::int64_t number(int bits, Random& random) {
  const std::int64_t limit = (std::int64_t{1} << bits) - 1;
  switch (random.below(6)) {
    case 0:
      return limit;
    case 1:
      return -limit;
    case 2:
      return 0;
    default:
      return static_cast<std::int64_t>(random.below(2 * static_cast<std::uint64_t>(limit))) - limit;
  }
}
FixedVector vector(int bits, Random& random) {
  return {number(bits, random), number(bits, random), number(bits, random)};
}

}  // namespace

TEST_CASE("words of 64 bits give the signs of integers of any length, up to the largest differences") {
  Random random(131);
  int zeros = 0;
  for (const int bits : {1, 2, 20, 31, 32, 33, 60, 61})
    for (int trial = 0; trial < trials(4000); ++trial) {
      CAPTURE(bits);
      const FixedVector u = vector(bits, random), v = vector(bits, random), w = vector(bits, random);
      const FixedVector p = random.below(4) == 0 ? u : vector(bits, random);  // u is on the sphere
      const Whole a = whole(u), b = whole(v), c = whole(w), d = whole(p);
      const rbpa::Integer volume = dot(cross(a, b), c);
      const rbpa::Integer power = dot(d, d) * volume - dot(a, a) * dot(cross(b, c), d) -
                                  dot(b, b) * dot(cross(c, a), d) - dot(c, c) * dot(cross(a, b), d);
      CHECK(space::volume_sign(u, v, w) == volume.sign());
      CHECK(space::power_sign(u, v, w, p) == power.sign());
      zeros += power == 0 && volume != 0;
      // Balls: a weight is a product of two numbers below 2^60.
      std::array<std::int64_t, 8> factor{};
      for (std::int64_t& value : factor) value = number(std::min(bits, 60), random);
      std::array<rbpa::Integer128, 4> weights{};
      std::array<rbpa::Integer, 4> whole_weights;
      for (std::size_t i = 0; i < 4; ++i) {
        weights[i] = rbpa::Integer128{factor[2 * i]} * factor[2 * i + 1];
        whole_weights[i] = factor[2 * i];
        whole_weights[i] *= factor[2 * i + 1];
      }
      const rbpa::Integer with_weights = power - whole_weights[3] * volume + whole_weights[0] * dot(cross(b, c), d) +
                                         whole_weights[1] * dot(cross(c, a), d) +
                                         whole_weights[2] * dot(cross(a, b), d);
      CHECK(space::power_sign(u, v, w, p, weights) == with_weights.sign());
    }
  CHECK(zeros > trials(4000));
}

TEST_CASE("differences are integers of one unit, whatever the unit, or there are none") {
  Random random(132);
  int exact = 0, inexact = 0;
  for (int trial = 0; trial < trials(20000); ++trial) {
    const int unit = static_cast<int>(random.below(2000)) - 1000, spread = static_cast<int>(random.below(24));
    const auto coordinate = [&] {
      return std::ldexp(static_cast<double>(number(52, random)),
                        unit + static_cast<int>(random.below(1 + static_cast<std::uint64_t>(spread))));
    };
    std::array<Point3, 3> p;
    for (Point3& q : p) q = {coordinate(), coordinate(), coordinate()};
    const FixedVectors<2> to(p[0], {&p[1], &p[2]});
    if (!to.are_exact()) {
      ++inexact;
      continue;
    }
    ++exact;
    // All of them have the same factor.
    Rational factor = 0;
    for (std::size_t i = 0; i < 2; ++i)
      for (const auto& [whole, from, at] :
           {std::tuple(to[i].x, p[0].x, p[i + 1].x), {to[i].y, p[0].y, p[i + 1].y}, {to[i].z, p[0].z, p[i + 1].z}}) {
        CHECK(std::abs(whole) <= std::int64_t{1} << 60);
        const Rational difference = rational(at) - rational(from);
        CHECK((whole == 0) == (difference == 0));
        if (whole == 0) continue;
        if (factor == 0) factor = difference / Rational(rbpa::Integer(whole));
        CHECK(factor > 0);
        CHECK(difference == factor * Rational(rbpa::Integer(whole)));
      }
  }
  CHECK(exact > trials(4000));
  CHECK(inexact > trials(1000));
}

TEST_CASE("differences that do not fit are not exact, and are decided by integers of any length") {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const Point3 zero = {0, 0, 0}, one = {1, 0, 0};
  const auto fit = [&](const Point3& p, const Point3& q) { return FixedVectors<2>(p, {&q, &one}).are_exact(); };
  CHECK(fit(zero, zero));
  CHECK(fit({-0.0, 0, -0.0}, one));
  CHECK(fit({0x1p-59, 0, 0}, zero));
  CHECK_FALSE(fit({0x1p-60, 0, 0}, zero));  // 1 is 2^60 units
  CHECK_FALSE(fit({least, 0, 0}, zero));
  CHECK_FALSE(fit({0x1p-1022, 0, 0}, zero));
  CHECK_FALSE(fit({most, 0, 0}, zero));
  CHECK_FALSE(FixedVectors<1>({-most, 0, 0}, {&one}).are_exact());
  const Point3 far = {0x1p1023, 0, 0}, near = {0x1p1022, 0, 0};
  CHECK(FixedVectors<1>(near, {&far}).are_exact());
  CHECK_FALSE(FixedVectors<1>({-0x1p1023, 0, 0}, {&far}).are_exact());  // the difference is infinite
  // A cube in a unit that fits, and in one so small that its differences are not normal.
  for (const double unit : {0.1, 0x1p-1070}) {
    CAPTURE(unit);
    const Point3 a = zero, b = {unit, 0, 0}, c = {0, unit, 0}, d = {0, 0, unit}, tie = {unit, unit, unit};
    CHECK(space::in_sphere_on_grid(a, b, c, d, tie).has_value() == (unit == 0.1));
    CHECK(space::in_sphere_exactly(a, b, c, d, tie) == space::pulled_into_sphere(a, b, c, d, tie));
    CHECK(space::in_sphere_exactly(a, b, c, d, {unit, unit, 0.5 * unit}));
    CHECK_FALSE(space::in_sphere_exactly(a, b, c, d, {unit, unit, 2 * unit}));
  }
}

TEST_SUITE_END();
