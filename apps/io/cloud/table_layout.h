// What: finds the meaning of the columns of a table from its first line and from the request; declares how tables are
//       opened (table_cloud.cpp).
// Law:  a first line is a header if none of its requested columns looks like a number and none of its other columns is
//       a number. Known names, such as lat and lon, give the columns of x and y, or the column of geometries in
//       well-known text. A comment in the line before the first line of numbers is also a header, if it has a name for
//       each column, among them x, y, and in space z. Without known names, a column whose first value is a geometry is
//       the column of geometries.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/table_lines.h"
#include "io/cloud/table_separator.h"
#include "io/text/fields.h"

namespace rbpa::app {

/// The kind of a table, by the ending of the file's name. Without a header the kind determines the columns (`kind_rows`
/// in table_layout.cpp), unless the kind is `any`.
enum class TableKind { any, pts, xyzn, xyzrgb };

/// Returns the least number of columns in a table of the kind.
std::size_t least_columns(TableKind kind);

struct TableLayout {
  bool header = false;                            ///< the first line is a header
  FieldCount width = {};                          ///< number of fields in a line
  std::vector<std::size_t> numbers = {};          ///< the columns of x, y; or of x, y, z; or of x, y, z and the normal
  std::vector<std::size_t> colors = {};           ///< the columns of red, green and blue; empty if there are none
  std::optional<std::size_t> wkt = std::nullopt;  ///< the column of geometries, in place of x and y
  std::optional<std::size_t> height = std::nullopt;
  bool degrees = false;                      ///< x is a longitude and y a latitude
  bool unnamed = false;                      ///< six columns without names: the last three may be normals or colors
  std::vector<std::string_view> names = {};  ///< names of all columns, if known
};

/// The beginning of a table: its first line, the comment in the line before, and the form of the lines after it.
struct TableBeginning {
  const TableLines& lines;
  std::vector<std::string_view> fields = {};  ///< fields of the current line, without empty fields at its end
  FieldCount width = {};
  std::string_view comment;
  std::vector<std::string_view> names = {};  ///< the fields of the comment
  SeparatorChoice choice;
  bool says_columns = false;  ///< a warning is to name the columns of the points, as lines of text are left out
};

/// The ways in which a line may be a header.
enum class HeaderKind { none, unknown_names, known_names };

/// Returns known_names if `fields` may be a header with the columns that `request` has by name, or else with known
/// names of coordinates or geometries; unknown_names if all fields are texts and enough of them may be names of
/// columns; else none.
HeaderKind header_kind(const std::vector<std::string_view>& fields, const CloudRequest& request);

/// Returns the layout of a table, and adds warnings to `warnings`. Throws BadInput that names the line; WrongUsage if
/// two requested columns are the same.
TableLayout lay_out_table(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& warnings);

/// Opens a table of the kind; called by CloudFormat::open, and throws as that does.
std::unique_ptr<Cloud> open_table(Content content, const CloudRequest& request, TableKind kind);

/// The CloudFormat of tables of a kind.
template <TableKind kind>
constexpr CloudFormat reader_of_kind = {
    .open = [](Content content, const CloudRequest& request) { return open_table(std::move(content), request, kind); },
    .fields = names_of_columns,
    .streams = true,
    .skips_invalid = true,
    .is_text = true};

/// Sets the columns of `layout` by `names`, one for each column, for a table whose first line is numbers.
void lay_out_by_names(const std::vector<std::string_view>& names, bool in_space, TableLayout& layout);

/// Returns "2 columns ('1 2')" for `count` columns in `line`, for messages.
std::string found_columns(std::size_t count, std::string_view line);

/// Returns whether any of `columns` is requested by its name, so that the table needs a header.
bool is_by_name(const std::optional<std::vector<Column>>& columns);

}  // namespace rbpa::app
