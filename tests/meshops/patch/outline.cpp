// survey(): the parts of a patch that connect it to the mesh around it.
#include "meshops/patch/outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "support/arguments.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Returns some of the triangles of a grid, a band or a torus, in any order.
Patch random_patch(std::mt19937& random) {
  const auto columns = static_cast<std::uint32_t>(4 + random() % 4),
             rows = static_cast<std::uint32_t>(4 + random() % 4);
  const PolygonSoup grid = shuffled(grid_soup(columns, rows, random() % 2 == 0, random() % 3 == 0), random, true).soup;
  const std::size_t kept = 2 + random() % 9;
  Patch patch;
  std::map<std::pair<Site, Site>, int> side_at;
  for (std::size_t f = 0; f < grid.faces(); ++f) {
    if (random() % 10 >= kept) continue;
    const auto corners = grid.face(f);
    auto& triangle = patch.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<Site>(corners[i]);
    for (std::size_t i = 0; i < 3; ++i)
      side_at[{triangle[i], triangle[(i + 1) % 3]}] = static_cast<int>(3 * patch.triangles.size() - 3 + i);
  }
  for (const auto& t : patch.triangles) {
    auto& across = patch.across.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto beyond = side_at.find({t[(i + 1) % 3], t[i]});
      across[i] = beyond != side_at.end() ? beyond->second : random() % 2 == 0 ? Patch::open : Patch::nothing;
    }
  }
  return patch;
}

/// Returns the open side that ends at a site, among the triangles there that are connected to the given one around the
/// site.
int end_of_fan(const Patch& patch, std::size_t triangle, Site site) {
  std::set<std::size_t> fan = {triangle};
  for (std::size_t before = 0; before != fan.size();) {
    before = fan.size();
    for (const std::size_t t : std::set<std::size_t>(fan))
      for (std::size_t i = 0; i < 3; ++i)
        if (patch.across[t][i] >= 0 && (patch.triangles[t][i] == site || patch.triangles[t][(i + 1) % 3] == site))
          fan.insert(static_cast<std::size_t>(patch.across[t][i]) / 3);
  }
  for (const std::size_t t : fan)
    for (std::size_t i = 0; i < 3; ++i)
      if (patch.across[t][i] < 0 && patch.triangles[t][(i + 1) % 3] == site) return static_cast<int>(3 * t + i);
  return -1;
}

}  // namespace

TEST_SUITE("patch") {
  TEST_CASE("a wheel of any size is surveyed in linear time, whichever way its triangles are numbered") {
    constexpr int spokes = 300000;          // a walk around from each spoke would take minutes
    for (const int step : {1, spokes - 1})  // from one triangle to the next around the hub
      for (const bool closed : {true, false}) {
        Patch wheel;
        for (int t = 0; t < spokes; ++t) {
          const int next = (t + step) % spokes, previous = (t + spokes - step) % spokes;
          wheel.triangles.push_back({0, static_cast<Site>(t) + 1, static_cast<Site>(next) + 1});
          wheel.across.push_back({3 * previous + 2, Patch::open, 3 * next});
        }
        if (!closed) wheel.across.front()[0] = wheel.across[static_cast<std::size_t>(spokes - step)][2] = Patch::open;
        Outline outline;
        survey(wheel, outline);
        CHECK(outline.inside.size() == (closed ? 1 : 0));
        CHECK(outline.rim.size() == (closed ? spokes : spokes + 2));
      }
  }

  TEST_CASE("an outline has the rim, the holes, and for each inner site the last side that comes first in its pair") {
    std::mt19937 random(5);
    Outline outline;
    for (int round = 0; round < rbpa_test::trials(300); ++round) {
      CAPTURE(round);
      const Patch patch = random_patch(random);
      std::vector<int> rim, holes, next_hole;
      std::set<Site> at_rim;
      std::map<Site, int> last;
      for (int s = 0; s < static_cast<int>(3 * patch.triangles.size()); ++s) {
        const auto t = static_cast<std::size_t>(s) / 3, i = static_cast<std::size_t>(s) % 3;
        if (patch.across[t][i] < 0) {
          (patch.across[t][i] == Patch::open ? rim : holes).push_back(s);
          at_rim.insert({patch.triangles[t][i], patch.triangles[t][(i + 1) % 3]});
        } else if (s < patch.across[t][i]) {
          last[patch.triangles[t][i]] = s;
        }
      }
      std::vector<int> inside;
      for (const auto& [site, side] : last)
        if (!at_rim.contains(site)) inside.push_back(side);
      std::sort(inside.begin(), inside.end());
      survey(patch, outline);
      std::sort(outline.inside.begin(), outline.inside.end());
      for (const int hole : holes) {
        const auto t = static_cast<std::size_t>(hole) / 3;
        const int next = end_of_fan(patch, t, patch.triangles[t][static_cast<std::size_t>(hole) % 3]);
        REQUIRE(next >= 0);
        const bool is_hole = std::find(holes.begin(), holes.end(), next) != holes.end();
        next_hole.push_back(is_hole ? next : -1);
      }
      CHECK(outline.rim == rim);
      CHECK(outline.holes == holes);
      CHECK(outline.next_hole == next_hole);
      CHECK(outline.inside == inside);
    }
  }

  TEST_CASE("a patch whose table across is not symmetric is refused") {
    Outline outline;
    const auto refused = [&](const Patch& patch) { CHECK_THROWS_AS(survey(patch, outline), ContractViolation); };
    const std::vector<std::array<Site, 3>> two = {{0, 1, 2}, {2, 1, 3}};
    survey({two, {{-1, 3, -2}, {1, -2, -1}}}, outline);
    CHECK(outline.rim == std::vector<int>{0, 5});
    CHECK(outline.holes == std::vector<int>{2, 4});
    CHECK(outline.next_hole == std::vector<int>{-1, -1});
    CHECK(outline.inside.empty());
    refused({two, {{-1, 3, -2}}});
    refused({two, {{-1, 3, -2}, {1, -2, -1}, {-1, -1, -1}}});
    refused({two, {{-1, 3, -2}, {-1, -2, -1}}});
    refused({two, {{-1, 3, -2}, {0, -2, -1}}});
    refused({two, {{-1, 6, -2}, {1, -2, -1}}});
    refused({two, {{-1, 3, -2}, {1, 4, -1}}});
    refused({two, {{-1, 3, -3}, {1, -2, -1}}});
    refused({{{0, 1, 2}}, {{1, 0, -1}}});
    refused({{{0, 1, 2}}, {{-1, -1, 2}}});
    refused({two, {{-1, -1, -1}, {-1, 5, 4}}});
  }
}
