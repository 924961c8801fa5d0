// What: the lines of a table, of a text in memory or of a file of which some is read at a time.
// Law:  blank lines and those that begin with '#' are passed over, and counted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/bytes/content.h"
#include "io/text/lines.h"

namespace rbpa::app {

class TableLines {
 public:
  explicit TableLines(Content content) : content_(std::move(content)) {}

  /// Goes to the next line with content; false at the end. Throws BadInput for UTF-16, and where a line is too long for memory.
  bool next();
  /// The next line was read elsewhere, up to `behind` its last character.
  void pass_line(const char* behind) { lines_.pass_line(behind); }

  std::string_view line() const { return lines_.line(); }
  std::size_t number() const { return lines_.number(); }
  /// What is there behind the line: of a file that is read not all.
  std::string_view rest() const { return lines_.rest(); }
  const Lines& lines() const { return lines_; }
  /// What the line right before the current one has behind its '#'; nothing where it is no comment.
  std::string_view comment_before() const;

  const Content& content() const { return content_; }
  const std::string& name() const { return content_.name(); }

 private:
  bool next_text();
  void require_memory(std::size_t size) const;

  Content content_;
  Lines lines_ = Lines({});
  std::string_view text_ = {};  // which lines_ are of
  std::size_t taken_ = 0;       // of the content, for that
};

}  // namespace rbpa::app
