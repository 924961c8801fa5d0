// What: the task of a merge: partials become one, or the files that the run is for.
// Law:  the same whatever the order of the partials; of all tiles the bytes of `rbpa mesh` and `rbpa shape`.
// Cost: n log n in what is open in the partials, which is in memory; in the end every triangle is written and read twice.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "stream/request.h"
#include "stream/run_stream.h"
#include "tasks/partial_file.h"

namespace rbpa::app {

/// All as one. Throws BadInput when one is not what a task has written, of another run, or has a tile that another has too;
/// Failure, Cancelled.
PartialFile merge_files(const std::vector<std::string>& paths);

/// Adds the targets of the request to `outputs`, and calls before_names(result) before they take their names. The request has
/// no sources; its alpha is that of the run. Throws BadInput that names what is missing; as run_stream() does.
StreamResult finish_run(const StreamRequest& request, PartialFile whole, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names);

}  // namespace rbpa::app
