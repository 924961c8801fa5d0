// What: glues the triangles of a boundary through the outside instead of through the solid.
// Cost: linear, and a sort at edges that several wedges of tetrahedra share.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// Changes the neighbors of a boundary that is glued through the solid. Returns by how much the number of edges is
/// below half of the number of sides, because several wedges of tetrahedra share an edge.
/// Requires: a closed, linked boundary of these points.
std::size_t glue_outside(std::span<const Point3> points, Surface& boundary);

}  // namespace rbpa::space
