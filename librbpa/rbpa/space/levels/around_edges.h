// What: which sides of triangles face each other across an edge that several share.
// Law:  of the sides at an edge, in the order of their triangles around it, one whose triangle has its positive side after it
//       faces the next one if that has its own before it. Each side faces one other at most, and that one faces it. A function
//       of the set of sides.
// Cost: a sort; an orientation for each comparison where more than two sides are at an edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/core/point3.h"

namespace rbpa::space {

/// A side of the triangle (from, to, apex).
struct EdgeSide {
  std::uint32_t from, to, apex;
  std::uint32_t triangle;  ///< a name of the caller's
  std::uint32_t across;    ///< of its corners, that of apex
};

/// Pairs of positions among the sides, which are sorted. Requires: at an edge no two triangles in the same direction of it,
/// as those of a Delaunay triangulation.
std::vector<std::pair<std::size_t, std::size_t>> facing_sides(std::span<const Point3> points,
                                                              std::vector<EdgeSide>& sides);

}  // namespace rbpa::space
