// What: looks in the first lines of a table for signs that its numbers are not the coordinates that its layout takes.
// Law:  a sign that nearly proves it refuses the table, also with --skip-invalid; any other sign gives a warning.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/table_layout.h"

namespace rbpa::app {

/// The first lines of a table, from its current line on, split into fields without quotes.
class TableSample {
 public:
  using Test = bool (*)(std::string_view field);

  explicit TableSample(const TableBeginning& table);

  std::size_t lines() const { return rows_.size(); }
  /// Returns the field of a line and a column, from 0; empty if the line has no such column.
  std::string_view field(std::size_t line, std::size_t column) const {
    return column < rows_[line].size() ? rows_[line][column] : std::string_view();
  }
  /// Returns whether there is a line from number `first` on, and each has a field in the column that passes the test.
  bool all(std::size_t column, Test test, std::size_t first) const;
  bool any(std::size_t column, Test test, std::size_t first) const;

 private:
  std::vector<std::vector<std::string_view>> rows_ = {};
};

/// Returns the argument of --columns for the columns that are most likely x and y in a table whose header has unknown
/// names: by words of the names, else the first columns of decimals, else of numbers; "X,Y" if there are no two.
std::string likely_columns(const TableBeginning& table, const TableSample& sample);

/// Adds warnings about a table in the plane without a header and without requested columns. Throws WholeRefusal if
/// several points stand in a line.
void doubt_first_columns(const TableBeginning& table, const TableSample& sample, std::vector<std::string>& warnings);

/// Adds warnings about the columns of coordinates. Throws WholeRefusal if signs of coordinates, or minutes, are in
/// other columns, or the header says that west or south is positive.
void doubt_coordinates(const TableBeginning& table, const TableLayout& layout, const TableSample& sample,
                       std::vector<std::string>& warnings);

/// Throws BadInput if a file that begins with `bytes` is no table but a workbook, a web page or JSON.
void refuse_no_table(std::string_view bytes, const std::string& name);

/// Returns the warning that the last line after the current line has two numbers and a word such as "Sum", and is read
/// as a point; empty if it is not so.
std::string doubt_last_line(const TableLines& lines, char separator);

/// Throws WholeRefusal if the current line, which is no point, is the header of another table than `header`: as many
/// different names, which are known names or stand below a blank line.
void refuse_second_header(const TableLines& lines, char separator, const FieldCount& width, const std::string& header);

}  // namespace rbpa::app
