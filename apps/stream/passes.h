// What: runs the passes of `rbpa stream`, from cutting the input into tiles to writing the requested files.
// Law:  the file of a tile contains all points in its box, and all others within 2 alpha of the box. The result does
//       not depend on the tiles and their order: files have the bytes that `rbpa mesh` and `rbpa shape` write.
// Cost: cutting reads the input once and writes each point to the file of every tile that needs it; waiting points are
//       in memory. Computing triangulates every tile, in several threads; the tiles in work and the unfinished parts
//       between tiles are in memory.
#pragma once

#include <cstdint>
#include <functional>

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

/// Cuts the input into tiles, from the place of the input that the manifest records. Sets the tile summaries of the
/// manifest. Throws as read_points() does; Damaged, Failure, Cancelled.
void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Makes the file of tile number `tile` again. Throws as cut_tiles() does.
void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile);

/// Cuts tiles with more points than `budget` or the request allows, until a cut no longer helps. Throws Failure if too
/// many points for the memory are within reach of each other, and as cut_tiles() does.
void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Computes all tiles; continues from the progress saved in `scratch`, if there is any. Returns the counts, adds
/// triangles to `rows` and polygons to `polygons`. Throws BadInput if a file of scratch is damaged; Failure, Cancelled;
/// as cut_again() does if the file of a tile is damaged.
PartialCounts compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch,
                            Manifest& manifest, TriangleRows& rows, PolygonLog& polygons);

/// Gives polygons to a sink, in canonical order, and calls its finish().
using ShowPolygons = std::function<void(PolygonSink&)>;

/// Returns what shows the polygons of a run, filtered as requested; refers to `polygons`. PolygonFacts::points of
/// filtered polygons is 0 unless `counts_points`. Throws as write_targets() does.
ShowPolygons shown_polygons(const StreamRequest& request, const Manifest& manifest, const PolygonLog& polygons,
                            std::uint64_t sort_bytes, bool counts_points);

/// Shows the polygons to `sink`, if it is not null, and sets the polygon members of `result`.
void add_up(const ShowPolygons& show, PolygonSink* sink, StreamResult& result);

/// Adds the targets, except meshes of single tiles, to `outputs`: files that are complete but have no name yet. Sets
/// the polygon members of `result`. Requires: result.counts is set. Throws BadInput if a file of scratch is damaged;
/// Failure, ClosedPipe, Cancelled; as read_points() does if polygons are filtered.
void write_targets(const StreamRequest& request, const Manifest& manifest, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result);

}  // namespace rbpa::app
