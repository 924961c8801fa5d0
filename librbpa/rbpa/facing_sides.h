// What: which sides of triangles face each other across an edge that several share: for who glues triangles in space.
// Law:  exact, on any finite input. Of the sides at an edge, in the order of their triangles around it, one whose triangle
//       has its positive side after it faces the next one if that has its own before it. Each side faces one other at most,
//       and that one faces it. A function of the set of sides.
// Cost: a sort; an orientation for each comparison where more than two sides are at an edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"

namespace rbpa {

/// A side of the triangle (from, to, apex), counter-clockwise seen from its positive side; corners are indices of points.
struct EdgeSide {
  std::uint32_t from, to, apex;
  std::uint32_t triangle;  ///< a name of the caller's
  std::uint32_t across;    ///< of its corners, that of apex
};

/// Sorts the sides. Returns: pairs of positions among them then. Requires: corners of a triangle are distinct points; at an
/// edge no two triangles in the same direction of it, as those of a Delaunay triangulation.
RBPA_API std::vector<std::pair<std::size_t, std::size_t>> facing_sides(std::span<const Point3> points,
                                                                       std::vector<EdgeSide>& sides);

}  // namespace rbpa
