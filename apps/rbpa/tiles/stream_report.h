// What: reports on a finished run of `rbpa stream`.
#pragma once

#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"

namespace rbpa::app {

/// Writes the report of --stats.
void write_stream_stats(OutputFile& file, const StreamRequest& request, const StreamResult& result);

/// Prints warnings about the result, and, unless quiet, the summary.
void say_stream_result(const StreamRequest& request, const StreamResult& result);

}  // namespace rbpa::app
