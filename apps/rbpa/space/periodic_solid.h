// What: runs `rbpa solid --box`: the tetrahedra of points in a periodic box.
#pragma once

#include "shared/verbs.h"
#include "space/solid_request.h"

namespace rbpa::app {

/// Runs the verb; throws as verbs.h says. Requires: request.box is present.
void run_periodic_solid(const SolidArguments& arguments, const SolidRequest& request);

}  // namespace rbpa::app
