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

/// Returns whether the current line is a header that lacks the name of the first column, the column of row names, as
/// R's write.table() writes a header: all lines have one field more, and the first is a text, perhaps in quotes, or the
/// number of the line. Such a number is none if the header begins with a name for it and another number follows.
bool lacks_name_of_rows(const TableLines& lines, const SeparatorChoice& choice);

/// Returns the warning that the last line after the current line has two numbers and a word such as "Sum", or an empty
/// first field below texts, and is read as a point; empty for any other last line.
std::string doubt_last_line(const TableLines& lines, char separator);

/// Throws WholeRefusal if the current line, which is no point, is the header of another table: two or more distinct
/// names, in a text other than `header`, which is not empty. If there are as many names as `width` has fields, the
/// names must include known coordinates, or the line before must be blank. Otherwise the names must include known
/// coordinates, and the next line with content must be a point with as many fields as there are names.
void refuse_second_header(const TableLines& lines, char separator, const FieldCount& width, const std::string& header);

}  // namespace rbpa::app
