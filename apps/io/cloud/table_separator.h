// What: finds the separator of the fields of a table.
// Law:  "sep=" decides. Otherwise the first lines decide. Best is a separator with which lines of data have as many
//       fields as the first line; then the tab, if the file ends in .tsv; then the separator with which most lines are
//       data with equally many fields. Commas that are decimal signs in all lines separate nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/text/fields.h"

namespace rbpa::app {

struct SeparatorChoice {
  char separator = blanks;
  std::size_t lines = 0;   ///< number of lines of data with that separator; 0: the first line alone decided
  FieldCount fields = {};  ///< number of fields of each line of data
  bool first_fits = true;  ///< the first line has as many fields as the lines of data
  std::optional<std::size_t> geometry = std::nullopt;  ///< index of the field that is a geometry in lines of data
  bool begin_with_atoms = false;                       ///< first fields of lines of data may be numbers of elements
};

/// The number of bytes at the beginning of a table by which the separator is chosen.
constexpr std::size_t separator_sample = std::size_t{1} << 16U;

/// Returns the separator of the table that begins with `text`, of which only the first separator_sample bytes count.
/// `said` is the separator of "sep=". With `by_most` the first line may be no line of the table, and the lines of data
/// alone decide. `name` is the name of the file, with the ending.
SeparatorChoice choose_separator(std::string_view text, std::optional<char> said, bool by_most,
                                 const std::string& name);

/// Returns the numbers of fields of `line` if the line is data, with two numbers or a geometry; else nothing.
std::optional<FieldCount> fields_of_data(std::string_view line, char separator);

}  // namespace rbpa::app
