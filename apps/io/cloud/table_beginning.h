// What: reads the beginning of a table, before its first point: "sep=;", the number of points, a comment with names, a
//       header, or the count and the comment of atoms.
// Law:  with --skip-invalid, the lines before the first line with the form of the other lines are also left out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/table_layout.h"
#include "io/cloud/table_lines.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

/// The beginning of the .xyz format of chemistry: the number of atoms, a comment line, and a line for each atom with
/// its element and x, y, z. "Properties=species:S:1:pos:R:3:..." in the comment names the columns (extended XYZ,
/// https://github.com/libAtoms/extxyz).
struct XyzBeginning {
  std::size_t count = 0;                 ///< number of atoms
  std::vector<std::string> names = {};   ///< names of the columns; "element", "x", "y" and "z" are among them
  const char* behind_comment = nullptr;  ///< pointer to the end of the comment in the text
};

/// Returns the beginning of a list of atoms, whose first line is the number of atoms; nothing if the third line of
/// `text` is not an atom. `by_number`: elements may be numbers.
std::optional<XyzBeginning> find_xyz_atoms(std::string_view text, bool by_number);

/// Returns the names of the columns in the comment of an extended .xyz; none if the comment names no columns.
std::vector<std::string> xyz_columns(std::string_view comment);

/// The number of points that a line before the points announces.
struct AnnouncedPoints {
  std::size_t count, line;
  bool atoms = false;  ///< the points are atoms of the first model of a molecule; more models may follow
};

/// Returns the warning that a table has `lines` lines of points and not as many as announced; empty if the numbers are
/// equal. Unless `skips_invalid`, throws BadInput instead of returning a warning.
std::string check_announced(const AnnouncedPoints& announced, std::size_t lines, const std::string& name,
                            bool skips_invalid);

/// Returns the warning that the current line, which follows the announced atoms, and all later lines are not read.
/// Throws BadInput unless the current line begins the next frame of a trajectory, or `skips_invalid`.
std::string check_after_atoms(const AnnouncedPoints& announced, const TableLines& lines, bool skips_invalid);

struct TableStart {
  TableLayout layout = {};
  char separator = blanks;       ///< separator of the data
  std::string header = {};       ///< the line of the header; empty if there is none
  std::size_t first_line = 0;    ///< number of the line that sets the number of columns
  bool has_line = false;         ///< the current line is the first of data
  bool any_table = false;        ///< `layout` is set
  bool may_lack_fields = false;  ///< lines may lack fields at the end, as a line with all fields shows the others
  std::vector<std::string> names = {};  ///< names of all columns, if known, without quotes
  std::optional<AnnouncedPoints> announced = std::nullopt;
};

/// Goes to the first line of data, and finds the columns of the table and of `selection`. Throws BadInput, also if no
/// line follows a header, unless a line announces 0 points; WrongUsage if two requested columns are the same.
TableStart start_table(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
                       std::vector<std::string>& warnings);

}  // namespace rbpa::app
