// What: how far the computation has come, in files of scratch.
// Law:  written as a whole or not at all: progress.json names the file of what is open, which is whole before.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rbpa/partial.h"
#include "stream/polygon_log.h"
#include "stream/scratch.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

struct ComputeState {
  std::uint64_t generation = 0;
  std::size_t tiles_done = 0;  ///< in the order of the tree
  std::uint64_t points_done = 0;
  std::vector<Partial> open = {};  ///< parts of the tree that are done, and not yet merged with others
  RowsState rows = {};
  LogState polygons = {};
};

void save(const ComputeState& state, const Scratch& scratch);

/// Nothing where no tile was done. Throws BadInput when the files are not what was written.
std::optional<ComputeState> load_state(const Scratch& scratch);

}  // namespace rbpa::app
