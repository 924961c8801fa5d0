// What: looks in the first lines of a table for signs that its numbers are not the coordinates that its layout takes.
// Law:  a sign that is nearly a proof refuses the table, also with --skip-invalid; any other sign gives a warning.
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

/// Returns the end of a warning about columns x and y, which were found by their names: the columns to choose instead.
std::string other_columns(const std::vector<std::string_view>& fields, std::size_t x, std::size_t y, bool in_space);

/// Adds the warning that the first `numbers` columns are read as coordinates, although not all have known names.
void warn_of_unknown_names(const TableBeginning& table, std::size_t numbers, std::vector<std::string>& warnings);

/// Throws WholeRefusal if the header has no known names and the line after it has three numbers or more, so that any
/// two of them may be the coordinates.
void refuse_unknown_names(const TableBeginning& table, const TableSample& sample);

/// Adds warnings about a table in the plane without a header and without requested columns. Throws WholeRefusal if
/// several points stand in a line, or as refuse_decimal_commas().
void doubt_first_columns(const TableBeginning& table, const TableSample& sample, std::vector<std::string>& warnings);

/// Throws WholeRefusal if the numbers of a table without a header may be halves of numbers with decimal commas.
void refuse_decimal_commas(const TableBeginning& table, const TableSample& sample);

/// Adds the warning that no column is read as z, if others than x, y and the columns of the condition have numbers.
void warn_of_no_height(const TableBeginning& table, const TableLayout& layout, const CloudRequest& request,
                       const TableSample& sample, std::vector<std::string>& warnings);

/// Adds warnings about the columns of coordinates. Throws WholeRefusal if signs of coordinates, or minutes, are in
/// other columns, the header says that west or south is positive, or numbers have signs between thousands.
void doubt_coordinates(const TableBeginning& table, const TableLayout& layout, const CloudRequest& request,
                       const TableSample& sample, std::vector<std::string>& warnings);

}  // namespace rbpa::app
