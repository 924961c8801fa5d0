#include "io/text/typed_words.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/number.h"
#include "io/text/fields.h"
#include "io/words.h"

namespace rbpa::app {

std::optional<std::int64_t> integer_of(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || std::to_string(value) != word) return std::nullopt;
  return value;
}

namespace {

std::optional<double> number_of(std::string_view word) {
  if (is_missing(word)) return std::numeric_limits<double>::quiet_NaN();
  // 1D2 may be a label, 1.0D2 is a number of Fortran.
  const bool has_letter = std::any_of(word.begin(), word.end(), [](char c) { return c == 'd' || c == 'D'; });
  const bool may_be_label = has_letter && word.find('.') == std::string_view::npos;
  const ParsedNumber number = may_be_label ? parse_whole_number(word) : parse_written_number(word);
  const bool has_zeros = word.size() > 1 && word.front() == '0' && is_digit(word[1]);  // a label, such as 007
  if (has_zeros || (number.fault != NumberFault::none && number.fault != NumberFault::not_finite)) return std::nullopt;
  return number.value;
}

}  // namespace

void append_word(PointColumn& column, std::string_view word) {
  if (column.type == Scalar::int64) {
    if (const std::optional<std::int64_t> value = integer_of(word)) return column.append(*value);
    if (!number_of(word) || !become_numbers(column)) become_texts(column);
  }
  if (!column.is_text) {
    if (const std::optional<double> value = number_of(word)) return column.append(*value);
  }
  append_text(column, word);
}

void append_text(PointColumn& column, std::string_view text) {
  if (!column.is_text) become_texts(column);
  column.append(column.number_of(text));
}

}  // namespace rbpa::app
