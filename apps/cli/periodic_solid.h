// What: `rbpa solid --box`: the tetrahedra of points in a box that repeats.
#pragma once

#include "cli/solid_request.h"
#include "cli/verbs.h"

namespace rbpa::app {

/// Requires: a request with a box.
void run_periodic_solid(const SolidArguments& arguments, const SolidRequest& request);

}  // namespace rbpa::app
