#include "rbpa/plane/hierarchy/level_patch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "rbpa/plane/divide/divide_and_conquer.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/growth_by_tiles.h"
#include "rbpa/plane/hierarchy/site_levels.h"
#include "support/generate.h"
#include "support/sets.h"

using namespace rbpa_test;
using meshops::Patch;
using rbpa::Ladder;
using rbpa::LevelPatch;
using rbpa::Radius;
using rbpa::SiteLevels;
using rbpa::WaitingTriangle;
using rbpa::WaitingTriangles;

TEST_SUITE_BEGIN("hierarchy");

namespace {

using Corners = std::array<meshops::Site, 3>;

bool admits(const Radius& radius, const Points& points, const Corners& t) {
  const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(t[i])]; };
  return radius.admits<double>(at(0), at(1), at(2));
}

/// Returns all triangles, which an infinite ladder admits.
Patch delaunay_patch(const Points& points) {
  std::vector<rbpa::SitePoint> places;
  for (const rbpa::Point& p : points) places.push_back({p, static_cast<std::uint32_t>(places.size())});
  rbpa::Threads one;
  return rbpa::divide_and_conquer<double>(
      places, [](const auto&...) { return 0; }, one);
}

void check_parts(const Points& input, double least) {
  CAPTURE(least);
  rbpa::Threads one;
  const rbpa::Sites sites(input, one);
  Points points;
  for (std::uint32_t s = 0; s < sites.size(); ++s) points.push_back(sites.at(s));
  const Patch patch = delaunay_patch(points);
  const Ladder ladder(least, Radius(), 1e6);
  LevelPatch parts;
  parts.split(patch, SiteLevels(sites, ladder));
  if (parts.later.empty()) parts.first = patch;

  // Both have the same triangles, each on its level.
  std::vector<Corners> first = parts.first.triangles;
  std::sort(first.begin(), first.end());
  std::size_t f = 0, l = 0;
  for (const Corners& t : patch.triangles) {
    if (admits(ladder.radius(0), points, t)) {
      ++f;
      CHECK(std::binary_search(first.begin(), first.end(), t));
      continue;
    }
    REQUIRE(l < parts.later.size());
    const WaitingTriangle& waiting = parts.later[l++];
    CHECK(waiting.corners == t);
    CHECK(waiting.level > 0);
    CHECK(admits(ladder.radius(waiting.level), points, t));
    CHECK_FALSE(admits(ladder.radius(waiting.level - 1), points, t));
  }
  CHECK(f == parts.first.triangles.size());
  CHECK(l == parts.later.size());

  // A triangle across a side is also across it in the part, unless it waits.
  std::map<std::pair<meshops::Site, meshops::Site>, int> side;
  for (std::size_t t = 0; t < parts.first.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      side[{parts.first.triangles[t][i], parts.first.triangles[t][(i + 1) % 3]}] = static_cast<int>(3 * t + i);
  REQUIRE(parts.first.across.size() == parts.first.triangles.size());
  for (const auto& [ends, number] : side) {
    const auto beyond = side.find({ends.second, ends.first});
    const auto n = static_cast<std::size_t>(number);
    const int across = parts.first.across[n / 3][n % 3];
    if (beyond != side.end())
      CHECK(across == beyond->second);
    else
      CHECK(across < 0);
  }
}

}  // namespace

TEST_CASE(
    "a patch is split into a patch of the first level and triangles that wait for the first level that admits them") {
  for (const Points& points : {uniform(400, 1), perfect_grid(15, 1), clusters(20, 2), sparse_grid(20, 0.4, 3)})
    for (const double least : {1e-3, 0.5, 0.7071, 1.0, 3.0, 1e5}) check_parts(points, least);
}

TEST_CASE("no other patch has a triangle at a side beyond which one waits; other sides do not change") {
  // Two triangles at an edge; the second is too large for the first level.
  const Points points = {{0, 0}, {1, 0}, {0, 1}, {10, 10}};
  rbpa::Threads one;
  const rbpa::Sites sites(points, one);
  std::array<meshops::Site, 4> site;
  for (std::uint32_t s = 0; s < sites.size(); ++s) site[sites.input_index()[s]] = s;
  const Corners small = {site[0], site[1], site[2]}, large = {site[2], site[1], site[3]};
  Patch patch;
  patch.triangles = {small, large};
  patch.across = {{Patch::open, 3, Patch::nothing}, {1, Patch::open, Patch::open}};
  LevelPatch parts;
  const Ladder ladder(1, Radius(), 100);
  parts.split(patch, SiteLevels(sites, ladder));
  REQUIRE(parts.first.triangles == std::vector<Corners>{small});
  CHECK(parts.first.across == std::vector<std::array<int, 3>>{{Patch::open, Patch::nothing, Patch::nothing}});
  REQUIRE(parts.later.size() == 1);
  CHECK(parts.later[0].corners == large);
}

TEST_CASE("waiting triangles come level by level, in the order in which they were added") {
  WaitingTriangles waiting;
  waiting.add({{{0, 1, 2}, 5}, {{1, 2, 3}, 2}, {{2, 3, 4}, 5}});
  waiting.add({{{3, 4, 5}, 2}, {{4, 5, 6}, 7}});
  waiting.sort(9);
  const auto of_level = [&](int level) {
    const auto found = waiting.of_level(level);
    return std::vector<Corners>(found.begin(), found.end());
  };
  CHECK(of_level(2) == std::vector<Corners>{{1, 2, 3}, {3, 4, 5}});
  CHECK(of_level(5) == std::vector<Corners>{{0, 1, 2}, {2, 3, 4}});
  CHECK(of_level(7) == std::vector<Corners>{{4, 5, 6}});
  for (const int level : {0, 1, 3, 4, 6, 8, 9}) CHECK(of_level(level).empty());
  const std::vector<std::pair<int, int>> after = {{0, 2}, {1, 2}, {2, 5}, {3, 5}, {4, 5}, {5, 7}, {6, 7}};
  for (const auto& [level, next] : after) CHECK(waiting.after(level) == next);
  for (const int level : {7, 8, 9}) CHECK(waiting.after(level) == Ladder::never);
}

TEST_CASE("there is no next level where no triangle waits") {
  WaitingTriangles none;
  none.sort(3);
  for (int level = 0; level <= 3; ++level) {
    CHECK(none.of_level(level).empty());
    CHECK(none.after(level) == Ladder::never);
  }
}

TEST_SUITE_END();
