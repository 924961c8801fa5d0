// What: decimal text to double and back; whole numbers of a command line.
// Law:  parse_number(text of x) = x for every finite double x; reading rounds to the nearest double, but for integers,
//       which are read exactly or refused.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

enum class NumberFault { none, not_a_number, not_finite, out_of_range, rounded_integer };

struct ParsedNumber {
  double value;
  const char* end;  ///< behind the last character that belongs to the number
  NumberFault fault;
};

/// What from_chars() calls out of range: larger than any double is a fault, smaller than any is rounded.
ParsedNumber parse_extreme_number(const char* first, const char* last, const char* end);

/// Doubles have every integer up to it, from one side of zero to the other.
constexpr double exact_integers = 0x1p53;

/// Of the same, that is beyond exact_integers: an integer that `value`, the nearest double, is not is a fault.
ParsedNumber parse_large_number(const char* first, const char* end, double value);

/// The number that begins at `first`, an optional sign included. Reading rounds to the nearest double, but no integer.
inline ParsedNumber parse_number(const char* first, const char* last) {
  if (last - first > 1 && *first == '+' && first[1] != '-') ++first;
  double value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::invalid_argument) return {0, first, NumberFault::not_a_number};
  if (error == std::errc::result_out_of_range) return parse_extreme_number(first, last, end);
  if (value >= exact_integers || value <= -exact_integers) return parse_large_number(first, end, value);
  const bool finite = value - value == 0;
  return {value, end, finite ? NumberFault::none : NumberFault::not_finite};
}

/// The number that is the whole of `text`.
ParsedNumber parse_whole_number(std::string_view text);

/// The same, with Fortran's D for E ("1.0D0") or the sign − of typography (U+2212) as well.
ParsedNumber parse_written_number(std::string_view text);

/// What had to stand where there is a fault.
const char* expected_instead(NumberFault fault);

/// The characters of the longest, such as -2.2250738585072014e-308.
constexpr std::size_t number_room = 24;

/// Puts the text of `value`, of a double the shortest that reads back to it, at `at`, where there is number_room.
/// Returns its end.
inline char* put_number(char* at, std::uint64_t value) { return std::to_chars(at, at + number_room, value).ptr; }
inline char* put_number(char* at, double value) { return std::to_chars(at, at + number_room, value).ptr; }

/// A double as the shortest text that reads back to it.
class ShortestText {
 public:
  explicit ShortestText(double value) : end_(put_number(text_.data(), value)) {}
  operator std::string_view() const { return {text_.data(), static_cast<std::size_t>(end_ - text_.data())}; }

 private:
  std::array<char, number_room> text_;
  char* end_;
};

/// The same as a text of its own; "none" where there is none.
inline std::string text_of(double value) { return std::string(ShortestText(value)); }
inline std::string text_of(const std::optional<double>& value) { return value ? text_of(*value) : "none"; }

/// With so many digits, for people: "3819.51" of six.
std::string rounded(double value, int digits);

struct WholeNumbers {
  std::size_t least = 0;
  std::size_t greatest = std::numeric_limits<std::size_t>::max();
};

/// What `option` was given: decimal digits and nothing else, of a number among `allowed`. Throws WrongUsage naming text
/// and bounds, of so many `things` ("points").
std::size_t parse_whole(const std::string& option, const std::string& text, WholeNumbers allowed,
                        const std::string& things = "");

}  // namespace rbpa::app
