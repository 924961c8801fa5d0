// What: what a table begins with before its first point: "sep=;", the number of points, a comment with names, a header,
//       or the count and the comment of atoms.
// Law:  where lines that are no point may be left out, the first lines are left out until the others go on as one does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud/table_layout.h"
#include "io/cloud/table_lines.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

/// The number of points, as a line before them announces it.
struct AnnouncedPoints {
  std::size_t count, line;
  bool atoms = false;  ///< others may follow, in which case these are the first of them
};

struct TableStart {
  TableLayout layout = {};
  char separator = blanks;     ///< of the data
  std::string header = {};     ///< the line; empty without one
  std::size_t first_line = 0;  ///< which says how many columns there are
  bool has_line = false;       ///< the current line is the first of data
  bool any_table = false;      ///< there is a layout
  std::optional<AnnouncedPoints> announced = std::nullopt;
};

/// Goes to the first line of data, and lets `selection` find its columns. Throws BadInput.
TableStart start_table(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
                       std::vector<std::string>& remarks);

}  // namespace rbpa::app
