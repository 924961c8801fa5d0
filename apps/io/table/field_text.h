// What: what the texts of a table are: a mark before them, the names and the values of fields.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/lines.h"

namespace rbpa::app {

/// The text behind the mark of UTF-8. Throws BadInput when it is UTF-16.
std::string_view beyond_byte_order_mark(std::string_view text, const std::string& name);

/// "sep=;", which Excel may write before everything else; the lines show it as well.
bool is_separator_hint(std::string_view line);

/// With a decimal point or comma.
bool is_number(std::string_view field);

/// What programs write where there is no value: "NA", nothing, and others.
bool is_missing(std::string_view field);

/// Which field of the header, the current line of `lines`, is called that, by case or else without. Throws BadInput.
std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name);

}  // namespace rbpa::app
