// What: plans tiles by the counts of points in cells.
// Law:  by the counts no tile has more points than allowed, with the points around it, unless it is a single cell.
//       Counts do not tell where in a cell a point is: a tile that has more points than planned is cut again.
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
  std::uint64_t points = 0;  ///< maximum with the points around the tile, so that the computation fits into memory
  std::uint64_t owned = 0;   ///< maximum in the box of the tile
  double reach = 0;          ///< distance from the tile up to which points matter for it
};

/// The exception if no tile is small enough, as too many points are within reach of each other.
struct TooDense {
  Point where;
  std::uint64_t points;
};

struct TilePlan {
  TileTree tree = {};
  double points = 0;  ///< estimated sum of the points of all tiles, including the points around them
};

/// Throws Failure that names the place, the number of points there, how many fit into memory, and the memory that
/// suffices.
[[noreturn]] void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget);

/// Returns the plan of the tiles. Throws TooDense.
TilePlan plan_tiles(const CellCounts& counts, const TileLimits& limits);

}  // namespace rbpa::app
