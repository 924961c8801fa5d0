#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "io/laz/item_models.h"
#include "io/laz/items.h"

namespace rbpa::app {
namespace {

/// Decodes items, each from the item before, by `Models`.
template <typename Models>
class PointwiseItem final : public ItemDecoder {
 public:
  explicit PointwiseItem(const ItemStart& start) : last_(start.first, start.first + start.size), models_(last_) {}

  void next(char* to, ChunkState& chunk) override {
    models_.next(*chunk.stream, last_.data());
    std::copy(last_.begin(), last_.end(), to);
  }

 private:
  std::vector<char> last_;
  Models models_;
};

/// Offsets in a record of formats 0 to 5; `returns` are numbers of returns with flags.
namespace at10 {
constexpr std::size_t intensity = 12, returns = 14, classification = 15, scan_angle = 16, user_data = 17, source = 18;
}

/// The models of the fields that both versions of point records decode alike, and the decoding of these fields.
struct PointModels {
  using Bytes = ModelTable<256, 256>;

  /// Replaces the byte at `at` by the next byte, with a model for each value of the last byte.
  static void replace(ArithmeticDecoder& decoder, char* at, Bytes& models) {
    *at = static_cast<char>(decoder.symbol(models[static_cast<unsigned char>(*at)]));
  }
  void replace_source(ArithmeticDecoder& decoder, char* last) {
    store16(last + at10::source, source.decode(decoder, load_little<std::uint16_t>(last + at10::source)));
  }

  SymbolModel<64> changed = {};
  Bytes returns = {}, classification = {}, user_data = {};
  IntegerDecoder<16> source = {};
};

class Point10Version1 : PointModels {
 public:
  explicit Point10Version1(const std::vector<char>&) {}

  void next(ArithmeticDecoder& decoder, char* last) {
    const std::int32_t dx = dx_.decode_signed(decoder, median(x_));
    const std::int32_t dy = dy_.decode_signed(decoder, median(y_), std::min(dx_.size(), 19U));
    const unsigned size = (dx_.size() + dy_.size()) / 2;
    add32(last, dx);
    add32(last + 4, dy);
    store(last + 8, dz_.decode(decoder, load_little<std::uint32_t>(last + 8), std::min(size, 19U)));
    x_[oldest_] = dx;
    y_[oldest_] = dy;
    oldest_ = (oldest_ + 1) % 3;
    const unsigned bits = decoder.symbol(changed);
    if ((bits & 32U) != 0)
      store16(last + at10::intensity, intensity_.decode(decoder, load_little<std::uint16_t>(last + at10::intensity)));
    if ((bits & 16U) != 0) replace(decoder, last + at10::returns, returns);
    if ((bits & 8U) != 0) replace(decoder, last + at10::classification, classification);
    char& angle = last[at10::scan_angle];
    if ((bits & 4U) != 0)
      angle = static_cast<char>(angle_.decode(decoder, static_cast<unsigned char>(angle), size < 3 ? 1 : 0));
    if ((bits & 2U) != 0) replace(decoder, last + at10::user_data, user_data);
    if ((bits & 1U) != 0) replace_source(decoder, last);
  }

 private:
  using Differences = std::array<std::int32_t, 3>;
  static std::int32_t median(const Differences& last) {
    return std::max(std::min(last[0], last[1]), std::min(std::max(last[0], last[1]), last[2]));
  }

  IntegerDecoder<32> dx_ = {}, dy_ = IntegerDecoder<32>(20), dz_ = IntegerDecoder<32>(20);
  IntegerDecoder<16> intensity_ = {};
  IntegerDecoder<8> angle_ = IntegerDecoder<8>(2);
  Differences x_ = {}, y_ = {};
  std::size_t oldest_ = 0;
};

/// Contexts for a return number (second index) of a number of returns (first index) from 0 to 7, in hexadecimal digits.
/// Return numbers from 1 to the number of returns, up to 5, have the contexts 0 to 14, one each; other pairs share
/// contexts.
constexpr char contexts_of_returns[8][9] = {"fedcba98", "e0136aa9", "d1247bba", "c3458ccb",
                                            "b6789ddc", "aabcdeed", "9abcdefe", "89abcdef"};

class Point10Version2 : PointModels {
 public:
  explicit Point10Version2(std::vector<char>& last) { store16(&last[at10::intensity], 0); }

  void next(ArithmeticDecoder& decoder, char* last) {
    const unsigned bits = decoder.symbol(changed);
    if ((bits & 32U) != 0) replace(decoder, last + at10::returns, returns);
    const unsigned flags = static_cast<unsigned char>(last[at10::returns]), number = flags & 7U,
                   count = flags >> 3U & 7U;
    const char digit = contexts_of_returns[count][number];
    const auto context = static_cast<std::size_t>(digit >= 'a' ? digit - 'a' + 10 : digit - '0');
    std::uint16_t& intensity = intensities_[context];
    if ((bits & 16U) != 0)
      intensity = static_cast<std::uint16_t>(intensity_.decode(decoder, intensity, std::min<std::size_t>(context, 3)));
    store(last + at10::intensity, intensity);
    if ((bits & 8U) != 0) replace(decoder, last + at10::classification, classification);
    char& angle = last[at10::scan_angle];
    if ((bits & 4U) != 0)
      angle = static_cast<char>(static_cast<unsigned char>(angle) + decoder.symbol(angle_[flags >> 6U & 1U]));
    if ((bits & 2U) != 0) replace(decoder, last + at10::user_data, user_data);
    if ((bits & 1U) != 0) replace_source(decoder, last);
    place_.next_xy(decoder, last, context, count == 1);
    place_.next_z(decoder, last, std::max(count, number) - std::min(count, number), count == 1);
  }

 private:
  std::array<std::uint16_t, 16> intensities_ = {};
  IntegerDecoder<16> intensity_ = IntegerDecoder<16>(4);
  std::array<SymbolModel<256>, 2> angle_ = {};  // one for each direction of the scan
  PlaceDecoder<16> place_ = {};
};

class Time11Version1 {
 public:
  explicit Time11Version1(const std::vector<char>&) {}

  void next(ArithmeticDecoder& decoder, char* last) {
    const bool moves = difference_ != 0;
    const unsigned symbol = moves ? decoder.symbol(multiples_) : decoder.symbol(kinds_);
    if (symbol == (moves ? full : 2)) store(last, decoder.bits64());
    if (!moves && symbol == 1) add64(last, difference_ = numbers_.decode_signed(decoder, 0, 0));
    if (!moves || symbol >= full) return;
    const auto unit = static_cast<std::uint32_t>(difference_);
    const std::uint32_t predicted = symbol == 0 ? static_cast<std::uint32_t>(difference_ / 4) : symbol * unit;
    const std::size_t context = symbol == 0 ? 2 : symbol == 1 ? 1 : symbol < 10 ? 3 : symbol < 50 ? 4 : 5;
    const std::int32_t difference = numbers_.decode_signed(decoder, static_cast<std::int32_t>(predicted), context);
    add64(last, difference);
    const bool is_extreme = symbol == 0 || symbol == full - 1;
    if (symbol != 1 && !(is_extreme && ++extremes_ > 3)) return;
    difference_ = difference;
    extremes_ = 0;
  }

 private:
  static constexpr unsigned full = 510;
  SymbolModel<full + 2> multiples_ = {};
  SymbolModel<3> kinds_ = {};
  IntegerDecoder<32> numbers_ = IntegerDecoder<32>(6);
  std::int32_t difference_ = 0, extremes_ = 0;
};

struct Time11Version2 : TimeDecoder<true> {
  explicit Time11Version2(const std::vector<char>& first) : TimeDecoder<true>(first.data()) {}
};

/// Decodes bytes as integers: all extra bytes, or those bytes of a color whose bits are set in a symbol.
template <bool are_colors>
struct BytesVersion1 {
  explicit BytesVersion1(const std::vector<char>& first) : bytes(first.size()) {}

  void next(ArithmeticDecoder& decoder, char* last) {
    const unsigned bits = are_colors ? decoder.symbol(changed) : 0;
    for (std::size_t i = 0; i < bytes.contexts(); ++i)
      if (!are_colors || (bits >> i & 1U) != 0)
        last[i] = static_cast<char>(bytes.decode(decoder, static_cast<unsigned char>(last[i]), i));
  }

  SymbolModel<64> changed = {};
  IntegerDecoder<8> bytes;
};

struct Color12Version2 : ColorDecoder {
  explicit Color12Version2(const std::vector<char>&) {}
};

struct BytesVersion2 {
  explicit BytesVersion2(const std::vector<char>& first) : bytes(first.size()) {}
  void next(ArithmeticDecoder& decoder, char* last) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i].next(decoder, last + i);
  }
  std::vector<ByteDecoder> bytes;
};

/// Wave packets: an index; offset and size of a wave; its place and direction.
class WavePacket13 {
 public:
  explicit WavePacket13(const std::vector<char>&) {}

  void next(ArithmeticDecoder& decoder, char* last) {
    char *const offset = last + 1, *const size = last + 9;
    *last = static_cast<char>(decoder.symbol(index_));
    const auto old_size = load_little<std::uint32_t>(size);
    kind_ = decoder.symbol(kinds_[kind_]);
    if (kind_ == 1) store(offset, load_little<std::uint64_t>(offset) + old_size);
    if (kind_ == 2) add64(offset, difference_ = differences_.decode_signed(decoder, difference_));
    if (kind_ == 3) store(offset, decoder.bits64());
    IntegerDecoder<32>* const decoders[] = {&sizes_, &places_, &directions_, &directions_, &directions_};
    for (std::size_t i = 0; i < 5; ++i)
      store(size + 4 * i, decoders[i]->decode(decoder, load_little<std::uint32_t>(size + 4 * i), i < 2 ? 0 : i - 2));
  }

 private:
  SymbolModel<256> index_ = {};
  std::array<SymbolModel<4>, 4> kinds_ = {};
  IntegerDecoder<32> differences_ = {}, sizes_ = {}, places_ = {}, directions_ = IntegerDecoder<32>(3);
  std::int32_t difference_ = 0;
  unsigned kind_ = 0;
};

template <typename Models>
constexpr ItemKind kind(unsigned type, unsigned version, std::size_t size) {
  return {type, version, version, size, {}, make_item<PointwiseItem<Models>>};
}
constexpr ItemKind pointwise_kinds[] = {
    kind<BytesVersion1<false>>(0, 1, 0), kind<BytesVersion2>(0, 2, 0),   kind<Point10Version1>(6, 1, 20),
    kind<Point10Version2>(6, 2, 20),     kind<Time11Version1>(7, 1, 8),  kind<Time11Version2>(7, 2, 8),
    kind<BytesVersion1<true>>(8, 1, 6),  kind<Color12Version2>(8, 2, 6), kind<WavePacket13>(9, 1, 29)};

}  // namespace

const ItemKind* find_pointwise_item(unsigned type, unsigned version) {
  for (const ItemKind& kind : pointwise_kinds)
    if (kind.type == type && kind.least_version == version) return &kind;
  return nullptr;
}

}  // namespace rbpa::app
