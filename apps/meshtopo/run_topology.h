// What: one run of meshtopo.
// Law:  its files appear when all are complete, and the report went out.
#pragma once

#include "meshtopo/arguments.h"

namespace rbpa::app {

/// Throws WrongUsage, BadInput, Failure, Cancelled.
void run_topology(const TopologyArguments& arguments);

}  // namespace rbpa::app
