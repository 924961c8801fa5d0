// What: glues the triangles of a boundary at shared edges through the outside instead of through the solid; finds the
//       place of a corner.
// Cost: linear, and a sort at edges that several wedges of tetrahedra share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// Returns the place of `value` in `row`, counted from 0; 0 also if `row` does not contain `value`. The code has no
/// branch, which would be mispredicted.
inline std::uint32_t place_of(std::uint32_t value, const std::array<std::uint32_t, 4>& row) {
  return static_cast<std::uint32_t>(row[1] == value) | static_cast<std::uint32_t>(row[2] == value) << 1U |
         static_cast<std::uint32_t>(row[3] == value) * 3U;
}
inline std::uint32_t place_of(std::uint32_t value, const std::array<std::uint32_t, 3>& row) {
  return static_cast<std::uint32_t>(row[1] == value) | static_cast<std::uint32_t>(row[2] == value) << 1U;
}

/// Replaces the neighbors in `boundary`, which are glued through the solid, by neighbors that are glued through the
/// outside. Returns sides / 2 − edges, the number of sides of triangles and of edges of the boundary. The result is
/// above 0 where several wedges of tetrahedra share an edge.
/// Requires: `boundary` is closed and linked, as in solid_boundary(), and its corners are indices of `points`.
std::size_t glue_outside(std::span<const Point3> points, Surface& boundary);

}  // namespace rbpa::space
