// What: finds the boundary curves of a complex whose triangles and neighbors are given as arrays.
// Law:  the curves are those of the mesh of the same triangles: at a point where the complex touches itself (a pinch),
//       a curve continues along the same fan of triangles; the curve may therefore pass the point several times.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns for each boundary curve the indices of its points in order, with the triangles on its right: outer curves
/// are clockwise. A curve is closed, and its first point is not repeated at the end. The order of the curves and their
/// first points are unspecified.
/// Requires: counter-clockwise triangles with neighbors that require_linked() accepts; not checked.
/// Throws:   Cancelled; `go_on` is not called during the walk along a curve.
/// Cost:     linear in the triangles.
RBPA_API std::vector<std::vector<std::uint32_t>> boundary_curves(const TriangleArrays& of, const GoOn& go_on = {});

}  // namespace rbpa
