#include "io/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#include "io/failure.h"
#include "io/words.h"

namespace rbpa::app {

ParsedNumber parse_extreme_number(const char* first, const char* end) {
  // strtod() separates too large from too small; the program never leaves the "C" locale.
  const double value = std::strtod(std::string(first, end).c_str(), nullptr);
  return {value, end, std::isinf(value) ? NumberFault::out_of_range : NumberFault::none};
}

ParsedNumber parse_large_number(const char* first, const char* end, double value) {
  if (!std::isfinite(value)) return {value, end, NumberFault::not_finite};
  std::string_view digits(first, static_cast<std::size_t>(end - first));
  if (digits.front() == '-') digits.remove_prefix(1);
  if (digits.find_first_not_of("0123456789") != std::string_view::npos) return {value, end, NumberFault::none};
  digits.remove_prefix(digits.find_first_not_of('0'));
  char exact[std::numeric_limits<double>::max_exponent10 + 3];
  std::snprintf(exact, sizeof exact, "%.0f", std::abs(value));
  return {value, end, digits == exact ? NumberFault::none : NumberFault::rounded_integer};
}

ParsedNumber parse_whole_number(std::string_view text) {
  const char* last = text.data() + text.size();
  ParsedNumber number = parse_number(text.data(), last);
  if (number.end != last) number.fault = NumberFault::not_a_number;
  return number;
}

ParsedNumber parse_written_number(std::string_view text) {
  constexpr std::string_view minus = "\xE2\x88\x92";
  constexpr std::size_t longest = 4096;  // most characters of a number with D or U+2212
  const ParsedNumber number = parse_whole_number(text);
  if (number.fault != NumberFault::not_a_number || text.size() > longest) return number;
  std::string ascii;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_minus = text.substr(at, minus.size()) == minus;
    ascii.push_back(is_minus ? '-' : text[at]);
    if (is_minus) at += minus.size() - 1;
  }
  // Accept D only where E may stand: after digits, points and signs.
  const std::size_t exponent = ascii.find_first_of("dD");
  if (exponent != std::string::npos && ascii.find_first_not_of("0123456789.+-") == exponent) ascii[exponent] = 'e';
  const ParsedNumber read = parse_whole_number(ascii);
  return {read.value, text.data() + text.size(), read.fault};
}

const char* expected_instead(NumberFault fault) {
  switch (fault) {
    case NumberFault::not_finite:
      return "a finite number";
    case NumberFault::out_of_range:
      return "a number within the range of a double (up to 1.8e308)";
    case NumberFault::rounded_integer:
      return "an integer that a double holds exactly, such as all up to 2^53";
    default:
      return "a number";
  }
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t first = 0, end = 0; first <= text.size(); first = end + 1) {
    end = std::min(text.find(separator, first), text.size());
    parts.push_back(text.substr(first, end - first));
  }
  return parts;
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> words = split_at(text, ',');
  for (std::string_view& word : words) word = trimmed(word);
  return words;
}

namespace {

bool has_decimal_comma(std::string text) {
  const std::size_t comma = text.find(',');
  if (comma < text.size()) text[comma] = '.';
  return comma < text.size() && parse_whole_number(text).fault == NumberFault::none;
}

}  // namespace

double parse_real(const std::string& option, const std::string& text, Range allowed, const std::string& expected) {
  const auto [value, end, fault] = parse_whole_number(text);
  if ((fault != NumberFault::none && fault != NumberFault::not_finite) ||
      !(allowed.least <= value && value <= allowed.greatest))
    bad_usage(option, in_quotes(text), expected + (has_decimal_comma(text) ? ", with a decimal point" : ""));
  return value;
}

std::size_t parse_whole(const std::string& option, const std::string& text, WholeNumbers allowed,
                        const std::string& things) {
  const std::optional<std::size_t> number = parse_count(text);
  if (number && *number >= allowed.least && *number <= allowed.greatest) return *number;
  std::string expected = "a whole number ";
  if (!things.empty()) expected.append("of ").append(things).append(" ");
  expected.append("from ").append(std::to_string(allowed.least));
  if (allowed.greatest < WholeNumbers().greatest) expected.append(" to ").append(std::to_string(allowed.greatest));
  bad_usage(option, in_quotes(text), expected);
}

}  // namespace rbpa::app
