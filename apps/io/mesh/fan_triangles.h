// What: a face as a fan of triangles between its corners.
// Law:  the triangles depend on the positions of the corners and on their direction, not on the corner that comes
//       first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rbpa::app {

/// Calls use(triangle) for each triangle of the fan around the lexicographically least corner of a face, in the face's
/// direction. If the face has a corner twice, so have some triangles.
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
