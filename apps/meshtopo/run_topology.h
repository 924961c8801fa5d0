// What: runs meshtopo.
// Law:  no output file has its name before all are complete and the report is written.
#pragma once

#include "meshtopo/arguments.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Runs the program. Prints on standard error every check that does not hold, and, if there are several meshes, every
/// mesh that cannot be read; the others are examined. Returns the worst result: bad_input_given, check_failed or done.
/// Throws WrongUsage, BadInput (for a single mesh), Failure, ClosedPipe, Cancelled.
ExitCode run_topology(const TopologyArguments& arguments);

}  // namespace rbpa::app
