// What: what the smaller of several radii have made of a surface.
// Law:  it is the surface that they alone have: what a radius made is glued as it was then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"
#include "rbpa/surface.h"

namespace rbpa::space {

inline TriangleArrays arrays_of(const Surface& surface) { return {surface.triangles, surface.neighbors}; }

/// The triangles of levels below one, glued among each other. Requires: a level of each.
inline Surface part_below(std::uint32_t level, const Surface& surface) {
  Surface part;
  std::vector<std::uint32_t> number(surface.triangles.size(), Surface::none);
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
