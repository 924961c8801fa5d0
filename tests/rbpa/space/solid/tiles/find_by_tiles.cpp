// Tetrahedra found tile by tile, for any size of leaf, compared with those found by insertion.
#include "rbpa/space/solid/tiles/find_by_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "rbpa/base/progress.h"
#include "rbpa/space/solid/solid.h"
#include "support/arguments.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"

using rbpa::Point3;
using rbpa::Solid;
using rbpa::space::TiledSolid;
using rbpa::space::TileLimits;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the tetrahedra as a solid without the isolated points; nothing where coordinates spread too far for tiles.
std::optional<Solid> by_tiles(const Points3& points, double alpha, std::size_t points_in_leaf, unsigned threads) {
  const rbpa::space::Spread spread = rbpa::space::spread(points);
  const double scaled_alpha = std::ldexp(alpha, spread.exponent);
  if (!spread.is_exact || (!std::isinf(alpha) && !std::isnormal(scaled_alpha))) return std::nullopt;
  std::vector<Point3> copy;
  rbpa::Threads several(threads);
  TileLimits limits;  // never reached
  limits.points_in_leaf = points_in_leaf;
  limits.most_crowding = limits.most_unsettled = limits.most_unsettled_at_first = limits.most_exact = INFINITY;
  TiledSolid tiled;
  REQUIRE(rbpa::space::find_by_tiles(rbpa::space::scaled(points, spread, copy), spread, scaled_alpha, several, {},
                                     tiled, limits));
  Solid solid;
  rbpa::space::fill_in(std::move(tiled.rows), tiled.index, points.size(), true, several, {}, solid);
  solid.duplicates = std::move(tiled.duplicates);
  solid.distinct = tiled.distinct;
  return solid;
}

std::size_t compare(const Points3& points, double alpha, std::size_t points_in_leaf, unsigned threads) {
  const auto found = by_tiles(points, alpha, points_in_leaf, threads);
  if (!found) return 0;
  const Solid expected = rbpa::solid(points, alpha);
  CAPTURE(points.size());
  CAPTURE(alpha);
  CAPTURE(points_in_leaf);
  REQUIRE(found->simplices == expected.simplices);
  REQUIRE(found->neighbors == expected.neighbors);
  CHECK(found->duplicates == expected.duplicates);
  CHECK(found->distinct == expected.distinct);
  return expected.simplices.size();
}

}  // namespace

TEST_CASE("tiles find the tetrahedra of insertion for any kind of points, any alpha and any size of leaf") {
  Random random(3161);
  std::size_t compared = 0, sets = 0;
  for (int trial = 0; trial < trials(700); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(space_kinds));
    Points3 points = space_set(kind, 4 + random.below(trial % 4 == 0 ? 900u : 150u), random);
    for (std::size_t copies = random.below(10); copies > 0; --copies)
      points.push_back(points[random.below(points.size())]);
    random.shuffle(points);
    CAPTURE(name(kind));
    CAPTURE(trial);
    const double alpha = random.below(3) != 0 ? INFINITY : space_radius(points, random);
    const std::size_t in_leaf = std::size_t{6} << random.below(8);
    const std::size_t count = compare(points, alpha, in_leaf, static_cast<unsigned>(1 + random.below(2)));
    compared += count;
    sets += count > 0 ? 1u : 0u;
  }
  CHECK(sets > 100);
  CHECK(compared > 40'000);
}

TEST_CASE("tiles handle lattices with slightly moved points, whose hull has edges of 1 and of 1e-18") {
  Random random(3164);
  std::size_t compared = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const Points3 points = moved_lattice(4 + random.below(400), random);
    CAPTURE(trial);
    compared += compare(points, INFINITY, std::size_t{5} << random.below(9), 1);
  }
  CHECK(compared > 20'000);
}

TEST_CASE("tiles handle shapes of a thousand points in leaves of a hundred") {
  std::size_t sets = 0;
  for (const SolidSet& set : solid_sets(1000)) {
    CAPTURE(set.name);
    sets += compare(set.points, INFINITY, 100, 2) > 0 ? 1u : 0u;
  }
  CHECK(sets > 8);
}

TEST_CASE("solid() uses tiles for many points that fill a volume, and the result does not depend on the order") {
  Points3 points = uniform_cube(24'000, 3162);
  // Points far away, which no tile settles.
  for (const double far : {-400.0, 500.0}) points.push_back({far, far / 3, -far / 7});
  const Solid solid = rbpa::solid(points, INFINITY);
  std::size_t tiles = 0;
  rbpa::SolidOptions options;
  options.threads = 1;
  options.progress = [&](const rbpa::Progress&) { return ++tiles > 0; };
  CHECK(rbpa::solid(points, INFINITY, options).simplices == solid.simplices);
  CHECK(tiles < 20);  // insertion would call it once for every few points

  options.threads = 2;
  options.progress = {};
  for (const double alpha : {1.4, 2.0}) {
    const Solid some = rbpa::solid(points, alpha, options);
    std::vector<std::uint32_t> order(points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    Random random(3163);
    random.shuffle(order);
    Points3 shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(points[i]);
    const Solid other = rbpa::solid(shuffled, alpha);
    REQUIRE(other.simplices.size() == some.simplices.size());
    std::vector<std::array<std::uint32_t, 4>> renamed, expected;
    for (auto row : other.simplices) {
      for (std::uint32_t& i : row) i = order[i];
      std::sort(row.begin(), row.end());
      renamed.push_back(row);
    }
    for (auto row : some.simplices) {
      std::sort(row.begin(), row.end());
      expected.push_back(row);
    }
    std::sort(renamed.begin(), renamed.end());
    std::sort(expected.begin(), expected.end());
    CHECK(renamed == expected);
  }
  options.progress = [](const rbpa::Progress& progress) { return progress.triangles < 3000; };
  CHECK_THROWS_AS(rbpa::solid(points, INFINITY, options), rbpa::Cancelled);
}

TEST_CASE("find_by_tiles() gives up where points are crowded, at the hull, or cospherical") {
  rbpa::Threads one;
  const auto gives_up = [&](const Points3& points) {
    TiledSolid tiled;
    return !rbpa::space::find_by_tiles(points, rbpa::space::spread(points), INFINITY, one, {}, tiled);
  };
  CHECK(gives_up(clusters_in_cube(20'000, 1)));
  CHECK(gives_up(on_unit_sphere(20'000, 2)));
  CHECK(gives_up(cubic_grid(27'000, 1, 3)));
  CHECK(!gives_up(uniform_cube(20'000, 4)));
}

TEST_SUITE_END();
