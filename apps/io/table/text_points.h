// What: points from a table in text, one a line.
// Law:  every line is a point, a comment ('#'), blank, or the one header; anything else is refused by its line, or left
//       out and counted.
// Cost: one pass.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/condition.h"
#include "io/point_file.h"
#include "io/table/columns.h"

namespace rbpa::app {

struct TableRule {
  std::optional<Columns> columns = std::nullopt;  ///< absent: as the header names them, else the first two
  bool skip_invalid = false;                      ///< leave out lines that are no point, and say how many
  bool vertices = false;                          ///< take those of lines and polygons in a column of geometries
  std::optional<Condition> where = std::nullopt;  ///< on columns that the header names: which lines count
};

/// A table that comes in several texts, each of whole lines.
class TextTable {
 public:
  TextTable(const std::string& name, const TableRule& rule);
  ~TextTable();
  TextTable(const TextTable&) = delete;
  TextTable& operator=(const TextTable&) = delete;

  /// The points of file() are those of this text now: to be copied, not taken. Throws as read_text_points().
  void read(std::string_view text);
  /// That was all: adds what there is to remark. The points are still those of the last text.
  void finish();
  PointFile& file();

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

/// The separator is the first of comma, semicolon, tab and blanks that the first line of data contains; but where every
/// comma stands inside a number, as in "1,5;2,5", it is a decimal sign. Fields may stand in double quotes (not with
/// blanks). A first line without a number in either column is a header; where its names are known, such as lat and lon,
/// they say which columns are x and y, or that there is one of geometries in well-known text. All lines have the same
/// number of columns. Of a line that is not as `where` asks only the columns that it names are read. Throws BadInput naming the line, and WrongUsage when both columns turn out to be one.
PointFile read_text_points(std::string_view text, const std::string& name, const TableRule& rule);

}  // namespace rbpa::app
