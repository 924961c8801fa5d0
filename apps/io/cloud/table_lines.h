// What: goes through the lines of a table that is in memory or read piece by piece.
// Law:  blank lines, lines of separators only and comments are skipped, and counted in line numbers. A quoted text may
//       span several lines of the file, which are then one line, wherever pieces of the file end.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/content.h"
#include "io/text/fields.h"
#include "io/text/lines.h"

namespace rbpa::app {

class TableLines {
 public:
  explicit TableLines(Content content) : content_(std::move(content)) {}

  /// Goes to the next line with content; returns false at the end. Throws BadInput for UTF-16 and UTF-32, and if a line
  /// is too long for memory; Failure; Cancelled.
  bool next();
  /// Skips the next line, which the caller has read in rest(); `behind` points to its line end or to the end of rest().
  /// line() does not change.
  void pass_line(const char* behind) { lines_.pass_line(behind); }

  /// Sets the separator and the least number of fields, from the current line on. Before the first call no text spans
  /// lines.
  void set_layout(char separator, std::size_t least_fields);

  /// Sets the columns of coordinates, from 0, by which a comment is recognized that may be a point: "#3,0,3" below
  /// "tree,x,y". No comment is recognized if `columns` has the first column, whose field is no number with the
  /// comment's mark.
  void set_coordinates(const std::vector<std::size_t>& columns, const FieldCount& width, char separator);
  /// Returns the warning about comments that may be points; empty if there are none.
  std::string warning_on_comments() const;
  std::size_t comments() const { return comments_; }  ///< number of comments until now
  /// Returns the number of comments that may be points: all with two numbers before set_coordinates() is called.
  std::size_t passed_points() const { return passed_points_; }

  std::string_view line() const { return line_; }
  /// Returns the number of the current line in the file, from 1; the number of the first if several lines are joined.
  std::size_t number() const { return lines_.number() - spanned_; }
  /// Returns whether a quoted text begins in the current line and does not end, or spans lines of data like it.
  bool is_open() const { return is_open_; }
  /// Throws BadInput that says why the current line is_open().
  [[noreturn]] void refuse_open() const;
  /// Returns the text after the current line, as far as it is in memory.
  std::string_view rest() const { return lines_.rest(); }
  /// Returns the text from the beginning of the current line: whole lines of together at least `size` bytes, fewer only
  /// at the end.
  std::string_view ahead(std::size_t size);
  const Lines& lines() const { return lines_; }
  /// Returns the line of the file before the current line, as far as it is in memory.
  std::string_view line_before() const;
  /// Returns the text after '#' or "//" in the line before the current line; empty if that line is not a comment.
  std::string_view comment_before() const;

  const Content& content() const { return content_; }
  const std::string& name() const { return content_.name(); }

 private:
  bool is_passed_over(std::string_view line);
  void look_for_point(std::string_view comment);
  bool next_text(std::size_t at_least);
  void require_memory(std::size_t size) const;
  void widen();
  void join();
  std::size_t swallowed_row(const char* end) const;

  Content content_;
  Lines lines_ = Lines({});
  std::string_view text_ = {};  // the text through which lines_ goes
  std::string_view line_ = {};
  std::string room_ = {};  // holds text_ if CR ended a line
  std::size_t taken_ = 0;  // number of bytes of the content that are in room_
  std::size_t mark_ = 0;   // number of bytes before text_: the byte-order mark
  char separator_ = '\0';  // '\0': not known
  std::size_t least_fields_ = 0;
  std::size_t spanned_ = 0;  // number of lines that are joined to the first of the current line
  bool is_open_ = false;
  std::size_t swallowed_ = 0;  // number of the first line of data that a quoted text spans; 0: there is none
  std::vector<std::size_t> coordinates_ = {};
  FieldCount width_ = {};
  char separator_of_points_ = '\0';               // '\0': the columns are not known
  std::size_t comments_ = 0, passed_points_ = 0;  // passed_points_: comments that may be points
  std::string first_passed_ = {};                 // the first comment that may be a point, and its place
};

}  // namespace rbpa::app
