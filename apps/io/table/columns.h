// What: which columns of a table are x and y, or x, y, z and the parts of a normal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

/// Throws WrongUsage: two of `columns` are the same.
[[noreturn]] void refuse_one_column(std::string_view columns);

/// The same of columns in space.
[[noreturn]] void refuse_repeated_column(std::string_view columns);

/// "X,Y", each a number from 1 or a name, and not the same. Throws WrongUsage.
Columns parse_columns(const std::string& text);

/// "X,Y,Z" or "X,Y,Z,NX,NY,NZ", each a number from 1 or a name, and no two the same. Throws WrongUsage.
std::vector<Column> parse_space_columns(const std::string& text);

}  // namespace rbpa::app
