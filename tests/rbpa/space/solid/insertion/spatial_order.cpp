#include "rbpa/space/solid/insertion/spatial_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "rbpa/space/solid/insertion/hilbert.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::hilbert_index;
using rbpa::space::spatial_order;

TEST_SUITE_BEGIN("space");

TEST_CASE("the Hilbert curve visits each cell once, and continues through a face") {
  for (const int levels : {1, 2, 3, 4}) {
    const std::uint32_t cells = 1u << levels;
    std::vector<std::array<std::uint32_t, 3>> at(cells * cells * cells, {99, 99, 99});
    for (std::uint32_t x = 0; x < cells; ++x)
      for (std::uint32_t y = 0; y < cells; ++y)
        for (std::uint32_t z = 0; z < cells; ++z) {
          const std::uint64_t index = hilbert_index(x, y, z, levels);
          REQUIRE(index < at.size());
          CHECK(at[index][0] == 99);
          at[index] = {x, y, z};
          // The parts of a cell are consecutive.
          CHECK(hilbert_index(x / 2, y / 2, z / 2, levels - 1) == index / 8);
        }
    for (std::size_t i = 1; i < at.size(); ++i) {
      int steps = 0;
      for (std::size_t k = 0; k < 3; ++k)
        steps += std::abs(static_cast<int>(at[i][k]) - static_cast<int>(at[i - 1][k]));
      CHECK(steps == 1);
    }
  }
}

TEST_CASE("each distinct point comes once, with its lowest index, in an order that depends on the set alone") {
  Random random(97);
  rbpa::Threads threads(2);
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    Points3 points = space_set(static_cast<SpaceKind>(k), 500, random);
    for (int i = 0; i < 20; ++i) points.push_back(points[random.below(points.size())]);
    points.push_back({points[0].x + 0.0, points[0].y == 0 ? -0.0 : points[0].y, points[0].z});
    const auto order = spatial_order(points, points, threads, {});
    std::vector<std::uint32_t> all = order.order;
    for (const rbpa::Duplicate& d : order.duplicates) {
      all.push_back(d.index);
      CHECK(points[d.index] == points[d.stands_for]);
      CHECK(d.stands_for < d.index);
    }
    std::sort(all.begin(), all.end());
    std::vector<std::uint32_t> expected(points.size());
    std::iota(expected.begin(), expected.end(), 0u);
    CHECK(all == expected);
    Points3 distinct;
    for (const std::uint32_t i : order.order) distinct.push_back(points[i]);
    Points3 sorted = distinct;
    std::sort(sorted.begin(), sorted.end());
    CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());

    random.shuffle(points);
    const auto other = spatial_order(points, points, threads, {});
    Points3 again;
    for (const std::uint32_t i : other.order) again.push_back(points[i]);
    CHECK(again == distinct);
  }
}

TEST_CASE("consecutive points are near each other, also in clusters of any size") {
  Random random(98);
  rbpa::Threads threads(2);
  Points3 points;
  for (const double size : {1.0, 1e-5, 1e-12})
    for (int i = 0; i < 1000; ++i)
      points.push_back({1 + size * random.unit(), size * random.unit(), -size * random.unit()});
  const auto order = spatial_order(points, points, threads, {}).order;
  // Within the last round, which has seven points in eight, most steps are shorter than a fifth of the cluster.
  std::array<int, 3> near{};
  for (std::size_t i = points.size() / 5; i < points.size(); ++i) {
    const std::size_t cluster = order[i] / 1000;
    const Point3 &p = points[order[i]], &q = points[order[i - 1]];
    near[cluster] += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < std::array{0.2, 2e-6, 2e-13}[cluster];
  }
  for (const int count : near) CHECK(count > 500);
}

TEST_SUITE_END();
