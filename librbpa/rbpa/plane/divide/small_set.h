// What: the solid alpha complex of a small set: one triangulation by divide and conquer; the triangles are read off the
//       edges in canonical order. Grid, tiles, lanes and threads would take longer to prepare than the work takes.
// Law:  the result equals the result by tiles (patches/for_each_patch.h), to the last index.
// Cost: O(n log n); about 150 bytes a point while it runs.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// The least number of points for which tiles are used: from this number on, several threads can share the tiles, and a
/// single thread is not slower with tiles.
inline constexpr std::size_t small_set_limit = 10000;

/// Fills in the empty `result`, but not `boundary` and the members of a full complex. Fills in `neighbors` only if
/// options.neighbors or options.boundary is set. Returns false and does nothing if the points do not fit double
/// (base/exact/magnitude.h).
/// Requires: fewer than `small_set_limit` finite points; 0 < alpha ≤ infinity.
/// Throws:   Cancelled.
bool triangulate_small_set(std::span<const Point> points, double alpha, const AlphaComplexOptions& options,
                           AlphaComplex& result);

}  // namespace rbpa
