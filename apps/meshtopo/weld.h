// What: merges vertices that are near each other: --weld.
// Law:  two vertices are merged if a chain of vertices leads from one to the other with no step longer than the
//       distance, decided exactly, and get the position of the lexicographically least of them. The result does not
//       depend on the order of the vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Welded {
  double distance = 0;
  std::size_t vertices = 0;                               ///< vertices merged into others
  std::size_t corners = 0;                                ///< repeated corners removed from faces that remain
  std::size_t degenerate_faces = 0, duplicate_faces = 0;  ///< removed faces
};

/// Returns for each vertex the least number of the vertices that it is merged with, its own included.
/// Requires: 0 ≤ distance < ∞; finite positions.
/// Cost:     n log n, unless dense clusters of positions are just out of reach of each other. Throws Cancelled.
std::vector<std::uint32_t> near_vertices(const std::vector<std::array<double, 3>>& positions, double distance);

}  // namespace rbpa::app
