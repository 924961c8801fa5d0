#include "io/cloud/table_lines.h"

#include <algorithm>
#include <optional>

#include "io/bytes/available_memory.h"
#include "io/failure.h"
#include "io/text/fields.h"

namespace rbpa::app {

bool TableLines::next() {
  while (!lines_.next_with_content())
    if (!next_text()) return false;
  return true;
}

/// All that is in memory, or some more of a file, up to the end of a line.
bool TableLines::next_text() {
  const bool is_first = taken_ == 0;
  content_.skip(taken_);
  constexpr std::size_t at_once = std::size_t{1} << 20U;
  std::string_view text = content_.ahead();
  for (std::size_t before = 0; !content_.is_in_memory();) {
    text = content_.ahead(before + at_once);
    if (text.size() < before + at_once) break;  // the end of the file
    const std::size_t last = text.substr(before).rfind('\n');
    if (last != std::string_view::npos) {
      text = text.substr(0, before + last + 1);
      break;
    }
    before = text.size();
    require_memory(before);
  }
  taken_ = text.size();
  text_ = is_first ? beyond_byte_order_mark(text, name()) : text;
  lines_ = Lines(text_, lines_.number());
  return !text.empty();
}

/// For a line that has not ended so far.
void TableLines::require_memory(std::size_t size) const {
  constexpr double bytes_for_each = 5;  // the text, a larger one when it grows, and the point or its vertices
  const std::optional<double> there = available_memory();
  if (there && bytes_for_each * static_cast<double>(size) > *there)
    bad_input(name(), "a line of more than " + bytes_text(static_cast<double>(size)),
              "lines for which memory suffices");
}

std::string_view TableLines::comment_before() const {
  std::string_view before = text_.substr(0, static_cast<std::size_t>(line().data() - text_.data()));
  before = before.substr(0, before.find_last_of('\n') + 1);  // without blanks before the line
  if (before.empty()) return {};
  before.remove_suffix(1);
  before = trimmed(before.substr(before.find_last_of('\n') + 1));
  return before.starts_with('#') ? trimmed(before.substr(1)) : std::string_view();
}

}  // namespace rbpa::app
