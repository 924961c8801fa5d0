// What: what a bench program has measured and written as CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace figures {

/// A table of numbers above 0, the first column ascending.
struct Measured {
  std::vector<std::string> head;     ///< two lines: the date and the machine; what was measured
  std::vector<std::string> columns;  ///< their names
  std::vector<std::vector<double>> rows;

  /// Absent when no column has the name.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// A file of the folder of figures: lines `# …` of head, a line of names, and rows of numbers with commas between them.
/// Throws std::runtime_error naming file and line where it is anything else.
Measured read_measured(const std::string& name);

}  // namespace figures
