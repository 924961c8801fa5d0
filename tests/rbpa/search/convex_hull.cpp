#include "rbpa/search/convex_hull.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::ConvexHull;
using rbpa::Point;

TEST_SUITE_BEGIN("search");

namespace {

/// q is between a and b. Requires: on their line.
bool between(const Point& a, const Point& b, const Point& q) { return (a < q && q < b) || (b < q && q < a); }

bool is_edge(const Points& points, const Point& a, const Point& b) {
  for (const Point& q : points) {
    if (q == a || q == b) continue;
    const int side = exact::orientation(a, b, q);
    if (side > 0 || (side == 0 && between(a, b, q))) return false;
  }
  return true;
}

bool on_a_line(const Points& points) {
  for (std::size_t i = 2; i < points.size(); ++i)
    if (exact::orientation(points[0], points[1], points[i]) != 0) return false;
  return true;
}

Points distinct(const Points& points) {
  Points some = points;
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end()), some.end());
  Random random(some.size());
  random.shuffle(some);
  return some;
}

/// The first pair about which the hull is wrong, as text; "" when there is none.
template <typename Real>
std::string wrong_edge(const Points& points) {
  const ConvexHull<Real> hull(points);
  for (std::uint32_t a = 0; a < points.size(); ++a)
    for (std::uint32_t b = 0; b < points.size(); ++b)
      if (a != b && hull.has_edge(a, b) != is_edge(points, points[a], points[b]))
        return std::to_string(a) + "-" + std::to_string(b);
  return "";
}

void check(const Points& all, bool fits_double = true) {
  const Points points = distinct(all);
  if (points.size() < 3 || on_a_line(points)) return;
  if (fits_double) CHECK(wrong_edge<double>(points) == "");
  CHECK(wrong_edge<long double>(points) == "");
}

}  // namespace

TEST_CASE("hull edges of small grids are the pairs with nothing on the left or between") {
  for (int number = 0; number < 1500; ++number) {
    CAPTURE(number);
    Random random(static_cast<std::uint64_t>(number));
    check(random_grid(random.integer(2, 7), random.below(14) + 3, true, random.bits()));
  }
}

TEST_CASE("hull edges are right where many points lie on sides and circles") {
  check(perfect_grid(8, 1));
  check(perfect_grid(8, 0.1));
  check(rotated_integer_grid(7));
  check(rotated_rounded_grid(7));
  check(triangular_lattice(7));
  check(integer_circle(1105));
  check(integer_concentric(325, true));
  check(rounded_concentric(25));
  check(collinear_run_with_points_off(50, 7, -3, 3, 1));
  check(collinear_run_with_points_off(50, 0, 1, 3, 2));
  check(collinear_run(60, 0.1, 0.3, 3));  // on a line but for the last bits
  check(moved(jittered_grid(8, 0.9, 4), 0x1p52, 0x1p51));
  check(uniform(50, 5));
}

TEST_CASE("hull edges are right at both ends of the range of double") {
  check(scaled(perfect_grid(5, 1), 1020), false);
  check(scaled(uniform(30, 6), -1030), false);
  check(denormals(12, 40, 7), false);
  check(mixed_exponents(8, 8), false);
  check(far_and_tiny(4, 9), false);
  Points corners = corners_of_range();
  corners.resize(25);
  check(corners, false);
}

TEST_SUITE_END();
