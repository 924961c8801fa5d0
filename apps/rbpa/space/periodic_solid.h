// What: runs `rbpa solid --box`, which makes the tetrahedra of points in a periodic box.
#pragma once

#include "shared/verbs.h"
#include "space/solid_request.h"

namespace rbpa::app {

/// Runs the verb. Throws as verbs.h says. Requires: request.box has a value.
void run_periodic_solid(const SolidArguments& arguments, const SolidRequest& request);

}  // namespace rbpa::app
