// What: extracts parts of a surface, for example the triangles of its smaller radii.
// Law:  the triangles of the smaller radii are the surface by these radii alone: a larger radius changes no gluing
//       between earlier triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

inline TriangleArrays arrays_of(const Surface& surface) { return {surface.triangles, surface.neighbors}; }

/// Returns the triangles t for which keep(t) is true, glued to each other. `duplicates` and `distinct` are not set.
template <typename Keep>
Surface part_of(const Surface& surface, const Keep& keep) {
  Surface part;
  std::vector<std::uint32_t> number(surface.triangles.size(), Surface::none);  // new number of each triangle
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!keep(t)) continue;
    number[t] = static_cast<std::uint32_t>(part.triangles.size());
    part.triangles.push_back(surface.triangles[t]);
    part.neighbors.push_back(surface.neighbors[t]);
    if (!surface.levels.empty()) part.levels.push_back(surface.levels[t]);
  }
  for (auto& neighbors : part.neighbors)
    for (std::uint32_t& other : neighbors)
      if (other != Surface::none) other = number[other];
  return part;
}

/// Returns the triangles of levels below `level`, glued as in part_of(). Requires: `surface` has levels.
inline Surface sub_surface(std::uint32_t level, const Surface& surface) {
  return part_of(surface, [&](std::size_t t) { return surface.levels[t] < level; });
}

}  // namespace rbpa::space
