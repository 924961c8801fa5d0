// What: the boundary sides of triangles, at which no other triangle lies, from their neighbors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the boundary sides, each directed as in its triangle, in lexicographic order. Calls tick() for each
/// triangle; tick() may throw. Requires: neighbors were computed.
template <typename Tick>
std::vector<std::array<std::uint32_t, 2>> boundary_sides(const TriangleArrays& of, Tick tick) {
  std::vector<std::array<std::uint32_t, 2>> boundary;
  for (std::size_t t = 0; t < of.triangles.size(); ++t) {
    tick();
    for (std::size_t k = 0; k < 3; ++k)
      if (of.neighbors[t][k] == TriangleArrays::none)
        boundary.push_back({of.triangles[t][(k + 1) % 3], of.triangles[t][(k + 2) % 3]});
  }
  std::sort(boundary.begin(), boundary.end());
  return boundary;
}

}  // namespace rbpa
