// What: the passes of a run over the points, from the plan of tiles to the requested files.
// Law:  the file of a tile has every point of its box, and every other within 2 alpha of it; what comes of the tiles is
//       the same whatever they are and in whatever order they are done: the bytes of `rbpa mesh` and `rbpa shape`.
// Cost: cutting reads the input and writes it once, and memory has the points that wait; computing triangulates every
//       tile, in several threads, and memory has the tiles in work and what is open between them.
#pragma once

#include <cstdint>

#include "io/bytes/output_file.h"
#include "rbpa/partial.h"
#include "stream/budget.h"
#include "stream/manifest.h"
#include "stream/polygon_log.h"
#include "stream/request.h"
#include "stream/run_stream.h"
#include "stream/scratch.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// Continues cutting where the manifest records that it stopped; once the input is read, the manifest records what the
/// files contain.
/// Throws as read_points(), Failure, Cancelled.
void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Makes the file of one tile again.
void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile);

/// Cuts tiles that turned out larger than they may be, as long as there are any. Throws Failure where no cut helps.
void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Goes on from where a run stopped that has left its progress in the scratch. What comes of it is in files there, but
/// for the counts. Throws Failure, Cancelled.
PartialCounts compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch,
                            Manifest& manifest, TriangleRows& rows, PolygonLog& polygons);

/// Adds the targets to `outputs`, in order and whole but for their names; those of single tiles are left out. Of the
/// result the counts are there, and what is known of polygons comes. Throws Failure, Cancelled.
void write_targets(const StreamRequest& request, const PointsFacts& facts, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result);

}  // namespace rbpa::app
