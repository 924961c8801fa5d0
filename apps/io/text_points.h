// What: points from a table in text, one a line.
// Law:  every line is a point, a comment ('#'), blank, or the one header; anything else is refused by its line.
// Cost: one pass.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/columns.h"
#include "rbpa/core/point.h"

namespace rbpa::app {

/// The separator is the first of comma, semicolon, tab and blanks that the first line of data contains. Fields may stand
/// in double quotes (not with blanks). A first line without a number in either column is a header. All lines have the
/// same number of columns. Throws BadInput naming the line, and
/// WrongUsage when both columns turn out to be one.
std::vector<Point> read_text_points(std::string_view text, const std::string& name, const Columns& columns);

}  // namespace rbpa::app
