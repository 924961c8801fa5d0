// What: by which sign the fields of a table are apart.
// Law:  what "sep=" says; else that which makes lines of data of most of the first lines, with as many fields as the
//       first line: one that is a header counts more than the ending of the name, and that more than how many lines
//       there are. Commas that are decimal in all of them separate nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/text/fields.h"

namespace rbpa::app {

struct SeparatorChoice {
  char separator = blanks;
  std::size_t lines = 0;                               ///< of data that have fields so; 0: the first line alone decided
  FieldCount fields = {};                              ///< of these lines
  bool first_fits = true;                              ///< the first line has as many
  std::optional<std::size_t> geometry = std::nullopt;  ///< the field that is one, in these lines
  bool begin_with_atoms = false;                       ///< the first field of each may be the number of an element
};

/// The text that is looked at.
constexpr std::size_t separator_sample = std::size_t{1} << 16U;

/// For the table in `text`, of which nothing but its beginning counts. `said`: by "sep="; `by_most`: the first line may
/// be none of it.
SeparatorChoice choose_separator(std::string_view text, std::optional<char> said, bool by_most,
                                 const std::string& name);

}  // namespace rbpa::app
