// What: runs `rbpa alpha --dimension 3`: the radii of points in space, and births and deaths of components, tunnels and
//       voids.
#pragma once

#include "cli/verbs.h"

namespace rbpa::app {

void run_space_alpha(const AlphaArguments& arguments);

}  // namespace rbpa::app
