#include "rbpa/space/surface/facing_sides.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/arguments.h"
#include "support/space_sets.h"

using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

TEST_CASE("sides at an edge face the next one around it, but only if it is turned toward them") {
  // About the edge from 0 to 1, upward; apexes in twelve directions, 30 degrees apart.
  Points3 points = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < 12; ++i) points.push_back({std::cos(i * M_PI / 6), std::sin(i * M_PI / 6), 0.3});
  Random random(305);
  std::size_t count = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    std::vector<rbpa::EdgeSide> sides;
    std::vector<int> at(12, 0);  // 1: the positive side follows; -1: it precedes
    for (std::uint32_t i = 0; i < 12; ++i) {
      at[i] = random.chance(0.4) ? 0 : random.chance(0.5) ? 1 : -1;
      if (at[i] == 1) sides.push_back({0, 1, 2 + i, i, 0});
      if (at[i] == -1) sides.push_back({1, 0, 2 + i, i, 0});
    }
    random.shuffle(sides);
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected, actual;
    for (std::uint32_t i = 0; i < 12; ++i) {
      if (at[i] != 1) continue;
      std::uint32_t j = (i + 1) % 12;
      while (at[j] == 0) j = (j + 1) % 12;
      if (at[j] == -1) expected.emplace(i, j);
    }
    for (const auto& [i, j] : rbpa::facing_sides(points, sides)) actual.emplace(sides[i].triangle, sides[j].triangle);
    CHECK(actual == expected);
    count += expected.size();
  }
  CHECK(count > trials(300));
}

TEST_SUITE_END();
