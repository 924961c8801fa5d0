// What: a triangle as three point numbers, the smallest first, with the position of the triangle in a list.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/patch/patch.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// A triangle, and its position in a list.
struct NumberedTriangle {
  Triangle corners;
  std::uint32_t number;
};

/// Returns the names of a triangle's corners, rotated so that the least comes first. The code has no branch, as the
/// position of the least name cannot be predicted.
inline Triangle from_least(std::span<const std::uint32_t> names, const std::array<meshops::Site, 3>& corner) {
  const std::uint32_t a = names[corner[0]], b = names[corner[1]], c = names[corner[2]];
  const std::uint32_t b_first = (b < a) & (b < c), c_first = (c < a) & (c < b);
  const std::uint32_t turn_by_1 = -b_first, turn_by_2 = -c_first;  // all bits, or none
  const std::uint32_t first = a ^ ((a ^ b) & turn_by_1) ^ ((a ^ c) & turn_by_2),
                      second = b ^ ((b ^ c) & turn_by_1) ^ ((b ^ a) & turn_by_2);
  return {first, second, a ^ b ^ c ^ first ^ second};
}

/// Calls visit(Triangle) for each triangle of a patch, in order, with the names of the corners, the least first.
template <typename Visit>
void for_each_triangle(const meshops::Patch& patch, std::span<const std::uint32_t> names, Visit visit) {
  constexpr std::size_t ahead = 32;  // names are prefetched this many triangles before
  const std::size_t count = patch.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    for (const meshops::Site corner : patch.triangles[std::min(t + ahead, count - 1)])
      __builtin_prefetch(&names[corner]);
    visit(from_least(names, patch.triangles[t]));
  }
}

}  // namespace rbpa
