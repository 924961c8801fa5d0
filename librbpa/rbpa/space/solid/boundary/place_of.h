// What: finds the place of a number in a row that contains it once; without a branch, which would be mispredicted.
#pragma once

#include <array>
#include <cstdint>

namespace rbpa::space {

/// Returns the place of `value` in `row`, counted from 0; 0 also if `row` does not contain `value`.
inline std::uint32_t place_of(std::uint32_t value, const std::array<std::uint32_t, 4>& row) {
  return static_cast<std::uint32_t>(row[1] == value) | static_cast<std::uint32_t>(row[2] == value) << 1U |
         static_cast<std::uint32_t>(row[3] == value) * 3U;
}
inline std::uint32_t place_of(std::uint32_t value, const std::array<std::uint32_t, 3>& row) {
  return static_cast<std::uint32_t>(row[1] == value) | static_cast<std::uint32_t>(row[2] == value) << 1U;
}

}  // namespace rbpa::space
