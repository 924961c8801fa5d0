// What: which two columns of a table are x and y.
#pragma once

#include <cstddef>
#include <string>

namespace rbpa::app {

/// A column by its number or by its name in the header line.
struct Column {
  std::size_t number = 0;  ///< from 1; 0 when the name counts
  std::string name = {};
};

struct Columns {
  Column x{.number = 1};
  Column y{.number = 2};
};

/// "X,Y", each a number from 1 or a name. Throws WrongUsage.
Columns parse_columns(const std::string& text);

}  // namespace rbpa::app
