// What: appends the fields of a table to columns, whose types follow from the texts.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "io/point_columns.h"

namespace rbpa::app {

/// Returns the integer of a text without sign +, zeros before it, or blanks; nothing for any other text.
std::optional<std::int64_t> integer_of(std::string_view word);

/// Appends the text of a field of a table to a column. The column has integers (int64) as long as all texts are
/// integers as they are written; then numbers (float64, NaN where a value is missing), if doubles represent the
/// integers before; else texts. Requires: the column began empty, as int64 or as
/// texts.
void append_word(PointColumn& column, std::string_view word);

/// Appends a text to a column as append_word() does, but never as a number.
void append_text(PointColumn& column, std::string_view text);

}  // namespace rbpa::app
