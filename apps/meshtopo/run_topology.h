// What: one run of meshtopo.
// Law:  its files appear when all are complete, and the report went out.
#pragma once

#include "meshtopo/arguments.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Of several meshes those that cannot be read are named on standard error, and the others reported; so is every check
/// that does not hold. Returns the worst that was found: bad_input_given, else check_failed, else done.
/// Throws WrongUsage, BadInput (of a single mesh), Failure, Cancelled.
ExitCode run_topology(const TopologyArguments& arguments);

}  // namespace rbpa::app
