// What: a triangle as three numbers: indices of its corners, in a list of points of the plane or of space.
#pragma once

#include <array>
#include <cstdint>

namespace rbpa {

using Triangle = std::array<std::uint32_t, 3>;

/// The same, turned the same way, from its least corner on.
inline Triangle from_least(const Triangle& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

/// Stands for the index of a triangle, or of another item of a list, where there is none.
inline constexpr std::uint32_t no_index = 0xffffffff;

}  // namespace rbpa
