// What: numbers the triangles and the edges of a triangulation, and finds the triangles of each tetrahedron and the
//       edges of each triangle.
// How:  a triangle is numbered by the first of its tetrahedra, an edge by the first of its triangles. The table of
//       edges has a short section for the edges up from each corner; it stays in the caches where the corners of
//       consecutive tetrahedra are near each other:
//
//           corner     0        1      2 …
//           slots   | · 3 · 7 | · 12 | 5 · …
//
//       A section has at least half as many slots as triangles have an edge up, plus one.
// Cost: linear; twenty bytes for each triangle for the tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

struct NumberedTriangles {
  std::vector<Triangle> corners;                 ///< corners of each triangle, ascending
  std::vector<std::array<std::uint32_t, 4>> of;  ///< for each tetrahedron: the triangle across from each corner
};

/// Returns the triangles. Requires: one row of neighbors for each tetrahedron. Throws ContractViolation where a
/// neighbor does not exist, or does not share the face with its tetrahedron; Cancelled.
NumberedTriangles number_triangles(const Solid& delaunay, Steps& step);

struct NumberedEdges {
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< ends of each edge, ascending
  std::vector<std::array<std::uint32_t, 3>> of;    ///< for each triangle: the edge across from each corner
};

/// Returns the edges. Requires: corners of `triangles` ascend, and are below `points`; each edge is a side of two
/// triangles at least.
NumberedEdges number_edges(std::size_t points, std::span<const Triangle> triangles, Steps& step);

}  // namespace rbpa::space
