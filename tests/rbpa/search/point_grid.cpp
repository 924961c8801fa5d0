#include "rbpa/search/point_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Region;

TEST_SUITE_BEGIN("search");

namespace {

struct Set {
  std::string name;
  Points points;
  bool fits_double = true;
};

Points on_a_segment(double dx, double dy, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({dx * i, dy * i});
  return points;
}

/// Every point half as far from the corner as the one before.
Points geometric(int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({std::ldexp(1.0, -i), std::ldexp(i % 3, -i)});
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
          {"huge", scaled(uniform(200, 6), 990), false},
          {"mixed exponents", mixed_exponents(60, 7), false},
          {"denormals", denormals(12, 100, 8), false},
          {"corners of range", corners_of_range(), false},
          {"far and tiny", far_and_tiny(60, 9), false}};
}

/// A point of the set, or one near it.
Point near(const Points& points, Random& random) {
  const Point p = points[random.below(points.size())];
  if (random.chance(0.5)) return p;
  const Point q = points[random.below(points.size())];
  const double t = std::ldexp(random.unit(), -random.integer(0, 30));
  return {p.x + t * (q.x / 2 - p.x / 2), p.y + t * (q.y / 2 - p.y / 2)};
}

/// A distance of any order that occurs.
double some_distance(const Points& points, Random& random) {
  const Point p = points[random.below(points.size())], q = points[random.below(points.size())];
  const double d = std::min(std::max(std::abs(p.x / 2 - q.x / 2), std::abs(p.y / 2 - q.y / 2)), 1e307);
  return random.chance(0.5) ? d : std::ldexp(d, random.integer(-30, 2));
}

/// The first site that is truly inside and that the scan did not reach, as text; "" when there is none.
template <typename Real, typename Inside>
std::string missed(const PointGrid<Real>& grid, const Region<Real>& region, Inside inside) {
  const auto& points = grid.points();
  std::vector<int> visits(points.size(), 0);
  grid.scan(region, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) ++visits.at(i);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (visits[i] > 1) return "site " + std::to_string(i) + " twice";
    if (visits[i] == 0 && inside(points[i])) return "site " + std::to_string(i);
  }
  return "";
}

template <typename Real>
void check_scans(const Set& set, int trials) {
  CAPTURE(set.name);
  const PointGrid<Real> grid(set.points);
  const auto everything = [](const Point&) { return true; };
  CHECK(missed(grid, Region<Real>(), everything) == "");
  if (set.points.empty()) return;
  Random random(41);
  for (int trial = 0; trial < trials; ++trial) {
    CAPTURE(trial);
    const Point c = near(set.points, random);
    const double radius = random.chance(0.05) ? 0.0 : some_distance(set.points, random);
    const auto disc = Region<Real>::disc({Real(c.x), Real(c.y)}, Real(radius));
    CHECK(missed(grid, disc, [&](const Point& p) { return exact::in_disc(c, radius, p); }) == "");

    const Point a = near(set.points, random), b = near(set.points, random);
    if (a != b) {
      double k = std::ldexp(random.between(-1, 1), random.integer(-20, 20));
      if (random.chance(0.1)) k = 0;
      if (random.chance(0.1)) k = std::numeric_limits<double>::infinity();
      if (random.chance(0.1)) k = std::ldexp(random.unit(), random.integer(20, 300));
      CAPTURE(k);
      const auto segment = Region<Real>::segment(a, b, Real(k));
      CHECK(missed(grid, segment, [&](const Point& p) { return exact::in_segment(a, b, k, p); }) == "");
    }

    // A sector, as the roll uses it: a disc and two cuts through its centre, or through other points.
    double direction[4];
    for (double& d : direction) d = random.chance(0.1) ? 0.0 : std::ldexp(random.between(-1, 1), random.integer(-30, 3));
    const Point second = random.chance(0.5) ? c : near(set.points, random);
    auto sector = disc;
    sector.keep_left(c, {Real(direction[0]), Real(direction[1])});
    sector.keep_left(second, {Real(direction[2]), Real(direction[3])});
    CHECK(missed(grid, sector, [&](const Point& p) {
            return exact::not_right_of(c, direction[0], direction[1], p) &&
                   exact::not_right_of(second, direction[2], direction[3], p) && exact::in_disc(c, radius, p);
          }) == "");
  }
}

template <typename Real>
void check_bookkeeping(const Set& set) {
  CAPTURE(set.name);
  const PointGrid<Real> grid(set.points);
  std::map<Point, std::uint32_t> lowest;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> repetitions, expected;
  for (std::uint32_t i = 0; i < set.points.size(); ++i) {
    const auto [first, is_new] = lowest.try_emplace(set.points[i], i);
    if (!is_new) expected.emplace_back(i, first->second);
  }
  for (const auto& r : grid.repetitions()) repetitions.emplace_back(r.index, r.stands_for);
  CHECK(repetitions == expected);
  REQUIRE(grid.points().size() == lowest.size());
  REQUIRE(grid.input_index().size() == lowest.size());
  for (std::size_t s = 0; s < grid.points().size(); ++s) {
    const Point p = grid.points()[s];
    REQUIRE(lowest.count(p) == 1);
    CHECK(grid.input_index()[s] == lowest[p]);
    // Of −0 and +0 the one that came first is kept.
    const Point given = set.points[lowest[p]];
    CHECK(std::signbit(p.x) == std::signbit(given.x));
    CHECK(std::signbit(p.y) == std::signbit(given.y));
    lowest.erase(p);
  }
}

}  // namespace

TEST_CASE("a scan reaches every point of the region, and none twice") {
  for (const Set& set : sets()) {
    if (set.fits_double) check_scans<double>(set, 60);
    check_scans<long double>(set, set.fits_double ? 30 : 20);
  }
}

TEST_CASE("sites are the distinct points, each with its lowest input index") {
  for (const Set& set : sets()) {
    if (set.fits_double) check_bookkeeping<double>(set);
    check_bookkeeping<long double>(set);
  }
}

TEST_CASE("no two points are farther apart than the diameter bound") {
  for (const Set& set : sets()) {
    CAPTURE(set.name);
    const PointGrid<long double> grid(set.points);
    Random random(42);
    for (int trial = 0; trial < 200 && !set.points.empty(); ++trial) {
      const Point p = set.points[random.below(set.points.size())], q = set.points[random.below(set.points.size())];
      CHECK(std::hypot(static_cast<long double>(p.x) - q.x, static_cast<long double>(p.y) - q.y) <= grid.diameter_bound());
    }
  }
}

TEST_SUITE_END();
