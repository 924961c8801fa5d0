#include "rbpa/space/surface/scale_space.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/surface/surface_levels.h"
#include "rbpa/space/surface/unused_points.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::scale_space;

TEST_SUITE_BEGIN("space");

namespace {

constexpr double pi = 3.14159265358979323846;

/// Returns random points on the unit sphere, moved along their normals by nearly normally distributed noise, given in
/// spacings.
Points3 sphere(std::size_t count, double noise) {
  Random random(98);
  const double spacing = std::sqrt(4 * pi / static_cast<double>(count));
  Points3 points;
  while (points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (length(p) < 0.1 || length(p) > 1) continue;
    double bell = -6;  // with standard deviation 1
    for (int i = 0; i < 12; ++i) bell += random.unit();
    const double out = (1 + noise * spacing * bell) / length(p);
    points.push_back({out * p.x, out * p.y, out * p.z});
  }
  return points;
}

double deviation(const Points3& points) {
  double sum = 0, squares = 0;
  for (const Point3& p : points) {
    sum += length(p);
    squares += length(p) * length(p);
  }
  const auto n = static_cast<double>(points.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

bool same_bytes(const Points3& a, const Points3& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point3)) == 0;
}

}  // namespace

TEST_CASE("a sphere with noise of half a spacing becomes one that the ball closes, with nearly all points") {
  const std::size_t count = 5000;
  const double spacing = std::sqrt(4 * pi / count);
  for (const double noise : {0.2, 0.5, 0.8}) {
    CAPTURE(noise);
    const Points3 points = sphere(count, noise);
    const auto moved = scale_space(points);
    CHECK(moved.steps >= 1);
    CHECK(moved.steps <= 8);
    CHECK(deviation(moved.points) < 0.25 * deviation(points));
    const Points3 normals = rbpa::estimate_normals(moved.points);
    const std::vector<double> radii = {2.5 * spacing, 4 * spacing};
    const rbpa::Surface surface = rbpa::surface(moved.points, normals, radii);
    CHECK(rbpa::unused_points(moved.points, normals, radii, surface).size() < count / 50);
    CHECK(surface.triangles.size() > 2 * 0.98 * count);
  }
}

TEST_CASE("a smooth surface takes one step, however coarse its points, and a noisy one takes as many as necessary") {
  for (const std::size_t count : {500u, 5000u}) CHECK(scale_space(sphere(count, 0)).steps == 1);
  CHECK(scale_space(sphere(1500, 0.5)).steps <= 3);
}

TEST_CASE("points of a plane or a line, and a single point, do not move") {
  Random random(99);
  Points3 level, line;
  for (int i = 0; i < 300; ++i) {
    level.push_back({random.between(-1, 1), random.between(-1, 1), 0.3});
    line.push_back({random.between(-1, 1), 0, 0});
  }
  CHECK(scale_space(level).steps == 1);
  CHECK(scale_space(level).points == level);
  CHECK(scale_space(line).points == line);
  CHECK(scale_space({{{1, 2, 3}}}).points == Points3{{1, 2, 3}});
  CHECK(scale_space({{{1, 2, 3}, {1, 2, 3}}}, {.steps = 3}).steps == 3);
  CHECK(scale_space({}).points.empty());
}

TEST_CASE("a given number of steps equals that many single steps") {
  const Points3 points = sphere(1500, 0.4);
  const auto once = scale_space(points, {.steps = 1});
  CHECK(once.steps == 1);
  CHECK(same_bytes(scale_space(once.points, {.steps = 1}).points, scale_space(points, {.steps = 2}).points));
  CHECK_FALSE(same_bytes(once.points, scale_space(points, {.steps = 1, .neighbors = 12}).points));
}

TEST_CASE("neither the order of the points nor the threads nor a power of two changes the result") {
  Random random(100);
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    const Points3 points = space_set(static_cast<SpaceKind>(k), 1200, random);
    const Points3 expected = scale_space(points, {.steps = 2, .threads = 1}).points;
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    Points3 shuffled, expected_shuffled;
    for (const std::uint32_t i : order) {
      const auto scaled = [](const Point3& p) {
        return Point3{std::ldexp(p.x, 5), std::ldexp(p.y, 5), std::ldexp(p.z, 5)};
      };
      shuffled.push_back(scaled(points[i]));
      expected_shuffled.push_back(scaled(expected[i]));
    }
    CHECK(scale_space(shuffled, {.steps = 2, .threads = 2}).points == expected_shuffled);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i] == points[i + 1]) CHECK(expected[i] == expected[i + 1]);
  }
}

TEST_CASE("bad input is refused, and a run can be cancelled") {
  CHECK_THROWS_WITH_AS(scale_space({{{0, 0, 0}, {0, std::nan(""), 0}}}),
                       "point 1 is (0, nan, 0), expected finite coordinates", rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(scale_space({}, {.neighbors = 1}), "scale space from 1 neighbors, expected at least 2",
                       rbpa::InvalidInput);
  const Points3 points = sphere(20'000, 0.4);
  std::size_t left = 5;
  CHECK_THROWS_AS(scale_space(points, {.steps = 4, .progress = [&](const rbpa::Progress&) { return --left > 0; }}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();
