// What: models that items of several versions share: tables of models, medians, times and colors.
// Source: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS 79(2), 2013.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "io/laz/arithmetic_decoder.h"
#include "io/laz/integer_decoder.h"
#include "io/scalar.h"

namespace rbpa::app {

/// Store `value` at `to`, little-endian, or add `more` to the number at `to`.
template <typename T>
void store(char* to, T value) {
  value = load_little<T>(reinterpret_cast<const char*>(&value));
  std::memcpy(to, &value, sizeof value);
}
inline void store16(char* to, std::uint32_t value) { store(to, static_cast<std::uint16_t>(value)); }
inline void add32(char* to, std::int32_t more) {
  store(to, load_little<std::uint32_t>(to) + static_cast<std::uint32_t>(more));
}
inline void add64(char* to, std::int64_t more) {
  store(to, load_little<std::uint64_t>(to) + static_cast<std::uint64_t>(more));
}

/// Models of `most` symbols, one for each context below `contexts`. A model is made when its context first occurs.
template <unsigned most, std::size_t contexts>
class ModelTable {
 public:
  SymbolModel<most>& operator[](std::size_t context) {
    std::unique_ptr<SymbolModel<most>>& model = models_[context];
    if (!model) model = std::make_unique<SymbolModel<most>>();
    return *model;
  }

 private:
  std::array<std::unique_ptr<SymbolModel<most>>, contexts> models_ = {};
};

/// Approximates the median of the last numbers by five of them, in ascending order. A new number replaces the greatest
/// and the least in turn.
class StreamingMedian {
 public:
  std::int32_t get() const { return values_[2]; }
  void add(std::int32_t value) {
    auto place = values_.begin();
    if (drops_greatest_) {
      drops_greatest_ = value < get();
      place = std::upper_bound(values_.begin(), values_.end() - 1, value);
      std::copy_backward(place, values_.end() - 1, values_.end());
    } else {
      drops_greatest_ = value <= get();
      place = std::lower_bound(values_.begin() + 1, values_.end(), value) - 1;
      std::copy(values_.begin() + 1, place + 1, values_.begin());
    }
    *place = value;
  }

 private:
  std::array<std::int32_t, 5> values_ = {};
  bool drops_greatest_ = true;
};

/// Decodes coordinates: x and y as differences to the last place, predicted by medians of the last differences in each
/// of `contexts` contexts; z as the difference to the last z of the same level, the number of returns after a point in
/// its pulse.
template <std::size_t contexts>
class PlaceDecoder {
 public:
  PlaceDecoder() = default;
  explicit PlaceDecoder(std::int32_t z) { z_.fill(z); }

  /// Replaces x and y, the numbers at `place`. `is_single`: the pulse has one return.
  void next_xy(ArithmeticDecoder& decoder, char* place, std::size_t context, bool is_single) {
    const std::int32_t dx = dx_.decode_signed(decoder, x_[context].get(), is_single ? 1 : 0);
    add32(place, dx);
    x_[context].add(dx);
    const std::size_t size = std::min(dx_.size() & ~1U, 20U) + (is_single ? 1 : 0);
    const std::int32_t dy = dy_.decode_signed(decoder, y_[context].get(), size);
    add32(place + 4, dy);
    y_[context].add(dy);
  }
  /// Replaces z, the third number at `place`, after x and y.
  void next_z(ArithmeticDecoder& decoder, char* place, std::size_t level, bool is_single) {
    const std::size_t size = std::min((dx_.size() + dy_.size()) / 2 & ~1U, 18U) + (is_single ? 1 : 0);
    store(place + 8, z_[level] = dz_.decode_signed(decoder, z_[level], size));
  }

 private:
  IntegerDecoder<32> dx_ = IntegerDecoder<32>(2), dy_ = IntegerDecoder<32>(22), dz_ = IntegerDecoder<32>(20);
  std::array<StreamingMedian, contexts> x_ = {}, y_ = {};
  std::array<std::int32_t, 8> z_ = {};
};

/// Decodes times as bits of doubles, of four sequences that alternate: each time by its difference to the time before
/// in its sequence, mostly a multiple of the last difference. With `may_stay` a symbol stands for the same time again.
template <bool may_stay>
class TimeDecoder {
 public:
  explicit TimeDecoder(const char* first) { times_[0] = load_little<std::int64_t>(first); }

  /// Decodes the next time to `to`.
  void next(ArithmeticDecoder& decoder, char* to) {
    while (!step(decoder)) continue;
    store(to, times_[now_]);
  }

 private:
  static constexpr unsigned greatest = 500, full = greatest + 11;  // multiples from −10 to 500, and no multiple

  /// Decodes one step. Returns true if times_[now_] is the next time, false if the step has only changed the sequence.
  bool step(ArithmeticDecoder& decoder) {
    const bool moves = differences_[now_] != 0;
    unsigned symbol = moves ? decoder.symbol(multiples_) : decoder.symbol(kinds_);
    if constexpr (may_stay) {
      if (symbol == (moves ? full : 0)) return true;
      if (!moves || symbol > full) --symbol;
    }
    if (moves && symbol < full) return add_multiple(decoder, symbol);
    if (moves) symbol -= full - 1;
    if (symbol > 1) {
      now_ = (now_ + symbol - 1) % 4;
      return false;
    }
    if (symbol == 0) {
      differences_[now_] = numbers_.decode_signed(decoder, 0, 0);
      times_[now_] = sum(times_[now_], differences_[now_]);
    } else {
      const auto high = static_cast<std::uint32_t>(static_cast<std::uint64_t>(times_[now_]) >> 32U);
      const std::uint64_t upper = numbers_.decode(decoder, high, 8);
      now_ = last_made_ = (last_made_ + 1) % 4;
      times_[now_] = static_cast<std::int64_t>(upper << 32U | decoder.bits(32));
      differences_[now_] = 0;
    }
    extremes_[now_] = 0;
    return true;
  }

  /// Adds a multiple of the difference: `symbol` times it up to 500; beyond, 500 − `symbol` times it. The extremes, and
  /// 0, stand also for more extreme multiples.
  bool add_multiple(ArithmeticDecoder& decoder, unsigned symbol) {
    const bool is_extreme = symbol == 0 || symbol == greatest || symbol == full - 1;
    const std::uint32_t multiple = symbol > greatest ? greatest - symbol : symbol;
    const std::size_t context = symbol < 2           ? (symbol == 0 ? 7 : 1)
                                : symbol < greatest  ? (symbol < 10 ? 2 : 3)
                                : symbol == greatest ? 4
                                                     : (is_extreme ? 6 : 5);
    const auto predicted = multiple * static_cast<std::uint32_t>(differences_[now_]);
    const std::int32_t difference = numbers_.decode_signed(decoder, static_cast<std::int32_t>(predicted), context);
    times_[now_] = sum(times_[now_], difference);
    if (symbol == 1) extremes_[now_] = 0;
    if (is_extreme && ++extremes_[now_] > 3) {
      differences_[now_] = difference;
      extremes_[now_] = 0;
    }
    return true;
  }
  static std::int64_t sum(std::int64_t time, std::int64_t difference) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(time) + static_cast<std::uint64_t>(difference));
  }

  SymbolModel<full + 4 + may_stay> multiples_ = {};
  SymbolModel<5 + may_stay> kinds_ = {};
  IntegerDecoder<32> numbers_ = IntegerDecoder<32>(9);
  std::array<std::int64_t, 4> times_ = {};
  std::array<std::int32_t, 4> differences_ = {}, extremes_ = {};
  std::size_t now_ = 0, last_made_ = 0;
};

/// Decodes colors of three channels of 16 bits: each byte as its difference to the byte of the last color, which for
/// green and blue is first changed as the channels before changed.
class ColorDecoder {
 public:
  static constexpr std::size_t size = 6;

  /// Replaces the color at `last` by the next color.
  void next(ArithmeticDecoder& decoder, char* last) {
    const unsigned changed = decoder.symbol(changed_);
    std::array<int, size> old, now;  // low and high byte of red, green, blue
    for (std::size_t i = 0; i < size; ++i) now[i] = old[i] = static_cast<unsigned char>(last[i]);
    const auto decode = [&](std::size_t i, int guess) {
      if ((changed >> i & 1U) != 0) now[i] = (guess + static_cast<int>(decoder.symbol(bytes_[i]))) & 0xFF;
    };
    for (const std::size_t low : {0U, 1U}) decode(low, old[low]);
    for (const std::size_t low : {0U, 1U}) {
      if ((changed & 64U) == 0) {
        now[low + 4] = now[low + 2] = now[low];  // gray
        continue;
      }
      const int red = now[low] - old[low];
      decode(low + 2, std::clamp(red + old[low + 2], 0, 255));
      decode(low + 4, std::clamp((red + now[low + 2] - old[low + 2]) / 2 + old[low + 4], 0, 255));
    }
    for (std::size_t i = 0; i < size; ++i) last[i] = static_cast<char>(now[i]);
  }

 private:
  SymbolModel<128> changed_ = {};
  std::array<SymbolModel<256>, size> bytes_ = {};
};

/// Decodes a byte as its difference to the last byte.
struct ByteDecoder {
  static constexpr std::size_t size = 1;

  void next(ArithmeticDecoder& decoder, char* last) {
    *last = static_cast<char>(static_cast<unsigned char>(*last) + decoder.symbol(differences));
  }

  SymbolModel<256> differences = {};
};

}  // namespace rbpa::app
