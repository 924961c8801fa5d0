#include "io/table/separator.h"

#include <cstddef>

#include "io/table/fields.h"

namespace rbpa::app {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// No comma, or one between digits.
bool may_be_decimal(std::string_view field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos) return true;
  return comma > 0 && is_digit(field[comma - 1]) && comma + 1 < field.size() && is_digit(field[comma + 1]) &&
         field.find(',', comma + 1) == std::string_view::npos;
}

}  // namespace

bool commas_are_decimal(std::string_view line, char separator) {
  if (line.find(',') == std::string_view::npos) return false;
  std::size_t count = 0;
  for (Fields fields(line, separator); !fields.at_end(); ++count)
    if (!may_be_decimal(without_quotes(fields.take()))) return false;
  return count > 1;
}

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', blanks})
    if ((c == blanks || line.find(c) != std::string_view::npos) && commas_are_decimal(line, c)) return c;
  for (const char c : {',', ';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return blanks;
}

}  // namespace rbpa::app
