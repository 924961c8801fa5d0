#include "rbpa/plane/partial/crc64.h"

#include <array>
#include <cstddef>

namespace rbpa {
namespace {

using Table = std::array<std::uint64_t, 256>;

/// Returns tables whose entry [k][b] is the effect of byte b when k more bytes follow.
std::array<Table, 8> make_tables() {
  std::array<Table, 8> tables{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    std::uint64_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xC96C5795D7870F42 : 0);
    tables[0][byte] = rest;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint64_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8U) ^ tables[0][before & 0xFF];
    }
  return tables;
}

}  // namespace

std::uint64_t crc64(std::span<const std::uint8_t> bytes) {
  static const std::array<Table, 8> tables = make_tables();
  std::uint64_t crc = ~std::uint64_t{0};
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t next = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto byte = static_cast<std::uint8_t>(crc >> (8 * k)) ^ bytes[i + k];
      next ^= tables[7 - k][static_cast<std::uint8_t>(byte)];
    }
    crc = next;
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8U) ^ tables[0][static_cast<std::uint8_t>(crc) ^ bytes[i]];
  return ~crc;
}

}  // namespace rbpa
