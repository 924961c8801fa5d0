// What: decodes symbols, bits and numbers from bytes by arithmetic coding with adaptive models, as LASzip encodes them.
// Law:  a decoder reads only its own bytes, and throws BadStream for bytes that no encoder writes.
// Cost: a division, and about one search step, for each symbol; no allocation.
// Source: A. Said, Introduction to arithmetic coding, HP Labs report HPL-2004-76; M. Isenburg, LASzip: lossless
//         compression of LiDAR data, PE&RS 79(2), 2013.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// The exception for compressed bytes that cannot be decoded.
struct BadStream {
  const char* at;               ///< the byte at which decoding stopped
  std::string found, expected;  ///< for bad_input()
};

/// The probabilities of 0 and 1.
class BitModel {
 public:
  static constexpr unsigned shift = 13;  ///< probabilities are multiples of 2^−13

 private:
  friend class ArithmeticDecoder;
  void update() {
    total_ += cycle_;
    if (total_ > 1U << shift) {
      total_ = (total_ + 1) / 2;
      zeros_ = (zeros_ + 1) / 2;
      if (zeros_ == total_) ++total_;
    }
    zero_ = zeros_ * (0x80000000U / total_) >> (31 - shift);
    left_ = cycle_ = std::min(5 * cycle_ / 4, 64U);
  }

  std::uint32_t zeros_ = 1, total_ = 2, zero_ = 1U << (shift - 1), cycle_ = 4, left_ = 4;
};

/// The probabilities of symbols 0 … n − 1, n ≤ `most`.
template <unsigned most>
class SymbolModel {
 public:
  static constexpr unsigned shift = 15;  ///< probabilities are multiples of 2^−15

  SymbolModel() : SymbolModel(most) {}
  explicit SymbolModel(unsigned symbols) : symbols_(symbols), cycle_(symbols) {
    counts_.fill(1);
    update();
    left_ = cycle_ = (symbols_ + 6) / 2;
  }

 private:
  friend class ArithmeticDecoder;
  static constexpr unsigned table_bits = std::max(static_cast<unsigned>(std::bit_width(most - 1)), 4U) - 2,
                            table_shift = shift - table_bits;

  void update() {
    total_ += cycle_;
    if (total_ > 1U << shift) {
      total_ = 0;
      for (unsigned i = 0; i < symbols_; ++i) total_ += counts_[i] = static_cast<std::uint16_t>((counts_[i] + 1) / 2);
    }
    const std::uint32_t scale = 0x80000000U / total_;
    std::uint32_t sum = 0;
    unsigned filled = 0;
    for (unsigned i = 0; i < symbols_; ++i) {
      starts_[i] = static_cast<std::uint16_t>(scale * sum >> (31 - shift));
      sum += counts_[i];
      for (; filled <= unsigned{starts_[i]} >> table_shift; ++filled)
        table_[filled] = static_cast<std::uint16_t>(i == 0 ? 0 : i - 1);
    }
    for (; filled < table_.size(); ++filled) table_[filled] = static_cast<std::uint16_t>(symbols_ - 1);
    left_ = cycle_ = std::min(5 * cycle_ / 4, (symbols_ + 6) * 8);
  }

  std::array<std::uint16_t, most> starts_ = {}, counts_;  // a symbol has the numbers from its start to the next start
  // A number in part t of the range belongs to a symbol from table_[t] to table_[t + 1].
  std::array<std::uint16_t, (1U << table_bits) + 2> table_;
  std::uint32_t symbols_, total_ = 0, cycle_, left_ = 0;
};

class ArithmeticDecoder {
 public:
  /// Decodes `bytes`, which must outlive the decoder. Throws BadStream if there are fewer than four.
  explicit ArithmeticDecoder(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {
    for (int i = 0; i < 4; ++i) value_ = value_ << 8U | next();
    if (value_ == length_) refuse();
  }

  /// Decodes a symbol, and counts it in the model. Throws BadStream.
  template <unsigned most>
  unsigned symbol(SymbolModel<most>& model) {
    const std::uint32_t unit = length_ >> SymbolModel<most>::shift, number = value_ / unit;
    const std::uint32_t part = number >> SymbolModel<most>::table_shift;
    unsigned low = model.table_[part], high = model.table_[part + 1] + 1U;
    while (high - low > 1) {
      const unsigned middle = (low + high) / 2;
      (model.starts_[middle] > number ? high : low) = middle;
    }
    const std::uint32_t start = model.starts_[low] * unit;
    length_ = (low + 1 == model.symbols_ ? length_ : model.starts_[low + 1] * unit) - start;
    value_ -= start;
    renormalize();
    ++model.counts_[low];
    if (--model.left_ == 0) model.update();
    return low;
  }

  /// Decodes a bit, and counts it in the model. Throws BadStream.
  unsigned bit(BitModel& model) {
    const std::uint32_t zero = model.zero_ * (length_ >> BitModel::shift);
    const bool is_one = value_ >= zero;
    if (is_one) {
      value_ -= zero;
      length_ -= zero;
    } else {
      length_ = zero;
      ++model.zeros_;
    }
    renormalize();
    if (--model.left_ == 0) model.update();
    return is_one ? 1 : 0;
  }

  /// Decodes a number of `bits` bits, which no model predicts. Requires: 1 ≤ bits ≤ 32. Throws BadStream.
  std::uint32_t bits(unsigned bits) {
    if (bits > 19) {
      const std::uint32_t low = this->bits(16);
      return this->bits(bits - 16) << 16U | low;
    }
    length_ >>= bits;
    const std::uint32_t number = value_ / length_;
    if (number >> bits != 0) refuse();
    value_ -= number * length_;
    renormalize();
    return number;
  }

  /// Decodes a number of 64 bits, which no model predicts. Throws BadStream.
  std::uint64_t bits64() {
    const std::uint64_t low = bits(32);
    return std::uint64_t{bits(32)} << 32U | low;
  }

  /// Returns the position of the next unread byte; after the last symbol of a stream this is the end of the stream.
  const char* at() const { return at_; }
  /// Continues with `bytes`, a copy of the bytes from at() on, perhaps with more bytes after them.
  void move_to(std::string_view bytes) {
    at_ = bytes.data();
    end_ = bytes.data() + bytes.size();
  }

 private:
  static constexpr std::uint32_t least_length = 1U << 24U;

  std::uint32_t next() {
    if (at_ == end_) refuse();
    return static_cast<unsigned char>(*at_++);
  }
  void renormalize() {
    for (; length_ < least_length; length_ <<= 8U) value_ = value_ << 8U | next();
  }
  [[noreturn]] void refuse() const {
    const bool ended = at_ == end_;
    throw BadStream{at_, ended ? "the end of the compressed points" : "a code that no compressor writes",
                    ended ? "more of them" : "compressed points"};
  }

  const char *at_, *end_;
  // The encoded number minus the least number of the current interval, and the length of this interval; value < length.
  std::uint32_t value_ = 0, length_ = 0xFFFFFFFF;
};

}  // namespace rbpa::app
