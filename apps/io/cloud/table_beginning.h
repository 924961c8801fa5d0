// What: reads the beginning of a table, before its first point: "sep=;", the number of points, a comment with names, a
//       header, or the count and the comment of atoms.
// Law:  if lines that are not points may be left out, the first lines are left out as well, up to a line with the form
//       of the other lines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud/table_layout.h"
#include "io/cloud/table_lines.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

/// The number of points that a line before the points announces.
struct AnnouncedPoints {
  std::size_t count, line;
  bool atoms = false;  ///< the points are atoms of the first model of a molecule; others may follow
};

struct TableStart {
  TableLayout layout = {};
  char separator = blanks;     ///< separator of the data
  std::string header = {};     ///< the line of the header; empty if there is none
  std::size_t first_line = 0;  ///< number of the line that sets the number of columns
  bool has_line = false;       ///< the current line is the first of data
  bool any_table = false;      ///< `layout` is set
  std::optional<AnnouncedPoints> announced = std::nullopt;
};

/// Goes to the first line of data, and finds the columns of the table and of `selection`. Throws BadInput, also if no
/// line follows a header, unless a line announces 0 points; WrongUsage if two requested columns are the same.
TableStart start_table(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
                       std::vector<std::string>& warnings);

}  // namespace rbpa::app
