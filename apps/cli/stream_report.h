// What: what a run over tiles says when it is done.
#pragma once

#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"

namespace rbpa::app {

/// The file of --stats. Requires that the request has one.
void add_stream_stats(OutputSet& outputs, const StreamRequest& request, const StreamResult& result);

/// The summary, and whatever a user should know.
void say_stream_result(const StreamRequest& request, const StreamResult& result);

}  // namespace rbpa::app
