#include "rbpa/space/surface/auto_radii.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/surface/spacing/tangent_cell.h"
#include "rbpa/space/surface/surface_levels.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::auto_radii;
using rbpa::Point3;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Radii = std::vector<double>;

/// Returns random points of the unit sphere; with a power above 1 they are denser at the bottom.
Points3 on_sphere(std::size_t count, double power, std::uint64_t seed) {
  Random random(seed);
  Points3 points;
  while (points.size() < count) {
    const double z = -1 + 2 * std::pow(random.between(0, 1), power), angle = random.between(0, 2 * M_PI);
    const double s = std::sqrt(1 - z * z);
    points.push_back({s * std::cos(angle), s * std::sin(angle), z});
  }
  return points;
}

bool is_closed(const Surface& s) {
  return !s.triangles.empty() && std::all_of(s.neighbors.begin(), s.neighbors.end(), [](const auto& n) {
    return std::count(n.begin(), n.end(), Surface::none) == 0;
  });
}

}  // namespace

namespace {

/// Returns the ground and facades along it, seen from one place: up to fifty times as dense near it as far away.
Points3 street(std::size_t count) {
  Random random(17);
  Points3 points;
  while (points.size() < count) {
    const double far = 2 * std::pow(20.0, random.between(0, 1)), angle = random.between(0, 2 * M_PI);
    const double x = far * std::cos(angle), y = far * std::sin(angle);
    if (std::abs(y) < 6)
      points.push_back({x, y, 0});
    else if (const double height = 6 / std::abs(y) * random.between(0, far); height < 10)
      points.push_back({6 / std::abs(y) * x, std::copysign(6.0, y), height});
  }
  return points;
}

/// Adds one point in twenty anywhere in a box `wide` times as large.
Points3 with_outliers(Points3 points, double wide) {
  Random random(18);
  Point3 low = points.front(), high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto any = [&](double from, double to) {
    return (from + to) / 2 + wide * (to - from) * random.between(-0.5, 0.5);
  };
  for (std::size_t left = points.size() / 20; left > 0; --left)
    points.push_back({any(low.x, high.x), any(low.y, high.y), any(low.z, high.z)});
  return points;
}

}  // namespace

TEST_CASE("one outlier in twenty changes the largest radius by less than half, also on a street") {
  Points3 torus, waves;
  Random random(19);
  while (torus.size() < 8000) {
    const double a = random.between(0, 2 * M_PI), b = random.between(0, 2 * M_PI);
    if (random.between(0, 1.5) > 1 + 0.5 * std::cos(b)) continue;
    torus.push_back({(1 + 0.5 * std::cos(b)) * std::cos(a), (1 + 0.5 * std::cos(b)) * std::sin(a), 0.5 * std::sin(b)});
  }
  for (int i = 0; i < 8000; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    waves.push_back({x, y, 0.2 * std::sin(4 * x + y)});
  }
  for (const Points3& points : {on_sphere(5000, 1, 2), on_sphere(5000, 3, 2), torus, waves, street(20'000)}) {
    const double expected = auto_radii(points).back();
    for (const double wide : {1.1, 3.0}) {
      CAPTURE(wide);
      const double found = auto_radii(with_outliers(points, wide)).back();
      CAPTURE(found / expected);
      CHECK((found < 1.5 * expected && expected < 1.5 * found));
    }
  }
}

TEST_CASE("one radius closes a uniform sphere, and several radii one whose density varies a hundredfold") {
  for (const std::size_t count : {100U, 1000U, 5000U}) {
    const Points3 uniform = on_sphere(count, 1, count);
    const Radii radii = auto_radii(uniform);
    REQUIRE(radii.size() == 1);
    const Surface surface = rbpa::surface(uniform, uniform, radii[0]);
    CHECK(is_closed(surface));
    CHECK(surface.triangles.size() == 2 * count - 4);
    CHECK(radii[0] < 10 / std::sqrt(static_cast<double>(count)));  // three spacings
  }
  const Points3 varying = on_sphere(2000, 3, 1);
  const Radii radii = auto_radii(varying);
  CHECK(radii.size() >= 2);
  CHECK(radii.size() <= 4);
  for (std::size_t i = 1; i < radii.size(); ++i) CHECK(radii[i] >= 2 * radii[i - 1]);
  const Surface surface = rbpa::surface(varying, varying, radii);
  CHECK(is_closed(surface));
  CHECK(surface.triangles.size() == 2 * varying.size() - 4);
}

TEST_CASE("a hole in a sphere stays open: the gaps at its rim are much larger than other gaps there") {
  Points3 points = on_sphere(3000, 1, 7);
  std::erase_if(points, [](const Point3& p) { return p.z > 0.8; });
  const Radii radii = auto_radii(points);
  REQUIRE(radii.size() == 1);
  CHECK(radii[0] < 0.2);
  const Surface surface = rbpa::surface(points, points, radii);
  CHECK(!is_closed(surface));
  CHECK(surface.triangles.size() > 2 * points.size() - 200);
}

TEST_CASE(
    "radii do not depend on the order of points, duplicates, signs of zero and threads; they scale with the points") {
  Random random(401);
  std::size_t several = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < 4; ++trial) {
      CAPTURE(name(static_cast<SpaceKind>(k)));
      Points3 points = space_set(static_cast<SpaceKind>(k), 3 + random.below(trial < 3 ? 60 : 2000), random);
      const Radii radii = auto_radii(points);
      several += radii.size() > 1;
      CHECK(radii.size() <= 4);
      CHECK(std::is_sorted(radii.begin(), radii.end()));
      for (const double radius : radii) CHECK((radius > 0 && std::isfinite(radius)));
      for (int i = 0; i < 5; ++i) points.push_back(points[random.below(points.size())]);
      for (Point3& p : points)
        if (p.x == 0) p.x = -p.x;
      random.shuffle(points);
      for (const unsigned threads : {1u, 2u, 5u}) CHECK(auto_radii(points, {.threads = threads}) == radii);
      if (static_cast<SpaceKind>(k) == SpaceKind::extreme) continue;
      for (const int exponent : {-400, 300}) {
        Points3 scaled;
        for (const Point3& p : points)
          scaled.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
        Radii expected = radii;
        for (double& radius : expected) radius = std::ldexp(radius, exponent);
        CHECK(auto_radii(scaled) == expected);
      }
    }
  CHECK(several > 0);
}

TEST_CASE("on grids the radius is that of the squares, and the surface has all of them") {
  for (const int columns : {2, 3, 12}) {
    Points3 points;
    for (int x = 0; x < columns; ++x)
      for (int y = 0; y < columns; ++y) points.push_back({double(x), double(y), 5});
    const Radii radii = auto_radii(points);
    REQUIRE(radii.size() == 1);
    CHECK(radii[0] > std::sqrt(0.5));
    CHECK(radii[0] < 1);
    const Surface surface = rbpa::surface(points, Points3(points.size(), {0, 0, 1}), radii[0]);
    CHECK(surface.triangles.size() == 2 * static_cast<std::size_t>((columns - 1) * (columns - 1)));
  }
  Points3 cube;
  for (int i = 0; i < 8; ++i) cube.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  REQUIRE(auto_radii(cube).size() == 1);
  CHECK(rbpa::exposed_triangles(cube, auto_radii(cube)[0]).triangles.size() >= 12);
}

TEST_CASE("points without triangles have no radii, and invalid input is refused") {
  CHECK(auto_radii({}).empty());
  CHECK(auto_radii(Points3{{1, 2, 3}}).empty());
  CHECK(auto_radii(Points3{{1, 2, 3}, {4, 5, 6}, {1, 2, 3}}).empty());
  CHECK(auto_radii(Points3(9, {0, 0, 0})).empty());
  Points3 line;
  for (int i = 0; i < 50; ++i) line.push_back({double(i), 2.0 * i, -3.0 * i});
  CHECK(auto_radii(line).empty());
  CHECK(auto_radii(Points3{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}) == Radii{1.25 * 2.5});
  for (const double spacing : {0.001, 1000.0}) {
    Points3 far;  // two lines of points that are much farther apart than their points are, and the same in rows
    for (int i = 0; i < 60; ++i)
      for (const int row : {0, 1}) far.push_back({i * spacing, row * 1000 * spacing, 0});
    const Radii radii = auto_radii(far);
    REQUIRE(radii.size() == 1);
    CHECK(!rbpa::exposed_triangles(far, radii[0]).triangles.empty());
  }
  CHECK_THROWS_AS(auto_radii(Points3{{0, 0, std::numeric_limits<double>::infinity()}}), rbpa::InvalidInput);
  const Points3 points = on_sphere(3000, 1, 3);
  CHECK_THROWS_AS(auto_radii(points, {.progress = [](auto) { return false; }}), rbpa::Cancelled);
}

TEST_CASE("the radius suggested for an empty surface gives triangles, if there are any") {
  const Points3 points = on_sphere(500, 1, 5);
  REQUIRE(rbpa::surface(points, points, 0.001).triangles.empty());
  const std::optional<double> radius = rbpa::radius_with_triangles(points, points);
  REQUIRE(radius);
  CHECK(!rbpa::surface(points, points, *radius).triangles.empty());
  CHECK(rbpa::radius_with_triangles(points, {}) == radius);
  // Points in a plane, with normals along it.
  const Points3 square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  CHECK(rbpa::radius_with_triangles(square, {}));
  CHECK(!rbpa::radius_with_triangles(square, Points3(4, {1, 0, 0})));
  CHECK(!rbpa::radius_with_triangles(Points3{{0, 0, 0}, {1, 0, 0}}, {}));
  CHECK_THROWS_AS(rbpa::radius_with_triangles(square, Points3(3, {0, 0, 1})), rbpa::InvalidInput);
}

TEST_CASE("the gap around a point is the farthest corner of its cell in the plane") {
  using rbpa::space::gap_around;
  Points3 around;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      if (x != 0 || y != 0) around.push_back({double(x), double(y), 0});
  std::sort(around.begin(), around.end(),
            [](const Point3& p, const Point3& q) { return std::hypot(p.x, p.y) < std::hypot(q.x, q.y); });
  const Point3 up = {0, 0, 1};
  const auto near = [](double value) { return doctest::Approx(value).epsilon(1e-12); };
  CHECK(*gap_around(around, up, 1.4) == near(std::sqrt(0.5)));
  CHECK(!gap_around(around, up, 0.7));  // beyond the neighbors
  Points3 half = around;
  std::erase_if(half, [](const Point3& p) { return p.x < 0; });
  CHECK(!gap_around(half, up, 1.4));  // the cell is not closed
  // A point directly above bounds nothing; a point above and to the side bounds by the plane in between.
  around.push_back({0, 0, 0.1});
  CHECK(*gap_around(around, up, 1.4) == near(std::sqrt(0.5)));
  const Points3 three = {{1, 0, 0}, {-0.5, std::sqrt(0.75), 0}, {-0.5, -std::sqrt(0.75), 0}};
  CHECK(*gap_around(three, up, 2) == near(1));
}

TEST_SUITE_END();
