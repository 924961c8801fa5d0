#include "rbpa/space/surface/neighbors/find_nearest.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::Neighborhoods;

TEST_SUITE_BEGIN("space");

namespace {

template <typename Real>
Real square(const Point3& p, const Point3& q) {
  const Real x = Real(p.x) - q.x, y = Real(p.y) - q.y, z = Real(p.z) - q.z;
  return x * x + y * y + z * z;
}

/// Checks that each point is in its place, and that the points around it come first when all others are sorted by
/// distance, then by coordinates.
template <typename Real>
void check(const Points3& points, std::size_t count) {
  rbpa::Threads threads(1);
  const Neighborhoods found = rbpa::space::find_nearest<Real>(points, count, threads, {});
  CHECK(found.count == std::min(count, points.size() - 1));
  REQUIRE(found.place.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    REQUIRE(found.points[found.place[i]] == p);
    Points3 others = points;
    others.erase(others.begin() + static_cast<long>(i));
    std::sort(others.begin(), others.end(), [&](const Point3& q, const Point3& r) {
      const Real to_q = square<Real>(p, q), to_r = square<Real>(p, r);
      return to_q != to_r ? to_q < to_r : q < r;
    });
    others.resize(found.count);
    Points3 actual;
    for (const std::uint32_t j : found.around(found.place[i])) actual.push_back(found.points[j]);
    CHECK(actual == others);
  }
}

}  // namespace

TEST_CASE("the nearest points are those that sorting finds, and the least among ties") {
  Random random(21);
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (const std::size_t size : {1u, 2u, 20u, 150u}) {
      const Points3 any = space_set(static_cast<SpaceKind>(k), size, random);
      const std::set<Point3> distinct(any.begin(), any.end());
      const Points3 points(distinct.begin(), distinct.end());
      for (const std::size_t count : {2u, 7u, 200u}) {
        check<long double>(points, count);
        if (static_cast<SpaceKind>(k) != SpaceKind::extreme) check<double>(points, count);
      }
    }
  }
}

TEST_SUITE_END();
