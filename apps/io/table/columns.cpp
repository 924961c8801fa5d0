#include "io/table/columns.h"

#include <algorithm>
#include <charconv>

#include "io/failure.h"
#include "io/lines.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

Column parse_column(std::string_view text) {
  // What is a number is no name: -1 and 1.5 are mistakes.
  const NumberFault fault = parse_whole_number(text).fault;
  if (fault == NumberFault::not_a_number || fault == NumberFault::not_finite)
    return {.number = 0, .name = std::string(text)};
  Column column;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), column.number);
  if (error != std::errc() || end != text.data() + text.size() || column.number == 0)
    throw WrongUsage("--columns: found " + in_quotes(text) + ", expected a column number from 1 or a column name");
  return column;
}

}  // namespace

void refuse_one_column(std::string_view columns) {
  throw WrongUsage("--columns: found " + in_quotes(columns) + ", which is one column, expected two");
}

void refuse_repeated_column(std::string_view columns) {
  throw WrongUsage("--columns: found " + in_quotes(columns) + ", of which two are one column, expected different ones");
}

Columns parse_columns(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view x = trimmed(std::string_view(text).substr(0, comma));
  const std::string_view y = trimmed(std::string_view(text).substr(std::min(comma + 1, text.size())));
  if (x.empty() || y.empty() || y.find(',') != std::string_view::npos)
    throw WrongUsage("--columns: found " + in_quotes(text) + ", expected X,Y (two column numbers or names)");
  const Columns columns{parse_column(x), parse_column(y)};
  if (columns.x == columns.y) refuse_one_column(text);
  return columns;
}

std::vector<Column> parse_space_columns(const std::string& text) {
  const auto refuse = [&] {
    throw WrongUsage("--columns: found " + in_quotes(text) +
                     ", expected X,Y,Z or X,Y,Z,NX,NY,NZ (column numbers or names)");
  };
  std::vector<Column> columns;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const std::string_view word = trimmed(std::string_view(text).substr(first, comma - first));
    if (word.empty()) refuse();
    columns.push_back(parse_column(word));
    first = comma + 1;
  }
  if (columns.size() != 3 && columns.size() != 6) refuse();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      refuse_repeated_column(text);
  return columns;
}

}  // namespace rbpa::app
