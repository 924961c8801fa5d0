// What: turns triangles of vertices into triangles of a Surface: with points as corners, in lexicographic order, and
//       glued where triangles share two vertices.
// Cost: a sort of the sides, and of the triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/progress.h"

namespace rbpa::space {

/// Triangles and neighbors in the form of Surface::triangles and Surface::neighbors.
struct LinkedTriangles {
  std::vector<std::array<std::uint32_t, 3>> triangles, neighbors;
  std::vector<std::uint32_t> order;  ///< for each triangle, its number among the given ones
};

/// Returns the triangles `of_vertices`, linked; `point` has the point of each vertex. A side stays unglued if more than
/// two triangles share it, or two triangles run along it in one direction. Throws: Cancelled.
LinkedTriangles linked_triangles(std::span<const std::array<std::uint32_t, 3>> of_vertices,
                                 std::span<const std::uint32_t> point, meshops::Steps& step);

}  // namespace rbpa::space
