// What: the choices of a test that walks at random: from a seed, or byte by byte from a fuzzer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>

namespace meshops::test {

class Choices {
 public:
  /// Without end.
  explicit Choices(std::uint64_t seed) : random_(seed), from_bytes_(false) {}
  /// Ends with the bytes; what is asked for after is 0.
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes), from_bytes_(true) {}

  bool ended() const { return from_bytes_ && bytes_.empty(); }

  /// A number from 0 to bound − 1. Takes one byte where the bound is at most 256, else two.
  std::uint32_t below(std::uint32_t bound) {
    if (bound < 2) return 0;
    if (!from_bytes_) return static_cast<std::uint32_t>(random_() % bound);
    std::uint32_t value = byte();
    if (bound > 256) value = value << 8U | byte();
    return value % bound;
  }
  /// In one of so many cases.
  bool once_in(std::uint32_t cases) { return below(cases) == 0; }

 private:
  std::uint32_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }

  std::mt19937_64 random_;
  std::span<const std::uint8_t> bytes_;
  bool from_bytes_;
};

}  // namespace meshops::test
