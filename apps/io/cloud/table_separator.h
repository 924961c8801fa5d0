// What: the separator of the fields of a table.
// Law:  "sep=" decides. Otherwise the separator is the one that makes lines of data, with as many fields as the first
//       line, of most of the first lines; a first line that is a header with it counts more than the ending of the
//       file's name, and that more than the number of lines. Commas that are decimal signs in all lines separate
//       nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/text/fields.h"

namespace rbpa::app {

struct SeparatorChoice {
  char separator = blanks;
  std::size_t lines = 0;                               ///< of data with that separator; 0: only the first line decided
  FieldCount fields = {};                              ///< of each of `lines`
  bool first_fits = true;                              ///< the first line has as many fields
  std::optional<std::size_t> geometry = std::nullopt;  ///< the field of each of `lines` that is a geometry
  bool begin_with_atoms = false;                       ///< the first field of each may be the number of an element
};

/// The size of the text, in bytes, by which the separator is chosen.
constexpr std::size_t separator_sample = std::size_t{1} << 16U;

/// Returns the separator of the table that begins with `text`. Only the first separator_sample bytes count. `said`: the
/// separator by "sep="; `by_most`: the first line may be no line of the table.
SeparatorChoice choose_separator(std::string_view text, std::optional<char> said, bool by_most,
                                 const std::string& name);

}  // namespace rbpa::app
