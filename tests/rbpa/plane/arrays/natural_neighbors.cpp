// Natural neighbor interpolation, compared with Voronoi cells that are cut out of the plane one half-plane at a time.
#include "rbpa/plane/arrays/natural_neighbors.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/locate.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::Interpolation;
using rbpa::Point;

TEST_SUITE_BEGIN("locate");

namespace {

/// Returns the part of a convex polygon that is nearer to a than to b.
Points nearer(const Points& polygon, const Point& a, const Point& b) {
  const auto side = [&](const Point& p) {
    return (p.x - (a.x + b.x) / 2) * (a.x - b.x) + (p.y - (a.y + b.y) / 2) * (a.y - b.y);
  };
  Points kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = side(p), at_q = side(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p >= 0) != (at_q >= 0)) {
      const double t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

double area(const Points& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point &o = polygon[0], &p = polygon[i], &q = polygon[i + 1];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return twice / 2;
}

/// Returns the share of each point, by cutting.
std::map<std::uint32_t, double> shares_by_cutting(const Points& points, const Point& query) {
  constexpr double far = 1e4;
  Points cell = {{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (const Point& p : points) cell = nearer(cell, query, p);
  std::map<std::uint32_t, double> shares;
  const double whole = area(cell);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    Points part = cell;
    for (const Point& other : points)
      if (!(other == points[i])) part = nearer(part, points[i], other);
    if (const double a = area(part); a > 1e-12 * whole) shares[i] = a / whole;
  }
  return shares;
}

struct Natural {
  explicit Natural(Points of)
      : points(std::move(of)), triangulation(delaunay_arrays(points)), locator(points, triangulation) {}

  std::vector<double> operator()(const std::vector<double>& values, const Points& queries, unsigned threads = 0) const {
    const std::size_t columns = points.empty() ? 1 : values.size() / points.size();
    return locator.interpolate(values, columns, queries,
                               {.method = Interpolation::natural_neighbor, .threads = threads});
  }

  Points points;
  AlphaComplex triangulation;
  rbpa::Locator locator;
};

}  // namespace

TEST_CASE("shares are the areas that are cut out of the neighbors' cells") {
  Random random(41);
  std::size_t compared = 0, many = 0;
  for (int number = 0; number < 300; ++number) {
    CAPTURE(number);
    const auto count = static_cast<std::size_t>(random.integer(4, 25));
    Points points = random.chance(0.3) ? random_grid(6, count, false, random.bits()) : uniform(count, random.bits());
    const Natural natural(points);
    Points queries;
    for (int i = 0; i < 8; ++i) queries.push_back({random.between(0, 5), random.between(0, 5)});
    for (const Point& p : points) queries.push_back({p.x + 0.5, p.y + 0.5});  // on grids, the middles of squares
    const auto found = natural.locator.find(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (found[i] == AlphaComplex::none) continue;
      const Point& q = queries[i];
      // Near the hull the new cell extends beyond the box in which cells are cut.
      const Points box = {{q.x + 1e-3, q.y}, {q.x - 1e-3, q.y}, {q.x, q.y + 1e-3}, {q.x, q.y - 1e-3}};
      const auto around = natural.locator.find(box);
      if (std::count(around.begin(), around.end(), AlphaComplex::none) > 0) continue;
      if (std::find(points.begin(), points.end(), q) != points.end()) continue;
      rbpa::NaturalNeighbors neighbors(points, natural.triangulation);
      const auto shares = neighbors.find(q, found[i]);
      auto expected = shares_by_cutting(points, q);
      many += shares.size() > 6;
      double sum = 0;
      for (const auto& [point, share] : shares) {
        CHECK(std::abs(share - expected[point]) < 1e-7);
        expected.erase(point);
        CHECK(share >= 0);
        sum += share;
      }
      CHECK(std::abs(sum - 1) < 1e-14);
      for (const auto& [point, share] : expected) CHECK(share < 1e-7);
      ++compared;
    }
  }
  CHECK(compared > 3000);
  CHECK(many > 100);
}

TEST_CASE(
    "linear functions are reproduced, values at points are their own, and linear on the hull, on sets of every kind") {
  Random random(42);
  std::size_t inside = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    Points points = set.make();
    if (points.empty()) continue;
    // At exponents far apart, areas are rational numbers of thousands of bits.
    const bool is_moderate = rbpa::fits_double(rbpa::magnitude(points));
    const std::size_t most = is_moderate ? 150 : 8;
    if (points.size() > most) points.resize(most);
    const Natural natural(points);
    double size = 0;
    for (const Point& p : points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    std::vector<double> values;
    for (const Point& p : points) {
      values.push_back(p.x / size * 2 - p.y / size);
      values.push_back(1);
      values.push_back(random.between(-1, 1));
    }
    Points queries = points;
    for (const auto& t : natural.triangulation.triangles) {
      const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      queries.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
      queries.push_back({a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3});
      queries.push_back({a.x / 7 + b.x * 5 / 7 + c.x / 7, a.y / 7 + b.y * 5 / 7 + c.y / 7});
    }
    if (!is_moderate && queries.size() > 12) queries.resize(12);
    const auto found = natural.locator.find(queries);
    const std::vector<double> result = natural(values, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Point& q = queries[i];
      if (found[i] == AlphaComplex::none) {
        CHECK(std::isnan(result[3 * i]));
        continue;
      }
      ++inside;
      CHECK(std::abs(result[3 * i] - (q.x / size * 2 - q.y / size)) < 1e-9);
      CHECK(result[3 * i + 1] == 1);
      CHECK(std::abs(result[3 * i + 2]) <= 1);
      for (const std::uint32_t corner : natural.triangulation.triangles[found[i]])
        if (points[corner] == q) CHECK(result[3 * i + 2] == values[3 * corner + 2]);
    }
    CHECK(natural(values, queries, 1).size() == result.size());
    const std::vector<double> again = natural(values, queries, 1);
    for (std::size_t i = 0; i < result.size(); ++i) CHECK((again[i] == result[i] || std::isnan(result[i])));
  }
  CHECK(inside > 15000);
}

TEST_CASE("values are continuous across sides, circles and points, and toward the hull") {
  const Natural natural(uniform(200, 43));
  Random random(44);
  std::vector<double> values;
  for (std::size_t i = 0; i < natural.points.size(); ++i) values.push_back(random.between(-1, 1));
  // Small steps along lines across the set: no step changes more than the steepest way between two points allows.
  for (int line = 0; line < 20; ++line) {
    Points queries;
    const Point from = {random.between(0, 14), 0.5}, to = {random.between(0, 14), 13.5};
    constexpr int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
      const double t = double(i) / steps;
      queries.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
    const std::vector<double> result = natural(values, queries);
    for (std::size_t i = 1; i < result.size(); ++i)
      if (!std::isnan(result[i]) && !std::isnan(result[i - 1])) CHECK(std::abs(result[i] - result[i - 1]) < 0.05);
  }
  // Toward the middle of a side of the hull, the limit is the mean of the values at its ends.
  const Natural square({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.6}});
  const std::vector<double> five = {1, 2, 3, 4, 100};
  CHECK(square(five, {{0.5, 0}}) == std::vector<double>{1.5});
  for (const double near : {1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(near);
    CHECK(std::abs(square(five, {{0.5, near}})[0] - 1.5) < 1000 * near + 1e-9);
  }
}

TEST_CASE("four points of a square have equal shares at its middle, at any scale; wrong values are refused") {
  for (const int exponent : {0, -1000, 900}) {
    CAPTURE(exponent);
    const double unit = std::ldexp(1.0, exponent);
    const Natural natural({{0, 0}, {unit, 0}, {unit, unit}, {0, unit}});
    CHECK(natural({1, 2, 4, 8}, {{unit / 2, unit / 2}}) == std::vector<double>{3.75});
  }
  const Natural natural({{0, 0}, {4, 0}, {0, 4}});
  CHECK(natural({1, 2, 3}, {{0, 0}, {5, 5}, {infinity, 0}})[0] == 1);
  CHECK_THROWS_AS(natural.locator.interpolate(std::vector<double>(4), 1, natural.points,
                                              {.method = Interpolation::natural_neighbor}),
                  rbpa::InvalidInput);
}

TEST_SUITE_END();
