// What: which tiles, by counts of points in cells.
// Law:  by the counts no tile has more points than it may, those around it included, unless a single cell has; what is
//       counted is not where each point lies, so a tile may turn out too large and has to be cut again.
// Cost: n log n in the cells.
#pragma once

#include <cstdint>

#include "stream/budget.h"
#include "stream/cell_counts.h"
#include "stream/request.h"
#include "stream/tile_tree.h"

namespace rbpa::app {

/// How much a tile may have.
struct TileLimits {
  std::uint64_t points = 0;  ///< of its own and around it, so that it fits into memory
  std::uint64_t owned = 0;   ///< of its own
  double reach = 0;          ///< from the tile to what matters around it
};

/// No tile is small enough: so many points are within reach of each other.
struct TooDense {
  Point where;
  std::uint64_t points;
};

struct TilePlan {
  TileTree tree = {};
  double points = 0;  ///< about how many all tiles have together, those around them included
};

/// Throws Failure: where, how many points, how many fit, and how much memory would do.
[[noreturn]] void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget);

/// Throws TooDense.
TilePlan plan_tiles(const CellCounts& counts, const TileLimits& limits);

}  // namespace rbpa::app
