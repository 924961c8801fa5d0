// What: the counts of solid_topology.h, computed from the components of the outside.
// Cost: linear.
#pragma once

#include "rbpa/space/solid/boundary/outside.h"
#include "rbpa/space/solid/solid_topology.h"

namespace rbpa::space {

SolidCounts count_solid(const Solid& solid, const SolidBoundary& boundary, const Outside& outside);

}  // namespace rbpa::space
