// What: runs `rbpa alpha --dimension 3`, which lists radii of points in space, and the births and deaths of components,
//       tunnels and voids.
#pragma once

#include "shared/verbs.h"

namespace rbpa::app {

void run_space_alpha(const AlphaArguments& arguments);

}  // namespace rbpa::app
