// What: plans tiles by the counts of points in cells.
// Law:  by the counts no tile has more points than allowed, those around it included, unless a single cell has. Counts
//       do not tell where in a cell a point lies, so a tile may turn out too large and has to be cut again.
// Cost: O(n log n) in the number of cells.
#pragma once

#include <cstdint>

#include "stream/budget.h"
#include "stream/cell_counts.h"
#include "stream/request.h"
#include "stream/tile_tree.h"

namespace rbpa::app {

/// The limits of a tile.
struct TileLimits {
  std::uint64_t points = 0;  ///< the most points, those around it included, so that it fits into memory
  std::uint64_t owned = 0;   ///< the most points of its own
  double reach = 0;          ///< distance up to which points around the tile matter
};

/// Thrown if no tile is small enough, as so many points are within reach of each other.
struct TooDense {
  Point where;
  std::uint64_t points;
};

struct TilePlan {
  TileTree tree = {};
  double points = 0;  ///< estimated sum over all tiles, with the points around each
};

/// Throws Failure that names the place, its number of points, how many fit, and the memory that suffices.
[[noreturn]] void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget);

/// Returns the plan. Throws TooDense.
TilePlan plan_tiles(const CellCounts& counts, const TileLimits& limits);

}  // namespace rbpa::app
