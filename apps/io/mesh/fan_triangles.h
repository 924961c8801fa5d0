// What: cuts a face into a fan of triangles between its corners.
// Law:  the triangles depend on the positions and the direction of the corners, not on which corner is first in the
//       face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rbpa::app {

/// Calls use(triangle) for each triangle of the fan around the lexicographically least corner of a face, in the face's
/// direction. If the face has a corner twice, some triangles may have that corner twice.
template <typename Use>
void for_each_fan_triangle(std::span<const std::uint32_t> face, std::span<const std::array<double, 3>> positions,
                           Use use) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < face.size(); ++i)
    if (positions[face[i]] < positions[face[least]]) least = i;
  const auto corner = [&](std::size_t i) { return face[(least + i) % face.size()]; };
  for (std::size_t i = 1; i + 1 < face.size(); ++i) use(std::array{corner(0), corner(i), corner(i + 1)});
}

}  // namespace rbpa::app
