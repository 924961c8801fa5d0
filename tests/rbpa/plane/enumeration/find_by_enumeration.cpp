#include "rbpa/plane/enumeration/find_by_enumeration.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

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
using rbpa::LocalFront;
using rbpa::Point;
using rbpa::Radius;
using rbpa::Tile;

TEST_SUITE_BEGIN("enumeration");

namespace {

using P = rbpa::Predicates<double>;

std::vector<Tile> tiles_of(const rbpa::PointGrid& grid, std::uint32_t max_points) {
  std::vector<Tile> tiles;
  rbpa::Cutter cutter(grid);
  for (const rbpa::Block& block : rbpa::blocks(grid, max_points)) cutter.cut(block, tiles.emplace_back());
  return tiles;
}

struct Workspace {
  rbpa::TileWorkspace tile;
  rbpa::EnumerationWorkspace own;
};

bool is_enumerated(const Tile& tile, const Radius& radius, Workspace& workspace) {
  rbpa::TilePatch found;
  workspace.tile.coordinates.assign(tile);
  return find_by_enumeration(tile, radius, workspace.tile, workspace.own, found);
}

/// Returns the triangles on the front of a workspace, as sites.
std::vector<Triangle> found_on(const Tile& tile, const LocalFront& front) {
  std::vector<Triangle> found;
  for (std::size_t t = 1; t < front.triangles(); ++t)
    found.push_back({tile.site[front.from(4 * t)], tile.site[front.from(4 * t + 1)], tile.site[front.from(4 * t + 2)]});
  return canonical(std::move(found));
}

std::vector<Triangle> expected_on(const Tile& tile, const std::vector<Triangle>& complex) {
  std::set<std::uint32_t> own;
  for (std::size_t v = 0; v < tile.points.size(); ++v)
    if (tile.owned[v]) own.insert(tile.site[v]);
  std::vector<Triangle> expected;
  std::copy_if(complex.begin(), complex.end(), std::back_inserter(expected), [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t s) { return own.contains(s); });
  });
  return expected;
}

double circumradius(const Points& points, const Triangle& t) {
  const auto ab = P::from(points[t[0]], points[t[1]]), bc = P::from(points[t[1]], points[t[2]]),
             ca = P::from(points[t[2]], points[t[0]]);
  return std::sqrt(P::dot(ab, ab)) * std::sqrt(P::dot(bc, bc)) * std::sqrt(P::dot(ca, ca)) /
         (2 * std::abs(P::cross(ab, ca)));
}

/// Returns some of the least circumradii, exactly or nearly.
std::vector<Radius> least_radii(const SiteSet& sites) {
  std::vector<double> radii;
  for (const Triangle& t : sites.delaunay)
    if (const double r = circumradius(sites.points, t); std::isfinite(r) && r > 0) radii.push_back(r);
  std::sort(radii.begin(), radii.end());
  std::vector<Radius> some;
  for (const double share : {0.0, 0.03, 0.1, 0.2})
    if (!radii.empty()) some.emplace_back(radii[static_cast<std::size_t>(share * static_cast<double>(radii.size()))]);
  return some;
}

/// Returns lattice points, of which only some are kept.
Points thinned_lattice(int columns, double unit, double kept, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < columns; ++y)
      if (random.chance(kept)) points.push_back({x * unit, y * unit});
  return points;
}

Points circle(int count, double radius, Point center) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double t = 6.283185307179586 * i / count;
    points.push_back({center.x + radius * std::cos(t), center.y + radius * std::sin(t)});
  }
  return points;
}

}  // namespace

TEST_CASE("exactly the triangles within alpha with a corner of the tile are found") {
  for (const TileSet& set : {TileSet{"uniform", uniform(1500, 5)}, TileSet{"jittered", jittered_grid(40, 0.9, 6)},
                             TileSet{"thinned lattice", thinned_lattice(60, 1, 0.3, 7)},
                             TileSet{"thinned lattice of tenths", thinned_lattice(60, 0.1, 0.3, 8)},
                             TileSet{"far out", moved(uniform(800, 9), 0x1p30, -0x1p31)}}) {
    CAPTURE(set.name);
    const SiteSet sites(set.points);
    const double spacing = mean_spacing(sites.points);
    std::vector<double> alphas = {0.1 * spacing, 0.3 * spacing, 0.5 * spacing, 0.65 * spacing};
    for (const Radius& r : least_radii(sites)) alphas.push_back(r.value());
    for (const double alpha : alphas) {
      CAPTURE(alpha);
      const std::vector<Triangle> complex = sites.within(Radius(alpha));
      for (const std::uint32_t most : {100u, 2048u}) {
        const std::vector<Tile> tiles = tiles_of(sites.grid, most);
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
          const OneTarget only(target);
          Workspace workspace;
          std::size_t enumerated = 0;
          for (const Tile& tile : tiles) {
            if (!is_enumerated(tile, Radius(alpha), workspace)) continue;
            ++enumerated;
            CHECK(difference(expected_on(tile, complex), found_on(tile, workspace.tile.front)) == "");
          }
          CHECK(enumerated >= tiles.size() / 2);
        }
      }
    }
  }
}

TEST_CASE("the results of a tile are true and equal on every vector unit, for radii that admit few triangles") {
  Random random(11);
  const auto check = [](const TileSet& set, std::uint32_t most) {
    CAPTURE(set.name);
    const std::string wrong = wrong_on(set.points, most, least_radii);
    if (wrong.empty()) return;
    const Points few =
        shrink(set.points, [&](const Points& p) { return p.size() > 2 && !wrong_on(p, most, least_radii).empty(); });
    FAIL_CHECK(set.name << ", at most " << most << " in a tile, " << wrong << "; less points: " << literal(few) << ": "
                        << wrong_on(few, most, least_radii));
  };
  for (const TileSet& set : tile_sets())
    for (const std::uint32_t most : {5u, 40u, 2048u}) check(set, most);
  for (int round = 0; round < trials(200); ++round) {
    CAPTURE(round);
    check(few_points(random), round % 2 == 0 ? 6 : 2048);
  }
}

TEST_CASE("a tile that enumerates lists every pair within a diameter of which it owns one point only") {
  const SiteSet sites(uniform(1500, 12));
  const Radius radius(0.5 * mean_spacing(sites.points));
  std::size_t pairs = 0;
  for (const Tile& tile : tiles_of(sites.grid, 300)) {
    Workspace workspace;
    REQUIRE(is_enumerated(tile, radius, workspace));
    std::set<std::array<std::uint32_t, 2>> near_rim(workspace.own.near_rim.begin(), workspace.own.near_rim.end());
    for (std::size_t v = 0; v < tile.points.size(); ++v)
      for (std::size_t u = 0; u < tile.points.size(); ++u) {
        if (!tile.owned[v] || tile.owned[u] || !radius.spans<double>(tile.points[v], tile.points[u])) continue;
        CHECK(near_rim.contains({tile.site[v], tile.site[u]}));
        ++pairs;
        // Its site may prove not to be settled: the points near it are listed then as well.
        for (std::size_t w = 0; w < tile.points.size(); ++w)
          if (w != v && tile.owned[w] && radius.spans<double>(tile.points[v], tile.points[w]))
            CHECK(near_rim.contains({tile.site[w], tile.site[v]}));
      }
  }
  CHECK(pairs > 100);
}

TEST_CASE("where alpha is small a tile settles all its sites except those near other tiles, even without a triangle") {
  const SiteSet sites(uniform(1500, 13));
  for (const double alpha : {0.01, 0.3, 0.5}) {
    CAPTURE(alpha);
    const Radius radius(alpha * mean_spacing(sites.points));
    std::size_t known = 0, shared = 0;
    for (const auto& tile : patches_of(sites.grid, radius, 2048)) {
      known += tile.settled.size();
      shared += tile.shared.size();
    }
    CHECK(known + shared == sites.points.size());
    CHECK(shared < sites.points.size() / 20);
  }
}

TEST_CASE("nothing is enumerated where it would not pay, or where points are unknown") {
  Workspace workspace;
  const auto is_first_enumerated = [&](const Points& points, double alpha) {
    const Tile tile = tiles_of(rbpa::PointGrid(points), 2048).front();
    return is_enumerated(tile, Radius(alpha), workspace);
  };
  const Points even = uniform(1000, 14);
  CHECK(is_first_enumerated(even, 0.5));
  CHECK_FALSE(is_first_enumerated(even, 1));

  Tile tile = tiles_of(rbpa::PointGrid(even), 2048).front();
  CHECK_FALSE(is_enumerated(tile, Radius(), workspace));
  tile.unknown.assign(tile.cells() + 1, 0);
  CHECK_FALSE(is_enumerated(tile, Radius(0.5), workspace));
  tile.unknown.clear();
  tile.nothing_left = false;
  CHECK(is_enumerated(tile, Radius(0.5), workspace));
  tile.x0 += 2 * tile.cell;  // its own points then reach to where there may be unknown points
  CHECK_FALSE(is_enumerated(tile, Radius(0.5), workspace));

  // More points around a point than are listed, and so many ties that they cost more than they save.
  Points crowded = even;
  for (const Point& p : moved(scaled(uniform(60, 15), -10), 10, 10)) crowded.push_back(p);
  CHECK_FALSE(is_first_enumerated(crowded, 0.3));
  Points clumps = even;
  for (int i = 0; i < 10; ++i)
    for (const Point& p : moved(scaled(uniform(40, 16), -10), 3.0 * i + 1, 10)) clumps.push_back(p);
  CHECK_FALSE(is_first_enumerated(clumps, 0.3));
  Points tied = even;
  for (int i = 0; i < 10; ++i)
    for (const Point& p : circle(12, 0.1, {3.0 * i + 1.5, 20})) tied.push_back(p);
  CHECK_FALSE(is_first_enumerated(tied, 0.11));
}

TEST_SUITE_END();
