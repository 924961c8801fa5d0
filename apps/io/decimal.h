// What: the decimal numbers that one product of two words decides, which are nearly all that files hold.
// Law:  what is decided is what std::from_chars() finds, value and end; the rest is left to it.
// Cost: a few operations for eight digits, one product.
// Source: W. Clinger, How to read floating point numbers accurately (1990); the bound is derived below.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace rbpa::app {

/// w · 10^exponent as the nearest double, or absent when more than a product is needed to tell.
///
/// Requires w > 0. Let 5^exponent = (power + δ) · 2^s with 0 ≤ δ < 1 and 2^63 ≤ power < 2^64, and w be shifted up to
/// 2^63 ≤ w < 2^64. Then w · (power + δ) lies less than 2^64 above w · power: less than one unit of its upper word. Of
/// that word 53 bits are the mantissa, and the bits below them, the rest, tell which way to round. The true rest lies
/// from rest + lower word up to less than one more: down when rest + 2 ≤ half; up when rest and lower word are above
/// half, since an excess beyond the next mantissa rounds to the same. Between lies what is left undecided.
std::optional<double> nearest_double(std::uint64_t w, int exponent);

namespace decimal {

__extension__ typedef unsigned __int128 TwoWords;

constexpr int largest_exponent = 27;  // 5^27 < 2^63 < 5^28

struct PowerOfFive {
  std::uint64_t power;  ///< its upper 64 bits
  int shift;            ///< the bits below them
};

constexpr std::array<PowerOfFive, 2 * largest_exponent + 1> make_powers_of_five() {
  std::array<PowerOfFive, 2 * largest_exponent + 1> powers{};
  std::uint64_t five = 1;
  for (std::size_t i = 0; i <= largest_exponent; ++i, five *= 5) {
    const int bits = static_cast<int>(std::bit_width(five));
    powers[largest_exponent + i] = {five << (64 - bits), bits - 64};
    if (i > 0)
      powers[largest_exponent - i] = {static_cast<std::uint64_t>((TwoWords{1} << (63 + bits)) / five), -63 - bits};
  }
  return powers;
}

inline constexpr auto powers_of_five = make_powers_of_five();

constexpr std::array<std::uint64_t, 20> make_powers_of_ten() {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}

inline constexpr auto powers_of_ten = make_powers_of_ten();

constexpr std::uint64_t each_byte(std::uint64_t byte) { return byte * 0x0101010101010101U; }

/// The digits at the front of `text`, the first in the lowest byte, up to the first other character.
inline unsigned count_digits(std::uint64_t text) {
  // In a byte with a digit neither sum reaches the upper bit nor a neighbour, so the lowest byte that does is exact.
  const std::uint64_t others = ((text + each_byte(0x46)) | (text - each_byte(0x30))) & each_byte(0x80);
  return static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// Eight digits, the first in the lowest byte, as a number: neighbours are joined in pairs, fours, eights.
inline std::uint64_t value_of_eight(std::uint64_t text) {
  text -= each_byte('0');
  text = (text & 0x00FF00FF00FF00FFU) * 10 + (text >> 8U & 0x00FF00FF00FF00FFU);
  text = (text & 0x0000FFFF0000FFFFU) * 100 + (text >> 16U & 0x0000FFFF0000FFFFU);
  return (text & 0xFFFFFFFFU) * 10000 + (text >> 32U);
}

/// Appends the digits from `at` on to `w`, modulo 2^64, and returns where they end.
inline const char* take_digits(const char* at, const char* last, std::uint64_t& w) {
  if constexpr (std::endian::native == std::endian::little) {
    while (last - at >= 8) {
      std::uint64_t text = 0;
      std::memcpy(&text, at, sizeof text);
      const unsigned count = count_digits(text);
      if (count == 8) {
        w = w * powers_of_ten[8] + value_of_eight(text);
        at += 8;
        continue;
      }
      if (count == 0) return at;
      // Zeros go in front, where they do not count.
      text = text << (64 - 8 * count) | each_byte('0') >> (8 * count);
      w = w * powers_of_ten[count] + value_of_eight(text);
      return at + count;
    }
  }
  for (; at != last && *at >= '0' && *at <= '9'; ++at) w = w * 10 + static_cast<std::uint64_t>(*at - '0');
  return at;
}

}  // namespace decimal

inline std::optional<double> nearest_double(std::uint64_t w, int exponent) {
  if (exponent < -decimal::largest_exponent || exponent > decimal::largest_exponent) return std::nullopt;
  const auto [power, shift] = decimal::powers_of_five[static_cast<std::size_t>(exponent + decimal::largest_exponent)];
  const int zeros = std::countl_zero(w);
  const decimal::TwoWords product = decimal::TwoWords{w << zeros} * power;
  const auto upper = static_cast<std::uint64_t>(product >> 64U), lower = static_cast<std::uint64_t>(product);
  const int dropped = 10 + static_cast<int>(upper >> 63U);  // the upper word has 63 or 64 bits
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1), rest = upper & (2 * half - 1);
  if (rest + 1 == half || (rest == half && lower == 0)) return std::nullopt;
  const std::uint64_t mantissa = (upper >> dropped) + (rest >= half ? 1U : 0U);
  // 2^-140 < 10^-27 and 2^64 · 10^27 < 2^160: no exponent here is near the ends of the range of double.
  const auto scale = static_cast<std::uint64_t>(1023 + 64 + dropped + shift + exponent - zeros) << 52U;
  return static_cast<double>(static_cast<std::int64_t>(mantissa)) * std::bit_cast<double>(scale);
}

struct Decimal {
  double value;
  const char* end;  ///< behind its last character; null when it is not decided
};

/// The number that begins at `first`, without sign or with '-'.
inline Decimal read_decimal(const char* first, const char* last) {
  constexpr Decimal undecided = {0, nullptr};
  const bool negative = first != last && *first == '-';
  const char* const digits = negative ? first + 1 : first;
  std::uint64_t w = 0;
  const char* at = decimal::take_digits(digits, last, w);
  auto count = at - digits;
  std::ptrdiff_t exponent = 0;
  if (at != last && *at == '.') {
    const char* const behind_point = at + 1;
    at = decimal::take_digits(behind_point, last, w);
    exponent = behind_point - at;
    count -= exponent;
  }
  if (count == 0) return undecided;
  if (count > 19) {
    for (const char* zero = digits; *zero == '0' || *zero == '.'; ++zero)
      if (*zero == '0' && --count == 0) break;
    if (count > 19) return undecided;  // w may have overflown
  }
  if (at != last && (*at == 'e' || *at == 'E')) {
    const char* power = at + 1;
    const bool down = power != last && *power == '-';
    if (power != last && (*power == '-' || *power == '+')) ++power;
    std::uint64_t magnitude = 0;
    const char* const end = decimal::take_digits(power, last, magnitude);
    if (end - power > 4) return undecided;
    if (end != power) {  // otherwise the letter belongs to what follows
      exponent += down ? -static_cast<std::ptrdiff_t>(magnitude) : static_cast<std::ptrdiff_t>(magnitude);
      at = end;
    }
  }
  if (w == 0) return {negative ? -0.0 : 0.0, at};
  if (exponent < -decimal::largest_exponent || exponent > decimal::largest_exponent) return undecided;
  const std::optional<double> value = nearest_double(w, static_cast<int>(exponent));
  if (!value) return undecided;
  return {negative ? -*value : *value, at};
}

}  // namespace rbpa::app
