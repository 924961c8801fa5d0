#include "io/las/scaled_integer.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>

#include "io/number.h"

namespace rbpa::app {
namespace {

constexpr std::int64_t greatest_exact = std::int64_t{1} << 53;  // up to it every integer is a double
constexpr int max_places = 15;                                  // ten to that is exact, and below 2^53

/// digits · 10^-places.
struct Decimal {
  std::int64_t digits;
  int places;
};

/// The shortest decimal that reads back to the value, when it has few enough digits and places.
std::optional<Decimal> decimal_of(double value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
  const std::string_view all(text, static_cast<std::size_t>(end - text));
  const std::size_t e = all.find('e');
  if (e == std::string_view::npos) return std::nullopt;
  Decimal decimal{0, 0};
  bool fraction = false;
  for (const char c : all.substr(0, e)) {
    if (c == '-') continue;
    if (c == '.') {
      fraction = true;
      continue;
    }
    decimal.digits = 10 * decimal.digits + (c - '0');  // at most 17 digits
    decimal.places += fraction ? 1 : 0;
  }
  int exponent = 0;
  const char* first = all.data() + e + 1;
  std::from_chars(*first == '+' ? first + 1 : first, end, exponent);
  decimal.places -= exponent;
  if (all.front() == '-') decimal.digits = -decimal.digits;
  if (decimal.digits == 0) return Decimal{0, 0};
  for (; decimal.places < 0; ++decimal.places) {
    if (std::abs(decimal.digits) > greatest_exact / 10) return std::nullopt;
    decimal.digits *= 10;
  }
  if (decimal.places > max_places) return std::nullopt;
  return decimal;
}

/// The digits with so many places, when they stay small enough.
std::optional<std::int64_t> with_places(Decimal decimal, int places) {
  for (; decimal.places < places; ++decimal.places) {
    if (std::abs(decimal.digits) > greatest_exact / 10) return std::nullopt;
    decimal.digits *= 10;
  }
  return decimal.digits;
}

}  // namespace

ScaledInteger::ScaledInteger(double scale, double offset) : scale_(scale), offset_(offset) {
  const std::optional<Decimal> a = decimal_of(scale), b = decimal_of(offset);
  if (!a || !b) return;
  const int places = std::max(a->places, b->places);
  const std::optional<std::int64_t> factor = with_places(*a, places), summand = with_places(*b, places);
  constexpr std::int64_t largest_value = std::int64_t{1} << 31;
  if (!factor || !summand || std::abs(*factor) > (greatest_exact - std::abs(*summand)) / largest_value) return;
  exact_ = true;
  factor_ = *factor;
  summand_ = *summand;
  for (int i = 0; i < places; ++i) divisor_ *= 10;
}

}  // namespace rbpa::app
