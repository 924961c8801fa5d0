// What: recognizes lines that are no points of a table, although they may be read as points: the beginning of another
//       kind of file, a total in the last line, the header of another table.
#pragma once

#include <string>
#include <string_view>

#include "io/cloud/table_lines.h"
#include "io/cloud/table_separator.h"
#include "io/text/fields.h"

namespace rbpa::app {

/// Throws BadInput if a file that begins with `bytes` is no table but a workbook, a web page, XML, a grid or JSON.
void refuse_no_table(std::string_view bytes, const std::string& name);

/// Returns whether the current line is a header that lacks the name of the first column, that of names of rows, as R's
/// write.table() writes it: all lines have one field more, and the first is a text, perhaps in quotes, or, unless the
/// header begins with the name of such numbers and another number follows, the number of the line.
bool lacks_name_of_rows(const TableLines& lines, const SeparatorChoice& choice);

/// Returns the warning that the last line after the current line has two numbers and a word such as "Sum", or an empty
/// first field below texts, and is read as a point; empty if it is not so.
std::string doubt_last_line(const TableLines& lines, char separator);

/// Throws WholeRefusal if the current line, which is no point, is the header of another table than `header`: different
/// names, which are known names, or as many below a blank line; above a line of points if they are more or fewer.
void refuse_second_header(const TableLines& lines, char separator, const FieldCount& width, const std::string& header);

}  // namespace rbpa::app
