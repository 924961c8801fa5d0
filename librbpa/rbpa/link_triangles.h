// What: the neighbors of each triangle, computed from triangles in canonical order alone.
// Law:  the neighbors that triangulate() finds.
// Why:  less memory than finding them in the run: the result and four bytes a point, after the run has freed its own.
// Cost: linear where few triangles are at a point, n log n where many are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// Of each triangle, neighbor k is the triangle across from corner k, or TriangleArrays::none.
/// Requires: triangles of a complex in the plane as in a Triangulation; corners are below `points`.
/// Throws:   Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API std::vector<Triangle> link_triangles(std::span<const Triangle> triangles, std::size_t points,
                                              const std::function<bool()>& go_on = {});

}  // namespace rbpa
