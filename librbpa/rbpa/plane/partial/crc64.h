// What: CRC-64/XZ, which detects bytes that were changed.
// Why:  of this length it misses no change of up to 64 bits side by side, and of others one in 2⁶⁴; a product of bytes (FNV)
//       promises nothing.
// Source: ECMA-182 (1992), annex B; reflected, as in the XZ format.
#pragma once

#include <cstdint>
#include <span>

namespace rbpa {

/// Cost: about a nanosecond a byte.
std::uint64_t crc64(std::span<const std::uint8_t> bytes);

}  // namespace rbpa
