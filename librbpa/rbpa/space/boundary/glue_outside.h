// What: triangles of a boundary glued through what is outside.
// Cost: linear, and a sort at edges that several wedges of tetrahedra share.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::space {

/// Changes the neighbors of a boundary that is glued through the solid. Returns: how many edges it has less than half of its sides, as some
/// are those of several wedges.
/// Requires: closed, linked, on these points.
std::size_t glue_outside(std::span<const Point3> points, Surface& boundary);

}  // namespace rbpa::space
