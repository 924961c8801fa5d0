// What: the complex of all points, tile by tile.
// Law:  the same whatever the tiles are, and in whatever order they are done.
// Cost: that of triangulating every tile, in several threads; memory as the tiles in work and what is open between them.
#pragma once

#include <cstdint>

#include "rbpa/partial.h"
#include "stream/budget.h"
#include "stream/manifest.h"
#include "stream/polygon_log.h"
#include "stream/request.h"
#include "stream/scratch.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// What comes of it: counts here, the rest in files of scratch.
struct Computed {
  PartialCounts counts = {};
};

/// Goes on from where a run stopped that has left its progress in the scratch. Throws Failure, Cancelled.
Computed compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
                       TriangleRows& rows, PolygonLog& polygons);

}  // namespace rbpa::app
