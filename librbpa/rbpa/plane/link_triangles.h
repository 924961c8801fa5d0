// What: computes the neighbors of each triangle from the triangles in canonical order alone.
// Law:  the neighbors equal those that alpha_complex() finds.
// Why:  takes less memory than AlphaComplexOptions::neighbors: the result and four bytes a point, after alpha_complex()
//       has freed its own memory.
// Cost: linear if few triangles meet at each point, n log n if many do.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// Returns for each triangle its neighbors: entry k is the number of the triangle across from corner k, or
/// TriangleArrays::none.
/// Requires: triangles in the order of AlphaComplex::triangles, of which at most two share an edge, on opposite sides
///           of the edge; corners below `points`, the number of input points. None of these is checked.
/// Throws:   Cancelled.
RBPA_API std::vector<Triangle> link_triangles(std::span<const Triangle> triangles, std::size_t points,
                                              const GoOn& go_on = {});

}  // namespace rbpa
