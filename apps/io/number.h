// What: converts decimal text to double and back; parses the numbers of a command line.
// Law:  parse_number(text of x) = x for every finite double x. Reading rounds to the nearest double, except integers,
//       which are read exactly or refused.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

enum class NumberFault { none, not_a_number, not_finite, out_of_range, rounded_integer };

struct ParsedNumber {
  double value;
  const char* end;  ///< after the last character of the number
  NumberFault fault;
};

/// Parses the number from `first` to `end`, which from_chars() reports as out of range. The fault of a number beyond
/// the largest double is out_of_range; a number too close to zero is rounded.
ParsedNumber parse_extreme_number(const char* first, const char* end);

/// Doubles represent every integer from -exact_integers to exact_integers.
constexpr double exact_integers = 0x1p53;

/// Returns the number from `first` to `end`, whose nearest double is `value`. The fault of an integer that differs from
/// `value` is rounded_integer. Requires: the absolute value of `value` is at least exact_integers.
ParsedNumber parse_large_number(const char* first, const char* end, double value);

/// Parses the longest number that begins at `first`, perhaps with a sign, and rounds it to the nearest double. The
/// fault is rounded_integer for an integer that rounding would change, not_finite for inf and nan, out_of_range beyond
/// the largest double, and not_a_number if no number begins there.
inline ParsedNumber parse_number(const char* first, const char* last) {
  if (last - first > 1 && *first == '+' && first[1] != '-') ++first;
  double value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::invalid_argument) return {0, first, NumberFault::not_a_number};
  if (error == std::errc::result_out_of_range) return parse_extreme_number(first, end);
  if (value >= exact_integers || value <= -exact_integers) return parse_large_number(first, end, value);
  const bool finite = value - value == 0;
  return {value, end, finite ? NumberFault::none : NumberFault::not_finite};
}

/// Parses `text` as parse_number() does. The fault is not_a_number if text follows the number.
ParsedNumber parse_whole_number(std::string_view text);

/// Parses `text` as parse_whole_number() does, and accepts Fortran's D for E ("1.0D0") and the minus sign − (U+2212).
ParsedNumber parse_written_number(std::string_view text);

/// Returns the text for "expected …" in a message about a number with this fault.
const char* expected_instead(NumberFault fault);

/// The most characters that put_number() writes, as for -2.2250738585072014e-308.
constexpr std::size_t number_room = 24;

/// Write `value` to `at` as decimal text, a double as the shortest text that reads back to it. Return the end of the
/// text. Require: there is room for number_room characters at `at`.
inline char* put_number(char* at, std::uint64_t value) { return std::to_chars(at, at + number_room, value).ptr; }
inline char* put_number(char* at, double value) { return std::to_chars(at, at + number_room, value).ptr; }

/// Return the shortest text that reads back to `value`; "none" if `value` is absent.
inline std::string text_of(double value) {
  char text[number_room];
  return {text, put_number(text, value)};
}
inline std::string text_of(const std::optional<double>& value) { return value ? text_of(*value) : "none"; }

/// Returns `value` as text, rounded to `digits` significant digits: "3819.51" for six.
std::string rounded(double value, int digits);

/// Returns the parts of `text` between separators.
std::vector<std::string_view> split_at(std::string_view text, char separator);
/// Returns the parts of `text` between commas, without blanks around each part.
std::vector<std::string_view> split_at_commas(std::string_view text);

/// A range of numbers, both ends included.
struct Range {
  double least = 0;
  double greatest = std::numeric_limits<double>::max();
};
constexpr Range above_0{.least = std::numeric_limits<double>::denorm_min()};

/// Parses the argument of `option`: a number within `allowed`, perhaps inf. Throws WrongUsage that quotes the text and
/// says `expected`, a description of valid arguments.
double parse_real(const std::string& option, const std::string& text, Range allowed, const std::string& expected);

struct WholeNumbers {
  std::size_t least = 0;
  std::size_t greatest = std::numeric_limits<std::size_t>::max();
};

/// Parses the argument of `option`: decimal digits and nothing else, a number within `allowed`. Throws WrongUsage that
/// quotes the text and names the bounds; `things` is the noun for counted things ("points").
std::size_t parse_whole(const std::string& option, const std::string& text, WholeNumbers allowed,
                        const std::string& things = "");

}  // namespace rbpa::app
