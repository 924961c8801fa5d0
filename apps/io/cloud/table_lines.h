// What: the lines of a table, of a text in memory or of a file of which some is read at a time.
// Law:  blank lines and those that begin with '#' or "//" are passed over, and counted. A text in quotes may go on in
//       lines behind the one it begins in, which are then one line, wherever pieces of the file end.
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

  /// Goes to the next line with content; false at the end. Throws BadInput for UTF-16, and where a line is too long for memory.
  bool next();
  /// The next line was read elsewhere, up to `behind` its last character.
  void pass_line(const char* behind) { lines_.pass_line(behind); }

  /// From the current line on: how its fields are apart, and how many there are at least. Before that, no text goes on.
  void set_layout(char separator, std::size_t least_fields);

  std::string_view line() const { return line_; }
  /// The number of the line, from 1; the first of a record of several lines.
  std::size_t number() const { return lines_.number() - spanned_; }
  /// Whether a text in quotes begins in the line and ends nowhere.
  bool is_open() const { return is_open_; }
  /// What is there behind the line: of a file that is read not all.
  std::string_view rest() const { return lines_.rest(); }
  /// The text from the beginning of the current line on: whole lines of `size` bytes or more, fewer at the end only.
  std::string_view ahead(std::size_t size);
  const Lines& lines() const { return lines_; }
  /// What the line right before the current one has behind its '#' or "//"; nothing where it is no comment.
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
  std::string_view text_ = {};  // which lines_ are of
  std::string_view line_ = {};
  std::string room_ = {};  // of text_, where CR ended a line
  std::size_t taken_ = 0;  // of the content, for that
  std::size_t mark_ = 0;   // bytes before text_, which are no text
  char separator_ = '\0';  // not known yet
  std::size_t least_fields_ = 0;
  std::size_t spanned_ = 0;  // lines behind the first of the current one
  bool is_open_ = false;
};

}  // namespace rbpa::app
