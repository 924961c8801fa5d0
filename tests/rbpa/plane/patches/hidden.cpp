// Tests tiles near hidden points, which are not in the grid: the results hold for all points.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "rbpa/plane/grid/hidden_points.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/tile/cut.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::PointGrid;
using rbpa::Radius;

TEST_SUITE_BEGIN("patches");

namespace {

struct Counts {
  std::size_t triangles = 0, known = 0;
};

/// Hides some points, and computes the tiles of the others.
Counts check_hidden(const Points& points, const Points& hidden, const Radius& radius) {
  const PointGrid grid(points);
  const auto& all = grid.levels()[0];
  const rbpa::HiddenPoints places(hidden, {{all.x, all.y}, {all.x + all.width, all.y + all.height}});
  // The complex of all points, numbered by their positions here: those of the grid first.
  Points together(grid.points().begin(), grid.points().end());
  together.insert(together.end(), hidden.begin(), hidden.end());
  std::set<Triangle> complex;
  for (const Triangle& t : delaunay_by_winners(together))
    if (radius.admits<double>(together[t[0]], together[t[1]], together[t[2]])) complex.insert(t);

  Counts counts;
  std::set<Triangle> found;
  std::vector<std::uint32_t> known;
  rbpa::Cutter cutter(grid, places);
  rbpa::Tile tile;
  rbpa::FinderWorkspace workspace;
  rbpa::TilePatch triangles;
  for (const rbpa::Block& block : rbpa::blocks(grid, 200)) {
    cutter.cut(block, tile);
    find_patch(tile, radius, workspace, triangles);
    for (const auto& t : triangles.patch.triangles) found.insert(canonical({{{t[0], t[1], t[2]}}})[0]);
    known.insert(known.end(), triangles.settled.begin(), triangles.settled.end());
  }
  for (const Triangle& t : found) CHECK(complex.contains(t));
  const std::set<std::uint32_t> complete(known.begin(), known.end());
  for (const Triangle& t : complex)
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t s) { return complete.contains(s); }))
      CHECK(found.contains(t));
  counts.triangles = found.size();
  counts.known = known.size();
  return counts;
}

}  // namespace

TEST_CASE("a tile finds no triangle whose circle holds a hidden point, and settles no site near one") {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Points points = round % 4 == 0   ? perfect_grid(30, 1)
                    : round % 4 == 1 ? clusters(60, 40 + static_cast<std::uint64_t>(round))
                                     : uniform(900, static_cast<std::uint64_t>(round));
    random.shuffle(points);
    const std::size_t count = round % 3 == 0 ? 1 : 1 + random.below(40);
    const Points hidden(points.end() - static_cast<std::ptrdiff_t>(count), points.end());
    points.resize(points.size() - count);
    for (const Radius& radius : {Radius(), Radius(1.2), Radius(0.6)}) check_hidden(points, hidden, radius);
  }
}

TEST_CASE("a far point costs the sides that see it, and a near one its neighborhood") {
  const Points points = uniform(3000, 2);
  const Counts none = check_hidden(points, {}, Radius());
  const Counts inside = check_hidden(points, {{27.3, 27.4}}, Radius());
  CHECK(inside.known + 200 > none.known);
  CHECK(inside.known < none.known);
  for (const Points& hidden : {Points{{1e9, 10}}, Points{{-1e9, 10}}, Points{{20, 1e9}}, Points{{20, -1e9}}}) {
    const Counts outside = check_hidden(points, hidden, Radius());
    CHECK(outside.known + 300 > none.known);
    CHECK(outside.triangles < none.triangles);
  }
}

TEST_SUITE_END();
