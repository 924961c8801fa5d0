// What: counts the simplices and Betti numbers of a solid from the components of its outside.
// Cost: linear.
#pragma once

#include "rbpa/space/solid/boundary/outside.h"
#include "rbpa/space/solid/solid_topology.h"

namespace rbpa::space {

/// Returns the counts.
/// Requires: `outside` is the result of outside_of() for `solid` and `boundary`.
/// Throws:   ContractViolation when the counts are impossible: then the three arguments do not belong together.
SolidCounts count_solid(const Solid& solid, const SolidBoundary& boundary, const Outside& outside);

}  // namespace rbpa::space
