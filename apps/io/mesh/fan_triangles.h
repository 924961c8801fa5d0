// What: a face as triangles between its corners.
// Law:  a function of the places of its corners and of its direction, and not of the corner at which it begins.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rbpa::app {

/// The triangles of a fan around the lexicographically least corner of a face, in its direction; with a corner twice also
/// triangles that have it twice.
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
