#include "rbpa/plane/locate.h"

#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "support/arguments.h"
#include "support/delaunay_arrays.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::Point;

TEST_SUITE_BEGIN("locate");

// Spans of temporaries would dangle.
static_assert(std::is_constructible_v<rbpa::Locator, Points&, AlphaComplex&>);
static_assert(std::is_constructible_v<rbpa::Locator, std::span<Point>, rbpa::TriangleArrays>);
static_assert(!std::is_constructible_v<rbpa::Locator, Points, AlphaComplex&>);
static_assert(!std::is_constructible_v<rbpa::Locator, Points&, AlphaComplex>);
static_assert(!std::is_constructible_v<rbpa::Locator, Points&, rbpa::ConstrainedDelaunay>);
static_assert(!std::is_constructible_v<rbpa::Locator, Points&, rbpa::OwnedTriangles>);
static_assert(!std::is_constructible_v<rbpa::Locator, Points, AlphaComplex>);

namespace {

/// Returns the first triangle that contains the point, by exact arithmetic on each.
std::uint32_t first_by_trying_all(const Points& points, const AlphaComplex& of, const Point& query) {
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    const auto& [a, b, c] = of.triangles[t];
    if (exact::orientation(points[a], points[b], query) >= 0 && exact::orientation(points[b], points[c], query) >= 0 &&
        exact::orientation(points[c], points[a], query) >= 0)
      return t;
  }
  return AlphaComplex::none;
}

/// Returns the points themselves, middles of sides, points near them by a bit, corners of the box and beyond, and
/// arbitrary points.
Points queries_for(const Points& points, const AlphaComplex& of, Random& random) {
  Points queries = {{infinity, 0}, {0, std::nan("")}, {1e308, 1e308}, {-1e308, 1e-308}};
  for (const Point& p : points) {
    queries.push_back(p);
    queries.push_back({std::nextafter(p.x, infinity), p.y});
    queries.push_back({p.x, std::nextafter(p.y, -infinity)});
  }
  for (const auto& t : of.triangles) {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    queries.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
    queries.push_back({a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3});
  }
  for (int i = 0; i < 20 && !points.empty(); ++i) {
    const auto any = [&] { return points[static_cast<std::size_t>(random.integer(0, int(points.size()) - 1))]; };
    queries.push_back({any().x, any().y});
  }
  return queries;
}

}  // namespace

TEST_CASE(
    "locate() finds the first triangle that contains the point, on sets of every kind, with any number of threads") {
  Random random(1);
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const std::size_t most = all_trials() ? 30 : 14;  // exact arithmetic is slow
    Points points = set.first(most);
    const AlphaComplex of = delaunay_arrays(points);
    const rbpa::Locator locator(points, of);
    const Points queries = queries_for(points, of, random);
    const auto found = locator.find(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      CAPTURE(queries[i].x);
      CAPTURE(queries[i].y);
      REQUIRE(found[i] ==
              (rbpa::is_finite(queries[i]) ? first_by_trying_all(points, of, queries[i]) : AlphaComplex::none));
    }
  }
}

TEST_CASE("many queries by many threads have the results of single ones") {
  const Points points = uniform(5000, 7), queries = uniform(20000, 8);
  const AlphaComplex of = delaunay_arrays(points);
  const rbpa::Locator locator(points, of);
  const auto found = locator.find(queries);
  CHECK(found == locator.find(queries, {.threads = 1}));
  for (std::size_t i = 0; i < queries.size(); i += 997)
    REQUIRE(found[i] == first_by_trying_all(points, of, queries[i]));
}

TEST_CASE("values are convex combinations of the corners' values, a point has its own, and a miss has none") {
  Random random(2);
  std::size_t inside = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    Points points = set.first(100);
    const AlphaComplex of = delaunay_arrays(points);
    const rbpa::Locator locator(points, of);
    const Points queries = queries_for(points, of, random);
    std::vector<double> values;  // two for each point, the second of which is 1
    for (std::size_t i = 0; i < points.size(); ++i) {
      values.push_back(random.between(-1, 1));
      values.push_back(1);
    }
    const auto found = locator.find(queries);
    const std::vector<double> result = locator.interpolate(values, 2, queries);
    REQUIRE(result.size() == 2 * queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (found[i] == AlphaComplex::none) {
        CHECK(std::isnan(result[2 * i]));
        CHECK(std::isnan(result[2 * i + 1]));
        continue;
      }
      ++inside;
      const auto& corners = of.triangles[found[i]];
      double least = 1, greatest = -1;
      for (const std::uint32_t corner : corners) {
        least = std::min(least, values[2 * corner]);
        greatest = std::max(greatest, values[2 * corner]);
        if (points[corner] == queries[i]) CHECK(result[2 * i] == values[2 * corner]);
      }
      CHECK(result[2 * i] >= least);
      CHECK(result[2 * i] <= greatest);
      CHECK(result[2 * i + 1] == 1);
    }
    // The results are the same to the last bit in any order of the queries, with any number of threads.
    std::vector<std::uint32_t> order(queries.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    Points shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(queries[i]);
    const std::vector<double> again = locator.interpolate(values, 2, shuffled, {.threads = 1});
    for (std::size_t i = 0; i < order.size(); ++i)
      CHECK((again[2 * i] == result[2 * order[i]] || std::isnan(result[2 * order[i]])));
  }
  CHECK(inside > 10000);
}

TEST_CASE("a linear function is reproduced, wherever the points are, and wrong values are refused") {
  for (const int exponent : {0, -1000, 990}) {
    const Points unit = uniform(400, 4), queries = uniform(900, 5);
    const auto scaled = [&](Points points) {
      for (Point& p : points) p = {std::ldexp(p.x - 10, exponent), std::ldexp(p.y - 10, exponent)};
      return points;
    };
    const Points points = scaled(unit), at = scaled(queries);
    const AlphaComplex of = delaunay_arrays(points);
    std::vector<double> values;
    for (const Point& p : unit) values.push_back(2 * p.x - 3 * p.y + 1);
    const std::vector<double> result = rbpa::Locator(points, of).interpolate(values, 1, at);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (!std::isnan(result[i])) {
        ++inside;
        CHECK(std::abs(result[i] - (2 * queries[i].x - 3 * queries[i].y + 1)) < 1e-12);
      }
    CHECK(inside > 300);
  }
  // Far from the origin and thin: differences are rounded, and areas vanish in the rounding error.
  for (const double thin : {1e-3, 1e-6, 1e-9}) {
    const Point at = {1e6 + 1. / 3, 1e6 / 7};
    const Points corners = {at, {at.x + 1, at.y + 1. / 3}, {at.x + 3, at.y + 1 - thin}};
    const AlphaComplex of = delaunay_arrays(corners);
    REQUIRE(of.triangles.size() == 1);
    const rbpa::Locator locator(corners, of);
    const std::vector<double> x = {corners[0].x - at.x, corners[1].x - at.x, corners[2].x - at.x};
    Points queries;
    for (int i = 1; i < 30; ++i) queries.push_back({at.x + i / 10., at.y + i / 30. - thin * i / 60});
    const std::vector<double> found = locator.interpolate(x, 1, queries);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (std::isnan(found[i])) continue;
      ++inside;
      CHECK(std::abs(found[i] - (queries[i].x - at.x)) < 1e-9 / thin * 1e-3);
    }
    CHECK(inside > 3);
  }
  const Points points = {{0, 0}, {4, 0}, {0, 4}};
  const AlphaComplex of = delaunay_arrays(points);
  const rbpa::Locator locator(points, of);
  const std::vector<double> values = {1, 2, 3, infinity};
  CHECK_THROWS_WITH_AS(locator.interpolate(values, 1, points),
                       "values: found 4 numbers, expected 1 for each of the 3 points", rbpa::InvalidInput);
  CHECK_THROWS_AS(locator.interpolate(values, 0, points), rbpa::InvalidInput);
  CHECK_THROWS_AS(locator.interpolate(std::span(values).first(3), 1, uniform(9000, 1), {.go_on = [] { return false; }}),
                  rbpa::Cancelled);
  // A corner with weight 0 does not count.
  CHECK(locator.interpolate(std::span(values).last(3), 1, Points{{2, 0}, {0, 0}}) == std::vector<double>{2.5, 2});
}

TEST_CASE("nothing is found where there is no triangle") {
  for (const Points& points : {Points{}, Points{{1, 2}}, Points{{0, 0}, {1, 1}, {2, 2}}}) {
    const AlphaComplex of = delaunay_arrays(points);
    CHECK(rbpa::Locator(points, of).find(Points{{1, 1}, {0, 0}}) == std::vector(2, AlphaComplex::none));
  }
}

TEST_CASE("a complex with a radius is refused, other points too, and a cancelled run ends") {
  const Points points = uniform(20000, 3);
  const AlphaComplex solid = rbpa::alpha_complex(points, 0.6, {.neighbors = true}), all = delaunay_arrays(points);
  CHECK_THROWS_AS(rbpa::Locator(points, solid), meshops::ContractViolation);
  const Points fewer = uniform(100, 3);
  CHECK_THROWS_AS(rbpa::Locator(fewer, all), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::Locator(points, all, {.go_on = [] { return false; }}), rbpa::Cancelled);
  CHECK_THROWS_AS(rbpa::Locator(points, all).find(points, {.go_on = [] { return false; }}), rbpa::Cancelled);
  // The triangles of other points: a walk leads anywhere, but it ends.
  const Points others = uniform(20000, 4);
  const rbpa::Locator lost(others, all);
  for (const Point& query : uniform(50, 5)) try {
      lost.find(std::span(&query, 1));
    } catch (const meshops::ContractViolation&) {
    }
}

TEST_SUITE_END();
