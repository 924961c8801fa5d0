#include "rbpa/space/solid/insertion/insertion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "support/for_space_sets.h"
#include "support/order.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::BasicInsertion;
using rbpa::space::ErrorBound;
using rbpa::space::SpatialOrder;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the finite tetrahedra, with sorted corners, after inserting points in that order. Counts in `wrong`
/// neighbors that are not mutual.
template <bool weighted>
std::vector<std::array<std::uint32_t, 4>> inserted(const Points3& points, const std::vector<double>& radii,
                                                   const SpatialOrder& order, rbpa::space::Division division,
                                                   std::size_t& wrong) {
  const rbpa::space::Spread spread = rbpa::space::spread(points, radii);
  std::vector<Point3> copy;
  std::vector<double> copy_of_radii;
  rbpa::Threads threads(2);
  BasicInsertion<weighted> insertion(points, rbpa::space::scaled(points, spread, copy), spread, order, threads, radii,
                                     rbpa::space::scaled(std::span(radii), spread, copy_of_radii), division);
  std::vector<std::array<std::uint32_t, 4>> found;
  if (!insertion.insert_all({})) return found;
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

std::vector<std::array<std::uint32_t, 4>> inserted(const Points3& points, const std::vector<std::uint32_t>& order,
                                                   std::size_t& wrong) {
  return inserted<false>(points, {}, {order, {}, {}}, {.workers = 1}, wrong);
}

}  // namespace

TEST_CASE("the order of insertion does not change the tetrahedra") {
  Random random(99);
  std::size_t wrong = 0;
  for_space_sets(5, 60, 0, random, [&](Points3 points) {
    sort_distinct(points);
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto expected = inserted(points, order, wrong);
    for (int shuffle = 0; shuffle < 4; ++shuffle) {
      random.shuffle(order);
      CHECK(inserted(points, order, wrong) == expected);
    }
  });
  CHECK(wrong == 0);
}

TEST_CASE("the tetrahedra do not depend on how workers in several threads share the insertion") {
  Random random(103);
  rbpa::Threads threads(2);
  std::size_t wrong = 0;
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    const Points3 points = space_set(static_cast<SpaceKind>(k), 700, random);
    std::vector<double> radii(points.size());
    double size = 0;
    for (const Point3& p : points) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    for (double& radius : radii) radius = random.below(3) == 0 ? size / 16 : size / 16 * random.unit();
    const rbpa::space::Spread spread = rbpa::space::spread(points);
    std::vector<Point3> copy;
    const SpatialOrder order =
        rbpa::space::spatial_order(points, rbpa::space::scaled(points, spread, copy), threads, {});
    const auto expected = inserted<false>(points, {}, order, {.workers = 1}, wrong);
    const auto of_balls = inserted<true>(points, radii, order, {.workers = 1}, wrong);
    for (const std::size_t workers : {2u, 3u, 7u, 64u})
      for (const std::size_t least : {2u, 30u}) {
        CHECK(inserted<false>(points, {}, order, {workers, least}, wrong) == expected);
        CHECK(inserted<true>(points, radii, order, {workers, least}, wrong) == of_balls);
      }
  }
  CHECK(wrong == 0);
}

TEST_CASE("workers in several threads insert nearly all points, and one worker inserts the few others") {
  Random random(104);
  const Points3 points = space_set(SpaceKind::cube, 40'000, random);
  rbpa::Threads threads(2);
  const rbpa::space::Spread spread = rbpa::space::spread(points);
  std::vector<Point3> copy;
  const auto scaled = rbpa::space::scaled(points, spread, copy);
  const SpatialOrder order = rbpa::space::spatial_order(points, scaled, threads, {});
  rbpa::space::Insertion insertion(points, scaled, spread, order, threads, {}, {}, {4, 2000});
  REQUIRE(insertion.insert_all({}));
  const auto [after_half, alone] = insertion.waited();
  CHECK(after_half > 0);
  CHECK(after_half < points.size() / 5);
  CHECK(alone < points.size() / 25);

  rbpa::space::Insertion cancelled(points, scaled, spread, order, threads, {}, {}, {4, 2000});
  std::size_t most = 0;
  CHECK_THROWS_AS(cancelled.insert_all([&](const rbpa::Progress& now) {
    CHECK(now.triangles >= most);
    CHECK(now.points == order.order.size());
    most = now.triangles;
    return now.triangles < 20'000;
  }),
                  rbpa::Cancelled);
  CHECK(most >= 20'000);
}

TEST_CASE("a cavity with more vertices than the table has room for is filled correctly") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {  // different collisions of the hash table's entries
    Random random(seed);
    Points3 points = space_set(SpaceKind::near_sphere, 600, random);
    sort_distinct(points);
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
    sort_distinct(points);
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
