// What: the counts of solid_topology.h, computed from the components of the outside.
// Cost: linear.
#pragma once

#include "rbpa/solid_topology.h"
#include "rbpa/space/boundary/outside.h"

namespace rbpa::space {

SolidCounts count_solid(const Solid& solid, const SolidBoundary& boundary, const Outside& outside);

}  // namespace rbpa::space
