// What: numbers the triangles and edges of a triangulation; finds the triangles of tetrahedra and the edges of
//       triangles.
// How:  triangles are numbered in the order of their first tetrahedra, edges in the order of their first triangles. The
//       table of edges has for each point a short section of the edges to greater points. The sections in use stay in
//       the caches if the corners of consecutive tetrahedra are near each other:
//
//           corner     0        1      2 …
//           slots   | · 3 · 7 | · 12 | 5 · …
//
//       The section of a point that is the lower end of n sides of triangles has at least n / 2 + 1 slots.
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

/// Returns the triangles. Requires: one row of neighbors for each tetrahedron. Throws ContractViolation if a neighbor
/// does not exist or does not share the face; Cancelled.
NumberedTriangles number_triangles(const Solid& delaunay, Steps& step);

struct NumberedEdges {
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< ends of each edge, ascending
  std::vector<std::array<std::uint32_t, 3>> of;    ///< for each triangle: the edge across from each corner
};

/// Returns the edges. Requires: the corners of each triangle ascend and are below `points`; each edge is a side of at
/// least two triangles.
NumberedEdges number_edges(std::size_t points, std::span<const Triangle> triangles, Steps& step);

}  // namespace rbpa::space
