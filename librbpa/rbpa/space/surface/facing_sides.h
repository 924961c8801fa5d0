// What: pairs the sides of triangles that face each other around an edge of several triangles, so that they can be
//       glued.
// Law:  exact, on any finite input. The sides of two triangles that are consecutive by angle around an edge face each
//       other if the wedge between the triangles is on the positive side of both. Each side faces at most one other
//       side. The result is a function of the set of sides.
// Cost: a sort; an exact orientation test for each comparison at edges of more than two sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"

namespace rbpa {

/// A side of the triangle (from, to, apex), counter-clockwise seen from its positive side; corners are point indices.
struct EdgeSide {
  std::uint32_t from, to, apex;
  std::uint32_t triangle;  ///< number of the triangle, chosen by the caller
  std::uint32_t across;    ///< position of apex among the corners of the triangle; for the caller, not read
};

/// Sorts `sides` by edge, and by angle around each edge. Returns the pairs of positions in the sorted `sides` whose
/// sides face each other, ascending. The first side of a pair leads to the end of higher index, the second side back.
/// Requires: corners are indices of points, those of a triangle not on one line; no two triangles lie in the same
///           direction from an edge, as in a Delaunay triangulation. Not checked.
RBPA_API std::vector<std::pair<std::size_t, std::size_t>> facing_sides(std::span<const Point3> points,
                                                                       std::vector<EdgeSide>& sides);

}  // namespace rbpa
