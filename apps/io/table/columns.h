// What: which two columns of a table are x and y.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rbpa::app {

/// A column by its number or by its name in the header line.
struct Column {
  std::size_t number = 0;  ///< from 1; 0 when the name counts
  std::string name = {};
  friend bool operator==(const Column&, const Column&) = default;
};

struct Columns {
  Column x{.number = 1};
  Column y{.number = 2};
};

/// Throws WrongUsage: `columns` are the same.
[[noreturn]] void refuse_one_column(std::string_view columns);

/// "X,Y", each a number from 1 or a name, and not the same. Throws WrongUsage.
Columns parse_columns(const std::string& text);

}  // namespace rbpa::app
