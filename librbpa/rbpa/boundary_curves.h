// What: the boundary curves of triangles in arrays.
// Law:  they are those of the mesh of the same triangles: a curve that comes to a point where the complex touches itself
//       (a pinch) goes on at the same fan of triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// The points along each curve, with the triangles to the right. Where a curve begins, and the order of the curves, is
/// left open.
/// Requires: as require_linked(), which is not checked.
/// Throws:   Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
/// Cost:     linear.
RBPA_API std::vector<std::vector<std::uint32_t>> boundary_curves(const TriangleArrays& of,
                                                                 const std::function<bool()>& go_on = {});

}  // namespace rbpa
