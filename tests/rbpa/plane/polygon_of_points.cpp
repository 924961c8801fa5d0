#include "rbpa/plane/polygon_of_points.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/pictures.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::PolygonFilter;

TEST_SUITE_BEGIN("shape");

namespace {

using Numbers = std::vector<std::optional<std::uint32_t>>;

enum class Side { outside, on, inside };

/// Returns the side by counting crossings of a ray, in exact numbers: the points are small integers.
Side side_of(const Point& p, const rbpa::Ring& ring, const Points& points) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point& a = points[ring.points[i]];
    const Point& b = points[ring.points[(i + 1) % ring.points.size()]];
    const double turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const bool between = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
                         p.y <= std::max(a.y, b.y);
    if (turn == 0 && between) return Side::on;
    if ((a.y > p.y) != (b.y > p.y) && (turn > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside ? Side::inside : Side::outside;
}

bool is_in(const Point& p, const Polygon& polygon, const Points& points) {
  if (side_of(p, polygon.shell, points) == Side::outside) return false;
  for (const rbpa::Ring& hole : polygon.holes)
    if (side_of(p, hole, points) == Side::inside) return false;
  return true;
}

Numbers by_definition(const std::vector<Polygon>& polygons, const Points& points) {
  Numbers numbers;
  for (const Point& p : points) {
    std::optional<std::uint32_t> number;
    for (std::uint32_t k = 0; k < polygons.size() && !number; ++k)
      if (is_in(p, polygons[k], points)) number = k;
    numbers.push_back(number);
  }
  return numbers;
}

void check(const Points& points, double alpha) {
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  const rbpa::AlphaComplex arrays = rbpa::alpha_complex(points, alpha, {.neighbors = true});
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double hole : {0.0, 1.5, 4.5, 20.0, infinity})
    for (const double part : {0.0, 1.0, 5.0, infinity}) {
      CAPTURE(alpha);
      CAPTURE(hole);
      CAPTURE(part);
      const PolygonFilter filter{.min_hole_area = hole, .min_part_area = part};
      const std::vector<Polygon> polygons = rbpa::outline_polygons(complex, filter);
      const Numbers wanted = by_definition(polygons, points);
      REQUIRE(rbpa::polygon_of_points(complex, polygons, filter, points) == wanted);
      REQUIRE(rbpa::polygon_of_points(points, arrays, arrays.duplicates, polygons, filter) == wanted);
      REQUIRE(rbpa::polygon_of_points(polygons, points, points) == wanted);
      std::vector<Polygon> filtered = rbpa::outline_polygons(points, arrays);
      rbpa::filter_polygons(filtered, points, filter);
      REQUIRE(filtered == polygons);
    }
}

}  // namespace

TEST_CASE(
    "a point is in the first polygon that contains it, inside or on a ring, with pinches, islands and filled holes") {
  Random random(11);
  for (int run = 0; run < 60; ++run) {
    const int columns = random.integer(3, 16);
    const auto count = static_cast<std::size_t>(random.integer(3, columns * columns));
    const Points points = random_grid(columns, count, random.chance(0.3), random.bits());
    for (const double alpha : {0.75, 1.0, 1.2, 1.6, 2.5}) check(points, alpha);
  }
  for (const double solid : {0.5, 0.7})
    for (int run = 0; run < 10; ++run) {
      Points points = points_of(random_picture(10, 10, solid, random));
      // Points in holes, in no triangle; some of them repeated.
      for (int i = 0; i < 12; ++i)
        points.push_back(
            {static_cast<double>(2 * random.integer(0, 9) + 1), static_cast<double>(2 * random.integer(0, 9) + 1)});
      check(points, picture_alpha);
    }
}

TEST_CASE("without polygons no point is in one") {
  check({}, 1);
  check({{0, 0}, {1, 0}, {2, 0}, {1, 0}}, 1);
  check({{0, 0}, {1, 0}, {0, 1}, {9, 9}, {9, 9}, {0, 1}}, 1);
}

TEST_CASE("the search for points in filled holes can be cancelled anywhere") {
  const Points points = uniform(60000, 5);
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, 0.4);
  const PolygonFilter filled{.min_hole_area = std::numeric_limits<double>::infinity()};
  const std::vector<Polygon> polygons = rbpa::outline_polygons(complex, filled);
  std::size_t asked = 0;
  rbpa::polygon_of_points(complex, polygons, filled, points, [&] { return ++asked > 0; });
  const auto queries = static_cast<double>(complex.isolated.size());
  // The sort of the queries compares that often
  CHECK(static_cast<double>(asked) > queries * std::log2(queries) / 2 / 16384);
  for (std::size_t last = 1; last <= asked; ++last) {
    std::size_t left = last;
    CHECK_THROWS_AS(rbpa::polygon_of_points(complex, polygons, filled, points, [&] { return --left > 0; }),
                    rbpa::Cancelled);
    CHECK(left == 0);  // and was not called again
  }
}

TEST_SUITE_END();
