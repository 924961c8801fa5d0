// What: the boundary curves of a triangulation in arrays.
// Law:  they are those of the mesh of the same triangles: a curve that comes to a point where the complex touches itself
//       (a pinch) goes on at the same fan of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/triangulate.h"

namespace rbpa::app {

/// The points along each curve, with the triangles to the right. Where a curve begins, and the order of the curves, is
/// left open.
/// Requires: neighbours. Throws Cancelled after a signal. Cost: linear.
std::vector<std::vector<std::uint32_t>> boundary_curves(const Triangulation& of);

}  // namespace rbpa::app
