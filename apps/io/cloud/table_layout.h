// What: the meaning of the columns of a table, by its first line and by the request.
// Law:  a first line is a header if no requested column of it looks like a number and no other column is one. Known
//       names, such as lat and lon, give the columns of x and y, or the column of geometries in well-known text. A
//       comment right before the first line of numbers is a header as well, if it has as many names and x, y, in space
//       also z, are among them. Without known names, a column whose first value is a geometry is the column of
//       geometries.
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

/// The columns of a table without a header, by the ending of the file's name.
enum class TableKind {
  any,
  pts,    ///< x y z, with an intensity, with red green blue, or with both
  xyzn,   ///< x y z nx ny nz
  xyzrgb  ///< x y z red green blue
};

struct TableLayout {
  bool header = false;                            ///< the first line is a header
  FieldCount width = {};                          ///< number of fields in a line
  std::vector<std::size_t> numbers = {};          ///< the columns of x, y; or of x, y, z; or of x, y, z and the normal
  std::vector<std::size_t> colors = {};           ///< none, or the columns of red, green and blue
  std::optional<std::size_t> wkt = std::nullopt;  ///< the column of geometries, in place of x and y
  std::optional<std::size_t> height = std::nullopt;
  bool degrees = false;                      ///< x is a longitude and y a latitude
  bool unnamed = false;                      ///< six columns without names: the last three may be normals or colors
  std::vector<std::string_view> names = {};  ///< of all columns, if they are known
};

/// The beginning of a table: its first line, the comment right before it, and the form of the lines after it.
struct TableBeginning {
  const TableLines& lines;
  std::vector<std::string_view> fields = {};  ///< of the current line, without empty ones at its end
  FieldCount width = {};
  std::string_view comment;
  std::vector<std::string_view> names = {};  ///< the fields of the comment
  SeparatorChoice choice;
};

/// Returns the layout of a table, and adds warnings to `warnings`. Throws BadInput naming the line, and WrongUsage if
/// two requested columns are one.
TableLayout lay_out_table(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& warnings);

/// Opens a table, for CloudFormat::open.
std::unique_ptr<Cloud> open_table(Content content, const CloudRequest& request, TableKind kind);

/// The reader of tables of a kind.
template <TableKind kind>
constexpr CloudFormat table_format = {
    .open = [](Content content, const CloudRequest& request) { return open_table(std::move(content), request, kind); },
    .fields = names_of_columns,
    .streams = true,
    .skips_invalid = true,
    .is_text = true};

/// Sets the columns of `layout` by `names`, for a table whose first line is numbers.
void lay_out_by_names(const std::vector<std::string_view>& names, bool in_space, TableLayout& layout);

/// Returns "2 columns ('1 2')".
std::string found_columns(std::size_t count, std::string_view line);

/// Returns whether a column is requested by its name, so that the table needs a header.
bool is_by_name(const std::optional<std::vector<Column>>& columns);

}  // namespace rbpa::app
