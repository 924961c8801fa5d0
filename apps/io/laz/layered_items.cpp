#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "io/laz/item_models.h"
#include "io/laz/items.h"

namespace rbpa::app {
namespace {

constexpr unsigned channels = 4;

using LayerDecoder = std::optional<ArithmeticDecoder>;

LayerDecoder decoder_of(std::string_view stream) {
  return stream.empty() ? LayerDecoder() : LayerDecoder(ArithmeticDecoder(stream));
}

/// Offsets in a record of formats 6 to 10; `flags` has four flags of the class, the channel, direction and edge.
namespace at14 {
constexpr std::size_t z = 8, intensity = 12, returns = 14, flags = 15, classification = 16, user_data = 17,
                      scan_angle = 18, source = 20, time = 22, size = 30;
}

/// The layers of a point in their order; the first has x, y, returns and the channel.
namespace layer14 {
enum Index : std::size_t { place, height, classes, flags, intensity, angle, user, source, time, count };
}

/// Contexts for a return number (second index) of a number of returns (first index) from 0 to 15.
constexpr char contexts_of_returns14[16][17] = {
    "0123453445555555", "1013333333333333", "2124444444433333", "3345444444444444",
    "4344544444444444", "5344454444444444", "3344445444444444", "4344444544444444",
    "4344444454444444", "5344444445444444", "5344444444544444", "5334444444455444",
    "5334444444455544", "5334444444445554", "5334444444444555", "5334444444444455"};

/// The last point of a scanner channel, and models.
struct Channel {
  explicit Channel(const char* point)
      : coordinates(load_little<std::int32_t>(point + at14::z)), times(point + at14::time) {
    std::memcpy(last, point, at14::size);
    intensities.fill(load_little<std::uint16_t>(point + at14::intensity));
  }

  char last[at14::size];
  bool time_changed = false;
  std::array<SymbolModel<128>, 8> changed = {};
  SymbolModel<3> channel = {};
  std::array<SymbolModel<16>, 16> counts = {}, numbers = {};
  SymbolModel<13> number_in_pulse = {};
  PlaceDecoder<12> coordinates;
  ModelTable<256, 64> classification = {}, user_data = {};
  ModelTable<64, 64> flags = {};
  IntegerDecoder<16> intensity = IntegerDecoder<16>(4), scan_angle = IntegerDecoder<16>(2), source = {};
  std::array<std::uint16_t, 8> intensities;
  TimeDecoder<false> times;
};

class Point14 final : public ItemDecoder {
 public:
  explicit Point14(const ItemStart& start)
      : now_(static_cast<unsigned char>(start.first[at14::flags]) >> 4U & 3U), version_(start.version) {
    for (std::size_t i = 0; i < layer14::count; ++i) decoders_[i] = decoder_of(start.streams[i]);
    if (!decoders_[layer14::place])
      throw BadStream{start.streams[layer14::place].data(), "a chunk without x and y", "a layer of them"};
    channels_[start.chunk.channel = now_] = std::make_unique<Channel>(start.first);
  }

  void next(char* to, ChunkState& chunk) override {
    // In version 3 a channel that does not change counts as channel 0 for other items.
    chunk.channel = version_ > 3 ? now_ : 0;
    ArithmeticDecoder& decoder = *decoders_[layer14::place];
    Channel* c = channels_[now_].get();
    const unsigned last = byte(*c, at14::returns), number_before = last & 15U, count_before = last >> 4U;
    const unsigned changed =
        decoder.symbol(c->changed[(number_before == 1 ? 1U : 0U) + (number_before >= count_before ? 2U : 0U) +
                                  (c->time_changed ? 4U : 0U)]);
    if ((changed & 64U) != 0) {
      now_ = (now_ + decoder.symbol(c->channel) + 1) % channels;
      if (!channels_[now_]) channels_[now_] = std::make_unique<Channel>(c->last);
      c = channels_[now_].get();
      c->last[at14::flags] = static_cast<char>((byte(*c, at14::flags) & ~0x30U) | now_ << 4U);
      chunk.channel = now_;
    }
    c->time_changed = (changed & 16U) != 0;
    const unsigned returns = next_returns(*c, changed), number = returns & 15U, count = returns >> 4U;
    c->last[at14::returns] = static_cast<char>(returns);
    const auto context = static_cast<std::size_t>(contexts_of_returns14[count][number] - '0');
    c->coordinates.next_xy(decoder, c->last, 2 * context + (c->time_changed ? 1 : 0), count == 1);
    next_fields(*c, number, count, changed);
    std::memcpy(to, c->last, at14::size);
  }

 private:
  static unsigned byte(const Channel& c, std::size_t at) { return static_cast<unsigned char>(c.last[at]); }

  /// Returns the next byte with the number of the return and the number of returns.
  unsigned next_returns(Channel& c, unsigned changed) {
    ArithmeticDecoder& decoder = *decoders_[layer14::place];
    unsigned number = byte(c, at14::returns) & 15U, count = byte(c, at14::returns) >> 4U;
    if ((changed & 4U) != 0) count = decoder.symbol(c.counts[count]);
    const unsigned step = changed & 3U;  // 0, 1, 2: the number, 1 more, 1 less; 3: any other
    if (step < 3)
      number += step == 2 ? 15 : step;
    else if (c.time_changed)
      number = decoder.symbol(c.numbers[number]);
    else
      number += 2 + decoder.symbol(c.number_in_pulse);
    return count << 4U | (number & 15U);
  }

  /// Decodes all layers but the first.
  void next_fields(Channel& c, unsigned number, unsigned count, unsigned changed) {
    const unsigned kind = (number == 1 ? 2U : 0U) + (number >= count ? 1U : 0U);  // 3: the only return
    const unsigned time_changed = c.time_changed ? 1 : 0;
    char* const last = c.last;
    if (decoders_[layer14::height]) {
      const unsigned level = std::min(std::max(count, number) - std::min(count, number), 7U);
      c.coordinates.next_z(*decoders_[layer14::height], last, level, count == 1);
    }
    if (decoders_[layer14::classes]) {
      const unsigned context = (byte(c, at14::classification) & 31U) << 1U | (kind == 3 ? 1U : 0U);
      last[at14::classification] = static_cast<char>(decoders_[layer14::classes]->symbol(c.classification[context]));
    }
    if (decoders_[layer14::flags]) {
      const unsigned before = byte(c, at14::flags);
      const unsigned bits = decoders_[layer14::flags]->symbol(c.flags[(before >> 2U & 0x30U) | (before & 15U)]);
      last[at14::flags] = static_cast<char>((bits & 0x30U) << 2U | (before & 0x30U) | (bits & 15U));
    }
    if (decoders_[layer14::intensity]) {
      std::uint16_t& before = c.intensities[2 * kind + time_changed];
      before = static_cast<std::uint16_t>(c.intensity.decode(*decoders_[layer14::intensity], before, kind));
      store(last + at14::intensity, before);
    }
    if (decoders_[layer14::angle] && (changed & 8U) != 0)
      replace(c, at14::scan_angle, *decoders_[layer14::angle], c.scan_angle, time_changed);
    if (decoders_[layer14::user])
      last[at14::user_data] =
          static_cast<char>(decoders_[layer14::user]->symbol(c.user_data[byte(c, at14::user_data) / 4]));
    if (decoders_[layer14::source] && (changed & 32U) != 0)
      replace(c, at14::source, *decoders_[layer14::source], c.source, 0);
    if (decoders_[layer14::time] && c.time_changed) c.times.next(*decoders_[layer14::time], last + at14::time);
  }
  static void replace(Channel& c, std::size_t at, ArithmeticDecoder& decoder, IntegerDecoder<16>& numbers,
                      std::size_t context) {
    store16(c.last + at, numbers.decode(decoder, load_little<std::uint16_t>(c.last + at), context));
  }

  std::array<LayerDecoder, layer14::count> decoders_;
  std::array<std::unique_ptr<Channel>, channels> channels_;
  unsigned now_, version_;
};

/// Infrared, a number of 16 bits.
struct InfraredDecoder {
  static constexpr std::size_t size = 2;

  void next(ArithmeticDecoder& decoder, char* last) {
    const unsigned bits = decoder.symbol(changed);
    for (std::size_t i = 0; i < size; ++i)
      if ((bits >> i & 1U) != 0) bytes[i].next(decoder, last + i);
  }

  SymbolModel<4> changed = {};
  std::array<ByteDecoder, size> bytes = {};
};

/// A layer whose bytes `Models` decodes from the last bytes of the same channel.
template <typename Models>
class ChannelLayer {
 public:
  ChannelLayer(const ItemStart& start, std::size_t layer, std::size_t offset)
      : decoder_(decoder_of(start.streams[layer])), now_(start.chunk.channel), version_(start.version) {
    std::memcpy(last_[now_], start.first + offset, Models::size);
    if (decoder_) channels_[now_] = std::make_unique<Models>();
  }

  void next(char* to, unsigned channel) {
    char* last = last_[now_];
    if (decoder_ && channel != now_) {
      const bool is_new = !channels_[channel];
      if (is_new) {
        channels_[channel] = std::make_unique<Models>();
        std::memcpy(last_[channel], last, Models::size);
      }
      // In version 3 the first point after a change is predicted by the last point of the old channel, and replaces
      // that.
      if (is_new || version_ > 3) last = last_[channel];
      now_ = channel;
    }
    if (decoder_) channels_[now_]->next(*decoder_, last);
    std::memcpy(to, last, Models::size);
  }

 private:
  LayerDecoder decoder_;
  std::array<std::unique_ptr<Models>, channels> channels_ = {};
  char last_[channels][Models::size];
  unsigned now_, version_;
};

class Color14 final : public ItemDecoder {
 public:
  explicit Color14(const ItemStart& start) : color_(start, 0, 0) {
    if (start.streams.size() > 1) infrared_.emplace(start, 1, ColorDecoder::size);
  }
  void next(char* to, ChunkState& chunk) override {
    color_.next(to, chunk.channel);
    if (infrared_) infrared_->next(to + ColorDecoder::size, chunk.channel);
  }

 private:
  ChannelLayer<ColorDecoder> color_;
  std::optional<ChannelLayer<InfraredDecoder>> infrared_ = std::nullopt;
};

class Bytes14 final : public ItemDecoder {
 public:
  explicit Bytes14(const ItemStart& start) {
    for (std::size_t i = 0; i < start.size; ++i) bytes_.emplace_back(start, i, i);
  }
  void next(char* to, ChunkState& chunk) override {
    for (auto& byte : bytes_) byte.next(to++, chunk.channel);
  }

 private:
  std::vector<ChannelLayer<ByteDecoder>> bytes_ = {};
};

/// Wave packets, which are not decoded.
struct Waves14 final : ItemDecoder {
  explicit Waves14(const ItemStart&) {}
  void next(char*, ChunkState&) override {}
};

// Version 2 is that of a prototype, like version 3.
constexpr ItemKind layered_kinds[] = {{point14, 2, 4, 30, "aaaaaaaabbbbeeadcgffhhiiiiiiii", make_item<Point14>},
                                      {11, 2, 4, 6, "aaaaaa", make_item<Color14>},
                                      {12, 2, 4, 8, "aaaaaabb", make_item<Color14>},
                                      {13, 3, 4, 29, "aaaaaaaaaaaaaaaaaaaaaaaaaaaaa", make_item<Waves14>},
                                      {14, 2, 4, 0, "", make_item<Bytes14>}};

}  // namespace

const ItemKind* find_layered_item(unsigned type, unsigned version) {
  for (const ItemKind& kind : layered_kinds)
    if (kind.type == type && kind.least_version <= version && version <= kind.greatest_version) return &kind;
  return nullptr;
}

}  // namespace rbpa::app
