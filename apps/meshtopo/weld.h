// What: merges vertices that are near each other, for --weld.
// Law:  two vertices are merged if a chain of vertices with no step longer than the distance leads from one to the
//       other; this is decided exactly. The position of merged vertices is the lexicographically least of their
//       positions. The result does not depend on the order of the vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Welded {
  double distance = 0;
  std::size_t vertices = 0;                               ///< number of vertices that were merged into another
  std::size_t corners = 0;                                ///< number of repeated corners removed from remaining faces
  std::size_t degenerate_faces = 0, duplicate_faces = 0;  ///< numbers of removed faces
};

/// Returns for each vertex the least number among the vertices that merge with it, including itself.
/// Requires: 0 ≤ distance < ∞; finite positions.
/// Cost:     O(n log n) for n vertices, unless dense clusters of positions are just out of reach of each other.
/// Throws:   Cancelled.
std::vector<std::uint32_t> near_vertices(const std::vector<std::array<double, 3>>& positions, double distance);

}  // namespace rbpa::app
