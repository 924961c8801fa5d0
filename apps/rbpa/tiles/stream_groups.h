// What: runs `rbpa stream --group-by`, which makes the shape of each group of more points than fit into memory.
// Law:  files have the bytes that `rbpa shape --group-by` writes.
// How:  sorts the points by group into one file of scratch; computes groups that fit into memory together, in the order
//       of their names, and streams each larger group through tiles.
// Cost: the input is read once, and each point of a larger group three times more from scratch; in memory, beside
//       tiles, are the names of groups.
#pragma once

#include "shared/run.h"
#include "stream/request.h"

namespace rbpa::app {

/// Writes all targets and the report of --stats. Requires: the targets are GeoJSON; the first columns of
/// PointSource::where are the keys of groups. Throws as run_stream().
void run_stream_groups(const StreamRequest& request, Run& run);

}  // namespace rbpa::app
