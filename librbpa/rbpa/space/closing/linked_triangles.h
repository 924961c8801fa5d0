// What: triangles of vertices as a surface has them: of points, glued where they have two vertices in common, in lexicographic order.
// Cost: a sort of the sides, and of the triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/progress.h"

namespace rbpa::space {

/// As Surface::triangles and Surface::neighbors.
struct LinkedTriangles {
  std::vector<std::array<std::uint32_t, 3>> triangles, neighbors;
  std::vector<std::uint32_t> order;  ///< which of those that were given each triangle is
};

/// `point`: of each vertex. Vertices that more than two triangles join, or two in one direction, glue nothing. Throws: Cancelled.
LinkedTriangles linked_triangles(std::span<const std::array<std::uint32_t, 3>> of_vertices,
                                 std::span<const std::uint32_t> point, meshops::Steps& step);

}  // namespace rbpa::space
