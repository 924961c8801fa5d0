#include "rbpa/plane/tile/cut.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "rbpa/base/exact/magnitude.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/sets.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::Block;
using rbpa::Cutter;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Tile;

TEST_SUITE_BEGIN("tile");

namespace {

bool same(const Tile& a, const Tile& b) {
  return a.x0 == b.x0 && a.y0 == b.y0 && a.cell == b.cell && a.columns == b.columns && a.rows == b.rows &&
         a.nothing_left == b.nothing_left && a.nothing_right == b.nothing_right && a.nothing_below == b.nothing_below &&
         a.nothing_above == b.nothing_above && a.points == b.points && a.site == b.site && a.owned == b.owned &&
         a.start == b.start && a.unknown == b.unknown;
}

/// Returns the first violated law of a tile, "" when there is none.
std::string wrong_with(const Tile& tile, const Block& block, const PointGrid& grid) {
  const auto points = grid.points();
  const std::size_t n = tile.points.size(), cells = tile.cells();
  if (tile.columns < 1 || tile.rows < 1 || !(tile.cell > 0)) return "no cells";
  if (tile.site.size() != n || tile.owned.size() != n) return "sizes";
  if (tile.start.size() != cells + 1 || tile.start.front() != 0 || tile.start.back() != n) return "start";
  if (!tile.unknown.empty() && tile.unknown.size() != cells + 1) return "unknown";
  if (!tile.unknown.empty() && tile.unknown.front() != 0) return "unknown does not begin with 0";

  // Rounding of coordinates and of numbers computed from them.
  const double off_x = 8 * 0x1p-52 * (std::abs(tile.x0) + std::abs(tile.x1()) + tile.columns * tile.cell),
               off_y = 8 * 0x1p-52 * (std::abs(tile.y0) + std::abs(tile.y1()) + tile.rows * tile.cell);
  std::vector<bool> here(points.size(), false);
  std::size_t owned = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    if (tile.start[c] > tile.start[c + 1]) return "start goes down";
    if (!tile.unknown.empty() && tile.unknown[c + 1] - tile.unknown[c] > 1) return "a cell is unknown or not";
    const double x = tile.x0 + static_cast<double>(c % static_cast<std::size_t>(tile.columns)) * tile.cell,
                 y = tile.y0 + static_cast<double>(c / static_cast<std::size_t>(tile.columns)) * tile.cell;
    for (std::size_t i = tile.start[c]; i < tile.start[c + 1]; ++i) {
      const Point& p = tile.points[i];
      if (tile.site[i] >= points.size() || points[tile.site[i]] != p) return "site of point " + std::to_string(i);
      if (here[tile.site[i]]) return "a point is there twice";
      here[tile.site[i]] = true;
      owned += tile.owned[i];
      if (p.x < x - off_x || p.x > x + tile.cell + off_x || p.y < y - off_y || p.y > y + tile.cell + off_y)
        return "point " + std::to_string(i) + " is not in its cell";
    }
  }
  if (owned != block.points) return "it owns other than the points of its block";
  if (owned == 0) return "it owns nothing";
  for (std::size_t s = 0; s < points.size(); ++s) {
    const Point& p = points[s];
    const std::string of_site = " of site " + std::to_string(s);
    if (tile.nothing_left && p.x < tile.x0) return "something is left:" + of_site;
    if (tile.nothing_below && p.y < tile.y0) return "something is below:" + of_site;
    if (tile.nothing_right && p.x > tile.x1() + off_x) return "something is right:" + of_site;
    if (tile.nothing_above && p.y > tile.y1() + off_y) return "something is above:" + of_site;
    if (here[s] || p.x < tile.x0 || p.x > tile.x1() || p.y < tile.y0 || p.y > tile.y1()) continue;
    if (tile.unknown.empty()) return "all should be known, but not the point" + of_site;
    const auto c = static_cast<std::size_t>(tile.row(p.y) * tile.columns + tile.column(p.x));
    if (tile.unknown[c + 1] == tile.unknown[c]) return "its cell should be known, but not the point" + of_site;
  }
  return "";
}

/// Cuts a set into tiles of up to `max_points` points. Returns the number of tiles with unknown cells.
int check_tiles(const Points& points, std::uint32_t max_points) {
  CAPTURE(max_points);
  const PointGrid grid(points);
  Cutter cutter(grid);
  Tile tile;
  int with_unknown = 0;
  std::vector<int> owners(grid.points().size(), 0);
  for (const Block& block : rbpa::blocks(grid, max_points)) {
    CHECK(block.points > 0);
    CHECK((block.points <= max_points || (block.columns == 1 && block.rows == 1)));
    cutter.cut(block, tile);
    if (block.points > Tile::max_points) {
      CHECK(tile.points.empty());
      continue;
    }
    const std::string wrong = wrong_with(tile, block, grid);
    REQUIRE(wrong == "");
    with_unknown += !tile.unknown.empty();
    for (std::size_t i = 0; i < tile.points.size(); ++i) owners[tile.site[i]] += tile.owned[i];
  }
  if (max_points <= Tile::max_points) CHECK(std::count(owners.begin(), owners.end(), 1) == std::ssize(owners));
  return with_unknown;
}

}  // namespace

TEST_CASE("every site has one owner, and a tile has all points of its box or lists the gaps, on small sets") {
  int with_unknown = 0;
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    for (const std::uint32_t most : {1u, 3u, 10u, 40u, 150u, 2048u}) with_unknown += check_tiles(set.points, most);
  }
  CHECK(with_unknown > 0);
}

TEST_CASE("every site has one owner, and a tile has all points of its box or lists the gaps, on few points") {
  Random random(1);
  for (int round = 0; round < trials(400); ++round) {
    const TileSet set = few_points(random);
    CAPTURE(round);
    CAPTURE(set.name);
    for (const std::uint32_t most : {1u, 5u, 2048u}) check_tiles(set.points, most);
  }
}

TEST_CASE("every site has one owner, and a tile has all points of its box or lists the gaps, on generated sets") {
  int with_unknown = 0;
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (points.size() < 2 || !rbpa::fits_double(rbpa::magnitude(points))) continue;
    CAPTURE(set.name);
    for (const std::uint32_t most : {60u, 2048u}) with_unknown += check_tiles(points, most);
  }
  CHECK(with_unknown > 0);
}

TEST_CASE("a tile does not exceed its greatest number of points: its surroundings are unknown then") {
  CHECK(check_tiles(uniform(31000, 4), Tile::max_points) > 0);
}

TEST_CASE("a tile in a grid of its own has the points beyond or lists the gaps, for a crowd next to a crowd") {
  Random random(5);
  int with_unknown = 0;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Points points = scaled(uniform(400, random.bits()), 1);
    const double x = random.between(5, 30), y = random.between(5, 30);
    for (int i = 0; i < 60; ++i) points.push_back({x + random.unit(), y + random.unit()});
    for (int i = 0; i < 2000; ++i) points.push_back({x + 1 + random.between(0, 0.2), y + random.unit()});
    for (const std::uint32_t most : {30u, 2048u}) with_unknown += check_tiles(points, most);
  }
  CHECK(with_unknown > 0);
}

TEST_CASE("a block of more points than a tile can have gives an empty tile") {
  const Points points = jittered_grid(110, 0.9, 2);
  const PointGrid grid(points);
  const auto blocks = rbpa::blocks(grid, 1000000);
  REQUIRE(blocks.size() == 1);
  REQUIRE(blocks[0].points > Tile::max_points);
  Cutter cutter(grid);
  Tile tile;
  cutter.cut(rbpa::blocks(grid, 2048)[0], tile);
  CHECK_FALSE(tile.points.empty());
  cutter.cut(blocks[0], tile);
  CHECK(tile.points.empty());
}

TEST_CASE("a tile does not depend on tiles cut before it") {
  Random random(3);
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    const PointGrid grid(set.points);
    auto blocks = rbpa::blocks(grid, 20);
    const auto coarse = rbpa::blocks(grid, 2048);
    blocks.insert(blocks.end(), coarse.begin(), coarse.end());
    random.shuffle(blocks);
    Cutter used(grid);
    Tile again;
    for (const Block& block : blocks) {
      Cutter fresh(grid);
      Tile tile;
      fresh.cut(block, tile);
      used.cut(block, again);
      CHECK(same(tile, again));
    }
  }
}

TEST_SUITE_END();
