// What: runs meshtopo: reads, examines, changes, checks and writes meshes.
// Law:  no output file has its name before all output files are complete.
#pragma once

#include "meshtopo/arguments.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Runs the program. Prints on standard error every check that fails and, if there are several meshes, every mesh that
/// cannot be read; the other meshes are examined. Returns the worst result: bad_input_given, check_failed or done.
/// Throws WrongUsage, BadInput (for a single mesh), Failure, ClosedPipe, Cancelled.
ExitCode run_topology(const TopologyArguments& arguments);

}  // namespace rbpa::app
