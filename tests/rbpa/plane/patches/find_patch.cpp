#include "rbpa/plane/patches/find_patch.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/tile/cut.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/one_target.h"
#include "support/shrink.h"
#include "support/spacing.h"
#include "support/tile_laws.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using meshops::Patch;
using rbpa::Block;
using rbpa::Cutter;
using rbpa::FinderWorkspace;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Radius;
using rbpa::Tile;
using rbpa::TilePatch;

TEST_SUITE_BEGIN("patches");

namespace {

using P = rbpa::Predicates<double>;

/// Returns infinity, some circumradii exactly or nearly, and a radius without triangles.
std::vector<Radius> radii(const SiteSet& sites) {
  Random random(1);
  std::vector<Radius> all = {Radius()};
  for (int i = 0; i < 3 && !sites.delaunay.empty(); ++i) {
    const Triangle& t = sites.delaunay[random.below(sites.delaunay.size())];
    const Point &a = sites.points[t[0]], &b = sites.points[t[1]], &c = sites.points[t[2]];
    const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
    const double r = std::sqrt(P::dot(ab, ab)) * std::sqrt(P::dot(bc, bc)) * std::sqrt(P::dot(ca, ca)) /
                     (2 * std::abs(P::cross(ab, ca)));
    const double shortest = std::sqrt(std::min({P::dot(ab, ab), P::dot(bc, bc), P::dot(ca, ca)}));
    if (std::isfinite(r) && r > 0) all.emplace_back(std::max(r * (random.chance(0.3) ? 0.7 : 1), shortest / 2));
  }
  return all;
}

void check(const TileSet& set, std::uint32_t max_points) {
  CAPTURE(set.name);
  const std::string wrong = wrong_on(set.points, max_points, radii);
  if (wrong.empty()) return;
  const Points small =
      shrink(set.points, [&](const Points& p) { return p.size() > 2 && !wrong_on(p, max_points, radii).empty(); });
  FAIL_CHECK(set.name << ", at most " << max_points << " in a tile, " << wrong << "; less points: " << literal(small)
                      << ": " << wrong_on(small, max_points, radii));
}

}  // namespace

TEST_CASE("the results of a tile are true and equal on every vector unit, with all points in a tile") {
  for (const TileSet& set : tile_sets()) check(set, 2048);
}

TEST_CASE("the results of a tile are true and equal on every vector unit, for small tiles") {
  for (const TileSet& set : tile_sets())
    for (const std::uint32_t most : {5u, 40u}) check(set, most);
}

TEST_CASE("the results of a tile are true and equal on every vector unit, for few points") {
  Random random(2);
  for (int round = 0; round < trials(600); ++round) {
    CAPTURE(round);
    const TileSet set = few_points(random);
    for (const std::uint32_t most : {1u, 6u, 2048u}) check(set, most);
  }
}

TEST_CASE("the results of a tile are true and equal on every vector unit, next to unknown crowds") {
  Random random(6);
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    TileSet set{"beside a crowd", scaled(uniform(15 + random.below(36), random.bits()), 1)};
    const double width = random.between(0.01, 1);
    const Point at = {random.between(0, 14), random.between(0, 14)};
    for (int i = 0; i < 70; ++i) set.points.push_back({at.x + width * random.unit(), at.y + width * random.unit()});
    for (const std::uint32_t most : {1u, 3u}) check(set, most);
  }
}

TEST_CASE("a point off a lattice by less than differences can resolve is not on the lattice") {
  // Differences from the third point round to those from (0, 0), which would be cocircular with the others.
  const Points five = {{1, 2}, {-2, 1}, {0x1p-60, 0}, {-2, -1}, {-1, 0}};
  const Points nine = {{2, 1}, {3, 2}, {-3, 3}, {-3, -2}, {2, -2}, {-1, -3}, {3, -1}, {1e-20, 1e-20}, {3, 1}};
  for (const Points& points : {five, nine})
    for (const std::uint32_t most : {1u, 6u, 2048u}) check({"lattice around a stranger", points}, most);
}

TEST_CASE("a tile finds the same whatever the workspace and the result were used for before") {
  Random random(3);
  FinderWorkspace used;
  TilePatch again;
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    const PointGrid grid(set.points);
    auto blocks = rbpa::blocks(grid, 10);
    const auto coarse = rbpa::blocks(grid, 2048);
    blocks.insert(blocks.end(), coarse.begin(), coarse.end());
    random.shuffle(blocks);
    Cutter cutter(grid);
    Tile tile;
    for (const Block& block : blocks) {
      cutter.cut(block, tile);
      FinderWorkspace fresh;
      TilePatch found;
      find_patch(tile, Radius(), fresh, found);
      find_patch(tile, Radius(), used, again);
      CHECK(same(found, again));
    }
  }
  find_patch(Tile(), Radius(), used, again);
  CHECK(again.patch.triangles.empty());
  CHECK(again.patch.across.empty());
  CHECK(again.settled.empty());
}

TEST_CASE("tiles along streets give up and find nothing, on every vector unit") {
  Random random(8);
  Points streets;
  for (int i = 0; i < 20000; ++i) {
    const double along = random.unit(), street = random.integer(0, 12) / 12.0;
    streets.push_back(random.chance(0.5) ? Point{along, street} : Point{street, along});
  }
  const PointGrid grid(streets);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const OneTarget only(target);
    std::size_t triangles = 0;
    for (const TilePatch& tile : patches_of(grid, Radius(), 2048)) triangles += tile.patch.triangles.size();
    CHECK(triangles < streets.size() / 8);
  }
}

TEST_CASE("a tile with all points settles most sites and finds most triangles of a set of even density") {
  for (const TileSet& set :
       {TileSet{"uniform", uniform(1500, 5)}, TileSet{"grid", perfect_grid(40, 1)},
        TileSet{"fine grid far out", moved(perfect_grid(40, 0x1p-20), 0x1p30, 0x1p31)},
        TileSet{"grid of tenths", perfect_grid(40, 0.1)}, TileSet{"rotated", rotated_rounded_grid(40)}}) {
    CAPTURE(set.name);
    const SiteSet sites(set.points);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const OneTarget only(target);
      for (const std::uint32_t most : {300u, 2048u}) {
        std::size_t triangles = 0, known = 0;
        const auto patches = patches_of(sites.grid, Radius(), most);
        CHECK(wrong_with(patches, sites.delaunay) == "");
        for (const TilePatch& tile : patches) {
          triangles += tile.patch.triangles.size();
          known += tile.settled.size();
        }
        CHECK(triangles > sites.delaunay.size() * 9 / 10);
        CHECK(known > sites.points.size() * 3 / 4);

        if (set.name != "uniform") continue;
        // With a radius: the sides beyond which it is exceeded; most of them are recognized.
        const Radius radius(0.6 * mean_spacing(set.points));
        std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
        for (const Triangle& t : sites.delaunay)
          for (std::size_t i = 0; i < 3; ++i)
            if (!radius.admits<double>(sites.points[t[0]], sites.points[t[1]], sites.points[t[2]]))
              sides.insert({t[i], t[(i + 1) % 3]});
        std::size_t nothing = 0, open = 0;
        for (const TilePatch& tile : patches_of(sites.grid, radius, most))
          for (std::size_t t = 0; t < tile.patch.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
              const auto from = static_cast<std::uint32_t>(tile.patch.triangles[t][i]),
                         to = static_cast<std::uint32_t>(tile.patch.triangles[t][(i + 1) % 3]);
              if (!sides.contains({to, from})) continue;
              nothing += tile.patch.across[t][i] == Patch::nothing;
              open += tile.patch.across[t][i] == Patch::open;
            }
        CHECK(nothing > 100);
        CHECK(nothing >= 2 * open);
      }
    }
  }
}

TEST_SUITE_END();
