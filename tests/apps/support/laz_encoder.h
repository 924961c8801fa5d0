// What: the arithmetic encoder of LASzip, its numbers, and what encoders of items share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace apps_test::laz {

/// Counts of symbols, and where each begins in the range of 2^15.
struct Model {
  explicit Model(unsigned symbols) : counts(symbols, 1), starts(symbols), cycle(symbols) {
    update();
    left = cycle = (symbols + 6) >> 1U;
  }
  void update() {
    if ((total += cycle) > 32768) {
      total = 0;
      for (std::uint32_t& count : counts) total += count = (count + 1) >> 1U;
    }
    const std::uint32_t scale = 0x80000000U / total;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < counts.size(); sum += counts[i++]) starts[i] = scale * sum >> 16U;
    cycle = std::min(5 * cycle >> 2U, static_cast<std::uint32_t>(counts.size() + 6) << 3U);
    left = cycle;
  }
  std::vector<std::uint32_t> counts, starts;
  std::uint32_t cycle, total = 0, left = 0;
};

struct BitModel {
  std::uint32_t zeros = 1, total = 2, zero = 4096, cycle = 4, left = 4;
};

class Encoder {
 public:
  void symbol(Model& model, unsigned symbol) {
    const bool is_last = symbol + 1 == model.counts.size();
    const std::uint32_t unit = length_ >> 15U, low = model.starts[symbol] * unit;
    narrow(low, is_last ? length_ - low : model.starts[symbol + 1] * unit - low);
    ++model.counts[symbol];
    if (--model.left == 0) model.update();
  }
  void bit(BitModel& model, unsigned bit) {
    const std::uint32_t low = model.zero * (length_ >> 13U);
    bit == 0 ? narrow(0, low) : narrow(low, length_ - low);
    if (bit == 0) ++model.zeros;
    if (--model.left != 0) return;
    if ((model.total += model.cycle) > 8192) {
      model.total = (model.total + 1) >> 1U;
      model.zeros = (model.zeros + 1) >> 1U;
      if (model.zeros == model.total) ++model.total;
    }
    model.zero = model.zeros * (0x80000000U / model.total) >> 18U;
    model.left = model.cycle = std::min(5 * model.cycle >> 2U, 64U);
  }
  void bits(unsigned bits, std::uint32_t value) {
    if (bits > 19) {
      this->bits(16, value & 0xFFFFU);
      value >>= 16U;
      bits -= 16;
    }
    const std::uint32_t unit = length_ >> bits;
    narrow(value * unit, unit);
  }
  void bits64(std::uint64_t value) {
    bits(32, static_cast<std::uint32_t>(value));
    bits(32, static_cast<std::uint32_t>(value >> 32U));
  }

  std::string done() {
    const bool one_more = length_ > 0x2000000U;
    const std::uint32_t before = base_;
    base_ += one_more ? 0x1000000U : 0x800000U;
    length_ = one_more ? 0x800000U : 0x8000U;
    if (base_ < before) carry();
    renormalize();
    return bytes_ + std::string(one_more ? 3 : 2, '\0');
  }

 private:
  void narrow(std::uint32_t low, std::uint32_t length) {
    const std::uint32_t before = base_;
    base_ += low;
    length_ = length;
    if (base_ < before) carry();
    if (length_ < 0x1000000U) renormalize();
  }
  void carry() {
    std::size_t at = bytes_.size() - 1;
    for (; bytes_[at] == '\xFF'; --at) bytes_[at] = '\0';
    ++bytes_[at];
  }
  void renormalize() {
    do {
      bytes_ += static_cast<char>(base_ >> 24U);
      base_ <<= 8U;
    } while ((length_ <<= 8U) < 0x1000000U);
  }

  std::string bytes_ = {};
  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFU;
};

class Integers {
 public:
  explicit Integers(unsigned bits, unsigned contexts = 1) : bits_(bits), sizes_(contexts, Model(bits + 1)) {
    for (unsigned k = 1; k <= bits; ++k) digits_.emplace_back(1U << std::min(k, 8U));
  }
  void encode(Encoder& encoder, std::int32_t predicted, std::int32_t real, unsigned context = 0) {
    std::int64_t difference = std::int64_t{real} - predicted;
    const std::int64_t range = std::int64_t{1} << bits_;
    while (difference < -range / 2) difference += range;
    while (difference >= range / 2) difference -= range;
    k_ = 0;
    for (std::int64_t rest = difference <= 0 ? -difference : difference - 1; rest != 0; rest >>= 1U) ++k_;
    encoder.symbol(sizes_[context], k_);
    if (k_ == 0) return encoder.bit(bit_, static_cast<unsigned>(difference));
    if (k_ == 32) return;
    const auto number =
        static_cast<std::uint32_t>(difference < 0 ? difference + (std::int64_t{1} << k_) - 1 : difference - 1);
    if (k_ <= 8) return encoder.symbol(digits_[k_ - 1], number);
    encoder.symbol(digits_[k_ - 1], number >> (k_ - 8));
    encoder.bits(k_ - 8, number & ((1U << (k_ - 8)) - 1));
  }
  unsigned k() const { return k_; }

 private:
  unsigned bits_, k_ = 0;
  std::vector<Model> sizes_, digits_ = {};
  BitModel bit_ = {};
};

template <typename T>
T at(const char* record, std::size_t offset) {
  T value;
  std::memcpy(&value, record + offset, sizeof value);
  return value;
}
inline unsigned byte(const char* record, std::size_t offset) { return at<std::uint8_t>(record, offset); }

struct Models : std::map<unsigned, Model> {
  Model& get(unsigned context, unsigned symbols) { return try_emplace(context, symbols).first->second; }
};

/// An encoder of the items of a chunk after the first, with its layers, or in a stream of all items.
class Item {
 public:
  virtual ~Item() = default;
  /// Encodes the item at `now` to the layers; `channel` as in the decoder of LASzip.
  virtual void encode(const char* now, unsigned& channel) = 0;
  std::vector<std::shared_ptr<Encoder>> layers = {};

 protected:
  Encoder& layer(std::size_t i) { return *layers[i]; }
};

}  // namespace apps_test::laz
