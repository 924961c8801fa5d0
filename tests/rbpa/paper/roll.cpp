#include <doctest/doctest.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "paper/small_sets.h"
#include "rbpa/paper/circle.h"
#include "support/arguments.h"
#include "support/generate.h"

using namespace rbpa_test;
using rbpa::Radius;
using rbpa::paper::Ball;

TEST_SUITE_BEGIN("paper");

namespace {

using Site = std::uint32_t;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

const Float& two_pi() {
  static const Float value = boost::math::constants::two_pi<Float>();
  return value;
}
const Float tolerance = Float(1e-20) * Float(1e-20);  // smaller differences are ties

/// Returns the angle from one direction to another, in [0, 2π).
Float after(const Float& from, const Float& at) {
  Float turn = at - from;
  turn -= two_pi() * floor(turn / two_pi());
  return turn > two_pi() - tolerance ? Float(0) : turn;
}

/// The interval of directions from v to the ball's center in which the ball around v touches or contains a point.
struct Contact {
  Site site;
  Float direction, half_width;
  Float start() const { return direction - half_width; }
  Float end() const { return direction + half_width; }
  /// Returns whether the angle is strictly outside of the interval and its ends.
  bool is_clear_of(const Float& angle) const {
    return after(start() - tolerance, angle) > 2 * half_width + 2 * tolerance;
  }
};

std::vector<Contact> contacts(const Points& points, double alpha, Site v) {
  std::vector<Contact> all;
  for (Site q = 0; q < points.size(); ++q) {
    if (q == v) continue;
    const Float x = Float(points[q].x) - points[v].x, y = Float(points[q].y) - points[v].y;
    const Float cosine = sqrt(x * x + y * y) / (2 * Float(alpha));
    if (cosine > 1 + tolerance) continue;
    all.push_back({q, atan2(y, x), cosine >= 1 ? Float(0) : Float(acos(cosine))});
  }
  return all;
}

struct Statistics {
  int rolls = 0, ties = 0, returns = 0;
};

/// Returns the point whose contact starts next after that of `from` has ended; among several, the first in direction.
Site next_by_angles(const std::vector<Contact>& all, const Contact& from, Statistics& statistics) {
  const Float begin = from.end();
  const Contact* next = &from;
  Float when = two_pi() - 2 * from.half_width;
  for (const Contact& c : all) {
    if (c.site == from.site) continue;
    const Float at = after(begin, c.start());
    const bool is_tie = abs(at - when) < tolerance;
    statistics.ties += is_tie;
    if (is_tie ? after(begin, c.direction) < after(begin, next->direction) || next == &from : at < when) {
      next = &c;
      when = at;
    }
  }
  ++statistics.rolls;
  statistics.returns += next == &from;
  return next->site;
}

void check(const Points& points, double alpha, Statistics& statistics) {
  CAPTURE(alpha);
  const Ball ball(points, all_sites(points), Radius(alpha));
  for (Site v = 0; v < points.size(); ++v) {
    const std::vector<Contact> all = contacts(points, alpha, v);
    for (const Contact& from : all) {
      // The ball is empty where it leaves `from`, and touches no other point.
      if (!std::all_of(all.begin(), all.end(),
                       [&](const Contact& c) { return c.site == from.site || c.is_clear_of(from.end()); }))
        continue;
      CAPTURE(v);
      CAPTURE(from.site);
      REQUIRE(ball.roll(v, from.site) == next_by_angles(all, from, statistics));
    }
  }
}

}  // namespace

TEST_CASE("the ball rolls to the point whose contact starts next, as sorting the angles shows") {
  Statistics statistics;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u})
    for (const double alpha : {0.45, 0.8, 1.2, 2.5, 20.0}) check(uniform(16, seed), alpha, statistics);
  check(clusters(2, 1), 0.02, statistics);
  check(moved(scaled(uniform(14, 7), -10), 1e6, -1e6), 0.0011, statistics);
  check(along_curves(8), 0.7, statistics);
  check(scaled(uniform(14, 9), -900), std::ldexp(0.8, -900), statistics);
  CHECK(statistics.rolls > 500);
  CHECK(statistics.returns > 50);
}

TEST_CASE("among points that the ball reaches at once the first around the point is chosen") {
  Statistics statistics;
  check(perfect_grid(4, 1), 0.5, statistics);
  check(perfect_grid(3, 2), 1.25, statistics);
  check(rectangles_of_circumradius_5(3), 5, statistics);
  check(integer_circle(65), 65, statistics);
  check(pairs_at_distance_2(4, 1), 1, statistics);
  check({{-6, 0}, {-5, 0}, {5, 0}, {4, 3}, {3, 4}, {0, 5}}, 5, statistics);
  check({{0, -6}, {0, -5}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}}, 5, statistics);
  Random random(96);
  for (int trial = 0; trial < trials(400); ++trial) {
    Points points(7);
    fill(points, Kind::small_grid, random);
    const double alphas[] = {0.5, 1, 1.25, 2.5};
    check(distinct(points, random), alphas[random.below(4)], statistics);
  }
  CHECK(statistics.rolls > trials(1000));
  CHECK(statistics.ties > 100);
}

TEST_SUITE_END();
