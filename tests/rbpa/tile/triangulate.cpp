#include "rbpa/tile/triangulate.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshops/front/outline.h"
#include "meshops/front/patch.h"
#include "rbpa/predicate/predicates.h"
#include "rbpa/tile/cut.h"
#include "support/generate.h"
#include "support/one_target.h"
#include "support/shrink.h"
#include "support/spacing.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using meshops::Patch;
using rbpa::Block;
using rbpa::Cutter;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Radius;
using rbpa::Tile;
using rbpa::TileTriangles;
using rbpa::TileWorkspace;

TEST_SUITE_BEGIN("tile");

namespace {

using P = rbpa::Predicates<double>;

/// What each tile tells.
std::vector<TileTriangles> tell(const PointGrid<double>& grid, const Radius& radius, std::uint32_t most_points) {
  std::vector<TileTriangles> told;
  Cutter cutter(grid);
  Tile tile;
  TileWorkspace workspace;
  for (const Block& block : rbpa::blocks(grid, most_points)) {
    cutter.cut(block, tile);
    triangulate(tile, radius, workspace, told.emplace_back());
  }
  return told;
}

bool same(const TileTriangles& a, const TileTriangles& b) {
  return a.patch.triangles == b.patch.triangles && a.patch.across == b.patch.across && a.known == b.known;
}

bool is_outlined(const TileTriangles& told) {
  meshops::Outline expected;
  survey(told.patch, expected);
  std::vector<int> inside = told.outline.inside;
  for (auto* sides : {&inside, &expected.inside}) std::sort(sides->begin(), sides->end());
  return told.outline.rim == expected.rim && told.outline.holes == expected.holes &&
         told.outline.next_hole == expected.next_hole && inside == expected.inside;
}

/// How large two patches are.
std::string unlike(const TileTriangles& a, const TileTriangles& b) {
  return "triangles " + std::to_string(a.patch.triangles.size()) + " and " + std::to_string(b.patch.triangles.size()) +
         ", known " + std::to_string(a.known.size()) + " and " + std::to_string(b.known.size());
}

/// The Delaunay triangles of the sites of a grid, once for many radii.
struct Sites {
  explicit Sites(const Points& input)
      : grid(input), points(grid.points().begin(), grid.points().end()), delaunay(delaunay_by_winners(points)) {}
  PointGrid<double> grid;
  Points points;
  std::vector<Triangle> delaunay;

  std::vector<Triangle> within(const Radius& radius) const {
    std::vector<Triangle> found;
    for (const Triangle& t : delaunay)
      if (radius.is_infinite() ||
          P::compare_circumradius(points[t[0]], points[t[1]], points[t[2]], radius.value()) <= 0)
        found.push_back(t);
    return found;
  }
};

Triangle corners(const std::array<meshops::Site, 3>& t) {
  return canonical(
      {{static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])}})[0];
}

/// The first law of what tiles tell that is broken, "" when none is.
std::string wrong_with(const std::vector<TileTriangles>& told, const std::vector<Triangle>& complex) {
  const std::set<Triangle> expected(complex.begin(), complex.end());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Triangle> at_side;
  std::map<std::uint32_t, std::vector<Triangle>> at;
  for (const Triangle& t : complex)
    for (std::size_t i = 0; i < 3; ++i) {
      at_side[{t[i], t[(i + 1) % 3]}] = t;
      at[t[i]].push_back(t);
    }
  std::set<Triangle> found;
  std::set<std::uint32_t> known;
  for (const TileTriangles& tile : told) {
    const Patch& patch = tile.patch;
    if (patch.across.size() != patch.triangles.size()) return "sizes of a patch";
    if (!is_outlined(tile)) return "the outline of a patch is that of another one";
    std::set<Triangle> of_tile;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      const Triangle triangle = corners(patch.triangles[t]);
      const std::string name = "triangle " + std::to_string(triangle[0]) + " " + std::to_string(triangle[1]) + " " +
                               std::to_string(triangle[2]);
      if (!expected.contains(triangle)) return name + " is not of the complex";
      if (!found.insert(triangle).second) return name + " is told twice";
      of_tile.insert(triangle);
    }
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto from = static_cast<std::uint32_t>(patch.triangles[t][i]),
                   to = static_cast<std::uint32_t>(patch.triangles[t][(i + 1) % 3]);
        const std::string name = "side " + std::to_string(from) + " " + std::to_string(to);
        const auto beyond = at_side.find({to, from});
        const int across = patch.across[t][i];
        if (across == Patch::open || across == Patch::nothing) {
          if (beyond == at_side.end()) continue;
          if (across == Patch::nothing) return name + " has nothing beyond, and there is a triangle";
          if (of_tile.contains(beyond->second)) return name + " is open, and what is beyond is in the patch";
          continue;
        }
        const auto s = static_cast<std::size_t>(across);
        if (across < 0 || s >= 3 * patch.triangles.size()) return name + " is across of nothing";
        if (patch.across[s / 3][s % 3] != static_cast<int>(3 * t + i)) return name + " is not across of what is";
        if (static_cast<std::uint32_t>(patch.triangles[s / 3][s % 3]) != to ||
            static_cast<std::uint32_t>(patch.triangles[s / 3][(s % 3 + 1) % 3]) != from)
          return name + " is across of another edge";
      }
    for (const std::uint32_t s : tile.known) {
      if (!known.insert(s).second) return "site " + std::to_string(s) + " is known twice";
      for (const Triangle& t : at[s])
        if (!of_tile.contains(t)) return "site " + std::to_string(s) + " is known, and a triangle at it is missing";
    }
  }
  return "";
}

/// Infinity, some circumradii exactly or nearly, and a radius for which there is nothing.
std::vector<Radius> radii(const Sites& sites, Random& random, int count) {
  std::vector<Radius> all = {Radius()};
  for (int i = 0; i < count && !sites.delaunay.empty(); ++i) {
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

/// The first thing that is wrong with any target, and whether targets differ.
std::string wrong_on(const Points& input, const Radius* radius, std::uint32_t most_points) {
  const Sites sites(input);
  Random random(1);
  const std::vector<Radius> some = radius ? std::vector<Radius>{*radius} : radii(sites, random, 3);
  for (const Radius& r : some) {
    const std::vector<Triangle> complex = sites.within(r);
    std::vector<TileTriangles> first;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const OneTarget only(target);
      const std::string at = std::string(" by ") + hwy::TargetName(target) + ", radius " +
                             (r.is_infinite() ? "infinity" : literal(r.value()));
      const auto told = tell(sites.grid, r, most_points);
      if (const std::string wrong = wrong_with(told, complex); !wrong.empty()) return wrong + at;
      if (first.empty()) first = told;
      for (std::size_t i = 0; i < told.size(); ++i)
        if (!same(first[i], told[i])) return "another target tells otherwise: " + unlike(first[i], told[i]) + at;
    }
  }
  return "";
}

void check(const TileSet& set, std::uint32_t most_points) {
  CAPTURE(set.name);
  const std::string wrong = wrong_on(set.points, nullptr, most_points);
  if (wrong.empty()) return;
  const Points small =
      shrink(set.points, [&](const Points& p) { return p.size() > 2 && !wrong_on(p, nullptr, most_points).empty(); });
  FAIL_CHECK(set.name << ", at most " << most_points << " in a tile, " << wrong << "; less points: " << literal(small)
                      << ": " << wrong_on(small, nullptr, most_points));
}

}  // namespace

TEST_CASE("what a tile tells is true, and the same by every vector unit: all points in a tile") {
  for (const TileSet& set : tile_sets()) check(set, 2048);
}

TEST_CASE("what a tile tells is true, and the same by every vector unit: small tiles") {
  for (const TileSet& set : tile_sets())
    for (const std::uint32_t most : {5u, 40u}) check(set, most);
}

TEST_CASE("what a tile tells is true, and the same by every vector unit: a few points") {
  Random random(2);
  for (int round = 0; round < 600; ++round) {
    CAPTURE(round);
    const TileSet set = few_points(random);
    for (const std::uint32_t most : {1u, 6u, 2048u}) check(set, most);
  }
}

TEST_CASE("what a tile tells is true, and the same by every vector unit: beside crowds that it does not know") {
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

TEST_CASE("a point that is off a lattice by less than differences can tell is not of the lattice") {
  // Differences from the third point round to those from (0, 0), which would be on a circle with the others.
  const Points five = {{1, 2}, {-2, 1}, {0x1p-60, 0}, {-2, -1}, {-1, 0}};
  const Points nine = {{2, 1}, {3, 2}, {-3, 3}, {-3, -2}, {2, -2}, {-1, -3}, {3, -1}, {1e-20, 1e-20}, {3, 1}};
  for (const Points& points : {five, nine})
    for (const std::uint32_t most : {1u, 6u, 2048u}) check({"lattice around a stranger", points}, most);
}

TEST_CASE("a tile tells the same whatever the workspace and the result were used for before") {
  Random random(3);
  TileWorkspace used;
  TileTriangles again;
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    const PointGrid<double> grid(set.points);
    auto blocks = rbpa::blocks(grid, 10);
    const auto coarse = rbpa::blocks(grid, 2048);
    blocks.insert(blocks.end(), coarse.begin(), coarse.end());
    random.shuffle(blocks);
    Cutter cutter(grid);
    Tile tile;
    for (const Block& block : blocks) {
      cutter.cut(block, tile);
      TileWorkspace fresh;
      TileTriangles told;
      triangulate(tile, Radius(), fresh, told);
      triangulate(tile, Radius(), used, again);
      CHECK(same(told, again));
    }
  }
  triangulate(Tile(), Radius(), used, again);
  CHECK(again.patch.triangles.empty());
  CHECK(again.patch.across.empty());
  CHECK(again.known.empty());
}

TEST_CASE("a tile that has all points knows most sites and triangles of a set of even density") {
  for (const TileSet& set :
       {TileSet{"uniform", uniform(1500, 5)}, TileSet{"grid", perfect_grid(40, 1)},
        TileSet{"fine grid far out", moved(perfect_grid(40, 0x1p-20), 0x1p30, 0x1p31)},
        TileSet{"grid of tenths", perfect_grid(40, 0.1)}, TileSet{"rotated", rotated_rounded_grid(40)}}) {
    CAPTURE(set.name);
    const Sites sites(set.points);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const OneTarget only(target);
      for (const std::uint32_t most : {300u, 2048u}) {
        std::size_t triangles = 0, known = 0;
        const auto told = tell(sites.grid, Radius(), most);
        CHECK(wrong_with(told, sites.delaunay) == "");
        for (const TileTriangles& tile : told) {
          triangles += tile.patch.triangles.size();
          known += tile.known.size();
        }
        CHECK(triangles > sites.delaunay.size() * 9 / 10);
        CHECK(known > sites.points.size() * 3 / 4);

        if (set.name != "uniform") continue;
        // With a radius, the sides beyond which it is exceeded: most are seen to be so.
        const Radius radius(0.6 * mean_spacing(set.points));
        std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
        for (const Triangle& t : sites.delaunay)
          for (std::size_t i = 0; i < 3; ++i)
            if (!radius.admits<double>(sites.points[t[0]], sites.points[t[1]], sites.points[t[2]]))
              sides.insert({t[i], t[(i + 1) % 3]});
        std::size_t nothing = 0, open = 0;
        for (const TileTriangles& tile : tell(sites.grid, radius, most))
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
