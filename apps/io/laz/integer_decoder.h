// What: decodes integers as differences to predictions: the number k of the binary digits of a difference, then its
//       digits, the highest eight by a model of their own for each k.
// Source: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS 79(2), 2013.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/laz/arithmetic_decoder.h"

namespace rbpa::app {

/// A decoder of integers of `bits` bits, 8, 16 or 32. Differences are modulo 2^bits.
template <unsigned bits>
class IntegerDecoder {
 public:
  IntegerDecoder() : IntegerDecoder(1) {}
  /// Makes a decoder that has a model of k for each of `contexts` contexts.
  explicit IntegerDecoder(std::size_t contexts) : sizes_(contexts, SymbolModel<bits + 1>()) {
    digits_.fill(SymbolModel<256>());
    for (unsigned k = 1; k < high_bits && k <= bits; ++k) digits_[k - 1] = SymbolModel<256>(1U << k);
  }

  /// Returns the integer, from 0 to 2^bits − 1; for 32 bits the bits of a signed integer. Throws BadStream.
  std::uint32_t decode(ArithmeticDecoder& decoder, std::uint32_t predicted, std::size_t context = 0) {
    return (predicted + difference(decoder, sizes_[context])) & mask;
  }
  /// Decodes a signed integer of 32 bits.
  std::int32_t decode_signed(ArithmeticDecoder& decoder, std::int32_t predicted, std::size_t context = 0) {
    return static_cast<std::int32_t>(decode(decoder, static_cast<std::uint32_t>(predicted), context));
  }

  std::size_t contexts() const { return sizes_.size(); }
  /// Returns the number k of binary digits of the last difference.
  unsigned size() const { return k_; }

 private:
  static constexpr unsigned high_bits = 8;
  static constexpr std::uint32_t mask = bits == 32 ? 0xFFFFFFFFU : (1U << bits) - 1;

  std::uint32_t difference(ArithmeticDecoder& decoder, SymbolModel<bits + 1>& sizes) {
    k_ = decoder.symbol(sizes);
    if (k_ == 0) return decoder.bit(zero_or_one_);
    if (k_ == 32) return 0x80000000U;
    std::uint32_t number = decoder.symbol(digits_[k_ - 1]);
    if (k_ > high_bits) number = number << (k_ - high_bits) | decoder.bits(k_ - high_bits);
    // The lower half of the numbers are the differences from 1 − 2^k to −2^(k−1), the upper half 2^(k−1) + 1 to 2^k.
    return number >> (k_ - 1) != 0 ? number + 1 : number - ((1U << k_) - 1);
  }

  std::vector<SymbolModel<bits + 1>> sizes_;
  std::array<SymbolModel<256>, bits> digits_;  // [k − 1]
  BitModel zero_or_one_ = {};
  unsigned k_ = 0;
};

}  // namespace rbpa::app
