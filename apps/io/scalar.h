// What: the types of the numbers in binary files, and functions that read numbers of these types.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace rbpa::app {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Calls use(value) with a zero of the C++ type that `type` stands for, and returns the result of use().
template <typename Use>
constexpr auto with_type(Scalar type, const Use& use) {
  switch (type) {
    // NOLINTNEXTLINE(bugprone-branch-clone): alike in text, and of other types
    case Scalar::int8:
      return use(std::int8_t());
    case Scalar::uint8:
      return use(std::uint8_t());
    case Scalar::int16:
      return use(std::int16_t());
    case Scalar::uint16:
      return use(std::uint16_t());
    case Scalar::int32:
      return use(std::int32_t());
    case Scalar::uint32:
      return use(std::uint32_t());
    case Scalar::int64:
      return use(std::int64_t());
    case Scalar::uint64:
      return use(std::uint64_t());
    case Scalar::float32:
      return use(float());
    case Scalar::float64:
      break;
  }
  return use(double());
}

constexpr std::size_t size_of(Scalar type) {
  return with_type(type, [](auto value) { return sizeof value; });
}

constexpr bool is_integer(Scalar type) { return type != Scalar::float32 && type != Scalar::float64; }

/// Returns the value of type T that is stored at `bytes` in the given byte order.
template <typename T>
T load(const char* bytes, std::endian order) {
  using Bits = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(T) == 2, std::uint16_t,
                                                     std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;
  Bits bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  if (order != std::endian::native) {
    Bits reversed = 0;
    for (std::size_t i = 0; i < sizeof bits; ++i) {
      const auto byte = static_cast<std::uint64_t>(bits) >> (8 * i) & 0xFFU;
      reversed = static_cast<Bits>(reversed | static_cast<Bits>(byte << (8 * (sizeof bits - 1 - i))));
    }
    bits = reversed;
  }
  return std::bit_cast<T>(bits);
}

template <typename T>
T load_little(const char* bytes) {
  return load<T>(bytes, std::endian::little);
}

/// Returns the number of the given type at `bytes` as the nearest double.
inline double load_number(Scalar type, const char* bytes, std::endian order) {
  return with_type(type, [&](auto value) { return static_cast<double>(load<decltype(value)>(bytes, order)); });
}

/// Returns whether `value` is at most 2^53 in absolute value, up to which doubles represent all integers; always true
/// for types other than 64-bit integers.
template <typename T>
constexpr bool is_exact_in_double(T value) {
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
    constexpr T most = T{1} << 53U;
    if constexpr (std::is_signed_v<T>) return value <= most && value >= -most;
    return value <= most;
  }
  return true;
}

/// Returns the type for a kind, "i", "u" or "f", and a size in bytes, "1", "2", "4" or "8"; nothing if there is no such
/// type.
constexpr std::optional<Scalar> scalar_of(std::string_view kind, std::string_view size) {
  constexpr std::pair<std::string_view, Scalar> known[] = {
      {"i1", Scalar::int8},    {"u1", Scalar::uint8},  {"i2", Scalar::int16}, {"u2", Scalar::uint16},
      {"i4", Scalar::int32},   {"u4", Scalar::uint32}, {"i8", Scalar::int64}, {"u8", Scalar::uint64},
      {"f4", Scalar::float32}, {"f8", Scalar::float64}};
  for (const auto& [text, type] : known)
    if (kind == text.substr(0, 1) && size == text.substr(1)) return type;
  return std::nullopt;
}

}  // namespace rbpa::app
