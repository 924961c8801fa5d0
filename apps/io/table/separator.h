// What: by which sign the fields of a line are apart, and what a comma in it is.
#pragma once

#include <string_view>

namespace rbpa::app {

/// Comma, semicolon, tab or blanks: the first of them that the line contains. A comma that stands between the digits of
/// a number in every field that has one separates nothing.
char separator_of(std::string_view line);

/// Whether `line`, apart at `separator`, has commas, and every one of them stands in a number of its own: "1,5;2".
bool commas_are_decimal(std::string_view line, char separator);

}  // namespace rbpa::app
