#include "rbpa/plane/partial/cover.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "plane/partial/cuts.h"
#include "support/arguments.h"
#include "support/infinity.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Cover;
using rbpa::Point;
using rbpa::Quadrant;
using rbpa::Region;

TEST_SUITE_BEGIN("partial");

namespace {

Cover sum(const Regions& regions) {
  Cover cover;
  for (const Region& region : regions) cover = cover + Cover(region);
  return cover;
}

std::vector<Quadrant> list(const Cover& cover) { return {cover.quadrants().begin(), cover.quadrants().end()}; }

/// Returns the number of regions that contain the place; −∞ is in a region that begins there.
std::size_t times(const Regions& regions, const Point& place) {
  return static_cast<std::size_t>(
      std::count_if(regions.begin(), regions.end(), [&](const Region& region) { return region.contains(place); }));
}

Region random_region(Random& random) {
  const auto bound = [&] {
    return random.chance(0.1) ? -infinity : random.chance(0.1) ? infinity : random.integer(-4, 4);
  };
  double x0 = bound(), x1 = bound(), y0 = bound(), y1 = bound();
  if (x1 < x0) std::swap(x0, x1);
  if (y1 < y0) std::swap(y0, y1);
  return {x0, y0, x1, y1};
}

/// Returns a place of every kind that borders on integers from −4 to 4 distinguish.
std::vector<Point> places() {
  std::vector<double> along{-infinity, -5};
  for (int i = -4; i <= 4; ++i) along.push_back(i);
  std::vector<Point> all;
  for (const double x : along)
    for (const double y : along) all.push_back({x, y});
  return all;
}

}  // namespace

TEST_CASE("regions of a cut cover the plane in any order, and less when one is missing") {
  Random random(1);
  for (int run = 0; run < trials(300); ++run) {
    Points points;
    for (int i = random.integer(1, 40); i > 0; --i)
      points.push_back({double(random.integer(-9, 9)), double(random.integer(-9, 9))});
    Regions regions = any_cut(points, 12, random);
    random.shuffle(regions);
    REQUIRE(sum(regions).is_whole());
    CHECK(!sum(regions).wrong());
    CHECK(!sum(regions).missing());
    const Region last = regions.back();
    regions.pop_back();
    const bool was_empty = !(last.x0 < last.x1 && last.y0 < last.y1);
    REQUIRE(sum(regions).is_whole() == was_empty);
    REQUIRE(sum(regions).missing().has_value() == !was_empty);
    if (!was_empty) CHECK(last.contains(*sum(regions).missing()));
  }
}

TEST_CASE("overlaps and gaps of random regions are found, and no others") {
  Random random(2);
  int overlaps = 0;
  for (int run = 0; run < trials(2000); ++run) {
    Regions regions;
    for (int i = random.integer(0, 4); i > 0; --i) regions.push_back(random_region(random));
    bool twice = false, none = false;
    for (const Point& place : places()) {
      twice = twice || times(regions, place) > 1;
      none = none || times(regions, place) == 0;
    }
    const Cover cover = sum(regions);
    REQUIRE(cover.wrong().has_value() == twice);
    if (twice) CHECK(times(regions, *cover.wrong()) > 1);
    if (!twice) REQUIRE(cover.missing().has_value() == none);
    if (!twice && none) CHECK(times(regions, *cover.missing()) == 0);
    overlaps += twice ? 1 : 0;
  }
  CHECK(overlaps > 100);
  CHECK(overlaps < 1900);
}

TEST_CASE("a part of the plane is the same however it was cut") {
  const Regions across{{0, 0, 1, 3}, {1, 0, 2, 3}, {2, 0, 3, 3}}, up{{0, 0, 3, 1}, {0, 1, 3, 2}, {0, 2, 3, 3}};
  CHECK(list(sum(across)) == list(sum(up)));
  CHECK(list(sum(across)) == list(Cover(Region{-0.0, -0.0, 3, 3})));
  CHECK(list(sum(across)).size() == 4);
}

TEST_CASE("a negative cover is wrong") {
  CHECK(Cover(std::vector<Quadrant>{{{0, 0}, -1}}).wrong());
  CHECK(Cover(std::vector<Quadrant>{{{0, 0}, 1}, {{1, -1}, -1}}).wrong());
}

TEST_SUITE_END();
