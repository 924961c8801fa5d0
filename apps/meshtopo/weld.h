// What: vertices that are near each other made one: --weld.
// Law:  two vertices become one when a chain of vertices leads from one to the other with no step longer than the distance,
//       decided exactly; the place is that of the lexicographically least. Neither depends on the order of the vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Welded {
  double distance = 0;
  std::size_t vertices = 0;                               ///< that are gone
  std::size_t corners = 0;                                ///< that a face named twice in a row, of faces that are left
  std::size_t degenerate_faces = 0, duplicate_faces = 0;  ///< that are gone
};

/// Of each vertex: the least of those it becomes one with.
/// Requires: 0 ≤ distance < ∞; finite positions.
/// Cost:     n log n, where no places of a dense cluster have those of another just out of reach. Throws Cancelled.
std::vector<std::uint32_t> near_vertices(const std::vector<std::array<double, 3>>& positions, double distance);

}  // namespace rbpa::app
