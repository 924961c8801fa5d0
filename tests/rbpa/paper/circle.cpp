#include "rbpa/paper/circle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include "paper/small_sets.h"
#include "support/arguments.h"
#include "support/generate.h"

using namespace rbpa_test;
using rbpa::Radius;
using rbpa::paper::Ball;

TEST_SUITE_BEGIN("paper");

namespace {

using Site = std::uint32_t;

/// Returns the point on the left of a→b that sees it under the largest angle, whatever the circle.
std::optional<Site> winner(const Points& points, Site a, Site b) {
  std::optional<Site> best;
  for (Site i = 0; i < points.size(); ++i)
    if (exact::orientation(points[a], points[b], points[i]) > 0 &&
        (!best || exact::in_perturbed_circle(points[a], points[b], points[*best], points[i]) > 0))
      best = i;
  return best;
}

int check_pivots(const Points& points, double alpha) {
  CAPTURE(alpha);
  const Ball ball(points, all_sites(points), radius_of(alpha));
  int found = 0;
  for (Site a = 0; a < points.size(); ++a)
    for (Site b = 0; b < points.size(); ++b) {
      if (a == b) continue;
      // The ball must reach both ends. Pairs that are farther apart are not an edge of a complex, and any answer is
      // allowed.
      if (!std::isinf(alpha) && exact::compare_to_diameter(points[a], points[b], alpha) > 0) continue;
      CAPTURE(a);
      CAPTURE(b);
      std::optional<Site> expected = winner(points, a, b);
      if (expected && !std::isinf(alpha) &&
          exact::compare_circumradius(points[a], points[b], points[*expected], alpha) > 0)
        expected.reset();
      CHECK(ball.pivot(a, b) == expected);
      found += expected.has_value();
    }
  return found;
}

int check_nearest(const Points& points, double alpha) {
  CAPTURE(alpha);
  const Ball ball(points, all_sites(points), radius_of(alpha));
  int found = 0;
  for (Site v = 0; v < points.size(); ++v) {
    CAPTURE(v);
    const auto nearest = ball.nearest(v);
    const auto is_nearer = [&](Site q) {
      return q != v && (nearest ? exact::compare_distances(points[v], points[q], points[*nearest]) < 0
                                : std::isinf(alpha) || exact::compare_to_diameter(points[v], points[q], alpha) <= 0);
    };
    for (Site q = 0; q < points.size(); ++q) CHECK_FALSE(is_nearer(q));
    if (!nearest) continue;
    ++found;
    CHECK(*nearest != v);
    if (!std::isinf(alpha)) CHECK(exact::compare_to_diameter(points[v], points[*nearest], alpha) <= 0);
  }
  return found;
}

}  // namespace

TEST_CASE("the ball pivots to the point of the largest angle, unless their circle is larger than it") {
  int found = 0;
  for_small_sets_of_every_kind(
      94, 30, 11, [&](const Points& points, double alpha, Random&) { found += check_pivots(points, alpha); });
  CHECK(found > trials(1000));
  check_pivots(perfect_grid(5, 1), 0.7071067811865475);
  check_pivots(perfect_grid(5, 1), 0.7071067811865476);
  check_pivots(rounded_concentric(12), 1);
}

TEST_CASE("a point whose circle is as large as the ball is touched, and one whose circle is a step larger is not") {
  const Points points = {{0, 0}, {6, 0}, {0, 8}};
  CHECK(Ball(points, all_sites(points), Radius(5)).pivot(0, 1) == 2);
  CHECK(Ball(points, all_sites(points), Radius(5)).pivot(1, 0) == std::nullopt);
  CHECK(Ball(points, all_sites(points), Radius(std::nextafter(5.0, 0.0))).pivot(0, 1) == std::nullopt);
}

TEST_CASE("the nearest point is found if the ball can touch both") {
  int found = 0;
  for_small_sets_of_every_kind(
      95, 60, 11, [&](const Points& points, double alpha, Random&) { found += check_nearest(points, alpha); });
  CHECK(found > trials(1000));
  const Points pair = {{1, 2}, {1, 4}};
  CHECK(Ball(pair, all_sites(pair), Radius(1)).nearest(0) == 1);
  CHECK(Ball(pair, all_sites(pair), Radius(std::nextafter(1.0, 0.0))).nearest(0) == std::nullopt);
}

TEST_CASE("the ball sees only the sites that it was given") {
  const Points points = {{0, 0}, {1, 0}, {0, 1}, {0.4, 0.3}};
  const std::vector<Site> without{0, 1, 2};
  CHECK(Ball(points, all_sites(points), Radius(2)).pivot(0, 1) == 3);
  CHECK(Ball(points, without, Radius(2)).pivot(0, 1) == 2);
  CHECK(Ball(points, all_sites(points), Radius(2)).nearest(0) == 3);
  CHECK(Ball(points, without, Radius(2)).nearest(0) != 3);
}

TEST_SUITE_END();
