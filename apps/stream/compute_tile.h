// What: one tile: its points out of its file, and what it contributes to the complex.
// Law:  a function of the file.
// Cost: that of triangulating its points; memory as these, some hundred bytes each (budget.h).
#pragma once

#include <cstdint>
#include <string>

#include "rbpa/partial.h"
#include "stream/pack_block.h"
#include "stream/tile_file.h"

namespace rbpa::app {

/// All points of the file. Throws Damaged, Failure, Cancelled.
IndexedPoints read_tile(TileReader& reader);

struct TileWork {
  double alpha;
  unsigned threads;      ///< at most
  bool wants_triangles;  ///< else PartialAndItems::owned stays empty
};

/// Throws Cancelled, and InvalidInput as partial() does.
PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, const TileWork& work);

}  // namespace rbpa::app
