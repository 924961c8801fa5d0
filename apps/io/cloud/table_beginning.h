// What: the beginning of a table, before its first point: "sep=;", the number of points, a comment with names, a
//       header, or the count and the comment of atoms.
// Law:  if lines that are not points may be left out, so are the first lines, up to one that the other lines match.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud/table_layout.h"
#include "io/cloud/table_lines.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

/// The number of points that a line before them announces.
struct AnnouncedPoints {
  std::size_t count, line;
  bool atoms = false;  ///< of the first model of a molecule; others may follow
};

struct TableStart {
  TableLayout layout = {};
  char separator = blanks;     ///< of the data
  std::string header = {};     ///< the line; empty without one
  std::size_t first_line = 0;  ///< the line that sets the number of columns
  bool has_line = false;       ///< the current line is the first of data
  bool any_table = false;      ///< there is a layout
  std::optional<AnnouncedPoints> announced = std::nullopt;
};

/// Goes to the first line of data, and finds the columns of `selection`. Throws BadInput, also for a header that no
/// line follows, unless a line says that there are 0 points.
TableStart start_table(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
                       std::vector<std::string>& warnings);

}  // namespace rbpa::app
