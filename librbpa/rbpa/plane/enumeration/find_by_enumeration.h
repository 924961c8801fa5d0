// What: finds the triangles of a small solid alpha complex on a tile by enumeration: a finder (tile/finder.h).
// Law:  every triangle of the complex with a corner that the tile owns is found, and no other.
// Why:  an advancing front finds the whole Delaunay triangulation, even if alpha leaves little of it. If a point has a
//       handful of other points within 2 alpha, testing which of these form a triangle with the point is faster.
// Cost: for each point, with m others within 2 alpha: O(m²) triples, each tested against m points in vector registers;
//       a few dozen nanoseconds up to m = 6.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/finder.h"

namespace rbpa {

struct EnumerationWorkspace {
  std::vector<std::int32_t> labels;       // for each point, its number and whether the tile owns it
  std::vector<std::uint64_t> owned_bits;  // which points the tile owns
  /// Pairs of sites at most about 2 alpha apart, the first owned by the tile: all pairs whose second site another tile
  /// owns, and some further pairs.
  std::vector<TilePatch::Neighbors> near_rim;
};

/// Finds the patch of a tile. Returns false, and leaves `found` unspecified, if alpha is infinite or 2 alpha exceeds
/// about a cell of the tile, if the tile lacks points that the search may need, or if the search would not pay: the
/// 3 × 3 cells around a point have more than 48 points, that point included, there are more than about 12 triples a
/// point, or rounding leaves too many decisions open.
/// Requires: workspace.coordinates are those of the tile.
bool find_by_enumeration(const Tile& tile, const Radius& alpha, TileWorkspace& workspace, EnumerationWorkspace& own,
                         TilePatch& found);

}  // namespace rbpa
