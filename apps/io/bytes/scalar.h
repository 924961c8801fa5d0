// What: numbers as binary files store them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace rbpa::app {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr std::size_t size_of(Scalar type) {
  switch (type) {
    case Scalar::int8:
    case Scalar::uint8:
      return 1;
    case Scalar::int16:
    case Scalar::uint16:
      return 2;
    case Scalar::int32:
    case Scalar::uint32:
    case Scalar::float32:
      return 4;
    default:
      return 8;
  }
}

constexpr bool is_integer(Scalar type) { return type != Scalar::float32 && type != Scalar::float64; }

/// The value of type T stored at `bytes` in the given byte order.
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

/// The number of the given type at `bytes` as the nearest double.
inline double load_number(Scalar type, const char* bytes, std::endian order) {
  switch (type) {
    case Scalar::int8:
      return load<std::int8_t>(bytes, order);
    case Scalar::uint8:
      return load<std::uint8_t>(bytes, order);
    case Scalar::int16:
      return load<std::int16_t>(bytes, order);
    case Scalar::uint16:
      return load<std::uint16_t>(bytes, order);
    case Scalar::int32:
      return load<std::int32_t>(bytes, order);
    case Scalar::uint32:
      return load<std::uint32_t>(bytes, order);
    case Scalar::int64:
      return static_cast<double>(load<std::int64_t>(bytes, order));
    case Scalar::uint64:
      return static_cast<double>(load<std::uint64_t>(bytes, order));
    case Scalar::float32:
      return static_cast<double>(load<float>(bytes, order));
    case Scalar::float64:
      break;
  }
  return load<double>(bytes, order);
}

}  // namespace rbpa::app
