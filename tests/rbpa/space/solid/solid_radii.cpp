#include "rbpa/space/solid/solid_radii.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/circumradius.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns whether `radius` is the least double at which the tetrahedron is admitted.
bool is_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double radius) {
  using rbpa::space::exact::compare_circumradius;
  const double greatest = std::numeric_limits<double>::max();
  if (std::isinf(radius)) return compare_circumradius(a, b, c, d, greatest) > 0;
  const double below = std::nextafter(radius, 0);
  return compare_circumradius(a, b, c, d, radius) <= 0 && (below == 0 || compare_circumradius(a, b, c, d, below) > 0);
}

double radius_of(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Points3 points = {a, b, c, d};
  const std::array<std::uint32_t, 4> corners = {0, 1, 2, 3};
  return rbpa::circumradii(points, {&corners, 1}).front();
}

void check_radius(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double radius = radius_of(a, b, c, d);
  CAPTURE(radius);
  CHECK(is_rounded_up(a, b, c, d, radius));
  CHECK(rbpa::space::circumradius_rounded_up(a, b, c, d) == radius);
}

/// Returns the greatest number of corners of a solid component.
std::size_t most_corners(const Points3& points, const Solid& solid) {
  const rbpa::SolidComponents components = solid_components(points, solid, solid_boundary(solid));
  std::vector<std::set<std::uint32_t>> corners(components.all.size());
  for (std::size_t t = 0; t < solid.simplices.size(); ++t)
    corners[components.number[t]].insert(solid.simplices[t].begin(), solid.simplices[t].end());
  std::size_t most = 0;
  for (const auto& of : corners) most = std::max(most, of.size());
  return most;
}

void check_same(const Solid& a, const Solid& b) {
  CHECK(a.simplices == b.simplices);
  CHECK(a.neighbors == b.neighbors);
  CHECK(a.isolated == b.isolated);
  CHECK(a.distinct == b.distinct);
  CHECK(a.duplicates.size() == b.duplicates.size());
}

}  // namespace

TEST_CASE("a radius is the least double at which its tetrahedron is in the complex") {
  for (const SolidSet& set : solid_sets(300)) {
    CAPTURE(set.name);
    const Solid delaunay = rbpa::solid(set.points, infinity);
    const std::vector<double> radii = rbpa::circumradii(set.points, delaunay.simplices, 1);
    REQUIRE(radii.size() == delaunay.simplices.size());
    std::size_t wrong = 0;
    const std::size_t step = radii.size() / 3000 + 1;
    for (std::size_t t = 0; t < radii.size(); t += step) {
      const auto& [a, b, c, d] = delaunay.simplices[t];
      wrong += !is_rounded_up(set.points[a], set.points[b], set.points[c], set.points[d], radii[t]);
    }
    CHECK(wrong == 0);
    CHECK(radii == rbpa::circumradii(set.points, delaunay.simplices, 3));
  }
}

TEST_CASE("radii that are doubles, near doubles, or at the limits of the range are rounded up") {
  check_radius({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});  // 1.5
  CHECK(radius_of({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}) == 1.5);
  CHECK(radius_of({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
  const double next = std::nextafter(1, 2);
  check_radius({-1, 0, 0}, {next, 0, 0}, {0, 1, 0}, {0, 0, 1});
  check_radius({-1, 0, 0}, {1, 0, 0}, {0, next, 0}, {0, 0, 1});
  for (const double unit : {0x1p-1074, 0x1p-1060, 0x1p-1022, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000, 0x1p1022}) {
    CAPTURE(unit);
    check_radius({0, 0, 0}, {unit, 0, 0}, {0, unit, 0}, {0, 0, unit});
    check_radius({-unit, 0, 0}, {unit, 0, 0}, {0, unit, 0}, {0, 0, unit});
  }
  // Flat: a radius far above the distances, and one above all doubles.
  check_radius({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-12});
  check_radius({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-300});
  CHECK(std::isinf(radius_of({0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {1e299, 1e299, 1e280})));
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const auto coordinate = [&] {
      return std::ldexp(random.between(-1, 1), static_cast<int>(random.integer(-40, 40)));
    };
    const auto point = [&] { return Point3{coordinate(), coordinate(), coordinate()}; };
    const Point3 a = point(), b = point(), c = point(), d = point();
    if (rbpa::space::exact::orientation(a, b, c, d) != 0) check_radius(a, b, c, d);
  }
}

TEST_CASE("within() a radius is the solid of that radius") {
  for (const SolidSet& set : solid_sets(300)) {
    CAPTURE(set.name);
    const Solid delaunay = rbpa::solid(set.points, infinity);
    const std::vector<double> radii = rbpa::circumradii(set.points, delaunay.simplices);
    std::vector<double> alphas = {0x1p-1000, infinity};
    Random random(4);
    for (int i = 0; i < 4 && !radii.empty(); ++i) {
      const double radius = radii[random.below(radii.size())];
      alphas.push_back(radius);
      alphas.push_back(std::nextafter(radius, 0));
    }
    for (const double alpha : alphas) {
      CAPTURE(alpha);
      if (alpha > 0) check_same(rbpa::within(delaunay, radii, alpha), rbpa::solid(set.points, alpha));
    }
  }
}

TEST_CASE("no point is isolated at the least alpha that covers, and one is below it") {
  for_solids(200, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    const double alpha = rbpa::min_alpha(delaunay, rbpa::circumradii(points, delaunay.simplices));
    CHECK(rbpa::solid(points, alpha).isolated.empty());
    CHECK_FALSE(rbpa::solid(points, std::nextafter(alpha, 0)).isolated.empty());
  });
}

TEST_CASE("one solid component has all points at the least alpha that connects, and none has below it") {
  for_solids(200, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    const double alpha = rbpa::auto_alpha(delaunay, radii);
    CHECK(alpha >= rbpa::min_alpha(delaunay, radii));
    CHECK(most_corners(points, rbpa::within(delaunay, radii, alpha)) == delaunay.distinct);
    CHECK(most_corners(points, rbpa::within(delaunay, radii, std::nextafter(alpha, 0))) < delaunay.distinct);
  });
}

TEST_CASE("a share of the points is covered, or in one piece, from the least alpha on, and outliers do not decide it") {
  for_solids(200, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    for (const double share : {0.3, 0.9, 0.99}) {
      std::size_t wanted = 0;
      while (static_cast<double>(wanted) / static_cast<double>(delaunay.distinct) < share) ++wanted;
      const auto covered = [&](double alpha) { return delaunay.distinct - rbpa::solid(points, alpha).isolated.size(); };
      const double least = rbpa::min_alpha(delaunay, radii, share), whole = rbpa::auto_alpha(delaunay, radii, share);
      CHECK(covered(least) >= wanted);
      CHECK(covered(std::nextafter(least, 0)) < wanted);
      CHECK(most_corners(points, rbpa::within(delaunay, radii, whole)) >= wanted);
      CHECK(most_corners(points, rbpa::within(delaunay, radii, std::nextafter(whole, 0))) < wanted);
    }
  });
  Points3 points = jittered_cubes(1000, 8);
  points.push_back({500, 500, 500});
  const Solid delaunay = rbpa::solid(points, infinity);
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  CHECK(rbpa::auto_alpha(delaunay, radii) > 100);
  CHECK(rbpa::auto_alpha(delaunay, radii, 0.99) < 2);
  CHECK_THROWS_AS(rbpa::min_alpha(delaunay, radii, 0), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::auto_alpha(delaunay, radii, 1.5), meshops::ContractViolation);
}

TEST_CASE("two bodies are covered long before they are in one piece, and a duplicate changes nothing") {
  Points3 points = jittered_cubes(500, 5);
  const std::size_t one = points.size();
  for (std::size_t i = 0; i < one; ++i) points.push_back({points[i].x + 100, points[i].y, points[i].z});
  points.push_back(points[7]);
  const Solid delaunay = rbpa::solid(points, infinity);
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  const double least = rbpa::min_alpha(delaunay, radii), whole = rbpa::auto_alpha(delaunay, radii);
  CHECK(least < 5);
  CHECK(whole > 40);
  CHECK(most_corners(points, rbpa::within(delaunay, radii, 5)) == one);
  CHECK(most_corners(points, rbpa::within(delaunay, radii, std::nextafter(whole, 0))) < 2 * one);
  CHECK(most_corners(points, rbpa::within(delaunay, radii, whole)) == 2 * one);
}

TEST_CASE("threads change neither the least alpha that connects nor the complex within an alpha") {
  Points3 points = jittered_cubes(3000, 9);
  const std::size_t one = points.size();
  for (std::size_t i = 0; i < one; ++i) points.push_back({2 * points[i].x + 60, 2 * points[i].y, 2 * points[i].z});
  const Solid delaunay = rbpa::solid(points, infinity);
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  REQUIRE(radii.size() > 20'000);
  for (const double share : {1e-4, 0.01, 0.4, 0.5, 0.9, 1.0}) {
    CAPTURE(share);
    const double alpha = rbpa::auto_alpha(delaunay, radii, share, {}, 1);
    CHECK(rbpa::auto_alpha(delaunay, radii, share, {}, 2) == alpha);
    const Solid expected = rbpa::within(delaunay, radii, alpha, 1), found = rbpa::within(delaunay, radii, alpha, 2);
    check_same(found, expected);
    const rbpa::SolidBoundary by_one = rbpa::solid_boundary(expected, 1), by_two = rbpa::solid_boundary(expected, 2);
    CHECK(by_two.surface.triangles == by_one.surface.triangles);
    CHECK(by_two.surface.neighbors == by_one.surface.neighbors);
    CHECK(by_two.tetrahedra == by_one.tetrahedra);
  }
}

TEST_CASE("no alpha suffices without a tetrahedron, and invalid radii and those of another solid are refused") {
  const Solid flat = rbpa::solid(Points3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, infinity);
  CHECK(std::isinf(rbpa::min_alpha(flat, {})));
  CHECK(std::isinf(rbpa::auto_alpha(flat, {})));
  CHECK(rbpa::within(flat, {}, 1).isolated.size() == 4);

  Points3 points = jittered_cubes(60, 6);
  points.resize(60);
  const Solid solid = rbpa::solid(points, infinity), bare = rbpa::solid(points, infinity, {.neighbors = false});
  const std::vector<double> radii = rbpa::circumradii(points, solid.simplices);
  CHECK_THROWS_AS(rbpa::min_alpha(solid, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::auto_alpha(solid, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::auto_alpha(bare, radii), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::within(solid, {}, 1), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::within(solid, radii, 0), rbpa::InvalidInput);
  CHECK(rbpa::within(bare, radii, 1).neighbors.empty());
  const std::vector<std::array<std::uint32_t, 4>> beyond = {{0, 1, 2, 3}, {0, 1, 2, 60}};
  CHECK_THROWS_WITH_AS(rbpa::circumradii(points, beyond), "simplex 1 has corner 60, expected one below 60",
                       rbpa::InvalidInput);
}

TEST_SUITE_END();
