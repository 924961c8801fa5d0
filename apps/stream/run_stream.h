// What: computes a complex of more points than fit into memory, from files to files, through files of tiles.
// Law:  targets have the bytes that `rbpa mesh` and `rbpa shape` write, for any tiles, and each appears complete or not
//       at all.
// Source: docs/how_to/more_points_than_memory.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "io/polygon/write_shapes.h"
#include "rbpa/plane/partial.h"
#include "stream/request.h"

namespace rbpa::app {

struct StreamResult {
  PartialCounts counts = {};
  std::size_t tiles = 0;
  /// Numbers of polygons and of their holes; 0 if no polygons are requested.
  std::uint64_t polygons = 0, holes = 0;
  double area = 0, perimeter = 0;
  std::optional<std::string> caution =
      std::nullopt;  ///< a warning that readers of GeoJSON may misinterpret the coordinates
  double count_seconds = 0, cut_seconds = 0, compute_seconds = 0, write_seconds = 0;
};

/// Adds the targets to `outputs`, calls before_names(result), gives the files their names, and removes the files of
/// scratch; request.keep_tiles keeps tiles and manifest. Throws BadInput, WrongUsage, Failure, ClosedPipe, Cancelled.
StreamResult run_stream(const StreamRequest& request, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names);

/// Computes the polygons of a request without writing its targets, calls use(result, show), where show(sink) gives the
/// polygons to a sink, any number of times, and removes the files of scratch. Requires: request.wants_polygons().
/// Throws as run_stream().
void use_polygons(const StreamRequest& request,
                  const std::function<void(const StreamResult&, const std::function<void(PolygonSink&)>& show)>& use);

}  // namespace rbpa::app
