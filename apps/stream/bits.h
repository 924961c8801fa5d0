// What: numbers of any width, from 0 to 64 bits, one behind the other.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace rbpa::app {

inline unsigned bits_of(std::uint64_t value) { return static_cast<unsigned>(std::bit_width(value)); }

/// The number of bytes of so many numbers, in whole words.
inline std::size_t packed_size(std::size_t count, unsigned width) { return (count * width + 63) / 64 * 8; }

/// Appends the lowest `width` bits of each, of which the others are 0.
inline void pack(std::span<const std::uint64_t> values, unsigned width, std::string& bytes) {
  if (width == 0) return;
  const std::size_t before = bytes.size();
  bytes.resize(before + packed_size(values.size(), width));
  char* at = bytes.data() + before;
  std::uint64_t word = 0;
  unsigned used = 0;
  const auto emit = [&] {
    std::memcpy(at, &word, sizeof word);
    at += sizeof word;
  };
  for (const std::uint64_t value : values) {
    word |= value << used;
    used += width;
    if (used < 64) continue;
    emit();
    used -= 64;
    word = used == 0 ? 0 : value >> (width - used);
  }
  if (used > 0) emit();
}

/// The other way round. Requires: `bytes` has packed_size() of them.
inline void unpack(const char* bytes, unsigned width, std::span<std::uint64_t> values) {
  const std::uint64_t mask = width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  std::uint64_t word = 0;
  unsigned left = 0;  // bits of the word that are still to come
  for (std::uint64_t& value : values) {
    if (left >= width) {
      value = word & mask;
      word = width == 64 ? 0 : word >> width;
      left -= width;
      continue;
    }
    value = word;
    std::memcpy(&word, bytes, sizeof word);
    bytes += sizeof word;
    value = (value | word << left) & mask;
    const unsigned taken = width - left;
    word = taken == 64 ? 0 : word >> taken;
    left = 64 - taken;
  }
}

}  // namespace rbpa::app
