// What: glues the triangles of a boundary at shared edges through the outside instead of through the solid.
// Cost: linear, and a sort at edges that several wedges of tetrahedra share.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// Replaces the neighbors in `boundary`, which are glued through the solid, by neighbors that are glued through the
/// outside. Returns sides / 2 − edges, the number of sides of triangles and of edges of the boundary. The result is
/// above 0 where several wedges of tetrahedra share an edge.
/// Requires: `boundary` is closed and linked, as in solid_boundary(), and its corners are indices of `points`.
std::size_t glue_outside(std::span<const Point3> points, Surface& boundary);

}  // namespace rbpa::space
