#include "stream/pack_block.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace rbpa::app {
namespace {

// Packing stores numbers of any width from 0 to 64 bits without gaps between them.

unsigned bits_of(std::uint64_t value) { return static_cast<unsigned>(std::bit_width(value)); }

/// Returns the size in bytes of `count` packed numbers of `width` bits, rounded up to whole words of 8 bytes.
std::size_t packed_size(std::size_t count, unsigned width) { return (count * width + 63) / 64 * 8; }

/// Appends the lowest `width` bits of each value to `bytes`. Requires: the other bits are 0.
void pack(std::span<const std::uint64_t> values, unsigned width, std::string& bytes) {
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

/// Reverses pack(): sets all `values`. Requires: width > 0; `bytes` points to packed_size(values.size(), width) bytes.
void unpack(const char* bytes, unsigned width, std::span<std::uint64_t> values) {
  const std::uint64_t mask = width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  std::uint64_t word = 0;
  unsigned left = 0;  // number of bits of the word that are not read yet
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

constexpr std::array<double, 16> powers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr std::uint8_t as_keys = 0xff;
constexpr std::uint64_t sign = std::uint64_t{1} << 63U;

/// Returns an integer for a double, so that the order of the integers is the order of the doubles.
std::uint64_t key_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}
double of_key(std::uint64_t key) { return std::bit_cast<double>((key & sign) != 0 ? key & ~sign : ~key); }

using Values = std::array<std::uint64_t, most_in_packed_block>;

/// The frame of a column of a block. Coordinate i is base + (packed value i << shift); index i is base + values 0 to i.
struct Frame {
  std::uint8_t kind;   // number of decimal places, or as_keys; 0 for indices
  std::uint8_t width;  // number of bits of a packed value
  std::uint8_t shift;
  std::uint64_t base;
};
constexpr std::size_t frame_size = 3 + 8;

void append(std::string& bytes, const Frame& frame) {
  bytes += static_cast<char>(frame.kind);
  bytes += static_cast<char>(frame.width);
  bytes += static_cast<char>(frame.shift);
  bytes.append(reinterpret_cast<const char*>(&frame.base), sizeof frame.base);
}

void append_packed(std::uint8_t kind, std::span<std::uint64_t> values, std::uint64_t base, std::string& bytes) {
  std::uint64_t any = 0;
  for (std::uint64_t& value : values) any |= value -= base;
  const auto shift = static_cast<std::uint8_t>(any == 0 ? 0 : std::countr_zero(any));
  for (std::uint64_t& value : values) value >>= shift;
  const auto width = static_cast<std::uint8_t>(bits_of(any >> shift));
  append(bytes, {kind, width, shift, base});
  pack(values, width, bytes);
}

/// Sets `values` to the coordinates times 10^places, as integers. Returns false unless dividing each integer gives the
/// bits of its coordinate back.
template <double Point::*axis>
bool as_decimals(std::span<const Point> points, unsigned places, std::span<std::uint64_t> values) {
  const double power = powers[places];
  // Add `rounding`, so that the last bits of the sum are the nearest integer. Refuse numbers of magnitude 2⁵¹ or more:
  // their sum could leave [2⁵², 2⁵³), where the last bits of a double are a whole number.
  constexpr double most = 0x1p51, rounding = 0x1.8p52;
  const auto rounding_bits = std::bit_cast<std::uint64_t>(rounding);
  bool exact = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = points[i].*axis, scaled = value * power;
    const double sum = (std::abs(scaled) < most ? scaled : 0) + rounding;
    const double whole = sum - rounding;
    exact &= std::bit_cast<std::uint64_t>(whole / power + 0.0) == std::bit_cast<std::uint64_t>(value);
    values[i] = std::bit_cast<std::uint64_t>(sum) - rounding_bits + sign;  // in the order of the doubles
  }
  return exact;
}

template <double Point::*axis>
bool find_decimals(std::span<const Point> points, unsigned& hint, std::span<std::uint64_t> values) {
  const auto fits = [&](unsigned places) {
    const std::size_t few = std::min<std::size_t>(points.size(), 8);
    return as_decimals<axis>(points.first(few), places, values) && as_decimals<axis>(points, places, values);
  };
  if (hint == as_keys) return false;
  // Begin with `hint` places: numbers with fewer decimal places fit too.
  for (unsigned places = hint; places < powers.size(); ++places)
    if (fits(places)) {
      hint = places;
      return true;
    }
  hint = as_keys;
  return false;
}

template <double Point::*axis>
void pack_column(std::span<const Point> points, unsigned& hint, std::string& bytes) {
  Values room{};
  const std::span<std::uint64_t> values(room.data(), points.size());
  std::uint8_t kind = as_keys;
  if (find_decimals<axis>(points, hint, values)) {
    kind = static_cast<std::uint8_t>(hint);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = key_of(points[i].*axis);
  }
  append_packed(kind, values, *std::min_element(values.begin(), values.end()), bytes);
}

void pack_indices(std::span<const std::uint64_t> indices, std::string& bytes) {
  Values room{};
  const std::span<std::uint64_t> values(room.data(), indices.size());
  values[0] = 0;
  for (std::size_t i = 1; i < indices.size(); ++i) values[i] = indices[i] - indices[i - 1];
  std::uint64_t any = 0;
  for (const std::uint64_t value : values) any |= value;
  const auto width = static_cast<std::uint8_t>(bits_of(any));
  append(bytes, {0, width, 0, indices[0]});
  pack(values, width, bytes);
}

/// Removes the frame and the packed values of a column from the front of `bytes`, and sets `values` to the packed
/// values. Returns the frame, or nothing if the bytes are not a column.
std::optional<Frame> unpack_column(std::string_view& bytes, std::span<std::uint64_t> values) {
  if (bytes.size() < frame_size) return std::nullopt;
  Frame frame{static_cast<std::uint8_t>(bytes[0]), static_cast<std::uint8_t>(bytes[1]),
              static_cast<std::uint8_t>(bytes[2]), 0};
  std::memcpy(&frame.base, bytes.data() + 3, sizeof frame.base);
  bytes.remove_prefix(frame_size);
  if (frame.width > 64 || frame.shift > 63) return std::nullopt;
  const std::size_t size = packed_size(values.size(), frame.width);
  if (bytes.size() < size) return std::nullopt;
  if (frame.width == 0) {
    std::fill(values.begin(), values.end(), 0);
  } else {
    unpack(bytes.data(), frame.width, values);
  }
  bytes.remove_prefix(size);
  return frame;
}

template <double Point::*axis>
bool take_coordinates(std::string_view& bytes, std::span<Point> points, std::span<std::uint64_t> values) {
  const std::optional<Frame> frame = unpack_column(bytes, values);
  if (!frame || (frame->kind != as_keys && frame->kind >= powers.size())) return false;
  for (std::uint64_t& value : values) value = (value << frame->shift) + frame->base;
  if (frame->kind == as_keys) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i].*axis = of_key(values[i]);
    return true;
  }
  const double power = powers[frame->kind];
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].*axis = static_cast<double>(static_cast<std::int64_t>(values[i] - sign)) / power;
  return true;
}

}  // namespace

void pack_block(std::span<const Point> points, std::span<const std::uint64_t> indices, PackingHint& hint,
                std::string& bytes) {
  const auto count = static_cast<std::uint16_t>(points.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  pack_column<&Point::x>(points, hint.places[0], bytes);
  pack_column<&Point::y>(points, hint.places[1], bytes);
  pack_indices(indices, bytes);
}

bool unpack_block(std::string_view bytes, IndexedPoints& points) {
  std::uint16_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count == 0 || count > most_in_packed_block) return false;
  const std::size_t before = points.size();
  points.points.resize(before + count);
  points.indices.resize(before + count);
  Values room{};
  const std::span<std::uint64_t> values(room.data(), count);
  const std::span<Point> some = std::span(points.points).subspan(before);
  if (!take_coordinates<&Point::x>(bytes, some, values) || !take_coordinates<&Point::y>(bytes, some, values))
    return false;
  const std::optional<Frame> frame = unpack_column(bytes, values);
  if (!frame || !bytes.empty()) return false;
  std::uint64_t index = frame->base;
  for (std::size_t i = 0; i < count; ++i) points.indices[before + i] = index += values[i];
  return std::all_of(some.begin(), some.end(), [](const Point& p) { return is_finite(p); });
}

}  // namespace rbpa::app
