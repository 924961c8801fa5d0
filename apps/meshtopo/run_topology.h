// What: one run of meshtopo.
// Law:  output files appear when all are complete and the report is written.
#pragma once

#include "meshtopo/arguments.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Runs the program. Reports every check that does not hold on standard error; of several meshes also those that cannot
/// be read, and continues with the others. Returns the worst result: bad_input_given, check_failed or done. Throws
/// WrongUsage, BadInput (for a single mesh), Failure, Cancelled.
ExitCode run_topology(const TopologyArguments& arguments);

}  // namespace rbpa::app
