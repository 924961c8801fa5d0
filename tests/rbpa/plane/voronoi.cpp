#include "rbpa/plane/voronoi.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "support/data_folder.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/sets.h"

TEST_SUITE_BEGIN("plane");

namespace {

using rbpa::Point;
using rbpa::Voronoi;
using rbpa_test::Points;
using Exact = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Exact x, y;
  friend bool operator<(const ExactPoint& a, const ExactPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// Returns the point with equal powers |z|² − 2 p · z, of three points: by Cramer's rule.
ExactPoint exact_center(const Point& a, const Point& b, const Point& c) {
  const auto square = [](const Point& p) -> Exact { return Exact(p.x) * Exact(p.x) + Exact(p.y) * Exact(p.y); };
  const Exact bx = 2 * (Exact(b.x) - Exact(a.x)), by = 2 * (Exact(b.y) - Exact(a.y)),
              cx = 2 * (Exact(c.x) - Exact(a.x)), cy = 2 * (Exact(c.y) - Exact(a.y)), bs = square(b) - square(a),
              cs = square(c) - square(a);
  const Exact determinant = bx * cy - by * cx;
  return {Exact((bs * cy - cs * by) / determinant), Exact((bx * cs - cx * bs) / determinant)};
}

/// Returns whether no double is nearer to `exact` than `rounded`, and `rounded` is even if another is as near.
bool is_nearest(double rounded, const Exact& exact) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Exact beyond = Exact(std::numeric_limits<double>::max()) + Exact(0x1p970);
  if (std::isinf(rounded)) return rounded > 0 ? exact >= beyond : exact <= -beyond;
  if (abs(exact) >= beyond) return false;
  const Exact error = abs(exact - Exact(rounded));
  const bool is_even =
      std::fmod(std::scalbn(std::abs(rounded), 52 - std::max(std::ilogb(rounded == 0 ? 1 : rounded), -1022)), 2) == 0;
  for (const double end : {infinity, -infinity}) {
    const double other = std::nextafter(rounded, end);
    if (std::isinf(other)) continue;
    const Exact of_other = abs(exact - Exact(other));
    if (of_other < error || (of_other == error && !is_even)) return false;
  }
  return true;
}

/// Returns the first violated law of a diagram, "" when there is none.
std::string wrong_with(const Voronoi& made, const Points& points) {
  const rbpa::Delaunay delaunay(points);
  const rbpa::AlphaComplex& complex = delaunay.triangulation();
  std::set<ExactPoint> centers;
  for (const auto& [a, b, c] : complex.triangles) centers.insert(exact_center(points[a], points[b], points[c]));
  if (made.vertices.size() != centers.size()) return "not one vertex for each circle";
  for (const auto& [a, b, c] : complex.triangles) {
    const ExactPoint center = exact_center(points[a], points[b], points[c]);
    const auto region = made.region(made.point_region[a]);
    if (std::none_of(region.begin(), region.end(), [&](std::int32_t v) {
          if (v == Voronoi::infinity) return false;
          const Point& p = made.vertices[static_cast<std::size_t>(v)];
          return is_nearest(p.x, center.x) && is_nearest(p.y, center.y);
        }))
      return "a circumcenter is not a vertex of the region";
  }
  if (made.regions() != complex.distinct) return "not one region for each distinct point";
  std::size_t unbounded = 0;
  for (std::size_t r = 0; r < made.regions(); ++r)
    unbounded += static_cast<std::size_t>(made.region(r).back() == Voronoi::infinity);
  if (!complex.triangles.empty()) {
    if (made.vertices.size() + made.regions() != made.ridge_points.size() + 1) return "Euler's formula";
    if (made.region_vertices.size() != 2 * made.ridge_points.size()) return "regions have another number of ridges";
  }
  if (unbounded != (complex.triangles.empty() ? complex.distinct : complex.isolated.size() + unbounded))
    return "bounded";
  for (const auto& [duplicate, first] : complex.duplicates)
    if (made.point_region[duplicate] != made.point_region[first]) return "a duplicate has another region";
  // Each ridge is passed by both regions, in opposite directions.
  auto direction = made.unbounded.begin();
  for (std::size_t r = 0; r < made.ridge_points.size(); ++r) {
    const auto [from, to] = made.ridge_vertices[r];
    if (from == Voronoi::infinity) {
      if (direction == made.unbounded.end() || direction->ridge != r) return "an unbounded ridge without a direction";
      if (std::abs(std::hypot(direction->direction.x, direction->direction.y) - 1) >= 1e-15) return "a direction";
      ++direction;
    }
    if (complex.triangles.empty()) continue;
    std::array<int, 2> times = {};
    for (const std::uint32_t p : made.ridge_points[r]) {
      const auto region = made.region(made.point_region[p]);
      for (std::size_t i = 0; i < region.size(); ++i) {
        const std::int32_t a = region[i], b = region[(i + 1) % region.size()];
        times[0] += static_cast<int>(a == from && b == to);
        times[1] += static_cast<int>(a == to && b == from);
      }
    }
    if (times != std::array{1, 1} && !(from == Voronoi::infinity && times[0] > 0 && times[1] > 0))
      return "a ridge is not on two regions";
  }
  if (direction != made.unbounded.end()) return "a direction of a bounded ridge";
  return "";
}

/// Returns the pairs of distinct points whose cells have more than a point in common, by definition: on the bisector of
/// a pair, each other point leaves a half-line of the places that are not nearer to it.
std::set<std::array<std::uint32_t, 2>> ridges_by_definition(const Points& points) {
  std::set<std::array<std::uint32_t, 2>> ridges;
  const auto is_first = [&](std::uint32_t p) {
    return std::find(points.begin(), points.end(), points[p]) - points.begin() == static_cast<std::ptrdiff_t>(p);
  };
  for (std::uint32_t q = 0; q < points.size(); ++q)
    for (std::uint32_t p = 0; p < q; ++p) {
      if (!is_first(p) || !is_first(q)) continue;
      const Exact mx = (Exact(points[p].x) + Exact(points[q].x)) / 2,
                  my = (Exact(points[p].y) + Exact(points[q].y)) / 2;
      const Exact nx = Exact(points[q].y) - Exact(points[p].y), ny = Exact(points[p].x) - Exact(points[q].x);
      bool has_low = false, has_high = false, is_empty = false;
      Exact low, high;
      for (const Point& r : points) {
        if (r == points[p] || r == points[q]) continue;
        // |m + s n − r|² ≥ |m + s n − p|²: a s ≤ b.
        const auto square = [&](const Point& z) -> Exact {
          return (mx - Exact(z.x)) * (mx - Exact(z.x)) + (my - Exact(z.y)) * (my - Exact(z.y));
        };
        const Exact a = 2 * (nx * (Exact(r.x) - Exact(points[p].x)) + ny * (Exact(r.y) - Exact(points[p].y)));
        const Exact b = square(r) - square(points[p]);
        if (a == 0) {
          is_empty = is_empty || b < 0;
        } else if (a > 0) {
          high = has_high ? std::min(high, Exact(b / a)) : Exact(b / a);
          has_high = true;
        } else {
          low = has_low ? std::max(low, Exact(b / a)) : Exact(b / a);
          has_low = true;
        }
      }
      if (!is_empty && !(has_low && has_high && low >= high)) ridges.insert({p, q});
    }
  return ridges;
}

}  // namespace

TEST_CASE("the Voronoi diagram of a few points on lattices has the ridges of its definition") {
  rbpa_test::Random random(7);
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    Points points;
    const std::uint64_t side = 1 + random.below(6);
    const double unit = std::array{1.0, 0.1, 1e-100, 1e100, 0x1p-1074}[random.below(5)];
    for (std::uint64_t i = 0, count = 1 + random.below(10); i < count; ++i)
      points.push_back(
          {unit * static_cast<double>(random.below(side)), unit * static_cast<double>(random.below(side))});
    const Voronoi made = rbpa::voronoi(rbpa::Delaunay(points));
    CHECK(wrong_with(made, points) == "");
    const auto expected = ridges_by_definition(points);
    CHECK(std::vector(expected.begin(), expected.end()) == made.ridge_points);
  }
}

TEST_CASE(
    "the Voronoi diagrams of generated and bundled sets are the dual of Delaunay, with correctly rounded vertices") {
  const auto check = [](const Points& all) {
    const Points points(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(all.size(), 100)));
    const Voronoi made = rbpa::voronoi(rbpa::Delaunay(points));
    CHECK(wrong_with(made, points) == "");
    const Points backwards(points.rbegin(), points.rend());
    Points vertices = made.vertices, others = rbpa::voronoi(rbpa::Delaunay(backwards)).vertices;
    std::sort(vertices.begin(), vertices.end());
    std::sort(others.begin(), others.end());
    CHECK(vertices == others);
  };
  for (const auto& set : rbpa_test::generated_sets()) {
    CAPTURE(set.name);
    check(set.make());
  }
  for (const auto& file : rbpa_test::point_files(rbpa_test::bundled_data())) {
    CAPTURE(file.name);
    check(rbpa_test::read_points(file));
  }
}

TEST_CASE("a cell with few or many neighbors has all of them, in order, inside and on the hull") {
  rbpa_test::Random random(3);
  for (const double turn : {6.2, 3.1})  // around the point, and on one side of it
    for (const int neighbors : {3, 23, 24, 25, 26, 60}) {
      CAPTURE(turn);
      CAPTURE(neighbors);
      Points points = {{0, 0}};
      for (int i = 0; i < neighbors; ++i) {
        const double angle = turn * (i + random.between(0, 0.3)) / neighbors;
        points.push_back({std::cos(angle), std::sin(angle)});
      }
      random.shuffle(points);
      const Voronoi made = rbpa::voronoi(rbpa::Delaunay(points));
      CHECK(wrong_with(made, points) == "");
      const auto hub = static_cast<std::size_t>(std::find(points.begin(), points.end(), Point{0, 0}) - points.begin());
      CHECK(made.region(made.point_region[hub]).size() + 1 >= static_cast<std::size_t>(neighbors));
    }
}
