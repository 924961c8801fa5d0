// What: a triangle as the three indices of its corners, in a list of points of the plane or of space.
#pragma once

#include <array>
#include <cstdint>

namespace rbpa {

/// Three corners, or three numbers of neighbors, one across from each corner.
using Triangle = std::array<std::uint32_t, 3>;

/// Returns the triangle with its lowest corner first, in the same orientation. Requires: distinct corners.
inline Triangle from_least(const Triangle& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

/// The index that stands for no triangle, or for no item of another list.
inline constexpr std::uint32_t no_index = 0xffffffff;

}  // namespace rbpa
