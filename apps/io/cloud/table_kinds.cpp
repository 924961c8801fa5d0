// What: the tables whose columns, if no header names them, are known by the ending of the file's name.
#include <initializer_list>

#include "io/cloud/table_layout.h"
#include "io/failure.h"

namespace rbpa::app {

std::vector<std::string_view> names_of_kind(TableKind kind, const TableBeginning& table) {
  const std::size_t width = table.fields.size();
  std::vector<std::string_view> names;
  const auto append = [&](bool has, std::initializer_list<std::string_view> more) {
    if (has) names.insert(names.end(), more);
  };
  append(true, {"x", "y", "z"});
  append(kind == TableKind::xyzn, {"nx", "ny", "nz"});
  append(kind == TableKind::pts && (width == 4 || width == 7), {"intensity"});
  append(kind == TableKind::xyzrgb || (kind == TableKind::pts && width >= 6), {"red", "green", "blue"});
  if (names.size() == width) return names;
  bad_input(at_line(table.lines.name(), table.lines.number()), found_columns(width, table.lines.line()),
            kind == TableKind::xyzn     ? "6: x, y, z, nx, ny, nz"
            : kind == TableKind::xyzrgb ? "6: x, y, z, red, green, blue"
                                        : "3, 4, 6 or 7: x, y, z, intensity, red, green, blue");
}

/// Reads a table whose columns, if no header names them, are x, y, z and then an intensity, a color or both. The first
/// line of such a table may be the number of points; exactly as many must follow, unless invalid ones are skipped.
const CloudFormat pts_reader = table_format<TableKind::pts>;

/// Reads a table whose columns, if no header names them, are x, y, z, nx, ny, nz.
const CloudFormat xyzn_reader = table_format<TableKind::xyzn>;

/// Reads a table whose columns, if no header names them, are x, y, z, red, green, blue: from 0 to 1, or from 0 to 255
/// if one of the file is greater than 1.
const CloudFormat xyzrgb_reader = table_format<TableKind::xyzrgb>;

}  // namespace rbpa::app
