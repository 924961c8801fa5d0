// Numbers in text: their ends as by std::from_chars(), their values as by strtod(), and back.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

#include "io/number.h"
#include "support/arguments.h"

using rbpa::app::NumberFault;
using rbpa::app::ParsedNumber;

namespace {

/// Returns whether a text is an integer that differs from its double, which is at least 2^53.
bool is_rounded_integer(std::string_view text, double value) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return false;
  while (text.front() == '0') text.remove_prefix(1);
  std::array<char, 400> exact{};
  std::snprintf(exact.data(), exact.size(), "%.0f", std::abs(value));
  return text != exact.data();
}

/// Parses a number without our reader: std::from_chars() finds its end, strtod() its value.
ParsedNumber by_the_standard(const char* first, const char* last) {
  if (last - first > 1 && *first == '+' && first[1] != '-') ++first;
  double value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::invalid_argument) return {0, first, NumberFault::not_a_number};
  value = std::strtod(std::string(first, end).c_str(), nullptr);
  if (std::abs(value) >= 0x1p53 && std::isfinite(value) &&
      is_rounded_integer({first, static_cast<std::size_t>(end - first)}, value))
    return {value, end, NumberFault::rounded_integer};
  if (std::isfinite(value)) return {value, end, NumberFault::none};
  return {value, end, error == std::errc() ? NumberFault::not_finite : NumberFault::out_of_range};
}

bool same(const ParsedNumber& a, const ParsedNumber& b) {
  if (a.fault != b.fault || a.end != b.end) return false;
  return a.fault != NumberFault::none || std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

/// Returns whether both readers agree, at the end of the text and with more text after it.
bool reads_alike(const std::string& text) {
  const char* const first = text.data();
  const char* const last = first + text.size();
  if (!same(rbpa::app::parse_number(first, last), by_the_standard(first, last))) return false;
  for (const char* behind : {" 1234567890", ",-.5e3", "\n", "\r\n7"}) {
    const std::string more = text + behind;
    if (!same(rbpa::app::parse_number(more.data(), more.data() + more.size()),
              by_the_standard(more.data(), more.data() + more.size())))
      return false;
  }
  return true;
}

/// Returns the digits from the first to the last that is not 0, without the exponent.
int significant_digits(std::string_view text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e')))
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0'), last = digits.find_last_not_of('0');
  return first == std::string::npos ? 0 : static_cast<int>(last - first + 1);
}

/// Returns `value` rounded to the given number of digits.
std::string rounded(double value, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
  return text.data();
}

class Texts {
 public:
  explicit Texts(std::uint64_t seed) : random_(seed) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  double any_double() { return std::bit_cast<double>(random_()); }
  double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }

  std::string digits(std::uint64_t count) {
    std::string text;
    for (std::uint64_t i = 0; i < count; ++i) text += static_cast<char>('0' + below(10));
    return text;
  }
  /// Any shape of a decimal number: signs, leading zeros, a point anywhere, an exponent of any size, or none of these.
  std::string decimal() {
    std::string text;
    if (below(2) == 0) text += "-+"[below(4) / 3];
    if (below(4) == 0) text.append(below(12), '0');
    text += digits(below(22));
    if (below(4) != 0) {
      text += '.';
      if (below(4) == 0) text.append(below(12), '0');
      text += digits(below(22));
    }
    if (below(3) == 0) {
      text += "eE"[below(2)];
      if (below(2) == 0) text += "-+"[below(4) / 3];
      text += std::to_string(below(3) == 0 ? below(400) : below(30));
    }
    return text;
  }
  /// A number half way between two doubles, or one unit of its last place next to it.
  std::string halfway() {
    std::uint64_t w = std::uint64_t{1} << 54U | below(std::uint64_t{1} << 53U) << 1U | 1U;
    const std::uint64_t places = below(4);
    for (std::uint64_t i = 0; i < places; ++i) w *= 5;
    std::string text = std::to_string(w + below(3) - 1);
    if (places > 0) text.insert(text.size() - places, 1, '.');
    if (below(4) == 0) text += "e0";
    return text;
  }
  std::string printed(double value) {
    std::array<char, 1200> text{};
    const int precision = static_cast<int>(below(20));
    const int size = std::snprintf(text.data(), text.size(), below(2) == 0 ? "%.*g" : "%.*e", precision, value);
    return {text.data(), static_cast<std::size_t>(size)};
  }
  std::string shortest(double value) { return rbpa::app::text_of(value); }
  /// Characters that numbers are made of, and some that end them.
  std::string scrap() {
    constexpr std::string_view letters("0123456789.eE+-xXnaif \t\r,;\0#", 29);
    std::string text;
    for (std::uint64_t i = below(12); i > 0; --i) text += letters[below(letters.size())];
    return text;
  }
  std::string any() {
    switch (below(8)) {
      case 0:
        return shortest(any_double());
      case 1:
        return printed(any_double());
      case 2:
        return shortest((unit() - 0.5) * 1000);
      case 3:
        return printed((unit() - 0.5) * 1000);
      case 4:
        return halfway();
      case 5:
        return scrap();
      default:
        return decimal();
    }
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

TEST_SUITE("numbers") {
  TEST_CASE("any text gives the value, end and fault of the standard library") {
    Texts texts(20);
    std::size_t different = 0;
    for (int i = 0; i < rbpa_test::trials(1000000); ++i) {
      const std::string text = texts.any();
      if (reads_alike(text)) continue;
      CAPTURE(text);
      CHECK(reads_alike(text));
      if (++different == 10) break;
    }
    CHECK(different == 0);
  }

  TEST_CASE("texts at the limits of the notation read as by the standard library") {
    using namespace std::string_literals;
    // clang-format off
    for (const std::string& text :
         {""s, " "s, "+"s, "-"s, "."s, "-."s, "e"s, "e5"s, ".e5"s, "1."s, "-1."s, ".5"s, "-.5"s, "+.5"s, "+5"s, "+-5"s,
          "-+5"s, "++5"s, "--5"s, "1e"s, "1e+"s, "1e-"s, "1.e"s, "1.e5"s, "1e5.5"s, "1E5"s, "1e+5"s, "1e05"s,
          "1e00000000005"s, "1e-00000000005"s, "0x10"s, "-0x10"s, "0x"s, "nan"s, "-nan"s, "NaN"s, "nan(1)"s, "nan(\n)"s,
          "inf"s, "-inf"s, "infinity"s, "Infinit"s, "+inf"s, "0"s, "-0"s, "+0"s, "-0.0"s, "0e5"s, "-0e-999"s,
          "0e99999"s, "00"s, "007"s, "0.10"s, "1,5"s, "1 5"s, " 1"s, "\t1"s, "1\t"s, "1\r\n"s, "1\0"s, "\0001"s,
          "1\0002"s, "1.\0005"s, "12345678"s, "123456789"s, "1234567.8"s, "12345678."s, "12345678.12345678"s,
          "1234567a"s, "1234567\xB9"s, "1\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s, "12:4567890"s, "12/4567890"s,
          "9999999999999999999"s, "10000000000000000000"s, "18446744073709551615"s, "18446744073709551616"s,
          "99999999999999999999"s, "0.0000000000000000000001"s, "00000000000000000000000000001"s,
          "00000000000000000000000000000.00000000000000000000000000000"s, "9007199254740993"s, "9007199254740992"s,
          "9007199254740991"s, "9007199254740993e0"s, "9007199254740993.0"s, "900719925474099.3"s,
          "9007199254740992.5"s, "9007199254740993.000000000000000001"s, "1e27"s, "1e28"s, "1e-27"s, "1e-28"s,
          "9999999999999999999e27"s, "9999999999999999999e-27"s, "1e22"s, "1e23"s, "8.5e22"s, "1e308"s,
          "1.7976931348623157e308"s, "1.7976931348623158e308"s, "1.7976931348623159e308"s, "1e309"s, "-1e309"s,
          "1e400"s, "1e99999"s, "1e999999999999999999999"s, "1e18446744073709551616"s, "2.2250738585072014e-308"s,
          "2.2250738585072011e-308"s, "5e-324"s, "4.9406564584124654e-324"s, "2.4703282292062328e-324"s,
          "2.4703282292062327e-324"s, "1e-324"s, "1e-400"s, "-1e-400"s, "1e-99999"s, "0.1"s, "0.2"s, "0.3"s,
          "0.7999999999999999"s, "123.456"s}) {
      // clang-format on
      CAPTURE(text);
      CHECK(reads_alike(text));
    }
  }

  TEST_CASE("a number's text reads back to it and fits its room, and no digit of a fraction could be left out") {
    const auto reads_back = [](const std::string& text, double value) {
      return std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)) == std::bit_cast<std::uint64_t>(value);
    };
    const auto is_right = [&](double value) {
      const std::string text = rbpa::app::text_of(value);
      const ParsedNumber parsed = rbpa::app::parse_whole_number(text);
      if (!std::isfinite(value)) return parsed.fault == NumberFault::not_finite;
      if (text.size() > rbpa::app::number_room || !reads_back(text, value)) return false;
      if (parsed.fault != NumberFault::none || !same(parsed, {value, text.data() + text.size(), NumberFault::none}))
        return false;
      if (text.find_first_of(".e") == std::string::npos) return true;  // an integer, which may be written out
      const int digits = significant_digits(text);
      return digits < 2 || !reads_back(rounded(value, digits - 1), value);
    };
    Texts texts(22);
    std::size_t different = 0;
    const auto check = [&](double value) {
      for (const double x : {value, -value, std::nextafter(value, 0.0), std::nextafter(value, 1e300)}) {
        if (is_right(x)) continue;
        CAPTURE(x);
        CHECK(is_right(x));
        ++different;
      }
    };
    for (int i = 0; i < 20000 && different < 10; ++i) {
      check(texts.any_double());
      check(std::ldexp(texts.unit(), static_cast<int>(texts.below(80)) - 20));
      // Few decimal places, few binary places, integers with trailing zeros.
      const double power = std::pow(10, static_cast<double>(texts.below(16)));
      check(static_cast<double>(texts.below(1000000000)) / power);
      check(std::ldexp(static_cast<double>(texts.below(1000)), -static_cast<int>(texts.below(70))));
      check(static_cast<double>(texts.below(1000)) * power);
    }
    CHECK(different == 0);
    for (int exponent = -1074; exponent < 1024; ++exponent) check(std::ldexp(1.0, exponent));
    for (const double value : {0.0, 0.001, 0.0009, 0x1p-10, 99999.0, 100000.0, 1e15, 1e16, 0x1p53, 0.1 + 0.2, 5e-324})
      check(value);
  }
}
