// What: a complex of more points than fit into memory, from files to files, by way of files of tiles.
// Law:  the bytes of `rbpa mesh` and `rbpa shape`, whatever the tiles are; targets appear whole or not at all.
// Source: docs/how_to/more_points_than_memory.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/partial.h"
#include "stream/manifest.h"
#include "stream/request.h"
#include "stream/scratch.h"

namespace rbpa::app {

struct StreamResult {
  PartialCounts counts = {};
  std::size_t tiles = 0;
  // Where polygons are requested:
  std::uint64_t polygons = 0, holes = 0;
  double area = 0, perimeter = 0;
  std::optional<std::string> caution = std::nullopt;  ///< what readers of GeoJSON may mistake
  double count_seconds = 0, cut_seconds = 0, compute_seconds = 0, write_seconds = 0;
};

/// Adds the targets to `outputs`, whole but for their names, and calls before_names(result) before these are given;
/// then the scratch goes. Throws BadInput, WrongUsage, Failure, Cancelled.
StreamResult run_stream(const StreamRequest& request, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names);

/// Counts and cuts into the scratch, which is named and stays; write_work() writes there what is to be done with the
/// tiles. Of the result, points, tiles and seconds are filled in. A scratch that was cut before is checked, and damaged
/// tiles are made again. Throws as run_stream() does.
StreamResult prepare_tasks(const StreamRequest& request,
                           const std::function<void(const Scratch&, const Manifest&)>& write_work);

}  // namespace rbpa::app
