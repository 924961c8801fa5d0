// fill() with an infinite size.
#include "rbpa/fill/front/triangulate_outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "fill/laws.h"
#include "fill/refusal.h"
#include "rbpa/fill.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/generate_polygons.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::Filling;
using rbpa::Point;
using rbpa::Polygon;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Counts the inner edges across which the apex is inside of the perturbed circle.
std::size_t illegal_edges(const Filling& filling) {
  std::size_t illegal = 0;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (const std::uint32_t other : filling.neighbors[t]) {
      if (other == rbpa::TriangleArrays::none || other < t) continue;
      const auto& across = filling.neighbors[other];
      const auto j = static_cast<std::size_t>(std::find(across.begin(), across.end(), t) - across.begin());
      const auto& [a, b, c] = filling.triangles[t];
      illegal +=
          rbpa::Predicates<long double>::in_perturbed_circle(filling.points[a], filling.points[b], filling.points[c],
                                                             filling.points[filling.triangles[other][j]]) > 0;
    }
  return illegal;
}

void check_law(const std::vector<Point>& points, const std::vector<Polygon>& polygons) {
  const Filling filling = rbpa::fill(points, polygons, {.size = infinity});
  const std::string wrong = rbpa_test::wrong_with_filling(filling, points, polygons, true);
  CHECK_MESSAGE(wrong.empty(), wrong);
  CHECK(filling.points == points);
  CHECK(illegal_edges(filling) == 0);
}

}  // namespace

TEST_CASE("without a size no point is added, and no inner edge is illegal, ties of cocircular points included") {
  for (std::size_t number = 0; number < 200; ++number) {
    const rbpa_test::PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    check_law(polygon.points, polygon.polygons);
  }
}

TEST_CASE("rings on small grids, where nearly all points are cocircular with others, are triangulated") {
  rbpa_test::Random random(3);
  std::size_t filled = 0;
  for (int i = 0; i < 3000; ++i) {
    const rbpa_test::PolygonCase made = rbpa_test::random_rings(random, 1, random.integer(3, 12), random.integer(3, 8));
    if (rbpa_test::refusal(made.points, made.polygons, {.size = infinity}) != "") continue;
    ++filled;
    INFO("number ", i);
    check_law(made.points, made.polygons);
  }
  CHECK(filled > 50);
}

TEST_CASE("edges that cross many triangles are enforced: slanted teeth, and one edge between two dense rows") {
  for (const double slant : {0.0, 0.3, 0.7, 5.0}) {
    constexpr int teeth = 400;
    std::vector<Point> points;
    for (int i = 0; i < teeth; ++i) {
      points.push_back({double(i) / teeth, 0});
      points.push_back({(i + 0.4) / teeth + slant, 1});
    }
    for (const Point& p : {Point{1, -0.0001}, Point{1, -1}, Point{0, -1}}) points.push_back(p);
    Polygon comb;
    for (std::uint32_t i = 0; i < points.size(); ++i) comb.shell.points.push_back(i);
    INFO("slant ", slant);
    check_law(points, {comb});
  }
  rbpa_test::Random random(5);
  std::vector<Point> points = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}, {-0.5, 0}, {1.5, 1e-11}, {1.5, -1e-11}};
  Polygon plate{.shell = {{0, 1, 2, 3}}, .holes = {{{4, 5, 6}}}};
  for (int i = 0; i < 300; ++i) {  // small holes on both sides of the long one
    const double x = i / 300.0, y = (i % 2 == 0 ? 1 : -1) * random.between(1e-6, 2e-6);
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& p : {Point{x, y}, Point{x + 1e-3, y}, Point{x, 2 * y}}) points.push_back(p);
    plate.holes.push_back({{first, first + 1, first + 2}});
  }
  check_law(points, {plate});
}

TEST_CASE("without a size rings may touch, and polygons in points where several fans stand") {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {2, 3}, {0, 2},
                                     {1, 2}, {1, 3}, {6, 4}, {6, 6}, {8, 4}, {8, 6}, {4, 2}};
  const rbpa::Ring square{{0, 1, 2, 3}}, triangle{{4, 5, 6}};
  check_law(points, {{.shell = square, .holes = {triangle, {{7, 4, 9}}}}});  // on an edge, in a corner
  check_law(points, {{.shell = square}, {.shell = {{2, 10, 11}}}, {.shell = {{11, 12, 13}}}});  // a chain
  check_law(points, {{.shell = square}, {.shell = {{14, 10, 12}}}});                            // a corner on an edge
  check_law(points, {{.shell = {{0, 0, 1, 2, 2, 2, 3}}}});                                      // repeated
}

TEST_CASE("polygons that touch in points and share edges are triangulated") {
  // Two adjacent squares, and a triangle that touches both at their common corner, as rings, which
  // triangulate() requires.
  rbpa::Outline outline;
  outline.places = {{0, 0}, {0, 1}, {0.5, 2}, {1, 0}, {1, 1}, {1.5, 2}, {2, 0}, {2, 1}};
  outline.rings = {{.sites = {0, 3, 4, 1}}, {.sites = {3, 6, 7, 4}}, {.sites = {2, 4, 5}}};
  const auto triangles = rbpa::triangulate(outline, {});
  CHECK(triangles.size() == 5);
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Point &p = outline.places[a], &q = outline.places[b], &r = outline.places[c];
    area += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
  }
  CHECK(area == 2.5);
}

TEST_SUITE_END();
