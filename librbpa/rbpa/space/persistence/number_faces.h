// What: numbers the triangles and the edges of a triangulation, and finds which are faces of which.
// How:  a triangle is numbered by the first of its tetrahedra; an edge by the first of its triangles, in a table of the edges up from its lesser
//       corner, which is short and stays in the caches where the corners of tetrahedra that follow each other are near each other:
//
//           corner     0        1      2 …
//           slots   | · 3 · 7 | · 12 | 5 · …     of each at least half as many as triangles have an edge up from it, and one more
//
// Cost: linear; twenty bytes a triangle for the tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid.h"

namespace rbpa::space {

struct NumberedTriangles {
  std::vector<Triangle> corners;                 ///< ascending
  std::vector<std::array<std::uint32_t, 4>> of;  ///< of each tetrahedron, across from each corner
};

/// Throws: ContractViolation where neighbors, as many as tetrahedra, are not mutual.
NumberedTriangles number_triangles(const Solid& delaunay, Steps& step);

struct NumberedEdges {
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< ascending
  std::vector<std::array<std::uint32_t, 3>> of;    ///< of each triangle, across from each corner
};

/// Requires: ascending corners below `points`.
NumberedEdges number_edges(std::size_t points, std::span<const Triangle> triangles, Steps& step);

}  // namespace rbpa::space
