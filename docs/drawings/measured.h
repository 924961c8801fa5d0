// What: reads the results of a bench program, written as CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace figures {

/// Table of numbers above 0, the first column ascending.
struct Measured {
  std::vector<std::string> head;     ///< two lines: the date and the machine; the subject of the measurement
  std::vector<std::string> columns;  ///< names of the columns
  std::vector<std::vector<double>> rows;

  /// Returns the index of a column; nothing when no column has the name.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads a file of the folder of figures: lines `# …` of head, a line of names, and rows of numbers separated by
/// commas. Throws std::runtime_error, naming file and line, if the file is anything else.
Measured read_measured(const std::string& name);

}  // namespace figures
