// What: the task of one tile: its file becomes a partial, and on request triangles and a mesh.
// Law:  a function of the file and the facts of the run: done again, it writes the same.
// Cost: that of triangulating its points; memory as these, some hundred bytes each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/partial.h"

namespace rbpa::app {

struct TileRequest {
  std::string tile = {};  ///< its file, in the folder of tiles
  // What to write:
  std::optional<std::string> partial = std::nullopt, triangles = std::nullopt, mesh = std::nullopt;
  unsigned threads = 1;
};

struct TileDone {
  std::uint32_t number = 0;
  double alpha = 0;
  std::uint64_t around = 0;  ///< points of the file that the tile does not own
  PartialCounts counts = {};
  double read_seconds = 0, compute_seconds = 0;
};

/// Adds what is to be written to `outputs`. Throws BadInput when the file is not that of a tile of its run, Failure, Cancelled.
TileDone run_tile(const TileRequest& request, OutputSet& outputs);

}  // namespace rbpa::app
