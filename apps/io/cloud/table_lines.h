// What: the lines of a table, in memory or read piece by piece.
// Law:  blank lines and lines that begin with '#' or "//" are skipped, and counted in line numbers. A quoted text may
//       span several lines, which are then one line, wherever the pieces of the file end.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/bytes/content.h"
#include "io/text/fields.h"
#include "io/text/lines.h"

namespace rbpa::app {

class TableLines {
 public:
  explicit TableLines(Content content) : content_(std::move(content)) {}

  /// Goes to the next line with content; returns false at the end. Throws BadInput for UTF-16, and if a line is too
  /// long for memory.
  bool next();
  /// Skips the next line, which the caller has read up to `behind`, the end of its last character.
  void pass_line(const char* behind) { lines_.pass_line(behind); }

  /// Sets the separator and the least number of fields, from the current line on. Before the call no text spans lines.
  void set_layout(char separator, std::size_t least_fields);

  std::string_view line() const { return line_; }
  /// Returns the number of the line, from 1; the first number of a line that spans several.
  std::size_t number() const { return lines_.number() - spanned_; }
  /// Returns whether a quoted text begins in the line and has no end.
  bool is_open() const { return is_open_; }
  /// Returns the text after the line that is in memory.
  std::string_view rest() const { return lines_.rest(); }
  /// Returns the text from the beginning of the current line: whole lines of `size` bytes or more, fewer at the end
  /// only.
  std::string_view ahead(std::size_t size);
  const Lines& lines() const { return lines_; }
  /// Returns the comment in the line right before the current one, after its '#' or "//"; empty if it is not a comment.
  std::string_view comment_before() const;

  const Content& content() const { return content_; }
  const std::string& name() const { return content_.name(); }

 private:
  bool next_text(std::size_t at_least);
  void require_memory(std::size_t size) const;
  void widen();
  void join();

  Content content_;
  Lines lines_ = Lines({});
  std::string_view text_ = {};  // the text of lines_
  std::string_view line_ = {};
  std::string room_ = {};  // holds text_ if CR ended a line
  std::size_t taken_ = 0;  // bytes of the content that are in room_
  std::size_t mark_ = 0;   // bytes before text_: the byte-order mark
  char separator_ = '\0';  // not known yet
  std::size_t least_fields_ = 0;
  std::size_t spanned_ = 0;  // lines after the first of the current one
  bool is_open_ = false;
};

}  // namespace rbpa::app
