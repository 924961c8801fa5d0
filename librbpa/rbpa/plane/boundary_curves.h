// What: the boundary curves of a complex whose triangles and neighbors are given as arrays.
// Law:  the curves are those of the mesh of the same triangles: at a point where the complex touches itself (a pinch),
//       a curve continues along the same fan of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns for each boundary curve the indices of its points in order, the triangles on its right. A curve is closed,
/// and its first point is not repeated at the end. Which point is first and the order of the curves are unspecified.
/// Requires: as require_linked(), which is not checked.
/// Throws:   Cancelled.
/// Cost:     linear.
RBPA_API std::vector<std::vector<std::uint32_t>> boundary_curves(const TriangleArrays& of, const GoOn& go_on = {});

}  // namespace rbpa
