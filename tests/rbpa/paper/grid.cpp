#include "rbpa/paper/grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "paper/small_sets.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/shrink.h"

using namespace rbpa_test;
using rbpa::paper::Grid;

TEST_SUITE_BEGIN("paper");

namespace {

using Site = std::uint32_t;
using Counts = std::vector<int>;

struct Statistics {
  int near = 0, by_edges = 0;
};

/// Checks that every site in the grid that must be found is found once, and that no other site is found.
void check(const Points& points, const std::vector<Site>& sites, double alpha, Statistics& statistics) {
  INFO("alpha ", literal(alpha), ", points ", literal(points));
  const Grid grid(points, sites, radius_of(alpha));
  Counts held(points.size());
  for (const Site s : sites) held[s] = 1;
  const auto check_found = [&](const Counts& found, auto must_be_found) {
    for (Site q = 0; q < points.size(); ++q) {
      CAPTURE(q);
      if (held[q] && must_be_found(q))
        REQUIRE(found[q] == 1);
      else
        REQUIRE(found[q] <= held[q]);
    }
  };
  const auto is_near = [&](Site p, Site q) {
    return std::isinf(alpha) || exact::compare_to_diameter(points[p], points[q], alpha) <= 0;
  };
  for (Site v = 0; v < points.size(); ++v) {
    CAPTURE(v);
    Counts found(points.size());
    grid.for_each_near(v, [&](Site q) { ++found[q]; });
    check_found(found, [&](Site q) { return statistics.near += is_near(v, q), is_near(v, q); });
    for (Site u = 0; u < points.size(); ++u) {
      if (u == v || !is_near(u, v)) continue;
      CAPTURE(u);
      found.assign(points.size(), 0);
      grid.for_each_near(u, v, [&](Site q) { ++found[q]; });
      // The ball rests on u, v and q, or contains q when it rests on u and v at its equator.
      check_found(found, [&](Site q) {
        const bool is_touched =
            exact::orientation(points[u], points[v], points[q]) != 0 &&
            (std::isinf(alpha) || exact::compare_circumradius(points[u], points[v], points[q], alpha) <= 0);
        statistics.by_edges += is_touched;
        return is_touched || exact::dot_sign(points[q], points[u], points[v]) <= 0;
      });
    }
  }
}

}  // namespace

TEST_CASE("the nine cells hold exactly once each site that a ball can reach, and only sites of the grid") {
  Statistics statistics;
  for_small_sets_of_every_kind(91, 12, 10, [&](const Points& points, double alpha, Random& random) {
    check(points, all_sites(points), alpha, statistics);
    std::vector<Site> some;
    for (const Site s : all_sites(points))
      if (random.chance(0.7)) some.push_back(s);
    check(points, some, alpha, statistics);
  });
  CHECK(statistics.near > trials(4000));
  CHECK(statistics.by_edges > 4000);
}

TEST_CASE("cells that are tiny relative to the coordinates are numbered correctly") {
  // Neighboring doubles far from the origin, with a diameter of half, one, … of their distance.
  Random random(92);
  Statistics statistics;
  for (int trial = 0; trial < trials(1000); ++trial) {
    const int exponent = random.integer(-900, 900);
    const auto coordinate = [&] {
      const double at = random.chance(0.2) ? 0 : std::ldexp(random.chance(0.3) ? 1 : random.between(1, 2), exponent);
      return jiggled(random.chance(0.5) ? at : -at, 3, random);
    };
    Points points;
    for (int i = 0; i < 5; ++i) points.push_back({coordinate(), coordinate()});
    for (int i = 0; i < 5; ++i)
      points.push_back({jiggled(points[static_cast<std::size_t>(i)].x, 2, random), points[random.below(5)].y});
    points = distinct(points, random);
    const double alpha = std::ldexp(random.chance(0.5) ? 1 : random.between(1, 2), exponent - random.integer(40, 66));
    check(points, all_sites(points), alpha, statistics);
  }
  CHECK(statistics.near > 1000);
}

TEST_CASE("only the cells that touch the middle one are searched") {
  const Points points = uniform(400, 93);
  for (const double alpha : {0.2, 0.7, 2.0}) {
    const Grid grid(points, all_sites(points), rbpa::Radius(alpha));
    const double two_cells = 2 * 2 * alpha * (1 + 0x1p-6);
    std::size_t looked_at = 0, by_edges = 0;
    for (Site v = 0; v < points.size(); ++v) {
      grid.for_each_near(v, [&](Site q) {
        ++looked_at;
        CHECK(std::abs(points[q].x - points[v].x) <= two_cells);
        CHECK(std::abs(points[q].y - points[v].y) <= two_cells);
      });
      for (Site u = 0; u < v; ++u) {
        if (std::hypot(points[u].x - points[v].x, points[u].y - points[v].y) > 2 * alpha) continue;
        grid.for_each_near(u, v, [&](Site q) {
          ++by_edges;
          REQUIRE(std::abs(points[q].x - (points[u].x + points[v].x) / 2) <= two_cells);
          REQUIRE(std::abs(points[q].y - (points[u].y + points[v].y) / 2) <= two_cells);
        });
      }
    }
    CHECK(looked_at <= 400 * (36 * alpha * alpha * 1.1 + 3));  // density 1, nine cells of 4α²
    CHECK(by_edges > 50);
  }
}

TEST_SUITE_END();
