// What: the passes of a run, from the plan of tiles to the requested files.
// Law:  the file of a tile has all points in the box of the tile, and all others within 2 alpha of the box. The result
//       does not depend on the tiles and their order: files have the bytes that `rbpa mesh` and `rbpa shape` write.
// Cost: cutting reads the input once and writes it once, with waiting points in memory. Computing triangulates every
//       tile, in several threads, with the tiles that are computed and the unfinished parts between tiles in memory.
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

/// Cuts the input into tiles, from the place of the input that the manifest records. Afterwards the manifest has the
/// summaries of the files. Throws as read_points(), Failure, Cancelled.
void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Makes the file of tile number `tile` again. Throws as cut_tiles() does.
void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile);

/// Cuts tiles that have more points than `budget` allows, until there are none. Throws Failure if no cut helps, and as
/// cut_tiles().
void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Computes all tiles, from the progress saved in `scratch` on if there is any. Returns the counts; triangles are in
/// `rows` and polygons in `polygons`. Throws BadInput if a file of scratch is damaged; Failure, Cancelled.
PartialCounts compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch,
                            Manifest& manifest, TriangleRows& rows, PolygonLog& polygons);

/// Adds the targets, except meshes of single tiles, to `outputs`, complete except for their names, and fills in the
/// values of `result` about polygons. Requires: result.counts is filled in. Throws BadInput if a file of scratch is
/// damaged; Failure, ClosedPipe, Cancelled.
void write_targets(const StreamRequest& request, const PointsFacts& facts, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result);

}  // namespace rbpa::app
