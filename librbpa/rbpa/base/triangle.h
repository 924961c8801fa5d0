// What: a triangle as the three indices of its corners, in a list of points of the plane or of space.
#pragma once

#include <array>
#include <cstdint>

namespace rbpa {

/// The three corners of a triangle, or its three neighbors, each across from the corner of the same position.
using Triangle = std::array<std::uint32_t, 3>;

/// Returns the triangle rotated so that its lowest corner is first; the orientation stays. Requires: distinct corners.
inline Triangle from_least(const Triangle& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

/// The index that stands for no triangle, or for no item of another list.
inline constexpr std::uint32_t no_index = 0xffffffff;

}  // namespace rbpa
