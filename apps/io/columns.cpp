#include "io/columns.h"

#include <algorithm>
#include <charconv>

#include "io/failure.h"

namespace rbpa::app {
namespace {

Column parse_column(const std::string& text) {
  const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return {.number = 0, .name = text};
  Column column;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), column.number);
  if (error != std::errc() || column.number == 0)
    throw WrongUsage("--columns: found " + in_quotes(text) + ", expected a column number from 1 or a column name");
  return column;
}

}  // namespace

Columns parse_columns(const std::string& text) {
  const std::size_t comma = text.find(',');
  const bool two = comma != std::string::npos && comma > 0 && comma + 1 < text.size() &&
                   text.find(',', comma + 1) == std::string::npos;
  if (!two)
    throw WrongUsage("--columns: found " + in_quotes(text) + ", expected X,Y (two column numbers or names)");
  return {parse_column(text.substr(0, comma)), parse_column(text.substr(comma + 1))};
}

}  // namespace rbpa::app
