#include "rbpa/plane/hierarchy/equal_squares.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::EqualSquares;
using rbpa::Point;
using Square = rbpa::Square<double>;

TEST_SUITE_BEGIN("hierarchy");

namespace {

/// Returns the square of a point, cut by cut.
Square textbook(Square square, const Point& p, int depth) {
  for (; depth > 0; --depth) {
    const double x = square.middle_x(), y = square.middle_y();
    square = {p.x >= x ? x : square.x, p.y >= y ? y : square.y, square.side / 2};
  }
  return square;
}

/// Returns a corner of one of the squares, or a point that differs from it in the last bits.
Point near_a_corner(Random& random, const Square& all, int depth) {
  Square square = all;
  for (; depth > 0; --depth)
    square = {random.chance(0.5) ? square.middle_x() : square.x, random.chance(0.5) ? square.middle_y() : square.y,
              square.side / 2};
  const auto beside = [&](double corner, double low) {
    const int bits = random.integer(-1, 1);
    return bits == 0 || (bits < 0 && corner == low) ? corner : std::nextafter(corner, bits * 100.0);
  };
  return {beside(square.x, all.x), beside(square.y, all.y)};
}

}  // namespace

TEST_CASE("a point lies in the square that repeated cuts find, also on cuts and a last bit away from them") {
  Random random(41);
  for (int number = 0; number < 300; ++number) {
    const Square all{random.between(-3, 3), random.between(-3, 3), random.between(0.1, 2)};
    const int depth = random.integer(1, 8);
    Points points;
    for (int i = 0; i < 200; ++i) points.push_back(near_a_corner(random, all, depth));
    points.push_back({all.x + all.side, all.y + all.side});
    EqualSquares<double> squares(all, depth);
    REQUIRE(squares.are_apart());
    squares.count(points);
    std::size_t seen = 0;
    squares.for_each_above(0, points, [&](std::span<Point> held, const Square& square) {
      for (const Point& p : held) {
        ++seen;
        const Square expected = textbook(all, p, depth);
        CHECK(std::tuple(square.x, square.y, square.side) == std::tuple(expected.x, expected.y, expected.side));
      }
    });
    CHECK(seen == points.size());
  }
}

TEST_CASE("merged squares hold the points of their quarters") {
  const Points points = uniform(3000, 42);
  const Square all{0, 0, 60};
  EqualSquares<double> merged(all, 6);
  merged.count(points);
  for (int depth = 6; depth >= 0; --depth) {
    std::map<std::pair<double, double>, std::size_t> held;
    std::size_t most = 0;
    for (const Point& p : points) {
      const Square square = textbook(all, p, depth);
      most = std::max(most, ++held[{square.x, square.y}]);
    }
    CHECK(merged.max_held() == most);
    if (depth > 0) merged.merge();
  }
}

TEST_CASE("squares too small for their place are not apart") {
  CHECK(EqualSquares<double>({0x1p52, 0, 64}, 6).are_apart());
  CHECK_FALSE(EqualSquares<double>({0x1p52, 0, 64}, 7).are_apart());
  CHECK_FALSE(EqualSquares<double>({0, -0x1p52, 64}, 8).are_apart());
  CHECK_FALSE(EqualSquares<double>({0, 0, 0}, 1).are_apart());
}

TEST_SUITE_END();
