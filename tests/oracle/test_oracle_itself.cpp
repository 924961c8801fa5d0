// Compares the oracles with each other: they must agree before they judge the library.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "oracle/brute_force.h"
#include "oracle/circumradius.h"
#include "oracle/delaunay.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/shrink.h"

namespace rbpa_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns at most `most` points on a small grid, which is too wide to be full.
Points small_grid(Random& random, int most) {
  const int columns = random.integer(2, 6);
  return random_grid(columns, static_cast<std::size_t>(random.integer(3, most)), random.chance(0.2), random.bits());
}

double some_alpha(Random& random) {
  const double choices[] = {0.5, std::sqrt(0.5), 0.75, 1, 1.25, 1.5, 2, 2.5, 4, infinity};
  return choices[random.below(std::size(choices))];
}

TEST_CASE("brute force and CGAL agree on small integer grids, triangle for triangle") {
  Random random(101);
  for (int i = 0; i < 4000; ++i) {
    const Points points = small_grid(random, 12);
    const double alpha = some_alpha(random);
    const std::string differs = difference(brute_force(points, alpha), DelaunayOracle(points).triangles(alpha));
    REQUIRE_MESSAGE(differs.empty(), literal(points), " alpha ", literal(alpha), ": ", differs);
  }
}

TEST_CASE("rational numbers and 128-bit integers agree") {
  Random random(102);
  for (int i = 0; i < 300; ++i) {
    const Points points = small_grid(random, 9);
    const double alpha = some_alpha(random);
    REQUIRE(brute_force(points, alpha) == brute_force_in_rationals(points, alpha));
  }
}

TEST_CASE("brute force and CGAL agree where exponents are extreme") {
  Random random(103);
  for (int i = 0; i < 300; ++i) {
    Points points;
    const int count = random.integer(3, 7), kind = random.integer(0, 3);
    for (int n = 0; n < count; ++n) {
      const int x = random.integer(-4, 4), y = random.integer(-4, 4);
      const auto exponent = [&] {
        constexpr int some[] = {1000, 0, -1000, -1074};
        return some[kind < 3 ? kind : static_cast<int>(random.below(4))];
      };
      const int x_exponent = exponent(), y_exponent = exponent();
      points.push_back({std::ldexp(x, x_exponent), std::ldexp(y, y_exponent)});
    }
    const double alpha = random.chance(0.3) ? infinity : std::ldexp(some_alpha(random), kind == 0 ? 1000 : -1000);
    const std::string differs =
        difference(brute_force_in_rationals(points, alpha), DelaunayOracle(points).triangles(alpha));
    REQUIRE_MESSAGE(differs.empty(), literal(points), " alpha ", literal(alpha), ": ", differs);
  }
}

TEST_CASE("both kernels of CGAL agree if both can be used") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (const Points& points : {random_grid(12, 80, false, seed), uniform(100, seed), clusters(10, seed)})
      CHECK(DelaunayOracle(points, Kernel::filtered).triangles(infinity) ==
            DelaunayOracle(points, Kernel::rational).triangles(infinity));
  }
}

TEST_CASE("a circumradius equal to alpha is within it, and the doubles next to alpha distinguish that") {
  for (const int exponent : {0, 1000, -1000, 300, -300}) {
    CAPTURE(exponent);
    const auto times = [&](double value) { return std::ldexp(value, exponent); };
    const rbpa::Point a{0, 0}, b{times(3), 0}, c{0, times(4)};
    CHECK(circumradius_at_most(a, b, c, times(2.5)));
    CHECK(circumradius_at_most(a, b, c, std::nextafter(times(2.5), infinity)));
    CHECK_FALSE(circumradius_at_most(a, b, c, std::nextafter(times(2.5), 0.0)));
    CHECK_FALSE(circumradius_at_most(a, b, c, std::numeric_limits<double>::denorm_min()));
    CHECK(circumradius_at_most(a, b, c, std::numeric_limits<double>::max()));
    CHECK(circumradius_at_most(a, b, c, infinity));
  }
}

TEST_CASE("intervals and rational numbers decide circumradii alike") {
  Random random(104);
  int within = 0;
  for (int i = 0; i < 3000; ++i) {
    const Points p = uniform(3, random.bits());
    const double alpha = random.between(0.3, 2);
    const bool fits = circumradius_at_most(p[0], p[1], p[2], alpha);
    within += fits;
    REQUIRE(fits == circumradius_at_most_exactly(p[0], p[1], p[2], alpha));
  }
  CHECK(within > 300);
  CHECK(within < 2700);
}

TEST_CASE("the four points of a square are split from the lexicographically largest") {
  // The largest point is lifted most, so that it is cut off: the diagonal joins the other two corners of its square.
  const Points square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Triangle> expected = {{0, 1, 3}, {1, 2, 3}};
  CHECK(brute_force(square, infinity) == expected);
  CHECK(DelaunayOracle(square).triangles(infinity) == expected);
}

TEST_CASE("the lowest index stands for all equal points") {
  const Points points = {{5, 5}, {0, 0}, {-0.0, 0}, {1, 0}, {0, -0.0}, {0, 1}, {1, 0}};
  const std::vector<Triangle> expected = {{1, 3, 5}, {0, 5, 3}};
  CHECK(brute_force(points, infinity) == canonical(expected));
  CHECK(DelaunayOracle(points).triangles(infinity) == canonical(expected));
}

TEST_CASE("a shrunk set still fails and no point can be left out of it") {
  const Points points = uniform(200, 7);
  const auto fails = [&](const Points& some) {  // fails exactly with points 17 and 171
    return std::count(some.begin(), some.end(), points[17]) + std::count(some.begin(), some.end(), points[171]) == 2;
  };
  CHECK(shrink(points, fails) == Points{points[17], points[171]});
}

}  // namespace
}  // namespace rbpa_test
