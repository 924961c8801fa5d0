// What: runs `rbpa alpha --dimension 3`: radii of points in space; births and deaths of components, tunnels, voids.
#pragma once

#include "shared/verbs.h"

namespace rbpa::app {

void run_space_alpha(const AlphaArguments& arguments);

}  // namespace rbpa::app
