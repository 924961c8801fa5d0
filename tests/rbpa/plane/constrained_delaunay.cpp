#include "rbpa/plane/constrained_delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/arguments.h"
#include "support/order.h"
#include "support/random.h"
#include "support/refusal_of.h"

TEST_SUITE_BEGIN("plane");

namespace {

using rbpa::ConstrainedDelaunay;
using rbpa::Point;
using rbpa::Segment;
using rbpa::Triangle;
using Points = std::vector<Point>;
using Segments = std::vector<Segment>;
using Predicates = rbpa::Predicates<long double>;

constexpr std::uint32_t none = rbpa::TriangleArrays::none;

bool is_on(const Point& p, const Point& a, const Point& b) {
  return Predicates::orientation(a, b, p) == 0 && std::min(a, b) <= p && p <= std::max(a, b);
}

/// Returns the parts of a segment between consecutive points on it.
std::set<std::pair<Point, Point>> parts_of(const Points& points, const Segment& segment) {
  std::set<Point> on;
  for (const Point& p : points)
    if (is_on(p, points[segment[0]], points[segment[1]])) on.insert(p);
  std::set<std::pair<Point, Point>> parts;
  for (auto p = on.begin(); std::next(p) != on.end(); ++p) parts.insert({*p, *std::next(p)});
  return parts;
}

/// Returns twice the area of the convex hull.
boost::multiprecision::cpp_rational hull_area(Points points) {
  std::sort(points.begin(), points.end());
  boost::multiprecision::cpp_rational area = 0;
  for (int half = 0; half < 2; ++half, std::reverse(points.begin(), points.end())) {
    Points chain;
    for (const Point& p : points) {
      while (chain.size() > 1 && Predicates::orientation(chain[chain.size() - 2], chain.back(), p) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      area += boost::multiprecision::cpp_rational(chain[i].x) * chain[i + 1].y -
              boost::multiprecision::cpp_rational(chain[i].y) * chain[i + 1].x;
  }
  return area;
}

/// Checks that `made` is the constrained Delaunay triangulation of its points. Triangles without a side that the circle
/// test would flip, whose areas make up the convex hull, are the only such triangulation.
void check_triangulation(const ConstrainedDelaunay& made) {
  CHECK_NOTHROW(rbpa::require_linked(made, made.points.size()));
  CHECK(std::is_sorted(made.triangles.begin(), made.triangles.end()));
  REQUIRE(made.constrained.size() == made.triangles.size());
  std::set<Segment> constrained;
  std::size_t turned = 0, illegal = 0, one_sided = 0;
  boost::multiprecision::cpp_rational area = 0;
  for (std::uint32_t t = 0; t < made.triangles.size(); ++t) {
    const Triangle& corner = made.triangles[t];
    const Point &a = made.points[corner[0]], &b = made.points[corner[1]], &c = made.points[corner[2]];
    turned += Predicates::orientation(a, b, c) <= 0 || corner[0] > std::min(corner[1], corner[2]);
    const boost::multiprecision::cpp_rational ax(a.x), ay(a.y);
    area += (b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corner[(k + 1) % 3], corner[(k + 2) % 3]);
      if (made.is_constrained(t, k)) constrained.insert({low, high});
      const std::uint32_t other = made.neighbors[t][k];
      if (other == none) continue;
      const auto& across = made.neighbors[other];
      const auto j = static_cast<std::uint32_t>(std::find(across.begin(), across.end(), t) - across.begin());
      one_sided += made.is_constrained(t, k) != made.is_constrained(other, j);
      illegal += !made.is_constrained(t, k) &&
                 Predicates::in_perturbed_circle(a, b, c, made.points[made.triangles[other][j]]) > 0;
    }
  }
  CHECK(turned == 0);
  CHECK(illegal == 0);
  CHECK(one_sided == 0);
  CHECK(area == hull_area(made.points));
  if (!made.triangles.empty()) CHECK(Segments(constrained.begin(), constrained.end()) == made.edges);
  std::set<Point> corners, distinct(made.points.begin(), made.points.end());
  for (const Triangle& triangle : made.triangles)
    for (const std::uint32_t i : triangle) corners.insert(made.points[i]);
  if (!made.triangles.empty()) CHECK(corners == distinct);
}

using Edges = std::set<std::pair<Point, Point>>;

Edges edges_of(const ConstrainedDelaunay& made) {
  Edges edges;
  for (const auto& [a, b] : made.edges) edges.insert(std::minmax(made.points[a], made.points[b]));
  return edges;
}

/// Checks a triangulation whose segments do not cross: its edges are exactly the parts of the segments.
void check_edges(const ConstrainedDelaunay& made, const Segments& segments) {
  Edges expected;
  for (const Segment& segment : segments) expected.merge(parts_of(made.points, segment));
  CHECK(edges_of(made) == expected);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return Predicates::orientation(a, b, c) * Predicates::orientation(a, b, d) < 0 &&
         Predicates::orientation(c, d, a) * Predicates::orientation(c, d, b) < 0;
}

/// Returns whether two of the segments cross where there is no point.
bool any_cross(const Points& points, const Segments& segments) {
  Edges parts;
  for (const Segment& segment : segments) parts.merge(parts_of(points, segment));
  for (const auto& [a, b] : parts)
    for (const auto& [c, d] : parts)
      if (cross(a, b, c, d)) return true;
  return false;
}

struct Case {
  Points points;
  Segments segments;
};

/// Returns points on a grid, some of them equal, and segments between them.
Case random_case(rbpa_test::Random& random, int side, int points, int segments, double unit = 1) {
  Case made;
  for (int i = 0; i < points; ++i)
    made.points.push_back({random.integer(0, side) * unit, random.integer(0, side) * unit});
  for (int i = 0; i < segments; ++i) {
    const auto a = static_cast<std::uint32_t>(random.below(made.points.size())),
               b = static_cast<std::uint32_t>(random.below(made.points.size()));
    if (made.points[a] != made.points[b]) made.segments.push_back({a, b});
  }
  return made;
}

/// Returns the triangles by the places of their corners.
std::set<std::array<Point, 3>> places_of(const ConstrainedDelaunay& made) {
  std::set<std::array<Point, 3>> places;
  for (const auto& [a, b, c] : made.triangles) {
    std::array<Point, 3> corners{made.points[a], made.points[b], made.points[c]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    places.insert(corners);
  }
  return places;
}

/// Returns the case with points and segments in another order, and segments in another direction.
Case shuffled(const Case& given, rbpa_test::Random& random) {
  const std::vector<std::uint32_t> order = random_order(given.points.size(), random);
  std::vector<std::uint32_t> place(given.points.size());
  Case made;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    made.points.push_back(given.points[order[i]]);
    place[order[i]] = i;
  }
  for (const auto& [a, b] : given.segments)
    made.segments.push_back(random.chance(0.5) ? Segment{place[a], place[b]} : Segment{place[b], place[a]});
  random.shuffle(made.segments);
  return made;
}

std::string refusal(const Case& of) {
  return rbpa_test::refusal_of<rbpa::InvalidInput>([&] { rbpa::constrained_delaunay(of.points, of.segments); });
}

}  // namespace

TEST_CASE("segments on small grids, which touch, overlap and repeat, become edges of the only such triangulation") {
  rbpa_test::Random random(1);
  const int trials = rbpa_test::all_trials() ? 100'000 : 10'000;
  int refused = 0, made = 0;
  for (int i = 0; i < trials; ++i) {
    const double unit = i % 10 != 0 ? 1 : i % 20 == 0 ? 0x1p330 : 0x1p-340;
    const Case of = random_case(random, random.integer(1, 7), random.integer(1, 14), random.integer(0, 6), unit);
    INFO("number ", i);
    const bool is_refused = !refusal(of).empty();
    REQUIRE(is_refused == any_cross(of.points, of.segments));
    if (is_refused) {
      ++refused;
      continue;
    }
    ++made;
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments);
    CHECK(found.points == of.points);
    CHECK(found.crossed.empty());
    check_triangulation(found);
    check_edges(found, of.segments);
  }
  CHECK(refused > trials / 10);
  CHECK(made > trials / 2);
}

TEST_CASE("crossings are split at the nearest doubles, and the parts are edges that do not cross") {
  rbpa_test::Random random(2);
  std::size_t added = 0, again = 0;
  for (int i = 0; i < (rbpa_test::all_trials() ? 40'000 : 4'000); ++i) {
    // With a unit of 2⁻⁵² at 1 nearly every crossing is rounded far from its segments.
    const bool is_fine = i % 4 == 0;
    Case of =
        random_case(random, random.integer(3, 12), random.integer(6, 24), random.integer(2, 12), is_fine ? 0x1p-52 : 1);
    if (is_fine)
      for (Point& p : of.points) p = {1 + p.x, 1 + p.y};
    INFO("number ", i);
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments, {.split_crossings = true});
    REQUIRE(found.points.size() - of.points.size() == found.crossed.size());
    check_triangulation(found);
    added += found.crossed.size();
    CHECK(std::is_sorted(found.points.begin() + static_cast<std::ptrdiff_t>(of.points.size()), found.points.end()));
    for (std::size_t k = 0; k < found.crossed.size(); ++k) {
      const Point& at = found.points[of.points.size() + k];
      for (const std::uint32_t s : found.crossed[k]) {
        const Point &a = of.points[of.segments[s][0]], &b = of.points[of.segments[s][1]];
        CHECK(std::min(a.x, b.x) <= at.x + 1e-14);
        CHECK(at.x <= std::max(a.x, b.x) + 1e-14);
      }
    }
    // Every end is joined with the other end of its segment by edges near the segment.
    const Edges edges = edges_of(found);
    for (const auto& [a, b] : edges)
      for (const auto& [c, d] : edges) CHECK(!cross(a, b, c, d));
    for (const auto& [from, to] : of.segments) {
      std::set<Point> reached = {of.points[from]};
      for (std::size_t before = 0; before < reached.size();) {
        before = reached.size();
        for (const auto& [a, b] : edges)
          if (reached.contains(a) || reached.contains(b)) reached.insert({a, b});
      }
      CHECK(reached.contains(of.points[to]));
    }
    const Case other = shuffled(of, random);
    const ConstrainedDelaunay same =
        rbpa::constrained_delaunay(other.points, other.segments, {.split_crossings = true});
    CHECK(places_of(same) == places_of(found));
    CHECK(edges_of(same) == edges);
    again += any_cross(found.points, of.segments);
  }
  CHECK(added > 5'000);
  CHECK(again > 500);  // bent by rounding
}

TEST_CASE("the triangles do not depend on the order of points and segments, or on the direction of segments") {
  rbpa_test::Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Case of = random_case(random, 9, 40, 4);
    if (!refusal(of).empty()) continue;
    const Case other = shuffled(of, random);
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments),
                              same = rbpa::constrained_delaunay(other.points, other.segments);
    CHECK(places_of(found) == places_of(same));
    CHECK(edges_of(found) == edges_of(same));
  }
}

TEST_CASE("long segments through many points, at any magnitude, become edges") {
  rbpa_test::Random random(4);
  for (const double scale : {1.0, 0x1p-700, 0x1p600}) {
    Case of;
    for (int i = 0; i < 3'000; ++i)
      of.points.push_back({random.between(0, 100) * scale, random.between(0, 100) * scale});
    for (int i = 0; i < 30; ++i) {  // a comb of nearly parallel segments
      of.points.push_back({(3 * i + 0.1) * scale, -1 * scale});
      of.points.push_back({(3 * i + 7.3) * scale, 101 * scale});
      const auto n = static_cast<std::uint32_t>(of.points.size());
      of.segments.push_back({n - 2, n - 1});
    }
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments);
    check_triangulation(found);
    CHECK(found.edges.size() == of.segments.size());
    CHECK(rbpa::regions(found).is_inside == std::vector<bool>(31, false));
  }
}

TEST_CASE("points on one line have edges on segments, and no triangle") {
  const Points points = {{3, 3}, {0, 0}, {1, 1}, {2, 2}, {1, 1}, {5, 5}};
  const ConstrainedDelaunay found = rbpa::constrained_delaunay(points, Segments{{0, 4}, {3, 2}, {1, 1 + 3}});
  CHECK(found.triangles.empty());
  CHECK(found.edges == Segments{{0, 3}, {1, 2}, {2, 3}});
  CHECK(found.duplicates == std::vector<rbpa::Duplicate>{{4, 2}});
  CHECK(rbpa::constrained_delaunay({}, {}).edges.empty());
  CHECK(rbpa::constrained_delaunay(Points{{1, 2}}, {}).edges.empty());
}

TEST_CASE("regions are numbered by their first triangles, and are inside by the even-odd rule") {
  const auto area_inside = [](const Points& points, const Segments& segments, bool splits = false) {
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(points, segments, {.split_crossings = splits});
    check_triangulation(found);
    const rbpa::SegmentRegions regions = rbpa::regions(found);
    std::uint32_t next = 0;
    double area = 0;
    for (std::size_t t = 0; t < found.triangles.size(); ++t) {
      CHECK(regions.region[t] <= next);
      if (regions.region[t] == next) ++next;
      const auto& [a, b, c] = found.triangles[t];
      const Point &p = found.points[a], &q = found.points[b], &r = found.points[c];
      if (regions.is_inside[regions.region[t]]) area += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    CHECK(next == regions.is_inside.size());
    return area / 2;
  };
  // A square, a square in it that touches it in a corner, and an open line.
  CHECK(area_inside({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 2}, {6, 4}, {8, 8}, {2, 4}, {-4, 4}, {-2, 6}, {12, 4}},
                    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {8, 9}}) == 64 - 12);
  // A chord, which divides the square in two.
  CHECK(area_inside({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}) == 4);
  Points points;
  Segments segments;
  const auto add = [&](double x, double y, double width) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& p : {Point{x, y}, {x + width, y}, {x + width, y + width}, {x, y + width}}) points.push_back(p);
    for (std::uint32_t k = 0; k < 4; ++k) segments.push_back({first + k, first + (k + 1) % 4});
  };
  for (int i = 0; i < 9; ++i) add(i % 3, i / 3, 1);  // side by side
  CHECK(area_inside(points, segments) == 9);
  CHECK(area_inside(points, segments, true) == 9);
  add(1, 1, 1);  // the middle one once more
  CHECK(area_inside(points, segments) == 8);
  CHECK(area_inside(points, segments, true) == 8);
  add(0.5, 0.5, 2);  // crosses all but the middle one
  CHECK(area_inside(points, segments, true) == 9 - 4 + 1);
}

TEST_CASE("crossings of nearly parallel segments are split in few rounds") {
  const Point p{0.9999999999999991, 0.9999999999999991};
  const std::vector<Case> cases = {
      {{{-0.8660254037844387, 0.4999999999999997},
        {-1.0, 1.2246467991473532e-16},
        {3.3306690738754696e-16, 1.0},
        {-1.0000000000000002, 1.1102230246251565e-16},
        {-0.7071067811865467, 0.7071067811865485}},
       {{0, 1}, {2, 3}, {4, 1}}},
      {{{0, 1}, p, {8.881784197001252e-16, 1}, {1.0000000000000009, 0.9999999999999982}}, {{0, 1}, {2, 1}, {2, 3}}}};
  for (const Case& of : cases) {
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments, {.split_crossings = true});
    check_triangulation(found);
    CHECK(found.crossed.size() < 10);
  }
  // Chords of polygons on one circle, whose corners and crossings are nearly equal.
  rbpa_test::Random random(6);
  std::size_t added = 0;
  for (int i = 0; i < 300; ++i) {
    Case of;
    for (int k = 0; k < 4; ++k) {
      const int corners = random.integer(3, 12), shift = random.integer(0, 3), leap = random.integer(1, 4);
      const auto first = static_cast<std::uint32_t>(of.points.size()), n = static_cast<std::uint32_t>(corners);
      for (int c = 0; c < corners; ++c) {
        const double angle = 3.14159265358979323846 * (2 * c + shift) / corners;
        of.points.push_back({std::cos(angle), std::sin(angle)});
      }
      for (std::uint32_t c = 0; c < n; ++c)
        if (const std::uint32_t to = (c + static_cast<std::uint32_t>(leap)) % n;
            of.points[first + c] != of.points[first + to])
          of.segments.push_back({first + c, first + to});
    }
    const ConstrainedDelaunay found = rbpa::constrained_delaunay(of.points, of.segments, {.split_crossings = true});
    check_triangulation(found);
    added += found.crossed.size();
  }
  CHECK(added > 1'000);
}

TEST_CASE("wrong segments are refused with their numbers and places") {
  const Points points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}, {0, 0}};
  CHECK(refusal({points, {{0, 1}, {0, 5}}}) == "segment 1: found point 5, expected one of 5");
  CHECK(refusal({points, {{0, 4}}}) == "segment 0 from (0, 0) to (0, 0): found no length, expected ends at two places");
  CHECK(refusal({points, {{2, 3}, {1, 0}}}) ==
        "segment 0 from (0, 2) to (2, 0) and segment 1 from (2, 2) to (0, 0): found a crossing, expected segments that "
        "meet in points (split_crossings splits them)");
  CHECK(refusal({{{0, 0}, {NAN, 1}}, {{0, 1}}}).find("point 1") != std::string::npos);
  std::size_t calls = 0;
  const auto stop = [&](const rbpa::Progress&) { return ++calls < 2; };
  rbpa_test::Random random(5);
  const Case of = random_case(random, 1'000'000, 30'000, 0);
  CHECK_THROWS_AS(rbpa::constrained_delaunay(of.points, of.segments, {.progress = stop}), rbpa::Cancelled);
}

TEST_SUITE_END();
