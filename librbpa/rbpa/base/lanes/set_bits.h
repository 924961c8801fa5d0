// What: a table of the positions of the set bits of each byte, ascending.
#pragma once

#include <array>
#include <cstdint>

namespace rbpa {

/// For each byte, the positions of its set bits, ascending, followed by zeros.
inline constexpr std::array<std::array<std::uint8_t, 8>, 256> set_bits = [] {
  std::array<std::array<std::uint8_t, 8>, 256> all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned count = 0;
    for (unsigned bit = 0; bit < 8; ++bit)
      if ((byte >> bit & 1U) != 0) all[byte][count++] = static_cast<std::uint8_t>(bit);
  }
  return all;
}();

}  // namespace rbpa
