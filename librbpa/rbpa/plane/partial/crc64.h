// What:   CRC-64/XZ, which detects changed bytes.
// Why:    CRC-64 detects every change within 64 consecutive bits, and of other changes all but one in 2⁶⁴; a product of
//         bytes (FNV) guarantees nothing.
// Source: ECMA-182 (1992), annex B; reflected, as in the XZ format.
#pragma once

#include <cstdint>
#include <span>

namespace rbpa {

/// Returns the checksum of the bytes. Cost: about a nanosecond a byte.
std::uint64_t crc64(std::span<const std::uint8_t> bytes);

}  // namespace rbpa
