// What: the triangles of a small solid alpha complex on a tile, found by enumeration: a finder (tile/finder.h).
// Law:  every triangle of the complex of which the tile owns a corner is found, and no other.
// Why:  a front that advances finds the whole Delaunay triangulation, also where alpha leaves little of it. Where a point
//       has a handful of others within 2 alpha, it is faster to test which of them form a triangle with it.
// Cost: for each point, with m others within 2 alpha: O(m³), in vectors; a few dozen nanoseconds up to m = 6.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/finder.h"

namespace rbpa {

struct EnumerationWorkspace {
  std::vector<std::int32_t> labels;       // of each point, its number and whether the tile owns it
  std::vector<std::uint64_t> owned_bits;  // which points the tile owns
  /// Pairs of sites at most, about, 2 alpha apart: all of which the tile owns one and another tile the other, and more.
  std::vector<TilePatch::Neighbors> near_rim;
};

/// False where a search would not pay or would need points that the tile does not have.
bool find_by_enumeration(const Tile& tile, const Radius& alpha, TileWorkspace& workspace, EnumerationWorkspace& own,
                         TilePatch& found);

}  // namespace rbpa
