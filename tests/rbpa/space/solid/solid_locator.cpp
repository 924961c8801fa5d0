#include "rbpa/space/solid/solid_locator.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/solid/solid.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::SolidLocator;

TEST_SUITE_BEGIN("space");

// A span of a temporary would dangle.
using Rows = std::vector<std::array<std::uint32_t, 4>>;
static_assert(std::is_constructible_v<SolidLocator, std::vector<Point3>&, Rows&, Rows&>);
static_assert(!std::is_constructible_v<SolidLocator, std::vector<Point3>, Rows&, Rows&>);
static_assert(!std::is_constructible_v<SolidLocator, std::vector<Point3>&, Rows, Rows&>);
static_assert(!std::is_constructible_v<SolidLocator, std::vector<Point3>&, Rows&, Rows>);

namespace {

/// Returns the first of all tetrahedra that contains a point.
std::uint32_t by_brute_force(const Points3& points, const Solid& delaunay, const Point3& query) {
  for (std::uint32_t t = 0; t < delaunay.simplices.size(); ++t) {
    bool is_inside = true;
    for (const auto& [a, b, c] : rbpa::space::outer_faces) {
      const auto& corner = delaunay.simplices[t];
      is_inside &= rbpa::space::exact::orientation(points[corner[a]], points[corner[b]], points[corner[c]], query) <= 0;
    }
    if (is_inside) return t;
  }
  return Solid::none;
}

Point3 middle(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

/// Returns points of the set, middles of edges, faces and tetrahedra, and other points in and around it.
Points3 queries_for(const Points3& points, const Solid& delaunay, std::size_t count, Random& random) {
  Points3 queries;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& t = delaunay.simplices[random.below(delaunay.simplices.size())];
    const Point3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]], &d = points[t[3]];
    queries.push_back(a);
    queries.push_back(middle(a, b));
    queries.push_back(middle(middle(a, b), c));
    queries.push_back(middle(middle(a, b), middle(c, d)));
    queries.push_back({a.x, b.y, c.z});
    queries.push_back({2 * a.x - b.x, a.y, d.z});
  }
  return queries;
}

}  // namespace

TEST_CASE("each query finds the first tetrahedron that contains it, on sets of every shape and grids full of ties") {
  std::size_t inside = 0, outside = 0;
  for_solids(60, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    const SolidLocator locator(points, delaunay.simplices, delaunay.neighbors);
    Random random(8);
    const Points3 queries = queries_for(points, delaunay, 12, random);
    const std::vector<std::uint32_t> found = locator.find(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      CAPTURE(i);
      CHECK(found[i] == by_brute_force(points, delaunay, queries[i]));
      ++(found[i] == Solid::none ? outside : inside);
    }
  });
  CHECK(inside > 500);
  CHECK(outside > 50);
}

TEST_CASE("every query in a cube of many points finds a tetrahedron, with any number of threads") {
  const Points3 points = uniform_cube(20000, 9);
  const Solid delaunay = rbpa::solid(points, infinity);
  const SolidLocator locator(points, delaunay.simplices, delaunay.neighbors);
  Random random(10);
  Points3 queries;
  for (int i = 0; i < 20000; ++i)
    queries.push_back({random.between(-12, 12), random.between(-12, 12), random.between(-12, 12)});
  const std::vector<std::uint32_t> one = locator.find(queries, {.threads = 1});
  CHECK(one == locator.find(queries, {.threads = 3}));
  for (std::size_t i = 0; i < queries.size(); ++i) {
    REQUIRE(one[i] != Solid::none);
    if (i % 500 == 0) CHECK(one[i] == by_brute_force(points, delaunay, queries[i]));
  }
}

TEST_CASE("a query that is not finite, or far outside, finds none, and so does any query without tetrahedra") {
  const Points3 points = jittered_cubes(100, 11);
  const Solid delaunay = rbpa::solid(points, infinity);
  const SolidLocator locator(points, delaunay.simplices, delaunay.neighbors);
  const double greatest = std::numeric_limits<double>::max();
  const Points3 queries = {{infinity, 0, 0}, {0, std::nan(""), 0}, {greatest, -greatest, greatest}, {-1e9, 1, 1}};
  for (const std::uint32_t t : locator.find(queries)) CHECK(t == Solid::none);
  CHECK(SolidLocator({}, {}, {}).find(queries) == std::vector<std::uint32_t>(4, Solid::none));
}

TEST_CASE("arrays that do not belong together are refused, and a walk that would not end is ended") {
  const Points3 points = jittered_cubes(100, 12);
  Solid delaunay = rbpa::solid(points, infinity);
  CHECK_THROWS_AS(SolidLocator(points, delaunay.simplices, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(SolidLocator(std::span(points).first(50), delaunay.simplices, delaunay.neighbors),
                  meshops::ContractViolation);
  for (auto& row : delaunay.neighbors)
    for (std::uint32_t& n : row)
      if (n == Solid::none) n = 0;
  const SolidLocator locator(points, delaunay.simplices, delaunay.neighbors);
  CHECK_THROWS_AS(locator.find(Points3{{1e6, 1e6, 1e6}}), meshops::ContractViolation);
  CHECK_THROWS_AS(locator.find(points, {.go_on = [] { return false; }}), rbpa::Cancelled);
}

TEST_SUITE_END();
