#include "rbpa/space/search/cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "oracle/rational.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::Cells;

TEST_SUITE_BEGIN("space");

namespace {

bool within_two_radii(const Point3& p, const Point3& q, double radius) {
  const Rational x = rational(p.x) - rational(q.x), y = rational(p.y) - rational(q.y),
                 z = rational(p.z) - rational(q.z);
  return x * x + y * y + z * z <= 4 * rational(radius) * rational(radius);
}

/// Every point is in one cell, and around it are all that are within two radii.
void check(const Points3& points, double radius) {
  const Cells cells(points, radius);
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::set<std::uint32_t> around;
    cells.for_each_around(i, [&](std::size_t j) {
      for (const std::uint32_t p : cells.points_in(j)) CHECK(around.insert(p).second);
    });
    CHECK(!cells.points_in(i).empty());
    for (const std::uint32_t p : cells.points_in(i)) {
      all.push_back(p);
      for (std::uint32_t q = 0; q < points.size(); ++q)
        if (within_two_radii(points[p], points[q], radius)) CHECK(around.contains(q));
    }
  }
  std::sort(all.begin(), all.end());
  CHECK(all.size() == points.size());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

}  // namespace

TEST_CASE("all within two radii of a point are in the cells around its cell") {
  Random random(71);
  for (int trial = 0; trial < 150; ++trial) {
    Points3 points =
        space_set(static_cast<SpaceKind>(random.integer(0, space_kinds - 1)), 1 + random.below(40), random);
    const double radius = space_radius(points, random);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    check(points, radius);
  }
}

TEST_CASE("cells of points that are as far apart as doubles can be, or as near") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Points3 points = {{most, -most, 0},      {-most, most, least},
                          {0, least, -least},    {2 * least, 0, 0},
                          {0x1p-500, 1, 0x1p57}, {1, 1, std::nextafter(0x1p57, 0)},
                          {1, 1, 0x1p57},        {1, 1, std::nextafter(0x1p57, 0x1p58)}};
  for (const double radius : {least, 0x1p-500, 1.0, 0x1.04p0, 8.0, 0x1p60, most / 4, most}) check(points, radius);
}

TEST_CASE("two points exactly two radii apart see each other wherever they lie") {
  for (const double start : {0.0, 1.0, 1.99, -0.01, 1e6, 0x1p40, -0x1p52 + 1})
    for (const double radius : {0.5, 1.0, 3.0})
      check({{start, 0, 0}, {start + 2 * radius, 0, 0}, {0, start, -2 * radius}, {0, start, 0}}, radius);
}

TEST_CASE("the order of the cells does not depend on that of the points") {
  Random random(72);
  Points3 points = space_set(SpaceKind::cube, 60, random);
  const auto in_order = [](const Points3& of) {
    const Cells cells(of, 0.3);
    Points3 result;
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (const std::uint32_t p : cells.points_in(i)) result.push_back(of[p]);
    return result;
  };
  const Points3 expected = in_order(points);
  random.shuffle(points);
  CHECK(in_order(points) == expected);
  CHECK(Cells(Points3{}, 1).size() == 0);
}

TEST_SUITE_END();
