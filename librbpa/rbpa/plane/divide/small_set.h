// What: the solid alpha complex of a small set: one triangulation by divide and conquer, whose triangles are read off its edges
//       in canonical order. No grid, tiles, lanes or threads, whose preparation costs more than the work.
// Law:  the result is that of the tiles (patches/for_each_patch.h), to the last index.
// Cost: O(n log n); about 150 bytes a point while it runs.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// From so many points on tiles are worked on by several threads, and one thread does not lose by them.
inline constexpr std::size_t small_set_limit = 10000;

/// Fills in all but what only the full complex has. Does nothing and returns false where the points do not fit double
/// (base/exact/magnitude.h).
/// Requires: less than `small_set_limit` finite points. Throws: Cancelled.
bool triangulate_small_set(std::span<const Point> points, double alpha, const TriangulationOptions& options,
                           Triangulation& result);

}  // namespace rbpa
