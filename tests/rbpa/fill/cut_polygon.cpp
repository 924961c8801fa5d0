#include "rbpa/fill/cut_polygon.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill/validity.h"
#include "rbpa/plane/alpha_complex.h"

using namespace rbpa;

namespace {

/// Returns whether p is inside: counts how often a ray to the right crosses rings.
bool is_inside(const std::vector<Point>& points, const std::vector<Polygon>& polygons, const Point& p) {
  bool inside = false;
  const auto cross = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Point &a = points[ring.points[i]], &b = points[ring.points[(i + 1) % ring.points.size()]];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  };
  for (const Polygon& polygon : polygons) {
    cross(polygon.shell);
    for (const Ring& hole : polygon.holes) cross(hole);
  }
  return inside;
}

double area_of(const std::vector<Polygon>& polygons) {
  double area = 0;
  for (const Polygon& polygon : polygons) area += polygon.area;
  return area;
}

/// Returns some points of a lattice, so that many lie on a line, and rings touch each other and themselves.
std::vector<Point> lattice(std::mt19937& random, int side) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      if (random() % 4 != 0) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

}  // namespace

TEST_SUITE("fill") {
  TEST_CASE("parts are valid, lie on their sides, and cover the same area as the polygon") {
    std::mt19937 random(7);
    std::size_t cut_polygons = 0, with_holes = 0, several = 0;
    for (int round = 0; round < 150; ++round) {
      const std::vector<Point> points = lattice(random, 9);
      const double alpha = round % 2 == 0 ? 0.75 : 1.2;
      const std::vector<Polygon> all = outline_polygons(points, alpha_complex(points, alpha, {.neighbors = true}));
      for (const double x : {2.0, 3.5, 4.0, 5.0, 5.125, 7.0})
        for (const Polygon& polygon : all) {
          CAPTURE(round);
          CAPTURE(x);
          const PolygonCut cut = cut_at(points, polygon, x);
          REQUIRE(cut.points.size() == points.size() + cut.crossings.size());
          const auto no_reason = std::optional<std::string>();
          CHECK(why_invalid(cut.points, cut.left) == no_reason);
          CHECK(why_invalid(cut.points, cut.right) == no_reason);
          const auto lie_within = [&](const std::vector<Polygon>& parts, double sign) {
            for (const Polygon& part : parts)
              for (const std::uint32_t i : part.shell.points)
                if (sign * (cut.points[i].x - x) < 0) return false;
            return true;
          };
          CHECK(lie_within(cut.left, -1));
          CHECK(lie_within(cut.right, 1));
          CHECK(area_of(cut.left) + area_of(cut.right) == doctest::Approx(polygon.area).epsilon(1e-12));
          for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j) {
              const Point p{i + 0.23, j + 0.41};
              CHECK(is_inside(cut.points, p.x < x ? cut.left : cut.right, p) == is_inside(points, {polygon}, p));
              CHECK_FALSE(is_inside(cut.points, p.x < x ? cut.right : cut.left, p));
            }
          cut_polygons += !cut.left.empty() && !cut.right.empty() ? 1U : 0U;
          with_holes += polygon.holes.empty() ? 0U : 1U;
          several += cut.left.size() > 1 || cut.right.size() > 1 ? 1U : 0U;
        }
    }
    CHECK(cut_polygons > 500);
    CHECK(with_holes > 300);
    CHECK(several > 100);
  }

  TEST_CASE("a line that misses the polygon, or passes through one corner, leaves it whole") {
    const std::vector<Point> points = {{0, 0}, {2, 1}, {0, 2}};
    const Polygon triangle{.shell = {{0, 1, 2}}, .holes = {}, .area = 2};
    for (const double x : {-1.0, 0.0}) {
      const PolygonCut cut = cut_at(points, triangle, x);
      CHECK(cut.left.empty());
      REQUIRE(cut.right.size() == 1);
      CHECK(cut.right.front().shell == triangle.shell);
    }
    const PolygonCut cut = cut_at(points, triangle, 2);
    CHECK(cut.right.empty());
    CHECK(cut.left.size() == 1);
  }

  TEST_CASE("a crossing names its edge and its position on it") {
    const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 8}, {0, 4}};
    const PolygonCut cut = cut_at(points, {.shell = {{0, 1, 2, 3}}}, 1);
    REQUIRE(cut.crossings.size() == 2);
    CHECK(cut.points[4] == Point{1, 0});
    CHECK(cut.points[5] == Point{1, 5});
    CHECK(cut.crossings[1].from == 3);
    CHECK(cut.crossings[1].to == 2);
    CHECK(cut.crossings[1].share == 0.25);
  }

  TEST_CASE("an empty polygon has no parts") {
    const PolygonCut cut = cut_at({}, {}, 0);
    CHECK((cut.points.empty() && cut.left.empty() && cut.right.empty()));
  }

  TEST_CASE("a clockwise shell is refused") {
    const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    CHECK_THROWS_AS(cut_at(points, {.shell = {{3, 2, 1, 0}}}, 1), InvalidInput);
  }
}
