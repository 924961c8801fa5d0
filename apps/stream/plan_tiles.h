// What: plans tiles from the counts of points in grid cells.
// Law:  by the counts, no tile with the points around it has more points than allowed, unless it owns points of one
//       cell only. Counts do not tell where in a cell a point is: a tile with more points than planned is cut again.
// Cost: O(n log n) in the number of cells.
#pragma once

#include <cstdint>

#include "stream/budget.h"
#include "stream/cell_counts.h"
#include "stream/request.h"
#include "stream/tile_tree.h"

namespace rbpa::app {

/// Limits of the numbers of points of a tile, and the distance up to which points around the tile count.
struct TileLimits {
  std::uint64_t points = 0;  ///< maximum including the points around the tile, so that the computation fits into memory
  std::uint64_t owned = 0;   ///< maximum in the box of the tile
  double reach = 0;          ///< distance from the tile up to which points matter for the tile
};

/// The exception if no tile can be small enough, because too many points are within reach of each other.
struct TooDense {
  Point where;
  std::uint64_t points;
};

struct TilePlan {
  TileTree tree = {};
  double points = 0;  ///< estimated sum of the points of all tiles, each including the points around it
};

/// Throws Failure that names the place, the number of points there, the number that fits into memory, and the memory
/// that would suffice.
[[noreturn]] void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget);

/// Returns the plan of the tiles. Throws TooDense.
TilePlan plan_tiles(const CellCounts& counts, const TileLimits& limits);

}  // namespace rbpa::app
