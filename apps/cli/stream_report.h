// What: what a run over tiles says when it is done.
#pragma once

#include "cli/stats.h"
#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"

namespace rbpa::app {

/// What is known of a complex by its counts, such as that of a tile.
Stats stats_of(const PartialCounts& counts, double alpha, unsigned threads);

/// The content of the file of --stats.
void write_stream_stats(OutputFile& file, const StreamRequest& request, const StreamResult& result);

/// The summary, and whatever a user should know.
void say_stream_result(const StreamRequest& request, const StreamResult& result);

}  // namespace rbpa::app
