// What: reports on a run over tiles when it is done.
#pragma once

#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"

namespace rbpa::app {

/// Writes the file of --stats.
void write_stream_stats(OutputFile& file, const StreamRequest& request, const StreamResult& result);

/// Prints the summary and the warnings.
void say_stream_result(const StreamRequest& request, const StreamResult& result);

}  // namespace rbpa::app
