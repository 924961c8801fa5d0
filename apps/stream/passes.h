// What: the passes of a run, from the plan of tiles to the requested files.
// Law:  the file of a tile has all points in its box, and all others within 2 alpha of it. The result does not depend
//       on the tiles and their order: it has the bytes of `rbpa mesh` and `rbpa shape`.
// Cost: cutting reads the input and writes it once, with the waiting points in memory. Computing triangulates every
//       tile, in several threads, with the tiles in work and the open parts between them in memory.
#pragma once

#include <cstdint>

#include "io/bytes/output_file.h"
#include "rbpa/plane/partial.h"
#include "stream/budget.h"
#include "stream/manifest.h"
#include "stream/polygon_log.h"
#include "stream/request.h"
#include "stream/run_stream.h"
#include "stream/scratch.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// Cuts the input into tiles, from where the manifest records that cutting stopped. Afterwards the manifest has the
/// summaries of the files. Throws as read_points(), Failure, Cancelled.
void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Makes the file of one tile again. Throws as cut_tiles() does.
void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile);

/// Cuts tiles that turned out too large until there are none. Throws Failure if no cut helps.
void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Computes all tiles, resuming from the progress in the scratch if there is any. The results are in files there,
/// except for the counts, which are returned. Throws Failure, Cancelled.
PartialCounts compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch,
                            Manifest& manifest, TriangleRows& rows, PolygonLog& polygons);

/// Adds the targets except those of single tiles to `outputs`, complete except for their names, and fills in the values
/// of `result` about polygons. Requires: result.counts is filled in. Throws Failure, Cancelled.
void write_targets(const StreamRequest& request, const PointsFacts& facts, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result);

}  // namespace rbpa::app
