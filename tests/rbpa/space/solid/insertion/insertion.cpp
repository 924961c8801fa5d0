#include "rbpa/space/solid/insertion/insertion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "rbpa/space/predicate/exact.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::ErrorBound;
using rbpa::space::Insertion;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the finite tetrahedra, with sorted corners, after inserting points in that order. Counts in `wrong`
/// neighbors that are not mutual.
std::vector<std::array<std::uint32_t, 4>> inserted(const Points3& points, const std::vector<std::uint32_t>& order,
                                                   std::size_t& wrong) {
  const rbpa::space::Spread spread = rbpa::space::spread(points);
  std::vector<Point3> copy;
  Insertion insertion(points, rbpa::space::scaled(points, spread, copy), spread, order);
  std::vector<std::array<std::uint32_t, 4>> found;
  if (!insertion.begin()) return found;
  for (rbpa::space::Vertex v = 5; v <= insertion.size(); ++v) insertion.insert(v);
  const auto tetrahedra = insertion.tetrahedra();
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (insertion.is_deleted(t)) continue;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const auto face = tetrahedra[t].neighbor[k];
      wrong += tetrahedra[face / 4].neighbor[face % 4] != 4 * t + k || insertion.is_deleted(face / 4);
    }
    if (tetrahedra[t].is_ghost()) continue;
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) corners[k] = insertion.index()[tetrahedra[t].corner[k]];
    std::sort(corners.begin(), corners.end());
    found.push_back(corners);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST_CASE("the order of insertion does not change the tetrahedra") {
  Random random(99);
  std::size_t wrong = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < 5; ++trial) {
      CAPTURE(name(static_cast<SpaceKind>(k)));
      Points3 points = space_set(static_cast<SpaceKind>(k), 60, random);
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
      std::vector<std::uint32_t> order(points.size());
      std::iota(order.begin(), order.end(), 0u);
      const auto expected = inserted(points, order, wrong);
      for (int shuffle = 0; shuffle < 4; ++shuffle) {
        random.shuffle(order);
        CHECK(inserted(points, order, wrong) == expected);
      }
    }
  CHECK(wrong == 0);
}

TEST_CASE("a cavity with more vertices than the table has room for is filled correctly") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {  // different collisions of the hash table's entries
    Random random(seed);
    Points3 points = space_set(SpaceKind::near_sphere, 600, random);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    points.push_back({0, 0, 0});
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::size_t wrong = 0;
    const auto last = inserted(points, order, wrong);
    std::reverse(order.begin(), order.end());
    CHECK(inserted(points, order, wrong) == last);
    CHECK(wrong == 0);
    const auto center = static_cast<std::uint32_t>(points.size() - 1);
    CHECK(std::count_if(last.begin(), last.end(), [&](const auto& t) { return t[3] == center; }) > 900);
  }
}

TEST_CASE("an error bound is rounded up, whatever its size") {
  Random random(101);
  for (int trial = 0; trial < 2000; ++trial) {
    const double constant = std::ldexp(random.unit(), random.integer(-1000, 900)),
                 slope = std::ldexp(random.unit(), random.integer(-1000, 900));
    const ErrorBound bound(constant, slope);
    CHECK(bound.constant() > constant);
    CHECK(bound.constant() <= constant * (1 + 0x1p-19) + 0x1p-1020);
    CHECK(bound.slope() > slope);
    CHECK(bound.slope() <= slope * (1 + 0x1p-19) + 0x1p-1020);
    CHECK(!bound.is_deleted());
  }
  CHECK(ErrorBound(0, 0).constant() > 0);
  CHECK(ErrorBound::deleted().is_deleted());
}

TEST_CASE("no point is inside the sphere of a tetrahedron, as integers show") {
  // The result must not depend on the filter.
  Random random(102);
  for (const SpaceKind kind : {SpaceKind::near_sphere, SpaceKind::nearest, SpaceKind::plate, SpaceKind::extreme}) {
    CAPTURE(name(kind));
    Points3 points = space_set(kind, 40, random);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::size_t wrong = 0;
    for (std::array<std::uint32_t, 4> t : inserted(points, order, wrong)) {
      if (rbpa::space::exact::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0)
        std::swap(t[0], t[1]);
      for (const Point3& q : points)
        wrong += rbpa::space::exact::side_of_sphere(points[t[0]], points[t[1]], points[t[2]], points[t[3]], q) > 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_SUITE_END();
