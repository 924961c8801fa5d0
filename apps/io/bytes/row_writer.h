// What: writes the rows of a table one after another, as CSV (RFC 4180) or as a JSON list of objects.
// Law:  a number reads back to the same double. A row has a value for each column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"

namespace rbpa::app {

/// Returns `text` as a field of CSV, in quotes if it needs them.
std::string csv_text(std::string_view text);
/// Returns `text` in quotes as JSON. Bytes that are not UTF-8, such as Latin-1, are written as the replacement
/// character.
std::string json_string(std::string_view text);

class RowWriter {
 public:
  /// Begins the table. Keeps a reference to `file`. Requires: `format` is csv or json; at least one column. Throws as
  /// OutputFile::write(), as do the other members.
  RowWriter(OutputFile& file, Format format, const std::vector<std::string>& columns);

  /// Write the next value of the row; the value of the last column ends the row.
  void text(std::string_view value);  ///< an empty text is null in JSON
  void number(double value);          ///< NaN is an empty field, or null
  void count(std::uint64_t value);
  /// Ends the table. Call once, after whole rows.
  void finish();

 private:
  void begin_value();
  void end_value();

  OutputFile& file_;
  bool is_csv_;
  std::vector<std::string> before_ = {};  // what stands before the value of each column
  std::size_t next_ = 0;                  // the column of the next value
  bool has_rows_ = false;
};

}  // namespace rbpa::app
