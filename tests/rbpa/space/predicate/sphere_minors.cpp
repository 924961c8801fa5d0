// The in-sphere determinant by its minors, and its error bound, compared with rational numbers.
#include "rbpa/space/predicate/sphere_minors.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "oracle/rational.h"
#include "rbpa/base/point3.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::ErrorBound;
using rbpa::space::Spoke;
using rbpa::space::WeightedSpoke;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns a vector of any direction, with a length from 1 to 2^−70, or rounded to a grid. It has few bits, so that
/// sums of products are sometimes exact.
Point3 vector_of(Random& random) {
  const double length = std::ldexp(1.0, -static_cast<int>(random.below(random.below(2) == 0 ? 3 : 70)));
  const auto coordinate = [&] {
    const double value = 2 * random.unit() - 1;
    return length * (random.below(3) == 0 ? std::nearbyint(value * 4) / 4 : value);
  };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

using Entries = std::array<Rational, 4>;

Entries entries(const Point3& p) {
  const Rational x = rational(p.x), y = rational(p.y), z = rational(p.z);
  return {x, y, z, x * x + y * y + z * z};
}

Rational determinant(const std::array<Entries, 4>& rows) {
  const auto of_three = [&](std::size_t i, std::size_t j, std::size_t k) -> Rational {  // of the first three rows
    const auto two = [&](std::size_t p, std::size_t q) -> Rational {
      return rows[1][p] * rows[2][q] - rows[1][q] * rows[2][p];
    };
    return rows[0][i] * two(j, k) - rows[0][j] * two(i, k) + rows[0][k] * two(i, j);
  };
  return rows[3][3] * of_three(0, 1, 2) - rows[3][2] * of_three(0, 1, 3) + rows[3][1] * of_three(0, 2, 3) -
         rows[3][0] * of_three(1, 2, 3);
}

}  // namespace

TEST_CASE("the determinant by minors is within its error bound for any lengths, also with a corner at infinity") {
  Random random(3196);
  std::size_t inexact = 0;
  for (int trial = 0; trial < trials(20'000); ++trial) {
    const Point3 a = vector_of(random), b = vector_of(random), c = vector_of(random), q = vector_of(random);
    const std::size_t at_infinity = random.below(6);  // corner 0 to 2, or none
    std::array<Spoke, 3> spokes{};
    std::array<Entries, 4> rows{};
    std::size_t k = 0;
    for (const Point3& p : {a, b, c}) {
      spokes[k] = k == at_infinity ? Spoke::to_infinity() : Spoke::to(p.x, p.y, p.z);
      rows[k] = k == at_infinity ? Entries{0, 0, 0, 1} : entries(p);
      ++k;
    }
    rows[3] = entries(q);
    const auto minor = rbpa::space::sphere_minors(spokes[0], spokes[1], spokes[2]);
    const ErrorBound bound = at_infinity < 3 ? rbpa::space::half_space_error(spokes[0], spokes[1], spokes[2], 0)
                                             : rbpa::space::sphere_error(spokes[0], spokes[1], spokes[2], 0);
    const double square = q.x * q.x + q.y * q.y + q.z * q.z;
    const double value = minor[0] * q.x + minor[1] * q.y + minor[2] * q.z + minor[3] * square;
    const Rational exact = determinant(rows), off = abs(Rational(rational(value) - exact));
    CAPTURE(trial);
    CHECK(off <= rational(bound.at(square)));
    inexact += off != 0 ? 1u : 0u;
  }
  CHECK(inexact > 1000);
}

TEST_CASE("the error bound holds for balls too, and where squares underflow") {
  Random random(3197);
  std::size_t inexact = 0, bounded = 0;
  for (int trial = 0; trial < trials(20'000); ++trial) {
    const bool is_far = random.below(2) == 0;  // lengths and radii from 2^150 to 2^-1000
    const auto size = [&] {
      return std::ldexp(1.0, !is_far                ? -static_cast<int>(random.below(20))
                             : random.below(2) == 0 ? 149
                                                    : -static_cast<int>(random.below(1000)));
    };
    const auto radius = [&] { return random.below(4) == 0 ? 0 : random.unit() * size(); };
    const double first = radius();  // of the ball at the origin, corner d
    std::array<WeightedSpoke, 3> spokes{};
    std::array<Entries, 4> rows{};
    Point3 q;
    double weight = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double s = size(), own = random.below(4) == 0 ? first : radius();
      q = {s * (2 * random.unit() - 1), s * (2 * random.unit() - 1), s * (2 * random.unit() - 1)};
      weight = rbpa::space::weight_difference(own, first);
      if (k < 3) spokes[k] = WeightedSpoke::to(q.x, q.y, q.z, weight);
      rows[k] = entries(q);
      rows[k][3] -= rational(own) * rational(own) - rational(first) * rational(first);
    }
    const auto minor = rbpa::space::sphere_minors(spokes[0], spokes[1], spokes[2]);
    const double bound = rbpa::space::sphere_error(spokes[0], spokes[1], spokes[2], is_far ? 0x1p-400 : 0)
                             .at(q.x * q.x + q.y * q.y + q.z * q.z + std::abs(weight));
    const double lift = q.x * q.x + q.y * q.y + q.z * q.z - weight;
    const double value = minor[0] * q.x + minor[1] * q.y + minor[2] * q.z + minor[3] * lift;
    if (!std::isfinite(bound)) continue;
    const Rational off = abs(Rational(rational(value) - determinant(rows)));
    CAPTURE(trial);
    CHECK(off <= rational(bound));
    inexact += off != 0 ? 1u : 0u;
    ++bounded;
  }
  CHECK(inexact > static_cast<std::size_t>(trials(15'000)));
  CHECK(bounded > static_cast<std::size_t>(trials(17'000)));
}

TEST_SUITE_END();
