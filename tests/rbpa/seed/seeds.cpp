#include "rbpa/seed/seeds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "rbpa/predicate/exact_integer.h"
#include "rbpa/rbpa.h"
#include "support/random.h"
#include "support/shrink.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Point;

TEST_SUITE_BEGIN("seed");

namespace {

using P = rbpa::Predicates<long double>;

/// Every triangle that turns left, whose perturbed circle is empty and whose circumradius is at most alpha.
std::vector<Triangle> by_definition(const Points& points, double alpha) {
  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  std::vector<std::uint32_t> sites;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i) sites.push_back(i);
  std::vector<Triangle> result;
  for (const std::uint32_t a : sites)
    for (const std::uint32_t b : sites)
      for (const std::uint32_t c : sites) {
        if (b <= a || c <= a || b == c || P::orientation(points[a], points[b], points[c]) <= 0) continue;
        if (P::compare_circumradius(points[a], points[b], points[c], alpha) > 0) continue;
        const bool empty = std::none_of(sites.begin(), sites.end(), [&](std::uint32_t q) {
          return q != a && q != b && q != c && P::in_perturbed_circle(points[a], points[b], points[c], points[q]) > 0;
        });
        if (empty) result.push_back({a, b, c});
      }
  return canonical(std::move(result));
}

std::string wrong(const Points& points, double alpha) {
  return difference(by_definition(points, alpha), rbpa::triangles(rbpa::rbpa(points, alpha)));
}

void check(const Points& points, double alpha) {
  if (wrong(points, alpha).empty()) return;
  const Points small = shrink(points, [&](const Points& p) { return !wrong(p, alpha).empty(); });
  FAIL_CHECK("alpha " << alpha << ", points " << literal(small) << ": " << wrong(small, alpha));
}

}  // namespace

TEST_CASE("points that the ball meets at once seed each triangle once") {
  // From its dangling edge, the ball around (−5, 0) arrives at four points of the circle of radius alpha together.
  check({{-6, 0}, {-5, 0}, {5, 0}, {4, 3}, {3, 4}, {0, 5}}, 5);
}

TEST_CASE("a point met at once with others is no neighbour in the perturbed triangulation") {
  // The perturbation cuts (0, −5) off as an ear: it has no edge to (−4, 3).
  check({{0, -6}, {0, -5}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}}, 5);
}

TEST_CASE("points met as others are left, in a row of circles of radius alpha, seed each triangle once") {
  Points rectangles;
  for (const double x : {0.0, 6.0, 12.0})
    for (const double y : {-8.0, 0.0, 8.0}) rectangles.push_back({x, y});
  check(rectangles, 5);
  rectangles.push_back({0, -9});
  rectangles.push_back({-4, -12});
  check(rectangles, 5);
}

TEST_CASE("with circumradii of exactly alpha, seeds find each triangle of the complex and no other") {
  // Arcs of circles of radius 5 and 25, their centres on a grid, and a few stray points.
  struct Circle {
    double radius;
    std::vector<Point> points;
  };
  std::vector<Circle> circles = {{5, {}}, {25, {}}};
  for (Circle& c : circles)
    for (int x = -static_cast<int>(c.radius); x <= c.radius; ++x)
      for (int y = -static_cast<int>(c.radius); y <= c.radius; ++y)
        if (x * x + y * y == c.radius * c.radius) c.points.push_back({double(x), double(y)});
  Random random(81);
  for (int trial = 0; trial < 3000; ++trial) {
    const Circle& circle = circles[random.below(2)];
    const int span = static_cast<int>(circle.radius) * 2;
    Points points;
    for (int arc = random.integer(1, 2); arc > 0; --arc) {
      const Point centre{double(random.integer(-span, span)), double(random.integer(-span, span))};
      for (const Point& p : circle.points)
        if (random.chance(0.45)) points.push_back({centre.x + p.x, centre.y + p.y});
    }
    for (int stray = random.integer(0, 3); stray > 0; --stray)
      points.push_back({double(random.integer(-span, span)), double(random.integer(-span, span))});
    if (points.size() > 14) points.resize(14);
    random.shuffle(points);
    CAPTURE(trial);
    check(points, circle.radius);
  }
}

TEST_CASE("on small grids, seeds find each triangle of the complex and no other") {
  Random random(82);
  for (int trial = 0; trial < 3000; ++trial) {
    Points points(static_cast<std::size_t>(random.integer(3, 10)));
    const int side = random.integer(2, 7);
    for (Point& p : points) p = {double(random.integer(0, side)), double(random.integer(0, side))};
    const double alphas[] = {0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3};
    CAPTURE(trial);
    check(points, alphas[random.below(8)]);
  }
}

TEST_SUITE_END();
