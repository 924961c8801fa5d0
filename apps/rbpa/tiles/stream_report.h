// What: reports on a finished run over tiles.
#pragma once

#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"

namespace rbpa::app {

/// Writes the file of --stats.
void write_stream_stats(OutputFile& file, const StreamRequest& request, const StreamResult& result);

/// Prints the summary and the warnings about the result.
void say_stream_result(const StreamRequest& request, const StreamResult& result);

}  // namespace rbpa::app
