#include "io/text/typed_words.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

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
  const ParsedNumber number = parse_whole_number(word);
  const bool has_zeros = word.size() > 1 && word.front() == '0' && is_digit(word[1]);  // a label, such as 007
  if (has_zeros || (number.fault != NumberFault::none && number.fault != NumberFault::not_finite)) return std::nullopt;
  return number.value;
}

void become_texts(PointColumn& column) {
  PointColumn texts{.name = column.name, .type = Scalar::int32, .is_text = true};
  for (std::size_t i = 0; i < column.size(); ++i) {
    std::string text;
    if (column.type == Scalar::int64)
      text = std::to_string(column.value<std::int64_t>(i));
    else if (const double value = column.value<double>(i); !std::isnan(value))
      text = text_of(value);
    texts.append(texts.number_of(text));
  }
  column = std::move(texts);
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
