#include "rbpa/plane/hierarchy/quadtree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/generate.h"
#include "support/order.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Quadtree;

TEST_SUITE_BEGIN("hierarchy");

namespace {

Points distinct(Points points) {
  sort_distinct(points);
  Random random(points.size());
  random.shuffle(points);
  return points;
}

/// Finds the smallest leaf by the definition, square by square.
template <typename Real>
Real textbook(const Points& points, Real x, Real y, Real side, std::size_t capacity) {
  const Real middle_x = x + side / 2, middle_y = y + side / 2;
  if (points.size() <= capacity || !(middle_x > x && middle_y > y)) return side;
  Points quarter[2][2];
  for (const Point& p : points) quarter[p.y >= middle_y][p.x >= middle_x].push_back(p);
  Real least = side / 2;
  for (const bool top : {false, true})
    for (const bool right : {false, true})
      least = std::min(
          least, textbook<Real>(quarter[top][right], right ? middle_x : x, top ? middle_y : y, side / 2, capacity));
  return least;
}

template <typename Real>
Real textbook(const Points& points, std::size_t capacity) {
  if (points.empty()) return 0;
  Real left = Real(points[0].x), right = left, bottom = Real(points[0].y), top = bottom;
  for (const Point& p : points) {
    left = std::min(left, Real(p.x));
    right = std::max(right, Real(p.x));
    bottom = std::min(bottom, Real(p.y));
    top = std::max(top, Real(p.y));
  }
  return textbook<Real>(points, left, bottom, std::max(right - left, top - bottom), capacity);
}

void check(const Points& all, bool fits_double = true) {
  const Points points = distinct(all);
  for (const std::size_t k : {1u, 2u, 3u, 7u, 64u, 1024u}) {
    CAPTURE(k);
    if (fits_double) CHECK(Quadtree<double>(points, k).smallest_side() == textbook<double>(points, k));
    CHECK(Quadtree<long double>(points, k).smallest_side() == textbook<long double>(points, k));
  }
}

}  // namespace

TEST_CASE("the smallest leaf is that of squares cut in four while they hold too many points") {
  check({});
  check({{1, 2}});
  check({{1, 2}, {3, 4}});
  check(uniform(500, 1));
  check(jittered_grid(20, 0.9, 2));
  check(perfect_grid(17, 1));
  check(perfect_grid(17, 0.1));
  check(rotated_rounded_grid(15));
  check(clusters(20, 3));
  check(lidar_lines(10, 30, 4));
  check(collinear_run(50, 0, 1, 5));
  check(collinear_run(50, 1, 0, 6));
  check(integer_circle(1105));
}

TEST_CASE("points on a cut belong to the upper right") {
  for (int number = 0; number < 3000; ++number) {
    CAPTURE(number);
    Random random(static_cast<std::uint64_t>(number));
    check(random_grid(random.integer(2, 17), random.below(12) + 2, false, random.bits()));
    Points tenths = random_grid(random.integer(2, 17), random.below(12) + 2, false, random.bits());
    for (Point& p : tenths) p = {0.1 * p.x - 0.7, 0.3 * p.y - 0.3};
    check(tenths);
  }
}

TEST_CASE("where doubles end before the points separate, squares are cut down to that limit") {
  const double one = std::nextafter(0x1p52, 0x1p53);
  check({{0x1p52, 0x1p52}, {one, 0x1p52}, {0x1p52, one}, {0, 0}});
  check({{0x1p52, 0}, {0x1p52, 1e-10}, {0x1p52, 2e-10}, {0, 0}});
  check({{-0x1p52, 1}, {-0x1p52, 1 + 1e-10}, {1, 1}, {1, 2}});
  check(moved(jittered_grid(15, 0.9, 7), 0x1p52, 0x1p51));
  check(nearest_doubles(100, 8), true);
}

TEST_CASE("the smallest leaf is right at the limits of double") {
  check(scaled(uniform(50, 9), 1010), false);
  check(denormals(12, 60, 10), false);
  check(mixed_exponents(20, 11), false);
  check(far_and_tiny(10, 12), false);
  check(corners_of_range(), false);
}

TEST_CASE("capacity 0 counts as capacity 1, and order does not matter") {
  Points points = distinct(uniform(100, 13));
  const double side = Quadtree<double>(points, 1).smallest_side();
  CHECK(Quadtree<double>(points, 0).smallest_side() == side);
  Random random(14);
  random.shuffle(points);
  CHECK(Quadtree<double>(points, 1).smallest_side() == side);
}

TEST_CASE("many points, which are counted in equal squares, have the same smallest leaf") {
  Points crowds = uniform(4500, 16), tenths = moved(perfect_grid(65, 0.1), 0.7, -0.3);
  for (const Point& p : uniform(5000, 17)) crowds.push_back({3 + 1e-3 * p.x, 5 + 1e-3 * p.y});
  for (const Point& p : uniform(5000, 18)) crowds.push_back({3 + 1e-6 * p.x, 5 + 1e-9 * p.y});
  for (const Points& points :
       {uniform(9000, 19), clusters(900, 20), perfect_grid(65, 1), perfect_grid(65, 0.3), tenths, crowds,
        nearest_doubles(2500, 21), lidar_lines(50, 200, 22), collinear_run(5000, 0, 1, 23),
        moved(perfect_grid(70, 1), 0x1p47, -0x1p50), moved(uniform(5000, 24), 0x1p48, 0x1p44)})
    check(points);
}

TEST_SUITE_END();
