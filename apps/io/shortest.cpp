// What: put_number() for doubles, by exact integers where two words hold them; std::to_chars() has the rest.
//
// Let x = m · 2^−n with 2^52 < m < 2^53 be above 2^−10 and no integer. The reals nearer to x than to any other double,
// the interval, reach 2^−n / 2 to both sides. Let k be the least power for which 10^k · 2^−n > 1; it is < 10. In units
// of 10^−k the interval is longer than one and shorter than ten. So it holds at most one multiple of ten, which then is
// the shortest decimal in it with zeros behind, since one still shorter would be another multiple. Otherwise the
// integers in it are the shortest, the one nearest to x is among them, and of two as near the even one is asked for.
// The ends of the interval are (2m ± 1) · 5^k / 2^(n−k+1), odd over even, and so never integers themselves.
//
// 2m · 5^k has at most 54 + 45 bits, as k ≤ 19: two words hold everything exactly.
//
// Source: the choice of k and of candidates follows R. Giulietti, The Schubfach way to render doubles (2020), which
// approximates 5^k to reach the whole range.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <utility>

#include "io/decimal.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

using decimal::powers_of_ten;
using decimal::TwoWords;

constexpr int largest_shift = 62;  // n of 2^-10: from there on no number is shorter with an exponent

struct Scale {
  int places;          ///< k
  std::uint64_t five;  ///< 5^k
};

constexpr std::array<Scale, largest_shift + 1> make_scales() {
  std::array<Scale, largest_shift + 1> scales{};
  std::uint64_t five = 1;
  int places = 0;
  for (int n = 0; n <= largest_shift; ++n) {
    while (n > 0 && five >> (n - places) == 0) {  // 5^k < 2^(n-k)
      five *= 5;
      ++places;
    }
    scales[static_cast<std::size_t>(n)] = {places, five};
  }
  return scales;
}

constexpr auto scales = make_scales();

/// value · 10^−places
struct Digits {
  std::uint64_t value;
  int places;
};

Digits without_zeros(Digits digits) {
  for (const auto& [power, zeros] : {std::pair{100000000U, 8}, {100000000U, 8}, {10000U, 4}, {100U, 2}, {10U, 1}})
    if (digits.value % power == 0) digits = {digits.value / power, digits.places - zeros};
  return digits;
}

/// The shortest decimal for m · 2^−n as above.
Digits shortest_digits(std::uint64_t m, int n) {
  const auto [places, five] = scales[static_cast<std::size_t>(n)];
  const int shift = n - places + 1;  // all below is in units of 2^-shift
  const TwoWords x = TwoWords{2 * m} * five, least = x - five, most = x + five;
  const auto floor = static_cast<std::uint64_t>(x >> shift);
  const std::uint64_t ten = floor / 10 * 10;
  if (least < TwoWords{ten} << shift) return without_zeros({ten, places});
  if (most > TwoWords{ten + 10} << shift) return without_zeros({ten + 10, places});
  const TwoWords rest = x - (TwoWords{floor} << shift), half = TwoWords{1} << (shift - 1);
  const bool up = rest > half || (rest == half && floor % 2 == 1);
  return {floor + (up ? 1 : 0), places};
}

constexpr std::array<char, 200> make_pairs() {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}

constexpr auto pairs = make_pairs();

/// Puts eight digits, zeros in front included.
void put_eight(char* at, std::uint32_t value) {
  const std::uint32_t upper = value / 10000, lower = value % 10000;
  std::memcpy(at, &pairs[2 * (upper / 100)], 2);
  std::memcpy(at + 2, &pairs[2 * (upper % 100)], 2);
  std::memcpy(at + 4, &pairs[2 * (lower / 100)], 2);
  std::memcpy(at + 6, &pairs[2 * (lower % 100)], 2);
}

/// Puts `places` digits, at most 19, zeros in front included; what is behind them up to 16 is overwritten.
char* put_places(char* at, std::uint64_t value, int places) {
  constexpr int two_blocks = 16;
  if (places > two_blocks) {
    std::uint64_t front = value / powers_of_ten[two_blocks];
    value %= powers_of_ten[two_blocks];
    places -= two_blocks;
    for (char* digit = at + places; digit != at; front /= 10) *--digit = static_cast<char>('0' + front % 10);
    at += places;
    places = two_blocks;
  }
  value *= powers_of_ten[static_cast<std::size_t>(two_blocks - places)];
  put_eight(at, static_cast<std::uint32_t>(value / 100000000));
  put_eight(at + 8, static_cast<std::uint32_t>(value % 100000000));
  return at + places;
}

}  // namespace

char* put_number(char* at, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  if (bits == 0) return put_number(at, bits);
  const int n = 1023 + 52 - static_cast<int>(bits >> 52U & 0x7FFU);
  if (n < 0 || n > largest_shift) return std::to_chars(at, at + number_room, value).ptr;
  const std::uint64_t implied = std::uint64_t{1} << 52U, m = (bits & (implied - 1)) | implied;
  const bool is_integer = n == 0 || m << (64 - n) == 0;
  // With five zeros behind an exponent is shorter, and a power of two has a neighbour at half the distance.
  if (is_integer ? (m >> n) % 100000 == 0 : m == implied) return std::to_chars(at, at + number_room, value).ptr;
  if (bits >> 63U != 0) *at++ = '-';
  const std::uint64_t integer = m >> n;
  at = put_number(at, integer);
  if (is_integer) return at;
  // Integers of this size are doubles, and so never in the interval: the decimal lies between the same two as x.
  const Digits digits = shortest_digits(m, n);
  *at++ = '.';
  return put_places(at, digits.value - integer * powers_of_ten[static_cast<std::size_t>(digits.places)], digits.places);
}

}  // namespace rbpa::app
