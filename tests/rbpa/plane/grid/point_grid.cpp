#include "rbpa/plane/grid/point_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/arguments.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::PointGrid;

TEST_SUITE_BEGIN("search");

namespace {

struct Set {
  std::string name;
  Points points;
};

Points on_a_segment(double dx, double dy, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({dx * i, dy * i});
  return points;
}

/// Returns points each of which is half as far from the corner as the one before.
Points geometric(int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({std::ldexp(1.0, -i), std::ldexp(i % 3, -i)});
  return points;
}

/// Returns points of which a few are far away in all directions.
Points with_far_points() {
  Points points = uniform(300, 7);
  for (const Point& p : {Point{0x1p140, 3}, Point{-0x1p149, 0x1p120}, Point{5, -0x1p145}}) points.push_back(p);
  return points;
}

std::vector<Set> sets() {
  return {{"nothing", {}},
          {"one point", {{3, -4}}},
          {"two points", {{3, -4}, {3.5, 1e3}}},
          {"one point many times", Points(200, Point{0.1, 0.2})},
          {"uniform", uniform(400, 1)},
          {"grid", perfect_grid(15, 1)},
          {"clusters", clusters(60, 2)},
          {"horizontal", on_a_segment(0.3, 0, 150)},
          {"vertical", on_a_segment(0, 1e-3, 150)},
          {"slanted", on_a_segment(1, 1e-7, 150)},
          {"geometric", geometric(120)},
          {"offset", moved(scaled(uniform(300, 3), -10), 1e6, -1e6)},
          {"duplicates", duplicates(60, 9, 4)},
          {"lidar", lidar_lines(4, 60, 5)},
          {"large", scaled(uniform(200, 6), 140)},
          {"wide", with_far_points()}};
}

/// Returns a point of the set, or one near it.
Point near(const Points& points, Random& random) {
  const Point p = points[random.below(points.size())];
  if (random.chance(0.5)) return p;
  const Point q = points[random.below(points.size())];
  const double t = std::ldexp(random.unit(), -random.integer(0, 30));
  return {p.x + t * (q.x / 2 - p.x / 2), p.y + t * (q.y / 2 - p.y / 2)};
}

/// Returns the first site inside the box that the scan did not reach, as text; "" when there is none.
std::string missed(const PointGrid& grid, const rbpa::Box& box) {
  const auto& points = grid.points();
  std::vector<int> visits(points.size(), 0);
  grid.scan(box, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) ++visits.at(i);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (visits[i] > 1) return "site " + std::to_string(i) + " twice";
    if (visits[i] == 0 && p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y)
      return "site " + std::to_string(i);
  }
  return "";
}

void check_scans(const Set& set, int trials) {
  CAPTURE(set.name);
  const PointGrid grid(set.points);
  CHECK(missed(grid, {{-1e300, -1e300}, {1e300, 1e300}}) == "");
  if (set.points.empty()) return;
  Random random(41);
  for (int trial = 0; trial < trials; ++trial) {
    CAPTURE(trial);
    const Point a = near(set.points, random), b = random.chance(0.1) ? a : near(set.points, random);
    CHECK(missed(grid, {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}}) == "");
  }
}

void check_bookkeeping(const Set& set) {
  CAPTURE(set.name);
  const PointGrid grid(set.points);
  std::map<Point, std::uint32_t> lowest;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> repetitions, expected;
  for (std::uint32_t i = 0; i < set.points.size(); ++i) {
    const auto [first, is_new] = lowest.try_emplace(set.points[i], i);
    if (!is_new) expected.emplace_back(i, first->second);
  }
  for (const auto& r : grid.duplicates()) repetitions.emplace_back(r.index, r.stands_for);
  CHECK(repetitions == expected);
  REQUIRE(grid.points().size() == lowest.size());
  REQUIRE(grid.input_index().size() == lowest.size());
  for (std::size_t s = 0; s < grid.points().size(); ++s) {
    const Point p = grid.points()[s];
    REQUIRE(lowest.count(p) == 1);
    CHECK(grid.input_index()[s] == lowest[p]);
    // The first one of −0 and +0 in the input is kept.
    const Point given = set.points[lowest[p]];
    CHECK(std::signbit(p.x) == std::signbit(given.x));
    CHECK(std::signbit(p.y) == std::signbit(given.y));
    lowest.erase(p);
  }
}

}  // namespace

TEST_CASE("a scan reaches every point of a box once") {
  for (const Set& set : sets()) check_scans(set, 90);
}

TEST_CASE("sites are the distinct points, each with its lowest input index") {
  for (const Set& set : sets()) check_bookkeeping(set);
}

TEST_CASE("no two points are farther apart than the bound of the diameter") {
  for (const Set& set : sets()) {
    CAPTURE(set.name);
    const PointGrid grid(set.points);
    Random random(42);
    for (int trial = 0; trial < trials(200) && !set.points.empty(); ++trial) {
      const Point p = set.points[random.below(set.points.size())], q = set.points[random.below(set.points.size())];
      CHECK(std::hypot(static_cast<long double>(p.x) - q.x, static_cast<long double>(p.y) - q.y) <=
            grid.diameter_bound());
    }
  }
}

TEST_SUITE_END();
