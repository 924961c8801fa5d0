// What: reads the fields of a table: the numbers of points, with a decimal point or a decimal comma or as angles, and
//       words of other columns, which are kept.
// Law:  all numbers of a table have the same decimal sign (DecimalComma); a number that is read otherwise than it is
//       written gives a warning, once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/table_lines.h"
#include "io/text/fields.h"

namespace rbpa::app {

class TableFields {
 public:
  /// Views `lines` and `file`, which must outlive this object. Adds warnings to `file`, and sets file.degrees for
  /// angles.
  TableFields(const TableLines& lines, PointFile& file) : lines_(lines), file_(file) {}

  /// Begins with the current line as the first line of points, below the line `header`; empty if there is none.
  void begin(char separator, bool in_space, std::string_view header);
  /// Sets the block whose first `numbers` columns hold the numbers that are read next.
  void begin_block(const CloudBlock& block, std::size_t numbers);
  /// Records whether the numbers of the block, which is complete, are whole.
  void end_block();

  /// Returns the number in the next of `fields`, a field of the current line. In messages `where` follows what is
  /// expected; `where` is empty for a coordinate of a point, on `axis`. Throws BadInput.
  double read(Fields& fields, std::string_view where = {}, std::size_t axis = 0);

  bool has_commas() const { return comma_.is_used(); }  ///< some number had a decimal comma

  /// Keeps the words of a column, from 0, in PointFile::kept. Requires: columns ascend.
  void keep(std::size_t column, const std::string& name);
  bool keeps_any() const { return !kept_.empty(); }
  void take_words();    ///< reads the words of the current line; call after its numbers are read
  void append_words();  ///< appends the words that were read for a point of the line

 private:
  [[noreturn]] void refuse(std::string_view field, const std::string& expected) const;
  double read_angle(double degrees, char hemisphere, std::string_view field, std::size_t axis);
  double read_decimal_comma(std::string_view field);
  bool is_block_whole() const;
  std::string other_columns() const;
  std::string here() const;

  const TableLines& lines_;
  PointFile& file_;
  char separator_ = blanks;
  bool in_space_ = false;
  std::string header_ = {};            // line of the header; empty if there is none
  std::size_t first_point_ = 0;        // number of the line of the first point
  const CloudBlock* block_ = nullptr;  // the block that is being filled
  std::size_t numbers_ = 0;            // number of columns of the block
  bool all_whole_ = true;              // all numbers of earlier blocks without a comma are whole
  DecimalComma comma_ = {};
  bool has_angles_ = false;
  std::vector<std::size_t> kept_ = {};   // columns that are kept, ascending
  std::vector<std::string> words_ = {};  // fields of the kept columns in the current line
};

}  // namespace rbpa::app
