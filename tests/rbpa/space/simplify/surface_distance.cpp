// Bounds of the distance of triangles from a surface, and decimation within a certified distance.
#include "rbpa/space/simplify/distance/surface_distance.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/topology/report.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/surface/surface_of.h"
#include "space/simplify/placed.h"
#include "space/simplify/random_meshes.h"
#include "space/simplify/triangle_sets.h"
#include "support/arguments.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using rbpa::space::SurfaceDistance;
using Corners = SurfaceDistance::Corners;

TEST_SUITE_BEGIN("space");

namespace {

using Real = long double;
struct Vector {
  Real x, y, z;
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(Real t, Vector a) { return {t * a.x, t * a.y, t * a.z}; }
};
Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real length(Vector a) { return std::sqrt(dot(a, a)); }
Vector vector(const Point3& p) { return {p.x, p.y, p.z}; }

/// Returns the distance of a point from a triangle: from its plane if the foot is inside, else from a side.
Real distance(Vector p, const std::array<Vector, 3>& t) {
  const Vector n = cross(t[1] - t[0], t[2] - t[0]);
  bool inside = dot(n, n) > 0;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector a = t[k], along = t[(k + 1) % 3] - a;
    inside = inside && dot(cross(n, along), p - a) >= 0;
    const Real whole = dot(along, along), share = whole > 0 ? dot(p - a, along) / whole : 0;
    least = std::min(least, length(p - a - std::clamp<Real>(share, 0, 1) * along));
  }
  return inside ? std::abs(dot(p - t[0], n)) / length(n) : least;
}

struct Soup {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::array<Vector, 3> triangle(std::size_t t) const {
    return {vector(points[corners[t][0]]), vector(points[corners[t][1]]), vector(points[corners[t][2]])};
  }
  /// Returns the distance of the nearest triangle, and the least number of such a triangle.
  std::pair<Real, std::size_t> nearest_to(Vector p) const {
    std::pair<Real, std::size_t> least = {std::numeric_limits<Real>::infinity(), 0};
    for (std::size_t t = 0; t < corners.size(); ++t) least = std::min(least, {distance(p, triangle(t)), t});
    return least;
  }
};

/// Returns the greatest distance of a point of the triangle from the soup, or `greatest` if that is more, up to `gap`:
/// pieces whose middle and radius, or whose corners and nearest triangle, leave nothing greater are dropped.
Real greatest_distance(const std::array<Vector, 3>& triangle, const Soup& soup, Real gap, Real greatest = 0) {
  std::vector<std::array<Vector, 3>> waiting = {triangle};
  while (!waiting.empty()) {
    const auto [a, b, c] = waiting.back();
    waiting.pop_back();
    const Vector middle = Real(1) / 3 * (a + b + c);
    const auto [here, nearest] = soup.nearest_to(middle);
    greatest = std::max(greatest, here);
    if (here + std::max({length(a - middle), length(b - middle), length(c - middle)}) <= greatest + gap) continue;
    const auto one = soup.triangle(nearest);  // the distance from one triangle is convex
    if (std::max({distance(a, one), distance(b, one), distance(c, one)}) <= greatest + gap) continue;
    const Vector p = Real(0.5) * (a + b), q = Real(0.5) * (b + c), r = Real(0.5) * (c + a);
    for (const auto& part : {std::array{a, p, r}, {p, b, q}, {r, q, c}, {p, q, r}}) waiting.push_back(part);
  }
  return greatest;
}

Soup random_soup(std::mt19937& random, std::size_t triangles, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  Soup soup;
  for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
    soup.points.push_back({coordinate(random), coordinate(random), coordinate(random) * 0.2});
    if (i % 3 == 2) soup.corners.push_back({i - 2, i - 1, i});
  }
  return soup;
}

/// Returns the greatest distance at many points of each triangle of a surface.
double sampled(const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
               const SurfaceDistance& from, int steps) {
  double greatest = 0;
  for (const auto& [i, j, k] : triangles) {
    const Point3 &a = points[i], &b = points[j], &c = points[k];
    for (int s = 0; s <= steps; ++s)
      for (int t = 0; s + t <= steps; ++t) {
        const double u = double(s) / steps, v = double(t) / steps, w = 1 - u - v;
        const Point3 p = {u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y, u * a.z + v * b.z + w * c.z};
        greatest = std::max(greatest, from.least({p, p, p}));
      }
  }
  return greatest;
}

}  // namespace

TEST_CASE("the bound of a triangle is at least its greatest distance, which is found without it, and little more") {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
    const Soup soup = random_soup(random, 1 + random() % 8, size);
    const Soup others = random_soup(random, 1, size * (round % 3 == 0 ? 0.3 : 1));
    const Corners corners = {others.points[0], others.points[1], others.points[2]};
    const Real gap = 1e-3L * size, truth = greatest_distance(others.triangle(0), soup, gap);
    const SurfaceDistance from(soup.points, soup.corners);
    const double bound = from.greatest(corners, 0), least = from.least(corners);
    CHECK(truth <= bound);
    CHECK(bound <= 1.0501L * (truth + gap));
    CHECK(least <= (truth + gap) * (1 + 1e-12L));
    CHECK_FALSE(from.is_within(corners, static_cast<double>(truth) * (1 - 1e-9)));
    CHECK(from.is_within(corners, static_cast<double>(truth + gap) * 1.1));
    // Whatever is certified is true.
    for (const double share : {0.9, 0.99, 1.0, 1.001, 1.01})
      if (const double limit = static_cast<double>(truth + gap) * share; from.is_within(corners, limit))
        CHECK(truth <= limit);
  }
}

TEST_CASE("triangles of the surface, and triangles across many of them in their plane, are at no distance") {
  const Triangles grid = sheet(20, 4);
  const SurfaceDistance from(grid.points, grid.corners);
  for (const auto& [a, b, c] : grid.corners)
    CHECK(from.greatest({grid.points[a], grid.points[b], grid.points[c]}, 0) < 1e-11);
  const Corners across = {Point3{0.3, 0.2, 0}, {19.7, 3.1, 0}, {7.7, 19.9, 0}};
  CHECK(from.greatest(across, 0) < 1e-11);
  CHECK(from.is_within(across, 1e-11));
  CHECK_FALSE(from.is_within(across, 0));
  const Corners above = {Point3{0.3, 0.2, 0.25}, {19.7, 3.1, 0.25}, {7.7, 19.9, 0.5}};
  CHECK(from.greatest(above, 0) == doctest::Approx(0.5).epsilon(0.06));
  CHECK(from.greatest(above, 0) >= 0.5);
  CHECK((from.is_within(above, 0.5000001) && !from.is_within(above, 0.4999999)));
  // Beyond the rim, and where products overflow.
  CHECK(from.greatest({Point3{5, 5, 0}, {26, 5, 0}, {5, 7, 0}}, 0) == doctest::Approx(6).epsilon(0.06));
  CHECK_FALSE(from.is_within({Point3{5, 5, 0}, {1e300, 5, 0}, {5, 7, 0}}, 1e299));
  CHECK(from.greatest({Point3{5, 5, 0}, {1e300, 5, 0}, {5, 7, 0}}, 0) == std::numeric_limits<double>::infinity());
  const SurfaceDistance none({}, {});
  CHECK_FALSE(none.is_within(across, 1e9));
  CHECK(none.greatest(across, 0) == std::numeric_limits<double>::infinity());
}

TEST_CASE("bounds do not depend on the order of triangles, and corners") {
  std::mt19937 random(2);
  const Triangles t = read_off(bundled_data() / "m3_spot.off"), other = shuffled(t, random);
  const SurfaceDistance one(t.points, t.corners), two(other.points, other.corners);
  for (int round = 0; round < 200; ++round) {
    const auto point = [&] { return t.points[random() % t.points.size()]; };
    const Corners corners = {point(), point(), point()};
    CHECK(one.greatest(corners, 0) == two.greatest(corners, 0));
    CHECK(one.is_within(corners, 0.2) == two.is_within(corners, 0.2));
  }
}

TEST_CASE("a decimation within an error is certified, and what was measured by sampling is below it") {
  for (const char* name :
       {"m3_spot.off", "m3_torus.off", "m3_bob.off", "m3_plate_holes.off", "m3_cube_no_bottom.off"}) {
    INFO(std::string(name));
    const Triangles t = read_off(bundled_data() / name);
    const rbpa::Surface surface = rbpa::surface_of(t.points, t.corners);
    const SurfaceDistance from(t.points, t.corners);
    Point3 low = t.points[0], high = low;
    for (const Point3& p : t.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    std::size_t before = t.corners.size() + 1;
    for (const double share : {0.0, 1e-4, 1e-3, 1e-2, 0.1}) {
      const auto left = rbpa::decimate(t.points, surface, {.error = share * size});
      REQUIRE(left.counts.distance);
      CHECK(*left.counts.distance <= share * size);
      CHECK(sampled(t.points, left.triangles, from, 12) <= *left.counts.distance + 1e-14 * size);
      CHECK((left.triangles.size() <= before || share > 1e-4));
      CHECK(left.counts.is_exhausted);
      if (share == 0.1) CHECK(left.triangles.size() <= t.corners.size() / 4);
      if (share < 1e-2) CHECK(left.counts.refused.contains(rbpa::Decimation::too_far));
      before = left.triangles.size();
    }
  }
}

TEST_CASE("the bound of a decimated mesh is at most 1.5 times what sampling measures, at a tenth of the triangles") {
  for (const char* name : {"m3_spot.off", "m3_torus.off", "m3_plate_holes.off"}) {
    const Triangles t = read_off(bundled_data() / name);
    const rbpa::Surface surface = rbpa::surface_of(t.points, t.corners);
    const auto left = rbpa::decimate(t.points, surface, {.faces = t.corners.size() / 10, .measured = true});
    REQUIRE(left.counts.distance);
    const double measured = sampled(t.points, left.triangles, SurfaceDistance(t.points, t.corners), 30);
    INFO(std::string(name));
    CHECK(measured <= *left.counts.distance);
    CHECK(*left.counts.distance <= 1.5 * measured);
  }
}

TEST_CASE("what decimations of random surfaces certify is true, and at most a twentieth more than the distance") {
  std::size_t farther = 0;
  const auto count = static_cast<unsigned>(argument("certificates", 200));
  for (unsigned seed = 0, done = 0; done < count; ++seed) {
    const Triangles t = random_surface(seed);
    if (t.corners.size() > 60) continue;  // the distance is found without a tree
    ++done;
    CAPTURE(seed);
    Placed with(t);
    const double error = std::ldexp(1.0, -static_cast<int>(seed % 5));
    const auto counts = rbpa::decimate(with.mesh, with.places, {.error = error}, {.at_ends = seed % 3 == 0});
    const Soup given{t.points, t.corners}, left{with.places, rbpa::space::corners_of(with.mesh)};
    Real truth = 0;
    const Real gap = 0.05L * error;
    for (std::size_t i = 0; i < left.corners.size(); ++i)
      truth = std::max(truth, greatest_distance(left.triangle(i), given, gap, truth));
    CHECK(*counts.distance <= error);
    CHECK(truth <= *counts.distance);
    CHECK(*counts.distance <= 1.0501L * (truth + gap));
    farther += truth > error / 4;
  }
  CHECK(farther > count / 4);
}

TEST_CASE("an error that is NaN is refused, and errors below 0 allow no collapse") {
  const Triangles t = sphere(2);
  const rbpa::Surface surface = rbpa::surface_of(t.points, t.corners);
  CHECK_THROWS_AS(rbpa::decimate(t.points, surface, {.error = std::nan("")}), meshops::ContractViolation);
  CHECK(rbpa::decimate(t.points, surface, {.error = -1.0}).counts.collapses == 0);
  CHECK(rbpa::decimate(t.points, surface, {.error = std::numeric_limits<double>::infinity()}).counts.left == 4);
  CHECK(rbpa::decimate(t.points, surface, {.faces = 1000, .measured = true}).counts.distance == 0.0);
}

TEST_SUITE_END();
