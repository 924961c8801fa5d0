#include "rbpa/filling_values.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill.h"

using namespace rbpa;

namespace {

/// A comb with a hole, in which a straight line between points often leaves the polygon.
const std::vector<Point> comb = {{0, 0}, {9, 0}, {9, 5}, {8, 5},   {8, 1},   {7, 1},     {7, 5},    {5, 5},
                                 {5, 1}, {4, 1}, {4, 5}, {0, 5.5}, {1, 3.1}, {1.7, 4.1}, {2.9, 3.3}};
const Polygon comb_polygon{.shell = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}, .holes = {{{12, 13, 14}}}};

double side(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

}  // namespace

TEST_SUITE("fill") {
  TEST_CASE("a linear function is reproduced, and given points keep their values to the last bit") {
    std::vector<double> values;
    for (const Point& p : comb) values.push_back(3 * p.x - 2 * p.y + 0.1);
    for (const bool keep : {false, true}) {
      const Filling filling = fill(comb, std::vector{comb_polygon}, {.size = 0.4, .keep_boundary = keep});
      REQUIRE(filling.points.size() > filling.boundary_points + 20);
      const std::vector<double> all = values_on_filling(filling, values);
      REQUIRE(all.size() == filling.points.size());
      for (std::size_t i = 0; i < values.size(); ++i) CHECK(all[i] == values[i]);
      for (std::size_t i = 0; i < all.size(); ++i)
        CHECK(all[i] == doctest::Approx(3 * filling.points[i].x - 2 * filling.points[i].y + 0.1).epsilon(1e-9));
    }
  }

  TEST_CASE("values inside are linear in the constrained Delaunay triangles of the boundary") {
    std::vector<double> values;
    for (std::size_t i = 0; i < comb.size(); ++i) values.push_back(static_cast<double>(i * i % 11));
    const Filling filling = fill(comb, std::vector{comb_polygon}, {.size = 0.4, .keep_boundary = true}),
                  coarse = fill(comb, std::vector{comb_polygon}, {.size = std::numeric_limits<double>::infinity()});
    const std::vector<double> all = values_on_filling(filling, values);
    for (std::size_t i = filling.boundary_points; i < all.size(); ++i) {
      const Point& p = filling.points[i];
      std::size_t around = 0;
      for (const Triangle& t : coarse.triangles) {
        const Point &a = comb[t[0]], &b = comb[t[1]], &c = comb[t[2]];
        const double u = side(b, c, p), v = side(c, a, p), w = side(a, b, p);
        if (u < 0 || v < 0 || w < 0) continue;
        ++around;
        CHECK(all[i] == doctest::Approx((u * values[t[0]] + v * values[t[1]] + w * values[t[2]]) / (u + v + w)));
      }
      CHECK(around >= 1);
    }
  }

  TEST_CASE("a point on an edge gets a value between those of its ends, and overlapping groups have their own values") {
    const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {5, 1}, {5, 5}, {1, 5}};
    const std::vector<Polygon> squares = {{.shell = {{0, 1, 2, 3}}}, {.shell = {{4, 5, 6, 7}}}};
    const std::vector<std::size_t> groups = {0, 1};
    const Filling filling = fill(points, squares, {.size = 1, .groups = groups});
    const std::vector<double> all = values_on_filling(filling, std::vector<double>{1, 1, 1, 1, 7, 7, 7, 7}, groups);
    for (std::size_t t = 0; t < filling.triangles.size(); ++t)
      for (const std::uint32_t i : filling.triangles[t]) CHECK(all[i] == (filling.groups[t] == 0 ? 1 : 7));
    const Filling one = fill(points, std::vector{squares[0]}, {.size = 1});
    const std::vector<double> rising = values_on_filling(one, std::vector<double>{0, 4, 8, 12, 0, 0, 0, 0});
    for (std::size_t i = 8; i < one.boundary_points; ++i)
      if (one.points[i].y == 0) CHECK(rising[i] == one.points[i].x);
  }

  TEST_CASE("no values give no values, and more values than points are refused") {
    const Filling filling = fill(comb, std::vector{comb_polygon}, {.size = 1});
    for (const double value : values_on_filling(filling, {})) CHECK(std::isnan(value));
    CHECK_THROWS_AS(values_on_filling(filling, std::vector<double>(filling.boundary_points + 1)), InvalidInput);
  }
}
