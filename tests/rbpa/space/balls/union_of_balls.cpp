#include "rbpa/space/balls/union_of_balls.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::BallUnion;
using rbpa::Point3;
using rbpa::union_of_balls;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

/// Measures the union by slices. On each circle of a slice, the arcs that are in no other disc bound the slice of the
/// union. By Archimedes a sphere has the same area between equally distant planes, so that arcs are the surface's
/// share.
BallUnion by_slices(const Points3& points, double radius, int slices) {
  std::vector<double> heights;  // between these every ball is met everywhere or nowhere
  for (const Point3& p : points)
    for (const double end : {p.z - radius, p.z + radius}) heights.push_back(end);
  std::sort(heights.begin(), heights.end());
  BallUnion sum;
  const int in_each = slices / static_cast<int>(heights.size());
  for (int slice = 0; slice < in_each * (static_cast<int>(heights.size()) - 1); ++slice) {
    const auto interval = static_cast<std::size_t>(slice / in_each);
    // Slices are thinner toward the ends, where circles shrink to points.
    const double half = (heights[interval + 1] - heights[interval]) / 2, angle = (slice % in_each + 0.5) * pi / in_each;
    const double step = half * std::sin(angle) * pi / in_each, z = heights[interval] + half * (1 - std::cos(angle));
    const auto disc = [&](const Point3& p) {
      return std::sqrt(std::max(radius * radius - (p.z - z) * (p.z - z), 0.0));
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double own = disc(points[i]);
      if (own == 0) continue;
      std::vector<std::pair<double, double>> covered;
      bool is_covered = false;
      for (std::size_t j = 0; j < points.size() && !is_covered; ++j) {
        const double other = disc(points[j]), x = points[j].x - points[i].x, y = points[j].y - points[i].y,
                     distance = std::hypot(x, y);
        if (j == i || other == 0 || distance >= own + other || own >= distance + other) continue;
        is_covered = other >= distance + own;
        const double reach =
            std::acos(std::clamp((own * own + distance * distance - other * other) / (2 * own * distance), -1.0, 1.0));
        double from = std::atan2(y, x) - reach;
        if (from < -pi) from += 2 * pi;
        covered.emplace_back(from, std::min(from + 2 * reach, pi));
        if (from + 2 * reach > pi) covered.emplace_back(-pi, from + 2 * reach - 2 * pi);
      }
      if (is_covered) continue;
      std::sort(covered.begin(), covered.end());
      covered.emplace_back(pi, pi);
      double at = -pi;
      for (const auto& [from, to] : covered) {
        if (from > at) {
          const double open = from - at;
          sum.area += radius * open * step;
          sum.volume += step * own / 2 *
                        (own * open + points[i].x * (std::sin(from) - std::sin(at)) -
                         points[i].y * (std::cos(from) - std::cos(at)));
        }
        at = std::max(at, to);
      }
    }
  }
  return sum;
}

void check_by_slices(const Points3& points, double radius) {
  CAPTURE(radius);
  const BallUnion found = union_of_balls(points, radius), expected = by_slices(points, radius, 20000);
  CHECK(found.volume == doctest::Approx(expected.volume).epsilon(2e-5));
  CHECK(found.area == doctest::Approx(expected.area).epsilon(2e-5));
}

}  // namespace

TEST_CASE("the measures of one ball, and of two, follow the formula") {
  const BallUnion one = union_of_balls(Points3{{3, 4, 5}}, 2);
  CHECK(one.volume == doctest::Approx(32 * pi / 3).epsilon(1e-14));
  CHECK(one.area == doctest::Approx(16 * pi).epsilon(1e-14));
  // Each ball loses a cap of height ½.
  const BallUnion two = union_of_balls(Points3{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}, 1);
  CHECK(two.volume == doctest::Approx(8 * pi / 3 - 2 * pi / 4 * (1 - 1.0 / 6)).epsilon(1e-14));
  CHECK(two.area == doctest::Approx(8 * pi - 2 * pi).epsilon(1e-14));
  const BallUnion apart = union_of_balls(Points3{{0, 0, 0}, {0, 2.5, 0}}, 1);
  CHECK(apart.volume == doctest::Approx(8 * pi / 3).epsilon(1e-14));
  CHECK(union_of_balls(Points3{}, 1).volume == 0);
}

TEST_CASE("the measures of three and four balls are right: acute, obtuse, far apart, flat") {
  const Points3 acute = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0.3}}, obtuse = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.2, 0.1}},
                line = {{0, 0, 0}, {0.7, 0.1, 0.2}, {1.4, 0.2, 0.4}},
                four = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0.3}, {0.5, 0.2, 0.8}},
                square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (const Points3& points : {acute, obtuse, line, four, square})
    for (const double radius : {0.3, 0.52, 0.56, 0.6, 0.71, 0.9, 2.0, 10.0}) check_by_slices(points, radius);
}

TEST_CASE("the measures of random points are right, from separate balls to one that is nearly a ball") {
  Random random(2);
  for (const std::size_t count : {5u, 9u, 30u}) {
    Points3 points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
    for (const double radius : {0.05, 0.15, 0.2, 0.25, 0.3, 0.4, 0.6, 1.0, 5.0}) check_by_slices(points, radius);
  }
}

TEST_CASE("the measures of a grid, which is cospherical everywhere, are right") {
  check_by_slices(cubic_grid(27, 0.25, 3), 0.2);
}

TEST_CASE("separate balls add up, and the measures do not decrease with the radius") {
  const Points3 points = jittered_cubes(2000, 4);
  const auto count = static_cast<double>(points.size());
  const BallUnion small = union_of_balls(points, 0.001);
  CHECK(small.volume == doctest::Approx(count * 4 * pi / 3 * 1e-9).epsilon(1e-9));
  double before = 0;
  for (const double radius : {0.3, 0.5, 0.6, 0.7, 0.8, 1.0, 2.0, 50.0}) {
    const BallUnion found = union_of_balls(points, radius);
    CHECK(found.volume > before);
    before = found.volume;
  }
  CHECK(union_of_balls(points, 1e6).volume == doctest::Approx(4 * pi / 3 * 1e18).epsilon(1e-4));
}

TEST_CASE("points that nearly coincide have nearly one ball, however near they are") {
  for (const double size : {1e-3, 1e-9, 1e-100, 1e-160, 1e-200, 1e-300}) {
    CAPTURE(size);
    Points3 points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {size, size, size / 2}};
    CHECK(union_of_balls(points, 1).volume == doctest::Approx(4 * pi / 3).epsilon(2 * size + 1e-13));
    points.push_back({1, 0, 0});
    const BallUnion two = union_of_balls(Points3{{0, 0, 0}, {1, 0, 0}}, 1), found = union_of_balls(points, 1);
    CHECK(found.volume == doctest::Approx(two.volume).epsilon(4 * size + 1e-13));
    CHECK(found.area == doctest::Approx(two.area).epsilon(4 * size + 1e-13));
  }
  CHECK_THROWS_AS(union_of_balls(Points3{{1e308, 0, 0}, {-1e308, 0, 0}}, 1), rbpa::InvalidInput);
}

TEST_CASE("points much nearer than the radius lose no digits: the order changes only the rounding") {
  Random random(8);
  for (const double size : {1e-2, 1e-4, 1e-6, 1e-8}) {
    CAPTURE(size);
    Points3 points;
    for (int i = 0; i < 60; ++i) {
      const auto near = [&](int cluster) { return 0.9 * cluster + size * random.unit(); };
      points.push_back({near(i % 3), near(i % 2), near(i % 5 == 0 ? 1 : 0)});
    }
    const BallUnion expected = union_of_balls(points, 1);
    std::reverse(points.begin(), points.end());
    const BallUnion reversed = union_of_balls(points, 1);
    CHECK(reversed.volume == doctest::Approx(expected.volume).epsilon(1e-14));
    CHECK(reversed.area == doctest::Approx(expected.area).epsilon(1e-13));
  }
}

TEST_CASE("moving and scaling by powers of two, shuffling and three threads change the result only by rounding") {
  Points3 points = jittered_cubes(500, 5);
  const BallUnion expected = union_of_balls(points, 0.75, {.threads = 1}),
                  by_threads = union_of_balls(points, 0.75, {.threads = 3});
  CHECK(by_threads.volume == expected.volume);
  CHECK(by_threads.area == expected.area);
  Points3 scaled, reversed(points.rbegin(), points.rend());
  for (const Point3& p : points) scaled.push_back({0x1p-300 * p.x, 0x1p-300 * p.y, 0x1p-300 * p.z});
  CHECK(union_of_balls(scaled, 0x1p-300 * 0.75).volume == doctest::Approx(0x1p-900 * expected.volume).epsilon(1e-12));
  CHECK(union_of_balls(reversed, 0.75).volume == doctest::Approx(expected.volume).epsilon(1e-12));
  CHECK(union_of_balls(reversed, 0.75).area == doctest::Approx(expected.area).epsilon(1e-12));
}

TEST_CASE("a given triangulation gives the same result; invalid radii and those of another triangulation are refused") {
  const Points3 points = jittered_cubes(100, 6);
  const rbpa::Solid delaunay = rbpa::solid(points, infinity),
                    bare = rbpa::solid(points, infinity, {.neighbors = false});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  CHECK(union_of_balls(points, delaunay, radii, 0.6).volume == union_of_balls(points, 0.6).volume);
  CHECK_THROWS_AS(union_of_balls(points, delaunay, {}, 0.6), meshops::ContractViolation);
  CHECK_THROWS_AS(union_of_balls(points, bare, radii, 0.6), meshops::ContractViolation);
  for (const double radius : {0.0, -1.0, infinity, std::nan("")}) {
    CHECK_THROWS_AS(union_of_balls(points, radius), rbpa::InvalidInput);
    CHECK_THROWS_AS(union_of_balls(points, delaunay, radii, radius), rbpa::InvalidInput);
  }
  CHECK_THROWS_AS(union_of_balls(Points3{{0, 0, infinity}}, 1), rbpa::InvalidInput);
}

TEST_SUITE_END();
