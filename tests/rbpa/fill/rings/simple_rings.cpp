#include "rbpa/fill/rings/simple_rings.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill/polygons_of_rings.h"
#include "support/generate_polygons.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;

/// Returns the side of c. Coordinates are integers, so that doubles are exact.
int side(const Point& a, const Point& b, const Point& c) {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (area > 0) - (area < 0);
}

bool is_on(const Point& p, const Point& a, const Point& b) {
  return side(a, b, p) == 0 && std::min(a, b) <= p && p <= std::max(a, b);
}

bool have_common_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  return (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) || is_on(c, a, b) || is_on(d, a, b) ||
         is_on(a, c, d) || is_on(b, c, d);
}

std::vector<Ring> rings_of(const rbpa_test::PolygonCase& made) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : made.polygons) rings.push_back(polygon.shell);
  return rings;
}

/// Returns whether rings meet, by all pairs of edges.
bool meet(const std::vector<Point>& points, const std::vector<Ring>& rings) {
  struct Edge {
    Point a, b;
    std::size_t ring, number;
  };
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].points.size(); ++i)
      edges.push_back({points[rings[r].points[i]], points[rings[r].points[(i + 1) % rings[r].points.size()]], r, i});
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].a == edges[i].b) return true;
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const std::size_t n = rings[e.ring].points.size();
      const bool f_follows = e.ring == f.ring && f.number == (e.number + 1) % n;
      const bool e_follows = e.ring == f.ring && e.number == (f.number + 1) % n;
      if (f_follows && e_follows) return true;
      if (f_follows   ? is_on(f.b, e.a, e.b) || is_on(e.a, f.a, f.b)
          : e_follows ? is_on(e.b, f.a, f.b) || is_on(f.a, e.a, e.b)
                      : have_common_point(e.a, e.b, f.a, f.b))
        return true;
    }
  }
  return false;
}

/// Returns whether `inner` is inside, by the parity of the edges above its first point.
bool is_inside(const std::vector<Point>& points, const Ring& inner, const Ring& outer) {
  const Point& p = points[inner.points[0]];
  bool inside = false;
  for (std::size_t i = 0; i < outer.points.size(); ++i) {
    const Point &a = points[outer.points[i]], &b = points[outer.points[(i + 1) % outer.points.size()]];
    if ((a.x <= p.x) != (b.x <= p.x) && side(std::min(a, b), std::max(a, b), p) < 0) inside = !inside;
  }
  return inside;
}

}  // namespace

TEST_CASE("rings meet exactly where two of their edges do") {
  rbpa_test::Random random(1);
  std::size_t apart = 0;
  for (int i = 0; i < 6000; ++i) {
    const int side_length = random.integer(2, 12);
    const auto made = rbpa_test::random_rings(random, random.integer(1, 3), random.integer(3, 8), side_length);
    const std::vector<Ring> rings = rings_of(made);
    const rbpa::NestedRings nested = rbpa::nest_rings(made.points, rings);
    INFO("number ", i, nested.meet ? ": they meet" : "");
    REQUIRE(nested.meet.has_value() == meet(made.points, rings));
    if (nested.meet) continue;
    ++apart;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      std::size_t around = 0;
      double area = 0;
      for (std::size_t other = 0; other < rings.size(); ++other)
        around += other != r && is_inside(made.points, rings[r], rings[other]);
      for (std::size_t k = 0; k < rings[r].points.size(); ++k) {
        const Point& a = made.points[rings[r].points[k]];
        const Point& b = made.points[rings[r].points[(k + 1) % rings[r].points.size()]];
        area += a.x * b.y - a.y * b.x;
      }
      CHECK(nested.place[r].depth == around);
      CHECK(nested.place[r].is_counter_clockwise == (area > 0));
      if (nested.place[r].inside) CHECK(is_inside(made.points, rings[r], rings[*nested.place[r].inside]));
    }
  }
  CHECK(apart > 500);
}

TEST_CASE("rings of even depth are shells and rings of odd depth holes, each in the smallest ring around it") {
  std::vector<Point> points;
  std::vector<Ring> rings;
  const auto add = [&](double center, double half, bool turned) {
    Ring ring;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      ring.points.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({center + half * x, half * y});
    }
    if (turned) std::reverse(ring.points.begin(), ring.points.end());
    rings.push_back(ring);
  };
  add(0, 1, true);    // an island
  add(0, 10, true);   // a shell
  add(0, 2, false);   // a hole in it
  add(6, 1, false);   // another
  add(20, 1, false);  // a shell beside
  add(0, 0.5, true);  // a hole in the island
  const std::vector<Polygon> polygons = rbpa::polygons_of_rings(points, rings);
  REQUIRE(polygons.size() == 3);
  CHECK(polygons[0].area == 3);
  CHECK(polygons[1].area == 400 - 16 - 4);
  CHECK(polygons[2].area == 4);
  CHECK(polygons[1].holes.size() == 2);

  const std::vector<Point> in_holes = {{1.5, 0}, {6, 0.5}, {0, 0.25}, {6.5, 0}};
  CHECK(rbpa::polygons_of_rings(points, rings, in_holes).size() == 3);
  const auto refused = [&](const std::vector<Point>& marks) {
    try {
      rbpa::polygons_of_rings(points, rings, marks);
    } catch (const rbpa::InvalidInput& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(refused({{1.5, 0}, {0, 0.25}}).find("the ring through (5, -1)") != std::string::npos);
  CHECK(refused({{1.5, 0}, {6, 0.5}, {0, 0.25}, {0.75, 0}}).find("hole point 3 at (0.75, 0)") != std::string::npos);
  CHECK(refused({{1.5, 0}, {6, 0.5}, {0, 0.25}, {50, 0}}).find("hole point 3 at (50, 0)") != std::string::npos);

  // Rings may begin anywhere.
  for (int turn = 1; turn < 4; ++turn) {
    CAPTURE(turn);
    for (Ring& ring : rings) std::rotate(ring.points.begin(), ring.points.begin() + 1, ring.points.end());
    const std::vector<Polygon> same = rbpa::polygons_of_rings(points, rings, in_holes);
    REQUIRE(same.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(same[i].area == polygons[i].area);
      CHECK(same[i].holes.size() == polygons[i].holes.size());
    }
    CHECK(refused({{1.5, 0}, {0, 0.25}}).find("the ring through ") != std::string::npos);
    CHECK(refused({{1.5, 0}, {6, 0.5}, {0, 0.25}, {0.75, 0}}).find("hole point 3 at (0.75, 0)") != std::string::npos);
  }
}

TEST_CASE("a ring around a hole may repeat a point") {
  const std::vector<Point> points = {{-4, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}, {2, 1}, {0, 2}, {0, 2}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    CAPTURE(turn);
    std::vector<Ring> rings = {{{0, 1, 2, 3}}, {{4, 5, 6, 7}}};
    for (Ring& ring : rings)
      std::rotate(ring.points.begin(), ring.points.begin() + static_cast<std::ptrdiff_t>(turn), ring.points.end());
    const std::vector<Polygon> polygons = rbpa::polygons_of_rings(points, rings, std::vector<Point>{{1, 1.25}});
    REQUIRE(polygons.size() == 1);
    CHECK(polygons[0].holes.size() == 1);
    CHECK(polygons[0].area == 18 - 0.5);
    CHECK_THROWS_AS(rbpa::polygons_of_rings(points, rings, std::vector<Point>{{0, 2}, {2, 1.5}}), rbpa::InvalidInput);
  }
}

TEST_SUITE_END();
