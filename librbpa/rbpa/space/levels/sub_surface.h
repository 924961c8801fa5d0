// What: the part of a surface that the smaller of its radii made.
// Law:  it is the surface by those radii alone, as a later radius changes no gluing between earlier triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"
#include "rbpa/surface.h"

namespace rbpa::space {

inline TriangleArrays arrays_of(const Surface& surface) { return {surface.triangles, surface.neighbors}; }

/// The triangles of levels below `level`, glued among each other. Requires: the surface has levels.
inline Surface sub_surface(std::uint32_t level, const Surface& surface) {
  Surface part;
  std::vector<std::uint32_t> number(surface.triangles.size(), Surface::none);  // in the part
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (surface.levels[t] < level) {
      number[t] = static_cast<std::uint32_t>(part.triangles.size());
      part.triangles.push_back(surface.triangles[t]);
      part.neighbors.push_back(surface.neighbors[t]);
      part.levels.push_back(surface.levels[t]);
    }
  for (auto& neighbors : part.neighbors)
    for (std::uint32_t& other : neighbors)
      if (other != Surface::none) other = number[other];
  return part;
}

}  // namespace rbpa::space
