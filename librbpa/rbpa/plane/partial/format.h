// What: the layout of a Partial in bytes: words of 8, little-endian (docs/explanation/plane.md, section 22).
#pragma once

#include <cstddef>
#include <cstdint>

namespace rbpa::partial_format {

inline constexpr std::uint64_t magic = 0x5452'4150'4150'4252;  // the letters RBPAPART
inline constexpr std::uint64_t version = 1;
inline constexpr std::size_t word = 8;

}  // namespace rbpa::partial_format
