#include "rbpa/plane/remainder/remainder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/tile/cut.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/shrink.h"
#include "support/spacing.h"
#include "support/tile_laws.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using meshops::Patch;
using rbpa::PointGrid;
using rbpa::Radius;
using rbpa::Remainder;
using rbpa::TilePatch;

TEST_SUITE_BEGIN("remainder");

namespace {

/// Returns the patch of each tile, in any order; of some tiles nothing.
std::vector<TilePatch> patches_of(const PointGrid& grid, const Radius& radius, std::uint32_t max_points,
                                  double share_found, Random& random) {
  std::vector<TilePatch> told;
  rbpa::Cutter cutter(grid);
  rbpa::Tile tile;
  rbpa::FinderWorkspace workspace;
  for (const rbpa::Block& block : rbpa::blocks(grid, max_points)) {
    if (!random.chance(share_found)) continue;
    cutter.cut(block, tile);
    find_patch(tile, radius, workspace, told.emplace_back());
  }
  random.shuffle(told);
  return told;
}

Triangle corners(const std::array<meshops::Site, 3>& t) {
  return canonical(
      {{static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])}})[0];
}

struct Counts {
  std::size_t sites = 0, complete = 0, not_done = 0, told = 0, added = 0;
};

/// Returns the first violated law, "" when there is none.
std::string wrong_with(const Points& input, const Radius& radius, std::uint32_t max_points, double share_found,
                       std::uint64_t seed, Counts& counts) {
  Random random(seed);
  rbpa::Threads one;
  const rbpa::Sites sites(input, one);
  const PointGrid& grid = sites.grid();
  const Points points(grid.points().begin(), grid.points().end());
  std::set<Triangle> complex;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Triangle> at_side;
  for (const Triangle& t : delaunay_by_winners(points)) {
    if (!radius.admits<double>(points[t[0]], points[t[1]], points[t[2]])) continue;
    complex.insert(t);
    for (std::size_t i = 0; i < 3; ++i) at_side[{t[i], t[(i + 1) % 3]}] = t;
  }
  Remainder remainder(sites, radius);
  std::set<Triangle> told;
  for (const TilePatch& tile : patches_of(grid, radius, max_points, share_found, random)) {
    remainder.add(tile);
    for (const auto& t : tile.patch.triangles) told.insert(corners(t));
  }
  counts.sites += points.size();
  for (std::uint32_t s = 0; s < points.size(); ++s) counts.complete += remainder.is_settled(s);
  for (const Triangle& t : complex)
    for (const std::uint32_t s : t)
      if (!told.contains(t) && remainder.is_settled(s))
        return "site " + std::to_string(s) + " is complete, and tiles did not find a triangle there";
  const std::vector<std::uint32_t> not_done = remainder.not_done();
  if (!std::is_sorted(not_done.begin(), not_done.end())) return "not_done is not ascending";
  counts.not_done += not_done.size();
  counts.told += told.size();

  rbpa::Threads threads;
  TilePatch rest;
  remainder.complete(
      threads, [] {}, rest);
  const Patch& patch = rest.patch;
  if (!is_outlined(rest)) return "outline";
  counts.added += patch.triangles.size();
  if (patch.across.size() != patch.triangles.size()) return "sizes";
  std::set<Triangle> all = told;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (!all.insert(corners(patch.triangles[t])).second) return "a triangle comes twice";
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::uint32_t>(patch.triangles[t][i]),
                 to = static_cast<std::uint32_t>(patch.triangles[t][(i + 1) % 3]);
      const auto beyond = at_side.find({to, from});
      const int across = patch.across[t][i];
      if (across >= 0) {
        const auto s = static_cast<std::size_t>(across);
        if (s >= 3 * patch.triangles.size()) return "a side has no counterpart";
        if (patch.across[s / 3][s % 3] != static_cast<int>(3 * t + i)) return "two sides do not name each other";
        if (beyond == at_side.end() || corners(patch.triangles[s / 3]) != beyond->second)
          return "a side is across from another triangle";
      } else if (across == Patch::open) {
        if (beyond == at_side.end() || !told.contains(beyond->second))
          return "a side is open, and tiles found nothing across it";
      } else if (beyond != at_side.end() || across != Patch::nothing) {
        return "a side is marked as having nothing beyond, but something is there";
      }
    }
  }
  if (all.size() != told.size() + patch.triangles.size()) return "a triangle is in both the tiles and the remainder";
  return all == complex ? ""
                        : "the complex has " + std::to_string(complex.size()) + " triangles, not these " +
                              std::to_string(all.size());
}

Counts check(const TileSet& set, const Radius& radius, std::uint32_t max_points, double share_found) {
  constexpr std::uint64_t seed = 5;
  Counts counts, ignored;
  const std::string wrong = wrong_with(set.points, radius, max_points, share_found, seed, counts);
  if (wrong.empty()) return counts;
  const auto fails = [&](const Points& p) {
    return p.size() > 2 && !wrong_with(p, radius, max_points, share_found, seed, ignored).empty();
  };
  const Points few = shrink(set.points, fails);
  FAIL_CHECK(set.name << ", radius " << (radius.is_infinite() ? "infinity" : literal(radius.value())) << ", at most "
                      << max_points << " in a tile: " << wrong << "; less points: " << literal(few) << ": "
                      << wrong_with(few, radius, max_points, share_found, seed, ignored));
  return counts;
}

}  // namespace

TEST_CASE("tiles and remainder are the complex, each triangle once, on sets that are hard for tiles") {
  Counts sum;
  for (const TileSet& set : tile_sets()) {
    const double spacing = mean_spacing(set.points);
    for (const Radius& radius : {Radius(), Radius(0.5 * spacing), Radius(spacing), Radius(3 * spacing)})
      for (const std::uint32_t most : {5u, 40u, 2048u}) {
        const Counts counts = check(set, radius, most, 1);
        sum.complete += counts.complete;
        sum.added += counts.added;
        sum.told += counts.told;
      }
  }
  CHECK(sum.complete > 0);
  CHECK(sum.added > 0);
  CHECK(sum.told > sum.added);
}

TEST_CASE("tiles and remainder are the complex, each triangle once, on few points") {
  Random random(2);
  for (int round = 0; round < trials(1000); ++round) {
    CAPTURE(round);
    const TileSet set = few_points(random);
    const double spacing = mean_spacing(set.points);
    for (const std::uint32_t most : {1u, 6u, 2048u}) {
      check(set, Radius(), most, 1);
      // At least half the shortest distance, as radii are.
      if (spacing > 0 && set.name == "uniform") check(set, Radius(random.between(0.6, 3) * spacing), most, 1);
    }
  }
}

TEST_CASE("tiles and remainder are the complex, each triangle once, when some tiles find nothing") {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const TileSet set{"uniform", uniform(300, random.bits())};
    const double spacing = mean_spacing(set.points);
    for (const double share : {0.0, 0.5, 0.9}) {
      check(set, Radius(), 30, share);
      for (const double alpha : {0.4, 0.6, 0.7, 1.0, 2.0}) check(set, Radius(alpha * spacing), 30, share);
    }
  }
}

TEST_CASE(
    "tiles and remainder are the complex, each triangle once, on a wheel whose every other triangle is too large") {
  Random random(4);
  Points wheel = {{0, 0}};
  double t = -1;
  for (int i = 0; t < 1; ++i, t += i % 2 == 0 ? 0.01 : 0.03) {
    const double u = 1 + t * t;
    wheel.push_back({(1 - t * t) / u, 2 * t / u});
    wheel.push_back({(t * t - 1) / u, -2 * t / u});
  }
  for (const double alpha : {0.50001, 0.5001, 0.5003, 0.501, 0.6, 0.99, 1.01})
    for (const std::uint32_t most : {10u, 2048u}) check({"wheel", wheel}, Radius(alpha), most, 1);
}

TEST_CASE("where density is even nearly all sites are done, however many tiles there are") {
  for (const Points& points : {uniform(1500, 6), jittered_grid(40, 0.9, 7), perfect_grid(40, 1)})
    for (const Radius& radius : {Radius(), Radius(1)}) {
      const Counts counts = check({"even", points}, radius, 100, 1);
      // The hull and its neighbors, and their neighbors where a circle is large.
      CHECK(counts.not_done < 0.3 * static_cast<double>(counts.sites));
      CHECK(counts.complete > 0.8 * static_cast<double>(counts.sites));
      CHECK(counts.added < counts.told / 40);
    }
}

TEST_CASE("an exception while the remainder is completed reaches the caller") {
  const Points points = uniform(20000, 8);
  rbpa::Threads one;
  const rbpa::Sites sites(points, one);
  Remainder remainder(sites, Radius());
  rbpa::Threads threads;
  TilePatch rest;
  CHECK_THROWS_AS(remainder.complete(
                      threads, [] { throw std::string("stop"); }, rest),
                  std::string);
}

TEST_SUITE_END();
