// What: the counts of a triangulation in arrays, as a topological space.
// Law:  of a solid complex, the result of count() for its mesh (rbpa/topology.h).
#pragma once

#include "rbpa/topology.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// Of a full complex, edges in no triangle are counted as well; the points covered are those in a triangle or an edge; every
/// other distinct point is a component. There components − holes = distinct points − edges + triangles.
/// Requires: neighbours. Throws Cancelled after a signal. Cost: about linear.
ComplexCounts count(const Triangulation& complex, Complex kind);

}  // namespace rbpa::app
