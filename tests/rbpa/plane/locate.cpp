#include "rbpa/locate.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/triangulate.h"
#include "support/arguments.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Triangulation;

TEST_SUITE_BEGIN("locate");

namespace {

const double infinity = std::numeric_limits<double>::infinity();

Triangulation delaunay_of(const Points& points) { return rbpa::triangulate(points, infinity, {.neighbors = true}); }

/// The first triangle that has the point, by exact arithmetic on each.
std::uint32_t first_by_trying_all(const Points& points, const Triangulation& of, const Point& query) {
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    const auto& [a, b, c] = of.triangles[t];
    if (exact::orientation(points[a], points[b], query) >= 0 && exact::orientation(points[b], points[c], query) >= 0 &&
        exact::orientation(points[c], points[a], query) >= 0)
      return t;
  }
  return Triangulation::none;
}

/// The points themselves, middles of sides, points near them by a bit, corners of the box and beyond, anything.
Points queries_for(const Points& points, const Triangulation& of, Random& random) {
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

TEST_CASE("the first triangle that has the point, on sets of every kind, with any number of threads") {
  Random random(1);
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    Points points = set.make();
    const std::size_t most = all_trials() ? 30 : 14;  // exact arithmetic is slow
    if (points.size() > most) points.resize(most);
    const Triangulation of = delaunay_of(points);
    const rbpa::Locator locator(points, of);
    const Points queries = queries_for(points, of, random);
    const auto found = locator.find(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      CAPTURE(queries[i].x);
      CAPTURE(queries[i].y);
      REQUIRE(found[i] ==
              (rbpa::is_finite(queries[i]) ? first_by_trying_all(points, of, queries[i]) : Triangulation::none));
    }
  }
}

TEST_CASE("many queries and threads: the same as one by one") {
  const Points points = uniform(5000, 7), queries = uniform(20000, 8);
  const Triangulation of = delaunay_of(points);
  const rbpa::Locator locator(points, of);
  const auto found = locator.find(queries);
  CHECK(found == locator.find(queries, {.threads = 1}));
  for (std::size_t i = 0; i < queries.size(); i += 997)
    REQUIRE(found[i] == first_by_trying_all(points, of, queries[i]));
}

TEST_CASE("nothing is found where nothing is") {
  for (const Points& points : {Points{}, Points{{1, 2}}, Points{{0, 0}, {1, 1}, {2, 2}}}) {
    const Triangulation of = delaunay_of(points);
    CHECK(rbpa::Locator(points, of).find(Points{{1, 1}, {0, 0}}) == std::vector(2, Triangulation::none));
  }
}

TEST_CASE("a complex with a radius is refused, points that are others too, and a cancelled run ends") {
  const Points points = uniform(20000, 3);
  const Triangulation solid = rbpa::triangulate(points, 0.6, {.neighbors = true}), all = delaunay_of(points);
  CHECK_THROWS_AS(rbpa::Locator(points, solid), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::Locator(uniform(100, 3), all), meshops::ContractViolation);
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
