// What: which columns of a table are which, by its first line and by the request.
// Law:  a first line with nothing that is nearly a number in a column that counts, and no number elsewhere, is a
//       header; where its names are known, such as lat and lon, they say which columns are x and y, or that there is
//       one of geometries in well-known text. A comment right before the first line of numbers is a header as well, if
//       it has as many names and x, y, in space also z, are among them. Where nothing is known by name, a column whose
//       first value is a geometry is one of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/table_lines.h"
#include "io/cloud/table_separator.h"
#include "io/text/fields.h"

namespace rbpa::app {

/// What the ending of its name says of a table without a header.
enum class TableKind {
  any,
  pts,    ///< x y z, with an intensity, with red green blue, or with both
  xyzn,   ///< x y z nx ny nz
  xyzrgb  ///< x y z red green blue
};

struct TableLayout {
  bool header = false;                    ///< the first line is one
  FieldCount width = {};                  ///< its fields
  std::vector<std::size_t> numbers = {};  ///< the columns of x, y; or of x, y, z and, if it has six, of the normal
  std::vector<std::size_t> colors = {};   ///< none, or those of red, green and blue
  std::optional<std::size_t> wkt = std::nullopt;  ///< that of geometries, in place of x and y
  std::optional<std::size_t> height = std::nullopt;
  bool degrees = false;                      ///< x is a longitude and y a latitude
  bool unnamed = false;                      ///< six columns without names: the last three may be normals or colors
  std::vector<std::string_view> names = {};  ///< of all columns, where they are known
};

/// The beginning of a table: its first line, the comment right before it, and the form of the lines behind it.
struct TableBeginning {
  const TableLines& lines;
  std::vector<std::string_view> fields = {};  ///< of the current line, without empty ones at its end
  FieldCount width = {};
  std::string_view comment;
  std::vector<std::string_view> names = {};  ///< its fields
  SeparatorChoice choice;
};

/// Adds what there is to remark. Throws BadInput naming the line, and WrongUsage when two columns turn out to be one.
TableLayout lay_out_table(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& remarks);

/// What a table of a kind, or of such names, has where its first line is of numbers.
void lay_out_by_names(const std::vector<std::string_view>& names, bool in_space, TableLayout& layout);

/// "2 columns ('1 2')".
std::string found_columns(std::size_t count, std::string_view line);

/// Whether a column is requested by its name, which a header has to have.
bool is_by_name(const std::optional<std::vector<Column>>& columns);

}  // namespace rbpa::app
